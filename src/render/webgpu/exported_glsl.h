// The parts of an exported shader: GLSL ES 3.00 as shader_assembly.h writes it, with GL's names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twinlight::webgpu {

// A uniform, an input or output of a stage, a member of a struct, or a parameter of a function.
struct Variable {
    std::string type, name;
    int length = 0;  // of an array
    std::string comment{};
    int location = -1;
    bool is_flat = false;
};

struct Struct {
    std::string name;
    std::string above{};  // the lines of comments above it
    std::vector<Variable> members{};
};

struct Function {
    std::string type, name;
    std::vector<Variable> parameters{};
    std::string above{};
    std::string text{};  // all of it
    std::string body{};  // what is between its braces
};

// A struct that no uniform has, or a function.
struct Definition {
    bool is_struct = false;
    Struct structure{};
    Function function{};
};

struct Shader {
    std::string heading{};  // its first comment
    std::vector<Variable> inputs{}, outputs{}, uniforms{};
    std::vector<Struct> uniform_structs{};
    std::vector<Definition> definitions{};  // the last is main()

    const Function& main() const { return definitions.back().function; }
};

// Also kept_uniforms.glsl, which has no main(). Throws std::logic_error for what assembled shaders do not have.
Shader read_shader(std::string_view text);

// Whether the identifier is in the text, outside comments.
bool mentions(std::string_view text, std::string_view identifier);

// "  // n", or nothing.
std::string comment_behind(const Variable& one);

// A program of the export: a kind of Draw.
struct Kind {
    Shader vertex, fragment;
    std::vector<int> attribute_floats;  // of each vertex input, in the vertex array
};
// Of both stages, once each.
std::vector<Variable> uniforms_of(const Kind& kind);

// Removes gl_PointSize, and what only its value needs. WebGPU's points have one pixel.
void remove_point_size(Shader& vertex_shader);

}  // namespace twinlight::webgpu
