#include "judge/compare/queries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scene/command/names.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::compare {

namespace {

// "glGetLightfv(GL_LIGHT0, GL_POSITION)", without the array for the result.
std::string call_of(const Command& query) {
    std::vector<std::string> arguments;
    for (std::size_t i = 0; i < query.sig().parameters.size(); ++i) {
        const Parameter& parameter = query.sig().parameters[i];
        if (parameter.extent == Extent::kValue) arguments.push_back(enum_name(query.enumerant(query.first(i))));
    }
    return fmt::format("{}({})", query.name(), fmt::join(arguments, ", "));
}

// Whether the value is one of GL's names.
bool returns_name(const Command& query) {
    const Enum pname = query.enumerant(query.sig().parameters.size() > 2 ? 1 : 0);
    switch (pname) {
        case kGL_ACTIVE_TEXTURE:
        case kGL_ALPHA_TEST_FUNC:
        case kGL_BLEND_DST:
        case kGL_BLEND_SRC:
        case kGL_COLOR_MATERIAL_FACE:
        case kGL_COLOR_MATERIAL_PARAMETER:
        case kGL_CULL_FACE_MODE:
        case kGL_DEPTH_FUNC:
        case kGL_FOG_MODE:
        case kGL_FRONT_FACE:
        case kGL_LIGHT_MODEL_COLOR_CONTROL:
        case kGL_MATRIX_MODE:
        case kGL_POLYGON_MODE:
        case kGL_RENDER_MODE:
        case kGL_SHADE_MODEL:
        case kGL_TEXTURE_ENV_MODE:
        case kGL_TEXTURE_GEN_MODE:
        case kGL_TEXTURE_MAG_FILTER:
        case kGL_TEXTURE_MIN_FILTER:
        case kGL_TEXTURE_WRAP_S:
        case kGL_TEXTURE_WRAP_T: return true;
        default: return false;
    }
}

std::string text_of(const Command& query, const std::vector<double>& values) {
    if (values.empty()) return "?";
    const bool is_boolean = query.sig().parameters.back().kind == Kind::kBoolean;
    const bool is_name = !is_boolean && returns_name(query);
    std::vector<std::string> words;
    for (const double value : values) {
        if (is_boolean)
            words.emplace_back(value != 0 ? "GL_TRUE" : "GL_FALSE");
        else if (is_name)
            words.push_back(enum_name(static_cast<Enum>(value)));
        else
            words.push_back(std::abs(value) < 1e15 && value == std::trunc(value) ? fmt::format("{:.0f}", value + 0.0)
                                                                                 : fmt::format("{:.6g}", value));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

bool agree(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.empty() || b.empty()) return true;
    constexpr double kFloats = 1e-5;  // products of a few matrices in floats
    return std::ranges::equal(a, b, [](double x, double y) {
        return std::abs(x - y) <= kFloats * std::max({1.0, std::abs(x), std::abs(y)});
    });
}

}  // namespace

std::vector<Query> queries_of(const Scene& scene, const DriversAnswers& drivers_answers) {
    const CommandList* commands = scene.recording->command_list();
    const auto is_query = [](const Command& command) { return is_answered(command.id); };
    if (!commands || std::ranges::none_of(commands->commands, is_query)) return {};
    const std::vector<std::vector<double>> of_driver =
        drivers_answers ? drivers_answers(scene) : std::vector<std::vector<double>>();
    std::vector<Query> queries;
    State state({.width = scene.frame.width, .height = scene.frame.height});
    for (const Command& command : commands->commands) {
        state.apply(command);
        if (!is_query(command)) continue;
        if (queries.size() >= kMostQueries) break;
        const std::vector<double> ours = answer(state, command);
        const std::vector<double> drivers =
            queries.size() < of_driver.size() ? of_driver[queries.size()] : std::vector<double>();
        queries.push_back(
            {command.place, call_of(command), text_of(command, ours), text_of(command, drivers), agree(ours, drivers)});
    }
    return queries;
}

std::string sentence_of(const Query& query) {
    const std::string driver = query.driver == "?" ? "" : query.driver == query.state ? "the same" : query.driver;
    return fmt::format("{}: {} returns {}{}", query.place.str(), query.call, query.state,
                       driver.empty() ? "" : fmt::format(" (driver: {})", driver));
}

}  // namespace twinlight::compare
