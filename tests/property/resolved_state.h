// A Draw's lighting as commands that leave the driver nothing to work out before it: matrices are loaded, lights placed under
// the identity, everything in the floats that the Frame's doubles round to.
#pragma once

#include <memory>
#include <string_view>

#include "judge/fuzz/random.h"
#include "scene/command/command.h"
#include "scene/frame/frame.h"

namespace twinlight {

// The first three vertices as a triangle, so that both faces have colours. Textures, fog and rasterisation are left out.
std::shared_ptr<const CommandList> resolved(const Draw& draw);

// The Draw under another modelview matrix, its vertices where they were in eye coordinates.
Draw with_modelview(Draw draw, const glm::dmat4& eye_from_object);

// The kinds of matrices that drivers tell apart.
enum class ModelviewKind {
    kAny,
    kIdentity,
    kTranslation,
    kRotation,
    kRotation2d,
    kScale2d,
    kUniformScale,
    kScale,
    kSimilarity,
    kShear,
    kProjective
};
inline constexpr int kModelviewKinds = 11;
std::string_view name_of(ModelviewKind kind);
glm::dmat4 modelview_of(ModelviewKind kind, const Draw& draw, fuzz::Random& random);

}  // namespace twinlight
