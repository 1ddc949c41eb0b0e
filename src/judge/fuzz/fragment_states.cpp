// Random scenes for everything between vertices and pixels: rasterisation, textures, fog, blending, tests.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "judge/fuzz/random_states.h"
#include "scene/command/text.h"

namespace twinlight::fuzz {

namespace {

class Builder {
  public:
    explicit Builder(const Seed& seed)
        : structure_(seed.structure),
          generated_(~seed.structure),
          random_(seed.values),
          levels_(seed.structure + 1),
          units_(seed.structure + 2),
          unit_values_(~seed.values),
          fragments_(~seed.values),
          more_(seed.structure + 3),
          more_values_(~seed.values + 1),
          stipples_(seed.structure + 4),
          copies_(seed.structure + 5),
          cubes_(seed.structure + 6),
          points_(seed.structure + 7),
          anisotropy_(seed.structure + 8),
          labels_(~seed.values + 2),
          pixel_copies_(~seed.values + 3),
          stencil_pixels_(~seed.values + 4),
          depths_(seed.structure + 9),
          volumes_(seed.structure + 10),
          objects_(seed.structure + 11),
          departure_(departure_of(seed, structure_)) {}

    std::string build() {
        clear("GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT");
        const bool has_stencil = of_stencil() || (departure_.is_none() && structure_.chance(0.25));
        const bool accumulates = departure_.is_none() && structure_.chance(0.15);
        if (has_stencil) add("glClearStencil({}); glClear(GL_STENCIL_BUFFER_BIT);", random_.below(300) - 20);
        if (accumulates) add("glClearAccum({}); glClear(GL_ACCUM_BUFFER_BIT);", four(-0.2, 0.2));
        const char* const parallel = "glLoadIdentity(); glScalef(0.12, 0.12, 1); glOrtho(-1, 1, -1, 1, 0, 10)";
        add("glMatrixMode(GL_PROJECTION); {};",
            shows(compare::stipples_listed_strips)
                ? parallel
                : one_of({"glFrustum(-1, 1, -1, 1, 1, 10)", "glFrustum(-1, 1, -1, 1, 1, 10)",
                          "gluPerspective(90, 1, 1, 10)", parallel}));
        const bool of_textures = shows(compare::clamps_between_nearest_and_linear) ||
                                 shows(compare::mixes_tex_coords) || shows(compare::biases_level_of_points) ||
                                 shows(compare::generates_mipmaps_after_pop) ||
                                 shows(compare::draws_others_beside_sprites);
        if (of_textures || (structure_.chance(0.7) && !shows(compare::adds_secondary_color_in_fog))) texture();
        if (shows(compare::wraps_cube_maps) || (departure_.is_none() && cubes_.chance(0.1))) cube_map();
        if (departure_.is_none() && volumes_.chance(0.1)) volume();
        if (departure_.is_none() && units_.chance(0.25)) further_units();
        secondary_ = departure_.is_none() && more_.chance(0.12);
        if (secondary_) add("glEnable(GL_COLOR_SUM);");
        add("glMatrixMode(GL_MODELVIEW);");
        if (shows(compare::adds_secondary_color_in_fog) || shows(compare::has_w_in_fog) || reaches_behind() ||
            shows(compare::has_negative_fog_coords) || structure_.chance(0.4))
            fog();
        raster();
        if (departure_.is_none() || of_points()) points();
        lit_ = shows(compare::adds_secondary_color_in_fog) || shows(compare::shows_cut_of_rectangles) ||
               structure_.chance(0.4);
        if (lit_) lighting();
        if (structure_.chance(0.6)) fragment_operations();
        if (has_stencil) stencil();
        std::string first = batch();
        if (departure_.is_none() && structure_.chance(0.3) && !sprites_) first = solid();
        if (shows(compare::shades_evaluated_meshes_flat) ||
            (departure_.is_none() && generated_.chance(0.1) && !sprites_))
            first = evaluated();
        text_ += first;
        if (has_stencil) {  // a pass that shows what the first left in the stencil buffer
            stencil();
            text_ += structure_.chance(0.5) || sprites_ ? batch() : whole_window();
        }
        if (accumulates) accumulate();
        // A second pass, over the same vertices (as in multi-pass effects) or over others.
        if (structure_.chance(0.3)) {
            if (structure_.chance(0.2)) clear(structure_.chance(0.5) ? "GL_COLOR_BUFFER_BIT" : "GL_DEPTH_BUFFER_BIT");
            if (structure_.chance(0.5)) add("glDisable(GL_TEXTURE_2D); glDisable(GL_TEXTURE_1D);");
            raster();
            fragment_operations();
            text_ += structure_.chance(0.5) ? first : batch();
        }
        if (accumulates) add("glAccum(GL_RETURN, {:.4f});", random_.uniform(0.5, 1));
        if (departure_.is_none() && copies_.chance(0.1))
            for (int i = 1 + copies_.below(2); i > 0; --i) copied();
        if (is_of_labels(departure_) || (departure_.is_none() && labels_.chance(0.1)))
            text_ += label(labels_, departure_);
        if (is_of_pixel_copies(departure_) || (departure_.is_none() && pixel_copies_.chance(0.05)))
            text_ += pixel_copy(pixel_copies_, departure_);
        if (is_of_stencil_pixels(departure_) || (departure_.is_none() && stencil_pixels_.chance(0.05)))
            text_ += stencil_pixels(stencil_pixels_, departure_);
        if (shows(compare::compares_depths_in_one_dimension) || shows(compare::copies_depths_after_mode) ||
            (departure_.is_none() && depths_.chance(0.1)))
            depths();
        if (shows(compare::sets_color_before_pop))
            add("glDisable(GL_LIGHTING); glDisable(GL_TEXTURE_2D); glDisable(GL_DEPTH_TEST); glDisable(GL_CULL_FACE); "
                "glDisable(GL_BLEND); glColor4f(1, 1, 1, 1); glPushAttrib(GL_CURRENT_BIT); "
                "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 1, 0, 1}); glColor4f(0, 0.8, 0.5, 1); glPopAttrib(); "
                "glBegin(GL_TRIANGLES); glVertex3f(-30, -30, -5); glVertex3f(30, -30, -5); glVertex3f(0, 40, -5); "
                "glEnd();");
        if (shows(compare::stipples_after_framebuffer) || shows(compare::makes_mipmaps_before_object_draws) ||
            (departure_.is_none() && objects_.chance(0.1)))
            object();
        if (has_quadric_) add("gluDeleteQuadric(quadric);");
        return std::move(text_);
    }

  private:
    template <class Rule>
    bool shows(Rule* rule) const {
        return departure_.is(rule);
    }
    void add(std::string_view line) { text_ += fmt::format("{}\n", line); }
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        text_ += fmt::format(format, std::forward<Arguments>(arguments)...) + '\n';
    }
    template <std::size_t n>
    const char* one_of(const char* const (&choices)[n]) {
        return choices[structure_.below(static_cast<int>(n))];
    }
    std::string four(double low = 0, double high = 1) {
        return fmt::format("{:.6f}, {:.6f}, {:.6f}, {:.6f}", random_.uniform(low, high), random_.uniform(low, high),
                           random_.uniform(low, high), random_.uniform(low, high));
    }
    std::string vector(double low = 0, double high = 1) { return fmt::format("(GLfloat[]){{{}}}", four(low, high)); }

    void clear(const char* buffers) { add("glClearColor({}); glClear({});", four(), buffers); }

    // With numbers of its own, so that the rest of the scene does not depend on it.
    void levels_in_use(const std::string& target, bool has_all) {
        if (departure_.is_none() && anisotropy_.chance(0.05))
            add("glTexParameterf({}, GL_TEXTURE_MAX_ANISOTROPY_EXT, {:.2f});", target, anisotropy_.uniform(1, 16));
        if (!shows(compare::biases_level_of_points) && levels_.chance(0.15))
            add("glTexParameterf({}, GL_TEXTURE_LOD_BIAS, {:.3f});", target, levels_.uniform(-2, 2));
        if (levels_.chance(0.1))
            add("glTexParameterf({0}, GL_TEXTURE_MIN_LOD, {1:.3f}); glTexParameterf({0}, GL_TEXTURE_MAX_LOD, {2:.3f});",
                target, levels_.uniform(-1, 1.5), levels_.uniform(1, 4));
        if (has_all && levels_.chance(0.1))
            add("glTexParameteri({}, GL_TEXTURE_MAX_LEVEL, {});", target, levels_.below(4));
        if (has_all && levels_.chance(0.1))
            add("glTexParameteri({}, GL_TEXTURE_BASE_LEVEL, {});", target, levels_.below(3));
    }

