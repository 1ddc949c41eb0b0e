// Texts of a whole program: those in quotes, and C's functions for them.
#include <fmt/format.h>
#include <fmt/printf.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

constexpr std::size_t kCharactersOfAStep = 8;  // so that a loop over long texts ends
constexpr std::size_t kMaxPrinted = 1 << 16;

// The characters of a text in quotes, with what \n, \x41 and \101 mean.
std::string unescaped(std::string_view quoted) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
        if (quoted[i] != '\\') {
            text += quoted[i];
            continue;
        }
        ++i;
        const bool is_hex = quoted[i] == 'x';
        const std::size_t base = is_hex ? 16 : 8, most = is_hex ? 2 : 3;
        std::size_t code = 0, digits = 0;
        for (std::size_t k = i + (is_hex ? 1 : 0); digits < most && k + 1 < quoted.size(); ++k, ++digits) {
            const std::size_t digit =
                kDigits.find(quoted[k] >= 'A' && quoted[k] <= 'F' ? static_cast<char>(quoted[k] + 32) : quoted[k]);
            if (digit >= base) break;
            code = code * base + digit;
        }
        if (digits > 0) {
            text += static_cast<char>(code);
            i += digits - (is_hex ? 0 : 1);
        } else {
            text += static_cast<char>(character_code(fmt::format("'\\{}'", quoted[i])));
        }
    }
    return text;
}

}  // namespace

// Reads "a" "b", which is one text. Each place in the program has one object for its text, as in C.
Value Reader::text_in_quotes() {
    Program& p = *program_;
    const std::size_t first = p.at;
    const Place place = token_.place;
    const auto [found, is_new] = p.texts.try_emplace(first);
    Object& object = found->second;
    std::string text;
    for (; token_.kind == TokenKind::kString; advance())
        if (is_new) text += unescaped(token_.text);
    if (is_new) {
        object = {.type = types_.array_of(types_.number(Kind::kByte), text.size() + 1),
                  .shown = tr("this text"),
                  .place = place,
                  .known = true,
                  .is_constant = true};
        allocate(object, place);
        std::memcpy(object.memory->bytes.data(), text.data(), text.size());
    }
    return {.type = Value::Type::kPointer, .object = &object, .of = object.type->of};
}

// The characters from a pointer to the 0 that ends them.
std::string Reader::text_behind(const Value& pointer, const Place& place) {
    const std::span<const std::byte> bytes = bytes_behind(pointer, 0, false, place);
    const auto end = std::ranges::find(bytes, std::byte{0});
    const auto length = static_cast<std::size_t>(end - bytes.begin());
    program_->steps += length / kCharactersOfAStep;
    if (end == bytes.end()) fail(place, "this text has no 0 at its end");
    check_known(*pointer.object, static_cast<std::size_t>(pointer.offset), length + 1, place);
    return {reinterpret_cast<const char*>(bytes.data()), length};
}

void Reader::write_text(const Value& to, std::string_view text, const Place& place) {
    const std::span<std::byte> bytes = bytes_behind(to, text.size() + 1, true, place);
    std::memcpy(bytes.data(), text.data(), text.size());
    bytes[text.size()] = std::byte{0};
}

struct Reader::Printed {
    std::string text;
    std::size_t used = 0;  // how many of the values
};

