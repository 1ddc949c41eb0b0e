// Exact surfaces by shaders against the reference's: every shape in many states, pixel by pixel.
//
// Near a silhouette, or wherever what is seen changes at once, the pixel shows what a ray a little beside its centre would: such
// a pixel, where a thousandth of a pixel decides in the reference, counts apart, and must show one of these.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>
#include <vector>

#include "command/text.h"
#include "context/context.h"
#include "context/gl.h"
#include "programmable/programmable.h"
#include "reference/pixel.h"
#include "reference/reference.h"
#include "scenes/scenes.h"
#include "state/state.h"

namespace twinlight {
namespace {

constexpr int kSide = 64;
constexpr double kCode = 1.0 / 255;

Frame frame_of(const std::string& text, int width = kSide, int height = kSide) {
    const auto scene = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
    return make_frame(scene, {.width = width, .height = height});
}

RenderOptions exact(Tier tier) {
    RenderOptions options;
    options.shading = Shading::kExact;
    options.budget = 0;
    options.tier = tier;
    return options;
}

double apart(const Rgba& a, const Rgba& b) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, static_cast<double>(std::abs(a[c] - b[c])));
    return most;
}

// All that is drawn moved by that part of a pixel.
Frame shifted(Frame frame, double x, double y) {
    for (auto& item : frame.items)
        if (Draw* draw = std::get_if<Draw>(&item)) {
            const Viewport& viewport = draw->raster.viewport;
            draw->clip_from_eye = glm::translate(glm::dmat4(1), {2 * x / viewport.width, 2 * y / viewport.height, 0}) *
                                  draw->clip_from_eye;
        }
    return frame;
}

// The reference's picture, and what it is for rays a little beside.
class Truth {
  public:
    explicit Truth(const Frame& frame) {
        constexpr double kStep = 1e-3;
        for (const auto& [x, y] : {std::pair(0.0, 0.0), {kStep, 0.0}, {-kStep, 0.0}, {0.0, kStep}, {0.0, -kStep}})
            pictures_.push_back(reference::render(shifted(frame, x, y), {.shading = Shading::kExact}));
    }
    const Image& picture() const { return pictures_.front(); }
    bool is_edge(std::size_t pixel) const {
        return std::ranges::any_of(
            pictures_, [&](const Image& p) { return apart(p.pixels[pixel], picture().pixels[pixel]) > kCode / 2; });
    }
    double nearest(std::size_t pixel, const Rgba& color) const {
        double least = 1;
        for (const Image& p : pictures_) least = std::min(least, apart(p.pixels[pixel], color));
        return least;
    }

  private:
    std::vector<Image> pictures_;
};

struct Found {
    int drawn = 0, edges = 0, edges_off = 0, interiors_off = 0;
    double worst = 0;  // of interiors
    std::size_t worst_pixel = 0;
};

Found compare(const Truth& truth, const Image& image, double tolerance) {
    Found found;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        found.drawn += image.pixels[i] == Rgba{} ? 0 : 1;
        if (truth.is_edge(i)) {
            ++found.edges;
            found.edges_off += truth.nearest(i, image.pixels[i]) > tolerance ? 1 : 0;
            continue;
        }
        const double off = apart(image.pixels[i], truth.picture().pixels[i]);
        found.interiors_off += off > tolerance ? 1 : 0;
        if (off > found.worst) {
            found.worst = off;
            found.worst_pixel = i;
        }
    }
    return found;
}

// ---- The scenes of these tests ----

const std::string kCamera =
    "glMatrixMode(GL_PROJECTION); gluPerspective(40, 1, 1, 20); glMatrixMode(GL_MODELVIEW); "
    "gluLookAt(1, 2, 3, 0, 0.2, 0, 0, 1, 0); glEnable(GL_DEPTH_TEST); ";
const std::string kLit =
    "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); "
    "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){2, 3, 4, 1}); "
    "glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (float[]){0.4, 0.4, 0.4, 1}); "
    "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20); "
    "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.8, 0.2, 0, 0.6}); "
    "glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (float[]){0, 0.2, 0.8, 0.4}); ";
const std::string kQuadric = "GLUquadric *q = gluNewQuadric(); gluQuadricTexture(q, GL_TRUE); ";

