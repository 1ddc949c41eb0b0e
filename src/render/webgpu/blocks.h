// The uniforms of an export's kinds in blocks, a buffer each, for APIs without single uniforms. All kinds of an export have the same
// blocks: a buffer of lights is filled once and serves every kind.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text/json.h"
#include "render/webgpu/exported_glsl.h"

namespace twinlight::webgpu {

struct Block {
    int binding = 0;
    std::string variable;             // in WGSL
    std::string type;                 // "Matrices"; of a block of one uniform: its type
    bool is_one = false;              // of one uniform, which has the variable's name
    std::vector<Variable> members{};  // or that one
    int size = 0;                     // in bytes
};

// A number or vector of a block, as GL's state sets it.
struct Place {
    std::string name;  // "LightSource[0].position"
    std::string type;  // in GLSL
    int length = 0;    // of an array
    int offset = 0;    // in the block, in bytes
    std::string state;
};

// A texture's binding; in WGSL, its sampler's is the next one.
inline constexpr int kTextureBinding = 7;

class Blocks {
  public:
    explicit Blocks(const std::vector<Kind>& kinds);

    const std::vector<Block>& all() const { return blocks_; }
    // Those with one of these uniforms.
    std::vector<const Block*> of(const std::vector<Variable>& uniforms) const;
    // Null for a type that is no struct.
    const Struct* struct_named(std::string_view type) const;
    // The block of a uniform; null for a texture.
    const Block* block_of(std::string_view uniform) const;
    std::vector<Place> places(const Block& block) const;

    // An element of layout.json's "blocks".
    Json json(const Block& block) const;

  private:
    void add_uniforms(const Shader& shader);
    void lay_out();

    std::vector<Variable> uniforms_;
    std::vector<Struct> structs_;
    std::vector<Block> blocks_;
};

bool is_sampler(const Variable& uniform);
// A texture's binding: Texture0, Texture1, ...
int binding_of_texture(const Variable& uniform);

}  // namespace twinlight::webgpu
