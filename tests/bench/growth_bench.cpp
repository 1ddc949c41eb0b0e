// How the time for a picture grows with vertices, lights, pixels and draws, for each renderer and for a comparison.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/renderers.h"
#include "ratios.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::growth_bench {
namespace {

// Something that scenes have more and more of.
struct Growth {
    std::string of_what;  // "vertices"
    std::vector<int> counts;
    std::function<std::string(int count)> text;                    // of the scene
    std::function<int(int count)> side = [](int) { return 256; };  // of the picture, in pixels
    bool for_fixed = true;                                         // whether the fixed function can draw so many
    bool for_compare = true;
};

const std::string kCamera =
    "glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
    "glMatrixMode(GL_PROJECTION); gluPerspective(45, 1, 0.1, 100);\n"
    "glMatrixMode(GL_MODELVIEW); gluLookAt(0, 0, 4, 0, 0, 0, 0, 1, 0);\n";

std::string sphere(int vertices) {
    const int slices = static_cast<int>(std::lround(std::sqrt(vertices)));
    return fmt::format("{0}glutSolidSphere(1, {1}, {1});\n", kCamera, slices);
}

// All of them reach the sphere. llvmpipe's shaders have room for 2,048.
std::string lights(int count) {
    std::string text = kCamera;
    for (int i = 0; i < std::min(count, 8); ++i)
        text += fmt::format(
            "glEnable(GL_LIGHT0 + {0}); glLightfv(GL_LIGHT0 + {0}, GL_DIFFUSE, (GLfloat[]){{0.1, 0.1, 0.1, 1}});\n", i);
    for (int i = 8; i < count; ++i)
        text += fmt::format(
            "#pragma twinlight light({0}, GL_DIFFUSE, 0.1, 0.1, 0.1, 1)\n"
            "#pragma twinlight light({0}, GL_POSITION, {1}, 0, 5, 1)\n",
            i, (i % 100) / 100.0);
    return text + "glutSolidSphere(1, 24, 24);\n";
}

// Each at its own place, in its own colour.
std::string squares(int count) {
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    std::string text = kCamera + "glEnable(GL_COLOR_MATERIAL);\n";
    for (int i = 0; i < count; ++i)
        text += fmt::format(
            "glPushMatrix(); glTranslatef({0}, {1}, 0); glColor3f({2}, 0.5, 0.5); glRectf(0, 0, {3}, {3}); "
            "glPopMatrix();\n",
            2.0 * (i % side) / side - 1, 2.0 * (i / side) / side - 1, (i % 10) / 10.0, 1.0 / side);
    return text;
}

const std::vector<Growth>& growths() {
    static const std::vector<Growth> all = {
        {.of_what = "vertices", .counts = {1'000, 10'000, 100'000, 1'000'000}, .text = sphere},
        {.of_what = "lights",
         .counts = {1, 8, 64, 512, 2048},
         .text = lights,
         .for_fixed = false,
         .for_compare = false},
        {.of_what = "pixels",
         .counts = {64 * 64, 256 * 256, 1024 * 1024, 2048 * 2048},
         .text = [](int) { return sphere(1'000); },
         .side = [](int count) { return static_cast<int>(std::lround(std::sqrt(count))); }},
        {.of_what = "draws", .counts = {10, 100, 1'000, 10'000, 100'000}, .text = squares},
    };
    return all;
}

// The seconds of one way for each count.
struct Series {
    std::string name;
    std::vector<double> seconds;
};

std::vector<bench::Way> ways_of(const Growth& growth, const Scene& scene, const cli::RendererSet& set) {
    const compare::Renderers& draw = set.functions();
    std::vector<bench::Way> ways;
    if (growth.for_fixed) ways.push_back({"fixed", [&] { draw.fixed(scene, {}); }});
    ways.push_back({"shaders", [&] { draw.programmable(scene.frame, {}); }});
    // Not through the set, which would keep the picture and not draw it again.
    ways.push_back({"reference", [&] { reference::render(scene.frame, {}); }});
    if (growth.for_compare) ways.push_back({"compare", [&] { compare::compare_scene(scene, {}, draw); }});
    return ways;
}

// The exponent of the growth over the last two decades: 1 if twice as much takes twice as long.
double slope(const std::vector<int>& counts, const std::vector<double>& seconds) {
    std::size_t first = counts.size() - 2;
    while (first > 0 && counts.back() / counts[first] < 100) --first;
    return std::log(seconds.back() / seconds[first]) / std::log(static_cast<double>(counts.back()) / counts[first]);
}

void measure(bench::Results& results, const Growth& growth) {
    std::vector<Series> all;
    for (const int count : growth.counts) {
        if (results.is_quick() && count > 1024) continue;
        const int side = growth.side(count);
        const Scene scene =
            make_scene(std::make_shared<CommandList>(read_scene(growth.text(count), "scene.gl", "scene")),
                       {.width = side, .height = side});
        const cli::RendererSet set(side, side);
        const std::vector<bench::Timed> timed =
            results.compare(fmt::format("{} {}", count, growth.of_what), ways_of(growth, scene, set), {.count = 5});
        all.resize(timed.size());
        for (std::size_t i = 0; i < timed.size(); ++i) {
            all[i].name = timed[i].name;
            all[i].seconds.push_back(timed[i].median());
        }
    }
    if (results.is_quick()) return;
    for (const Series& series : all)
        results.ratio(fmt::format("growth_{}_{}", growth.of_what, series.name), slope(growth.counts, series.seconds),
                      bench::Bar{1.1, true});
}

void measure_growth(bench::Results& results) {
    for (const Growth& growth : growths()) measure(results, growth);
}

const bool added = bench::add_part("growth", measure_growth);

}  // namespace
}  // namespace twinlight::growth_bench
