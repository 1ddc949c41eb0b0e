// The rows of parameters, against the table of parameters and against State.
#include "scene/frame/parameter_rows.h"

#include <gtest/gtest.h>

#include "scene/state/state.h"

namespace twinlight::parameter_rows_test {

namespace {

// Each row has as many values as the table says; each parameter of the table has a row, but `odd`.
template <class Owner>
void check_rows(twinlight::Owner of, std::initializer_list<Enum> odd) {
    std::size_t found = 0;
    for (const ParameterInfo& info : parameter_infos()) {
        if (info.owner != of || std::ranges::find(odd, info.pname) != odd.end()) continue;
        const ParameterRow<Owner>* const row = find_parameter_row<Owner>(info.pname);
        ASSERT_NE(row, nullptr) << enum_name(info.pname);
        EXPECT_EQ(values_of(Owner(), *row).size(), static_cast<std::size_t>(info.count)) << enum_name(info.pname);
        ++found;
    }
    EXPECT_EQ(found, kParameterRows<Owner>.size());
}

TEST(ParameterRows, AreThoseOfTheTable) {
    check_rows<LightSource>(Owner::kLight, {});
    check_rows<Material>(Owner::kMaterial, {kGL_AMBIENT_AND_DIFFUSE, kGL_COLOR_INDEXES});
    check_rows<LightModel>(Owner::kLightModel, {});
    check_rows<Texture>(Owner::kTexture, {});
    check_rows<PixelStore>(Owner::kPixelStore, {});
}

// What is set is read again from the same member, and changes no other.
template <class Owner>
void check_members() {
    const auto rows = kParameterRows<Owner>;
    for (const ParameterRow<Owner>& row : rows) {
        Owner changed;
        std::vector<double> values = values_of(changed, row);
        for (double& value : values) value = value == 0 ? 1 : 0;
        set_parameter(changed, row, values);
        EXPECT_EQ(values_of(changed, row), values) << enum_name(row.pname);
        for (const ParameterRow<Owner>& other : rows)
            EXPECT_EQ(has_equal(changed, Owner(), other), &other != &row) << enum_name(other.pname);
    }
}

TEST(ParameterRows, HaveAMemberEach) {
    check_members<LightSource>();
    check_members<Material>();
    check_members<LightModel>();
    check_members<Texture>();
    check_members<PixelStore>();
}

TEST(ParameterRows, TellFlagsFromNumbers) {
    EXPECT_TRUE(is_flag(*find_parameter_row<LightModel>(kGL_LIGHT_MODEL_TWO_SIDE)));
    EXPECT_FALSE(is_flag(*find_parameter_row<LightModel>(kGL_LIGHT_MODEL_COLOR_CONTROL)));
    EXPECT_EQ(find_parameter_row<Material>(kGL_POSITION), nullptr);
    EXPECT_EQ(find_parameter_row<Material>(kGL_AMBIENT_AND_DIFFUSE), nullptr);
}

}  // namespace

}  // namespace twinlight::parameter_rows_test
