// The programmable renderer: GLSL assembled for the effects that each Draw needs, in the current context. It uses only
// buffers, attributes and uniforms, no built-in GL lighting or matrix state.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/image/image.h"
#include "render/programmable/numbers/shader_options.h"
#include "scene/frame/frame.h"

namespace twinlight::programmable {

// A Frame prepared for drawing many times: planned, and with its vertices in the driver's buffers. Owns objects of the
// current context, so it must be destroyed before the context.
class UploadedFrame {
  public:
    // If textures copy pixels of the picture, draws that into the current colour buffer first.
    UploadedFrame(const Frame& frame, const Options& options);
    ~UploadedFrame();
    UploadedFrame(const UploadedFrame&) = delete;
    UploadedFrame& operator=(const UploadedFrame&) = delete;

  private:
    friend class Renderer;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Meshes in the driver's buffers, for Draws under Tier::kAuto. Counted since the Renderer was made.
struct MeshCounters {
    std::uint64_t made = 0;
    std::uint64_t hits = 0;     // Draws whose vertices were already uploaded
    std::uint64_t evicted = 0;  // meshes deleted to make room
    std::size_t bytes = 0;      // kept now, including copies of the vertices
};

// Counted since the Renderer was made.
struct Counters {
    std::uint64_t made = 0;      // programs with uniforms
    std::uint64_t baked = 0;     // programs with constants
    std::uint64_t hits = 0;      // Draws whose program already existed
    std::uint64_t evicted = 0;   // programs deleted to make room
    std::uint64_t textures = 0;  // textures uploaded
    MeshCounters meshes;
};

// How much a Renderer keeps. Beyond this, the least recently used goes first.
struct KeptLimits {
    std::size_t programs = 128;
    std::size_t mesh_bytes = std::size_t{256} << 20;  // under Tier::kAuto; 0 keeps nothing between frames
};

// Owns programs, textures and buffers of the current context, so it must be destroyed before the context.
class Renderer {
  public:
    explicit Renderer(const KeptLimits& limits = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Clears to black and depth 1 and draws the frame into the current colour buffer, with programs of the options'
    // tier. Throws ShaderRefused (shader_program.h) if the driver refuses a shader.
    void draw(const UploadedFrame& frame);
    // In frames of 40 Draws or more, neighbours with the same state are drawn as one (joined_draws.h), and small ones at
    // different places, too. Then the picture may differ by 1/255 from that of the Draws one by one, and at edges. Under
    // Tier::kAuto, that holds for all frames, and vertices that are bit for bit the same as in earlier frames are not
    // analysed or uploaded again (kept_meshes.h).
    void draw(const Frame& frame, const Options& options);
    // The same, and reads the picture back.
    Image render(const Frame& frame, const Options& options);

    // Under Tier::kAuto, compiling a program with constants takes longer than a frame. Where that is not allowed, programs with uniforms
    // draw until it is, and wants_to_bake() says whether a frame since then would have compiled one.
    void allow_baking(bool is_allowed);
    bool wants_to_bake() const;

    Counters counters() const;

  private:
    struct Impl;
    class Drawing;
    std::unique_ptr<Impl> impl_;
};

}  // namespace twinlight::programmable
