// One pixel taken apart: which fragments were drawn there, every term of the lighting of each, and which rulings decided it.
//
// In: a Frame and the pixel's window coordinates (y up). Out: its fragments in the order of the commands, with the terms of
// the points that they were lit at: of gouraud shading the primitive's vertices, of flat shading the provoking one, of phong
// shading the fragment itself. The fragments and their colours are the picture's: it is drawn here, one pixel wide.
#pragma once

#include <vector>

#include "base/image/image.h"
#include "lighting/equation.h"
#include "render/reference/draw_lighting.h"
#include "render/reference/reference_options.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

struct LitPoint {
    double weight = 1;  // in the fragment
    LitMaterial material;
    Vec scene_ambient{};
    std::vector<lighting::LightTerms<double>> terms{};  // one for each of PixelFragment::lights
    lighting::Formulas formulas{};                      // of the terms
    Vec primary{}, secondary{};                         // before the clamp
    // The same with the rulings that they come from.
    std::vector<lighting::LightTerms<lighting::Marked>> marked_terms{};
    Vec3<lighting::Marked> marked_primary{}, marked_secondary{};
};

struct PixelFragment {
    std::size_t draw = 0;  // which of the frame's Draws, from 0
    Face face = Face::kFront;
    double depth = 0;
    bool passes = true;  // depth and alpha test; the last that does is seen
    Shading shading = Shading::kGouraud;
    bool is_lit = false;
    std::vector<int> lights{};       // numbers of the enabled lights
    std::vector<LitPoint> points{};  // none where nothing is lit
    glm::dvec4 color{0};             // after clamp, texture, colour sum and fog; before blending
    glm::dvec4 after{0};             // what the picture has after it
    // What the specification leaves open and decided the colour.
    struct Decided {
        lighting::Ruling ruling;
        std::vector<int> lights;  // the numbers of the lights whose terms it decided
    };
    std::vector<Decided> rulings{};
};

struct PixelHistory {
    std::vector<PixelFragment> fragments;
    Rgba color{};  // the picture's
};

PixelHistory pixel_history(const Frame& frame, const Options& options, int x, int y);

// The terms of a fragment: those of its points by their weights. Linear in all but flat shading's one point, so the
// products add up to the colour; factors such as attenuation are means.
LitPoint mean_of(const PixelFragment& fragment);

}  // namespace twinlight::reference
