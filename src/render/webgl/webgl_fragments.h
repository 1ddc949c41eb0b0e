// The stencil test and blending for WebGL 2, which refuses some of their states (WebGL specification, "Stencil Separate Mask and
// Reference Value" and "Blending With Constant Color").
#pragma once

#include <glm/vec3.hpp>

#include "base/text/json.h"
#include "scene/frame/frame.h"

namespace twinlight::webgl {

// Whether front and back faces have different stencil tests.
bool has_two_stencils(const Draw& draw);
// Both faces must have the same reference and masks. So where they differ, each face is drawn with the other one culled.
bool needs_each_side(const Draw& draw);
// One list for front faces, one for back faces: [func, reference, mask, fail, depth_fail, depth_pass, write_mask].
Json stencil_json(const Draw& draw);

// One factor must not be of the constant colour and the other of the constant alpha. Then the shader multiplies the colour by the
// source's factor.
bool mixes_constants(const FragmentState& fragment);
glm::dvec3 constant_factor(const FragmentState& fragment);
Json blend_json(const FragmentState& fragment);

}  // namespace twinlight::webgl
