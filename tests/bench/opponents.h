// Shaders that serve every scene by uniforms, as others write them: as fast as we could make them of their kind. Their text stands
// under tests/bench/shaders.
#pragma once

#include <memory>

#include "scene/frame/frame.h"

namespace twinlight::bench {

// For the context that is current when it is made.
class Program {
  public:
    Program() = default;
    virtual ~Program() = default;
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    virtual void draw() = 0;  // clears, and draws
};

// Phong shading of a Draw's lights, per fragment: by a loop over them whose numbers tell all kinds of light; by flags.
std::unique_ptr<Program> make_uber(const Draw& draw);
std::unique_ptr<Program> make_flag_uber(const Draw& draw);

}  // namespace twinlight::bench
