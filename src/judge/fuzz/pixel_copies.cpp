// Random rectangles of the picture that glCopyPixels draws again, with the state that they depend on (4.3.3).
#include <fmt/format.h>

#include <string>
#include <utility>

#include "judge/fuzz/random_states.h"

namespace twinlight::fuzz {

namespace {

class PixelCopy {
  public:
    PixelCopy(Random& random, const ShownBug& departure) : random_(random), departure_(departure) {}

    std::string text() {
        state();
        const bool of_depths =
            departure_.is_none() ? random_.chance(0.35) : !shows(compare::copies_pixels_without_zoom);
        const int copies = departure_.is_none() ? 1 + random_.below(2) : 1;
        for (int i = 0; i < copies; ++i) of_depths ? depths() : colors();
        add("glPixelZoom(1, 1);");
        for (const char* channel : {"RED", "GREEN", "BLUE", "ALPHA", "DEPTH"})
            add("glPixelTransferf(GL_{0}_SCALE, 1); glPixelTransferf(GL_{0}_BIAS, 0);", channel);
        return std::move(text_);
    }

  private:
    template <class Rule>
    bool shows(Rule* rule) const {
        return departure_.is(rule);
    }
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        text_ += fmt::format(format, std::forward<Arguments>(arguments)...) + '\n';
    }
    std::string color() {
        return fmt::format("glColor4f({:.4f}, {:.4f}, {:.4f}, {:.4f});", random_.uniform(0, 1), random_.uniform(0, 1),
                           random_.uniform(0, 1), random_.uniform(0, 1));
    }

    // Without textures and mostly without fog, which would show known bugs; and without what would hide them.
    void state() {
        for (int unit = 7; unit >= 0; --unit)
            add("glActiveTexture(GL_TEXTURE{}); glDisable(GL_TEXTURE_1D); glDisable(GL_TEXTURE_2D); "
                "glDisable(GL_TEXTURE_CUBE_MAP);",
                unit);
        add("glPixelTransferi(GL_MAP_COLOR, 0); glPixelTransferf(GL_RED_SCALE, 1); glPixelTransferf(GL_ALPHA_BIAS, "
            "0);");
        if (!departure_.is_none() || random_.chance(0.9)) add("glDisable(GL_FOG);");
        if (departure_.is_none()) return;
        add("glDisable(GL_DEPTH_TEST); glDisable(GL_ALPHA_TEST); glDisable(GL_STENCIL_TEST); glDisable(GL_BLEND); "
            "glDisable(GL_SCISSOR_TEST); glDisable(GL_LIGHTING); glDisable(GL_COLOR_LOGIC_OP); glColorMask(1, 1, 1, "
            "1);");
    }

    // Whole numbers: drivers round the raster position.
    void position() {
        const auto zoom = [&] {
            const int size = 1 + random_.below(4);
            return random_.chance(0.2) ? -size : size;
        };
        const int across = zoom(), up = zoom();
        if (shows(compare::copies_pixels_without_zoom))
            add("glPixelZoom(1, 1);");
        else
            add("glPixelZoom({}, {});", across, up);
        add("glWindowPos3f({}, {}, {:.4f});", random_.below(60) - 4, random_.below(60) - 4, random_.uniform(0, 1));
    }
    void copy(const char* type) {
        // In the window: pixels outside are undefined.
        const int width = 1 + random_.below(20), height = 1 + random_.below(20);
        add("glCopyPixels({}, {}, {}, {}, {});", random_.below(64 - width), random_.below(64 - height), width, height,
            type);
    }

    void colors() {
        if (random_.chance(0.3))
            for (const char* channel : {"RED", "GREEN", "BLUE", "ALPHA"})
                add("glPixelTransferf(GL_{0}_SCALE, {1:.3f}); glPixelTransferf(GL_{0}_BIAS, {2:.3f});", channel,
                    random_.uniform(-1, 2), random_.uniform(-0.5, 0.5));
        if (shows(compare::copies_pixels_without_zoom)) {
            add("glPixelTransferf(GL_RED_SCALE, 1); glPixelTransferf(GL_RED_BIAS, 0); glPixelTransferf(GL_GREEN_SCALE, "
                "1); glPixelTransferf(GL_GREEN_BIAS, 0); glPixelTransferf(GL_BLUE_SCALE, 1); "
                "glPixelTransferf(GL_BLUE_BIAS, 0); glPixelTransferf(GL_ALPHA_SCALE, 1); "
                "glPixelTransferf(GL_ALPHA_BIAS, 0); glColorMask(1, 0, 0, 1);");
        }
        position();
        copy("GL_COLOR");
    }

