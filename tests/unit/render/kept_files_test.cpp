// Shaders to keep: planned by state and not by pose, one pair for each kind, GL's names, every version's spelling.
#include "render/programmable/export/kept_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../hand_built_draws.h"
#include "render/programmable/export/core_elements.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/text/kept_text.h"
#include "render/webgl/exported_page.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::programmable::kept_files_test {
namespace {

PlanOptions for_any_pose() {
    PlanOptions options;
    options.for_any_pose = true;
    return options;
}

LightingState attenuated_cone() {
    LightingState lighting = cone();
    lighting.lights[0].constant_attenuation = 2;
    return lighting;
}

std::vector<NamedFile> files_of(const std::vector<Draw>& draws, Glsl version = Glsl::k330) {
    Frame frame{.width = 8, .height = 8};
    for (const Draw& draw : draws) frame.items.emplace_back(draw);
    return kept_files(frame, {}, version, "scene");
}

std::string text_of(const std::vector<NamedFile>& files, const std::string& name) {
    const auto found = std::ranges::find(files, name, &NamedFile::name);
    return found == files.end() ? "" : found->bytes;
}

// Each pose leaves out something by default: the light is behind the square, its cone misses it, it is too faint.
TEST(PlanForAnyPose, FollowsTheStateAndNotThePlaces) {
    const EffectSet here = plan_effects(square(attenuated_cone()), for_any_pose()).effects;
    ASSERT_EQ(here.lights.size(), 1U);
    EXPECT_TRUE(here.lights[0].ambient && here.lights[0].diffuse && here.lights[0].specular);
    EXPECT_TRUE(here.lights[0].attenuated && here.lights[0].cone == SpotCone::kGl);
    EXPECT_TRUE(here.clamp);

    LightingState behind = attenuated_cone(), missing = attenuated_cone(), far = attenuated_cone();
    behind.lights[0].position_eye.z = -5;
    missing.lights[0].spot_direction_eye = {0, 0, 1};
    far.lights[0].position_eye.z = 1000;
    far.lights[0].quadratic_attenuation = 1;
    for (const LightingState& lighting : {behind, missing, far}) {
        const Draw draw = square(lighting);
        EXPECT_EQ(plan_effects(draw, for_any_pose()).effects, here);
        EXPECT_NE(plan_effects(draw, {}).effects.lights, here.lights) << "the default plan needs less";
    }
}

TEST(PlanForAnyPose, LeavesOutWhatTheStateExcludes) {
    LightingState lighting = attenuated_cone();
    lighting.lights[0].enabled = false;
    lighting.lights[1] = lighting.lights[2] = attenuated_cone().lights[0];
    lighting.lights[1].specular = lighting.lights[1].ambient = {0, 0, 0, 1};
    lighting.lights[2].ambient = lighting.lights[2].diffuse = lighting.lights[2].specular = {0, 0, 0, 1};
    const Plan plan = plan_effects(square(lighting), for_any_pose());
    ASSERT_EQ(plan.lights.size(), 1U);
    EXPECT_EQ(plan.lights[0].number, 1);
    EXPECT_FALSE(plan.effects.lights[0].specular || plan.effects.lights[0].ambient);
}

// A directional light has a cone too (section 2.14.1); which vertices it reaches changes with its direction.
TEST(PlanForAnyPose, KeepsTheConeOfADirectionalLight) {
    LightingState lighting = attenuated_cone();
    lighting.lights[0].position_eye = {0, 0, 1, 0};
    const Plan plan = plan_effects(square(lighting), for_any_pose());
    ASSERT_EQ(plan.effects.lights.size(), 1U);
    EXPECT_TRUE(plan.effects.lights[0].cone == SpotCone::kGl && plan.effects.lights[0].directional);
    EXPECT_FALSE(plan.effects.lights[0].attenuated);
}

TEST(KeptFiles, HaveOnePairForDrawsThatDifferInPlacesAndNumbers) {
    Draw moved = square(attenuated_cone());
    moved.eye_from_object[3] = {3, 1, -40, 1};
    moved.lighting.front.diffuse = {0.5, 0.4, 0.3, 1};
    moved.lighting.lights[0].position_eye = {0, 0, -50, 1};
    LightingState unlit = dark();
    unlit.enabled = false;
    const auto files = files_of({square(attenuated_cone()), moved, square(unlit)});
    std::vector<std::string> names;
    for (const NamedFile& file : files) names.push_back(file.name);
    EXPECT_EQ(names, (std::vector<std::string>{"kind1.vert", "kind1.frag", "kind2.vert", "kind2.frag", "kinds.c",
                                               "gl_state.h", "gl_state.c", "names.sed", "scene.c", "scene.bin",
                                               "scene.h", "window.c", "README.md"}));
    const std::string readme = text_of(files, "README.md");
    EXPECT_LE(std::ranges::count(readme, '\n'), 10);
}

TEST(KeptFiles, HaveGlsNamesAndTheEquationsFunctions) {
    const std::string text = text_of(files_of({square(attenuated_cone())}), "kind1.vert");
    for (const char* part :
         {"#version 330 core\n", "layout(location = 1) in vec3 Normal;", "uniform mat4 ModelViewMatrix;",
          "uniform LightSourceParameters LightSource[1];", "float attenuation(", "float spot(", "float highlight(",
          "lit.primary.rgb += reach * n_dot_vp * FrontMaterial.diffuse.rgb * LightSource[0].diffuse.rgb;",
          "FrontMaterial.emission.rgb + FrontMaterial.ambient.rgb * LightModel.ambient.rgb;"})
        EXPECT_NE(text.find(part), text.npos) << part << " in\n" << text;
    EXPECT_EQ(text.find("u_"), text.npos) << text;
    EXPECT_EQ(text.find("BackMaterial"), text.npos) << "only one side is lit\n" << text;
}

TEST(KeptFiles, SpellEachVersion) {
    Draw draw = square(attenuated_cone());
    draw.raster.clip_planes_eye[3] = glm::dvec4(0, 0, 1, 0);
    draw.fragment.alpha_test = true;
    draw.fragment.alpha_func = kGL_GEQUAL;
    const auto has = [&](Glsl version, const std::string& file, const char* part) {
        return text_of(files_of({draw}, version), file).find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(Glsl::k130, "kind1.vert", "#version 130\n"));
    EXPECT_FALSE(has(Glsl::k130, "kind1.vert", "layout("));
    EXPECT_TRUE(has(Glsl::k330, "kind1.vert", "gl_ClipDistance[0] = dot(ClipPlane[3], ModelViewMatrix * Vertex);"));
    EXPECT_TRUE(has(Glsl::k330, "kind1.frag", "if (!(color.a >= AlphaRef)) discard;"));
    EXPECT_TRUE(has(Glsl::k300es, "kind1.vert", "#version 300 es\nprecision highp float;"));
    EXPECT_FALSE(has(Glsl::k300es, "kind1.vert", "gl_ClipDistance"));
    EXPECT_TRUE(has(Glsl::k300es, "kind1.frag", "if (v_clip_distance0 < 0.0) discard;"));
}

TEST(KeptFiles, SizePointsWhereOpenGlEsDoesNot) {
    const auto sizes = [](Glsl version) {
        const std::string text = text_of(files_of({point({0, 0, 0}, attenuated_cone())}, version), "kind1.vert");
        return text.find("gl_PointSize = PointSize;") != std::string::npos;
    };
    EXPECT_TRUE(sizes(Glsl::k300es));
    EXPECT_FALSE(sizes(Glsl::k330));
}

TEST(ExportedPageText, HoldsAnyNameAndLoadsNothing) {
    Frame frame{.width = 8, .height = 8};
    frame.items = {square(attenuated_cone())};
    const std::string page = webgl::exported_page({{&frame, "x</script>"}}, {}, {"a</script>&b", "c < d"});
    EXPECT_NE(page.find("<title>a&lt;/script&gt;&amp;b</title>"), page.npos) << page.substr(0, 200);
    EXPECT_NE(page.find("<p>c &lt; d</p>"), page.npos);
    EXPECT_EQ(page.find("x</script>"), page.npos);
    for (const char* loads : {"http:", "https:", " src=", " href=", "import ", "import(", "fetch("})
        EXPECT_EQ(page.find(loads), page.npos) << loads;
    // Shaders, numbers and code can be read in it.
    for (const char* part :
         {"<script type=\"text/plain\" id=\"kind1.vert\">\n#version 300 es\n", "\"vertex\":\"kind1.vert\"",
          "\"LightSource[0].position\":[", "export class Renderer {", "at(\"picture\").addEventListener("})
        EXPECT_NE(page.find(part), page.npos) << part;
}

TEST(KeptFiles, RefuseSpectraAndManyLights) {
    LightingState lighting = attenuated_cone();
    lighting.lights.resize(20, lighting.lights[0]);
    Frame frame{.width = 8, .height = 8};
    frame.items = {square(lighting)};
    EXPECT_NE(why_not_kept(frame).find("light(16)"), std::string::npos) << why_not_kept(frame);
    EXPECT_THROW(kept_files(frame, {}, Glsl::k330, "scene"), std::runtime_error);
    lighting = attenuated_cone();
    lighting.light_model.spectrum = std::make_shared<SpectralSamples>(8);
    frame.items = {square(lighting)};
    EXPECT_NE(why_not_kept(frame).find("spectra"), std::string::npos);
    frame.items = {square(attenuated_cone())};
    EXPECT_EQ(why_not_kept(frame), "");
}

// The page draws what core GL lacks.
TEST(KeptFiles, RefuseMoreThanThePage) {
    Draw draw = square(attenuated_cone());
    draw.raster.polygon_stipple = std::make_shared<const PolygonStipple>();
    Frame frame{.width = 8, .height = 8};
    frame.items = {draw};
    EXPECT_EQ(why_not_kept(frame), "");
    EXPECT_NE(why_not_in_files(frame).find("polygon stipple"), std::string::npos);
    draw = square(attenuated_cone());
    draw.raster.point_parameters.distance_attenuation = {1, 0, 1};
    frame.items = {draw};
    EXPECT_EQ(why_not_kept(frame), "");
    EXPECT_NE(why_not_in_files(frame).find("glPointParameter"), std::string::npos);
    draw = square(attenuated_cone());
    draw.further_units.resize(1);
    frame.items = {draw};
    EXPECT_EQ(why_not_kept(frame), "");
    EXPECT_NE(why_not_in_files(frame).find("glActiveTexture"), std::string::npos);
    frame.items = {Accumulate{.op = kGL_RETURN}};
    EXPECT_EQ(why_not_kept(frame), "");
    EXPECT_NE(why_not_in_files(frame).find("glAccum"), std::string::npos);
}

// ---- scene.c ----

// The statements of a function in their order, with those of the lists that it calls.
std::vector<std::string> statements(const std::string& text, const std::string& function) {
    std::vector<std::string> lines;
    std::istringstream body(text.substr(text.find("void " + function + "(void) {\n")));
    std::string line;
    std::getline(body, line);
    while (std::getline(body, line) && line != "}") {
        if (line.find("//") != line.npos || line.empty()) continue;
        line = line.substr(4);
        if (line.starts_with("list"))
            std::ranges::copy(statements(text, line.substr(0, line.find('('))), std::back_inserter(lines));
        else
            lines.push_back(line);
    }
    return lines;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; at += part.size()) ++count;
    return count;
}

