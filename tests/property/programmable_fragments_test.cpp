// Compares pictures of the shaders with those of the fixed function, pixel by pixel, over random states of everything
// that decides a fragment's colour and whether it is drawn: textures and their environments, the colour sum, fog, the
// per-fragment operations, clip planes, materials of vertices, wide lines and points, polygons drawn as their edges.
//
// To find what rounding decides, the fixed function draws again with the picture moved by one step of the rasteriser's
// grid in each direction, and with slightly different levels of detail. A pixel may have any value between these
// results, and differ by the number of 1/255 steps that SceneText::codes returns.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "../golden/picture_failure.h"
#include "../unit/quad_cuts.h"
#include "judge/fuzz/random.h"
#include "render/context/context.h"
#include "render/effect/plan.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::programmable_fragments_test {
namespace {

constexpr int kWidth = 96, kHeight = 72;
constexpr double kGridStep = 1.0 / 256;   // of a pixel: llvmpipe and softpipe have 8 fractional bits
constexpr double kLevelStep = 1.0 / 256;  // of a texture's level of detail: llvmpipe's log2 is not exact

constexpr std::array kFormats{kGL_ALPHA, kGL_LUMINANCE, kGL_LUMINANCE_ALPHA, kGL_INTENSITY, kGL_RGB, kGL_RGBA};
constexpr std::array kEnvironments{kGL_MODULATE, kGL_REPLACE, kGL_BLEND, kGL_ADD, kGL_DECAL};
// Each pair of them, but that DECAL is undefined for the formats before RGB (table 3.23); then some without a texture.
constexpr int kTextured = static_cast<int>(kFormats.size() * (kEnvironments.size() - 1) + 2);
constexpr int kStructures = kTextured + 4;

// A scene as text. Of each `structure` is one: a program takes the driver a tenth of a second to make.
class SceneText {
  public:
    explicit SceneText(int structure)
        : structure_(static_cast<std::uint64_t>(structure)), random_(static_cast<std::uint64_t>(3000 + structure)) {
        textured_ = structure < kTextured;
        const auto place = static_cast<std::size_t>(std::min(structure, kTextured - 1));
        environment_ = kEnvironments.at(place / kFormats.size());
        format_ = kFormats.at(place % kFormats.size() + (environment_ == kGL_DECAL ? kFormats.size() - 2 : 0));
        one_dimensional_ = structure_.chance(0.25);
        q_ = structure_.chance(0.3);
        lit_ = structure_.chance(0.7);
        planes_ = structure_.chance(0.5) ? 1 + structure_.below(2) : 0;
        two_side_ = structure_.chance(0.5);
        color_material_ = structure_.chance(0.3);
        vertex_materials_ = structure_.chance(0.4);
        fog_ = structure % 4;
        matrix_ = structure_.chance(0.3);
        flat_ = structure_.chance(0.25);
        // The driver does not clamp the colour sum before fog (golden/known_differences).
        separate_ = fog_ == 0;
    }

    // The picture moved by so many pixels, and its textures' levels of detail by so much.
    struct Moved {
        double x = 0, y = 0, level = 0;
    };
    std::string text(const Moved& moved) const {
        return fmt::format("glMatrixMode(GL_PROJECTION);\nglTranslatef({:.9g}, {:.9g}, 0);\n", 2 * moved.x / kWidth,
                           2 * moved.y / kHeight) +
               fmt::format("glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, {:.4f});\n",
                           lod_bias_ + moved.level) +
               text_;
    }

    // Whether Phong's shading is Gouraud's, as the colour is a linear function of what is interpolated: each primitive
    // has one normal, and the light is directional.
    bool is_linear() const { return lit_ && !flat_ && !(separate_ && vertex_materials_); }

    // By how many steps of 1/255 a right picture may differ from the fixed function's.
    int codes() const {
        const int rounding = 1;               // to 8 bits, on either side of a half
        const int weights = linear_ ? 3 : 0;  // 8 bits for a position between texels, in s, in t and between levels
        return rounding + weights;
    }