// What printf would print of the values.
Reader::Printed Reader::printed(const std::string& pattern, std::span<const Value> values, const Place& place) {
    std::string text;
    std::size_t next = 0;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (text.size() > kMaxPrinted) fail(place, "this text is longer than {} characters", kMaxPrinted);
        if (pattern[i] != '%') {
            text += pattern[i];
            continue;
        }
        const std::size_t start = i++;
        while (i < pattern.size() && std::string_view("-+ #0123456789.").find(pattern[i]) != std::string_view::npos)
            ++i;
        std::string form = pattern.substr(start, i - start);
        while (i < pattern.size() && std::string_view("hlLzjt").find(pattern[i]) != std::string_view::npos) ++i;
        const char letter = i < pattern.size() ? pattern[i] : '\0';
        if (letter == '%' && form == "%") {
            text += '%';
            continue;
        }
        const bool is_long = form.size() > 8;
        if (is_long || letter == '\0' || std::string_view("diuxXofFeEgGcs").find(letter) == std::string_view::npos)
            out_of_reach(place, tr("the form {} of a printed text", in_quotes(form + letter)));
        if (next >= values.size()) fail(place, "the form {} has no value", in_quotes(form + letter));
        const Value& value = values[next++];
        form += letter;
        if (letter == 's' && !program_) fail(place, "a scene has no texts for the form '%s'; write the text itself");
        try {
            if (letter == 's')
                text += fmt::sprintf(form, text_behind(value, place));
            else if (value.is_pointer() || value.is_struct())
                fail(place, "the form {} needs a number", in_quotes(form));
            else if (letter == 'c')
                text += fmt::sprintf(form, static_cast<char>(in_kind(value, Kind::kByte, place).integer));
            else if (std::string_view("fFeEgG").find(letter) != std::string_view::npos)
                text += fmt::sprintf(form, value.number());
            else if (!value.is_integer())
                fail(place, "the form {} needs a whole number", in_quotes(form));
            else if (letter == 'd' || letter == 'i')
                text += fmt::sprintf(form, static_cast<int>(in_kind(value, Kind::kInt, place).integer));
            else
                text += fmt::sprintf(form, static_cast<unsigned>(in_kind(value, Kind::kUint, place).integer));
        } catch (const fmt::format_error&) {
            out_of_reach(place, tr("the form {} of a printed text", in_quotes(form)));
        }
    }
    return {std::move(text), next};
}

// Reads a text in quotes, and the values of its forms: "n = %g", n. In a program an array of characters may take its place.
void Reader::text_argument(Command& command, const Parameter& parameter) {
    const Token start = token_;
    std::string format;
    if (start.kind == TokenKind::kString) {
        for (; token_.kind == TokenKind::kString; advance()) format += unescaped(token_.text);
    } else {
        const Value given = program_ ? expression() : Value{};
        if (!given.is_pointer())
            fail(start.place, "expected the {} of {} in quotes, such as \"shininess 8\", found {}", parameter.name,
                 command.name(), shown(start));
        format = text_behind(given, start.place);
    }
    std::vector<Value> values;
    while (accept(",")) values.push_back(expression());
    const Printed printed_text = printed(format, values, start.place);
    if (printed_text.used < values.size())
        fail(start.place, "this text has {} such as %g, but {}",
             printed_text.used == 1 ? tr("1 form") : tr("{} forms", printed_text.used),
             values.size() == 1 ? tr("1 value is given") : tr("{} values are given", values.size()));
    const std::string& text = printed_text.text;
    // A scene has no escapes, so it could not have these characters.
    const auto is_refused = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\'; };
    if (text.empty() || std::ranges::any_of(text, is_refused))
        fail(start.place, "the {} of {} must be one line without quotes and backslashes, and not empty", parameter.name,
             command.name());
    check_short_text(start.place, tr("the {} of {}", parameter.name, command.name()), text);
    hold(text.size(), start.place);
    const auto bytes = std::as_bytes(std::span(text));
    command.memory = std::make_shared<const Memory>(Memory{Kind::kByte, {bytes.begin(), bytes.end()}});
}

// The arguments of vsprintf and its like: the first ones, then what the running function gets for its "...".
std::vector<Value> Reader::values_before_list(const Token& name, std::size_t count) {
    const Program& p = *program_;
    const std::size_t close = p.partners[p.at];
    std::vector<Value> values;
    expect("(", "after the function's name");
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(expression());
        expect(",", "after an argument of {}", name.text);
    }
    if (!p.more || token_.kind != TokenKind::kName || p.at + 1 != close)
        out_of_reach(name.place, tr("a va_list that another function made"));
    jump(close + 1);
    values.insert(values.end(), p.more->begin(), p.more->end());
    return values;
}

