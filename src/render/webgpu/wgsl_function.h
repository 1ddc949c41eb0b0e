// A function of an exported shader in WGSL: the same statements, names and comments. WGSL differs from GLSL in the forms of declarations,
// in that a component's name is not enough to assign several, in select() for ?:, and in few conversions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "render/webgpu/exported_glsl.h"

namespace twinlight::webgpu {

// What an identifier outside the function is in WGSL.
struct Global {
    std::string text;  // "materials.FrontMaterial"
    std::string type;  // in GLSL; "vec4[]": an array
};

struct WgslNames {
    std::map<std::string, Global> globals{};
    std::map<std::string, std::vector<Variable>> structs{};
    // Functions may share a name in GLSL, not in WGSL.
    struct Callable {
        std::string name;                       // in GLSL
        std::vector<std::string> parameters{};  // their types
        std::string type{}, wgsl_name{};
    };
    std::vector<Callable> functions{};
};

// "vec3f" for "vec3".
std::string wgsl_type(const std::string& type, int length = 0);

// All of it, for a function that is not main(). Throws std::logic_error for GLSL that exported shaders do not have.
std::string wgsl_function(const Function& function, const WgslNames& names);
// The statements. `result`: the output that becomes the value of the function, as the last statement; empty: none does.
std::string wgsl_body(const Function& function, const WgslNames& names, const std::string& result);

}  // namespace twinlight::webgpu