const std::vector<std::string>& shapes() {
    static const std::vector<std::string> all = {
        "glutSolidSphere(0.8, 12, 9);",
        "glutSolidCone(0.8, 1.2, 12, 4);",
        "glutSolidCylinder(0.5, 1.1, 12, 4);",
        "glRotatef(40, 1, 0, 0); glutSolidTorus(0.3, 0.6, 9, 12);",
        "glutSolidTorus(0.6, 0.4, 9, 12);",  // its tube meets itself
        "\n#pragma twinlight shape(cylinder, 0.6, 1.1, 12)\n",
        kQuadric + "glRotatef(-60, 1, 0, 0); gluCylinder(q, 0.8, 0.3, 1.1, 12, 4);",
        kQuadric + "glRotatef(-30, 1, 0, 0); gluDisk(q, 0.2, 0.9, 12, 4);",
        kQuadric + "glRotatef(-60, 1, 0, 0); gluPartialDisk(q, 0.2, 0.9, 12, 4, 30, 200);",
        kQuadric + "glRotatef(-60, 1, 0, 0); gluPartialDisk(q, 0, 0.9, 12, 4, 300, -70);",
        kQuadric + "gluQuadricOrientation(q, GLU_INSIDE); glRotatef(70, 1, 1, 0); gluSphere(q, 0.9, 12, 9);",
    };
    return all;
}

struct StateCase {
    const char* name;
    std::string commands;
};
const StateCase kStates[] = {
    {"lit", ""},
    {"unlit", "glDisable(GL_LIGHTING); glColor4f(0.9, 0.6, 0.3, 0.5); "},
    {"directional", "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 2, 3, 0}); "},
    {"local viewer", "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); "},
    {"separate specular", "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR); "},
    {"cone",
     "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 15); glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (float[]){-2, -3, -4}); "
     "glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 4.5); glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2); "},
    {"colour material", "glEnable(GL_COLOR_MATERIAL); glColor3f(0.2, 0.9, 0.4); "},
    {"GL_NORMALIZE", "glEnable(GL_NORMALIZE); glScalef(0.9, 0.9, 0.9); "},
    {"GL_RESCALE_NORMAL, uneven", "glEnable(GL_RESCALE_NORMAL); glScalef(1, 0.5, 1.3); "},
    {"sheared", "glMultMatrixf((float[]){1, 0.3, 0, 0, 0.5, 1, 0, 0, 0, 0.2, 0.7, 0, 0, 0, 0, 1}); "},
    {"mirrored", "glScalef(-1, 1, 1); glEnable(GL_CULL_FACE); "},
    {"front culled", "glEnable(GL_CULL_FACE); glCullFace(GL_FRONT); "},
    {"clockwise", "glFrontFace(GL_CW); "},
    {"both culled", "glEnable(GL_CULL_FACE); glCullFace(GL_FRONT_AND_BACK); "},
    {"clip planes",
     "glClipPlane(GL_CLIP_PLANE0, (double[]){1, 1, 1, 0.1}); glEnable(GL_CLIP_PLANE0); "
     "glClipPlane(GL_CLIP_PLANE3, (double[]){-1, 0.5, 0, 0.4}); glEnable(GL_CLIP_PLANE3); "},
    {"near plane", "glTranslatef(0.5, 1.2, 1.8); "},
    {"from inside", "glTranslatef(0.9, 1.9, 2.7); "},
    {"far plane",
     "glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(40, 1, 1, 3.7); "
     "glMatrixMode(GL_MODELVIEW); "},
    {"parallel",
     "glMatrixMode(GL_PROJECTION); glLoadIdentity(); glOrtho(-1.2, 1.3, -1, 1.5, 0, 10); "
     "glMatrixMode(GL_MODELVIEW); "},
    {"perspective modelview",
     "glMultMatrixf((float[]){1, 0, 0, 0.1, 0, 1, 0, 0.2, 0, 0, 1, 0, 0, 0, 0, 1.1}); "
     "glEnable(GL_FOG); glFogf(GL_FOG_DENSITY, 0.2); "},
    {"fog",
     "glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_START, 2); glFogf(GL_FOG_END, 5); "
     "glFogfv(GL_FOG_COLOR, (float[]){0.5, 0.6, 0.7, 1}); "},
    {"blended", "glDisable(GL_DEPTH_TEST); glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); "},
    {"blended, tested", "glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE); glDepthFunc(GL_LEQUAL); "},
    {"alpha test", "glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_LESS, 0.5); "},
    {"GL_GREATER", "glClearDepth(0); glClear(GL_DEPTH_BUFFER_BIT); glDepthFunc(GL_GREATER); "},
    {"GL_GREATER, no mask",
     "glClearDepth(0); glClear(GL_DEPTH_BUFFER_BIT); glDepthFunc(GL_GREATER); "
     "glDepthMask(GL_FALSE); "},
    {"GL_ALWAYS", "glDepthFunc(GL_ALWAYS); "},
    {"GL_NOTEQUAL", "glDepthFunc(GL_NOTEQUAL); "},
    {"depth range", "glDepthRange(0.8, 0.3); "},
    {"offset", "glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset(3, 20); "},
    {"scissor", "glEnable(GL_SCISSOR_TEST); glScissor(30, 20, 40, 50); glViewport(-10, 5, 110, 90); "},
    {"large",
     "glLoadIdentity(); gluLookAt(1e6, 2e6, 3e6, 0, 2e5, 0, 0, 1, 0); glScalef(1e6, 1e6, 1e6); "
     "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){2e6, 3e6, 4e6, 1}); glMatrixMode(GL_PROJECTION); "
     "glLoadIdentity(); gluPerspective(40, 1, 1e6, 2e7); glMatrixMode(GL_MODELVIEW); "},
    {"far away",
     "glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(0.2, 1, 10, 2000); "
     "glMatrixMode(GL_MODELVIEW); glLoadIdentity(); gluLookAt(250, 500, 750, 0, 0.2, 0, 0, 1, 0); "},
};

