// The rows of lights, materials and the light model, against the table of parameters and against State.
#include "scene/state/lighting_parameters.h"

#include <gtest/gtest.h>

#include "scene/state/state.h"

namespace twinlight::lighting_parameters_test {

namespace {

// Each row has as many values as the table says; each parameter of the table has a row, but `odd`.
template <class Owner>
void check_rows(twinlight::Owner of, std::initializer_list<Enum> odd) {
    std::size_t found = 0;
    for (const ParameterInfo& info : parameter_infos()) {
        if (info.owner != of || std::ranges::find(odd, info.pname) != odd.end()) continue;
        const LightingParameter<Owner>* const row = find_lighting_parameter<Owner>(info.pname);
        ASSERT_NE(row, nullptr) << enum_name(info.pname);
        EXPECT_EQ(values_of(Owner(), *row).size(), static_cast<std::size_t>(info.count)) << enum_name(info.pname);
        ++found;
    }
    EXPECT_EQ(found, lighting_parameters<Owner>().size());
}

TEST(LightingParameters, AreThoseOfTheTable) {
    check_rows<LightSource>(Owner::kLight, {});
    check_rows<Material>(Owner::kMaterial, {kGL_AMBIENT_AND_DIFFUSE, kGL_COLOR_INDEXES});
    check_rows<LightModel>(Owner::kLightModel, {});
}

// What is set is read again from the same member, and changes no other.
template <class Owner>
void check_members() {
    const auto rows = lighting_parameters<Owner>();
    for (const LightingParameter<Owner>& row : rows) {
        Owner changed;
        std::vector<double> values = values_of(changed, row);
        for (double& value : values) value = value == 0 ? 1 : 0;
        set_parameter(changed, row, values);
        EXPECT_EQ(values_of(changed, row), values) << enum_name(row.pname);
        for (const LightingParameter<Owner>& other : rows)
            EXPECT_EQ(has_equal(changed, Owner(), other), &other != &row) << enum_name(other.pname);
    }
}

TEST(LightingParameters, HaveAMemberEach) {
    check_members<LightSource>();
    check_members<Material>();
    check_members<LightModel>();
}

TEST(LightingParameters, TellFlagsFromNumbers) {
    EXPECT_TRUE(is_flag(*find_lighting_parameter<LightModel>(kGL_LIGHT_MODEL_TWO_SIDE)));
    EXPECT_FALSE(is_flag(*find_lighting_parameter<LightModel>(kGL_LIGHT_MODEL_COLOR_CONTROL)));
    EXPECT_EQ(find_lighting_parameter<Material>(kGL_POSITION), nullptr);
    EXPECT_EQ(find_lighting_parameter<Material>(kGL_AMBIENT_AND_DIFFUSE), nullptr);
}

}  // namespace

}  // namespace twinlight::lighting_parameters_test
