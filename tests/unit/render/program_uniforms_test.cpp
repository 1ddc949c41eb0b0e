// The list of uniforms. light_values_test.cpp checks that every program has values for it.
#include "render/programmable/numbers/program_uniforms.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "render/programmable/numbers/light_values.h"
#include "render/programmable/text/lighting_names.h"
#include "render/programmable/text/shader_pieces.h"

namespace twinlight::programmable::program_uniforms_test {
namespace {

TEST(ProgramUniforms, HaveDifferentNames) {
    std::set<std::string> names;
    std::size_t count = 0;
    const auto add = [&](const std::string& name) {
        EXPECT_TRUE(name.starts_with("u_")) << name;
        EXPECT_TRUE(names.insert(name).second) << name;
        ++count;
    };
    for_each_uniform([&](auto value) {
        add(name_of(value));
        EXPECT_FALSE(declaration_of(value).type.empty()) << name_of(value);
    });
    EXPECT_GT(count, 70u);
    for (int i = 0; i < 8; ++i) add(clip_plane_name(i));
    for (const ModelValue value : {ModelValue::kConstantAmbient, ModelValue::kRgbFromSamples})
        add(std::string(declaration_of(value, {}).name));
    EffectSet effects;
    effects.lights.resize(2);
    for (const char* face : {"front", "back"}) {
        for (const FaceValue value : {FaceValue::kBase, FaceValue::kAlpha, FaceValue::kShininess})
            add(name_of(face, value, effects));
        for (const LightValue color : {LightValue::kAmbient, LightValue::kDiffuse, LightValue::kSpecular})
            add(name_of_face_samples(face, color));
    }
    for (const std::size_t i : {0, 1}) {
        add(name_of_count(i));
        for (std::size_t number = 0; number < kLightValueCount; ++number) {
            const auto value = static_cast<LightValue>(number);
            const LightUniform uniform = declaration_of(value, effects, {}, i);
            if (is_color(value)) add(name_of_light_samples(i, value));
            for (const char* face : {"front", "back"})
                if (is_color(value)) add(name_of(i, uniform, face));
            if (!is_color(value)) add(name_of(i, uniform));
        }
    }
}

TEST(ProgramUniforms, HaveTheirNamesInTheUniformsOfADraw) {
    Uniforms uniforms;
    const LightUniform position = declaration_of(LightValue::kPosition, {}, {}, 0);
    const LightUniform diffuse = declaration_of(LightValue::kDiffuse, {}, {}, 0);
    add_to(uniforms, 3, position);
    add_to(uniforms, 12, diffuse, "back");
    add_to(uniforms, "front", FaceValue::kBase, {});
    EXPECT_EQ(uniforms[0].name, name_of(3, position));
    EXPECT_EQ(uniforms[1].name, name_of(12, diffuse, "back"));
    EXPECT_EQ(uniforms[2].name, name_of("front", FaceValue::kBase, {}));
    EXPECT_EQ(uniforms[0].name, "u_light3_position_eye");
    EXPECT_EQ(uniforms[1].name, "u_light12_back_diffuse");
    EXPECT_EQ(uniforms[2].name, "u_front_base");
}

TEST(ProgramUniforms, MustBeDeclaredWhereAShaderUsesThem) {
    const std::string declared = "uniform vec4 u_a;  // not u_b\nuniform float u_c[3];\n";
    EXPECT_NO_THROW(check_uniforms_are_declared(declared + "x = u_a * u_c[2];  // u_d\n"));
    try {
        check_uniforms_are_declared(declared + "x = u_a * u_b;\n");
        FAIL() << "u_b is not declared";
    } catch (const std::logic_error& error) {
        EXPECT_NE(std::string(error.what()).find("u_b,"), std::string::npos) << error.what();
    }
    EXPECT_THROW(check_uniforms_are_declared("x = u_a.x;\n"), std::logic_error);
}

TEST(ProgramUniforms, OfLightsAndMaterialsMustBeListed) {
    EffectSet effects;
    effects.lighting = true;
    effects.front.varies_shininess = effects.front.tracks_diffuse = true;
    effects.lights.resize(1);
    effects.lights[0].ambient = true;
    const Form form;
    LightingNames names(effects, form);
    EXPECT_THROW(names.model(ModelValue::kRgbFromSamples), std::logic_error);
    EXPECT_THROW(names.model(ModelValue::kConstantAmbient), std::logic_error);
    EXPECT_THROW(names.light(0, LightValue::kSpotDir), std::logic_error);
    EXPECT_THROW(names.sample_product(0, "front", LightValue::kAmbient), std::logic_error);
    EXPECT_THROW(names.alpha("front", {}), std::logic_error);
    EXPECT_EQ(names.declarations(), "");
    EXPECT_EQ(names.product(0, "front", LightValue::kAmbient, {}), "u_light0_front_ambient");
    EXPECT_EQ(names.declarations(), "uniform vec3 u_light0_front_ambient;  // a_cm a_cli\n");
}

}  // namespace
}  // namespace twinlight::programmable::program_uniforms_test