// What a statement sets: its function without ff, gl, Enable and Disable, and its arguments but the last, or the names among them.
std::string what_it_sets(const std::string& statement) {
    const std::string function = statement.substr(2, statement.find('(') - 2);
    const std::string arguments = statement.substr(statement.find('('));
    if (function == "Enable" || function == "Disable") return arguments;
    const std::size_t value = arguments.find(", ");
    const std::size_t array = arguments.find(", (float[])");
    return function + arguments.substr(0, array != arguments.npos ? array : value);
}

// Twenty objects in two lists, and a sphere without one.
constexpr const char* kHouse = R"(
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3.0, 1, 100); glMatrixMode(GL_MODELVIEW);
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST); glEnable(GL_NORMALIZE);
glNewList(1, GL_COMPILE);
glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0.8, 0.3, 0.2, 1}); glutSolidTorus(0.2, 0.5, 8, 12);
glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0.2, 0.3, 0.8, 1});
glPushMatrix(); glTranslatef(0, 1, 0); glutSolidCube(1); glPopMatrix();
glEndList();
glNewList(2, GL_COMPILE); glutSolidTeapot(0.5); glEndList();
glTranslatef(0, -3, -20); glutSolidSphere(0.5, 16, 8);
)";
std::string house() {
    std::string text = kHouse;
    for (int i = 0; i < 10; ++i)
        for (int list = 1; list <= 2; ++list)
            text += fmt::format(
                "glPushMatrix(); glTranslatef({}, {}, 0); glRotatef({}, 1, 2, 3); glCallList({}); glPopMatrix();\n",
                i - 5, 3 * list, 17 * i * list, list);
    return text;
}

