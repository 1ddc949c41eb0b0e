// Compares exact surfaces drawn by shaders with those of the reference, pixel by pixel: every shape in many states, and
// the built-in scenes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "exact_shader_cases.h"
#include "render/context/context.h"
#include "render/programmable/programmable.h"
#include "scene/scenes/load.h"

namespace twinlight::exact_shader_test {
namespace {

struct Found {
    int drawn = 0, edges = 0, edges_off = 0, interiors_off = 0;
    double worst = 0;  // away from silhouettes
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

std::string texels() {
    std::string text;
    for (int i = 0; i < 64; ++i) text += fmt::format("{:.4f}, ", 0.5 + 0.4 * std::sin(0.7 * i));
    return "glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 8, 8, 0, GL_LUMINANCE, GL_FLOAT, (float[]){" + text +
           "}); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glEnable(GL_TEXTURE_2D); "
           "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE); ";
}

class ExactShader : public ::testing::Test {
  protected:
    // With uniforms; every third scene with constants too.
    void expect_exact(const std::string& name, const Frame& frame, double tolerance) {
        const Truth truth(frame);
        const bool is_third = ++cases_ % 3 == 0;
        for (const programmable::Tier tier : {programmable::Tier::kUniform, programmable::Tier::kBaked}) {
            if (tier == programmable::Tier::kBaked && !is_third) continue;
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
                       tier == programmable::Tier::kBaked ? ", baked" : "", found.interiors_off, found.worst / kCode,
                       static_cast<int>(at) % image.width, static_cast<int>(at) / image.width, found.edges_off,
                       found.edges);
        }
    }

    // Every third shape; the next state has others.
    void expect_shapes(const StateCase& state, std::size_t number, double tolerance) {
        for (std::size_t i = number % 3; i < shapes().size(); i += 3)
            expect_exact(std::string(state.name) + ": " + shapes()[i],
                         frame_of(kCamera + kLit + state.commands + shapes()[i]), tolerance);
    }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(kExactSide, kExactSide);
    programmable::Renderer renderer_;
    int cases_ = 0, drawn_ = 0, edges_ = 0, edges_off_ = 0, interiors_off_ = 0;
    double worst_ = 0;
};

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

TEST_F(ExactShader, OfMatricesWithoutInverseIsEmpty) {
    const Image image = renderer_.render(frame_of(kCamera + "glScalef(1, 0, 1); glutSolidSphere(0.8, 20, 20);"),
                                         exact(programmable::Tier::kUniform));
    for (const Rgba& pixel : image.pixels) EXPECT_EQ(apart(pixel, {}), 0);
}

// Surfaces have their own texture coordinates; the level of detail comes from the tangent plane.
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

// 3.8.8 does not say how the scale factor follows from the derivatives: their largest, their length or their sum. These
// differ by half a level.
Frame at_other_levels(Frame frame, double bias) {
    for (auto& item : frame.items)
        if (Draw* draw = std::get_if<Draw>(&item)) draw->texture.lod_bias += bias;
    return frame;
}

// How far a colour lies outside the range between two others.
double beyond(const Rgba& color, const Rgba& a, const Rgba& b) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto [low, high] = std::minmax(a[c], b[c]);
        most = std::max(most, static_cast<double>(std::max(low - color[c], color[c] - high)));
    }
    return most;
}

// The difference comes from meshes, so phong shading has it too.
TEST(ExactShaderScenes, DifferFromTheReferenceInMeshesAlone) {
    constexpr int kWidth = 320, kHeight = 240;
    const auto context = make_offscreen_context(kWidth, kHeight);
    programmable::Renderer renderer;
    for (const EmbeddedFile& file : kSceneFiles) {
        const Frame frame = make_frame(read_built_in(file), {.width = kWidth, .height = kHeight});
        const Truth truth(frame);
        programmable::Options options = exact(programmable::Tier::kUniform);
        const Image picture = renderer.render(frame, options);
        options.shading = Shading::kPhong;
        const Image phong = renderer.render(frame, options),
                    phong_truth = reference::render(frame, reference::Options{options});
        std::array<Image, 2> levels;
        for (std::size_t i = 0; i < 2; ++i)
            levels[i] = reference::render(at_other_levels(frame, i == 0 ? -0.5 : 0.5), {{.shading = Shading::kExact}});
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            if (apart(phong.pixels[i], phong_truth.pixels[i]) > kFiltered) continue;
            EXPECT_LE(std::min(truth.nearest(i, picture.pixels[i]),
                               beyond(picture.pixels[i], levels[0].pixels[i], levels[1].pixels[i])),
                      kFiltered)
                << file.name << " at " << static_cast<int>(i) % kWidth << "," << static_cast<int>(i) / kWidth;
        }
    }
}

}  // namespace
}  // namespace twinlight::exact_shader_test
