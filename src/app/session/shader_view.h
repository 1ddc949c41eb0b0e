// ShaderView: the shaders that light the scene, as coloured text to read, and why each effect is in or out.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "render/effect/explanation.h"
#include "scene/frame/frame.h"

namespace twinlight::session {

// What a piece of GLSL is.
enum class Ink : std::uint8_t { kPlain, kKeyword, kType, kNumber, kComment, kDirective, kCall };
struct InkedText {
    Ink ink = Ink::kPlain;
    std::string_view text{};

    friend bool operator==(const InkedText&, const InkedText&) = default;
};
// Line by line, without the ends of lines. The views are into `glsl`.
std::vector<std::vector<InkedText>> inked_lines(std::string_view glsl);

// One program of the scene.
struct ShownShader {
    std::string title;  // "draw 1, report.gl:14:1; 3 more draws use this program with other values"
    int draw = 0;       // its first Draw, counted from 1; 0 if it is unknown
    std::string glsl;
};
// The programs in a text of programmable::shader_source().
std::vector<ShownShader> shown_shaders(std::string_view source);

// A program without the comments at its start that list effects and reasons. The values of the uniforms stay.
std::string_view without_reasons(std::string_view glsl);

// The plan of the Draw with this number, counted from 1; null if no Draw has it.
const ExplainedDraw* plan_of(const std::vector<ExplainedDraw>& draws, int number);

}  // namespace twinlight::session