    // Random texels at every level, so that a wrong level shows.
    void texture() {
        const bool flat = structure_.chance(0.15);
        const std::string target = flat ? "GL_TEXTURE_1D" : "GL_TEXTURE_2D";
        const char* format =
            one_of({"GL_ALPHA", "GL_LUMINANCE", "GL_LUMINANCE_ALPHA", "GL_INTENSITY", "GL_RGB", "GL_RGBA", "GL_RGBA"});
        const std::string min =
            shows(compare::generates_mipmaps_after_pop)
                ? "GL_LINEAR_MIPMAP_LINEAR"
                : one_of({"GL_NEAREST", "GL_LINEAR", "GL_NEAREST_MIPMAP_NEAREST", "GL_LINEAR_MIPMAP_NEAREST",
                          "GL_NEAREST_MIPMAP_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"});
        int width = 1 << structure_.below(6), height = flat ? 1 : 1 << structure_.below(6);
        const bool generates = shows(compare::generates_mipmaps_after_pop);
        if (generates)
            add("glPushAttrib(GL_TEXTURE_BIT); glTexParameteri({}, GL_GENERATE_MIPMAP, GL_TRUE); glPopAttrib();",
                target);
        std::string base;  // comes last where levels are generated, which overwrites the others
        for (int level = 0;; ++level) {
            std::string texels;
            for (int i = 0; i < width * height * 4; ++i)
                texels += fmt::format("{}{}", i ? "," : "", random_.below(256));
            add("GLubyte level{}[] = {{{}}};", level, texels);
            const std::string image = fmt::format(
                "glTexImage{}({}, {}, {}, {}{}, 0, GL_RGBA, GL_UNSIGNED_BYTE, level{});", flat ? "1D" : "2D", target,
                level, format, width, flat ? "" : fmt::format(", {}", height), level);
            if (generates && level == 0)
                base = image;
            else
                add(image);
            if (min.find("MIPMAP") == std::string::npos || (width == 1 && height == 1)) break;
            width = std::max(1, width / 2);
            height = std::max(1, height / 2);
        }
        add(base);
        // With two filters of the same kind GL_CLAMP is not skipped as a known bug.
        const bool nearest = min.starts_with("GL_NEAREST");
        const bool mixed = shows(compare::clamps_between_nearest_and_linear) || structure_.chance(0.2);
        add("glTexParameteri({}, GL_TEXTURE_MIN_FILTER, {});", target, min);
        add("glTexParameteri({}, GL_TEXTURE_MAG_FILTER, {});", target, nearest != mixed ? "GL_NEAREST" : "GL_LINEAR");
        for (const char* axis : {"S", "T"})
            add("glTexParameteri({}, GL_TEXTURE_WRAP_{}, {});", target, axis,
                shows(compare::clamps_between_nearest_and_linear)
                    ? "GL_CLAMP"
                    : one_of({"GL_REPEAT", "GL_REPEAT", "GL_CLAMP", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER",
                              "GL_MIRRORED_REPEAT"}));
        add("glTexParameterfv({}, GL_TEXTURE_BORDER_COLOR, {});", target, vector());
        add("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {});",
            one_of({"GL_MODULATE", "GL_MODULATE", "GL_REPLACE", "GL_DECAL", "GL_BLEND", "GL_ADD"}));
        add("glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {});", vector());
        if (shows(compare::biases_level_of_points))
            add("glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, {:.3f});", random_.uniform(1, 3));
        else if (structure_.chance(0.15))
            add("glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, {:.3f});", random_.uniform(-2, 2));
        levels_in_use(target, !generates);
        if (structure_.chance(0.2))
            add("glMatrixMode(GL_TEXTURE); glTranslatef({:.3f}, {:.3f}, 0); glRotatef({:.1f}, 0, 0, 1);",
                random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(0, 360));
        add("glEnable({});", target);
        if (departure_.is_none() && generated_.chance(0.2)) generated();
    }

    // A cube map in place of the texture of unit 0. Its numbers are its own, so that the rest of the scene does not depend on
    // them.
    void cube_map() {
        const bool repeats = shows(compare::wraps_cube_maps);
        const int size = repeats ? 4 : 1 << cubes_.below(4), filter = repeats ? 1 : cubes_.below(4);
        const char* const formats[] = {"GL_RGB", "GL_RGBA", "GL_LUMINANCE", "GL_ALPHA", "GL_INTENSITY"};
        const char* const wraps[] = {"GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_EDGE", "GL_REPEAT", "GL_MIRRORED_REPEAT"};
        const char* const filters[] = {"GL_NEAREST", "GL_LINEAR", "GL_NEAREST_MIPMAP_NEAREST",
                                       "GL_LINEAR_MIPMAP_LINEAR"};
        const char* const format = formats[cubes_.below(5)];
        add("glBindTexture(GL_TEXTURE_CUBE_MAP, 30);");
        for (int face = 0; face < 6; ++face)
            for (int level = 0, side = size; side > 0; ++level, side /= 2) {
                std::string texels;
                for (int i = 0; i < side * side * 4; ++i)
                    texels += fmt::format("{}{}", i ? "," : "", cubes_.below(256));
                add("glTexImage2D({}, {}, {}, {}, {}, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){{{}}});",
                    enum_name(kGL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<Enum>(face)), level, format, side, side,
                    texels);
            }
        add("glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, {}); "
            "glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, {});",
            filters[filter], filters[filter % 2]);
        for (const char* axis : {"S", "T"})
            add("glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_{}, {});", axis,
                repeats ? "GL_REPEAT" : wraps[cubes_.below(4)]);
        add("glMatrixMode(GL_MODELVIEW); glPushMatrix(); glLoadIdentity();");
        const int mode = cubes_.below(3);
        for (const char coordinate : std::string_view("STR")) {
            const char* const modes[] = {"GL_REFLECTION_MAP", "GL_NORMAL_MAP", "GL_EYE_LINEAR"};
            add("glTexGenfv(GL_{}, GL_EYE_PLANE, (GLfloat[]){{{:.4f}, {:.4f}, {:.4f}, {:.4f}}});", coordinate,
                cubes_.uniform(-1, 1), cubes_.uniform(-1, 1), cubes_.uniform(-1, 1), cubes_.uniform(-1, 1));
            add("glTexGeni(GL_{0}, GL_TEXTURE_GEN_MODE, {1}); glEnable(GL_TEXTURE_GEN_{0});", coordinate, modes[mode]);
        }
        add("glPopMatrix(); glDisable(GL_TEXTURE_GEN_Q);");
        if (cubes_.chance(0.3))
            add("glMatrixMode(GL_TEXTURE); glRotatef({:.1f}, 1, 2, {:.3f});", cubes_.uniform(0, 360),
                cubes_.uniform(-1, 1));
        if (cubes_.chance(0.5)) add("glEnable(GL_NORMALIZE);");
        add("glEnable(GL_TEXTURE_CUBE_MAP);");
    }

