#include "render/webgpu/wgsl_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "render/webgpu/wgsl_function.h"

namespace twinlight::webgpu {
namespace {

std::string wgsl_member(const std::string& attribute, const Variable& one) {
    return fmt::format("    {}{}: {},{}\n", attribute, one.name, wgsl_type(one.type, one.length), comment_behind(one));
}

std::string wgsl_struct(const std::string& above, const std::string& name, const std::vector<Variable>& members) {
    std::string text = fmt::format("{}struct {} {{\n", above, name);
    for (const Variable& member : members) text += wgsl_member("", member);
    return text + "}\n";
}

const char* dimension_of(const std::string& sampler) {
    return sampler == "sampler3D" ? "3d" : sampler == "samplerCube" ? "cube" : "2d";
}

// "// Vertex shader: transforms ..." of both stages.
std::string headings(const Kind& kind) { return kind.vertex.heading + kind.fragment.heading; }

class Module {
  public:
    Module(const Kind& kind, const Blocks& blocks) : kind_(kind), blocks_(blocks), uniforms_(uniforms_of(kind)) {
        merge();
        name_functions();
        name_globals();
    }

    std::string text() {
        std::string text = headings(kind_) + blocks_text() + textures_text() + stages_text();
        for (const Definition& one : definitions_)
            text += "\n" + (one.is_struct ? wgsl_struct(one.structure.above, one.structure.name, one.structure.members)
                                          : wgsl_function(one.function, names_));
        return text + "\n" + vertex_main() + "\n" + fragment_main();
    }

  private:
    static std::string text_of(const Definition& one) {
        if (!one.is_struct) return one.function.text;
        return wgsl_struct("", one.structure.name, one.structure.members);
    }

    // The structs and functions of both stages, once each.
    void merge() {
        for (const Shader* shader : {&kind_.vertex, &kind_.fragment})
            for (const Definition& one : shader->definitions) {
                if (!one.is_struct && one.function.name == "main") continue;
                if (std::ranges::none_of(definitions_,
                                         [&](const Definition& other) { return text_of(other) == text_of(one); }))
                    definitions_.push_back(one);
            }
    }

    void name_functions() {
        const auto count = [&](const std::string& name) {
            return std::ranges::count_if(
                definitions_, [&](const Definition& one) { return !one.is_struct && one.function.name == name; });
        };
        for (const Definition& one : definitions_) {
            if (one.is_struct) {
                names_.structs[one.structure.name] = one.structure.members;
                continue;
            }
            WgslNames::Callable callable{
                .name = one.function.name, .type = one.function.type, .wgsl_name = one.function.name};
            for (const Variable& parameter : one.function.parameters) callable.parameters.push_back(parameter.type);
            // Those of whole exponents and of others.
            if (count(callable.name) > 1)
                callable.wgsl_name +=
                    std::ranges::find(callable.parameters, "int") != callable.parameters.end() ? "_whole" : "_real";
            names_.functions.push_back(std::move(callable));
        }
    }

    void name_globals() {
        for (const Variable& uniform : uniforms_) {
            const Block* block = blocks_.block_of(uniform.name);
            const std::string text = !block || block->is_one ? uniform.name : block->variable + "." + uniform.name;
            names_.globals[uniform.name] = {text, uniform.type + (uniform.length > 0 ? "[]" : "")};
            if (block && block->is_one) names_.structs[block->type] = blocks_.struct_named(block->type)->members;
        }
        has_private_side_ = std::ranges::any_of(definitions_, [](const Definition& one) {
            return !one.is_struct && mentions(one.function.body, "gl_FrontFacing");
        });
        names_.globals["gl_FrontFacing"] = {"front_facing", "bool"};
    }

    std::string blocks_text() const {
        std::string text;
        std::vector<std::string> structs;
        for (const Block* block : blocks_.of(uniforms_)) {
            const bool is_new = std::ranges::find(structs, block->type) == structs.end();
            structs.push_back(block->type);
            const Struct* structure = blocks_.struct_named(block->type);
            if (is_new)
                text += "\n" + (block->is_one ? wgsl_struct(structure->above, block->type, structure->members)
                                              : wgsl_struct("", block->type, block->members));
            const int length = block->is_one ? block->members.front().length : 0;
            text += fmt::format("@group(0) @binding({}) var<uniform> {}: {};{}\n", block->binding, block->variable,
                                wgsl_type(block->type, length),
                                block->is_one ? comment_behind(block->members.front()) : "");
        }
        return text;
    }

