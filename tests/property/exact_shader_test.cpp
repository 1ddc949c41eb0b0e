// Compares exact surfaces drawn by shaders with those of the reference, pixel by pixel: every shape in many states, and
// the built-in scenes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "../unit/effort.h"
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

// How far a colour is from what the reference allows at a pixel; nothing: it is not checked.
std::optional<double> beyond_allowed(const AllowedDifference& allowed, std::size_t pixel, const Rgba& color,
                                     const Rgba& reference) {
    if (!allowed.is_judged(pixel)) return std::nullopt;
    const Rgba channels = allowed.channels(pixel);
    std::vector<AllowedRange> ranges{{reference, reference}};
    if (allowed.edge[pixel]) ranges = allowed.ranges.at(pixel);
    double least = 1;
    for (const AllowedRange& range : ranges) {
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max({most, static_cast<double>(range.low[c] - channels[c] - color[c]),
                             static_cast<double>(color[c] - range.high[c] - channels[c])});
        least = std::min(least, most);
    }
    return least;
}

// The frame, moved so that a silhouette passes as near by a pixel's centre as halving can tell: the pixels of the row in the middle
// whose colours differ most lie on its two sides.
Frame at_silhouette(const Frame& frame) {
    const auto rendered = [&](double x) {
        return reference::render(shifted(frame, x, 0), {{.shading = Shading::kExact}});
    };
    const Image picture = rendered(0);
    std::size_t at = 0;
    const auto change = [&](std::size_t pixel) { return apart(picture.pixels[pixel], picture.pixels[pixel + 1]); };
    for (std::size_t pixel = picture.index(0, picture.height / 2); pixel + 1 < picture.index(0, picture.height / 2 + 1);
         ++pixel)
        if (change(pixel) > change(at)) at = pixel;
    double low = 0, high = 1;  // to the right: the pixel on the right sees what the left one saw
    for (int i = 0; i < 16; ++i) {
        const double middle = (low + high) / 2;
        const Rgba color = rendered(middle).pixels[at + 1];
        const bool is_right = apart(color, picture.pixels[at + 1]) < apart(color, picture.pixels[at]);
        (is_right ? low : high) = middle;
    }
    return shifted(frame, low, 0);
}

// At a silhouette, too, a pixel has one of few colours: those of the surfaces there, and of what is beneath them. Tried with the
// shaders' pictures, and with the reference's for rays beside the centres.
TEST_F(ExactShader, IsHeldToTheColorsOfItsEdges) {
    int edges = 0, open = 0, off = 0, refused = 0;
    int number = 0;
    for (const StateCase& state : kStates)
        for (const std::string& shape : shapes()) {
            if (!is_tried(number++)) continue;
            const Frame frame = at_silhouette(frame_of(kCamera + kLit + state.commands + shape));
            const Truth truth(frame);
            std::vector<Image> pictures = truth.pictures();
            pictures.push_back(renderer_.render(frame, exact(programmable::Tier::kUniform)));
            const AllowedDifference allowed = reference::allowed_difference(frame, {{.shading = Shading::kExact}});
            for (std::size_t pixel = 0; pixel < allowed.edge.size(); ++pixel) {
                edges += allowed.edge[pixel] ? 1 : 0;
                open += allowed.is_judged(pixel) ? 0 : 1;
                const Rgba& here = truth.picture().pixels[pixel];
                if (allowed.edge[pixel])
                    refused += beyond_allowed(allowed, pixel, {1, 0, 1, 1}, here) > 32 * kCode ? 1 : 0;
                for (const Image& picture : pictures) {
                    const auto beyond = beyond_allowed(allowed, pixel, picture.pixels[pixel], here);
                    if (!beyond || *beyond <= kCode) continue;
                    ++off;
                    fmt::print("{}: {}: {:.2f} codes at {},{}\n", state.name, shape, *beyond / kCode,
                               pixel % kExactSide, pixel / kExactSide);
                }
            }
        }
    fmt::print("{} edges, {} not judged; {} refuse another colour\n", edges, open, refused);
    EXPECT_GT(edges, 60);
    EXPECT_EQ(open, 0);
    EXPECT_EQ(off, 0);
    EXPECT_GE(refused, edges * 9 / 10);
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
