#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/text/translation.h"
#include "judge/study/choice.h"

namespace twinlight::study {

namespace {

// ---- Axes of names ----

template <class Enum>
struct Named {
    Enum value;
    const char* key;
    const char* words;
};

constexpr Named<Method> kMethods[] = {
    {Method::kFixed, "fixed", "fixed function"},
    {Method::kUniforms, "shaders", "shaders with uniforms"},
    {Method::kConstants, "shaders-baked", "shaders with constants"},
    {Method::kPrecise, "shaders-precise", "precise shaders"},
    {Method::kReference, "reference", "reference"},
};
constexpr Named<fixed::Sending> kSendings[] = {
    {fixed::Sending::kBuffers, "buffers", "buffers"},
    {fixed::Sending::kClientArrays, "client-arrays", "client arrays"},
    {fixed::Sending::kImmediate, "immediate", "immediate mode"},
    {fixed::Sending::kDisplayList, "display-list", "display list"},
};
constexpr Named<Target> kTargets[] = {
    {Target::kCodes, "8-bit", "8-bit colours"},
    {Target::kFloats, "float", "float colours"},
};

constexpr Named<Number> kNumbers[] = {
    {Number::kDouble, "double", "doubles"},
    {Number::kFloat, "floats", "floats"},
    {Number::kLongDouble, "long-double", "long doubles"},
};
constexpr Named<Powers> kPowers[] = {
    {Powers::kPow, "pow", "powers by pow()"},
    {Powers::kSquaring, "squaring", "powers by repeated squaring"},
    {Powers::kTable, "table", "powers by a table"},
};

std::span<const Named<Method>> names(Method) { return kMethods; }
std::span<const ShadingName> names(Shading) { return kShadings; }
std::span<const LightingChangeRow> names(LightingChange) { return lighting_changes(); }
std::span<const Named<fixed::Sending>> names(fixed::Sending) { return kSendings; }
std::span<const Named<Target>> names(Target) { return kTargets; }
std::span<const Named<Number>> names(Number) { return kNumbers; }
std::span<const Named<Powers>> names(Powers) { return kPowers; }

// Whether a choice's words and key name the value.
enum class Mention : std::uint8_t { kAlways, kUnlessUsual };

template <auto member, Mention mention>
constexpr Axis of_names(const char* name, const char* words) {
    return {.name = name,
            .words = words,
            .is_number = false,
            .prefix = "",
            .value =
                [](const Choice& choice) {
                    const auto value = choice.*member;
                    for (const auto& row : names(value))
                        if (row.value == value)
                            return Value{row.key, row.words, mention == Mention::kAlways || value != Choice{}.*member};
                    return Value{};
                },
            .set =
                [](Choice& choice, std::string_view key) {
                    for (const auto& row : names(choice.*member)) {
                        if (row.key != key) continue;
                        choice.*member = row.value;
                        return true;
                    }
                    return false;
                },
            .keys =
                [] {
                    std::string text;
                    for (const auto& row : names(Choice{}.*member))
                        text += (text.empty() ? "" : ", ") + std::string(row.key);
                    return text;
                }};
}

// ---- Axes of numbers ----

template <auto member>
bool set_number(Choice& choice, std::string_view key, double least) {
    double number = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
    constexpr double kMost = 1e6;
    if (error != std::errc{} || end != key.data() + key.size() || !(number >= least && number <= kMost)) return false;
    choice.*member = static_cast<std::remove_reference_t<decltype(choice.*member)>>(number);
    return choice.*member == number;
}

std::string no_keys() { return {}; }

constexpr Axis kSlices = {.name = "slices",
                          .words = "slices of round shapes",
                          .is_number = true,
                          .prefix = "",
                          .value =
                              [](const Choice& choice) {
                                  if (choice.slices == 0) return Value{"", "as in the scene", false};
                                  return Value{std::to_string(choice.slices), tr("{} slices", choice.slices)};
                              },
                          .set =
                              [](Choice& choice, std::string_view key) {
                                  if (key.empty()) choice.slices = 0;
                                  return key.empty() || set_number<&Choice::slices>(choice, key, 1);
                              },
                          .keys = no_keys};

constexpr Axis kSamples = {
    .name = "samples",
    .words = "samples per pixel",
    .is_number = true,
    .prefix = "samples-",
    .value =
        [](const Choice& choice) {
            return Value{std::to_string(choice.samples), fmt::format("{0} x {0} samples", choice.samples),
                         choice.samples != 1};
        },
    .set = [](Choice& choice, std::string_view key) { return set_number<&Choice::samples>(choice, key, 1); },
    .keys = no_keys};

constexpr Axis kBudget = {
    .name = "budget",
    .words = "what shaders may skip",
    .is_number = true,
    .prefix = "budget-",
    .value =
        [](const Choice& choice) {
            return Value{
                fmt::format("{}", choice.budget),
                choice.budget == 0 ? "nothing skipped" : fmt::format("skipping up to {:.3g}/255", 255 * choice.budget),
                choice.budget != PlanOptions{}.budget};
        },
    .set = [](Choice& choice, std::string_view key) { return set_number<&Choice::budget>(choice, key, 0); },
    .keys = no_keys};

}  // namespace

const std::vector<Axis>& axes() {
    static const std::vector<Axis> all = {
        of_names<&Choice::method, Mention::kAlways>("renderer", "renderer"),
        of_names<&Choice::shading, Mention::kAlways>("shading", "shading"),
        kSlices,
        of_names<&Choice::lighting_change, Mention::kUnlessUsual>("model", "lighting model"),
        of_names<&Choice::sending, Mention::kUnlessUsual>("sending", "how vertices are sent"),
        of_names<&Choice::target, Mention::kUnlessUsual>("target", "colour buffer"),
        kSamples,
        of_names<&Choice::number, Mention::kUnlessUsual>("number", "number type of the reference"),
        of_names<&Choice::powers, Mention::kUnlessUsual>("powers", "powers in the reference"),
        kBudget,
    };
    return all;
}

std::string Choice::words() const {
    std::string text;
    for (const Axis& axis : axes())
        if (const Value value = axis.value(*this); value.is_mentioned)
            text += (text.empty() ? "" : tr(", ")) + tr(value.words);
    return text;
}

std::string Choice::key() const {
    std::string text;
    for (const Axis& axis : axes())
        if (const Value value = axis.value(*this); value.is_mentioned)
            text += (text.empty() ? "" : "-") + std::string(axis.prefix) + value.key;
    return text;
}

programmable::Options Choice::shader_options() const {
    return {{{.shading = shading}, budget},
            method == Method::kConstants ? programmable::Tier::kBaked : programmable::Tier::kUniform,
            method == Method::kPrecise};
}

reference::Options Choice::reference_options() const {
    return {{.shading = shading}, reference::QuadCut::kFirstToThird, {number, powers}};
}

fixed::ReplayOptions Choice::fixed_options() const {
    return {.shading = shading, .scrub = fixed::Scrub::kNothing, .sending = sending};
}

}  // namespace twinlight::study
