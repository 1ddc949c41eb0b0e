// Widgets that the panels share: rows with a label and a value, whose changes are readable numbers.
#pragma once

#include <imgui.h>

#include <cmath>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "app/demo/widgets.h"
#include "app/session/session.h"

namespace twinlight::demo {

constexpr float kLabelWidth = 114;  // at scale 1
constexpr const char* kNumberFormat = "%.3g";

// What a widget gives, without the digits that only floats have.
inline double readable(float value) { return std::round(static_cast<double>(value) * 1000) / 1000; }

// The value after a label, up to the panel's right edge.
inline void begin_value() {
    ImGui::SameLine(at_scale(kLabelWidth));
    ImGui::SetNextItemWidth(-1);
}

// A drag is one step of undo: call this after its widget.
inline void end_group_after_drag(session::Session& session) {
    if (ImGui::IsItemDeactivatedAfterEdit()) session.history.end_group();
}

// These show a value, and return whether the user changed it; then `edited` has the new one. Alpha stays.
bool color_edit(const char* id, const glm::dvec4& color, std::vector<double>& edited);
bool vector_edit(const char* id, const glm::dvec4& vector, std::vector<double>& edited, float speed);
bool vector_edit(const char* id, const glm::dvec3& vector, std::vector<double>& edited, float speed);
bool number_edit(const char* id, double number, float smallest, float largest, const char* format, double& edited);

}  // namespace twinlight::demo
