// Shaders for WebGPU and Vulkan: the layout of their buffers, WGSL for GLSL, and what the scene's data say.
#include "render/webgpu/ported_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "base/text/json.h"
#include "render/webgpu/blocks.h"
#include "render/webgpu/wgsl_function.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::webgpu::ported_files_test {
namespace {

Frame frame_of(const std::string& text) { return make_frame(read_text_of("", "scene", text), {}); }

std::string file_of(const std::string& scene, Target target, const std::string& name) {
    const std::vector<NamedFile> files = ported_files(frame_of(scene), {}, target, "scene");
    const auto found = std::ranges::find(files, name, &NamedFile::name);
    return found == files.end() ? "" : found->bytes;
}

// ---- The layout ----

constexpr const char* kSpot = R"(
glEnable(GL_LIGHTING); glEnable(GL_LIGHT1);
glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1}); glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){0, 0, 3, 1});
glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 30); glLightf(GL_LIGHT1, GL_SPOT_EXPONENT, 1.5);
glBegin(GL_TRIANGLES); glNormal3f(0, 0, 1); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(0, 1); glEnd();
)";

Json member_named(const Json& layout, const std::string& name) {
    for (const Json& block : layout["blocks"])
        for (const Json& member : block["members"])
            if (member["name"] == name) return member;
    return {};
}

// By the rules of std140 (OpenGL 4.5, section 7.6.2.2): vec4 and vec3 begin at multiples of 16, a float may follow a vec3 at 12; the struct of
// diffuse, position, spotDirection, spotExponent, spotCosCutoff has 16 + 16 + 12 + 4 + 4 bytes, rounded up to 64.
TEST(PortedLayout, FollowsStd140) {
    for (const Target target : {Target::kWgsl, Target::kVulkan}) {
        const Json layout = Json::parse(file_of(kSpot, target, "layout.json"));
        EXPECT_EQ(member_named(layout, "LightSource[0].diffuse")["offset"], 0);
        EXPECT_EQ(member_named(layout, "LightSource[0].position")["offset"], 16);
        EXPECT_EQ(member_named(layout, "LightSource[0].spotDirection")["offset"], 32);
        EXPECT_EQ(member_named(layout, "LightSource[0].spotExponent")["offset"], 44);
        EXPECT_EQ(member_named(layout, "LightSource[0].spotCosCutoff")["offset"], 48);
        EXPECT_EQ(member_named(layout, "LightSource[1].diffuse")["offset"], 64);
        // Two matrices of 4 columns, then one of 3 columns, which take 16 bytes each.
        EXPECT_EQ(member_named(layout, "NormalMatrix")["offset"], 128);
        EXPECT_EQ(layout["blocks"][0]["size"], 128 + 48);
        EXPECT_EQ(member_named(layout, "LightSource[1].spotCosCutoff")["state"],
                  "the cosine of glLight(GL_LIGHT1, GL_SPOT_CUTOFF)");
    }
}

TEST(PortedLayout, IsTheSameForAllKinds) {
    const std::string scene = std::string(kSpot) + R"(
glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1}); glLightfv(GL_LIGHT1, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});
glDisable(GL_LIGHT1); glEnable(GL_LIGHT0); glRectf(0, 0, 1, 1);
)";
    const std::string first = file_of(scene, Target::kWgsl, "kind1.wgsl"),
                      second = file_of(scene, Target::kWgsl, "kind2.wgsl");
    const auto materials = [](const std::string& text) {
        const std::size_t begin = text.find("struct MaterialParameters");
        return text.substr(begin, text.find('}', begin) - begin);
    };
    ASSERT_FALSE(first.empty() || second.empty());
    EXPECT_EQ(materials(first), materials(second));
    EXPECT_NE(materials(first).find("specular"), std::string::npos) << "the second needs it";
}

// ---- WGSL ----

std::string wgsl_of(const std::string& glsl, WgslNames names = {}) {
    const Shader shader = read_shader("// A shader.\n\n" + glsl);
    names.globals["place"] = {"matrices.place", "vec4"};
    return wgsl_function(shader.main(), names);
}

TEST(PortedWgsl, HasSelectForConditionsAndSaturateForClampsTo1) {
    EXPECT_EQ(
        wgsl_of("float f(float x, vec3 v) {\n    return x > 0.0 ? clamp(x, 0.0, 1.0) : (v.s < 0.5 ? -x : v.z);\n}\n"),
        "fn f(x: f32, v: vec3f) -> f32 {\n    return select(select(v.z, -x, v.x < 0.5), saturate(x), x > 0.0);\n}\n");
}

TEST(PortedWgsl, AssignsSeveralComponentsByTheWholeVector) {
    EXPECT_EQ(wgsl_of("vec4 f(vec3 v) {\n    vec4 c = place;\n    c.rgb += v;\n    c.rgb *= 0.5;\n    c.xy = v.xy;\n"
                      "    c.rgb = v;  // both\n    c.a = 1.0;\n    return c;\n}\n"),
              "fn f(v: vec3f) -> vec4f {\n    var c = matrices.place;\n    c += vec4f(v, 0.0);\n    c *= "
              "vec4f(vec3f(0.5), 1.0);\n"
              "    c = vec4f(v.xy, c.zw);\n    c = vec4f(\n        v,  // both\n        1.0);\n    return c;\n}\n");
}

// In one statement the second value would be that of before.
TEST(PortedWgsl, KeepsTheOrderOfAssignmentsThatDependOnEachOther) {
    EXPECT_EQ(wgsl_of("vec4 f(vec3 v) {\n    vec4 c = place;\n    c.rgb = v;\n    c.a = c.r;\n    return c;\n}\n"),
              "fn f(v: vec3f) -> vec4f {\n    var c = matrices.place;\n    c = vec4f(v, c.a);\n    c.a = c.r;\n    "
              "return c;\n}\n");
}