    // A texture of three dimensions in place of the texture of unit 0, with numbers of its own.
    void volume() {
        const char* const formats[] = {"GL_RGB", "GL_RGBA", "GL_LUMINANCE", "GL_ALPHA", "GL_INTENSITY"};
        const char* const wraps[] = {"GL_REPEAT", "GL_CLAMP", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER",
                                     "GL_MIRRORED_REPEAT"};
        const char* const filters[] = {"GL_NEAREST",
                                       "GL_LINEAR",
                                       "GL_NEAREST_MIPMAP_NEAREST",
                                       "GL_LINEAR_MIPMAP_NEAREST",
                                       "GL_NEAREST_MIPMAP_LINEAR",
                                       "GL_LINEAR_MIPMAP_LINEAR"};
        const int filter = volumes_.below(6);
        const char* const format = formats[volumes_.below(5)];
        const char* const target = "GL_TEXTURE_3D";
        add("glBindTexture({}, 50);", target);
        int width = 1 << volumes_.below(4), height = 1 << volumes_.below(4), depth = 1 << volumes_.below(4);
        for (int level = 0;; ++level) {
            std::string texels;
            for (int i = 0; i < width * height * depth * 4; ++i)
                texels += fmt::format("{}{}", i ? "," : "", volumes_.below(256));
            add("glTexImage3D({}, {}, {}, {}, {}, {}, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){{{}}});", target, level,
                format, width, height, depth, texels);
            if (filter < 2 || (width == 1 && height == 1 && depth == 1)) break;
            width = std::max(1, width / 2);
            height = std::max(1, height / 2);
            depth = std::max(1, depth / 2);
        }
        add("glTexParameteri({0}, GL_TEXTURE_MIN_FILTER, {1}); glTexParameteri({0}, GL_TEXTURE_MAG_FILTER, {2});",
            target, filters[filter], filters[volumes_.chance(0.8) ? filter % 2 : 1 - filter % 2]);
        for (const char* axis : {"S", "T", "R"})
            add("glTexParameteri({}, GL_TEXTURE_WRAP_{}, {});", target, axis, wraps[volumes_.below(5)]);
        add("glTexParameterfv({}, GL_TEXTURE_BORDER_COLOR, (GLfloat[]){{{:.4f}, {:.4f}, {:.4f}, {:.4f}}});", target,
            volumes_.uniform(0, 1), volumes_.uniform(0, 1), volumes_.uniform(0, 1), volumes_.uniform(0, 1));
        if (volumes_.chance(0.1))
            add("glTexParameterf({}, GL_TEXTURE_LOD_BIAS, {:.3f});", target, volumes_.uniform(-2, 2));
        for (const char coordinate : std::string_view("STR")) {
            if (volumes_.chance(0.3)) continue;
            add("glTexGenfv(GL_{}, GL_OBJECT_PLANE, (GLfloat[]){{{:.4f}, {:.4f}, {:.4f}, {:.4f}}});", coordinate,
                volumes_.uniform(-2, 2), volumes_.uniform(-2, 2), volumes_.uniform(-2, 2), volumes_.uniform(-1, 1));
            add("glTexGeni(GL_{0}, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR); glEnable(GL_TEXTURE_GEN_{0});", coordinate);
        }
        if (volumes_.chance(0.3))
            add("glMatrixMode(GL_TEXTURE); glRotatef({:.1f}, 1, 2, {:.3f}); glScalef(1, 1, {:.3f});",
                volumes_.uniform(0, 360), volumes_.uniform(-1, 1), volumes_.uniform(-3, 3));
        add("glEnable({});", target);
    }

    // One to three texture units above unit 0, which may have no texture.
    void further_units() {
        const int count = 1 + units_.below(3);
        for (int unit = 1; unit <= count; ++unit) further_units_.push_back(unit + units_.below(2) * (unit == count));
        if (units_.chance(0.3)) combine(0);
        for (const int unit : further_units_) {
            add("glActiveTexture(GL_TEXTURE{0}); glBindTexture(GL_TEXTURE_2D, {1});", unit, 10 + unit);
            const int width = 1 << units_.below(4), height = 1 << units_.below(4);
            std::string texels;
            for (int i = 0; i < width * height * 4; ++i)
                texels += fmt::format("{}{}", i ? "," : "", unit_values_.below(256));
            add("GLubyte image{}[] = {{{}}};", unit, texels);
            const char* const formats[] = {"GL_ALPHA", "GL_LUMINANCE", "GL_LUMINANCE_ALPHA", "GL_INTENSITY", "GL_RGB",
                                           "GL_RGBA",  "GL_RGBA"};
            add("glTexImage2D(GL_TEXTURE_2D, 0, {}, {}, {}, 0, GL_RGBA, GL_UNSIGNED_BYTE, image{});",
                formats[units_.below(7)], width, height, unit);
            const char* filter = units_.chance(0.4) ? "GL_NEAREST" : "GL_LINEAR";
            add("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, {0}); "
                "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, {0});",
                filter);
            const char* const wraps[] = {"GL_REPEAT", "GL_CLAMP", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER"};
            add("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, {});", wraps[units_.below(4)]);
            if (units_.chance(0.5)) {
                combine(unit);
            } else {
                const char* const modes[] = {"GL_MODULATE", "GL_REPLACE", "GL_DECAL", "GL_BLEND", "GL_ADD"};
                add("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {});", modes[units_.below(5)]);
            }
            add("glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (GLfloat[]){{{:.4f}, {:.4f}, {:.4f}, {:.4f}}});",
                unit_values_.uniform(0, 1), unit_values_.uniform(0, 1), unit_values_.uniform(0, 1),
                unit_values_.uniform(0, 1));
            if (units_.chance(0.2))
                add("glMatrixMode(GL_TEXTURE); glRotatef({:.1f}, 0, 0, 1); glScalef({:.3f}, 1, 1);",
                    unit_values_.uniform(0, 360), unit_values_.uniform(0.5, 2));
            if (units_.chance(0.2))
                add("glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, {}); glEnable(GL_TEXTURE_GEN_S);",
                    units_.chance(0.5) ? "GL_OBJECT_LINEAR" : "GL_EYE_LINEAR");
            add("glEnable(GL_TEXTURE_2D);");
        }
        add("glActiveTexture(GL_TEXTURE0);");
    }

    // A texture of the picture so far, on further primitives. It comes last, so that the rest of the scene does not depend
    // on its numbers.
    void copied() {
        const char* const formats[] = {"GL_RGB", "GL_RGB", "GL_RGBA", "GL_LUMINANCE", "GL_INTENSITY", "GL_ALPHA"};
        const char* const filters[] = {"GL_NEAREST", "GL_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"};
        const int filter = copies_.below(3), width = 4 + copies_.below(40), height = 4 + copies_.below(40);
        const int x = copies_.below(64 - width), y = copies_.below(64 - height);
        add("glDisable(GL_TEXTURE_1D); glDisable(GL_TEXTURE_3D); glEnable(GL_TEXTURE_2D); glBindTexture(GL_TEXTURE_2D, "
            "20);");
        add("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, {}); "
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, {});",
            filters[filter], filters[std::min(filter, 1)]);
        if (filter == 2) add("glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);");
        add("glCopyTexImage2D(GL_TEXTURE_2D, 0, {}, {}, {}, {}, {}, 0);", formats[copies_.below(6)], x, y, width,
            height);
        if (copies_.chance(0.3)) {
            text_ += batch();
            add("glCopyTexSubImage2D(GL_TEXTURE_2D, 0, {}, {}, {}, {}, {}, {});", copies_.below(width / 2),
                copies_.below(height / 2), copies_.below(32), copies_.below(32), 1 + copies_.below(width / 2),
                1 + copies_.below(height / 2));
        }
        text_ += batch();
    }

