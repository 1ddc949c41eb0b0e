// Shaders to keep: a scene as shaders that stay right when objects, lights and the camera move, with a program in C
// that draws the scene with them.
//
// There is one vertex and one fragment shader for each kind of Draw: kinds differ in state (which lights are on, which
// terms are not 0, textures, fog), not in where things are (PlanOptions::for_any_pose). Uniforms are GL's state with
// GL's names (kept_uniforms.glsl).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/image/named_file.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/numbers/shader_options.h"

namespace twinlight::programmable {

// One or more frames to draw with one set of shaders.
struct KeptScene {
    std::string name;
    // Visits the frames in order, with their numbers. A frame need not stay after its visit.
    std::function<void(const std::function<void(const Frame&, int number)>& visit)> for_each_frame;
    // The name of the shape that the command at a place draws, such as "sphere"; empty if it is not known.
    std::function<std::string(const Place&)> name_of_shape{};
};

// For a porter's program: kindN.vert and kindN.frag, gl_state.c, gl_state.h, kinds.c and names.sed. A program that draws the frames with
// them: scene.c, scene.bin, scene.h and window.c. And README.md. Of the options only the shading counts. Throws std::runtime_error if
// why_not_in_files() has a reason.
std::vector<NamedFile> kept_files(const KeptScene& scene, const Options& options, Glsl version);
// The same for one frame.
std::vector<NamedFile> kept_files(const Frame& frame, const Options& options, Glsl version, const std::string& name);

// What in the frame the files cannot draw; empty if they can draw it.
std::string why_not_in_files(const Frame& frame);

}  // namespace twinlight::programmable
