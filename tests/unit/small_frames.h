// Frames built by hand for the tests of the reference: small windows in which one unit of object space is one pixel.
#pragma once

#include <cstdint>
#include <glm/ext/matrix_clip_space.hpp>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

#include "render/reference/reference.h"

namespace twinlight {

inline constexpr glm::dvec4 kRed{1, 0, 0, 1}, kGreen{0, 1, 0, 1}, kBlue{0, 0, 1, 1}, kWhite{1, 1, 1, 1};
inline constexpr glm::dvec4 kNothingDrawn{0, 0, 0, 0};  // what a frame starts from

// A vertex at (x, y, z) with its colour. z = 0 is the near plane, z = -1 the far one: window depth is -z.
inline Vertex vertex(double x, double y, const glm::dvec4& color = kWhite, double z = 0) {
    return {.position_object = {x, y, z, 1}, .color = color};
}

// Unlit, no depth test, a viewport of the whole window.
inline Draw window_draw(int width, int height, Enum mode, std::vector<Vertex> vertices) {
    Draw draw;
    draw.mode = mode;
    draw.vertices = std::move(vertices);
    draw.raster.viewport = {0, 0, width, height};
    draw.clip_from_eye = glm::ortho<double>(0, width, 0, height, 0, 1);
    return draw;
}

inline Frame frame_of(int width, int height, std::initializer_list<Draw> draws) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    for (const Draw& draw : draws) frame.items.emplace_back(draw);
    return frame;
}

// The colour of a pixel; y up, as GL counts.
inline glm::dvec4 pixel(const Image& image, int x, int y) {
    const Rgba& c = image.at(x, image.height - 1 - y);
    return {c[0], c[1], c[2], c[3]};
}

// ---- A window of 16 x 16 ----

inline constexpr int kSize = 16;

inline Image draw_window(std::initializer_list<Draw> draws, const reference::Options& options = {}) {
    return reference::render(frame_of(kSize, kSize, draws), options);
}

using Pixels = std::set<std::pair<int, int>>;

inline Pixels drawn(const Image& image) {
    Pixels pixels;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (pixel(image, x, y) != kNothingDrawn) pixels.insert({x, y});
    return pixels;
}

inline Pixels rectangle(int x0, int y0, int x1, int y1) {
    Pixels pixels;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) pixels.insert({x, y});
    return pixels;
}

inline Draw quad(double x0, double y0, double x1, double y1, const glm::dvec4& color = kWhite, double z = 0) {
    return window_draw(
        kSize, kSize, kGL_QUADS,
        {vertex(x0, y0, color, z), vertex(x1, y0, color, z), vertex(x1, y1, color, z), vertex(x0, y1, color, z)});
}

// Fills the window at one depth.
inline Draw deep_quad(const glm::dvec4& color, double depth, Enum depth_func = kGL_LESS) {
    Draw draw = quad(0, 0, 16, 16, color, -depth);
    draw.raster.depth_test = true;
    draw.raster.depth_func = depth_func;
    return draw;
}

}  // namespace twinlight