TEST(SceneText, HasEachMeshOnceAndSetsOnlyWhatChanges) {
    const auto list = std::make_shared<CommandList>(read_scene(house(), "house.gl", "house.gl"));
    const std::string text = text_of(kept_files(make_frame(*list, {}), {}, Glsl::k330, "house"), "scene.c");
    EXPECT_EQ(count_of(text, "static const struct mesh "), 4U) << text;
    EXPECT_EQ(count_of(text, "// house.gl:6:"), 2U) << "at the torus and at its draw\n" << text;
    EXPECT_EQ(count_of(text, "static void list1(void) {"), 1U) << text;
    EXPECT_EQ(count_of(text, "    list1();"), 10U) << text;
    EXPECT_LT(std::ranges::count(text, '\n'), 160) << text;

    std::map<std::string, std::string> last;
    std::size_t draws = 0;
    for (const std::string& statement : statements(text, "draw_scene")) {
        draws += statement.starts_with("draw(");
        if (!statement.starts_with("ff") && !statement.starts_with("gl")) continue;
        if (statement.find("Matrix") != statement.npos || statement.starts_with("glClear(")) continue;
        EXPECT_NE(std::exchange(last[what_it_sets(statement)], statement), statement) << text;
    }
    EXPECT_EQ(draws, 31U) << text;
}

