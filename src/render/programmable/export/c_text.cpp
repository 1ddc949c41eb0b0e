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
    const std::string text = fmt::format("{}", to_float(x));  // the shortest text that is this float
    return text.find_first_of(".en") == text.npos ? text : text + "f";
}

}  // namespace twinlight::programmable
