// Rewrites: a scene's commands are replaced by others that have the same effect in OpenGL, but with which one known bug of a driver
// cannot show. If the fixed function is then right, the bug is proved to be the cause (causes.h). Some have the same effect only in most
// scenes, so the reference draws the rewritten scene, too, and nothing is proved where that changes.
#pragma once

#include <functional>
#include <memory>

#include "scene/command/command.h"
#include "scene/state/state.h"

namespace twinlight::compare {

struct Rewrite {
    // Carries out `command` on `state`, which all commands before it have led to, and emits what replaces it.
    void (*carry_out)(State& state, const Command& command, const std::function<void(const Command&)>& emit);
    // Whether the bug shows in no rewritten scene. Otherwise it may, so a picture that stays wrong does not clear it.
    bool is_whole = true;
};

// A glGet before the command. It changes nothing, but drivers that keep values of glMaterial and glColor aside use them then.
extern const Rewrite asks_before_color_material, asks_before_new_mode, asks_before_list, asks_before_pop;
// What glPopAttrib restores is set once more.
extern const Rewrite sets_color_after_pop, sets_lights_after_pop, sets_mipmaps_after_pop;
// glColor3 as glColor4, glTexCoord1 to 3 as glTexCoord4, glVertex4 as one whose w is 1.
extern const Rewrite sends_alpha, sends_all_coordinates, divides_by_w;
// Both sides' whole material after each glBegin and each glMaterial that follows it.
extern const Rewrite sets_both_sides;
// glRect and glEvalMesh2 as the vertices that they stand for (2.10, 5.1).
extern const Rewrite spells_out_rectangles, spells_out_evaluated_meshes;
// GL_SHININESS 1e-6 where it is 0: (n.h)^0 is nearly the same, but where n.h is 0. There the bug of two sides is no better than that.
extern const Rewrite sets_some_shininess, sets_some_shininess_of_sides;
// Unit vectors: directions towards lights, and normals under GL_NORMALIZE. GL_NORMALIZE for GL_RESCALE_NORMAL, which is the same for
// unit normals.
extern const Rewrite sends_unit_directions, normalizes_for_rescaling;
// The commands of display lists where the lists are called.
extern const Rewrite spells_out_lists;
// GL_POINT_SPRITE is off where no points are drawn.
extern const Rewrite limits_sprites_to_points;
// GL_DEPTH_TEXTURE_MODE once more after glCopyTexImage.
extern const Rewrite sets_mode_after_copy;

// The recording with all of its commands rewritten. `options`: of the picture.
std::shared_ptr<const Recording> rewritten(std::shared_ptr<const Recording> recording, const Rewrite& rewrite,
                                           const StateOptions& options);

}  // namespace twinlight::compare
