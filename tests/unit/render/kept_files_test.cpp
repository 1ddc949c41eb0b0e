// Shaders to keep: planned by state and not by pose, one pair for each kind, GL's names, every version's spelling.
#include "render/programmable/export/kept_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "../hand_built_draws.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/text/kept_text.h"
#include "render/webgl/exported_page.h"

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
                                               "gl_state.h", "gl_state.c", "names.sed", "scene.c", "scene.bin", "scene.h",
                                               "window.c", "README.md"}));
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