    // A texture of random depths or of those of the picture so far, on further primitives; last, as copied().
    void depths() {
        const char* const formats[] = {"GL_DEPTH_COMPONENT", "GL_DEPTH_COMPONENT24", "GL_DEPTH_COMPONENT16",
                                       "GL_DEPTH_COMPONENT32"};
        const char* const filters[] = {"GL_NEAREST", "GL_LINEAR", "GL_LINEAR_MIPMAP_LINEAR",
                                       "GL_NEAREST_MIPMAP_NEAREST"};
        const char* const wraps[] = {"GL_REPEAT", "GL_CLAMP", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER"};
        const char* const modes[] = {"GL_LUMINANCE", "GL_INTENSITY", "GL_ALPHA"};
        const char* const functions[] = {"GL_LEQUAL", "GL_GEQUAL",   "GL_LESS",   "GL_GREATER",
                                         "GL_EQUAL",  "GL_NOTEQUAL", "GL_ALWAYS", "GL_NEVER"};
        const bool flat = shows(compare::compares_depths_in_one_dimension);
        const char* const target = flat ? "GL_TEXTURE_1D" : "GL_TEXTURE_2D";
        const int filter = depths_.below(4), width = 1 + depths_.below(8), height = 1 + depths_.below(8);
        add("glDisable(GL_TEXTURE_1D); glDisable(GL_TEXTURE_2D); glDisable(GL_TEXTURE_3D); "
            "glDisable(GL_TEXTURE_CUBE_MAP); "
            "glEnable({0}); glBindTexture({0}, 40);",
            target);
        add("glTexParameteri({0}, GL_TEXTURE_MIN_FILTER, {1}); glTexParameteri({0}, GL_TEXTURE_MAG_FILTER, {2});",
            target, filters[filter], filters[filter % 3 == 0 ? 0 : 1]);
        if (filter > 1) add("glTexParameteri({}, GL_GENERATE_MIPMAP, GL_TRUE);", target);
        for (const char* axis : {"S", "T"})
            add("glTexParameteri({}, GL_TEXTURE_WRAP_{}, {});", target, axis, wraps[depths_.below(4)]);
        add("glTexParameterfv({}, GL_TEXTURE_BORDER_COLOR, (GLfloat[]){{{:.4f}, 1, 0, 0}});", target,
            depths_.uniform(0, 1));
        const int mode = depths_.below(3);
        add("glTexParameteri({}, GL_DEPTH_TEXTURE_MODE, {});", target,
            modes[shows(compare::copies_depths_after_mode) ? 2 : mode]);
        if (flat || depths_.chance(0.8))
            add("glTexParameteri({0}, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE); "
                "glTexParameteri({0}, GL_TEXTURE_COMPARE_FUNC, {1});",
                target, functions[depths_.below(8)]);
        const char* const format = formats[depths_.below(4)];
        if (flat) {
            add("glTexImage1D(GL_TEXTURE_1D, 0, {}, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){{{:.4f}, "
                "{:.4f}}});",
                format, depths_.uniform(0, 1), depths_.uniform(0, 1));
        } else if (depths_.chance(0.5) || shows(compare::copies_depths_after_mode)) {
            add("glEnable(GL_DEPTH_TEST); glDepthMask(GL_TRUE);");
            text_ += batch();
            const int side = 8 + depths_.below(40);
            add("glCopyTexImage2D(GL_TEXTURE_2D, 0, {}, {}, {}, {}, {}, 0);", format, depths_.below(64 - side),
                depths_.below(64 - side), side, side);
            if (depths_.chance(0.5)) clear("GL_DEPTH_BUFFER_BIT");
        } else {
            std::string texels;
            for (int i = 0; i < width * height; ++i)
                texels += fmt::format("{}{:.4f}", i ? "," : "", depths_.uniform(-0.1, 1.1));
            add("glTexImage2D(GL_TEXTURE_2D, 0, {}, {}, {}, 0, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){{{}}});",
                format, width, height, texels);
        }
        add("glMatrixMode(GL_MODELVIEW); glPushMatrix(); glLoadIdentity();");
        add("glTexGenfv(GL_R, GL_EYE_PLANE, (GLfloat[]){{{:.4f}, {:.4f}, {:.4f}, {:.4f}}});",
            depths_.uniform(-0.2, 0.2), depths_.uniform(-0.2, 0.2), depths_.uniform(-0.2, 0.05),
            depths_.uniform(-0.2, 0.4));
        add("glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR); glEnable(GL_TEXTURE_GEN_R); glPopMatrix();");
        if (shows(compare::copies_depths_after_mode))
            add("glDisable(GL_DEPTH_TEST); glDisable(GL_BLEND); glDisable(GL_ALPHA_TEST); glDisable(GL_CULL_FACE); "
                "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);");
        text_ += shows(compare::copies_depths_after_mode) ? whole_window() : batch();
    }

    // A picture in a texture, by a framebuffer object, on further primitives; last, as copied().
    void object() {
        if (shows(compare::stipples_after_framebuffer))
            add("glPolygonStipple((GLubyte[128]){255, 255, 255, 255}); glEnable(GL_POLYGON_STIPPLE); "
                "glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);");
        const char* const formats[] = {"GL_RGB", "GL_RGBA", "GL_RGB8", "GL_RGBA8"};
        const char* const filters[] = {"GL_NEAREST", "GL_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"};
        const int filter = objects_.below(3), width = 1 + objects_.below(100), height = 1 + objects_.below(100);
        const int depths = objects_.below(3);  // none, depths, depths and stencil
        add("glBindTexture(GL_TEXTURE_2D, 60);");
        add("glTexImage2D(GL_TEXTURE_2D, 0, {}, {}, {}, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);",
            formats[objects_.below(4)], width, height);
        add("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, {}); "
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, {});",
            filters[filter], filters[std::min(filter, 1)]);
        add("glBindFramebuffer(GL_FRAMEBUFFER, 1);");
        add("glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 60, 0);");
        if (shows(compare::makes_mipmaps_before_object_draws)) add("glGenerateMipmap(GL_TEXTURE_2D);");
        if (depths > 0) {
            add("glBindRenderbuffer(GL_RENDERBUFFER, 1);");
            add("glRenderbufferStorage(GL_RENDERBUFFER, {}, {}, {});",
                depths == 1 ? "GL_DEPTH_COMPONENT24" : "GL_DEPTH24_STENCIL8", width, height);
            add("glFramebufferRenderbuffer(GL_FRAMEBUFFER, {}, GL_RENDERBUFFER, 1);",
                depths == 1 ? "GL_DEPTH_ATTACHMENT" : "GL_DEPTH_STENCIL_ATTACHMENT");
        }
        add("glDisable(GL_SCISSOR_TEST); glColorMask(1, 1, 1, 1); glDepthMask(1); glStencilMask(255);");
        add("glPushAttrib(GL_VIEWPORT_BIT); glViewport(0, 0, {}, {}); glClearDepth(1);", width, height);
        clear("GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT");
        const auto draw = [&] {
            add("glBindTexture(GL_TEXTURE_2D, 0);");
            text_ += batch();
        };
        const auto show = [&] {
            add("glBindFramebuffer(GL_FRAMEBUFFER, 0); glPopAttrib();");
            add("glDisable(GL_TEXTURE_1D); glDisable(GL_TEXTURE_3D); glDisable(GL_TEXTURE_CUBE_MAP); "
                "glEnable(GL_TEXTURE_2D); glBindTexture(GL_TEXTURE_2D, 60);");
            if (filter == 2) add("glGenerateMipmap(GL_TEXTURE_2D);");
            text_ += batch();
        };
        draw();
        show();
        if (!objects_.chance(0.3)) return;
        add("glBindFramebuffer(GL_FRAMEBUFFER, 1);");
        add("glPushAttrib(GL_VIEWPORT_BIT); glViewport({}, {}, {}, {});", objects_.below(20) - 10,
            objects_.below(20) - 10, 1 + objects_.below(width), 1 + objects_.below(height));
        draw();
        show();
    }

    // GL_COMBINE of the active unit. It reads no unit that may lack a texture.
    void combine(int unit) {
        add("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);");
        const char* const functions[] = {"GL_REPLACE",     "GL_MODULATE", "GL_ADD",      "GL_ADD_SIGNED",
                                         "GL_INTERPOLATE", "GL_SUBTRACT", "GL_DOT3_RGB", "GL_DOT3_RGBA"};
        add("glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, {});", functions[units_.below(8)]);
        add("glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, {});", functions[units_.below(6)]);
        for (const std::string channel : {"RGB", "ALPHA"}) {
            for (int i = 0; i < 3; ++i) {
                const char* const sources[] = {"GL_TEXTURE", "GL_PREVIOUS", "GL_CONSTANT", "GL_PRIMARY_COLOR"};
                std::string source = sources[units_.below(4)];
                if (unit > 0 && units_.chance(0.25))
                    source = fmt::format("GL_TEXTURE{}", further_units_[static_cast<std::size_t>(
                                                             units_.below(static_cast<int>(further_units_.size())))]);
                add("glTexEnvi(GL_TEXTURE_ENV, GL_SRC{}_{}, {});", i, channel, source);
                const char* const operands[] = {"GL_SRC_ALPHA", "GL_ONE_MINUS_SRC_ALPHA", "GL_SRC_COLOR",
                                                "GL_ONE_MINUS_SRC_COLOR"};
                add("glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND{}_{}, {});", i, channel,
                    operands[units_.below(channel == "RGB" ? 4 : 2)]);
            }
            if (units_.chance(0.3)) add("glTexEnvi(GL_TEXTURE_ENV, GL_{}_SCALE, {});", channel, 1 << units_.below(3));
        }
    }

