#include "lit_spheres.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <numbers>

namespace twinlight::bench {
namespace {

glm::dvec4 opaque(double r, double g, double b) { return {r, g, b, 1}; }

LightSource directional(int i) {
    LightSource light;
    light.enabled = true;
    light.diffuse = opaque(0.2, 0.1 + 0.02 * i, 0.25 - 0.02 * i);
    light.position_eye = {std::cos(i), std::sin(i), 1, 0};
    return light;
}

LightSource positional(int i) {
    LightSource light = directional(i);
    light.position_eye = {3 * std::cos(i), 3 * std::sin(i), -2 + 0.3 * i, 1};
    light.linear_attenuation = 0.1;
    light.quadratic_attenuation = 0.02;
    return light;
}

LightSource spot(int i) {
    LightSource light = positional(i);
    light.spot_direction_eye = glm::dvec3(0, 0, -5) - glm::dvec3(light.position_eye);
    light.spot_cutoff_deg = 60;
    light.spot_exponent = 4;
    return light;
}

LightSource shining(LightSource light) {
    light.specular = opaque(0.2, 0.2, 0.2);
    return light;
}

Draw lit(const Draw& mesh) {
    Draw draw = mesh;
    draw.lighting.enabled = true;
    draw.lighting.lights[0] = LightSource{};
    draw.lighting.front.diffuse = draw.lighting.back.diffuse = opaque(0.8, 0.6, 0.4);
    return draw;
}

void make_shiny(Draw& draw) {
    for (Material* material : {&draw.lighting.front, &draw.lighting.back}) {
        material->specular = opaque(0.9, 0.9, 0.9);
        material->shininess = 32;
    }
}

template <class Light>
void put_lights(Draw& draw, int count, const Light& light) {
    for (int i = 0; i < count; ++i) draw.lighting.lights[static_cast<std::size_t>(i)] = light(i);
}

std::shared_ptr<const Texture> checks() {
    constexpr int kSide = 64;
    auto texture = std::make_shared<Texture>();
    TextureImage image{.width = kSide, .height = kSide, .base_format = kGL_RGB, .internal_format = kGL_RGB};
    for (int i = 0; i < kSide * kSide; ++i)
        image.texels.emplace_back((i / 8 + i / (8 * kSide)) % 2 == 0 ? glm::vec4(1) : glm::vec4(0.5, 0.5, 0.5, 1));
    texture->levels.push_back(std::move(image));
    texture->min_filter = kGL_LINEAR;
    return texture;
}

}  // namespace

Draw sphere(int slices, int stacks) {
    Draw draw;
    const auto index = [&](int row, int column) { return static_cast<std::uint32_t>(row * (slices + 1) + column); };
    for (int row = 0; row <= stacks; ++row) {
        for (int column = 0; column <= slices; ++column) {
            const double s = static_cast<double>(column) / slices, t = static_cast<double>(row) / stacks;
            const double theta = std::numbers::pi * t, phi = 2 * std::numbers::pi * s;
            const glm::dvec3 n(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
            draw.vertices.edit().push_back(
                {.position_object = glm::dvec4(n, 1), .normal_object = n, .tex_coord = {s, 1 - t, 0, 1}});
        }
    }
    for (int row = 0; row < stacks; ++row) {
        for (int column = 0; column < slices; ++column) {
            const std::uint32_t a = index(row, column), b = index(row, column + 1);
            const std::uint32_t c = index(row + 1, column), d = index(row + 1, column + 1);
            draw.indices.edit().insert(draw.indices.end(), {a, c, b, b, c, d});
        }
    }
    draw.eye_from_object = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -5));
    draw.clip_from_eye = glm::perspective(glm::radians(40.0), 1.0, 1.0, 10.0);
    draw.raster.depth_test = true;
    draw.raster.viewport = {0, 0, 64, 64};
    return draw;
}

