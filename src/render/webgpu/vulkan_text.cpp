#include "render/webgpu/vulkan_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace twinlight::webgpu {
namespace {

std::string declared(const Variable& one) {
    return fmt::format("{} {}{};{}\n", one.type, one.name, one.length > 0 ? fmt::format("[{}]", one.length) : "",
                       comment_behind(one));
}

std::string struct_text(const Struct& one) {
    std::string text = fmt::format("{}struct {} {{\n", one.above, one.name);
    for (const Variable& member : one.members) text += "    " + declared(member);
    return text + "};\n";
}

// The blocks of a stage; a struct stands before the first block that has it.
std::string blocks_text(const Shader& shader, const Blocks& blocks) {
    std::string text;
    std::vector<std::string> structs;
    for (const Block* block : blocks.of(shader.uniforms)) {
        if (block->is_one && std::ranges::find(structs, block->type) == structs.end()) {
            text += "\n" + struct_text(*blocks.struct_named(block->type));
            structs.push_back(block->type);
        } else if (!block->is_one) {
            text += "\n";
        }
        text += fmt::format("layout(std140, set = 0, binding = {}) uniform {} {{\n", block->binding,
                            block->is_one ? block->variable + "Block" : block->type);
        for (const Variable& member : block->members) text += "    " + declared(member);
        text += "};\n";
    }
    for (const Variable& uniform : shader.uniforms)
        if (is_sampler(uniform))
            text += fmt::format("\nlayout(set = 0, binding = {}) uniform {}", binding_of_texture(uniform),
                                declared(uniform));
    return text;
}

std::string varyings_text(const std::vector<Variable>& varyings, const std::vector<Variable>& of_vertices,
                          const char* kind) {
    std::string text;
    for (const Variable& one : varyings)
        text += fmt::format("layout(location = {}) {}{} {}",
                            std::ranges::find(of_vertices, one.name, &Variable::name) - of_vertices.begin(),
                            one.is_flat ? "flat " : "", kind, declared(one));
    return text;
}

std::string definitions_text(const Shader& shader, const char* at_end) {
    std::string text;
    for (const Definition& one : shader.definitions) {
        if (one.is_struct)
            text += "\n" + struct_text(one.structure);
        else if (one.function.name != "main")
            text += "\n" + one.function.above + one.function.text;
        else
            text += fmt::format("\n{}void main() {{\n{}{}}}\n", one.function.above, one.function.body, at_end);
    }
    return text;
}

}  // namespace

std::string vulkan_vertex_shader(const Kind& kind, const Blocks& blocks) {
    const Shader& shader = kind.vertex;
    std::string text = "#version 450\n" + shader.heading + "\n";
    for (const Variable& input : shader.inputs)
        text += fmt::format("layout(location = {}) in {}", input.location, declared(input));
    text += blocks_text(shader, blocks) + "\n" + varyings_text(shader.outputs, shader.outputs, "out");
    text += "\ninvariant gl_Position;  // another program with the same positions gets the same depths\n";
    return text + definitions_text(shader,
                                   "    gl_Position.y = -gl_Position.y;  // Vulkan's y points down\n"
                                   "    gl_Position.z = 0.5 * (gl_Position.z + gl_Position.w);  // Vulkan clips z to "
                                   "[0, w], GL to [-w, w]\n");
}

std::string vulkan_fragment_shader(const Kind& kind, const Blocks& blocks) {
    const Shader& shader = kind.fragment;
    std::string text = "#version 450\n" + shader.heading + "\n";
    text += varyings_text(shader.inputs, kind.vertex.outputs, "in");
    if (!shader.inputs.empty()) text += "\n";
    text += varyings_text(shader.outputs, shader.outputs, "out");
    return text + blocks_text(shader, blocks) + definitions_text(shader, "");
}

}  // namespace twinlight::webgpu
