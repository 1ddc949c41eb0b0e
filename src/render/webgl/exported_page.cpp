#include "render/webgl/exported_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
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

// The programs' texts as parts of the page that a reader can find. The programs have the parts' names instead.
class ShaderParts {
  public:
    void take(Json& programs) {
        for (Json& program : programs)
            for (const auto& [stage, ending] : {std::pair("vertex", "vert"), {"fragment", "frag"}})
                program[stage] = name_of(program[stage].get<std::string>(), ending);
    }
    std::string text{};

  private:
    std::string name_of(const std::string& shader, const char* ending) {
        const auto [at, is_new] = names_.try_emplace(shader);
        if (is_new) {
            at->second = fmt::format("kind{}.{}", ++numbers_[ending], ending);
            text += fmt::format("<script type=\"text/plain\" id=\"{}\">\n{}</script>\n", at->second, shader);
        }
        return at->second;
    }

    std::map<std::string, std::string> names_{};  // by the text
    std::map<std::string, int> numbers_{};        // of the last part with this ending
};

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

std::string missing_text(const std::map<std::string, Place>& missing) {
    if (missing.empty()) return "";
    std::string text = "<p>This picture lacks a part, because WebGL lacks it:</p>\n<ul>\n";
    for (const auto& [message, place] : missing) text += fmt::format("<li>line {}: {}</li>\n", place.line, message);
    return text + "</ul>\n";
}

std::string paragraph(const std::string& text) { return text.empty() ? "" : "<p>" + escaped(text) + "</p>\n"; }

}  // namespace

std::string exported_page(const std::vector<PageStep>& steps, const Look& look, const PageText& text) {
    programmable::ExportWords words;
    ShaderParts shaders;
    std::string views, refused;
    std::map<std::string, Place> missing;
    const Frame* first = nullptr;
    for (const PageStep& step : steps) {
        if (const std::string why = programmable::why_not_kept(*step.frame); !why.empty()) {
            refused = why;
            continue;
        }
        if (!first) first = step.frame;
        const DrawableFrame drawable = reference::drawable(*step.frame, {look});
        std::string before;
        for (const Shading shading : {Shading::kGouraud, Shading::kPhong}) {
            PlanOptions options{look};
            options.for_any_pose = true;
            if (!look.shading && shading == Shading::kPhong) options.shading = shading;
            Json header = webgl_header(*drawable, options, words);
            for (const Json& one : header["missing"])
                missing.try_emplace(one["message"].get<std::string>(), Place{.file = {}, .line = one["line"]});
            header.erase("missing");
            shaders.take(header["programs"]);
            const std::string view = in_lines(header);
            if (view == before) break;  // nothing is lit
            header["step"] = programmable::printable(step.title);
            if (!look.shading) header["shading"] = shading == Shading::kPhong ? "per pixel" : "per vertex";
            views += (views.empty() ? "[" : ",\n") + in_lines(header);
            before = view;
            if (look.shading) break;
        }
        for (const Draw* draw : step.frame->draws())
            if (draw->pixels && draw->pixels->copied)
                missing.try_emplace("after a turn, the pixels of glCopyPixels are still those of the first view",
                                    draw->place);
    }
    if (!first) throw std::runtime_error(refused);
    const std::string_view bytes(reinterpret_cast<const char*>(words.all.data()), 4 * words.all.size());  // NOLINT
    return filled(text_of_file("exported_page.html"), {{"title", escaped(text.name)},
                                                       {"shows", paragraph(text.shows)},
                                                       {"notice", paragraph(text.notice)},
                                                       {"width", fmt::format("{}", first->width)},
                                                       {"height", fmt::format("{}", first->height)},
                                                       {"missing", missing_text(missing)},
                                                       {"shaders", shaders.text},
                                                       {"views", views + "]"},
                                                       {"words", base64(bytes)},
                                                       {"theme.css", text_of_file("theme.css")},
                                                       {"gl.js", text_of_file("gl.js")},
                                                       {"labels.js", text_of_file("labels.js")},
                                                       {"terms.js", text_of_file("terms.js")},
                                                       {"theme.js", text_of_file("theme.js")},
                                                       {"viewer.js", text_of_file("viewer.js")}});
}

}  // namespace twinlight::webgl
