// What the surface itself costs in a shader, against meshes that come near to it, all lit at every pixel.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "lit_spheres.h"
#include "render/context/context.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/reader.h"
#include "scene/state/state.h"
#include "ways.h"

namespace twinlight::bench::exact_bench {
namespace {

constexpr int kSide = 512;

const char* const kState =
    "glMatrixMode(GL_PROJECTION); gluPerspective(40, 1, 1, 20); glMatrixMode(GL_MODELVIEW); "
    "gluLookAt(0, -3.5, 2, 0, 0, 0, 0, 0, 1); glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); "
    "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); glLightfv(GL_LIGHT0, GL_POSITION, (float[]){2, -3, 4, 1}); "
    "glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1); glMaterialf(GL_FRONT, GL_SHININESS, 40); "
    "glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.8, 0.8, 0.8, 1}); ";

Frame frame_with(const std::string& shape) {
    const auto scene = std::make_shared<const CommandList>(read_scene(kState + shape, "scene.gl", "scene"));
    return make_frame(*scene, {.width = kSide, .height = kSide});
}

// A shape that freeglut sends as many strips, as one Draw of triangles that share vertices: the fastest that a mesh is drawn.
Frame as_one_draw(const Frame& frame) {
    Frame result = frame;
    result.items.clear();
    Draw all = std::get<Draw>(frame.items.front());
    all.vertices.edit().clear();
    all.indices.edit().clear();
    all.mode = kGL_TRIANGLES;
    std::map<std::array<double, 6>, std::uint32_t> numbers;  // by position and normal
    for (const auto& item : frame.items) {
        const Draw& part = std::get<Draw>(item);
        const auto add = [&](std::size_t i) {
            const Vertex& v = part.vertices[part.index(i)];
            const auto &p = v.position_object, &n = glm::dvec4(v.normal_object, 0);
            const auto [known, is_new] =
                numbers.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, static_cast<std::uint32_t>(all.vertices.size()));
            if (is_new) all.vertices.edit().push_back(v);
            all.indices.edit().push_back(known->second);
        };
        const auto add_triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
            for (const std::size_t i : {a, b, c}) add(i);
        };
        for (std::size_t i = 0; i + 2 < part.count(); ++i) {
            if (part.mode == kGL_TRIANGLES && i % 3 == 0) add_triangle(i, i + 1, i + 2);
            if (part.mode == kGL_TRIANGLE_FAN) add_triangle(0, i + 1, i + 2);
            if (part.mode == kGL_TRIANGLE_STRIP || part.mode == kGL_QUAD_STRIP)
                add_triangle(i, i + 1 + i % 2, i + 2 - i % 2);
        }
    }
    result.items.emplace_back(std::move(all));
    return result;
}

double rms(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum += std::pow(a.pixels[i][c] - b.pixels[i][c], 2);
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

void compare_shape(Results& results, const std::string& name, const std::string& exact_shape,
                   const std::function<std::string(int slices)>& shape_of) {
    const auto context = make_offscreen_context(kSide, kSide, ColorBuffer::kFloat);
    const Frame exact = frame_with(exact_shape);
    const Image truth = reference::render(exact, {{.shading = Shading::kExact}});
    const std::vector<int> slices = {16, 32, 64, 128, 256};
    std::vector<Way> ways = {shader_way("exact, uniforms", exact, programmable::Tier::kUniform, false, Shading::kExact),
                             shader_way("exact, baked", exact, programmable::Tier::kBaked, false, Shading::kExact)};
    for (const int n : slices)
        ways.push_back(shader_way(fmt::format("phong, uniforms, {} slices", n), as_one_draw(frame_with(shape_of(n))),
                                  programmable::Tier::kUniform, true, Shading::kPhong));
    std::vector<double> errors;
    for (const Way& way : ways) {
        way.run();
        errors.push_back(rms(read_pixels(kSide, kSide), truth));
    }
    const std::vector<Timed> times = results.compare("exact: " + name, ways);
    const std::size_t fine = 2 + static_cast<std::size_t>(std::ranges::find(slices, 128) - slices.begin());
    results.ratio("exact_over_phong_128_" + name, times_faster(times[0], times[fine]));
    results.ratio("exact_baked_over_phong_128_" + name, times_faster(times[1], times[fine]));
    results.ratio("exact_accuracy_over_phong_128_" + name, errors[fine] / errors[0], Bar{1e4});
}

void compare_exact(Results& results) {
    compare_shape(results, "sphere", "glutSolidSphere(1, 16, 8);",
                  [](int n) { return fmt::format("glutSolidSphere(1, {}, {});", n, n / 2); });
    compare_shape(results, "cone", "glutSolidCone(0.8, 1.2, 16, 8);",
                  [](int n) { return fmt::format("glutSolidCone(0.8, 1.2, {}, {});", n, n / 4); });
    compare_shape(results, "torus", "glutSolidTorus(0.35, 0.8, 16, 16);",
                  [](int n) { return fmt::format("glutSolidTorus(0.35, 0.8, {}, {});", n / 2, n); });
}

const bool added = add_part("exact", compare_exact);

}  // namespace
}  // namespace twinlight::bench::exact_bench
