// ShaderProgram: compiled and linked GLSL, in the current context.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/text/shader_assembly.h"

namespace twinlight::programmable {

// The driver refuses a shader. what() is one line.
struct ShaderRefused : std::runtime_error {
    ShaderRefused(const std::string& line, std::string all) : std::runtime_error(line), text(std::move(all)) {}
    std::string text;  // the driver's log, the numbered source and the EffectSet; empty if the line says it all
};

class ShaderProgram {
  public:
    // Starts compiling; a driver with GL_KHR_parallel_shader_compile continues on its own threads.
    ShaderProgram(ShaderSource source, EffectSet effects);
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    // Whether use() can run without waiting for the compiler. True if the driver cannot tell. (llvmpipe generates
    // machine code later, in the program's first drawing command, whatever it answers.)
    bool is_ready() const;
    // Throws ShaderRefused.
    void make_current();
    // Makes the program current and sets the uniforms that differ from those of the last use. Throws as make_current().
    void use(const Uniforms& uniforms);

  private:
    void link();
    struct Slot {
        std::string name;
        int location = -1;
        unsigned type = 0;
        int length = 1;            // more than 1 for an array
        std::size_t place = 0;     // in the Uniforms of the last use
        std::vector<float> set{};  // its values now; empty: the driver's initial ones
    };
    ShaderSource source_;  // source and effects are kept for error messages until linking succeeds
    EffectSet effects_;
    unsigned program_ = 0;
    unsigned vertex_ = 0, fragment_ = 0;  // 0 after linking
    std::vector<Slot> slots_;             // the active uniforms
};

}  // namespace twinlight::programmable
