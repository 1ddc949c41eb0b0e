// The shader path: GLSL assembled for the effects that each Draw calls for, in the current context.
// Buffers, attributes and uniforms only: no built-in GL lighting or matrix state.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/image/image.h"
#include "render/effect/explanation.h"
#include "render/programmable/shader_options.h"
#include "scene/state/frame.h"

namespace twinlight::programmable {

// A Frame made ready to be drawn again and again: planned, its vertices in the driver's buffers. Owns objects of the
// context that is current; dies before that does.
class UploadedFrame {
  public:
    UploadedFrame(const Frame& frame, const Options& options);
    ~UploadedFrame();
    UploadedFrame(const UploadedFrame&) = delete;
    UploadedFrame& operator=(const UploadedFrame&) = delete;

  private:
    friend class Renderer;
    struct Impl;
    explicit UploadedFrame(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

// Since the Renderer was made, of Draws under Tier::kAuto: their vertices in the driver's buffers.
struct MeshCounters {
    std::uint64_t made = 0;
    std::uint64_t hits = 0;     // Draws whose vertices, all the same, were there
    std::uint64_t evicted = 0;  // that gave way to others
    std::size_t bytes = 0;      // that are kept now, with copies of the vertices
};

// Since the Renderer was made.
struct Counters {
    std::uint64_t made = 0;      // programs with uniforms
    std::uint64_t baked = 0;     // programs with constants
    std::uint64_t hits = 0;      // Draws whose program was there
    std::uint64_t evicted = 0;   // programs that gave way to others
    std::uint64_t textures = 0;  // uploaded
    MeshCounters meshes;
};

// What a Renderer keeps; of more, that goes which was not used for the longest time.
struct KeptLimits {
    std::size_t programs = 128;
    std::size_t mesh_bytes = std::size_t{256} << 20;  // under Tier::kAuto, of frames before: 0 for none
};

// With what it was drawn from.
struct Picture {
    Image image;
    std::vector<PlannedDraw> plans;
};

// Owns the programs, textures and buffers that it made in the context that is current; dies before that context does.
class Renderer {
  public:
    explicit Renderer(const KeptLimits& limits = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Clears to black and depth 1 and draws the frame into the current colour buffer, with the programs that its options'
    // tier calls for. Throws std::runtime_error with the log, the numbered source and the EffectSet when the driver
    // refuses a shader.
    void draw(const UploadedFrame& frame);
    // Under Tier::kAuto vertices that earlier frames had, bit by bit the same, are neither looked through nor sent to the
    // driver again (kept_meshes.h).
    void draw(const Frame& frame, const Options& options);
    // The same, and reads the picture.
    Picture render(const Frame& frame, const Options& options);

    Counters counters() const;

  private:
    UploadedFrame prepare_once(const Frame& frame, Options options);

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The GLSL that draws the frame, for people to read: the program of each Draw, with its effects, what is left
// out and why, and the uniforms' values in comments. Needs no context.
std::string shader_source(const Frame& frame, const Options& options);

}  // namespace twinlight::programmable
