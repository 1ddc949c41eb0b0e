// A rule about the text: the exponent Ns of an OBJ file's materials, scaled from 0..1000 to 0..128.
#include <algorithm>
#include <regex>

#include "base/text/translation.h"
#include "judge/lint/source.h"
#include "judge/lint/watch.h"

namespace twinlight::lint {

namespace {

// Whether a statement scales something by 128 / 1000, and is about a shininess. Blanks were removed from it.
bool scales_shininess(const std::string& statement) {
    constexpr std::size_t kLongest = 1000;  // regular expressions need stack for long texts, such as tables of numbers
    if (statement.size() > kLongest) return false;
    static const std::regex scale(
        R"(\*0?\.128f?(?![0-9.])|(^|[^0-9.])0?\.128f?\*|/1000(\.0*)?f?\)*\*128(\.0*)?f?(?![0-9.])|(^|[^0-9.])128(\.0*)?f?(\*\(*[A-Za-z_0-9.>\[\]-]+)?\)*/1000(\.0*)?f?(?![0-9.]))");
    static const std::regex name(R"((^|[^A-Za-z])(Ns|ns|NS)([^A-Za-z]|$)|[Ss]hin|SHIN)");
    return std::regex_search(statement, scale) && std::regex_search(statement, name);
}

class ScaledShininess : public Watch {
  public:
    void start(const CommandList* list) override { text_ = list ? list->text : nullptr; }
    void after(const Command& command, const State&) override {
        if (is_effect(command, "material") && pname_of(command) == kGL_SHININESS && command.arguments.back() > 0)
            commands_.push_back(command);
    }
    void drawn(const Draw& draw, const State&) override {
        has_highlight_ |= has_specular_light(draw) && !is_black(draw.lighting.front.specular);
    }
    void finish(const Frame&, bool) override {
        if (!text_ || !has_highlight_ || commands_.empty()) return;
        const std::vector<Statement> scaling = statements_with(*text_, scales_shininess);
        if (scaling.empty()) return;
        for (const Command& command : commands_) {
            const bool is_here = std::ranges::any_of(
                scaling, [&](const Statement& statement) { return statement.holds(command.place); });
            const std::string call =
                fmt::format("glMaterialf({}, GL_SHININESS, {:.4g});", enum_name(command.enumerant(0)),
                            std::min(128.0, command.arguments.back() * 1000 / 128));
            Warning warning{
                .place = command.place,
                .message = tr("this shininess is scaled from 0..1000 to 0..128, but Ns of an OBJ file is the "
                              "exponent itself: the highlight is too large"),
                .fix = tr("{} (Ns as it is, at most 128)", call)};
            if (is_here) warning.edits = {{.place = command.place, .removes = true, .insert = call}};
            warn(std::move(warning));
            if (!is_here) return;  // the scale is elsewhere: once is enough
        }
    }

  private:
    std::shared_ptr<const std::string> text_;
    std::vector<Command> commands_;
    bool has_highlight_ = false;
};

}  // namespace

std::vector<Rule> scaled_shininess_rules() {
    return {
        {"shininess-scaled",
         "The exponent `Ns` of an OBJ file's material is scaled from 0..1000 to 0..128. The highlight is too large.",
         "Section 2.14.1: the shininess is the exponent of n . h, and so is `Ns`. GL only limits it to 128 (table "
         "2.10).",
         "glMaterialf(GL_FRONT, GL_SHININESS, fmin(Ns, 128));",
         R"(// the view
// the light
 GLfloat Ns = 96.08;
 glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});
-glMaterialf(GL_FRONT, GL_SHININESS, Ns * 0.128);
+glMaterialf(GL_FRONT, GL_SHININESS, Ns);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<ScaledShininess>},
    };
}

}  // namespace twinlight::lint