std::vector<NamedFile> files_of_frames(const std::vector<Frame>& frames) {
    KeptScene scene;
    scene.name = "frames";
    scene.for_each_frame = [&](const auto& visit) {
        for (std::size_t i = 0; i < frames.size(); ++i) visit(frames[i], static_cast<int>(10 + i));
    };
    return kept_files(scene, {}, Glsl::k330);
}

TEST(SceneText, SharesWhatFramesHaveInCommon) {
    std::vector<Frame> frames;
    for (int i = 0; i < 3; ++i) {
        Draw draw = square(attenuated_cone());
        draw.eye_from_object[3] = {i, 1, -40, 1};
        frames.push_back({.width = 8, .height = 8, .items = {draw, draw}});
        draw.lighting.front.diffuse = {0.5, 0.4, 0.3, 1};
        frames.back().items.emplace_back(draw);
    }
    const auto one = files_of_frames({frames[0]}), several = files_of_frames(frames);
    const std::string text = text_of(several, "scene.c");
    EXPECT_EQ(count_of(text, "static void "), 1U) << text;
    EXPECT_NE(text.find("    ffMultMatrixf(frame_values);\n"), text.npos) << text;
    EXPECT_NE(text.find("    {10, draw_scene, 0, "), text.npos) << text;
    EXPECT_NE(text.find("    {12, draw_scene, 2, "), text.npos) << text;
    EXPECT_EQ(text_of(several, "scene.bin").size(), text_of(one, "scene.bin").size() + 3 * 16 * sizeof(float));
    EXPECT_EQ(text_of(several, "kinds.c"), text_of(one, "kinds.c"));
    // Without frames there is nothing that differs.
    EXPECT_EQ(text_of(one, "scene.c").find("frame_values"), std::string::npos);
}

TEST(SceneText, HasAMeshForEachFrameThatMovesVertices) {
    std::vector<Frame> frames;
    for (int i = 0; i < 2; ++i) {
        Draw draw = square(attenuated_cone());
        draw.vertices.edit()[0].position_object.x += 0.1 * i;
        frames.push_back({.width = 8, .height = 8, .items = {draw}});
    }
    const std::string text = text_of(files_of_frames(frames), "scene.c");
    EXPECT_EQ(count_of(text, "static void "), 1U) << text;
    EXPECT_NE(text.find("    draw(mesh[frame_index]);\n"), text.npos) << text;
}

