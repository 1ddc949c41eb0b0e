// The state of a frame's items as calls of gl_state.c and GL, for scene.c.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "render/effect/plan.h"
#include "render/programmable/numbers/form.h"
#include "scene/frame/frame.h"

namespace twinlight::programmable {

// Statements in C, with their numbers apart, so that frames which differ in numbers share a function.
struct CallText {
    std::string text;  // '@' is where the numbers are, one by one; '*' is where an array of them is
    std::vector<float> numbers{};

    friend bool operator==(const CallText&, const CallText&) = default;
    friend bool operator<(const CallText& a, const CallText& b) {
        return std::tie(a.text, a.numbers) < std::tie(b.text, b.numbers);
    }
};

enum class CallScope : std::uint8_t {
    kAnywhere,  // once before the first frame, if it never changes
    kFrame,     // in every frame: the window and its keys change it
    kEye,       // in every frame, where the modelview matrix is the camera's
};

struct Setting {
    std::string key;  // what it sets: a later Setting with this key replaces it
    CallScope scope = CallScope::kAnywhere;
    CallText call;
};

// The state of GL and gl_state.c at the start, without the viewport and the scissor's box.
std::vector<Setting> initial_settings();

std::vector<Setting> settings_of(const Clear& clear);
std::string call_of(const Clear& clear);  // "glClear(GL_COLOR_BUFFER_BIT);"

// What a Draw's shaders and GL need, other than the modelview matrix. `kind` and `texture` are the numbers of its shaders and of its
// texture.
std::vector<Setting> settings_of(const Draw& draw, const Plan& plan, const Code& code, int kind, std::size_t texture,
                                 Glsl version);
// The keys of what the Draw leaves unknown: glColorMaterial's properties of the material.
std::vector<std::string> unknown_after(const Plan& plan, const Code& code);

// OpenGL ES has no textures of one dimension. 0: none.
Enum target_of(const TextureUnit& unit, Glsl version);
Enum target_of(const Texture& texture, Glsl version);

CallText matrix_call(const glm::dmat4& matrix);  // ffMultMatrixf

}  // namespace twinlight::programmable