std::string texels() {
    std::string text;
    for (int i = 0; i < 64; ++i) text += fmt::format("{:.4f}, ", 0.5 + 0.4 * std::sin(0.7 * i));
    return "glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 8, 8, 0, GL_LUMINANCE, GL_FLOAT, (float[]){" + text +
           "}); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glEnable(GL_TEXTURE_2D); "
           "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE); ";
}

class ExactShader : public ::testing::Test {
  protected:
    // Draws it with both tiers.
    void expect_exact(const std::string& name, const Frame& frame, double tolerance) {
        const Truth truth(frame);
        for (const Tier tier : {Tier::kUniform, Tier::kBaked}) {
            const Image image = renderer_.render(frame, exact(tier));
            const Found found = compare(truth, image, tolerance);
            drawn_ += found.drawn;
            edges_ += found.edges;
            edges_off_ += found.edges_off;
            interiors_off_ += found.interiors_off;
            worst_ = std::max(worst_, found.worst);
            if (found.interiors_off + found.edges_off == 0) continue;
            const std::size_t at = found.worst_pixel;
            fmt::print("{}{}: {} interior pixels off by up to {:.2f} codes, at {},{}; {} of {} edges\n", name,
                       tier == Tier::kBaked ? ", baked" : "", found.interiors_off, found.worst / kCode,
                       static_cast<int>(at) % image.width, static_cast<int>(at) / image.width, found.edges_off,
                       found.edges);
        }
    }

    // Every third of the shapes, others in the next state.
    void expect_shapes(const StateCase& state, std::size_t number, double tolerance) {
        for (std::size_t i = number % 3; i < shapes().size(); i += 3)
            expect_exact(std::string(state.name) + ": " + shapes()[i],
                         frame_of(kCamera + kLit + state.commands + shapes()[i]), tolerance);
    }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(kSide, kSide);
    programmable::Renderer renderer_;
    int drawn_ = 0, edges_ = 0, edges_off_ = 0, interiors_off_ = 0;
    double worst_ = 0;
};

