// A known bug is named only on the drivers and versions where it was seen.
#include <gtest/gtest.h>

#include <algorithm>

#include "judge/compare/departures.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::compare::known_departures_test {
namespace {

Driver driver(const std::string& renderer, const std::string& version) {
    return parse_driver_name(renderer + ", 4.5 (Compatibility Profile) " + version + ", OSMesa");
}
const Driver kLlvmpipe = driver("llvmpipe (LLVM 15.0.6, 256 bits)", "Mesa 22.3.6");
const Driver kSoftpipe = driver("softpipe", "Mesa 22.3.6");

std::vector<std::string_view> names_of(const std::string& text, const Driver& driver) {
    std::vector<std::string_view> names;
    const auto scene = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
    for (const Departure* departure : known_departures_in(make_scene(scene, {}), driver))
        names.push_back(departure->name);
    return names;
}

using Names = std::vector<std::string_view>;

const std::string kSpot = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);";
const std::string kSpotOnCube = kSpot + "glutSolidCube(1);";
const std::string kWideLine = "glLineWidth(5); glBegin(GL_LINES); glVertex2f(0, 0); glVertex2f(1, 0); glEnd();";

TEST(KnownDepartures, AreThoseOfTheFrame) {
    EXPECT_EQ(names_of(kSpotOnCube, kLlvmpipe), Names{"shininess 0 with attenuation or a spot"});
    EXPECT_EQ(names_of(kSpot + "glMaterialf(GL_FRONT, GL_SHININESS, 5); glColor4f(1, 1, 1, 0); glColor3f(1, 1, 1); "
                               "glutSolidCube(1);",
                       kLlvmpipe),
              Names{"glColor3 after glColor4"});
}

