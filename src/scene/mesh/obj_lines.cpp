// Checks the lines of an OBJ file.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "base/text/translation.h"
#include "scene/command/lexer.h"
#include "scene/mesh/obj.h"

namespace twinlight {

namespace {

template <class... Values>
[[noreturn]] void refuse(std::size_t line, fmt::format_string<Values...> message, Values&&... values) {
    throw std::runtime_error(tr("line {}: {}", line, vtr(message, fmt::make_format_args(values...))));
}

constexpr std::string_view kSpaces = " \t\r\f\v";

// The next word; removes it from the line. Empty at the end of the line or before a comment.
std::string_view word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
    if (line.starts_with('#')) line = {};
    const std::string_view found = line.substr(0, line.find_first_of(kSpaces));
    line.remove_prefix(found.size());
    return found;
}

// Positions, texture coordinates or normals: how many the file has, and the largest index that a face uses.
struct Elements {
    std::string_view name;
    std::size_t count = 0;
    std::int64_t largest = 0;
    std::size_t largest_line = 0;
};

class Checker {
  public:
    explicit Checker(std::string_view text) : rest_(text) {}

    std::string run() {
        std::string kept;
        while (!rest_.empty()) {
            const std::string joined = next_line();
            std::string_view line = joined;
            const std::string_view keyword = word(line);
            if (keyword == "v")
                numbers(elements_[0], line, 3, 8);
            else if (keyword == "vt")
                numbers(elements_[1], line, 1, 3);
            else if (keyword == "vn")
                numbers(elements_[2], line, 3, 3);
            else if (keyword == "f")
                face(line);
            else if (keyword != "usemtl" && keyword != "mtllib")
                continue;
            kept.append(joined).append("\n");
        }
        for (const Elements& all : elements_) {
            if (all.largest <= static_cast<std::int64_t>(all.count)) continue;
            refuse(all.largest_line, "this face uses {} {}, but the file has only {}", all.name, all.largest,
                   all.count);
        }
        if (triangles_ == 0)
            throw std::runtime_error(tr("this file has no faces; it must have lines such as 'f 1 2 3'"));
        return kept;
    }

  private:
    // The next line, with those that continue it after a '\'.
    std::string next_line() {
        std::string line;
        std::size_t lines = 0;
        do {
            if (!line.empty()) line.back() = ' ';
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            std::string_view part = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            if (part.ends_with('\r')) part.remove_suffix(1);
            line += part;
            ++lines;
        } while (line.ends_with('\\') && !rest_.empty());
        line_ = next_;
        next_ += lines;
        if (line.find('\0') != std::string::npos) refuse(line_, "this is not a text file");
        return line;
    }

    void numbers(Elements& elements, std::string_view line, int least, int most) {
        int count = 0;
        for (std::string_view text = word(line); !text.empty(); text = word(line)) {
            double value = 0;
            std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
            const bool is_read = (error == std::errc() || error == std::errc::result_out_of_range) &&
                                 end == digits.data() + digits.size();
            if (!is_read) refuse(line_, "expected a number, found {}", in_quotes(text));
            if (error != std::errc() || !(std::abs(value) <= std::numeric_limits<float>::max()))
                refuse(line_, "{} is not a finite float", in_quotes(text));
            if (++count > most) refuse(line_, "{} has at most {} numbers", elements.name, most);
        }
        if (count < least) refuse(line_, "{} needs {} numbers, but {} are given", elements.name, least, count);
        if (++elements.count > kMaxMeshVertices)
            refuse(line_, "a mesh can have at most {} of each: vertices, texture coordinates, normals",
                   kMaxMeshVertices);
    }

    void face(std::string_view line) {
        std::size_t corners = 0;
        for (std::string_view text = word(line); !text.empty(); text = word(line)) {
            corner(text);
            if (++corners > kMaxFaceCorners) refuse(line_, "a face can have at most {} corners", kMaxFaceCorners);
        }
        if (corners < 3) refuse(line_, "a face needs 3 corners, but {} are given", corners);
        triangles_ += corners - 2;
        if (triangles_ > kMaxMeshTriangles) refuse(line_, "a mesh can have at most {} triangles", kMaxMeshTriangles);
    }

    // 7, 7/2, 7//3 or 7/2/3
    void corner(std::string_view text) {
        const std::string_view whole = text;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string_view digits = text.substr(0, text.find('/'));
            text.remove_prefix(digits.size());
            if (!(digits.empty() && i == 1 && text.size() > 1)) index(elements_[i], digits, whole);
            if (text.empty()) return;
            text.remove_prefix(1);
        }
        refuse(line_, "{} is not a corner of a face; it must look like 7, 7/2, 7//3 or 7/2/3", in_quotes(whole));
    }

    // Indices count from 1; -1 is the last element so far.
    void index(Elements& elements, std::string_view digits, std::string_view whole) {
        std::int64_t index = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
            refuse(line_, "{} is not a corner of a face; it must look like 7, 7/2, 7//3 or 7/2/3", in_quotes(whole));
        const auto so_far = static_cast<std::int64_t>(elements.count);
        if (error != std::errc() || index == 0)
            refuse(line_, "a face uses {} {}; indices start at 1", elements.name, in_quotes(digits));
        if (index < 0 && -index > so_far)
            refuse(line_, "this face uses {} {}, but only {} precede it", elements.name, index, so_far);
        if (index <= elements.largest) return;
        elements.largest = index;
        elements.largest_line = line_;
    }

    std::string_view rest_;
    std::size_t line_ = 1, next_ = 1;
    Elements elements_[3] = {{tr("vertex")}, {tr("texture coordinate")}, {tr("normal")}};
    std::size_t triangles_ = 0;
};

}  // namespace

std::string obj_lines(std::string_view text) {
    if (text.size() > kMaxObjBytes)
        throw std::runtime_error(
            tr("this file has more than {} MiB, the limit for a mesh; use a coarser mesh", kMaxObjBytes >> 20));
    return Checker(text).run();
}

}  // namespace twinlight
