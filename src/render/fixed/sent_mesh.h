// SentMesh: a Draw's vertices in the form in which they are sent to the fixed function (ReplayOptions::sending).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/fixed/replay.h"
#include "render/stages/elements.h"
#include "scene/frame/frame.h"

namespace twinlight::fixed {

// Which properties of vertices are sent; nothing reads the others.
struct MeshContents {
    bool normal = false, color = false, tex_coord = false;
    bool further_tex_coords = false;  // of texture units above 0
};

class SentMesh {
  public:
    SentMesh(const Draw& draw, const MeshContents& contents, const ReplayOptions& options);
    ~SentMesh();
    SentMesh(const SentMesh&) = delete;
    SentMesh& operator=(const SentMesh&) = delete;

    // Leaves its arrays disabled. A property that all vertices share is set as the current value.
    void draw() const;

  private:
    struct Sent {
        VertexAttribute attribute = VertexAttribute::kPosition;
        int size = 0;  // in floats
        std::size_t offset = 0;
    };

    void draw_arrays() const;
    void draw_immediately() const;

    Sending sending_;
    std::vector<Sent> sent_;  // what the array has of each vertex; the position last
    std::size_t stride_ = 0;
    Vertex shared_;  // has the properties that all vertices share

    // In the driver's buffers:
    std::optional<Elements> elements_;
    unsigned vertices_ = 0, edge_flags_ = 0;
    // Or in memory:
    Enum mode_ = 0;
    std::vector<float> values_;
    std::vector<std::uint8_t> flags_;  // empty: not needed
    int count_ = 0;
    std::vector<std::uint32_t> indices_;  // empty: 0, 1, 2, ...
    unsigned list_ = 0;
};

// Sets the current values to those of a vertex, but for its position and material.
void send_values(const Draw& draw, std::size_t index);

// Draws between glBegin and glEnd, with glMaterial for the properties of a face that vary.
void draw_with_materials(const Draw& draw, const FaceEffects& front, const FaceEffects& back);

}  // namespace twinlight::fixed