TEST(KnownDepartures, AreThoseOfTheDriver) {
    EXPECT_EQ(names_of(kSpotOnCube, kSoftpipe), Names{"shininess 0 with attenuation or a spot"});
    EXPECT_EQ(names_of(kWideLine, kSoftpipe), Names{"wide lines in softpipe"});
    EXPECT_EQ(names_of(kWideLine, kLlvmpipe), Names{});
    EXPECT_EQ(names_of(kSpotOnCube, driver("Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "Mesa 22.3.6")), Names{});
    EXPECT_EQ(names_of(kSpotOnCube, {}), Names{});
}

// NVIDIA's driver is one for all its chips.
TEST(KnownDepartures, AreThoseOfTheMaker) {
    const std::string flat = "glShadeModel(GL_FLAT); glEnable(GL_LIGHTING); glRectf(0, 0, 1, 1);";
    for (const char* chip : {"NVIDIA H200/PCIe/SSE2", "NVIDIA GeForce RTX 3060/PCIe/SSE2"})
        EXPECT_EQ(names_of(flat, driver(chip, "NVIDIA 580.159.04")), Names{"glRect as a quadrilateral"}) << chip;
    EXPECT_EQ(names_of(kSpotOnCube, driver("NVIDIA H200/PCIe/SSE2", "NVIDIA 580.159.04")), Names{});
}

// A program that gives a position of three numbers leaves w to chance.
TEST(KnownDepartures, AreFoundWhereALightIsTooFarForFloats) {
    const auto with_w = [](const std::string& w) {
        return names_of(
            "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glLightfv(GL_LIGHT0, GL_POSITION, "
            "(GLfloat[]){0, 20, -1, " +
                w + "}); glutSolidCube(1);",
            kLlvmpipe);
    };
    EXPECT_EQ(with_w("-1.98699e-35"), Names{"a direction whose square does not fit a float"});
    EXPECT_EQ(with_w("0.001"), Names{});
}

TEST(KnownDepartures, AreThoseOfTheVersion) {
    EXPECT_EQ(names_of(kSpotOnCube, driver("llvmpipe", "Mesa 22.3.0")).size(), 1U);
    EXPECT_EQ(names_of(kSpotOnCube, driver("llvmpipe", "Mesa 25.0.7")).size(), 1U);
    EXPECT_EQ(names_of(kSpotOnCube, driver("llvmpipe", "Mesa 99.0.0")).size(), 1U);
    EXPECT_EQ(names_of(kSpotOnCube, driver("llvmpipe", "")), Names{"shininess 0 with attenuation or a spot"});
}

TEST(KnownDepartures, AreGoneInTheVersionThatFixedThem) {
    const std::string back =
        "glEnable(GL_LIGHTING); glColorMaterial(GL_BACK, GL_DIFFUSE); glEnable(GL_COLOR_MATERIAL);"
        "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); glColor3f(1, 0, 0); glutSolidCube(1);";
    EXPECT_EQ(names_of(back, kLlvmpipe), Names{"two-sided colour material only on the back"});
    EXPECT_EQ(names_of(back, driver("llvmpipe", "Mesa 24.3.9")), Names{"two-sided colour material only on the back"});
    for (const char* version : {"Mesa 25.0.0", "Mesa 25.0.7", "Mesa 99.0.0"})
        EXPECT_EQ(names_of(back, driver("llvmpipe", version)), Names{});
}

TEST(KnownDepartures, OfFogAreThoseOfPrimitivesOnBothSidesOfTheEye) {
    const auto names = [](const std::string& mode, const std::string& shape) {
        return names_of("glEnable(GL_FOG); glFogi(GL_FOG_MODE, " + mode + ");" + shape, kLlvmpipe);
    };
    const std::string vertices = "glVertex3f(0, 0, 1); glVertex3f(0, 1, -1); glEnd();", lines = "glBegin(GL_LINES);";
    for (const char* mode : {"GL_EXP", "GL_EXP2"})
        EXPECT_EQ(names(mode, lines + vertices), Names{"exponential fog on primitives that reach behind the eye"});
    EXPECT_EQ(names("GL_LINEAR", lines + vertices), Names{});
    EXPECT_EQ(names("GL_EXP", "glBegin(GL_POINTS);" + vertices), Names{});
    EXPECT_EQ(names("GL_EXP", lines + "glVertex3f(0, 0, -1); glVertex3f(0, 1, -2); glEnd();"), Names{});
}

TEST(KnownDepartures, OfFogCoordinatesAreThoseBelow0) {
    const auto names = [](const std::string& text) {
        return names_of("glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);" +
                            text + "glutSolidCube(1);",
                        kLlvmpipe);
    };
    EXPECT_EQ(names("glFogCoordf(-1);"), Names{"fog coordinates below 0"});
    EXPECT_EQ(names("glFogCoordf(1);"), Names{});
    EXPECT_EQ(names("glFogCoordf(-1); glFogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH);"), Names{});
    EXPECT_EQ(names("glFogCoordf(-1); glDisable(GL_FOG);"), Names{});
}

TEST(KnownDepartures, OfLineStipplesAreThoseOfStripsInLists) {
    const auto names = [](const std::string& mode, const std::string& before) {
        return names_of(before + "glNewList(1, GL_COMPILE_AND_EXECUTE); glBegin(" + mode +
                            "); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(1, 1); glEnd(); glEndList();",
                        kLlvmpipe);
    };
    const std::string enable = "glEnable(GL_LINE_STIPPLE);";
    for (const char* mode : {"GL_LINE_STRIP", "GL_LINE_LOOP"})
        EXPECT_EQ(names(mode, enable), Names{"stippled line strips in a display list"});
    EXPECT_EQ(names("GL_LINES", enable), Names{});
    EXPECT_EQ(names("GL_LINE_STRIP", ""), Names{});
}

// Also what a framebuffer object draws, and what was drawn before a picture was copied.
TEST(KnownDepartures, AreThoseOfAllPicturesThatAreShown) {
    const std::string object =
        "glBindTexture(GL_TEXTURE_2D, 1); glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, "
        "NULL); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glBindFramebuffer(GL_FRAMEBUFFER, 1);"
        "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 1, 0);";
    const std::string copied = "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);" + kWideLine +
                               "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 8, 8, 0); glClear(GL_COLOR_BUFFER_BIT "
                               "| GL_DEPTH_BUFFER_BIT);";
    const std::string show =
        "glLineWidth(1); glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();";
    const std::string enable = "glEnable(GL_TEXTURE_2D);", window = "glBindFramebuffer(GL_FRAMEBUFFER, 0);";
    EXPECT_EQ(names_of(object + kWideLine + window + enable + show, kSoftpipe), Names{"wide lines in softpipe"});
    EXPECT_EQ(names_of(object + kWideLine + window + show, kSoftpipe), Names{});
    EXPECT_EQ(names_of(copied + enable + show, kSoftpipe), Names{"wide lines in softpipe"});
}

TEST(KnownDepartures, OfFilledPolygonsAreOffsetsBeyondTheDepthRange) {
    // Cut by the near plane, from there to the middle of the depth range, with a slope of 0.00078 a pixel.
    const auto names = [](const std::string& offset, const std::string& state) {
        return names_of("glEnable(GL_DEPTH_TEST); glEnable(GL_POLYGON_OFFSET_FILL);" + offset + state +
                            "glBegin(GL_TRIANGLES); glVertex3f(-3, 0, -2); glVertex3f(1, -1, 0); glVertex3f(1, 1, 0); "
                            "glEnd();",
                        kLlvmpipe);
    };
    const Names bug{"polygon offset that leaves the depth range"};
    EXPECT_EQ(names("glPolygonOffset(-1, 0);", ""), bug);
    EXPECT_EQ(names("glPolygonOffset(1, 0);", ""), Names{});
    EXPECT_EQ(names("glPolygonOffset(-1, 0);", "glDepthRange(0.1, 1);"), Names{});
    EXPECT_EQ(names("glPolygonOffset(1000, 0);", ""), bug) << "beyond 1, where it is farthest";
    EXPECT_EQ(names("glPolygonOffset(-1, 0);", "glDisable(GL_DEPTH_TEST);"), Names{});
    EXPECT_EQ(names("glPolygonOffset(0, -1);", ""), Names{}) << "two steps do not show";
}

TEST(KnownDepartures, OfSoftpipeAreSumsAndCopies) {
    const std::string triangle =
        "glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();";
    const std::string sum = "glEnable(GL_COLOR_SUM); glSecondaryColor3f(0, 0, 1);", blend = "glEnable(GL_BLEND);";
    EXPECT_EQ(names_of(sum + triangle + "glDisable(GL_COLOR_SUM);" + blend + triangle, kSoftpipe),
              Names{"blending over colour sums in softpipe"});
    EXPECT_EQ(names_of(sum + triangle, kSoftpipe), Names{});
    EXPECT_EQ(names_of(blend + triangle, kSoftpipe), Names{});
    EXPECT_EQ(names_of(sum + blend + triangle, kLlvmpipe), Names{});
    const std::string copy = "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 8, 8, 0);";
    for (const std::string enable : {"glEnable(GL_POLYGON_STIPPLE);", "glEnable(GL_LINE_SMOOTH);"}) {
        EXPECT_EQ(names_of(enable + triangle + copy, kSoftpipe),
                  Names{"copied textures after stipples and smooth lines in softpipe"});
        EXPECT_EQ(names_of(copy + enable + triangle, kSoftpipe), Names{});
        EXPECT_EQ(names_of(enable + triangle + copy, kLlvmpipe), Names{});
    }
}

TEST(KnownDepartures, OfListedStripsHaveLateAttributes) {
    const auto names = [](const std::string& mode, const std::string& first, const std::string& second) {
        return names_of("glNewList(1, GL_COMPILE_AND_EXECUTE); glBegin(" + mode + ");" + first + "glVertex2f(0, 0);" +
                            second + "glVertex2f(1, 0); glVertex2f(0, 1); glEnd(); glEndList();",
                        kLlvmpipe);
    };
    const Names bug{"a triangle strip in a display list whose first vertices lack attributes"};
    const std::string normal = "glNormal3f(0, 0, 1);", vertex = "glVertex2f(0, -1);";
    EXPECT_EQ(names("GL_TRIANGLE_STRIP", "", normal), bug);
    EXPECT_EQ(names("GL_TRIANGLE_STRIP", normal, normal), Names{});
    EXPECT_EQ(names("GL_TRIANGLE_STRIP", "", vertex + normal), Names{});
    EXPECT_EQ(names("GL_TRIANGLE_STRIP", normal, "glColor3f(1, 1, 1);"), bug);
    EXPECT_EQ(names("GL_TRIANGLES", "", normal), Names{});
}

TEST(KnownDepartures, OfAttenuatedPointsAreThoseInAViewport) {
    const auto names = [](const std::string& state, const Driver& driver) {
        return names_of(state + "glBegin(GL_POINTS); glVertex2f(0, 0); glEnd();", driver);
    };
    const std::string viewport = "glViewport(0, 0, 100, 100);",
                      attenuation = "glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (GLfloat[]){4, 0, 0});";
    EXPECT_EQ(names(viewport + attenuation, kLlvmpipe), Names{"attenuated points beyond the viewport"});
    EXPECT_EQ(names(attenuation, kLlvmpipe), Names{});
    EXPECT_EQ(names(viewport, kLlvmpipe), Names{});
    EXPECT_EQ(names(viewport + attenuation, driver("llvmpipe", "Mesa 25.0.7")), Names{});
}

TEST(KnownDepartures, OfClipPlanesAreUnderASingularProjection) {
    const auto names = [](const std::string& scale, const std::string& state) {
        return names_of("glMatrixMode(GL_PROJECTION); glScalef(" + scale + ");" + state +
                            "glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();",
                        kLlvmpipe);
    };
    const std::string enable = "glEnable(GL_CLIP_PLANE0);";
    EXPECT_EQ(names("1, 1, 0", enable), Names{"clip planes under a projection without an inverse"});
    EXPECT_EQ(names("1, 1, 0.1", enable), Names{});
    EXPECT_EQ(names("1, 1, 0", ""), Names{});
}

TEST(KnownDepartures, OfGeneratedMipmapsAreThoseOfAnObjectThatHasDrawnNothing) {
    const std::string make = "glGenerateMipmap(GL_TEXTURE_2D);", clear = "glClear(GL_COLOR_BUFFER_BIT);";
    const auto names = [](const std::string& text) {
        return names_of(
            "glBindTexture(GL_TEXTURE_2D, 1);"
            "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);"
            "glBindFramebuffer(GL_FRAMEBUFFER, 1);"
            "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 1, 0);" +
                text + "glBindFramebuffer(GL_FRAMEBUFFER, 0); glutSolidCube(1);",
            kLlvmpipe);
    };
    const Names bug{"glGenerateMipmap before a framebuffer object draws"};
    EXPECT_EQ(names(make), bug);
    EXPECT_EQ(names(clear + make), Names{});
    EXPECT_EQ(names("glBindFramebuffer(GL_FRAMEBUFFER, 0);" + make), Names{});
}

// A bug of the driver that shaders show, too, is the reason rather than one of the fixed function alone, wherever it is in the table.
TEST(KnownDepartures, LeaveOutAllPairsWhereShadersShowABug) {
    const CommandList scene = read_scene(
        "glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, (GLfloat[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});"
        "glEnable(GL_MAP2_VERTEX_3); glShadeModel(GL_FLAT); glEnable(GL_POLYGON_STIPPLE); glEvalMesh2(GL_FILL, 0, 2, "
        "0, "
        "2); glBindFramebuffer(GL_FRAMEBUFFER, 1);",
        "scene.gl", "scene");
    const Departure* found = DeparturesOfScene(scene, kLlvmpipe, {}).in({});
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->name, "polygon stipple after a framebuffer object");
}

TEST(KnownDepartures, ThatAreUndefinedAreThePlaceOfTheEyeInAViewVolumeThatHoldsIt) {
    const auto is_left_out = [](const std::string& near, const std::string& shape) {
        const CommandList scene = read_scene(
            "glMatrixMode(GL_PROJECTION); gluPerspective(90, 1, " + near + ", 10);" + shape, "scene.gl", "scene");
        const Departure* found = DeparturesOfScene(scene, kLlvmpipe, {}).in(make_frame(scene, {}));
        return found && found->name == "primitives through a point whose clip coordinates are all 0";
    };
    const std::string through =
        "glBegin(GL_TRIANGLES); glVertex3f(-1, 0, -1); glVertex3f(1, 0, -1); glVertex3f(0, 0, 1); glEnd();";
    const std::string line = "glBegin(GL_LINES); glVertex3f(1, 1, 2); glVertex3f(-2, -2, -4); glEnd();";
    const std::string aside =
        "glBegin(GL_TRIANGLES); glVertex3f(-1, 0.5, -1); glVertex3f(1, 0.5, -1); glVertex3f(0, 0.5, 1); glEnd();";
    EXPECT_TRUE(is_left_out("0", through));
    EXPECT_TRUE(is_left_out("0", line));
    EXPECT_FALSE(is_left_out("0", aside));
    EXPECT_FALSE(is_left_out("0.1", through));
    EXPECT_FALSE(is_left_out("0.1", line));
}

TEST(KnownDepartures, ThatAreUndefinedAreLimitsOfTheLevelInTheWrongOrder) {
    const auto is_left_out = [](const std::string& most) {
        const CommandList scene = read_scene(
            "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, (GLubyte[4]){255});"
            "glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 1);"
            "glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, " +
                most +
                "); glEnable(GL_TEXTURE_2D);"
                "glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();",
            "scene.gl", "scene");
        return DeparturesOfScene(scene, kLlvmpipe, {}).in(make_frame(scene, {})) != nullptr;
    };
    EXPECT_TRUE(is_left_out("0"));
    EXPECT_FALSE(is_left_out("1"));
}

TEST(KnownDepartures, AreListedForADriverOrNotAtAll) {
    EXPECT_TRUE(is_listed(kLlvmpipe));
    EXPECT_TRUE(is_listed(kSoftpipe));
    EXPECT_TRUE(is_listed(driver("llvmpipe", "Mesa 24.0.5")));
    EXPECT_TRUE(is_listed(driver("NVIDIA H200/PCIe/SSE2", "NVIDIA 595.10")));
    EXPECT_FALSE(is_listed(driver("iris", "Mesa 22.3.6")));
    EXPECT_FALSE(is_listed({}));
}

TEST(KnownDepartures, AreMeasuredOnSomeReleases) {
    for (const Driver& measured : {kLlvmpipe, kSoftpipe, driver("NVIDIA H200/PCIe/SSE2", "NVIDIA 580.159.04")})
        EXPECT_TRUE(is_measured(measured)) << measured.version;
    for (const Driver& other : {driver("llvmpipe", "Mesa 24.0.5"), driver("llvmpipe", "Mesa 99.0.0"),
                                driver("iris", "Mesa 22.3.6"), driver("NVIDIA H200", "NVIDIA 535.54.03"), Driver{}})
        EXPECT_FALSE(is_measured(other)) << other.name << ", " << other.version;
}

TEST(KnownDepartures, SayWhereTheyWereSeen) {
    for (const Departure& departure : departures())
        EXPECT_TRUE(departure.cause == Cause::kUnspecified || !departure.seen_on.empty() ||
                    !departure.crashes_on.empty())
            << departure.name;
}

// The fuzzer skips bugs that may show: also in other versions, and on any driver if several drivers have the bug.
TEST(KnownDepartures, MayShowElsewhere) {
    const auto may_show = [](std::string_view name, const Driver& driver) {
        return std::ranges::find(departures(), name, &Departure::name)->may_show_on(driver);
    };
    const Driver gpu = driver("a GPU", "Mesa 22.3.6"), other = driver("softpipe", "Mesa 24.0.5");
    for (const Driver& driver : {kLlvmpipe, kSoftpipe, gpu, other}) {
        EXPECT_TRUE(may_show("glColor3 after glColor4", driver));
        EXPECT_TRUE(may_show("no answer in the specification", driver));
        EXPECT_EQ(may_show("wide lines in softpipe", driver), driver.name == "softpipe");
        EXPECT_EQ(may_show("shininess 0 on one side of two", driver), driver.name == "llvmpipe");
    }
}

}  // namespace
}  // namespace twinlight::compare::known_departures_test