    SceneText& build() {
        add("gluPerspective(60, {:.4f}, 1, 20);\nglMatrixMode(GL_MODELVIEW);\nglTranslatef(0, 0, -6);\n",
            double{kWidth} / kHeight);
        add("glClearColor({});\nglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n", numbers(4, 0, 1));
        add("glShadeModel({});\n", flat_ ? "GL_FLAT" : "GL_SMOOTH");
        clip_planes();
        add("glRotatef({}, {});\n", number(-40, 40), numbers(3, -1, 1));
        if (textured_) texture();
        if (lit_) lighting();
        fog();
        operations();
        for (const char* mode : {"GL_QUADS", "GL_TRIANGLE_STRIP", "GL_POLYGON", "GL_LINE_STRIP", "GL_POINTS"}) {
            rasterisation();
            primitive(mode);
        }
        return *this;
    }

  private:
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
    }
    double uniform(double low, double high) { return random_.uniform(low, high); }
    bool chance(double probability) { return random_.chance(probability); }
    std::string number(double low, double high) { return fmt::format("{:.4f}", uniform(low, high)); }
    std::string numbers(int count, double low, double high) {
        std::string list = number(low, high);
        for (int i = 1; i < count; ++i) list += ", " + number(low, high);
        return list;
    }
    std::string vector(int count, double low, double high) {
        return fmt::format("(GLfloat[]){{{}}}", numbers(count, low, high));
    }
    const char* one_of(std::initializer_list<const char*> choices) {
        return choices.begin()[random_.below(static_cast<int>(choices.size()))];
    }

