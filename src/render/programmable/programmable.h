// The programmable renderer: GLSL assembled for the effects that each Draw needs, in the current context. It uses only
// buffers, attributes and uniforms, no built-in GL lighting or matrix state.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/image/image.h"
#include "render/effect/explanation.h"
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

// A picture and the plans it was drawn from.
struct Picture {
    Image image;
    std::vector<PlannedDraw> plans;
};

// Owns programs, textures and buffers of the current context, so it must be destroyed before the context.
class Renderer {
  public:
    explicit Renderer(const KeptLimits& limits = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Clears to black and depth 1 and draws the frame into the current colour buffer, with programs of the options'
    // tier. Throws ShaderRefused (shader_program.h) if the driver refuses a
    // shader.
    void draw(const UploadedFrame& frame);
    // Under Tier::kAuto, vertices that are bit for bit the same as in earlier frames are not analysed or uploaded again
    // (kept_meshes.h), and neighbours with the same state are drawn as one (joined_draws.h), in frames of many Draws also
    // small ones at different places. Then the picture may differ by 1/255 from that of Tier::kUniform, and at edges.
    void draw(const Frame& frame, const Options& options);
    // The same, and reads the picture back.
    Picture render(const Frame& frame, const Options& options);

    Counters counters() const;

  private:
    void draw_once(const Frame& frame, Options options, std::vector<PlannedDraw>* plans);

    struct Impl;
    class Drawing;
    std::unique_ptr<Impl> impl_;
};

}  // namespace twinlight::programmable