    // A triangle shows the depths afterwards.
    void depths() {
        add("glEnable(GL_DEPTH_TEST); glDepthMask(1); glDepthFunc({}); glDisable(GL_ALPHA_TEST);",
            !departure_.is_none() || random_.chance(0.6) ? "GL_ALWAYS" : "GL_LESS");
        if (!shows(compare::draws_colors_of_copied_depths)) add("glColorMask(0, 0, 0, 0);");
        if (shows(compare::transfers_copied_depths))
            add("glPixelTransferf(GL_DEPTH_SCALE, {:.3f}); glPixelTransferf(GL_DEPTH_BIAS, {:.3f});",
                random_.uniform(0.1, 0.5), random_.uniform(0, 0.2));
        add("{}", color());
        position();
        if (shows(compare::draws_colors_of_copied_depths)) add("{}", color());
        copy("GL_DEPTH");
        if (shows(compare::draws_colors_of_copied_depths)) return;
        const double near = random_.uniform(1.2, 4), far = random_.uniform(4, 9.8);
        add("glColorMask(1, 1, 1, 1); glDepthFunc(GL_LESS); glDisable(GL_LIGHTING); glDisable(GL_CULL_FACE);");
        add("glMatrixMode(GL_MODELVIEW); glPushMatrix(); glLoadIdentity(); glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);");
        add("{} glBegin(GL_TRIANGLES); glVertex3f({:.3f}, {:.3f}, {:.3f}); glVertex3f({:.3f}, {:.3f}, {:.3f}); "
            "glVertex3f({:.3f}, {:.3f}, {:.3f}); glEnd(); glPopMatrix();",
            color(), -1.5 * near, -near, -near, 1.5 * near, -near, -near, random_.uniform(-1, 1) * far, far, -far);
    }

  public:
    // Stencil values, drawn or copied, and triangles that show them.
    std::string stencil_text() {
        add("glPushAttrib(GL_ENABLE_BIT | GL_POLYGON_BIT | GL_CURRENT_BIT | GL_STENCIL_BUFFER_BIT);");
        state();
        if (departure_.is_none() && random_.chance(0.5)) add("glStencilMask({});", random_.below(256));
        const bool has_scissor = departure_.is_none() && random_.chance(0.3);
        if (has_scissor)
            add("glEnable(GL_SCISSOR_TEST); glScissor({}, {}, {}, {});", random_.below(32), random_.below(32),
                8 + random_.below(40), 8 + random_.below(40));
        if (shows(compare::transfers_stencil_values))
            add("glPixelTransferi(GL_INDEX_OFFSET, {});", 1 + random_.below(3));
        if (departure_.is_none() && random_.chance(0.5))
            add("glClearStencil({}); glClear(GL_STENCIL_BUFFER_BIT);", random_.below(4));
        for (int i = departure_.is_none() ? 1 + random_.below(3) : 1; i > 0; --i) {
            position();
            if (random_.chance(0.4))
                add("glDrawPixels(2, 2, GL_STENCIL_INDEX, GL_UNSIGNED_INT, (GLuint[]){{{}, {}, {}, {}}});",
                    random_.below(4), random_.below(4), random_.below(300), random_.below(4));
            else
                copy(random_.chance(0.2) ? "GL_DEPTH_STENCIL" : "GL_STENCIL");
        }
        add("glPixelTransferi(GL_INDEX_OFFSET, 0); glPixelZoom(1, 1); glStencilMask(255); glDisable(GL_SCISSOR_TEST);");
        add("glDisable(GL_FOG); glDisable(GL_LIGHTING); glDisable(GL_CULL_FACE); glDisable(GL_DEPTH_TEST); "
            "glDisable(GL_ALPHA_TEST); glDisable(GL_BLEND); "
            "glEnable(GL_STENCIL_TEST); glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP); glPolygonMode(GL_FRONT_AND_BACK, "
            "GL_FILL);");
        add("glMatrixMode(GL_PROJECTION); glPushMatrix(); glLoadIdentity(); glMatrixMode(GL_MODELVIEW); "
            "glPushMatrix(); glLoadIdentity();");
        for (int value = 1; value < 4; ++value)
            add("glStencilFunc(GL_EQUAL, {}, 255); {} glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(3, -1); "
                "glVertex2f(-1, 3); glEnd();",
                value, color());
        add("glPopMatrix(); glMatrixMode(GL_PROJECTION); glPopMatrix(); glMatrixMode(GL_MODELVIEW); glPopAttrib();");
        return std::move(text_);
    }

  private:
    Random& random_;
    ShownBug departure_;
    std::string text_;
};

}  // namespace

bool is_of_pixel_copies(const ShownBug& departure) {
    return departure.is(compare::copies_pixels_without_zoom) || departure.is(compare::draws_colors_of_copied_depths) ||
           departure.is(compare::transfers_copied_depths);
}

bool is_of_stencil_pixels(const ShownBug& departure) { return departure.is(compare::transfers_stencil_values); }

std::string stencil_pixels(Random& random, const ShownBug& departure) {
    return PixelCopy(random, departure).stencil_text();
}

std::string pixel_copy(Random& random, const ShownBug& departure) { return PixelCopy(random, departure).text(); }

}  // namespace twinlight::fuzz
