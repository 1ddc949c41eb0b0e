// Textures: the textures of a Frame, uploaded to texture objects of the current context.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "scene/state/frame.h"

namespace twinlight {

// GL_CLAMP, which core GL and shaders do not have: by the driver's own sampler, or left to a shader that clamps the
// coordinates to where the border begins.
enum class Clamping : std::uint8_t { kDriver, kShader };

// Owns its texture objects: dies before the context does.
class Textures {
  public:
    explicit Textures(Clamping clamping) : clamping_(clamping) {}
    ~Textures();
    Textures(const Textures&) = delete;
    Textures& operator=(const Textures&) = delete;

    // Binds the unit's texture to the active unit, with its sampling parameters; uploads it at its first use. Throws
    // std::runtime_error when the driver refuses an image.
    void bind(const TextureUnit& unit);
    // Deletes what no bind() asked for since the last call: the end of a frame. Of the next frame, whose textures State made
    // anew, those that are the same texel by texel are not uploaded again.
    void drop_unused();

    std::uint64_t upload_count() const { return upload_count_; }

  private:
    struct Uploaded {
        // Keeps it from changing: State changes a texture in place only where nobody else has it.
        std::shared_ptr<const Texture> texture;
        unsigned name = 0;
        bool used = true;
    };
    using Map = std::map<const Texture*, Uploaded>;
    Map::iterator known_again(const std::shared_ptr<const Texture>& texture);

    Clamping clamping_;
    Map uploaded_;
    std::uint64_t upload_count_ = 0;
};

}  // namespace twinlight