// What is drawn is rounded, the reference's picture is not; floats add little to that.
constexpr double kOpaque = (0.5 + 0.02) * kCode;
// Each of at most four points of a ray is rounded when it is blended, too.
constexpr double kBlended = kOpaque + 4 * 0.5 * kCode;
// llvmpipe's filters have weights of 8 bits: a 256th of what lies between two texels, once a dimension and once between levels.
constexpr double kFiltered = kOpaque + 3 * 0.5 * kCode;
TEST_F(ExactShader, DrawsEveryShapeInEveryStateAsTheReferenceDoes) {
    std::size_t number = 0;
    for (const StateCase& state : kStates) {
        const bool blends = state.commands.find("GL_BLEND") != std::string::npos;
        expect_shapes(state, number++, blends ? kBlended : kOpaque);
    }
    fmt::print("{} pixels drawn, {} edges, {} off; {} interiors off, the worst by {:.2f} codes\n", drawn_, edges_,
               edges_off_, interiors_off_, worst_ / kCode);
    EXPECT_EQ(interiors_off_, 0);
    EXPECT_EQ(edges_off_, 0);
}

// Texture coordinates of the surfaces' own, and how they change: the levels of detail are those of the tangent plane.
TEST_F(ExactShader, HasTheTexturesOfQuadrics) {
    const std::string matrix = "glMatrixMode(GL_TEXTURE); ", back = "glMatrixMode(GL_MODELVIEW); ";
    const std::string mipmaps =
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR); "
        "glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE); ";
    const StateCase states[] = {
        {"linear", texels()},
        {"repeated", texels() + matrix + "glScalef(3, 2, 1); glRotatef(20, 0, 0, 1); " + back},
        {"with q",
         texels() + matrix + "glMultMatrixf((float[]){2, 0, 0, 0.5, 0, 1, 0, 0.3, 0, 0, 1, 0, 0, 0, 0, 1}); " + back},
        {"clamped", texels() + "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP); " + matrix +
                        "glScalef(2, 2, 1); " + back},
        {"mipmaps", mipmaps + texels() + matrix + "glScalef(9, 9, 1); " + back},
        {"replaced", texels() + "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE); "},
        {"one dimension",
         "glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 4, 0, GL_RGB, GL_FLOAT, (float[]){1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, "
         "1}); "
         "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glEnable(GL_TEXTURE_1D); "},
        {"on blended faces",
         texels() + "glDisable(GL_DEPTH_TEST); glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE); "},
    };
    std::size_t number = 0;
    for (const StateCase& state : states) {
        const bool blends = state.commands.find("GL_BLEND") != std::string::npos;
        expect_shapes(state, number++, blends ? kFiltered + kBlended : kFiltered);
    }
    fmt::print("{} pixels drawn, {} edges, {} off; {} interiors off, the worst by {:.2f} codes\n", drawn_, edges_,
               edges_off_, interiors_off_, worst_ / kCode);
    EXPECT_EQ(interiors_off_, 0);
    EXPECT_EQ(edges_off_, 0);
}

// 3.8.8 leaves open how a scale factor is made of the derivatives: the largest of them, their length or their sum. Half a level
// lies between.
Frame at_other_levels(Frame frame, double bias) {
    for (auto& item : frame.items)
        if (Draw* draw = std::get_if<Draw>(&item)) draw->texture.lod_bias += bias;
    return frame;
}

// How far a colour lies outside of what is between two others.
double beyond(const Rgba& color, const Rgba& a, const Rgba& b) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto [low, high] = std::minmax(a[c], b[c]);
        most = std::max(most, static_cast<double>(std::max(low - color[c], color[c] - high)));
    }
    return most;
}

// What is off is of meshes, and so in phong shading, too.
TEST(ExactShaderScenes, DifferFromTheReferenceInMeshesAlone) {
    constexpr int kWidth = 320, kHeight = 240;
    const auto context = make_offscreen_context(kWidth, kHeight);
    programmable::Renderer renderer;
    for (const EmbeddedFile& file : kSceneFiles) {
        const Frame frame = frame_of(std::string(file.text), kWidth, kHeight);
        const Truth truth(frame);
        RenderOptions options = exact(Tier::kUniform);
        const Image picture = renderer.render(frame, options);
        options.shading = Shading::kPhong;
        const Image phong = renderer.render(frame, options), phong_truth = reference::render(frame, options);
        std::array<Image, 2> levels;
        for (std::size_t i = 0; i < 2; ++i)
            levels[i] = reference::render(at_other_levels(frame, i == 0 ? -0.5 : 0.5), {.shading = Shading::kExact});
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            if (apart(phong.pixels[i], phong_truth.pixels[i]) > kFiltered) continue;
            EXPECT_LE(std::min(truth.nearest(i, picture.pixels[i]),
                               beyond(picture.pixels[i], levels[0].pixels[i], levels[1].pixels[i])),
                      kFiltered)
                << file.name << " at " << static_cast<int>(i) % kWidth << "," << static_cast<int>(i) / kWidth;
        }
    }
}

