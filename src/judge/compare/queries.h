// What a scene's queries (glGet*, glIsEnabled) return, from Twinlight's state and from the driver.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/frame/scene.h"

namespace twinlight::compare {

// The values as text; "?" where there is none.
struct Query {
    Place place;
    std::string call;  // "glGetLightfv(GL_LIGHT0, GL_POSITION)"
    std::string state, driver;
    bool agree = true;  // within the precision of floats; true if one of the two gives no answer
};

inline constexpr std::size_t kMostQueries = 100;

// fixed::answers().
using DriversAnswers = std::function<std::vector<std::vector<double>>(const Scene&)>;

// The first kMostQueries queries of a scene; none for a recorded program.
std::vector<Query> queries_of(const Scene& scene, const DriversAnswers& drivers_answers);

// "sphere.gl:3:1: glIsEnabled(GL_LIGHTING) returns GL_TRUE (driver: the same)".
std::string sentence_of(const Query& query);

}  // namespace twinlight::compare