    // Texture coordinates that GL generates. The eye planes depend on the modelview matrix.
    void generated() {
        add("glMatrixMode(GL_MODELVIEW); glPushMatrix(); glTranslatef({0:.3f}, 0, -3); glRotatef({1:.1f}, {0:.3f}, 1, "
            "0);",
            generated_.uniform(-1, 1), generated_.uniform(-90, 90));
        for (const char coordinate : std::string_view("STRQ")) {
            if (generated_.chance(coordinate == 'Q' ? 0.8 : 0.15)) continue;
            const char* const modes[] = {"GL_OBJECT_LINEAR", "GL_EYE_LINEAR", "GL_REFLECTION_MAP", "GL_NORMAL_MAP",
                                         "GL_SPHERE_MAP"};
            const int most = coordinate == 'Q' ? 2 : coordinate == 'R' ? 4 : 5;
            add("glTexGeni(GL_{0}, GL_TEXTURE_GEN_MODE, {1}); glEnable(GL_TEXTURE_GEN_{0});", coordinate,
                modes[generated_.below(most)]);
            for (const char* plane : {"GL_OBJECT_PLANE", "GL_EYE_PLANE"})
                add("glTexGenfv(GL_{}, {}, (GLfloat[]){{{:.4f}, {:.4f}, {:.4f}, {:.4f}}});", coordinate, plane,
                    coordinate == 'Q' ? 0 : generated_.uniform(-0.6, 0.6),
                    coordinate == 'Q' ? 0 : generated_.uniform(-0.6, 0.6),
                    coordinate == 'Q' ? 0 : generated_.uniform(-0.3, 0.3), generated_.uniform(0.5, 1.5));
        }
        if (generated_.chance(0.3)) add("glEnable({});", generated_.chance(0.5) ? "GL_NORMALIZE" : "GL_RESCALE_NORMAL");
        add("glPopMatrix();");
        if (generated_.chance(0.3))
            add("glMatrixMode(GL_TEXTURE); glScalef({:.3f}, {:.3f}, 1); glRotatef(30, {:.3f}, 1, 0); "
                "glMatrixMode(GL_MODELVIEW);",
                generated_.uniform(0.5, 2), generated_.uniform(0.5, 2), generated_.uniform(-1, 1));
    }

    bool reaches_behind() const { return shows(compare::has_exponential_fog_behind_the_eye); }

    void fog() {
        add("glEnable(GL_FOG); glFogi(GL_FOG_MODE, {});", reaches_behind() || shows(compare::has_negative_fog_coords)
                                                              ? "GL_EXP"
                                                              : one_of({"GL_LINEAR", "GL_EXP", "GL_EXP2"}));
        add("glFogf(GL_FOG_DENSITY, {:.4f}); glFogfv(GL_FOG_COLOR, {});", random_.uniform(0, 0.3), vector());
        add("glFogf(GL_FOG_START, {:.3f}); glFogf(GL_FOG_END, {:.3f});", random_.uniform(1, 6), random_.uniform(6, 12));
        fog_coords_ = shows(compare::has_negative_fog_coords) || (departure_.is_none() && more_.chance(0.3));
        if (fog_coords_) add("glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);");
    }

    void fragment_operations() {
        if (structure_.chance(0.5)) blending();
        if (departure_.is_none()) {
            if (fragments_.chance(0.05)) logic_op();
            if (fragments_.chance(0.05)) polygon_stipple();
            if (fragments_.chance(0.1)) add("glEnable(GL_LINE_SMOOTH);");
            if (fragments_.chance(0.02)) add("glEnable(GL_POINT_SMOOTH);");
            if (stipples_.chance(0.15)) line_stipple();
        }
        if (structure_.chance(0.3))
            add("glEnable(GL_ALPHA_TEST); glAlphaFunc({}, {:.4f});",
                one_of({"GL_LESS", "GL_LEQUAL", "GL_GREATER", "GL_GEQUAL", "GL_NOTEQUAL", "GL_EQUAL"}),
                random_.uniform(0, 1));
        if (structure_.chance(0.2))
            add("glEnable(GL_SCISSOR_TEST); glScissor({}, {}, {}, {});", random_.below(20), random_.below(20),
                random_.below(60), random_.below(60));
        if (structure_.chance(0.15))
            add("glColorMask({}, {}, {}, {});", structure_.below(2), structure_.below(2), structure_.below(2),
                structure_.below(2));
    }

    bool of_stencil() const { return shows(compare::has_faces_in_stencil_of_borders); }

    // For both faces, or for each.
    void stencil() {
        add("glEnable(GL_STENCIL_TEST);");
        if (of_stencil())
            return add(
                "glStencilFuncSeparate(GL_BACK, GL_NEVER, 0, 255); glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);"
                "glDisable(GL_CULL_FACE); glLineWidth(9);");
        const bool separate = structure_.chance(0.4);
        for (const char* face : {"GL_FRONT", "GL_BACK"}) {
            const std::string names_face = separate ? fmt::format("{}, ", face) : "";
            const char* suffix = separate ? "Separate" : "";
            const auto mask = [&] { return structure_.chance(0.7) ? 255 : random_.below(256); };
            add("glStencilFunc{}({}{}, {}, {});", suffix, names_face,
                one_of({"GL_ALWAYS", "GL_ALWAYS", "GL_EQUAL", "GL_NOTEQUAL", "GL_LESS", "GL_LEQUAL", "GL_GREATER",
                        "GL_GEQUAL", "GL_NEVER"}),
                random_.below(4), mask());
            const auto operation = [&] {
                return one_of({"GL_KEEP", "GL_KEEP", "GL_REPLACE", "GL_INCR", "GL_DECR", "GL_INCR_WRAP", "GL_DECR_WRAP",
                               "GL_INVERT", "GL_ZERO"});
            };
            add("glStencilOp{}({}{}, {}, {});", suffix, names_face, operation(), operation(), operation());
            add("glStencilMask{}({}{});", suffix, names_face, mask());
            if (!separate) break;
        }
    }

    std::string whole_window() {
        return "glPushMatrix(); glLoadIdentity(); glDisable(GL_CULL_FACE);\n" + attributes(true, false) +
               "glBegin(GL_TRIANGLES); glVertex3f(-30, -30, -5); glVertex3f(30, -30, -5); glVertex3f(0, 40, -5); "
               "glEnd(); glPopMatrix();\n";
    }

    // Sums whose terms stay within [-1, 1].
    void accumulate() {
        add("glAccum(GL_ACCUM, {:.4f});", random_.uniform(0, 0.5));
        if (structure_.chance(0.3)) add("glAccum(GL_MULT, {:.4f});", random_.uniform(0, 1));
        if (structure_.chance(0.3)) add("glAccum(GL_ADD, {:.4f});", random_.uniform(-0.1, 0.1));
        if (structure_.chance(0.3)) add("glAccum(GL_LOAD, {:.4f});", random_.uniform(0.3, 0.5));
        text_ += batch();
        add("glAccum(GL_ACCUM, {:.4f});", random_.uniform(0, 0.4));
    }

    // With numbers of their own, so that the rest of the scene does not depend on them.
    void logic_op() {
        constexpr const char* kOps[] = {"GL_CLEAR",         "GL_AND",         "GL_AND_REVERSE", "GL_COPY",
                                        "GL_AND_INVERTED",  "GL_NOOP",        "GL_XOR",         "GL_OR",
                                        "GL_NOR",           "GL_EQUIV",       "GL_INVERT",      "GL_OR_REVERSE",
                                        "GL_COPY_INVERTED", "GL_OR_INVERTED", "GL_NAND",        "GL_SET"};
        add("glEnable(GL_COLOR_LOGIC_OP); glLogicOp({});", kOps[fragments_.below(static_cast<int>(std::size(kOps)))]);
    }

    void line_stipple() {
        add("glLineStipple({}, {}); glEnable(GL_LINE_STIPPLE);", 1 + stipples_.below(9), stipples_.below(65536));
    }

    void polygon_stipple() {
        std::string bytes;
        for (int i = 0; i < 128; ++i) bytes += fmt::format("{}{}", i == 0 ? "" : ", ", fragments_.below(256));
        add("glPolygonStipple((GLubyte[128]){{{}}}); glEnable(GL_POLYGON_STIPPLE);", bytes);
    }

    void blending() {
        const auto factor = [&] {
            return one_of({"GL_ZERO", "GL_ONE", "GL_SRC_COLOR", "GL_ONE_MINUS_SRC_COLOR", "GL_DST_COLOR",
                           "GL_ONE_MINUS_DST_COLOR", "GL_SRC_ALPHA", "GL_ONE_MINUS_SRC_ALPHA", "GL_DST_ALPHA",
                           "GL_ONE_MINUS_DST_ALPHA", "GL_CONSTANT_COLOR", "GL_ONE_MINUS_CONSTANT_COLOR",
                           "GL_CONSTANT_ALPHA", "GL_ONE_MINUS_CONSTANT_ALPHA"});
        };
        add("glEnable(GL_BLEND); glBlendColor({});", four());
        if (structure_.chance(0.3))
            add("glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);");
        else if (structure_.chance(0.5))
            add("glBlendFunc({}, {});", structure_.chance(0.1) ? "GL_SRC_ALPHA_SATURATE" : factor(), factor());
        else
            add("glBlendFuncSeparate({}, {}, {}, {});", factor(), factor(), factor(), factor());
        const auto equation = [&] {
            return one_of({"GL_FUNC_ADD", "GL_FUNC_SUBTRACT", "GL_FUNC_REVERSE_SUBTRACT", "GL_MIN", "GL_MAX"});
        };
        if (structure_.chance(0.2)) add("glBlendEquation({});", equation());
        if (structure_.chance(0.1)) add("glBlendEquationSeparate({}, {});", equation(), equation());
    }

