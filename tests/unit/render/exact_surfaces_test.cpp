// Exact surfaces, by derivation: the meshes' vertices lie on them, fine meshes look like them, coarser meshes approach
// them with the order that theory predicts, and double agrees with long double.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "render/reference/reference.h"
#include "scene/command/reader.h"
#include "scene/shape/surface.h"
#include "scene/state/state.h"

namespace twinlight::exact_surfaces_test {
namespace {

Frame frame_of(const std::string& text, int side = 200) {
    const auto scene = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
    return make_frame(*scene, {.width = side, .height = side});
}

Image render(const Frame& frame, Shading shading) { return reference::render(frame, {{.shading = shading}}); }

const std::string kQuadric = "GLUquadric *q = gluNewQuadric(); ";

// ---- The equations ----

struct Shape {
    std::string commands;
    std::size_t surfaces;
};
const Shape kShapes[] = {
    {"glutSolidSphere(0.8, 12, 9);", 1},
    {"glutSolidCone(0.8, 1.2, 12, 4);", 2},
    {"glutSolidCylinder(0.7, 1.1, 12, 4);", 3},
    {"glutSolidTorus(0.3, 0.6, 9, 12);", 1},
    {"\n#pragma twinlight shape(sphere, 0.8, 12, 9)\n", 1},
    {"\n#pragma twinlight shape(cone, 0.8, 1.2, 12)\n", 2},
    {"\n#pragma twinlight shape(cylinder, 0.7, 1.1, 12)\n", 3},
    {kQuadric + "gluSphere(q, 0.8, 12, 9);", 1},
    {kQuadric + "gluCylinder(q, 0.8, 0.3, 1.1, 12, 4);", 1},
    {kQuadric + "gluDisk(q, 0.2, 0.9, 12, 4);", 1},
    {kQuadric + "gluPartialDisk(q, 0.2, 0.9, 12, 4, 30, 200);", 1},
    {kQuadric + "gluQuadricOrientation(q, GLU_INSIDE); gluSphere(q, 0.8, 12, 9);", 1},
};

// The point where a ray from inside, along the vertex's normal, leaves a surface at the vertex, and the normal there.
bool holds(const std::vector<Surface>& surfaces, const Vertex& vertex) {
    using Vec = Vec3<double>;
    constexpr double kDepth = 0.125, kRounding = 1e-13;
    for (const Surface& surface : surfaces) {
        const glm::dvec3 outward = surface.inside ? -vertex.normal_object : vertex.normal_object;
        const Vec p = surface_from_object(surface, vec3_cast<Vec>(glm::dvec3(vertex.position_object))),
                  n = surface_from_object(surface, vec3_cast<Vec>(outward));
        const Crossings<double> found = crossings(surface, p - kDepth * n, n);
        for (int i = 0; i < found.count; ++i) {
            if (std::abs(found.s[static_cast<std::size_t>(i)] - kDepth) > kRounding) continue;
            const Vec there = outward_normal(surface, p);
            if (length(there / length(there) - n) < kRounding) return true;
        }
    }
    return false;
}

TEST(Surfaces, HoldTheVerticesOfTheirMeshes) {
    for (const Shape& shape : kShapes) {
        SCOPED_TRACE(shape.commands);
        const Frame frame = frame_of(shape.commands);
        std::size_t held = 0, vertices = 0;
        for (const auto& item : frame.items) {
            const Draw& draw = std::get<Draw>(item);
            ASSERT_TRUE(draw.surfaces);
            EXPECT_EQ(draw.surfaces->size(), shape.surfaces);
            EXPECT_EQ(draw.surfaces, std::get<Draw>(frame.items[0]).surfaces);
            for (const Vertex& vertex : draw.vertices) held += holds(*draw.surfaces, vertex) ? 1 : 0;
            vertices += draw.vertices.size();
        }
        // Skips vertices on a border, where rounding decides, and at an apex.
        EXPECT_GT(held, vertices / 4) << vertices;
    }
}

TEST(Surfaces, AreNotThoseOfWiresFlatShapesOrBadSizes) {
    for (const char* commands : {"glutWireSphere(1, 8, 8);", "glutSolidCube(1);", "glutSolidTeapot(1);",
                                 "glutSolidSphere(-1, 8, 8);", "glBegin(GL_POINTS); glVertex2f(0, 0); glEnd();"}) {
        for (const auto& item : frame_of(commands).items) EXPECT_FALSE(std::get<Draw>(item).surfaces) << commands;
    }
    for (const char* set : {"gluQuadricDrawStyle(q, GLU_LINE);", "gluQuadricNormals(q, GLU_NONE);"})
        for (const auto& item : frame_of(kQuadric + set + "gluSphere(q, 1, 8, 8);").items)
            EXPECT_FALSE(std::get<Draw>(item).surfaces) << set;
}

TEST(Surfaces, MeetRaysWhereLongDoubleSays) {
    const Surface surfaces[] = {{.equation = SphereSurface{0.8}},
                                {.equation = FrustumSurface{0.8, 0.3, 1.1}},
                                {.equation = FrustumSurface{0.7, 0.7, 1.1}},
                                {.equation = DiskSurface{0.2, 0.9, 0.5, true}},
                                {.equation = TorusSurface{0.3, 0.6}}};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    int met = 0, counts_differ = 0;
    double worst = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3<double> o{5 * coordinate(random), 5 * coordinate(random), 5 + coordinate(random)};
        const Vec3<double> d = Vec3<double>{0.8 * coordinate(random), 0.8 * coordinate(random), coordinate(random)} - o;
        for (const Surface& surface : surfaces) {
            const Crossings<double> found = crossings(surface, o, d);
            const Crossings<long double> truth =
                crossings(surface, vec3_cast<Vec3<long double>>(o), vec3_cast<Vec3<long double>>(d));
            if (found.count != truth.count) {
                ++counts_differ;
                continue;
            }
            for (int k = 0; k < found.count; ++k, ++met) {
                const auto at = static_cast<std::size_t>(k);
                const double error = static_cast<double>(std::abs(truth.s[at] - static_cast<long double>(found.s[at])));
                // A grazing ray magnifies the rounding error of the equation.
                const Vec3<double> p = o + found.s[at] * d, n = outward_normal(surface, p);
                const double grazing = std::abs(dot(n, d)) / (length(n) * length(d));
                worst = std::max(worst, error * grazing * grazing);
            }
        }
    }
    std::printf("%d points, %d counts differ; the worst is %.1e off\n", met, counts_differ, worst);
    EXPECT_GT(met, 50'000);
    EXPECT_LE(counts_differ, 2);
    EXPECT_LT(worst, 2e-14);
}

// ---- The pictures ----

const std::string kCamera =
    "glMatrixMode(GL_PROJECTION); gluPerspective(40, 1, 1, 20); glMatrixMode(GL_MODELVIEW); "
    "gluLookAt(1, 2, 3, 0, 0.2, 0, 0, 1, 0); glEnable(GL_DEPTH_TEST); glEnable(GL_NORMALIZE); ";
// Red fronts and blue backs, darker away from the light.
const std::string kTwoSides =
    "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); "
    "glLightfv(GL_LIGHT0, GL_POSITION, (float[]){2, 3, 4, 1}); "
    "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){1, 0.2, 0, 1}); "
    "glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (float[]){0, 0.2, 1, 1}); ";

// How much the pictures of the mesh and of the surface differ.
struct Apart {
    double rms = 0;
    int drawn = 0, differing = 0;  // pixels; `differing` by more than `allowed`
};
Apart apart(const Frame& frame, Shading shading, double allowed) {
    const Image mesh = render(frame, shading), exact = render(frame, Shading::kExact);
    Apart result;
    double squares = 0;
    for (std::size_t i = 0; i < mesh.pixels.size(); ++i) {
        if (mesh.pixels[i] == Rgba{} && exact.pixels[i] == Rgba{}) continue;
        ++result.drawn;
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = std::abs(mesh.pixels[i][c] - exact.pixels[i][c]);
            most = std::max(most, difference);
            squares += difference * difference;
        }
        result.differing += most > allowed ? 1 : 0;
    }
    result.rms = std::sqrt(squares / (3.0 * result.drawn));
    return result;
}

// Position, normal, face, depth: a fine mesh looks the same.
TEST(ExactPictures, AreWhatFineMeshesComeTo) {
    const std::string shapes[] = {
        "glutSolidSphere(0.8, 200, 200);",
        "glutSolidCone(0.8, 1.2, 200, 200);",
        "glutSolidCylinder(0.7, 1.1, 200, 1);",
        "glRotatef(50, 1, 0, 0); glutSolidTorus(0.3, 0.6, 200, 200);",
        "glFrontFace(GL_CW); glScalef(1, 0.5, -1.5); glutSolidSphere(0.8, 200, 200);",
        "\n#pragma twinlight shape(cylinder, 0.7, 1.1, 200)\n",
        kQuadric + "glRotatef(-60, 1, 0, 0); gluCylinder(q, 0.8, 0.3, 1.1, 200, 100);",
        kQuadric +
            "gluQuadricOrientation(q, GLU_INSIDE); glRotatef(-60, 1, 0, 0); gluCylinder(q, 0.8, 0.8, 1.1, 200, 100);",
        kQuadric + "glRotatef(-60, 1, 0, 0); gluPartialDisk(q, 0.2, 0.9, 200, 1, 30, -200);",
        "glClipPlane(GL_CLIP_PLANE0, (double[]){1, 1, 1, 0.1}); glEnable(GL_CLIP_PLANE0); glutSolidSphere(0.8, 200, "
        "200);",
        "glEnable(GL_CULL_FACE); glCullFace(GL_FRONT); glutSolidTorus(0.3, 0.6, 200, 200);",
        "glTranslatef(0.5, 1.2, 1.8); glutSolidSphere(0.8, 200, 200);",  // cut by the near plane
        "glEnable(GL_FOG); glFogf(GL_FOG_DENSITY, 0.2); glutSolidSphere(0.8, 200, 200);",
    };
    for (const std::string& shape : shapes) {
        SCOPED_TRACE(shape);
        // The mesh's error is (pi / 200)^2 / 8 of the radius, and its effect on colours. Pixels on silhouettes may show
        // their neighbours' colours.
        const Apart found = apart(frame_of(kCamera + kTwoSides + shape), Shading::kPhong, 0.003);
        EXPECT_GT(found.drawn, 2000);
        EXPECT_LT(found.differing, found.drawn / 200);
    }
}

// The interpolation error of a smooth function falls with the square of the mesh's width, of flat shading with the
// width.
TEST(ExactPictures, AreApproachedByTheOrderOfTheShading) {
    const auto error = [](int slices, Shading shading) {
        // Only pixels that the coarsest mesh covers: the middle of the sphere.
        const std::string scissor = "glEnable(GL_SCISSOR_TEST); glScissor(75, 75, 50, 50); ";
        return apart(frame_of(kCamera + kTwoSides + scissor + "glutSolidSphere(0.8, " + std::to_string(slices) + ", " +
                              std::to_string(slices) + ");"),
                     shading, 0)
            .rms;
    };
    for (const auto& [shading, order] :
         {std::pair(Shading::kFlat, 1.0), {Shading::kGouraud, 2.0}, {Shading::kPhong, 2.0}}) {
        const double coarse = error(16, shading), fine = error(64, shading);
        EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), order, 0.25) << coarse << " " << fine;
    }
}

