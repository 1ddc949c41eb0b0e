// What the guards of the shaders cost: what keeps them finite where the equation divides by nothing (docs/hard-cases.md), against
// the same texts without.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <regex>
#include <stdexcept>

#include "lit_spheres.h"
#include "ratios.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/effect/plan.h"
#include "render/programmable/shader_program.h"
#include "render/programmable/text/bake.h"
#include "render/programmable/uploaded_mesh.h"
#include "render/stages/fixed_stages.h"
#include "render/stages/textures.h"
#include "ways.h"

namespace twinlight::bench::guards_bench {
namespace {

using namespace programmable;

// ---- The texts without guards ----

struct Guard {
    const char* guarded;
    const char* naive;
};
constexpr Guard kGuards[] = {
    {R"(v / max\(length\(v\), 1e-18\))", "normalize(v)"},
    {R"(divisor > 0\.0 \? 1\.0 / max\(divisor, 1e-37\) : 0\.0)", "1.0 / divisor"},
    {R"(max\(dot\(sum, sum\), 1e-24\))", "dot(sum, sum)"},
    {R"(min\(x, 1e30\))", "x"},
};

// How often each was found.
using Found = std::array<long, std::size(kGuards)>;

std::string without_guards(std::string text, Found& found) {
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::regex guarded(kGuards[i].guarded);
        found[i] += std::distance(std::sregex_iterator(text.begin(), text.end(), guarded), std::sregex_iterator());
        text = std::regex_replace(text, guarded, kGuards[i].naive);
    }
    // The last one is that of a w that is not 1, which none of the scenes has.
    for (const char* limit : {"1e-18", "1e-24", "1e-37", "1e30", "far *"})
        if (text.find(limit) != text.npos)
            throw std::runtime_error(fmt::format("a guard with {} is left in this text:\n{}", limit, text));
    return text;
}

// ---- Drawing ----

// Draws as the renderer does; without guards where `found` is given.
class Drawn {
  public:
    Drawn(const Draw& draw, const programmable::Options& options, Found* found = nullptr)
        : draw_(draw),
          plan_(plan_effects(draw, options)),
          code_(code_for(draw, plan_)),
          numbers_(uniforms(draw, plan_, code_)),
          mesh_(draw, code_.effects, options.patches, code_.origin_object.value_or(glm::dvec3(0))) {
        ShaderSource source = assemble(code_.effects, code_.form);
        if (found) source = {without_guards(source.vertex, *found), without_guards(source.fragment, *found)};
        if (options.tier == programmable::Tier::kBaked) {
            const auto names = uniform_names(source);
            source = with_constants(source,
                                    numbers_.filtered([&](std::size_t i) { return names.contains(numbers_[i].name); }));
        }
        program_ = std::make_unique<ShaderProgram>(source, code_.effects);
    }

    void draw() {
        const FixedStages stages;
        stages.clear({.color = true, .depth = true, .clear_color = glm::dvec4(0), .clear_depth = 1});
        stages.set(draw_.raster, draw_.fragment);
        if (draw_.texture.texture) textures_.bind(draw_.texture);
        program_->use(numbers_);
        mesh_.draw();
        glFinish();
    }

  private:
    Draw draw_;
    Plan plan_;
    Code code_;
    Uniforms numbers_;
    UploadedMesh mesh_;
    std::unique_ptr<ShaderProgram> program_;
    Textures textures_{Clamping::kShader};
};

constexpr int kSide = 512;

// Where nothing is hard guards must change nothing, or the comparison is of something else; but roundings may cross the border of
// a code.
void check_same(Drawn& guarded, Drawn& naive) {
    guarded.draw();
    const Image one = read_pixels(kSide, kSide);
    naive.draw();
    const Image other = read_pixels(kSide, kSide);
    constexpr float kLit = 0.1F;  // the scene's ambient light alone gives 0.04
    bool is_lit = false;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            is_lit = is_lit || one.pixels[i][channel] > kLit;
            if (!(std::abs(one.pixels[i][channel] - other.pixels[i][channel]) < 1.5 / 255))
                throw std::runtime_error(fmt::format("without guards pixel {} is another", i));
        }
    if (!is_lit) throw std::runtime_error("nothing lit is drawn");
}

// How many times as long it takes with guards, over the scenes; of vertices, where nothing is rasterised.
double times_as_long(Results& results, const std::string& stage, const std::vector<LitScene>& scenes,
                     const programmable::Options& options, bool rasterises, Found& found) {
    std::vector<double> ratios;
    for (const LitScene& scene : scenes) {
        const auto guarded = std::make_shared<Drawn>(scene.draw, options);
        const auto naive = std::make_shared<Drawn>(scene.draw, options, &found);
        check_same(*guarded, *naive);
        if (!rasterises) glEnable(GL_RASTERIZER_DISCARD);
        const auto timed = results.compare(
            fmt::format("{}: {}", stage, scene.name),
            {{"with guards", [guarded] { guarded->draw(); }}, {"without", [naive] { naive->draw(); }}}, {.count = 25});
        glDisable(GL_RASTERIZER_DISCARD);
        ratios.push_back(times_faster(timed[1], timed[0]));
    }
    results.ratio("robust_over_naive: " + stage, geometric_mean(ratios));
    return geometric_mean(ratios);
}

void compare_guards(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    std::vector<LitScene> domes = seven_scenes();
    for (LitScene& scene : domes) scene.draw = on_dome(scene.draw, kSide);
    const std::vector<LitScene> spheres = seven_scenes(sphere(512, 256));
    std::vector<double> all;
    Found found{};
    for (const programmable::Tier tier : {programmable::Tier::kUniform, programmable::Tier::kBaked}) {
        const std::string of = tier == programmable::Tier::kBaked ? "baked" : "uniforms";
        all.push_back(
            times_as_long(results, "guards at vertices, " + of, spheres, options_for(tier, true), false, found));
        programmable::Options phong = options_for(tier, false);
        phong.shading = Shading::kPhong;
        all.push_back(times_as_long(results, "guards per fragment, " + of, domes, phong, true, found));
    }
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i] == 0)
            throw std::runtime_error(fmt::format("no shader has the guard {} any more", kGuards[i].guarded));
    results.ratio("robust_over_naive", geometric_mean(all), Bar{1.05, true});
}

const bool added = add_part("guards", compare_guards);

}  // namespace
}  // namespace twinlight::bench::guards_bench