Draw on_dome(Draw draw, int side) {
    constexpr int kCells = 8;
    draw.vertices.edit().clear();
    draw.indices.edit().clear();
    for (int row = 0; row <= kCells; ++row) {
        for (int column = 0; column <= kCells; ++column) {
            const double x = 2.0 * column / kCells - 1, y = 2.0 * row / kCells - 1;
            draw.vertices.edit().push_back({.position_object = {x, y, -0.3 * (x * x + y * y), 1},
                                            .normal_object = glm::normalize(glm::dvec3(0.6 * x, 0.6 * y, 1)),
                                            .tex_coord = {x, y, 0, 1}});
        }
    }
    for (std::uint32_t row = 0; row < kCells; ++row) {
        for (std::uint32_t column = 0; column < kCells; ++column) {
            const std::uint32_t a = row * (kCells + 1) + column, c = a + kCells + 1;
            draw.indices.edit().insert(draw.indices.end(), {a, a + 1, c, c, a + 1, c + 1});
        }
    }
    draw.eye_from_object = glm::dmat4(1);
    draw.eye_from_object[3] = glm::dvec4(0, 0, -2, 1);
    draw.raster.viewport = {0, 0, side, side};
    draw.raster.depth_test = false;  // nothing hides anything
    return draw;
}

std::vector<LitScene> seven_scenes(const Draw& mesh) {
    const Draw plain = lit(mesh);
    Draw shiny = plain;
    make_shiny(shiny);
    std::vector<LitScene> scenes;
    const auto add = [&](const char* name, const Draw& from) -> Draw& {
        scenes.push_back({name, from});
        return scenes.back().draw;
    };
    put_lights(add("1 directional, diffuse", plain), 1, directional);
    Draw& mixed = add("3 mixed: directional, positional, spot", shiny);
    mixed.lighting.lights[0] = shining(directional(0));
    mixed.lighting.lights[1] = positional(1);
    mixed.lighting.lights[2] = shining(spot(2));
    put_lights(add("8 directional, specular", shiny), 8, [](int i) { return shining(directional(i)); });
    Draw& positionals = add("8 positional, attenuated, specular, local viewer", shiny);
    put_lights(positionals, 8, [](int i) { return shining(positional(i)); });
    positionals.lighting.light_model.local_viewer = true;
    Draw& spots = add("the same with spots", shiny);
    put_lights(spots, 8, [](int i) { return shining(spot(i)); });
    spots.lighting.light_model.local_viewer = true;
    Draw& two_sided = add("two-sided: 2 lights, specular", shiny);
    put_lights(two_sided, 2, [](int i) { return shining(positional(i)); });
    two_sided.lighting.light_model.two_side = true;
    two_sided.lighting.back.diffuse = opaque(0.3, 0.4, 0.9);
    Draw& textured = add("1 directional, texture", plain);
    put_lights(textured, 1, directional);
    textured.texture.texture = checks();
    return scenes;
}

std::vector<LitScene> idle_scenes(const Draw& mesh) {
    const Draw plain = lit(mesh);
    std::vector<LitScene> scenes;
    Draw black = plain;
    black.lighting.front.shininess = black.lighting.back.shininess = 32;
    black.lighting.light_model.local_viewer = true;
    put_lights(black, 4, [](int i) { return shining(positional(i)); });
    scenes.push_back({"black specular: 4 positional lights, shininess 32, local viewer", black});
    Draw directionals = plain;
    directionals.lighting.front.shininess = directionals.lighting.back.shininess = 32;
    put_lights(directionals, 4, [](int i) { return shining(directional(i)); });
    scenes.push_back({"black specular, directional: 4 lights, shininess 32", directionals});
    Draw idle = plain;
    make_shiny(idle);
    put_lights(idle, 8, [](int i) {
        LightSource light = shining(positional(i));
        if (i >= 2) light.diffuse = light.specular = opaque(0, 0, 0);
        return light;
    });
    scenes.push_back({"idle lights: 8 enabled, of which 6 are black", idle});
    return scenes;
}

Frame frame_of(const Draw& draw, int side) { return {.width = side, .height = side, .items = {draw}}; }

}  // namespace twinlight::bench