    void raster() {
        add("{}(GL_DEPTH_TEST);", structure_.chance(0.85) ? "glEnable" : "glDisable");
        add("glDepthFunc({}); glDepthMask({});",
            one_of({"GL_LESS", "GL_LESS", "GL_LESS", "GL_LEQUAL", "GL_LEQUAL", "GL_EQUAL", "GL_GREATER", "GL_GEQUAL",
                    "GL_NOTEQUAL", "GL_ALWAYS"}),
            structure_.chance(0.85) ? 1 : 0);
        if (structure_.chance(0.2)) add("glDepthRange({:.2f}, {:.2f});", random_.uniform(0, 1), random_.uniform(0, 1));
        if (structure_.chance(0.2))
            add("glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset({:.2f}, {:.1f});", random_.uniform(-2, 2),
                random_.uniform(-9, 9));
        for (int i = 0; i < 2; ++i)
            if (structure_.chance(0.15))
                add("glClipPlane(GL_CLIP_PLANE{0}, (GLdouble[]){{{1}}}); glEnable(GL_CLIP_PLANE{0});", i, four(-1, 1));
        if (shows(compare::has_smooth_points))
            add("glEnable(GL_POINT_SMOOTH); glPointSize({:.1f}); glEnable(GL_BLEND);"
                "glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);",
                random_.uniform(9, 30));
        if (shows(compare::draws_borders_of_clipped_polygons)) add("glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);");
        if (shows(compare::has_edge_flags_in_strip)) add("glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);");
        if (shows(compare::clips_under_singular_projection))
            add("glMatrixMode(GL_PROJECTION); glLoadIdentity(); glScalef(0.1, 0.1, 0); glMatrixMode(GL_MODELVIEW); "
                "glDisable(GL_DEPTH_TEST); glClipPlane(GL_CLIP_PLANE0, (GLdouble[]){1, 0, 0, 0.2}); "
                "glEnable(GL_CLIP_PLANE0);");
        if (shows(compare::has_polygons_as_smooth_lines))
            add("glPolygonMode(GL_BACK, GL_LINE); glEnable(GL_LINE_SMOOTH);");
        if (shows(compare::enables_incomplete_texture))
            add("glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){9, 90, 30, "
                "255});"
                "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);"
                "glBindTexture(GL_TEXTURE_CUBE_MAP, 0); glEnable(GL_TEXTURE_CUBE_MAP);");
        if (shows(compare::stipples_borders)) {
            polygon_stipple();
            add("glPolygonMode(GL_BACK, GL_LINE); glLineWidth(9);");
        }
        if (shows(compare::offsets_one_of_two_modes))
            add("glPolygonMode(GL_BACK, GL_LINE); glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset(0, 4e6);"
                "glLineWidth(9); glEnable(GL_DEPTH_TEST); glDepthFunc(GL_LESS);");
        if (shows(compare::offsets_out_of_range))
            add("glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glEnable(GL_POLYGON_OFFSET_LINE); glPolygonOffset(0, 8e6);"
                "glLineWidth(9); glEnable(GL_DEPTH_TEST); glDepthFunc(GL_LESS);");
        if (shows(compare::offsets_other_modes_alone))
            add("glDisable(GL_POLYGON_OFFSET_FILL); glEnable(GL_POLYGON_OFFSET_LINE); glPolygonOffset(0, 8e6);"
                "glEnable(GL_DEPTH_TEST); glDepthFunc(GL_LESS);");
        add("glShadeModel({});", structure_.chance(0.2) ? "GL_FLAT" : "GL_SMOOTH");
        if (shows(compare::shades_after_pop_in_list))
            add("glNewList(9, GL_COMPILE); glPushAttrib(GL_LIGHTING_BIT); glShadeModel(GL_FLAT); glPopAttrib();"
                "glShadeModel(GL_FLAT); glEndList(); glShadeModel(GL_SMOOTH); glCallList(9);");
        if (structure_.chance(0.2))
            add("glEnable(GL_CULL_FACE); glCullFace({}); glFrontFace({});", one_of({"GL_FRONT", "GL_BACK"}),
                one_of({"GL_CW", "GL_CCW"}));
        if (structure_.chance(0.15)) {
            add("glPolygonMode({}, {});", one_of({"GL_FRONT_AND_BACK", "GL_FRONT", "GL_BACK"}),
                one_of({"GL_LINE", "GL_LINE", "GL_POINT"}));
            if (structure_.chance(0.5))
                add("glEnable(GL_POLYGON_OFFSET_LINE); glEnable(GL_POLYGON_OFFSET_POINT); "
                    "glPolygonOffset({:.2f}, {:.1f});",
                    random_.uniform(-2, 2), random_.uniform(-9, 9));
        }
        add("glLineWidth({:.1f}); glPointSize({:.1f});", random_.uniform(0.6, 9), random_.uniform(0.6, 20));
    }

    bool of_points() const {
        return shows(compare::attenuates_points_aside) || shows(compare::attenuates_points_in_viewport) ||
               scissors_sprites() || shows(compare::draws_others_beside_sprites);
    }
    bool scissors_sprites() const { return shows(compare::has_scissored_sprites); }
    // The size of points, and point sprites. Factors of the distance are 0 or would show a known bug.
    void points() {
        const bool by_distance = shows(compare::attenuates_points_aside);
        if (shows(compare::attenuates_points_in_viewport))
            add("glViewport(20, 20, 24, 24); glDisable(GL_SCISSOR_TEST); glPointSize(30); "
                "glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (GLfloat[]){1.5, 0, 0});");
        if (by_distance || points_.chance(0.15))
            add("glPointSize({:.2f}); glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (GLfloat[]){{{:.4f}, {:.4f}, "
                "{:.4f}}});",
                points_.uniform(4, 30), points_.uniform(0.2, 4), by_distance ? points_.uniform(0.1, 0.5) : 0,
                by_distance ? points_.uniform(0, 0.5) : 0);
        if (points_.chance(0.15))
            add("glPointParameterf(GL_POINT_SIZE_MIN, {:.2f}); glPointParameterf(GL_POINT_SIZE_MAX, {:.2f});",
                points_.uniform(0, 10), points_.uniform(10, 25));
        const bool beside = shows(compare::draws_others_beside_sprites);
        if (!beside && (by_distance || !(scissors_sprites() || points_.chance(0.15)))) return;
        sprites_ = !beside;
        if (scissors_sprites()) add("glPointSize(20); glEnable(GL_SCISSOR_TEST); glScissor(0, 32, 64, 32);");
        add("glEnable(GL_POINT_SPRITE); glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, {});",
            beside || points_.chance(0.8) ? 1 : 0);
        if (points_.chance(0.5)) add("glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);");
        if (points_.chance(0.5))
            add("glActiveTexture(GL_TEXTURE1); glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, 1); "
                "glActiveTexture(GL_TEXTURE0);");
    }

    void light(int i) {
        const char* name = i == 0 ? "GL_LIGHT0" : "GL_LIGHT5";
        add("glEnable({});", name);
        add("glLightfv({}, GL_DIFFUSE, {}); glLightfv({}, GL_SPECULAR, {});", name, vector(), name, vector());
        if (shows(compare::shows_cut_of_rectangles) || structure_.chance(0.6)) {
            const bool positional = shows(compare::shows_cut_of_rectangles) || structure_.chance(0.5);
            add("glLightfv({}, GL_POSITION, (GLfloat[]){{{:.3f}, {:.3f}, {:.3f}, {}}});", name, random_.uniform(-3, 3),
                random_.uniform(-3, 3), random_.uniform(0.5, 3), positional ? 1 : 0);
            if (positional) add("glLightf({}, GL_LINEAR_ATTENUATION, {:.3f});", name, random_.uniform(0, 0.3));
        }
        if (structure_.chance(0.2))
            add("glLightf({}, GL_SPOT_CUTOFF, {:.1f}); glLightf({}, GL_SPOT_EXPONENT, {:.1f});", name,
                random_.uniform(20, 80), name, random_.uniform(0.5, 20));
    }

