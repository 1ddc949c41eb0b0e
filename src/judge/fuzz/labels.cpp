// Random bitmaps and pixel rectangles, with the state that they depend on (2.13, 3.6, 3.7).
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "judge/fuzz/random_states.h"

namespace twinlight::fuzz {

namespace {

bool is_of_rectangles(const ShownBug& departure) {
    return departure.is(compare::maps_drawn_pixels) || departure.is(compare::mirrors_stenciled_pixels);
}

bool is_of_raster_position(const ShownBug& departure) {
    return departure.is_any(compare::has_fog_at_raster_position, compare::has_raster_position_in_eye_coordinates,
                            compare::has_secondary_color_at_raster_position, compare::has_texture_at_raster_position,
                            compare::has_long_normal_at_raster_position, compare::has_dim_light_at_raster_position);
}

class Label {
  public:
    Label(Random& random, const ShownBug& departure) : random_(random), departure_(departure) {}

    std::string text() {
        add("glMatrixMode(GL_MODELVIEW);");
        state();
        const bool may_be_rectangle = shows(compare::has_texture_at_raster_position) ||
                                      (!is_of_raster_position(departure_) && !shows(compare::is_textured_bitmap));
        const bool is_rectangle = is_of_rectangles(departure_) || (may_be_rectangle && random_.chance(0.4));
        if (!is_rectangle) lighting();
        add("glColor4f({0}); glSecondaryColor3f({1:.3f}, {1:.3f}, {2:.3f}); glFogCoordf({3:.3f});", numbers(4, 0, 1),
            random_.uniform(0, 1), random_.uniform(0, 1), random_.uniform(0, 14));
        add("glTexCoord4f({}, 0, 1); glMultiTexCoord4f(GL_TEXTURE1, {}, 0, 1);", numbers(2, -1, 2), numbers(2, -1, 2));
        if (shows(compare::has_texture_at_raster_position) || shows(compare::is_textured_bitmap))
            add("glActiveTexture(GL_TEXTURE0); glBindTexture(GL_TEXTURE_2D, 40); glEnable(GL_TEXTURE_2D); "
                "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); "
                "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); "
                "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 1, 0, GL_LUMINANCE, GL_FLOAT, (GLfloat[]){{0.1, 0.9}}); "
                "glColor4f(1, 1, 1, 1); glTexCoord4f(0.25, 0.5, 0, 1); "
                "glMatrixMode(GL_TEXTURE); glLoadIdentity(); glTranslatef(0.5, 0, 0); glMatrixMode(GL_MODELVIEW);");
        position();
        is_rectangle ? rectangle() : bitmaps();
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
    std::string numbers(int count, double low, double high) {
        std::string text;
        for (int i = 0; i < count; ++i) text += fmt::format("{}{:.4f}", i > 0 ? ", " : "", random_.uniform(low, high));
        return text;
    }

    // Without textures and mostly without fog, which would show known bugs; and without what would hide them.
    void state() {
        for (int unit = 7; unit >= 0; --unit)
            add("glActiveTexture(GL_TEXTURE{}); glDisable(GL_TEXTURE_1D); glDisable(GL_TEXTURE_2D); "
                "glDisable(GL_TEXTURE_CUBE_MAP);",
                unit);
        if (departure_.is_none()) {
            if (random_.chance(0.9)) add("glDisable(GL_FOG);");
            return;
        }
        add("glDisable(GL_DEPTH_TEST); glDisable(GL_ALPHA_TEST); glDisable(GL_STENCIL_TEST); glDisable(GL_BLEND); "
            "glDisable(GL_SCISSOR_TEST); glDisable(GL_LIGHTING); glColorMask(1, 1, 1, 1); "
            "glDisable(GL_COLOR_LOGIC_OP);");
        if (shows(compare::has_fog_at_raster_position))
            add("glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_START, 0); glFogf(GL_FOG_END, 9);");
        else
            add("glDisable(GL_FOG);");
    }

    // Without a known bug: directional lights, normals of length 1, one colour.
    void lighting() {
        if (departure_.is_none() ? random_.chance(0.5) : shows(compare::has_fog_at_raster_position)) return;
        add("glEnable(GL_LIGHTING); glDisable(GL_COLOR_MATERIAL); glDisable(GL_NORMALIZE); "
            "glDisable(GL_RESCALE_NORMAL);");
        for (int light = 0; light < 8; ++light) add("glDisable(GL_LIGHT{});", light);
        add("glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 0); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0);");
        const bool separate = shows(compare::has_secondary_color_at_raster_position);
        add("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, {});",
            separate ? "GL_SEPARATE_SPECULAR_COLOR" : "GL_SINGLE_COLOR");
        for (const char* name : {"GL_AMBIENT", "GL_DIFFUSE", "GL_SPECULAR"})
            add("glMaterialfv(GL_FRONT, {}, (GLfloat[]){{{}}});", name, numbers(4, 0.1, 0.8));
        add("glMaterialf(GL_FRONT, GL_SHININESS, {:.2f});", random_.uniform(1, 20));
        const bool is_positional =
            shows(compare::has_raster_position_in_eye_coordinates) || shows(compare::has_dim_light_at_raster_position);
        const bool is_dim = shows(compare::has_dim_light_at_raster_position);
        const int lights = 1 + random_.below(3);
        for (int light = 0; light < lights; ++light) {
            // glLight multiplies by the modelview matrix; here it is the identity.
            add("glPushMatrix(); glLoadIdentity(); glLightfv(GL_LIGHT{}, GL_POSITION, (GLfloat[]){{{}, {:.3f}, {}}}); "
                "glPopMatrix();",
                light, numbers(2, -1, 1), random_.uniform(0.2, 2), is_positional ? 1 : 0);
            add("glLightf(GL_LIGHT{0}, GL_SPOT_CUTOFF, 180); glLightf(GL_LIGHT{0}, GL_CONSTANT_ATTENUATION, {1}); "
                "glLightf(GL_LIGHT{0}, GL_LINEAR_ATTENUATION, 0); glLightf(GL_LIGHT{0}, GL_QUADRATIC_ATTENUATION, 0);",
                light, is_dim ? 2000 : 1);
            const double scale = is_dim ? 2000 : 1;
            for (const char* name : {"GL_AMBIENT", "GL_DIFFUSE", "GL_SPECULAR"})
                add("glLightfv(GL_LIGHT{}, {}, (GLfloat[]){{{}}});", light, name, numbers(4, 0, scale));
            add("glEnable(GL_LIGHT{});", light);
        }
        const bool is_long = shows(compare::has_long_normal_at_raster_position);
        if (is_long) add("glEnable(GL_NORMALIZE);");
        add("glNormal3f({});", is_long ? "0.3, 0.4, 2.5" : random_.chance(0.5) ? "0.6, 0, 0.8" : "0, 0, 1");
    }

    void position() {
        if (departure_.is_none() && random_.chance(0.2)) {
            add("glWindowPos3f({:.4f}, {:.4f}, {:.4f});", random_.uniform(-4, 64), random_.uniform(-4, 64),
                random_.uniform(0, 1));
            return;
        }
        const double depth = random_.uniform(3, 8);
        // A known bug at other positions than the eye's: the modelview matrix is the identity without it.
        if (shows(compare::has_raster_position_in_eye_coordinates)) {
            add("glLoadIdentity(); glTranslatef({:.3f}, 0, {:.3f}); glRasterPos3f(0.1, 0.1, 0);",
                random_.uniform(0.3, 1), -depth);
            return;
        }
        const double reach = departure_.is_none() ? 1.1 : 0.4;
        add("glLoadIdentity(); glRasterPos3f({:.4f}, {:.4f}, {:.4f});", random_.uniform(-reach, reach) * depth,
            random_.uniform(-reach, reach) * depth, -depth);
    }

    void bitmaps() {
        const int width = departure_.is_none() ? 1 + random_.below(19) : 16, height = 1 + random_.below(12);
        unpack();
        const int row = ((row_length_ > 0 ? row_length_ : width) + 8 * alignment_ - 1) / (8 * alignment_) * alignment_;
        add("GLubyte bits[] = {{{}}};", bytes(row * (height + skip_rows_) + (skip_pixels_ + 7) / 8, 0));
        const int count = 1 + random_.below(4);
        for (int i = 0; i < count; ++i)
            add("glBitmap({}, {}, {:.2f}, {:.2f}, {:.2f}, {:.2f}, bits);", width, height, random_.uniform(-3, 6),
                random_.uniform(-3, 6), random_.uniform(-4, 14), random_.uniform(-3, 3));
        add("glPixelStorei(GL_UNPACK_LSB_FIRST, 0); glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0); "
            "glPixelStorei(GL_UNPACK_SKIP_ROWS, 0); glPixelStorei(GL_UNPACK_ROW_LENGTH, 0); "
            "glPixelStorei(GL_UNPACK_ALIGNMENT, 4);");
    }

    void unpack() {
        if (random_.chance(0.3)) alignment_ = 1 << random_.below(4);
        if (random_.chance(0.2)) skip_pixels_ = random_.below(9);
        if (random_.chance(0.2)) skip_rows_ = random_.below(3);
        if (random_.chance(0.2)) row_length_ = 20 + random_.below(9);
        add("glPixelStorei(GL_UNPACK_LSB_FIRST, {}); glPixelStorei(GL_UNPACK_SKIP_PIXELS, {}); "
            "glPixelStorei(GL_UNPACK_SKIP_ROWS, {}); glPixelStorei(GL_UNPACK_ROW_LENGTH, {}); "
            "glPixelStorei(GL_UNPACK_ALIGNMENT, {});",
            random_.below(2), skip_pixels_, skip_rows_, row_length_, alignment_);
    }

    std::string bytes(int count, int low) {
        std::string text;
        for (int i = 0; i < count; ++i) text += fmt::format("{}{}", i > 0 ? "," : "", low + random_.below(256 - low));
        return text;
    }

    void rectangle() {
        struct Format {
            const char* name;
            int components;
        };
        const Format formats[] = {{"GL_RGB", 3},  {"GL_RGBA", 4},      {"GL_BGR", 3},
                                  {"GL_BGRA", 4}, {"GL_LUMINANCE", 1}, {"GL_LUMINANCE_ALPHA", 2},
                                  {"GL_RED", 1},  {"GL_ALPHA", 1}};
        const Format& format = formats[random_.below(8)];
        const int width = 1 + random_.below(7), height = 1 + random_.below(5);
        // Whole numbers: see "glPixelZoom from a position between pixels".
        const bool is_mirrored = shows(compare::mirrors_stenciled_pixels) || random_.below(4) == 0;
        add("glPixelZoom({}, {});", is_mirrored ? -2 : 1 + random_.below(4), 1 + random_.below(4));
        if (shows(compare::mirrors_stenciled_pixels))
            add("glEnable(GL_STENCIL_TEST); glStencilFuncSeparate(GL_FRONT, GL_ALWAYS, 0, 255); "
                "glStencilFuncSeparate(GL_BACK, GL_NEVER, 0, 255);");
        const bool transfers = departure_.is_none() && random_.chance(0.3);
        if (transfers)
            add("glPixelTransferf(GL_RED_SCALE, {:.3f}); glPixelTransferf(GL_ALPHA_BIAS, {:.3f});",
                random_.uniform(0, 2), random_.uniform(-0.5, 0.5));
        if (shows(compare::maps_drawn_pixels)) {
            add("glPixelTransferi(GL_MAP_COLOR, 1);");
            for (const char channel : std::string_view("RGBA"))
                add("glPixelMapfv(GL_PIXEL_MAP_{0}_TO_{0}, 3, (GLfloat[]){{{1}}});", channel, numbers(3, 0, 1));
        }
        const int values = width * height * format.components;
        if (random_.chance(0.3))
            add("glDrawPixels({}, {}, {}, GL_FLOAT, (GLfloat[]){{{}}});", width, height, format.name,
                numbers(values, -0.2, 1.2));
        else
            add("glPixelStorei(GL_UNPACK_ALIGNMENT, 1); glDrawPixels({}, {}, {}, GL_UNSIGNED_BYTE, (GLubyte[]){{{}}}); "
                "glPixelStorei(GL_UNPACK_ALIGNMENT, 4);",
                width, height, format.name, bytes(values, 0));
        // Twinlight does not draw copies that are transferred.
        if (transfers) add("glPixelTransferf(GL_RED_SCALE, 1); glPixelTransferf(GL_ALPHA_BIAS, 0);");
    }

    Random& random_;
    ShownBug departure_;
    int alignment_ = 4, skip_pixels_ = 0, skip_rows_ = 0, row_length_ = 0;
    std::string text_;
};

}  // namespace

bool is_of_labels(const ShownBug& departure) { return is_of_raster_position(departure) || is_of_rectangles(departure); }

std::string label(Random& random, const ShownBug& departure) { return Label(random, departure).text(); }

}  // namespace twinlight::fuzz
