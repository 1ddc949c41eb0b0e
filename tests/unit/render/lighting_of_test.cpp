// How a light arrives at a point: derived by hand from section 2.14.1.
#include "render/lighting_of.h"

#include <gtest/gtest.h>

namespace twinlight::lighting_of_test {

namespace {

LightSource point_light(const glm::dvec3& place) {
    LightSource light;
    light.position_eye = glm::dvec4(place, 1);
    return light;
}

TEST(Arrival, IsWeakerWithDistance) {
    LightSource light = point_light({0, 0, 3});
    light.constant_attenuation = 1;
    light.linear_attenuation = 0.5;
    light.quadratic_attenuation = 0.25;
    light.position_eye *= 2.0;                             // w = 2: the same place
    const Arrival arrival = arrival_at({0, 0, 1}, light);  // d = 2
    EXPECT_EQ(arrival.to_light_dir, glm::dvec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(arrival.attenuation, 1 / (1 + 0.5 * 2 + 0.25 * 4));
    EXPECT_EQ(arrival.spot, 1);
}

TEST(Arrival, OfADirectionalLightIsNotAttenuated) {
    LightSource light;
    light.position_eye = {0, 3, 4, 0};
    light.quadratic_attenuation = 5;
    const Arrival arrival = arrival_at({7, 8, 9}, light);
    EXPECT_NEAR(glm::distance(arrival.to_light_dir, glm::dvec3(0, 0.6, 0.8)), 0, 1e-15);
    EXPECT_EQ(arrival.reach(), 1);
}

TEST(Arrival, IsThatOfGlsCone) {
    LightSource light = point_light({0, 0, 0});
    light.spot_direction_eye = {0, 0, -2};  // of any length
    light.spot_cutoff_deg = 45;
    light.spot_exponent = 2;
    EXPECT_NEAR(arrival_at({0, 3, -4}, light).spot, 0.8 * 0.8, 1e-15);  // cos = 4 / 5
    EXPECT_NEAR(arrival_at({0, 1, -1}, light).spot, 0.5, 1e-15);        // the border belongs to the cone
    EXPECT_EQ(arrival_at({0, 5, -4}, light).spot, 0);
    light.smooth_cone = LightSource::SmoothCone{.inner_deg = 60, .outer_deg = 90};  // not GL's
    EXPECT_EQ(arrival_at({0, 5, -4}, light).spot, 0);
}

// RULING: no attenuation factor gives 0, and a light at the point has no direction.
TEST(Arrival, HasNoInfinity) {
    LightSource light = point_light({1, 2, 3});
    light.constant_attenuation = 0;
    EXPECT_EQ(arrival_at({0, 0, 0}, light).attenuation, 0);
    EXPECT_EQ(arrival_at({1, 2, 3}, light).to_light_dir, glm::dvec3(0));
}

}  // namespace

}  // namespace twinlight::lighting_of_test