TEST(SceneText, HasAFunctionForFramesWithOtherDraws) {
    const Draw draw = square(attenuated_cone());
    LightingState unlit = dark();
    unlit.enabled = false;
    const std::string text = text_of(files_of_frames({{.width = 8, .height = 8, .items = {draw}},
                                                      {.width = 8, .height = 8, .items = {draw, square(unlit)}},
                                                      {.width = 8, .height = 8, .items = {draw}}}),
                                     "scene.c");
    EXPECT_EQ(count_of(text, "static void "), 2U) << text;
    for (const char* row : {"    {10, draw_frame10, 0, ", "    {11, draw_frame11, 0, ", "    {12, draw_frame10, 1, "})
        EXPECT_NE(text.find(row), text.npos) << row << " in\n" << text;
}

// Table 2.12: the last vertex gives a flat colour; for a line loop's last line, the first.
TEST(SeparateElements, KeepTheLastVertexAndTheFace) {
    using Indices = std::vector<std::uint32_t>;
    EXPECT_EQ(separate_elements({kGL_TRIANGLE_STRIP, {5, 6, 7, 8}}),
              CoreElements(kGL_TRIANGLES, Indices{5, 6, 7, 7, 6, 8}));
    EXPECT_EQ(separate_elements({kGL_TRIANGLE_FAN, {5, 6, 7, 8}}),
              CoreElements(kGL_TRIANGLES, Indices{5, 6, 7, 5, 7, 8}));
    EXPECT_EQ(separate_elements({kGL_LINE_STRIP, {5, 6, 7}}), CoreElements(kGL_LINES, Indices{5, 6, 6, 7}));
    EXPECT_EQ(separate_elements({kGL_LINE_LOOP, {5, 6, 7}}), CoreElements(kGL_LINES, Indices{5, 6, 6, 7, 7, 5}));
    EXPECT_EQ(separate_elements({kGL_TRIANGLES, {5, 6, 7, 8}}), CoreElements(kGL_TRIANGLES, Indices{5, 6, 7}));
    EXPECT_EQ(separate_elements({kGL_POINTS, {5, 6}}), CoreElements(kGL_POINTS, Indices{5, 6}));
}

// Planes keep the coordinates that glTexGen was given them for, so that they stay right in other poses.
TEST(KeptFiles, GenerateTextureCoordinates) {
    Draw draw = square(attenuated_cone());
    auto texture = std::make_shared<Texture>();
    texture->levels = {{.width = 1, .height = 1, .texels = {glm::vec4(1)}}};
    texture->min_filter = kGL_LINEAR;
    draw.texture.texture = texture;
    draw.texture.generated = {{.coordinate = 0, .mode = kGL_EYE_LINEAR, .plane = {1, 0, 0, 2}},
                              {.coordinate = 1, .mode = kGL_OBJECT_LINEAR, .plane = {0, 3, 0, 4}}};
    const std::vector<NamedFile> planes = files_of({draw});
    const std::string shader = text_of(planes, "kind1.vert"), scene = text_of(planes, "scene.c");
    EXPECT_NE(shader.find("tex_coord.s = dot(EyePlaneS[0], position_eye);"), std::string::npos) << shader;
    EXPECT_NE(shader.find("tex_coord.t = dot(ObjectPlaneT[0], Vertex);"), std::string::npos) << shader;
    EXPECT_EQ(shader.find("MultiTexCoord0"), std::string::npos) << shader;
    EXPECT_NE(scene.find("ffTexGenfv(GL_S, GL_EYE_PLANE, (float[]){1, 0, 0, 2});"), std::string::npos) << scene;
    EXPECT_NE(scene.find("ffTexGenfv(GL_T, GL_OBJECT_PLANE, (float[]){0, 3, 0, 4});"), std::string::npos) << scene;
    draw.texture.generated = {{.coordinate = 0, .mode = kGL_SPHERE_MAP}};
    draw.lighting.normalize = false;
    draw.lighting.rescale_normal = true;
    const std::string sphere = text_of(files_of({draw}), "kind1.vert");
    EXPECT_NE(sphere.find("vec3 normal_eye = NormalScale * (NormalMatrix * Normal);"), std::string::npos) << sphere;
    EXPECT_NE(sphere.find("tex_coord.s = sphere_map(reflected).x;"), std::string::npos) << sphere;
}

}  // namespace
}  // namespace twinlight::programmable::kept_files_test
