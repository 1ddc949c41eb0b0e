#include "render/webgl/exported_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/text/json.h"
#include "base/text/page.h"
#include "render/programmable/export/c_text.h"
#include "render/programmable/export/kept_code.h"
#include "render/reference/copied_pixels.h"
#include "render/webgl/webgl_frame.h"

namespace twinlight::webgl {
namespace {

std::string text_of_file(std::string_view name) {
    return std::string(std::ranges::find(kWebglFiles, name, &EmbeddedFile::name)->text);
}

// The programs' texts as parts of the page that a reader can find; then the programs have their names instead.
std::string taken_shaders(Json& programs) {
    std::string parts;
    int number = 0;
    for (Json& program : programs) {
        ++number;
        for (const auto& [stage, ending] : {std::pair("vertex", "vert"), {"fragment", "frag"}}) {
            const std::string name = fmt::format("kind{}.{}", number, ending);
            parts += fmt::format("<script type=\"text/plain\" id=\"{}\">\n{}</script>\n", name,
                                 program[stage].get<std::string>());
            program[stage] = name;
        }
    }
    return parts;
}

// A line for each element of a list.
std::string in_lines(const Json& header) {
    std::string text;
    for (const auto& [name, value] : header.items()) {
        text += fmt::format("{}\n\"{}\": ", text.empty() ? "{" : ",", name);
        if (!value.is_array() || value.empty() || !value[0].is_structured()) {
            text += dumped(value);
            continue;
        }
        for (std::size_t i = 0; i < value.size(); ++i) text += (i == 0 ? "[\n  " : ",\n  ") + dumped(value[i]);
        text += "]";
    }
    return text + "\n}";
}

std::string missing_text(const Json& missing) {
    if (missing.empty()) return "";
    std::string text = "<p>This picture lacks a part, because WebGL does:</p>\n<ul>\n";
    for (const Json& one : missing)
        text += fmt::format("<li>line {}: {}</li>\n", one["line"].get<int>(), one["message"].get<std::string>());
    return text + "</ul>\n";
}

}  // namespace

std::string exported_page(const Frame& frame, const Look& look, const std::string& name) {
    if (const std::string why = programmable::why_not_kept(frame); !why.empty()) throw std::runtime_error(why);
    PlanOptions options{look};
    options.for_any_pose = true;
    const DrawableFrame drawable = reference::drawable(frame, {look});
    WebglFrame drawn = webgl_frame(*drawable, options);
    for (const Draw* draw : frame.draws())
        if (draw->pixels && draw->pixels->copied) {
            drawn.header["missing"].push_back(
                {{"line", draw->place.line},
                 {"column", draw->place.column},
                 {"message", "after a turn, the pixels of glCopyPixels are still those of the first view"}});
            break;
        }
    const std::string missing = missing_text(drawn.header["missing"]);
    drawn.header.erase("missing");
    const std::string shaders = taken_shaders(drawn.header["programs"]);
    const std::string_view words(reinterpret_cast<const char*>(drawn.words.data()), 4 * drawn.words.size());  // NOLINT
    return filled(text_of_file("exported_page.html"), {{"title", programmable::printable(name)},
                                                       {"width", fmt::format("{}", frame.width)},
                                                       {"height", fmt::format("{}", frame.height)},
                                                       {"missing", missing},
                                                       {"shaders", shaders},
                                                       {"scene", in_lines(drawn.header)},
                                                       {"words", base64(words)},
                                                       {"gl.js", text_of_file("gl.js")},
                                                       {"viewer.js", text_of_file("viewer.js")}});
}

}  // namespace twinlight::webgl
