// One pixel or vertex in detail: which fragments were drawn there, every lighting term of each with the numbers behind
// it, and the rulings that affected it.
//
// In: a Frame and the pixel's window coordinates (y up). Out: its fragments in the order of the commands, with the
// terms of the points where they were lit: the primitive's vertices (gouraud), the provoking vertex (flat), or the
// fragment itself (phong). The fragments and colours are the picture's: this draws a picture of one pixel.
#pragma once

#include <optional>
#include <vector>

#include "base/image/image.h"
#include "lighting/equation.h"
#include "render/reference/textures/color_steps.h"
#include "render/reference/vertices/draw_lighting.h"
#include "render/reference/vertices/reference_options.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

// How a normal reached the equation (2.11.3).
struct NormalSteps {
    Vec object{};        // as the program sent it
    Vec transformed{};   // times the normal matrix
    double rescale = 1;  // the factor of GL_RESCALE_NORMAL; 1 if it is disabled
    double transformed_length() const { return lighting::unit_and_length(transformed).length; }
};

struct LitPoint {
    double weight = 1;                            // its share of the fragment's colour
    Face face = Face::kFront;                     // the back face has the reversed normal and the back material
    std::optional<std::uint32_t> vertex{};        // index into Draw::vertices; empty for a point between vertices
    std::optional<glm::dvec4> position_object{};  // of a vertex
    glm::dvec4 position_eye{0};
    std::optional<NormalSteps> normal_steps{};                // of a vertex
    lighting::SurfacePoint<double> surface{};                 // V and n, as in the equation
    Vec vpe_dir{};                                            // toward the viewer
    std::vector<lighting::LightGeometry<double>> geometry{};  // one for each light
    LitMaterial material;
    Vec scene_ambient{};
    std::vector<lighting::LightTerms<double>> terms{};  // one for each of PixelFragment::lights
    lighting::Formulas formulas{};                      // the formulas of the terms
    Vec primary{}, secondary{};                         // before the clamp
    // The same, with the rulings that they depend on.
    std::vector<lighting::LightTerms<lighting::Marked>> marked_terms{};
    Vec3<lighting::Marked> marked_primary{}, marked_secondary{};
};

struct PixelFragment {
    std::size_t draw = 0;  // index of the Draw in the frame, from 0
    Face face = Face::kFront;
    double depth = 0;
    bool passes = true;  // passes the depth and alpha tests; the last such fragment is visible
    Shading shading = Shading::kGouraud;
    bool is_lit = false;
    std::vector<int> lights{};       // numbers of the enabled lights
    std::vector<LitPoint> points{};  // empty without lighting
    // The vertices of the triangle, line or point, and their shares of the fragment. None on an exact surface.
    struct Corner {
        std::uint32_t vertex;  // index into Draw::vertices
        double weight;
    };
    std::vector<Corner> corners{};
    ColorSteps steps{};   // from the lit colour to `color`
    glm::dvec4 color{0};  // after clamp, texture, colour sum and fog; before blending
    glm::dvec4 after{0};  // the picture's colour after this fragment
    // A ruling (our choice where the specification is silent) that affected the colour.
    struct Decided {
        lighting::Ruling ruling;
        std::vector<int> lights;  // the numbers of the lights whose terms it affected
    };
    std::vector<Decided> rulings{};
};

struct PixelHistory {
    std::vector<PixelFragment> fragments;
    Rgba color{};  // the pixel's final colour
};

PixelHistory pixel_history(const Frame& frame, const Options& options, int x, int y);

// A vertex of a lit Draw, lit for one face.
struct VertexHistory {
    std::vector<int> lights{};  // numbers of the enabled lights
    LitPoint point{};
    std::vector<PixelFragment::Decided> rulings{};
};
VertexHistory vertex_history(const Draw& draw, const Options& options, std::uint32_t vertex, Face face);

// The terms of a fragment: the weighted sum over its points. The products add up to the colour. Factors such as
// attenuation are only means, except in flat shading, which has one point.
LitPoint mean_of(const PixelFragment& fragment);

}  // namespace twinlight::reference
