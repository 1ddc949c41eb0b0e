// The shader files have few directives, and the exported text reads like the equation.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "../hand_built_draws.h"
#include "render/programmable/text/shader_assembly.h"
#include "render/programmable/text/shader_pieces.h"

namespace twinlight::programmable::shader_files_test {
namespace {

// Programs take whole functions, and C++ writes each light's block, so the files need few conditional lines.
TEST(ShaderFiles, HaveFewDirectivesAndSwitches) {
    constexpr std::size_t kMostDirectives = 300, kMostSwitches = 45;  // not included
    std::size_t directives = 0;
    std::set<std::string> switches;
    for (const EmbeddedFile& file : kShaderFiles) {
        std::istringstream lines{std::string(file.text)};
        for (std::string line; std::getline(lines, line);) {
            directives += line.starts_with('#');
            static const std::regex kSwitch("EFFECT_\\w+");
            for (std::sregex_iterator found(line.begin(), line.end(), kSwitch), end; found != end; ++found)
                switches.insert(found->str());
        }
    }
    EXPECT_GT(directives, 0u);
    EXPECT_LT(directives, kMostDirectives);
    EXPECT_LT(switches.size(), kMostSwitches);
}

TEST(ShaderFiles, ReplaceWholeWordsOnly) {
    const std::vector<Definition> whole = definitions("equation.glsl", {{"EXPONENT", "int"}, {"n", "x"}});
    for (const Definition& definition : whole) {
        EXPECT_EQ(definition.text.find("EXPONENT"), std::string::npos);
        if (definition.name == "unit") {
            EXPECT_NE(definition.text.find("length(v)"), std::string::npos) << "the n of length is no word";
        }
    }
}

TEST(ShaderFiles, GiveWhatATextNamesAndWhatThatNames) {
    const std::vector<Definition> library = {{"a", "float a() { return 1.0; }\n"},
                                             {"b", "float b() { return a(); }  // not c\n"},
                                             {"c", "float c() { return b(); }\n"}};
    const auto names = [&](const char* text) {
        std::string result;
        for (const Definition& definition : used_definitions(library, text)) result += definition.name;
        return result;
    };
    EXPECT_EQ(names("x = b();"), "ab");
    EXPECT_EQ(names("x = c();"), "abc");
    EXPECT_EQ(names("x = ab();  // b()"), "");
}

std::string exported_cone() {
    LightingState lighting = cone();
    LightSource& light = lighting.lights[0];
    light.linear_attenuation = 0.5;
    light.spot_exponent = 3;
    Frame frame;
    frame.items = {square(lighting)};
    return shader_source(frame, {});
}

TEST(ExportedShaders, HaveTheEquationsFunctionsAndCallThem) {
    const std::string text = exported_cone();
    for (const char* function : {"float attenuation(", "float spot(", "float highlight(", "float positive_dot("})
        EXPECT_NE(text.find(function), text.npos) << function << " in\n" << text;
    for (const char* call :
         {"float reach = attenuation(u_light0_attenuation, length(vp)) *",
          "spot(u_light0_spot_dir_object, u_light0_cos_cutoff, u_light0_spot_exponent, vp_dir);",
          "lit.primary.rgb += reach * u_light0_front_ambient;",
          "lit.primary.rgb += reach * n_dot_vp * u_light0_front_diffuse;", "reach * bounded(highlight(n_dot_vp, "})
        EXPECT_NE(text.find(call), text.npos) << call << " in\n" << text;
    EXPECT_NE(text.find("section 2.14.1"), text.npos);
}

// Each function appears once, and every function is called.
TEST(ExportedShaders, HaveNoFunctionTwiceAndNoneThatIsNotCalled) {
    const std::string text = exported_cone();
    const std::string vertex = text.substr(0, text.find("// ---- Fragment shader"));
    static const std::regex kFunction("\\n(?:float|vec3|vec4|Lit) (\\w+)\\(");
    std::set<std::string> names;
    for (std::sregex_iterator found(vertex.begin(), vertex.end(), kFunction), end; found != end; ++found) {
        const std::string name = (*found)[1];
        EXPECT_TRUE(names.insert(name).second) << name;
        const std::regex named("\\b" + name + "\\(");
        EXPECT_GE(std::distance(std::sregex_iterator(vertex.begin(), vertex.end(), named), std::sregex_iterator()), 2)
            << name;
    }
    EXPECT_GE(names.size(), 6u);
}

}  // namespace
}  // namespace twinlight::programmable::shader_files_test