// strlen, strcpy, sprintf and others: nullopt for another name.
std::optional<Value> Reader::call_of_texts(const Token& name) {
    constexpr std::pair<std::string_view, std::size_t> kAll[] = {
        {"strlen", 1},  {"strcpy", 2},  {"strncpy", 3}, {"strcat", 2},   {"strcmp", 2},   {"strncmp", 3},
        {"atoi", 1},    {"atof", 1},    {"sprintf", 2}, {"snprintf", 3}, {"vsprintf", 2}, {"vsnprintf", 3},
        {"isdigit", 1}, {"isspace", 1}, {"isalpha", 1}, {"toupper", 1},  {"tolower", 1}};
    const auto row = std::ranges::find(kAll, name.text, [](const auto& known) { return known.first; });
    if (row == std::end(kAll)) return std::nullopt;
    const bool takes_more = name.text.ends_with("printf"), takes_list = name.text.starts_with("v");
    const std::vector<Value> given = takes_list ? values_before_list(name, row->second) : values_in_parentheses();
    if (given.size() < row->second || (given.size() > row->second && !takes_more))
        fail(name.place, "{} takes {}", name.text,
             takes_more ? tr("at least {}", arguments_text(row->second)) : arguments_text(row->second));
    const auto text = [&](std::size_t i) { return text_behind(given[i], name.place); };
    const auto count = [&](std::size_t i) {
        return static_cast<std::size_t>(
            std::clamp<std::int64_t>(in_kind(given[i], Kind::kInt, name.place).integer, 0, kMaxMemoryBytes));
    };
    const auto number = [](int value) { return integer(value); };
    if (row->first.starts_with("is") || row->first.starts_with("to")) {
        const auto c = static_cast<int>(in_kind(given[0], Kind::kUbyte, name.place).integer);
        const bool is_upper = c >= 'A' && c <= 'Z', is_lower = c >= 'a' && c <= 'z';
        if (name.is("isdigit")) return number(c >= '0' && c <= '9' ? 1 : 0);
        if (name.is("isalpha")) return number(is_upper || is_lower ? 1 : 0);
        if (name.is("isspace")) return number(c == ' ' || (c >= '\t' && c <= '\r') ? 1 : 0);
        return number(name.is("toupper") && is_lower ? c - 32 : name.is("tolower") && is_upper ? c + 32 : c);
    }
    if (name.is("strlen")) return integer(static_cast<std::int64_t>(text(0).size()));
    if (name.is("atoi")) return integer(static_cast<std::int32_t>(std::strtol(text(0).c_str(), nullptr, 10)));
    if (name.is("atof")) return real(std::strtod(text(0).c_str(), nullptr), false);
    if (name.is("strcmp")) return number(text(0).compare(text(1)));
    if (name.is("strncmp")) return number(text(0).substr(0, count(2)).compare(text(1).substr(0, count(2))));
    if (name.is("strcpy")) write_text(given[0], text(1), name.place);
    if (name.is("strcat")) write_text(given[0], text(0) + text(1), name.place);
    if (name.is("strncpy")) {
        std::string copy = text(1);
        copy.resize(std::min(count(2), copy.size() + 1));
        const std::span<std::byte> to = bytes_behind(given[0], count(2), true, name.place);
        std::fill_n(to.begin(), count(2), std::byte{0});
        std::memcpy(to.data(), copy.data(), copy.size());
    }
    if (!takes_more) return given[0];
    const bool is_limited = name.text.ends_with("snprintf");
    const std::size_t format = is_limited ? 2 : 1;
    const std::string made = printed(text(format), std::span(given).subspan(format + 1), name.place).text;
    if (!is_limited || count(1) > 0) write_text(given[0], is_limited ? made.substr(0, count(1) - 1) : made, name.place);
    return integer(static_cast<std::int64_t>(made.size()));
}

}  // namespace twinlight
