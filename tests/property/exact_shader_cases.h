// The scenes that compare exact surfaces of the shaders with those of the reference, and the comparison.
//
// Where the visible surface changes within a thousandth of a pixel (near a silhouette, for example), a pixel may show
// what a ray slightly beside its centre shows. Such pixels are counted separately and must match one of these rays.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "render/programmable/numbers/shader_options.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight {

inline constexpr int kExactSide = 48;
inline constexpr double kCode = 1.0 / 255;

inline Frame frame_of(const std::string& text, int width = kExactSide, int height = kExactSide) {
    const auto scene = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
    return make_frame(*scene, {.width = width, .height = height});
}

inline programmable::Options exact(programmable::Tier tier) {
    programmable::Options options;
    options.shading = Shading::kExact;
    options.budget = 0;
    options.tier = tier;
    return options;
}

inline double apart(const Rgba& a, const Rgba& b) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, static_cast<double>(std::abs(a[c] - b[c])));
    return most;
}

// The frame, moved by a part of a pixel.
inline Frame shifted(Frame frame, double x, double y) {
    for (auto& item : frame.items)
        if (Draw* draw = std::get_if<Draw>(&item)) {
            const Rectangle& viewport = draw->raster.viewport;
            draw->clip_from_eye = glm::translate(glm::dmat4(1), {2 * x / viewport.width, 2 * y / viewport.height, 0}) *
                                  draw->clip_from_eye;
        }
    return frame;
}

// The reference's picture, and its pictures for rays slightly beside the centres.
class Truth {
  public:
    explicit Truth(const Frame& frame) {
        constexpr double kStep = 1e-3;
        for (const auto& [x, y] : {std::pair(0.0, 0.0), {kStep, 0.0}, {-kStep, 0.0}, {0.0, kStep}, {0.0, -kStep}})
            pictures_.push_back(reference::render(shifted(frame, x, y), {{.shading = Shading::kExact}}));
    }
    const std::vector<Image>& pictures() const { return pictures_; }
    const Image& picture() const { return pictures_.front(); }
    bool is_edge(std::size_t pixel) const {
        return std::ranges::any_of(
            pictures_, [&](const Image& p) { return apart(p.pixels[pixel], picture().pixels[pixel]) > kCode / 2; });
    }
    double nearest(std::size_t pixel, const Rgba& color) const {
        double least = 1;
        for (const Image& p : pictures_) least = std::min(least, apart(p.pixels[pixel], color));
        return least;
    }

  private:
    std::vector<Image> pictures_;
};

// ---- The scenes of these tests ----

inline const std::string kCamera =
    "glMatrixMode(GL_PROJECTION); gluPerspective(40, 1, 1, 20); glMatrixMode(GL_MODELVIEW); "
    "gluLookAt(1, 2, 3, 0, 0.2, 0, 0, 1, 0); glEnable(GL_DEPTH_TEST); ";
inline const std::string kLit =
    "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); "
    "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){2, 3, 4, 1}); "
    "glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (float[]){0.4, 0.4, 0.4, 1}); "
    "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20); "
    "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.8, 0.2, 0, 0.6}); "
    "glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (float[]){0, 0.2, 0.8, 0.4}); ";
inline const std::string kQuadric = "GLUquadric *q = gluNewQuadric(); gluQuadricTexture(q, GL_TRUE); ";

inline const std::vector<std::string>& shapes() {
    static const std::vector<std::string> all = {
        "glutSolidSphere(0.8, 12, 9);",
        "glutSolidCone(0.8, 1.2, 12, 4);",
        "glutSolidCylinder(0.5, 1.1, 12, 4);",
        "glRotatef(40, 1, 0, 0); glutSolidTorus(0.3, 0.6, 9, 12);",
        "glutSolidTorus(0.6, 0.4, 9, 12);",  // the tube intersects itself
        "\n#pragma twinlight shape(cylinder, 0.6, 1.1, 12)\n",
        kQuadric + "glRotatef(-60, 1, 0, 0); gluCylinder(q, 0.8, 0.3, 1.1, 12, 4);",
        kQuadric + "glRotatef(-30, 1, 0, 0); gluDisk(q, 0.2, 0.9, 12, 4);",
        kQuadric + "glRotatef(-60, 1, 0, 0); gluPartialDisk(q, 0.2, 0.9, 12, 4, 30, 200);",
        kQuadric + "glRotatef(-60, 1, 0, 0); gluPartialDisk(q, 0, 0.9, 12, 4, 300, -70);",
        kQuadric + "gluQuadricOrientation(q, GLU_INSIDE); glRotatef(70, 1, 1, 0); gluSphere(q, 0.9, 12, 9);",
    };
    return all;
}

