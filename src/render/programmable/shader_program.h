// ShaderProgram: compiled and linked GLSL, in the current context.
#pragma once

#include <string>
#include <vector>

#include "render/programmable/draw_values.h"
#include "render/programmable/shader_assembly.h"

namespace twinlight::programmable {

class ShaderProgram {
  public:
    // Starts to compile; a driver with GL_KHR_parallel_shader_compile goes on in threads of its own.
    ShaderProgram(ShaderSource source, EffectSet effects);
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    // Whether use() would not wait for the compiler. True where the driver does not say. (llvmpipe makes its machine code
    // later, in the first drawing command with a program, whatever it says.)
    bool is_ready() const;
    // Makes it current and gives it the values of the uniforms it has. Throws std::runtime_error with the driver's log, the
    // numbered source and the EffectSet when the driver refuses it.
    void use(const Uniforms& uniforms);

  private:
    void link();
    struct Slot {
        std::string name;
        int location = -1;
        unsigned type = 0;
        int length = 1;  // of an array
    };
    ShaderSource source_;  // and the effects: to say what the driver refuses; until it is linked
    EffectSet effects_;
    unsigned program_ = 0;
    unsigned vertex_ = 0, fragment_ = 0;  // 0 once it is linked
    std::vector<Slot> slots_;             // the active uniforms
};

}  // namespace twinlight::programmable
