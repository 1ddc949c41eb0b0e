// Rules about a state that is left on for text and other drawing that it is not for.
#include <algorithm>
#include <cmath>

#include "base/text/translation.h"
#include "judge/lint/watch.h"

namespace twinlight::lint {

namespace {

// Finds Draws with the state, one after the other, and where to disable it before them and to enable it again after them.
class LeftOn : public Watch {
  public:
    void before(const Command& command, const State& state) override {
        if (is_effect(command, "raster_pos") || is_effect(command, "window_pos")) raster_ = command.place;
        if (open_ && !next_ && command.place != open_->last) next_ = command.place;
        see(command, state);
    }
    void drawn(const Draw& draw, const State& state) override {
        const std::optional<std::string> effect = effect_on(draw, state);
        if (!effect) {
            if (first_.line == 0 && uses(draw)) first_ = draw.place;
            return close();
        }
        // 2.13: the raster position has the lit colour and the texture coordinates of its own call.
        if (!open_)
            open_ = {.start = draw.pixels && raster_.line > 0 ? raster_ : draw.place,
                     .state = *effect,
                     .is_text = draw.pixels != nullptr};
        open_->repeats = open_->last == draw.place;
        open_->last = open_->end = draw.place;
        next_.reset();
    }
    void after(const Command& command, const State&) override {
        if (open_ && !next_ && is_effect(command, "end")) open_->end = command.place;
    }
    void finish(const Frame&, bool) override { close(); }

  protected:
    // The name of the state, such as GL_LIGHTING, if it is left on for this Draw.
    virtual std::optional<std::string> effect_on(const Draw& draw, const State& state) = 0;
    virtual bool uses(const Draw& draw) const = 0;  // whether the state counts for it
    virtual void see(const Command&, const State&) {}
    virtual std::string message(bool is_text) const = 0;

  private:
    struct Drawing {
        Place start, last{}, end{};  // its first statement; the last Draw's, and where that ends
        std::string state;
        bool is_text = false;
        bool repeats = false;  // its last statement is executed repeatedly
    };

    void close() {
        if (!open_) return;
        const std::string disable = fmt::format("glDisable({});", open_->state),
                          enable = fmt::format("glEnable({});", open_->state);
        std::vector<Edit> edits{{.place = open_->start, .insert = disable}};
        if (next_)
            edits.push_back({.place = *next_, .insert = enable});
        else if (!open_->repeats)
            edits.push_back({.place = open_->end, .insert = enable, .is_after = true});
        else if (first_.line > 0)  // the end of a loop has no place: for the next picture
            edits.push_back({.place = first_, .insert = enable});
        warn({.place = open_->start,
              .message = message(open_->is_text),
              .fix = tr("{} before {}, {} after {}", disable, open_->is_text ? "glRasterPos" : tr("it"), enable,
                        open_->is_text ? tr("the text") : tr("it")),
              .edits = std::move(edits),
              .key = "left"});
        open_.reset();
        next_.reset();
    }

    std::optional<Drawing> open_;
    std::optional<Place> next_;  // of the first command after it
    Place raster_;               // of the last glRasterPos
    Place first_;                // of the first Draw that the state is meant for
};

// Flat drawing over the picture (orthographic, without depth test) that is lit as well.
class LitOverlay : public LeftOn {
    std::optional<std::string> effect_on(const Draw& draw, const State&) override {
        if (!lit_.is_overlay(draw)) return std::nullopt;
        return "GL_LIGHTING";
    }
    bool uses(const Draw& draw) const override { return draw.lighting.enabled; }
    std::string message(bool is_text) const override {
        return is_text
                   ? tr("this text has the colour of a lit surface, not that of glColor: GL_LIGHTING is still enabled "
                        "at glRasterPos")
                   : tr("this overlay is lit like the scene: GL_LIGHTING is still enabled");
    }

