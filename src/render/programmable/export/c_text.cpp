#include "render/programmable/export/c_text.h"

#include <fmt/format.h>

#include <string_view>

#include "render/programmable/numbers/draw_values.h"

namespace twinlight::programmable {

std::string printable(std::string text) {
    for (char& c : text)
        if ((c >= 0 && c < ' ') || std::string_view("<>&\\\x7F").find(c) != std::string_view::npos) c = '?';
    return text;
}

std::string c_number(double x) {
    const std::string text = fmt::format("{:.9g}", to_float(x));
    return text.find_first_of(".en") == text.npos ? text : text + "f";
}

std::string c_floats(const glm::dvec4& v) { return fmt::format("(float[]){{{}}}", c_numbers(v)); }
std::string c_floats(const glm::dmat4& m) {
    return fmt::format("(float[]){{{}, {}, {}, {}}}", c_numbers(m[0]), c_numbers(m[1]), c_numbers(m[2]),
                       c_numbers(m[3]));
}

}  // namespace twinlight::programmable
