#include "fuzz/fragment_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "command/text.h"
#include "fuzz/random.h"

namespace twinlight::fuzz {

namespace {

class Builder {
  public:
    explicit Builder(const Seed& seed) : structure_(seed.structure), random_(seed.values), departure_(seed.departure) {}

    std::string build() {
        clear("GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT");
        add("glMatrixMode(GL_PROJECTION); glFrustum(-1, 1, -1, 1, 1, 10);");
        if (structure_.chance(0.7)) texture();
        add("glMatrixMode(GL_MODELVIEW);");
        if (structure_.chance(0.4)) fog();
        raster();
        lit_ = structure_.chance(0.4);
        if (lit_) lighting();
        if (structure_.chance(0.6)) fragment_operations();
        const std::string first = batch();
        text_ += first;
        // A second pass: of the same vertices, as multi-pass effects have it, or of others.
        if (structure_.chance(0.3)) {
            if (structure_.chance(0.2)) clear(structure_.chance(0.5) ? "GL_COLOR_BUFFER_BIT" : "GL_DEPTH_BUFFER_BIT");
            if (structure_.chance(0.5)) add("glDisable(GL_TEXTURE_2D); glDisable(GL_TEXTURE_1D);");
            raster();
            fragment_operations();
            text_ += structure_.chance(0.5) ? first : batch();
        }
        return std::move(text_);
    }

  private:
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

    // Random texels at every level, so that levels can be told apart.
    void texture() {
        const bool flat = structure_.chance(0.15);
        const std::string target = flat ? "GL_TEXTURE_1D" : "GL_TEXTURE_2D";
        const char* format =
            one_of({"GL_ALPHA", "GL_LUMINANCE", "GL_LUMINANCE_ALPHA", "GL_INTENSITY", "GL_RGB", "GL_RGBA", "GL_RGBA"});
        const std::string min =
            one_of({"GL_NEAREST", "GL_LINEAR", "GL_NEAREST_MIPMAP_NEAREST", "GL_LINEAR_MIPMAP_NEAREST",
                    "GL_NEAREST_MIPMAP_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"});
        int width = 1 << structure_.below(6), height = flat ? 1 : 1 << structure_.below(6);
        for (int level = 0;; ++level) {
            std::string texels;
            for (int i = 0; i < width * height * 4; ++i)
                texels += fmt::format("{}{}", i ? "," : "", random_.below(256));
            add("GLubyte level{}[] = {{{}}};", level, texels);
            add("glTexImage{}({}, {}, {}, {}{}, 0, GL_RGBA, GL_UNSIGNED_BYTE, level{});", flat ? "1D" : "2D", target,
                level, format, width, flat ? "" : fmt::format(", {}", height), level);
            if (min.find("MIPMAP") == std::string::npos || (width == 1 && height == 1)) break;
            width = std::max(1, width / 2);
            height = std::max(1, height / 2);
        }
        add("glTexParameteri({}, GL_TEXTURE_MIN_FILTER, {});", target, min);
        add("glTexParameteri({}, GL_TEXTURE_MAG_FILTER, {});", target, one_of({"GL_NEAREST", "GL_LINEAR"}));
        for (const char* axis : {"S", "T"})
            add("glTexParameteri({}, GL_TEXTURE_WRAP_{}, {});", target, axis,
                one_of({"GL_REPEAT", "GL_REPEAT", "GL_CLAMP", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER",
                        "GL_MIRRORED_REPEAT"}));
        add("glTexParameterfv({}, GL_TEXTURE_BORDER_COLOR, {});", target, vector());
        add("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {});",
            one_of({"GL_MODULATE", "GL_MODULATE", "GL_REPLACE", "GL_DECAL", "GL_BLEND", "GL_ADD"}));
        add("glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {});", vector());
        if (structure_.chance(0.15))
            add("glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, {:.3f});", random_.uniform(-2, 2));
        if (structure_.chance(0.2))
            add("glMatrixMode(GL_TEXTURE); glTranslatef({:.3f}, {:.3f}, 0); glRotatef({:.1f}, 0, 0, 1);",
                random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(0, 360));
        add("glEnable({});", target);
    }

    void fog() {
        add("glEnable(GL_FOG); glFogi(GL_FOG_MODE, {});", one_of({"GL_LINEAR", "GL_EXP", "GL_EXP2"}));
        add("glFogf(GL_FOG_DENSITY, {:.4f}); glFogfv(GL_FOG_COLOR, {});", random_.uniform(0, 0.3), vector());
        add("glFogf(GL_FOG_START, {:.3f}); glFogf(GL_FOG_END, {:.3f});", random_.uniform(1, 6), random_.uniform(6, 12));
    }

    void fragment_operations() {
        if (structure_.chance(0.5)) blending();
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
        add("glShadeModel({});", structure_.chance(0.2) ? "GL_FLAT" : "GL_SMOOTH");
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

    void lighting() {
        add("glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_NORMALIZE);");
        add("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, {}); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, {});",
            structure_.chance(0.7) ? "GL_SEPARATE_SPECULAR_COLOR" : "GL_SINGLE_COLOR", structure_.below(2));
        add("glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, {}); glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 8);",
            vector());
        add("glMaterialfv(GL_BACK, GL_EMISSION, {});", vector(0, 0.5));
    }

    // The text of one glBegin ... glEnd.
    std::string batch() {
        const double repeat = random_.chance(0.5) ? 1.5 : random_.uniform(2, 12);
        const bool projective = structure_.chance(0.2);
        const bool materials = lit_ && structure_.chance(0.5);
        const char* other =
            one_of({"GL_POINTS", "GL_LINES", "GL_LINE_STRIP", "GL_LINE_LOOP", "GL_TRIANGLE_FAN", "GL_TRIANGLE_STRIP"});
        std::string text = fmt::format("glBegin({});\n", structure_.chance(0.75) ? "GL_TRIANGLES" : other);
        for (int i = 0; i < 12; ++i) {
            // What any vertex has of its own, the first has: see "a line loop whose first vertex lacks attributes".
            const bool first = i == 0;
            if (materials && (first || random_.chance(0.5)))
                text += fmt::format("glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, {});\n", vector());
            if (first || random_.chance(0.1)) text += fmt::format("glEdgeFlag({});\n", first ? 1 : random_.below(2));
            text += fmt::format("glColor4f({}); glNormal3f({:.3f}, {:.3f}, {:.3f});\n", four(), random_.uniform(-1, 1),
                                random_.uniform(-1, 1), random_.uniform(0.3, 1));
            text += fmt::format("glTexCoord4f({:.4f}, {:.4f}, 0, {:.4f});\n", random_.uniform(-repeat, repeat),
                                random_.uniform(-repeat, repeat), projective ? random_.uniform(0.5, 2) : 1);
            const double depth = random_.uniform(2, 9);
            text += fmt::format("glVertex3f({:.4f}, {:.4f}, {:.4f});\n", random_.uniform(-1, 1) * depth,
                                random_.uniform(-1, 1) * depth, -depth);
        }
        return text + "glEnd();\n";
    }

    Random structure_, random_;
    std::string_view departure_;
    bool lit_ = false;
    std::string text_;
};

}  // namespace

CommandList fragment_state(const Seed& seed) { return read_scene(Builder(seed).build(), "fuzz", "fuzz"); }

}  // namespace twinlight::fuzz