    LitOverlays lit_;
};

// What has no texture coordinates of its own, and gets the colour of one texel.
class TextureLeftOn : public LeftOn {
    void see(const Command& command, const State& state) override {
        if (kDrawCommands.contains(command.id)) current_ = state.attributes().current.tex_coord;
    }
    std::optional<std::string> effect_on(const Draw& draw, const State& state) override {
        const Texture* texture = draw.texture.texture.get();
        const glm::dvec4 coordinates = draw.vertices.front().tex_coord;
        const bool has_one =
            std::ranges::all_of(draw.vertices, [&](const Vertex& v) { return v.tex_coord == coordinates; });
        // Neither glTexCoord nor an array was called for it: it has what the Draw before left.
        const bool has_none =
            has_one && (draw.pixels || (coordinates == current_ && (coordinates == left_ || coordinates == kInitial)));
        left_ = draw.vertices.back().tex_coord;
        if (!texture) return std::nullopt;
        if (!has_one) textured_.insert(texture);
        const bool counts = draw.texture.env_mode == kGL_MODULATE || draw.texture.env_mode == kGL_REPLACE;
        if (!has_none || !counts || !draw.texture.generated.empty() || draw.combines_textures() ||
            !textured_.contains(texture) || !is_colored(*texture, coordinates))
            return std::nullopt;
        return std::string(enum_name(state.attributes().units[0].target()));
    }
    bool uses(const Draw& draw) const override { return draw.texture.texture != nullptr; }
    std::string message(bool is_text) const override {
        return is_text
                   ? tr("a texture is still enabled, so this text has the colour of one of its texels")
                   : tr("a texture is still enabled, but this object has no texture coordinates, so all of it has the "
                        "colour of one texel");
    }

    // Whether the texel there changes a colour.
    static bool is_colored(const Texture& texture, const glm::dvec4& coordinates) {
        if (texture.levels.empty() || texture.is_cube() || texture.is_volume() || texture.has_copies() ||
            texture.base_format() == kGL_ALPHA || coordinates.w == 0)
            return false;
        const auto& level = texture.levels[0];
        const auto place = [](double coordinate, int size) {
            const double part = coordinate - std::floor(coordinate);  // GL_REPEAT
            return std::min(static_cast<int>(part * size), size - 1);
        };
        const int x = place(coordinates.x / coordinates.w, level.width),
                  y = place(coordinates.y / coordinates.w, level.height);
        const std::size_t at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x);
        constexpr float kWhite = 0.9F;
        const glm::vec4& texel = level.texels[at];
        return std::min({texel.r, texel.g, texel.b}) < kWhite;
    }

    static constexpr glm::dvec4 kInitial{0, 0, 0, 1};
    glm::dvec4 current_ = kInitial, left_ = kInitial;  // before this command; of the last vertex
    std::set<const Texture*> textured_;                // those that other Draws have with coordinates
};

}  // namespace

std::vector<Rule> overlay_rules() {
    return {
        {"lit-overlay",
         "Something flat (text, a panel) is drawn over a lit scene in perspective, without depth test, and "
         "`GL_LIGHTING` is still enabled. Its colours are those of a lit surface.",
         "Section 2.14.1: with `GL_LIGHTING` every vertex is lit, also in an orthographic projection. Section 2.13: "
         "text "
         "has the colour that `glRasterPos` finds, so `GL_LIGHTING` must be disabled before it.",
         "glDisable(GL_LIGHTING);",
         R"(// the view
// the light
 glutSolidSphere(1.5, 40, 20);
 glMatrixMode(GL_PROJECTION);
 glLoadIdentity();
 gluOrtho2D(0, 4, 0, 3);
 glMatrixMode(GL_MODELVIEW);
 glLoadIdentity();
 glDisable(GL_DEPTH_TEST);
+glDisable(GL_LIGHTING);
 glRectf(0.2, 0.2, 1.2, 0.5);
+glEnable(GL_LIGHTING);
)",
         make_watch<LitOverlay>},
        {"texture-left-on",
         "A texture is still enabled for an object or a text that has no texture coordinates. All of it has the colour "
         "of "
         "one texel.",
         "Section 2.7: without `glTexCoord` a vertex has the current texture coordinates, which the object before "
         "left. "
         "Section 2.13: so has text, from `glRasterPos`.",
         "glDisable(GL_TEXTURE_2D);",
         R"(// the view
// the light
 GLubyte texels[] = {255, 128, 0, 255, 0, 128, 255, 255};
 glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
 glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
 glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
 glEnable(GL_TEXTURE_2D);
 glBegin(GL_QUADS);
 glNormal3f(0, 1, 0);
 glTexCoord2f(0, 0); glVertex3f(-3, -1, 3);
 glTexCoord2f(1, 0); glVertex3f(3, -1, 3);
 glTexCoord2f(1, 1); glVertex3f(3, -1, -3);
 glTexCoord2f(0, 1); glVertex3f(-3, -1, -3);
 glEnd();
+glDisable(GL_TEXTURE_2D);
 glutSolidSphere(1, 40, 20);
+glEnable(GL_TEXTURE_2D);
)",
         make_watch<TextureLeftOn>},
    };
}

}  // namespace twinlight::lint