    void clip_planes() {
        for (int i = 0; i < planes_; ++i) {  // through the middle of the shapes
            const glm::dvec3 normal(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
            add("glClipPlane(GL_CLIP_PLANE{0}, (GLdouble[]){{{1:.4f}, {2:.4f}, {3:.4f}, {4:.4f}}});\n"
                "glEnable(GL_CLIP_PLANE{0});\n",
                3 * i, normal.x, normal.y, normal.z, 6 * normal.z + uniform(0, 1));
        }
    }

    void texture() {
        const char* target = one_dimensional_ ? "GL_TEXTURE_1D" : "GL_TEXTURE_2D";
        const int width = 8, height = one_dimensional_ ? 1 : 8;
        add("GLfloat texels[] = {{{}}};\n", numbers(4 * width * height, 0, 1));
        const bool mipmaps = chance(0.5);
        add("glTexParameteri({}, GL_GENERATE_MIPMAP, {});\n", target, mipmaps ? 1 : 0);
        if (one_dimensional_)
            add("glTexImage1D(GL_TEXTURE_1D, 0, {}, 8, 0, GL_RGBA, GL_FLOAT, texels);\n", enum_name(format_));
        else
            add("glTexImage2D(GL_TEXTURE_2D, 0, {}, 8, 8, 0, GL_RGBA, GL_FLOAT, texels);\n", enum_name(format_));
        const std::string magnified = one_of({"GL_NEAREST", "GL_LINEAR"});
        const std::string minified = mipmaps ? one_of({"GL_NEAREST_MIPMAP_NEAREST", "GL_LINEAR_MIPMAP_NEAREST",
                                                       "GL_NEAREST_MIPMAP_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"})
                                             : one_of({"GL_NEAREST", "GL_LINEAR"});
        linear_ = (magnified + minified).find("LINEAR") != std::string::npos;
        add("glTexParameteri({0}, GL_TEXTURE_MAG_FILTER, {1});\nglTexParameteri({0}, GL_TEXTURE_MIN_FILTER, {2});\n",
            target, magnified, minified);
        // Of a nearest and a linear filter the driver's nearest one may take GL_CLAMP's border
        // (golden/known_differences).
        const bool mixed = linear_ && (magnified + minified).find("GL_NEAREST") != std::string::npos;
        for (const char* axis : {"S", "T"})
            add("glTexParameteri({}, GL_TEXTURE_WRAP_{}, {});\n", target, axis,
                chance(mixed ? 0 : 0.4)
                    ? "GL_CLAMP"
                    : one_of({"GL_REPEAT", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER", "GL_MIRRORED_REPEAT"}));
        add("glTexParameterfv({}, GL_TEXTURE_BORDER_COLOR, {});\n", target, vector(4, 0, 1));
        add("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {});\n", enum_name(environment_));
        add("glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {});\n", vector(4, 0, 1));
        if (chance(0.3)) lod_bias_ = uniform(-1, 1);
        if (chance(0.3)) add("glTexParameterf({}, GL_TEXTURE_LOD_BIAS, {});\n", target, number(-1, 1));
        // Not far beyond level 0: the driver rounds the levels that it makes another way.
        if (chance(0.3))
            add("glTexParameterf({0}, GL_TEXTURE_MIN_LOD, {1});\nglTexParameterf({0}, GL_TEXTURE_MAX_LOD, {2});\n",
                target, number(-1, 0), number(0.5, 3));
        if (mipmaps && chance(0.3)) add("glTexParameteri({}, GL_TEXTURE_MAX_LEVEL, {});\n", target, random_.below(4));
        if (matrix_)
            add("glMatrixMode(GL_TEXTURE);\nglScalef({0}, 1);\nglRotatef({1}, 0, 0, 1);\nglMatrixMode(GL_MODELVIEW);\n",
                numbers(2, 0.5, 2), number(0, 360));
        add("glEnable({});\n", target);
    }

    void material(const char* face) {
        add("glMaterialfv({}, GL_AMBIENT, {});\n", face, vector(4, 0, 0.3));
        add("glMaterialfv({}, GL_DIFFUSE, {});\n", face, vector(4, 0.2, 0.7));
        add("glMaterialfv({}, GL_EMISSION, {});\n", face, vector(4, 0, 0.2));
        if (separate_) add("glMaterialfv({}, GL_SPECULAR, {});\n", face, vector(4, 0, 1));
        if (separate_) add("glMaterialf({}, GL_SHININESS, {});\n", face, number(1, 30));
    }

    void lighting() {
        add("glEnable(GL_LIGHTING);\nglEnable(GL_LIGHT0);\nglEnable(GL_NORMALIZE);\n");
        add("glLightfv(GL_LIGHT0, GL_DIFFUSE, {});\n", vector(4, 0.3, 0.7));
        add("glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){{{}, 3, 0}});\n", numbers(2, -2, 2));
        if (two_side_) add("glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);\n");
        if (separate_) add("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);\n");
        material("GL_FRONT_AND_BACK");
        if (two_side_) material("GL_BACK");
        add("glColor3f({});\n", numbers(3, 0, 0.6));
        if (color_material_) {
            add("glColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);\nglEnable(GL_COLOR_MATERIAL);\nglColor3f({});\n",
                numbers(3, 0, 0.6));
        }
    }

    void fog() {
        if (fog_ == 0) return;
        add("glEnable(GL_FOG);\nglFogi(GL_FOG_MODE, {});\n",
            fog_ == 1 ? "GL_LINEAR" : (fog_ == 2 ? "GL_EXP" : "GL_EXP2"));
        add("glFogfv(GL_FOG_COLOR, {});\n", vector(4, 0, 1));
        add("glFogf(GL_FOG_DENSITY, {});\nglFogf(GL_FOG_START, {});\nglFogf(GL_FOG_END, {});\n", number(0.05, 0.3),
            number(2, 5), number(6, 9));
    }

    bool capability(const char* name, double probability) {
        const bool on = chance(probability);
        add("{}({});\n", on ? "glEnable" : "glDisable", name);
        return on;
    }

    // Operations that a driver may compile into its programs: set once per scene.
    void operations() {
        const auto comparison = [&] {
            return one_of({"GL_LESS", "GL_LEQUAL", "GL_GREATER", "GL_GEQUAL", "GL_NOTEQUAL", "GL_ALWAYS"});
        };
        const auto factor = [&] {
            return one_of({"GL_ZERO", "GL_ONE", "GL_DST_COLOR", "GL_ONE_MINUS_SRC_ALPHA", "GL_SRC_ALPHA",
                           "GL_CONSTANT_COLOR", "GL_ONE_MINUS_CONSTANT_ALPHA", "GL_DST_ALPHA"});
        };
        if (capability("GL_ALPHA_TEST", 0.3)) add("glAlphaFunc({}, {});\n", comparison(), number(0.2, 0.8));
        if (capability("GL_BLEND", 0.5))
            add("glBlendFuncSeparate({}, {}, {}, {});\nglBlendColor({});\n", factor(), factor(), factor(), factor(),
                numbers(4, 0, 1));
        if (chance(0.2)) add("glColorMask(1, {}, 1, {});\n", random_.below(2), random_.below(2));
        if (capability("GL_DEPTH_TEST", 0.6))
            add("glDepthFunc({});\nglDepthMask({});\n", chance(0.6) ? "GL_LESS" : comparison(), chance(0.9) ? 1 : 0);
    }

    void rasterisation() {
        if (capability("GL_SCISSOR_TEST", 0.2))
            add("glScissor({}, {}, {}, {});\n", random_.below(30), random_.below(20), 30 + random_.below(60),
                30 + random_.below(40));
        if (chance(0.2)) add("glDepthRange({}, {});\n", number(0, 0.3), number(0.6, 1));
        if (capability("GL_POLYGON_OFFSET_FILL", 0.3)) add("glPolygonOffset({}, 0);\n", number(-2, 2));
        if (capability("GL_CULL_FACE", 0.2))
            add("glCullFace({});\nglFrontFace({});\n", one_of({"GL_FRONT", "GL_BACK"}), one_of({"GL_CW", "GL_CCW"}));
        const auto mode = [&] { return chance(0.7) ? "GL_FILL" : one_of({"GL_LINE", "GL_POINT"}); };
        add("glPolygonMode(GL_FRONT, {});\nglPolygonMode(GL_BACK, {});\n", mode(), mode());
        add("glLineWidth({});\nglPointSize({});\n", number(0.5, 5), number(0.5, 9));
    }

    // A flat polygon's corners, or points anywhere.
    void primitive(const char* mode) {
        const bool strip = mode == std::string("GL_TRIANGLE_STRIP");
        const bool flat = strip || mode == std::string("GL_QUADS") || mode == std::string("GL_POLYGON");
        // The driver heeds edge flags of strips, too (golden/known_differences): there they are true.
        const bool has_edge_flags = flat && !strip;
        const double x = uniform(-2, 2), y = uniform(-1.5, 1.5), z = uniform(-1.5, 1.5), slope = uniform(-1, 1);
        const double turn = uniform(0, 6);
        add("glBegin({});\n", mode);
        if (lit_) add("glNormal3f({});\n", numbers(3, 0.1, 1));
        constexpr int kCorners = 4;
        for (int i = 0; i < kCorners; ++i) {
            vertex_attributes();
            add("glEdgeFlag({});\n", has_edge_flags && chance(0.3) ? 0 : 1);
            // Around a circle; a strip takes the third corner last.
            const int corner = strip && i >= 2 ? 5 - i : i;
            const double angle = turn + corner * std::acos(-1) / 2, dx = 2.5 * std::cos(angle),
                         dy = 2.2 * std::sin(angle);
            if (flat)
                add("glVertex3f({:.4f}, {:.4f}, {:.4f});\n", x + dx, y + dy, z + slope * dx);
            else
                add("glVertex3f({});\n", numbers(3, -2.5, 2.5));
        }
        add("glEnd();\n");
    }

    void vertex_attributes() {
        if (!lit_ || color_material_) add("glColor4f({});\n", numbers(4, 0, 0.6));
        if (textured_) add("glTexCoord4f({}, 0, {});\n", numbers(2, -1, 2), q_ ? number(0.5, 2) : "1");
        if (!lit_ || !vertex_materials_) return;
        add("glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, {});\n", vector(4, 0, 0.2));
        if (!color_material_) add("glMaterialfv(GL_FRONT, GL_DIFFUSE, {});\n", vector(4, 0.2, 0.7));
        if (separate_ && chance(0.5)) add("glMaterialf(GL_FRONT, GL_SHININESS, {});\n", number(1, 30));
    }

    fuzz::Random structure_, random_;
    Enum format_ = kGL_RGBA, environment_ = kGL_MODULATE;
    bool textured_ = false, one_dimensional_ = false, q_ = false, matrix_ = false;
    bool lit_ = false, two_side_ = false, separate_ = false, color_material_ = false, vertex_materials_ = false;
    bool flat_ = false, linear_ = false;
    double lod_bias_ = 0;
    int fog_ = 0, planes_ = 0;
    std::string text_;
};

Scene scene_of(const std::string& text) {
    auto commands = std::make_shared<const CommandList>(read_scene(text, "random.gl", "random"));
    State state({.width = kWidth, .height = kHeight});
    for (const Command& command : commands->commands) state.apply(command);
    EXPECT_TRUE(state.errors().empty()) << state.errors().front().message << "\n" << text;
    Frame frame = state.take_frame();
    EXPECT_TRUE(frame.unsupported.empty()) << frame.unsupported.front().name << "\n" << text;
    return {std::move(commands), std::move(frame)};
}

// The range that the fixed function may show, channel by channel.
struct Bounds {
    Image least, greatest, itself;
    Image between_cuts;  // how much further the other cut of quadrilaterals may take a channel
};

Bounds fixed_bounds(const SceneText& scene) {
    Bounds bounds;
    bounds.between_cuts = between_cuts(scene_of(scene.text({})).frame, {});
    bounds.itself = fixed::render(scene_of(scene.text({})));
    bounds.least = bounds.greatest = bounds.itself;
    std::vector<SceneText::Moved> moves = {{.level = kLevelStep}, {.level = -kLevelStep}};
    for (int x : {-1, 0, 1})
        for (int y : {-1, 0, 1}) moves.push_back({.x = x * kGridStep, .y = y * kGridStep});
    for (const SceneText::Moved& move : moves) {
        const Image moved = fixed::render(scene_of(scene.text(move)));
        for (std::size_t i = 0; i < moved.pixels.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) {
                bounds.least.pixels[i][c] = std::min(bounds.least.pixels[i][c], moved.pixels[i][c]);
                bounds.greatest.pixels[i][c] = std::max(bounds.greatest.pixels[i][c], moved.pixels[i][c]);
            }
        }
    }
    return bounds;
}

// Counts of pixels: all; drawn on; different from the fixed function where both cuts are alike; with a range of more than kOpen steps of 1/255.
struct Count {
    std::size_t pixels = 0, drawn = 0, different = 0, open = 0;
    int worst = 0;  // steps of 1/255 beyond the bounds
};

constexpr int kOpen = 8;

Count count(const Bounds& bounds, const Image& picture) {
    Count count;
    const Rgba background = bounds.itself.at(0, 0);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        int beyond = 0, width = 0;
        bool is_cut_alike = true;
        for (std::size_t c = 0; c < 4; ++c) {
            const int code = channel_code(picture.pixels[i][c]);
            const int least = channel_code(bounds.least.pixels[i][c]);
            const int greatest = channel_code(bounds.greatest.pixels[i][c]);
            const float between = bounds.between_cuts.pixels[i][c];
            is_cut_alike = is_cut_alike && between == 0;
            beyond =
                std::max(beyond, std::max(least - code, code - greatest) - static_cast<int>(std::ceil(255 * between)));
            width = std::max(width, greatest - least);
        }
        ++count.pixels;
        count.drawn += bounds.itself.pixels[i] != background;
        count.different += is_cut_alike && picture.pixels[i] != bounds.itself.pixels[i];
        count.open += width > kOpen;
        count.worst = std::max(count.worst, beyond);
    }
    return count;
}

class Comparison {
  public:
    void compare(int structure) {
        const SceneText scene = SceneText(structure).build();
        const Bounds bounds = fixed_bounds(scene);
        const Frame frame = scene_of(scene.text({})).frame;
        judge(fmt::format("fragments_{}", structure), scene, bounds, renderer_.render(frame, {}), total_);
        if (!scene.is_linear() || structure % 2 != 0) return;  // half of them, for time
        judge(fmt::format("fragments_{}_phong", structure), scene, bounds,
              renderer_.render(frame, {{{.shading = Shading::kPhong}}}), total_phong_);
    }

    // The scenes draw enough, and rounding decides only few pixels.
    void expect_worth() const {
        for (const Count& total : {total_, total_phong_}) {
            fmt::print("{} pixels, {} drawn on, {} different, {} open, the worst {} codes beyond\n", total.pixels,
                       total.drawn, total.different, total.open, total.worst);
            EXPECT_GE(total.drawn, total.pixels / 6);
            EXPECT_LE(total.open, total.drawn / 50);
            EXPECT_LE(total.different, total.drawn / 100);
        }
    }

  private:
    static void judge(const std::string& name, const SceneText& scene, const Bounds& bounds, const Image& picture,
                      Count& total) {
        const Count here = count(bounds, picture);
        if (here.worst > scene.codes())
            ADD_FAILURE() << name << ": " << here.worst << " codes beyond what the fixed function may show\n"
                          << scene.text({}) << picture_failure(name, picture, bounds.itself).message();
        total.pixels += here.pixels;
        total.drawn += here.drawn;
        total.different += here.different;
        total.open += here.open;
        total.worst = std::max(total.worst, here.worst);
    }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(kWidth, kHeight);
    programmable::Renderer renderer_;
    Count total_, total_phong_;
};

TEST(ProgrammableFragments, AreTheFixedFunctionsOverRandomStates) {
    Comparison comparison;
    for (int structure = 0; structure < kStructures; ++structure) comparison.compare(structure);
    comparison.expect_worth();
}

}  // namespace
}  // namespace twinlight::programmable_fragments_test
