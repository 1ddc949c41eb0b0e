// Runs of a part's primitives that share no pixel. glLogicOp (GL 2.1, section 4.1.10) combines each fragment with the picture before it,
// which a fragment shader can read only from a copy. So gl.js copies the picture before each run.
#pragma once

#include <cstddef>
#include <vector>

#include "render/webgl/webgl_lines.h"
#include "scene/frame/frame.h"

namespace twinlight::webgl {

// Strips, fans and loops as separate lines and triangles; the last vertex gives a flat colour as before.
Part listed(Part part);

struct Runs {
    std::vector<std::size_t> ends;  // of each run, in `indices`
    bool is_exact = true;           // no primitives of a run overlap
};
// The part must be listed. for_any_pose: in any view, not only in the Draw's.
Runs runs_of(const Part& part, const Draw& draw, bool for_any_pose);

}  // namespace twinlight::webgl
