#include "scene/trace/dump_lexer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace twinlight::trace {

// Moves the remaining bytes to the front and reads more, until the buffer surely contains two tokens or the text ends.
void DumpLexer::refill() {
    if (source_ended_) return;
    const auto left = static_cast<std::size_t>(end_ - position_);
    std::memmove(buffer_.data(), position_, left);
    position_ = buffer_.data();
    end_ = buffer_.data() + left;
    while (static_cast<std::size_t>(end_ - position_) <= 2 * kLongestToken) {
        const std::size_t read = source_.read(end_, static_cast<std::size_t>(buffer_.data() + kBufferSize - end_));
        end_ += read;
        if (read == 0) {
            source_ended_ = true;
            break;
        }
    }
    *end_ = '\0';
}

bool DumpLexer::accept(std::string_view word) {
    prepare_token();
    if (!std::string_view(position_, static_cast<std::size_t>(end_ - position_)).starts_with(word)) return false;
    position_ += word.size();
    return true;
}

// Most numbers are short decimals. Their digits form a whole number, which is multiplied or divided by a power of ten
// that a double holds exactly; the single rounding then gives the correct result (Clinger 1990, section 3).
// std::from_chars reads the others.
bool DumpLexer::number(double& value) {
    static constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                         1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    constexpr int kExactDigits = 15;  // 10^15 < 2^53
    prepare_token();
    const char* p = position_;
    const bool negative = *p == '-';
    if (negative) ++p;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (p[0] == '0' && p[1] == 'x') {
        std::uint64_t bits = 0;
        const auto [after, error] = std::from_chars(p + 2, end_, bits, 16);
        if (error != std::errc() || is_word(*after)) return false;
        position_ = after;
        value = static_cast<double>(bits);
        return !negative;
    }
    if (!is_digit(*p)) return false;
    const char* const start = p;
    std::uint64_t digits = 0;
    int digit_count = 0, scale = 0;
    for (; is_digit(*p); ++p) {
        digits = digits * 10 + static_cast<std::uint64_t>(*p - '0');
        ++digit_count;
    }
    if (*p == '.') {
        for (++p; is_digit(*p); ++p) {
            digits = digits * 10 + static_cast<std::uint64_t>(*p - '0');
            ++digit_count;
            --scale;
        }
    }
    if (*p == 'e' || *p == 'E') {
        int exponent = 0;
        const char* const sign = p + 1;
        const char* const first = *sign == '+' ? sign + 1 : sign;
        const auto [after, error] = std::from_chars(first, end_, exponent);
        // An exponent too large for an int gives 0 or infinity anyway.
        if (error == std::errc::invalid_argument) return false;
        scale = error == std::errc() && std::abs(exponent) < 100000 ? scale + exponent : 100000;
        p = after;
    }
    if (is_word(*p) || *p == '.') return false;
    if (digit_count <= kExactDigits && std::abs(scale) <= 22) {
        const auto whole = static_cast<double>(digits);
        value = scale < 0 ? whole / kPowers[-scale] : whole * kPowers[scale];
    } else {
        const auto [after, error] = std::from_chars(start, p, value);
        if (error == std::errc::result_out_of_range) value = std::strtod(std::string(start, p).c_str(), nullptr);
    }
    if (negative) value = -value;
    position_ = p;
    return true;
}

void DumpLexer::skip_string() {
    while (!at_end()) {
        const char c = peek();
        skip();
        if (c == '"') return;
        if (c == '\n') ++line_;
        if (c == '\\' && !at_end()) skip();
    }
}

std::string_view DumpLexer::string(std::size_t longest) {
    string_.clear();
    skip();
    while (!at_end()) {
        const char c = peek();
        skip();
        if (c == '"') break;
        if (c == '\n') ++line_;
        if (string_.size() < longest) string_ += c;
        if (c == '\\' && !at_end()) skip();
    }
    return string_;
}

void DumpLexer::rest_of_line(std::string& to, std::size_t longest) {
    while (!at_end()) {
        const char* const end = std::find(position_, static_cast<const char*>(end_), '\n');
        to.append(position_, std::min<std::size_t>(static_cast<std::size_t>(end - position_),
                                                   longest - std::min(longest, to.size())));
        position_ = end;
        if (end == end_) continue;
        skip();
        ++line_;
        return;
    }
}

bool DumpLexer::skip_line() {
    while (!at_end()) {
        const char c = *position_++;
        if (c == '"') skip_string();
        if (c != '\n') continue;
        ++line_;
        return true;
    }
    return false;
}

}  // namespace twinlight::trace
