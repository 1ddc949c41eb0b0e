// Textures: a Frame's textures, uploaded to texture objects of the current context.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "scene/frame/copied_texels.h"
#include "scene/frame/frame.h"

namespace twinlight {

// How GL_CLAMP is done, which core GL and shaders lack: by the driver's sampler, or by a shader that clamps coordinates
// to the start of the border.
enum class Clamping : std::uint8_t { kDriver, kShader };

// A DrawSource: calls draw(), and returns the area. The picture of a framebuffer object is drawn into a buffer of its own, another
// into the current one.
CopySource drawn_to_copy(const Frame& picture, CopiedBuffer buffer, const Rectangle& area,
                         const std::function<void()>& draw);

// Texture units with their numbers.
using TextureUnits = std::vector<std::pair<std::size_t, TextureUnit>>;
// Those of a Draw that combines textures; empty for another Draw.
TextureUnits combined_units(const Draw& draw);

// Turns off all textures of all units in the driver. The last unit is active then.
void disable_textures();

// Owns its texture objects, so it must be destroyed before the context.
class Textures {
  public:
    explicit Textures(Clamping clamping) : clamping_(clamping) {}
    ~Textures();
    Textures(const Textures&) = delete;
    Textures& operator=(const Textures&) = delete;

    // Binds the unit's texture to the active unit and sets its sampling parameters; uploads it at its first use. Throws
    // std::runtime_error if the driver refuses an image.
    void bind(const TextureUnit& unit);
    // Binds the textures of several units. release_units() makes unit 0 active again and resets what bind() does not
    // set; it must come before the next bind().
    void bind_units(const TextureUnits& units);
    static void release_units(const TextureUnits& units);
    // Ends a frame: deletes textures that were not bound since the last call. State creates textures again for each
    // frame; those that are the same texel by texel are not uploaded again.
    void drop_unused();

    std::uint64_t upload_count() const { return upload_count_; }

  private:
    struct Uploaded {
        // Holding it keeps it unchanged: State changes a texture in place only if nobody else holds it.
        std::shared_ptr<const Texture> texture;
        unsigned name = 0;
        bool used = true;
    };
    using Map = std::map<const Texture*, Uploaded>;
    Map::iterator find_equal(const std::shared_ptr<const Texture>& texture);

    Clamping clamping_;
    Map uploaded_;
    std::uint64_t upload_count_ = 0;
};

}  // namespace twinlight