    void lighting() {
        add("glEnable(GL_LIGHTING); glEnable(GL_NORMALIZE);");
        light(0);
        if (structure_.chance(0.3)) light(1);
        const bool separate = shows(compare::adds_secondary_color_in_fog) || structure_.chance(0.4);
        add("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, {}); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, {});",
            separate ? "GL_SEPARATE_SPECULAR_COLOR" : "GL_SINGLE_COLOR", structure_.below(2));
        add("glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, {}); glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 8);",
            vector());
        add("glMaterialfv(GL_BACK, GL_EMISSION, {});", vector(0, 0.5));
        if (shows(compare::adds_secondary_color_in_fog))  // the sum exceeds 1
            add("glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, (GLfloat[]){0.9, 0.9, 0.9, 1});"
                "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 1);");
        if (structure_.chance(0.3))
            add("glColorMaterial({}, {}); glEnable(GL_COLOR_MATERIAL); glColor4f({});",
                one_of({"GL_FRONT", "GL_FRONT_AND_BACK"}),
                one_of({"GL_AMBIENT_AND_DIFFUSE", "GL_DIFFUSE", "GL_EMISSION"}), four());
    }

    // One glBegin ... glEnd, as text.
    std::string batch() {
        repeat_ = random_.chance(0.5) ? 1.5 : random_.uniform(2, 12);
        if (sprites_) return anywhere("GL_POINTS");
        projective_ = structure_.chance(0.2);
        materials_ = lit_ && structure_.chance(0.5);
        const bool of_triangles = shows(compare::offsets_one_of_two_modes) || shows(compare::offsets_out_of_range) ||
                                  shows(compare::offsets_other_modes_alone) ||
                                  shows(compare::draws_borders_of_clipped_polygons) ||
                                  shows(compare::adds_secondary_color_in_fog) || of_stencil() || reaches_behind();
        if (shows(compare::shows_cut_of_rectangles)) return flat("glRectf");
        if (shows(compare::has_edge_flags_in_strip)) return anywhere("GL_TRIANGLE_STRIP");
        if (shows(compare::lists_edge_flags))
            return "glNewList(9, GL_COMPILE); glBegin(GL_TRIANGLE_FAN);\n" + attributes(true, true) +
                   "glVertex3f(0, 0, -2); glEnd(); glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);\n" +
                   anywhere("GL_TRIANGLE_FAN") + "glEndList(); glCallList(9);\n";
        if (shows(compare::lists_attributes_after_vertices))
            return "glNewList(9, GL_COMPILE); glBegin(GL_TRIANGLES); glColor4f(0.9, 0.6, 0.3, 1); glEnd(); "
                   "glEndList(); "
                   "glColor4f(0.2, 0.3, 0.9, 1); glCallList(9); glNormal3f(0, 0, 1); "
                   "glBegin(GL_TRIANGLES); glVertex3f(-30, -30, -5); glVertex3f(30, -30, -5); glVertex3f(0, 40, -5); "
                   "glEnd();\n";
        if (shows(compare::executes_listed_loops))
            return "glNewList(9, GL_COMPILE_AND_EXECUTE); glBegin(GL_LINE_LOOP); glColor4f(0.9, 0.6, 0.3, 1); "
                   "glVertex3f(0, 0, -5); glColor4f(0.2, 0.3, 0.9, 1); glVertex3f(0.1, 0, -5); glEnd(); glEndList(); "
                   "glNormal3f(0, 0, 1); glBegin(GL_TRIANGLES); glVertex3f(-30, -30, -5); glVertex3f(30, -30, -5); "
                   "glVertex3f(0, 40, -5); glEnd();\n";
        if (shows(compare::lists_strips_with_late_attributes))
            return "glDisable(GL_CULL_FACE); glNewList(9, GL_COMPILE); glBegin(GL_TRIANGLE_STRIP); "
                   "glVertex3f(-30, -30, -5); glColor4f(0.9, 0.6, 0.3, 1); glVertex3f(30, -30, -5); "
                   "glVertex3f(0, 40, -5); glEnd(); glEndList(); glCallList(9);\n";
        if (shows(compare::stipples_listed_strips))
            return "glLineStipple(8, 255); glEnable(GL_LINE_STIPPLE); glNewList(9, GL_COMPILE);\n" +
                   anywhere("GL_LINE_STRIP") + anywhere("GL_LINE_STRIP") + "glEndList(); glCallList(9);\n";
        if (shows(compare::stipples_in_perspective))
            return "glLineWidth(9); glLineStipple(4, 0x3333); glEnable(GL_LINE_STIPPLE);\n" + anywhere("GL_LINES");
        if (shows(compare::biases_level_of_points) || shows(compare::has_smooth_points) ||
            shows(compare::attenuates_points_aside) || shows(compare::attenuates_points_in_viewport))
            return anywhere("GL_POINTS");
        if (shows(compare::draws_loops_with_late_attributes)) return anywhere("GL_LINE_LOOP");
        if (of_triangles || structure_.chance(0.55)) return anywhere("GL_TRIANGLES");
        if (structure_.chance(0.5))
            return anywhere(one_of(
                {"GL_POINTS", "GL_LINES", "GL_LINE_STRIP", "GL_LINE_LOOP", "GL_TRIANGLE_FAN", "GL_TRIANGLE_STRIP"}));
        return flat(one_of({"GL_QUADS", "GL_QUAD_STRIP", "GL_POLYGON", "GL_TRIANGLE_FAN", "glRectf"}));
    }

    // A dozen vertices at random places.
    std::string anywhere(const std::string& mode) {
        std::string text = fmt::format("glBegin({});\n", mode);
        const bool late = shows(compare::draws_loops_with_late_attributes);
        const bool of_strips = mode == "GL_TRIANGLE_STRIP" || mode == "GL_TRIANGLE_FAN";
        const bool flags = !of_strips || shows(compare::has_edge_flags_in_strip);
        for (int i = 0; i < 12; ++i) {
            if (!late || i > 4) text += attributes(i == 0, flags);
            const double depth = random_.uniform(reaches_behind() ? -5 : 2, 9);
            const double x = random_.uniform(-1, 1) * depth, y = random_.uniform(-1, 1) * depth;
            if (shows(compare::has_w_in_fog))
                text += fmt::format("glVertex4f({:.4f}, {:.4f}, {:.4f}, 2);\n", 2 * x, 2 * y, -2 * depth);
            else
                text += fmt::format("glVertex3f({:.4f}, {:.4f}, {:.4f});\n", x, y, -depth);
        }
        return text + "glEnd();\n";
    }

    // Corners of convex, flat shapes, for polygons and quadrilaterals (2.6.1).
    std::string flat(const std::string& mode) {
        const double depth = random_.uniform(3, 7), slope = random_.uniform(-0.5, 0.5);
        const double x = random_.uniform(-2, 2), y = random_.uniform(-2, 2), turn = random_.uniform(0, 6);
        if (mode == "glRectf")
            return fmt::format("glPushMatrix(); glTranslatef(0, 0, {:.4f}); glRotatef({:.1f}, 0.6, 0.64, 0.48);\n",
                               -depth, random_.uniform(-60, 60)) +
                   attributes(true, false) +
                   fmt::format("glRectf({:.4f}, {:.4f}, {:.4f}, {:.4f}); glPopMatrix();\n", x - 2, y - 2, x + 2, y + 2);
        std::string text = fmt::format("glBegin({});\n", mode);
        const bool flags = mode == "GL_QUADS" || mode == "GL_POLYGON";
        constexpr int kCorners = 8;
        for (int i = 0; i < kCorners; ++i) {
            // Two quadrilaterals, a strip from left to right, or around a circle.
            double dx = 2.5 * std::cos(turn + i * M_PI / 4), dy = 2.5 * std::sin(turn + i * M_PI / 4);
            if (mode == "GL_QUADS")
                dx = 2 * std::cos(turn + i * M_PI / 2), dy = (i < 4 ? 2 : 1) * std::sin(turn + i * M_PI / 2);
            if (mode == "GL_QUAD_STRIP") dx = i / 2 * 1.3 - 2, dy = i % 2 ? 1.2 : -1.4;
            text += attributes(i == 0, flags);
            text += fmt::format("glVertex3f({:.4f}, {:.4f}, {:.4f});\n", x + dx, y + dy, slope * dx - depth);
        }
        return text + "glEnd();\n";
    }

