// Program: the compiled and linked GLSL of an EffectSet, in the current context.
#pragma once

#include <string>
#include <vector>

#include "programmable/assembly.h"
#include "programmable/draw_values.h"

namespace twinlight::programmable {

class Program {
  public:
    // Throws std::runtime_error with the driver's log, the numbered source and the EffectSet.
    explicit Program(const EffectSet& effects);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // Makes it current and gives it the values of the uniforms it has.
    void use(const Uniforms& uniforms) const;

  private:
    struct Slot {
        std::string name;
        int location = -1;
    };
    unsigned program_ = 0;
    std::vector<Slot> slots_;  // the active uniforms
};

}  // namespace twinlight::programmable