TEST(ExactPictures, HaveTheTextureOfTheQuadric) {
    std::string texels;
    for (int i = 0; i < 64; ++i) texels += std::to_string(128 + 100 * std::sin(0.7 * i)).substr(0, 5) + ", ";
    const std::string texture =
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 8, 8, 0, GL_LUMINANCE, GL_FLOAT, (float[]){" + texels +
        "}); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); glEnable(GL_TEXTURE_2D); "
        "glScalef(1, 1, 1); glMatrixMode(GL_TEXTURE); glScalef(3, 2, 1); glMatrixMode(GL_MODELVIEW); " +
        kQuadric + "gluQuadricTexture(q, GL_TRUE); glRotatef(-60, 1, 0, 0); ";
    for (const char* shape : {"gluSphere(q, 0.8, 200, 200);", "gluCylinder(q, 0.8, 0.3, 1.1, 200, 100);",
                              "gluDisk(q, 0.2, 0.9, 200, 50);"}) {
        const Apart found = apart(frame_of(kCamera + texture + shape), Shading::kPhong, 0.01);
        EXPECT_GT(found.drawn, 2000);
        EXPECT_LT(found.differing, found.drawn / 200) << shape;
    }
}

TEST(ExactPictures, OfMatricesWithoutInverseAreEmpty) {
    const Image image = render(frame_of(kCamera + "glScalef(1, 0, 1); glutSolidSphere(0.8, 20, 20);"), Shading::kExact);
    for (const Rgba& pixel : image.pixels) EXPECT_EQ(pixel, (Rgba{0, 0, 0, 0}));
}

// Flat shapes are drawn as their mesh, lit per pixel.
TEST(ExactPictures, OfFlatShapesAreThoseOfPhongShading) {
    const Frame frame = frame_of(kCamera + kTwoSides + "glutSolidCube(1); glutSolidTeapot(0.5);");
    EXPECT_EQ(render(frame, Shading::kExact).pixels, render(frame, Shading::kPhong).pixels);
}

}  // namespace
}  // namespace twinlight::exact_surfaces_test
