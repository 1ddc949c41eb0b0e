#include "app/demo/value_rows.h"

namespace twinlight::demo {
namespace {

template <class Vector>
bool edit_numbers(const char* id, const Vector& vector, std::vector<double>& edited, float speed) {
    constexpr int kCount = static_cast<int>(Vector::length());
    float numbers[4] = {};
    for (int i = 0; i < kCount; ++i) numbers[i] = static_cast<float>(vector[i]);
    if (!ImGui::DragScalarN(id, ImGuiDataType_Float, numbers, kCount, speed, nullptr, nullptr, kNumberFormat))
        return false;
    edited.clear();
    for (int i = 0; i < kCount; ++i) edited.push_back(readable(numbers[i]));
    return true;
}

}  // namespace

bool vector_edit(const char* id, const glm::dvec4& vector, std::vector<double>& edited, float speed) {
    return edit_numbers(id, vector, edited, speed);
}

bool vector_edit(const char* id, const glm::dvec3& vector, std::vector<double>& edited, float speed) {
    return edit_numbers(id, vector, edited, speed);
}

bool color_edit(const char* id, const glm::dvec4& color, std::vector<double>& edited) {
    constexpr ImGuiColorEditFlags kFlags =
        ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoLabel;
    float rgb[3] = {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
    if (!ImGui::ColorEdit3(id, rgb, kFlags)) return false;
    edited = {readable(rgb[0]), readable(rgb[1]), readable(rgb[2]), color.a};
    return true;
}

bool number_edit(const char* id, double number, float smallest, float largest, const char* format, double& edited) {
    auto value = static_cast<float>(number);
    if (!ImGui::SliderFloat(id, &value, smallest, largest, format)) return false;
    edited = readable(value);
    return true;
}

}  // namespace twinlight::demo