TEST(PortedWgsl, GivesScalarsTheTypeOfVectors) {
    EXPECT_EQ(wgsl_of("vec3 f(vec3 v) {\n    return min(max(v, 0.0), v) + mix(v, vec3(1.0), 0.5);\n}\n"),
              "fn f(v: vec3f) -> vec3f {\n    return min(max(v, vec3f(0.0)), v) + mix(v, vec3f(1.0), 0.5);\n}\n");
}

TEST(PortedWgsl, HasVariablesForWhatChanges) {
    EXPECT_EQ(wgsl_of("float f(float x, int n) {\n    const float far = 1e10;\n    float y = x, z;\n    z = far;\n"
                      "    for (int i = 0; i < 8; ++i) x *= (n >> i & 1) != 0 ? y : z;\n    if (x < 0.0) return 0.0;\n "
                      "   return x;\n}\n"),
              "fn f(x_given: f32, n: i32) -> f32 {\n    var x = x_given;  // a parameter cannot change in WGSL\n    "
              "const far = 1e10;\n"
              "    let y = x;\n    var z: f32;\n    z = far;\n"
              "    for (var i = 0; i < 8; i++) { x *= select(z, y, ((n >> u32(i)) & 1) != 0); }\n"
              "    if (x < 0.0) { return 0.0; }\n    return x;\n}\n");
}

// GLSL has one name for the functions of whole and of other exponents.
TEST(PortedWgsl, GivesFunctionsOfOneNameTwo) {
    const std::string scene = R"(
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT1);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 3, 1}); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30); glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2);
glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){0, 0, 3, 1}); glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 30); glLightf(GL_LIGHT1, GL_SPOT_EXPONENT, 2.5);
glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1}); glRectf(-1, -1, 1, 1);
)";
    const std::string text = file_of(scene, Target::kWgsl, "kind1.wgsl");
    for (const char* part : {"fn spot_whole(", "fn spot_real(", "= spot_whole(", "= spot_real("})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(PortedWgsl, RefusesWhatItDoesNotKnow) {
    EXPECT_THROW(wgsl_of("float f(float x) {\n    return unknown(x);\n}\n"), std::logic_error);
    EXPECT_THROW(wgsl_of("float f(float x) {\n    return y;\n}\n"), std::logic_error);
}

// ---- The scene ----

// The last vertex of a primitive gives a flat colour in GL, the first in WebGPU and Vulkan. Turns stay: (a, b, c) becomes (c, a, b).
TEST(PortedScene, HasListsWhoseFirstVertexGivesTheFlatColour) {
    const auto indices = [](const std::string& primitives) {
        const std::string scene = "glShadeModel(GL_FLAT); " + primitives;
        const Json json = Json::parse(file_of(scene, Target::kWgsl, "scene.json"));
        const std::string bytes = file_of(scene, Target::kWgsl, "scene.bin");
        const Json& item = json["items"].back();
        std::vector<std::uint32_t> result(item["indices"][1].get<std::size_t>());
        std::memcpy(result.data(), bytes.data() + 4 * item["indices"][0].get<std::size_t>(), 4 * result.size());
        return result;
    };
    const std::string four = "glVertex2f(0, 0); glVertex2f(0.5, 0); glVertex2f(0, 0.5); glVertex2f(0.5, 0.5); glEnd();";
    EXPECT_EQ(indices("glBegin(GL_TRIANGLE_STRIP); " + four), (std::vector<std::uint32_t>{2, 0, 1, 3, 2, 1}));
    EXPECT_EQ(indices("glBegin(GL_TRIANGLE_FAN); " + four), (std::vector<std::uint32_t>{2, 0, 1, 3, 0, 2}));
    EXPECT_EQ(indices("glBegin(GL_LINE_LOOP); " + four), (std::vector<std::uint32_t>{1, 0, 2, 1, 3, 2, 0, 3}));
}

// A rectangle from the lower left corner, in a picture of 480 rows.
TEST(PortedScene, CountsRowsFromTheTop) {
    const Json json = Json::parse(file_of(
        "glViewport(10, 20, 30, 40); glEnable(GL_SCISSOR_TEST); glScissor(-5, 2, 10, 20); glRectf(-1, -1, 1, 1);",
        Target::kWgsl, "scene.json"));
    const Json& item = json["items"].back();
    EXPECT_EQ(item["viewport"], Json({10, 480 - 60, 30, 40}));
    EXPECT_EQ(item["scissor"], Json({0, 480 - 22, 5, 20})) << "within the picture";
}

TEST(PortedFiles, NameWhatThePictureLacks) {
    const std::string scene =
        "glLineWidth(3); glBegin(GL_LINES); glVertex2f(0, 0); glVertex2f(1, 1); glEnd(); glPointSize(3); "
        "glBegin(GL_POINTS); glVertex2f(0, 0); glEnd();";
    const std::string readme = file_of(scene, Target::kWgsl, "README.md");
    EXPECT_NE(readme.find("- lines have a width of one pixel"), std::string::npos) << readme;
    EXPECT_NE(readme.find("- points have one pixel"), std::string::npos) << readme;
    EXPECT_EQ(file_of(scene, Target::kVulkan, "README.md").find("points have"), std::string::npos);
    EXPECT_NE(file_of(scene, Target::kVulkan, "kind1.vert").find("gl_PointSize"),
              file_of(scene, Target::kVulkan, "kind2.vert").find("gl_PointSize"));
}

}  // namespace
}  // namespace twinlight::webgpu::ported_files_test