// The depth buffer's, at some pixels of every shape.
TEST_F(ExactShader, WritesTheReferencesDepth) {
    constexpr double kStep = 1.0 / (1 << 24);
    // Half a step of rounding, and a few floats' of a sum that is as large as 1 where depths are small.
    constexpr double kDepth = 6 * kStep;
    // Three times the slope, which grows without a bound towards a silhouette, and its error with its square.
    constexpr double kOffsetDepth = 40 * kStep;
    double worst = 0;
    int compared = 0;
    for (const StateCase& state : kStates)
        for (const char* name :
             {"lit", "far plane", "parallel", "depth range", "offset", "perspective modelview", "far away"}) {
            if (std::strcmp(state.name, name) != 0) continue;
            for (const std::string& shape : shapes()) {
                const Frame frame = frame_of(kCamera + kLit + state.commands + shape);
                const Truth truth(frame);
                renderer_.render(frame, exact(Tier::kUniform));
                for (int y = 3; y < kSide; y += 7)
                    for (int x = 3; x < kSide; x += 7) {
                        if (truth.is_edge(static_cast<std::size_t>((kSide - 1 - y) * kSide + x))) continue;
                        double expected = 1;
                        for (const reference::PixelFragment& fragment :
                             reference::pixel_fragments(frame, {.shading = Shading::kExact}, x, y))
                            if (fragment.passes) expected = fragment.depth;
                        float actual = 0;
                        glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &actual);
                        const double off = std::abs(actual - expected);
                        compared += expected < 1;
                        const bool is_offset = std::strcmp(name, "offset") == 0;
                        EXPECT_LE(off, is_offset ? kOffsetDepth : kDepth)
                            << name << ": " << shape << " at " << x << "," << y;
                        worst = std::max(worst, off);
                    }
            }
        }
    fmt::print("{} depths compared, the worst {:.2f} steps of the buffer off\n", compared, worst * (1 << 24));
    EXPECT_GT(compared, 1000);
}

// In floats, far below what 8 bits show: the surface's shader against the finest mesh of the study.
TEST(ExactShaderFloats, AreOrdersOfMagnitudeNearerThanAFineMesh) {
    constexpr int kWide = 256;
    const auto context = make_offscreen_context(kWide, kWide, ColorBuffer::kFloat);
    programmable::Renderer renderer;
    for (const char* shape : {"glutSolidSphere(0.8, 128, 64);", "glutSolidTorus(0.3, 0.6, 64, 128);",
                              "glutSolidCone(0.8, 1.2, 128, 64);"}) {
        const Frame frame = frame_of(kCamera + kLit + shape, kWide, kWide);
        const Truth truth(frame);
        RenderOptions options = exact(Tier::kUniform);
        const Image surface = renderer.render(frame, options);
        options.shading = Shading::kPhong;
        const Image mesh = renderer.render(frame, options);
        double surface_square = 0, mesh_square = 0, worst = 0;
        int count = 0;
        for (std::size_t i = 0; i < mesh.pixels.size(); ++i) {
            if (truth.is_edge(i) || mesh.pixels[i] == Rgba{} || surface.pixels[i] == Rgba{}) continue;
            const double of_surface = apart(surface.pixels[i], truth.picture().pixels[i]);
            const double of_mesh = apart(mesh.pixels[i], truth.picture().pixels[i]);
            surface_square += of_surface * of_surface;
            mesh_square += of_mesh * of_mesh;
            worst = std::max(worst, of_surface);
            ++count;
        }
        fmt::print("{} {} pixels: rms {:.1e} of the surface, worst {:.1e}; {:.1e} of the mesh: {:.0f} times\n", shape,
                   count, std::sqrt(surface_square / count), worst, std::sqrt(mesh_square / count),
                   std::sqrt(mesh_square / surface_square));
        EXPECT_GT(count, 5000);
        EXPECT_GT(std::sqrt(mesh_square), 500 * std::sqrt(surface_square)) << shape;
    }
}

}  // namespace
}  // namespace twinlight
