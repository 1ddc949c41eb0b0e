// Which rulings (our choices where the specification is silent) affect a pixel, as `twinlight explain --pixel` shows
// them (docs/hard-cases.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "judge/check/case.h"
#include "render/reference/pixel_history.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::reference::rulings_test {
namespace {

using lighting::Ruling;
using Rulings = std::set<Ruling>;

Frame frame_of(const std::shared_ptr<const CommandList>& scene) {
    return make_frame(*scene, {.width = check::kSide, .height = check::kSide});
}

// The rulings of the fragments at a pixel of a 64 x 64 picture, y up.
Rulings rulings_at(const Frame& frame, int x, int y, const reference::Options& options = {}) {
    Rulings rulings;
    for (const PixelFragment& fragment : pixel_history(frame, options, x, y).fragments)
        for (const PixelFragment::Decided& decided : fragment.rulings) rulings.insert(decided.ruling);
    return rulings;
}

std::string told(const Rulings& rulings) {
    std::string text;
    for (const Ruling ruling : rulings) text += std::string(lighting::text_of(ruling).state) + "; ";
    return text;
}

TEST(DecidingRulings, AreToldOfHardCases) {
    const std::pair<Rulings, std::vector<std::string>> expected[] = {
        {{Ruling::kLightAtVertex}, {"light-at-vertex", "light-at-vertex-in-cone", "light-direction-zero"}},
        {{Ruling::kAttenuation}, {"attenuation-0-0-0"}},
        {{Ruling::kLightAtVertex, Ruling::kAttenuation}, {"light-at-vertex-quadratic", "light-at-vertex-without-k0"}},
        {{Ruling::kZeroNormal}, {"normal-zero-normalized"}},
        {{}, {"normal-zero", "vertex-w-0", "vertex-w-0-directional", "vertex-w-0-spot"}},
        {{Ruling::kSingularModelview}, {"modelview-singular"}},
        {{Ruling::kAtInfinity}, {"vertex-w-0-attenuated"}},
        {{Ruling::kOppositeHalfVector}, {"highlight-opposite", "viewer-local-opposite"}},
        {{Ruling::kSquares}, {"light-far-1e30", "light-near-1e-30", "normal-1e30-normalized", "spot-direction-1e-30"}},
        {{Ruling::kSpotBorder}, {"spot-0-on-axis", "spot-90-at-edge"}},
        {{Ruling::kRescaled}, {"rescale-uneven", "normal-length-2-rescaled"}},
        {{Ruling::kZeroSpotDirection}, {"spot-direction-zero"}},
        {{Ruling::kVertexAtEye}, {"viewer-local-at-vertex"}},
        {{Ruling::kFarFromOrigin}, {"camera-1e6-turned", "camera-1e8"}},
    };
    for (const auto& [those, names] : expected)
        for (const check::Case& of : check::load_cases(names)) {
            const Rulings rulings = rulings_at(of.carried_out(check::kSide).scene.frame, 8, 8);
            EXPECT_EQ(rulings, those) << of.name << ": " << told(rulings);
        }
}

// A quadrilateral that fills the picture, after `state`; GL_LIGHT0 is on.
constexpr const char* kCorners =
    "glVertex3f(-1, -1, 0); glVertex3f(1, -1, 0); glVertex3f(1, 1, 0); glVertex3f(-1, 1, 0);";
Rulings rulings_under(const std::string& state, const std::string& corners = kCorners,
                      const reference::Options& options = {}) {
    const std::string text =
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n" + state + "\nglBegin(GL_QUADS); " + corners + " glEnd();\n";
    return rulings_at(frame_of(std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"))), 8, 8,
                      options);
}

TEST(DecidingRulings, AreToldOfStatesWithoutAHardCase) {
    const std::string spot =
        "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){-0.734375, -0.734375, 1, 1});\n"  // in front of the pixel
        "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);\n";
    EXPECT_EQ(rulings_under(spot + "#pragma twinlight spot_cone(GL_LIGHT0, 20, 20)"), Rulings{Ruling::kEqualCones});
    EXPECT_EQ(rulings_under(spot + "#pragma twinlight spot_cone(GL_LIGHT0, 20, 25)"), Rulings{});

    const std::string shiny =
        "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});\n"
        "glMaterialf(GL_FRONT, GL_SHININESS, 128); glNormal3f(0, 0, 1e10);";
    EXPECT_EQ(rulings_under(shiny), Rulings{});  // 1e1280, which is clamped
    const std::string both = "glEnable(GL_LIGHT1); glLightfv(GL_LIGHT1, GL_SPECULAR, (GLfloat[]){-1, -1, -1, 1});\n";
    EXPECT_EQ(rulings_under(both + shiny), Rulings{Ruling::kNoNumber});

    const std::string fog = "glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_START, 0.5);\n";
    EXPECT_EQ(rulings_under(fog + "glFogf(GL_FOG_END, 0.5);"), Rulings{Ruling::kFogWithoutDepth});
    EXPECT_EQ(rulings_under(fog + "glFogf(GL_FOG_END, 2);"), Rulings{});

    const auto textured = [](const char* format, const char* mode) {
        return fmt::format(
            "glEnable(GL_TEXTURE_2D); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
            "glTexImage2D(GL_TEXTURE_2D, 0, {0}, 1, 1, 0, {0}, GL_UNSIGNED_BYTE, (GLubyte[4]){{128}});\n"
            "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {1});\n",
            format, mode);
    };
    EXPECT_EQ(rulings_under(textured("GL_LUMINANCE", "GL_DECAL")), Rulings{Ruling::kDecal});
    EXPECT_EQ(rulings_under(textured("GL_LUMINANCE", "GL_MODULATE")), Rulings{});
    const std::string texture = textured("GL_LUMINANCE", "GL_MODULATE");
    EXPECT_EQ(rulings_under(texture + "glTexCoord4f(0.5, 0.5, 0, 0);"), Rulings{Ruling::kZeroQuotient});
    EXPECT_EQ(rulings_under(texture + "glTexCoord2f(1e16, 0.5);"), Rulings{Ruling::kUncountable});
    const std::string depths =
        "glEnable(GL_TEXTURE_2D); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 2, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){0.2, "
        "0.6});\n";
    EXPECT_EQ(rulings_under(depths + "glTexCoord3f(0.4, 0.5, 0.5);"), Rulings{Ruling::kMixedOutcomes});
    EXPECT_EQ(rulings_under(depths + "glTexCoord3f(0.4, 0.5, 0.1);"), Rulings{});
}

// Only fog, which depends on the distance from the eye; and points of surfaces, which are not vertices.
TEST(DecidingRulings, AreToldOfPositionsWhereverTheyCount) {
    const std::string
        moved = "glTranslatef(0, 0, -1e8);\n",
        far_corners = "glVertex3f(-1, -1, 1e8); glVertex3f(1, -1, 1e8); glVertex3f(1, 1, 1e8); glVertex3f(-1, 1, 1e8);";
    const std::string unlit = "glDisable(GL_LIGHTING);\n" + moved;
    const std::string fog =
        "glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_START, -1); glFogf(GL_FOG_END, 1);\n"
        "glFogfv(GL_FOG_COLOR, (GLfloat[]){0, 0, 0, 1});\n";
    EXPECT_EQ(rulings_under(unlit + fog, far_corners), Rulings{Ruling::kFarFromOrigin});
    EXPECT_EQ(rulings_under(unlit, far_corners), Rulings{});
    EXPECT_EQ(rulings_under("glDisable(GL_LIGHTING);\n" + fog), Rulings{});

    reference::Options exact;
    exact.shading = Shading::kExact;
    const auto sphere = [&](const std::string& state, const std::string& radius) {
        const std::string text =
            "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n" + state + "glutSolidSphere(" + radius + ", 16, 16);\n";
        return rulings_at(frame_of(std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"))), 32, 32,
                          exact);
    };
    const std::string light = "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 2, 1});\n";
    EXPECT_EQ(sphere(light, "0.5"), Rulings{});
    EXPECT_EQ(sphere(light + "glTranslatef(0, 0, -1e4);\n", "1e4"), Rulings{Ruling::kFarFromOrigin});
}

TEST(DecidingRulings, AreToldOfWhatIsLitPerPixel) {
    reference::Options phong;
    phong.shading = Shading::kPhong;
    EXPECT_EQ(rulings_under("glNormal3f(0, 0, 0);", kCorners, phong), Rulings{Ruling::kZeroNormal});
    EXPECT_EQ(rulings_under("", kCorners, phong), Rulings{});
    // The pixel's own position, which is not a vertex.
    const std::string at_pixel = "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){-0.734375, -0.734375, 0, 1});";
    EXPECT_EQ(rulings_under(at_pixel, kCorners, phong), Rulings{Ruling::kLightAtVertex});
    EXPECT_EQ(rulings_under(at_pixel), Rulings{});
}

// Rulings that a colour does not depend on are not listed.
TEST(DecidingRulings, AreNotToldWhereTheirTermsAreMultipliedAway) {
    const std::string at_corner = "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){-1, -1, 0, 1});\n";
    EXPECT_EQ(rulings_under(at_corner), Rulings{Ruling::kLightAtVertex});
    EXPECT_EQ(rulings_under(at_corner + "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0, 0, 0, 1});"), Rulings{});
    EXPECT_EQ(rulings_under(at_corner + "glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){0, 0, 0, 1});"), Rulings{});
    EXPECT_EQ(rulings_under(at_corner + "glDisable(GL_LIGHTING);"), Rulings{});
    const std::string replaced =
        "glEnable(GL_TEXTURE_2D); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[4]){128});\n"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);";
    EXPECT_EQ(rulings_under(at_corner + replaced), Rulings{});
}

TEST(DecidingRulings, NameTheLights) {
    const std::string text =
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT3);\n"
        "glLightfv(GL_LIGHT3, GL_POSITION, (GLfloat[]){0, 0, 0, 1});\n"
        "glLightfv(GL_LIGHT3, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});\n"
        "glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();";
    const Frame frame = frame_of(std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene")));
    const std::vector<PixelFragment> fragments = pixel_history(frame, {}, 32, 32).fragments;
    ASSERT_EQ(fragments.size(), 1u);
    ASSERT_EQ(fragments[0].rulings.size(), 1u);
    EXPECT_EQ(fragments[0].rulings[0].ruling, Ruling::kLightAtVertex);
    EXPECT_EQ(fragments[0].rulings[0].lights, std::vector<int>{3});
}

TEST(DecidingRulings, AreNotOfOrdinaryScenes) {
    for (const char* name : {"commands", "lab", "legacy", "report", "spectral"}) {
        const Frame frame = frame_of(load_commands(name));
        for (const int x : {10, 24, 32, 40, 54}) {
            const Rulings rulings = rulings_at(frame, x, 32);
            EXPECT_TRUE(rulings.empty()) << name << ": " << told(rulings);
        }
    }
}

}  // namespace
}  // namespace twinlight::reference::rulings_test
