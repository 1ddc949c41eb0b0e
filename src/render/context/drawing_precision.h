// How exactly a driver draws, where OpenGL leaves that to it. Found by drawing, so it holds for drivers that nobody has listed.
#pragma once

namespace twinlight {

struct DrawingPrecision {
    // Pixels. Rasterisers round vertices to 2^-GL_SUBPIXEL_BITS of a pixel (3.5.1 leaves it open). One that also interpolates
    // between the rounded vertices gives the right colour of a place that is up to this far away, across and up. 0: it interpolates
    // between the vertices as they are.
    double position = 0;
    // Steps of 1/255. A colour becomes an 8-bit code by rounding to nearest (2.14.9); a driver may take the next code if the
    // colour is up to this far on the other side of the middle. 0: it never does. Graphics chips follow the rule of Direct3D,
    // which allows 0.1.
    double conversion = 0;
    // Whether the driver finds the scale factor rho of a texture by an approximation that 3.8.8 allows. Graphics chips do.
    bool approximates_rho = false;
};

// Measures the driver's fixed function in contexts of its own. No context is current afterwards. Throws std::runtime_error as
// make_offscreen_context() does.
DrawingPrecision measure_drawing_precision();

}  // namespace twinlight
