#include "render/webgpu/blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "render/programmable/text/shader_assembly.h"
#include "scene/command/names.h"
#include "scene/frame/parameter_rows.h"

namespace twinlight::webgpu {
namespace {

// The order of all uniforms and their structs' members.
const Shader& uniforms_in_order() {
    static const Shader kUniforms =
        read_shader(std::ranges::find(kShaderFiles, "kept_uniforms.glsl", &EmbeddedFile::name)->text);
    return kUniforms;
}

std::ptrdiff_t place_in(const std::vector<Variable>& list, const std::string& name) {
    return std::ranges::find(list, name, &Variable::name) - list.begin();
}

// Adds the variable, at its place in `order`; those that are not there come last, by name.
void add_in_order(std::vector<Variable>& list, const Variable& one, const std::vector<Variable>& order) {
    if (const auto found = std::ranges::find(list, one.name, &Variable::name); found != list.end()) {
        if (one.length > found->length) *found = one;  // the comment of LightSource names the lights
        return;
    }
    const auto is_before = [&](const Variable& a, const Variable& b) {
        const auto at = place_in(order, a.name), other = place_in(order, b.name);
        return at != other ? at < other : a.name < b.name;
    };
    list.insert(std::ranges::upper_bound(list, one, is_before), one);
}

// Whether each object has its own values, in most programs.
bool is_of_object(const std::string& name) { return name.find("Matrix") != name.npos || name == "NormalScale"; }

constexpr struct {
    const char* uniform;
    int binding;
} kOwnBlocks[] = {{"FrontMaterial", 1}, {"BackMaterial", 2}, {"LightSource", 3}, {"LightModel", 4}, {"Fog", 5}};
constexpr int kMatrices = 0, kParameters = 6;

// ---- Offsets: std140, and WGSL's uniform address space has the same for these types ----

constexpr int rounded_up(int offset, int alignment) { return (offset + alignment - 1) / alignment * alignment; }

struct Extent {
    int size = 0, alignment = 4;
};
Extent extent_of(const std::string& type) {
    static const std::map<std::string, Extent> kExtents = {{"float", {4, 4}},  {"int", {4, 4}},    {"uint", {4, 4}},
                                                           {"vec2", {8, 8}},   {"vec3", {12, 16}}, {"vec4", {16, 16}},
                                                           {"mat3", {48, 16}}, {"mat4", {64, 16}}};
    const auto found = kExtents.find(type);
    if (found == kExtents.end()) throw std::logic_error("a uniform block has the type " + type);
    return found->second;
}
// Arrays are of types whose size is a multiple of 16.
Extent extent_of(const Variable& one) {
    const Extent extent = extent_of(one.type);
    if (one.length > 0 && extent.size % 16 != 0) throw std::logic_error("a uniform block has an array of " + one.type);
    return {extent.size * std::max(one.length, 1), extent.alignment};
}

// Appends members; returns the offset after them. `visit`(member, offset).
template <class Visit>
int lay_out_members(const std::vector<Variable>& members, const Visit& visit) {
    int offset = 0;
    for (const Variable& member : members) {
        const Extent extent = extent_of(member);
        offset = rounded_up(offset, extent.alignment);
        visit(member, offset);
        offset += extent.size;
    }
    return rounded_up(offset, 16);
}

// ---- The state of GL ----

template <class Owner>
std::string parameter_named(const std::string& member) {
    for (const ParameterRow<Owner>& row : kParameterRows<Owner>)
        if (row.glsl == member) return enum_name(row.pname);
    return "";
}

std::string state_of(const std::string& uniform, int number, const Variable& member) {
    if (uniform == "LightSource") {
        const std::string light =
            number < 8 ? fmt::format("GL_LIGHT{}", number) : fmt::format("GL_LIGHT0 + {}", number);
        if (member.name == "spotCosCutoff") return fmt::format("the cosine of glLight({}, GL_SPOT_CUTOFF)", light);
        if (member.name == "halfVector")
            return fmt::format("glLight({}, GL_POSITION): {}", light,
                               member.comment.substr(member.comment.find(':') + 2));
        const std::string name = parameter_named<LightSource>(member.name);
        const bool turns = member.name == "position" || member.name == "spotDirection";
        return fmt::format("glLight({}, {}){}", light, name, turns ? ", in eye coordinates" : "");
    }
    if (uniform == "FrontMaterial" || uniform == "BackMaterial")
        return fmt::format("glMaterial({}, {})", uniform == "FrontMaterial" ? "GL_FRONT" : "GL_BACK",
                           parameter_named<Material>(member.name));
    if (uniform == "LightModel") return fmt::format("glLightModel({})", parameter_named<LightModel>(member.name));
    if (uniform == "Fog") {
        if (member.name == "scale") return "1 / (GL_FOG_END - GL_FOG_START) of glFog";
        std::string name = member.name;
        std::ranges::transform(name, name.begin(),
                               [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
        return fmt::format("glFog(GL_FOG_{})", name);
    }
    if (uniform == "TextureMatrix") return "glMatrixMode(GL_TEXTURE)";
    if (uniform.starts_with("ObjectPlane")) return fmt::format("glTexGen(GL_{}, GL_OBJECT_PLANE)", uniform.back());
    if (uniform.starts_with("EyePlane"))
        return fmt::format("glTexGen(GL_{}, GL_EYE_PLANE), in eye coordinates", uniform.back());
    return member.comment;
}

}  // namespace

bool is_sampler(const Variable& uniform) { return uniform.type.starts_with("sampler"); }

int binding_of_texture(const Variable& uniform) { return kTextureBinding + 2 * (uniform.name.back() - '0'); }

Blocks::Blocks(const std::vector<Kind>& kinds) {
    for (const Kind& kind : kinds)
        for (const Shader* shader : {&kind.vertex, &kind.fragment}) add_uniforms(*shader);
    lay_out();
}

void Blocks::add_uniforms(const Shader& shader) {
    const Shader& order = uniforms_in_order();
    for (const Variable& uniform : shader.uniforms)
        if (!is_sampler(uniform)) add_in_order(uniforms_, uniform, order.uniforms);
    for (const Struct& structure : shader.uniform_structs) {
        auto found = std::ranges::find(structs_, structure.name, &Struct::name);
        if (found == structs_.end()) found = structs_.insert(found, {structure.name, structure.above});
        const auto whole = std::ranges::find(order.uniform_structs, structure.name, &Struct::name);
        for (const Variable& member : structure.members) add_in_order(found->members, member, whole->members);
    }
}

void Blocks::lay_out() {
    Block matrices{.binding = kMatrices, .variable = "matrices", .type = "Matrices"};
    Block parameters{.binding = kParameters, .variable = "parameters", .type = "Parameters"};
    std::vector<Block> own;
    for (const Variable& uniform : uniforms_) {
        const auto found =
            std::ranges::find(kOwnBlocks, uniform.name, [](const auto& row) { return std::string(row.uniform); });
        if (found != std::end(kOwnBlocks))
            own.push_back({found->binding, uniform.name, uniform.type, true, {uniform}});
        else
            (is_of_object(uniform.name) ? matrices : parameters).members.push_back(uniform);
    }
    if (!matrices.members.empty()) blocks_.push_back(matrices);
    std::ranges::sort(own, {}, &Block::binding);
    blocks_.insert(blocks_.end(), own.begin(), own.end());
    if (!parameters.members.empty()) blocks_.push_back(parameters);
    for (Block& block : blocks_) {
        const auto ignore = [](const Variable&, int) {};
        block.size = block.is_one ? lay_out_members(struct_named(block.type)->members, ignore) *
                                        std::max(block.members.front().length, 1)
                                  : lay_out_members(block.members, ignore);
    }
}

const Struct* Blocks::struct_named(std::string_view type) const {
    const auto found = std::ranges::find(structs_, type, &Struct::name);
    return found == structs_.end() ? nullptr : &*found;
}

const Block* Blocks::block_of(std::string_view uniform) const {
    for (const Block& block : blocks_)
        if (std::ranges::find(block.members, uniform, &Variable::name) != block.members.end()) return &block;
    return nullptr;
}

std::vector<const Block*> Blocks::of(const std::vector<Variable>& uniforms) const {
    std::vector<const Block*> result;
    for (const Block& block : blocks_)
        if (std::ranges::any_of(uniforms, [&](const Variable& one) { return block_of(one.name) == &block; }))
            result.push_back(&block);
    return result;
}

std::vector<Place> Blocks::places(const Block& block) const {
    std::vector<Place> result;
    if (!block.is_one) {
        lay_out_members(block.members, [&](const Variable& member, int offset) {
            result.push_back({member.name, member.type, member.length, offset, state_of(member.name, 0, member)});
        });
        return result;
    }
    const Variable& uniform = block.members.front();
    const std::vector<Variable>& members = struct_named(block.type)->members;
    const int count = std::max(uniform.length, 1), stride = block.size / count;
    for (int i = 0; i < count; ++i) {
        const std::string name = uniform.length > 0 ? fmt::format("{}[{}]", uniform.name, i) : uniform.name;
        lay_out_members(members, [&](const Variable& member, int offset) {
            result.push_back(
                {name + "." + member.name, member.type, 0, i * stride + offset, state_of(uniform.name, i, member)});
        });
    }
    return result;
}

Json Blocks::json(const Block& block) const {
    Json members = Json::array();
    for (const Place& place : places(block)) {
        Json member = {{"name", place.name}, {"offset", place.offset}, {"type", place.type}};
        if (place.length > 0) member["length"] = place.length;
        if (!place.state.empty()) member["state"] = place.state;
        members.push_back(std::move(member));
    }
    return {
        {"binding", block.binding}, {"name", block.variable}, {"size", block.size}, {"members", std::move(members)}};
}

}  // namespace twinlight::webgpu