    std::string textures_text() const {
        std::string text;
        for (const Variable& uniform : uniforms_)
            if (is_sampler(uniform))
                text += fmt::format(
                    "\n@group(0) @binding({0}) var {1}: texture_{2}<f32>;{3}\n@group(0) @binding({4}) var {1}Sampler: "
                    "sampler;\n",
                    binding_of_texture(uniform), uniform.name, dimension_of(uniform.type), comment_behind(uniform),
                    binding_of_texture(uniform) + 1);
        return text;
    }

    std::string stages_text() const {
        std::string text = "\nstruct VertexInput {\n";
        for (const Variable& input : kind_.vertex.inputs)
            text += wgsl_member(fmt::format("@location({}) ", input.location), input);
        text +=
            "}\n\nstruct Varyings {\n    @builtin(position) @invariant position: vec4f,  // another program with the "
            "same positions gets the same depths\n";
        int location = 0;
        for (const Variable& output : kind_.vertex.outputs)
            text += wgsl_member(
                fmt::format("@location({}) {}", location++, output.is_flat ? "@interpolate(flat) " : ""), output);
        text += "}\n";
        if (has_private_side_) text += "\nvar<private> front_facing: bool;\n";
        return text;
    }

    std::string vertex_main() const {
        WgslNames names = names_;
        for (const Variable& input : kind_.vertex.inputs)
            names.globals[input.name] = {"vertex." + input.name, input.type};
        for (const Variable& output : kind_.vertex.outputs)
            names.globals[output.name] = {"out." + output.name, output.type};
        names.globals["gl_Position"] = {"out.position", "vec4"};
        return "@vertex\nfn vertex_main(vertex: VertexInput) -> Varyings {\n    var out: Varyings;\n" +
               wgsl_body(kind_.vertex.main(), names, "") +
               "    out.position.z = 0.5 * (out.position.z + out.position.w);  // WebGPU clips z to [0, w], GL to [-w, "
               "w]\n"
               "    return out;\n}\n";
    }

    std::string fragment_main() const {
        WgslNames names = names_;
        for (const Variable& input : kind_.fragment.inputs)
            names.globals[input.name] = {"in." + input.name, input.type};
        const Function& main = kind_.fragment.main();
        const bool is_parameter = !has_private_side_ && mentions(main.body, "gl_FrontFacing");
        return fmt::format("@fragment\nfn fragment_main(in: Varyings{}) -> @location(0) vec4f {{\n{}{}}}\n",
                           has_private_side_ ? ", @builtin(front_facing) is_front: bool"
                           : is_parameter    ? ", @builtin(front_facing) front_facing: bool"
                                             : "",
                           has_private_side_ ? "    front_facing = is_front;\n" : "",
                           wgsl_body(main, names, kind_.fragment.outputs.front().name));
    }

    const Kind& kind_;
    const Blocks& blocks_;
    const std::vector<Variable> uniforms_;
    std::vector<Definition> definitions_;  // without main()
    WgslNames names_;
    bool has_private_side_ = false;  // functions ask which side is seen
};

bool has(const Kind& kind, const char* identifier) {
    const auto in = [&](const Shader& shader) {
        return std::ranges::any_of(shader.definitions, [&](const Definition& one) {
            return !one.is_struct && mentions(one.function.body, identifier);
        });
    };
    return in(kind.vertex) || in(kind.fragment);
}

bool has_sampler(const Kind& kind, const char* type) {
    return std::ranges::find(kind.fragment.uniforms, type, &Variable::type) != kind.fragment.uniforms.end();
}

}  // namespace

std::string wgsl_module(const Kind& kind, const Blocks& blocks) { return Module(kind, blocks).text(); }

std::string why_not_in_vulkan(const Kind& kind) {
    const auto has_uniform = [&](const char* name) {
        return std::ranges::find(kind.fragment.uniforms, name, &Variable::name) != kind.fragment.uniforms.end();
    };
    if (has(kind, "gl_PointCoord")) return "point sprites (GL_POINT_SPRITE)";
    if (has_uniform("PolygonStipple")) return "a polygon stipple (glPolygonStipple)";
    if (has_uniform("Framebuffer")) return "glLogicOp";
    if (has(kind, "gl_FragCoord") || has(kind, "Viewport"))
        return "edges or corners of polygons with an offset or with colours of the back (glPolygonMode)";
    return "";
}

std::string why_not_in_wgsl(const Kind& kind) {
    if (std::string why = why_not_in_vulkan(kind); !why.empty()) return why;
    if (has_sampler(kind, "sampler2DShadow")) return "a depth texture that is compared (GL_TEXTURE_COMPARE_MODE)";
    return "";
}

}  // namespace twinlight::webgpu