struct StateCase {
    const char* name;
    std::string commands;
};
inline const StateCase kStates[] = {
    {"lit", ""},
    {"unlit", "glDisable(GL_LIGHTING); glColor4f(0.9, 0.6, 0.3, 0.5); "},
    {"directional", "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 2, 3, 0}); "},
    {"local viewer", "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); "},
    {"separate specular", "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR); "},
    {"cone",
     "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 15); glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (float[]){-2, -3, -4}); "
     "glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 4.5); glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2); "},
    {"colour material", "glEnable(GL_COLOR_MATERIAL); glColor3f(0.2, 0.9, 0.4); "},
    {"GL_NORMALIZE", "glEnable(GL_NORMALIZE); glScalef(0.9, 0.9, 0.9); "},
    {"GL_RESCALE_NORMAL, uneven", "glEnable(GL_RESCALE_NORMAL); glScalef(1, 0.5, 1.3); "},
    {"sheared", "glMultMatrixf((float[]){1, 0.3, 0, 0, 0.5, 1, 0, 0, 0, 0.2, 0.7, 0, 0, 0, 0, 1}); "},
    {"mirrored", "glScalef(-1, 1, 1); glEnable(GL_CULL_FACE); "},
    {"front culled", "glEnable(GL_CULL_FACE); glCullFace(GL_FRONT); "},
    {"clockwise", "glFrontFace(GL_CW); "},
    {"both culled", "glEnable(GL_CULL_FACE); glCullFace(GL_FRONT_AND_BACK); "},
    {"clip planes",
     "glClipPlane(GL_CLIP_PLANE0, (double[]){1, 1, 1, 0.1}); glEnable(GL_CLIP_PLANE0); "
     "glClipPlane(GL_CLIP_PLANE3, (double[]){-1, 0.5, 0, 0.4}); glEnable(GL_CLIP_PLANE3); "},
    {"near plane", "glTranslatef(0.5, 1.2, 1.8); "},
    {"from inside", "glTranslatef(0.9, 1.9, 2.7); "},
    {"far plane",
     "glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(40, 1, 1, 3.7); "
     "glMatrixMode(GL_MODELVIEW); "},
    {"parallel",
     "glMatrixMode(GL_PROJECTION); glLoadIdentity(); glOrtho(-1.2, 1.3, -1, 1.5, 0, 10); "
     "glMatrixMode(GL_MODELVIEW); "},
    {"perspective modelview",
     "glMultMatrixf((float[]){1, 0, 0, 0.1, 0, 1, 0, 0.2, 0, 0, 1, 0, 0, 0, 0, 1.1}); "
     "glEnable(GL_FOG); glFogf(GL_FOG_DENSITY, 0.2); "},
    {"fog",
     "glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_START, 2); glFogf(GL_FOG_END, 5); "
     "glFogfv(GL_FOG_COLOR, (float[]){0.5, 0.6, 0.7, 1}); "},
    {"blended", "glDisable(GL_DEPTH_TEST); glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); "},
    {"blended, tested", "glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE); glDepthFunc(GL_LEQUAL); "},
    {"alpha test", "glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_LESS, 0.5); "},
    {"GL_GREATER", "glClearDepth(0); glClear(GL_DEPTH_BUFFER_BIT); glDepthFunc(GL_GREATER); "},
    {"GL_GREATER, no mask",
     "glClearDepth(0); glClear(GL_DEPTH_BUFFER_BIT); glDepthFunc(GL_GREATER); "
     "glDepthMask(GL_FALSE); "},
    {"GL_ALWAYS", "glDepthFunc(GL_ALWAYS); "},
    {"GL_NOTEQUAL", "glDepthFunc(GL_NOTEQUAL); "},
    {"depth range", "glDepthRange(0.8, 0.3); "},
    {"offset", "glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset(3, 20); "},
    {"scissor", "glEnable(GL_SCISSOR_TEST); glScissor(15, 10, 20, 25); glViewport(-5, 3, 55, 45); "},
    {"large",
     "glLoadIdentity(); gluLookAt(1e6, 2e6, 3e6, 0, 2e5, 0, 0, 1, 0); glScalef(1e6, 1e6, 1e6); "
     "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){2e6, 3e6, 4e6, 1}); glMatrixMode(GL_PROJECTION); "
     "glLoadIdentity(); gluPerspective(40, 1, 1e6, 2e7); glMatrixMode(GL_MODELVIEW); "},
    {"far away",
     "glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(0.2, 1, 900, 1000); "
     "glMatrixMode(GL_MODELVIEW); glLoadIdentity(); gluLookAt(250, 500, 750, 0, 0.2, 0, 0, 1, 0); "},
};

// ---- Tolerances ----

// The shader's picture is rounded to 8 bits, the reference's is not; floats add little.
inline constexpr double kOpaque = (0.5 + 0.02) * kCode;
// Blending rounds each of at most four points of a ray again.
inline constexpr double kBlended = kOpaque + 4 * 0.5 * kCode;
// llvmpipe's filters have weights of 8 bits: an error of 1/256 for each dimension, and one between levels.
inline constexpr double kFiltered = kOpaque + 3 * 0.5 * kCode;

}  // namespace twinlight
