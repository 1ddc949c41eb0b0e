// Textures: the textures of a Frame, uploaded to texture objects of the current context.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "state/frame.h"

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
    // Deletes what no bind() asked for since the last call.
    void drop_unused();

  private:
    struct Uploaded {
        // Keeps it from changing: State changes a texture in place only where nobody else has it.
        std::shared_ptr<const Texture> texture;
        unsigned name = 0;
        bool used = true;
    };
    Clamping clamping_;
    std::map<const Texture*, Uploaded> uploaded_;
};

}  // namespace twinlight