    // The first vertex sets every attribute that a later vertex sets: see "a line loop whose first vertex lacks
    // attributes".
    std::string attributes(bool first, bool flags) {
        std::string text;
        if (secondary_)
            text += fmt::format("glSecondaryColor3f({:.4f}, {:.4f}, {:.4f});\n", more_values_.uniform(0, 1),
                                more_values_.uniform(0, 1), more_values_.uniform(0, 1));
        if (fog_coords_)
            text += fmt::format("glFogCoordf({:.4f});\n",
                                more_values_.uniform(shows(compare::has_negative_fog_coords) ? -9 : 0, 14));
        // So near to each other that few texels fall within a pixel: otherwise filters leave the colour open.
        for (const int unit : further_units_)
            text += fmt::format("glMultiTexCoord4f(GL_TEXTURE{}, {:.4f}, {:.4f}, 0, {:.4f});\n", unit,
                                unit_values_.uniform(-0.5, 0.5), unit_values_.uniform(-0.5, 0.5),
                                projective_ ? unit_values_.uniform(0.5, 2) : 1);
        if (materials_ && (first || random_.chance(0.5)))
            text += fmt::format("glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, {});\n", vector());
        if (first || (flags && random_.chance(shows(compare::has_edge_flags_in_strip) ? 0.5 : 0.1)))
            text += fmt::format("glEdgeFlag({});\n", first || random_.below(2) ? 1 : 0);
        text += fmt::format("glColor4f({}); glNormal3f({:.3f}, {:.3f}, {:.3f});\n", four(), random_.uniform(-1, 1),
                            random_.uniform(-1, 1), random_.uniform(0.3, 1));
        const double s = random_.uniform(-repeat_, repeat_), t = random_.uniform(-repeat_, repeat_);
        if (shows(compare::mixes_tex_coords) && random_.chance(0.5))
            return text + fmt::format("glTexCoord2f({:.4f}, {:.4f});\n", s, t);
        const double q = projective_ || shows(compare::mixes_tex_coords) ? random_.uniform(0.5, 2) : 1;
        return text + fmt::format("glTexCoord4f({:.4f}, {:.4f}, 0, {:.4f});\n", s, t, q);
    }

    // One of freeglut's or GLU's shapes, in front of the eye.
    std::string solid() {
        repeat_ = 1.5;
        std::string text = attributes(true, false);
        text += fmt::format(
            "glPushMatrix(); glTranslatef({:.3f}, {:.3f}, {:.3f}); glRotatef({:.2f}, {:.3f}, {:.3f}, 0.5);\n",
            random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-6, -4), random_.uniform(-180, 180),
            random_.uniform(-1, 1), random_.uniform(-1, 1));
        const double size = random_.uniform(0.8, 1.8);
        if (structure_.chance(0.5)) {
            const char* shape =
                one_of({"glutSolidSphere({:.3f}, 9, 6)", "glutSolidCube({:.3f})", "glutSolidTorus(0.4, {:.3f}, 7, 11)",
                        "glutSolidCone({:.3f}, 2, 9, 3)", "glutSolidCylinder({:.3f}, 1.5, 8, 2)",
                        "glutWireCube({:.3f})", "glutSolidTeapot({:.3f})", "glutWireSphere({:.3f}, 7, 5)"});
            text += fmt::format(fmt::runtime(shape), size) + ";\n";
        } else {
            text += quadric(size);
        }
        return text + "glPopMatrix();\n";
    }

    // A Bezier surface, in front of the eye.
    std::string evaluated() {
        const bool flat = shows(compare::shades_evaluated_meshes_flat);
        std::string text = attributes(true, false);
        if (flat) text += "glDisable(GL_LIGHTING); glShadeModel(GL_FLAT);\n";
        text += fmt::format("glPushMatrix(); glTranslatef(0, 0, {:.3f}); glRotatef({:.2f}, {:.3f}, 1, 0.5);\n",
                            generated_.uniform(-7, -5), generated_.uniform(-180, 180), generated_.uniform(-1, 1));
        const auto map = [&](const char* target, int size, double low, double high) {
            const int order_u = 2 + generated_.below(3), order_v = 2 + generated_.below(3);
            std::string points;
            for (int i = 0; i < order_u * order_v; ++i)
                for (int n = 0; n < size; ++n) {
                    double value = generated_.uniform(low, high);
                    // The places of a surface's points follow their numbers, so that it does not fold.
                    if (size == 3 && n == 0) value = 4.0 * (i / order_v) / (order_u - 1) - 2;
                    if (size == 3 && n == 1) value = 4.0 * (i % order_v) / (order_v - 1) - 2;
                    points += fmt::format("{}{:.4f}", points.empty() ? "" : ", ", value);
                }
            text += fmt::format("glMap2f({0}, 0, 1, {1}, {2}, 0, 1, {3}, {4}, (GLfloat[]){{{5}}}); glEnable({0});\n",
                                target, size * order_v, order_u, size, order_v, points);
        };
        map("GL_MAP2_VERTEX_3", 3, -1, 1);
        if (flat || generated_.chance(0.5)) map("GL_MAP2_COLOR_4", 4, 0, 1);
        if (generated_.chance(0.5)) map("GL_MAP2_TEXTURE_COORD_2", 2, -1, 2);
        if (generated_.chance(0.7)) text += "glEnable(GL_AUTO_NORMAL);\n";
        text += fmt::format("glMapGrid2f({}, 0, 1, {}, 0, 1);\n", 2 + generated_.below(5), 2 + generated_.below(5));
        const char* const modes[] = {"GL_FILL", "GL_FILL", "GL_LINE", "GL_POINT"};
        text +=
            flat ? "glEvalMesh2(GL_FILL, 0, 2, 0, 2);\n"
            : generated_.chance(0.7)
                ? fmt::format("glEvalMesh2({}, 0, 2, 0, 2);\n", modes[generated_.below(4)])
                : "glBegin(GL_TRIANGLES); glEvalCoord2f(0, 0); glEvalCoord2f(1, 0.2); glEvalPoint2(1, 2); glEnd();\n";
        return text + "glDisable(GL_MAP2_COLOR_4); glDisable(GL_MAP2_TEXTURE_COORD_2); glPopMatrix();\n";
    }

    std::string quadric(double size) {
        if (!has_quadric_) add("GLUquadric* quadric = gluNewQuadric();");
        has_quadric_ = true;
        std::string text =
            fmt::format("gluQuadricNormals(quadric, {}); gluQuadricOrientation(quadric, {});\n",
                        one_of({"GLU_SMOOTH", "GLU_FLAT", "GLU_NONE"}), one_of({"GLU_OUTSIDE", "GLU_INSIDE"}));
        text += fmt::format("gluQuadricDrawStyle(quadric, {}); gluQuadricTexture(quadric, {});\n",
                            one_of({"GLU_FILL", "GLU_FILL", "GLU_LINE", "GLU_SILHOUETTE", "GLU_POINT"}),
                            structure_.below(2) ? "GL_TRUE" : "GL_FALSE");
        const char* shape =
            one_of({"gluSphere(quadric, {:.3f}, 8, 6)", "gluCylinder(quadric, {:.3f}, 0.5, 2, 9, 3)",
                    "gluDisk(quadric, 0.3, {:.3f}, 9, 3)", "gluPartialDisk(quadric, 0.3, {:.3f}, 7, 2, 30, 200)"});
        return text + fmt::format(fmt::runtime(shape), size) + ";\n";
    }

    double repeat_ = 1;
    bool projective_ = false, materials_ = false, has_quadric_ = false;
    Random structure_, generated_, random_, levels_, units_, unit_values_, fragments_, more_, more_values_, stipples_,
        copies_, cubes_, points_, anisotropy_, labels_, pixel_copies_, stencil_pixels_, depths_, volumes_, objects_;
    bool secondary_ = false, fog_coords_ = false;  // vertices have secondary colours, fog coordinates
    bool sprites_ = false;                         // everything is points
    std::vector<int> further_units_;               // the numbers of those with a texture
    ShownBug departure_;
    bool lit_ = false;
    std::string text_;
};

}  // namespace

CommandList fragment_state(const Seed& seed) { return read_scene(Builder(seed).build(), "fuzz", "fuzz"); }

}  // namespace twinlight::fuzz
