// The programs of Draws for any pose: planned by state (PlanOptions::for_any_pose), with GL's names (kept_text.h).
#pragma once

#include <string>

#include "render/effect/plan.h"
#include "render/programmable/numbers/form.h"
#include "scene/frame/frame.h"

namespace twinlight::programmable {

inline constexpr int kMostKeptLights = 16;  // FF_LIGHTS of gl_state.h; OpenGL promises room for this many uniforms

// Code::lights is empty: the uniforms are GL's state.
Code kept_code(const Draw& draw, const Plan& plan, Glsl version);

// What in the frame these programs cannot do; empty if they can draw it.
std::string why_not_kept(const Frame& frame);

}  // namespace twinlight::programmable
