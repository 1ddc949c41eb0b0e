// Mesh: a Draw's vertices in buffers of the driver's, as the arrays of the fixed function (2.8, 2.9).
#pragma once

#include <cstdint>

#include "effect/effect_set.h"
#include "stages/elements.h"
#include "state/frame.h"

namespace twinlight::fixed {

// Which of a vertex's properties are sent; the others nothing reads.
struct MeshContents {
    bool normal = false, color = false, tex_coord = false;
};

class Mesh {
  public:
    Mesh(const Draw& draw, const MeshContents& contents, const RenderOptions& options);
    ~Mesh();
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;

    // With its own arrays; none is enabled afterwards. A property that all vertices share is the current one.
    void draw() const;

  private:
    struct Attribute {
        int size = 0;  // floats; 0: not in the array
        std::size_t offset = 0;
    };

    Elements elements_;
    Attribute position_, normal_, color_, tex_coord_;
    std::size_t stride_ = 0;
    Vertex shared_;  // its properties are those that all share
    unsigned vertices_ = 0, edge_flags_ = 0;
};

// Between glBegin and glEnd, where glMaterial may stand as well: those properties of a face that vary.
void draw_with_materials(const Draw& draw, const FaceEffects& front, const FaceEffects& back);

}  // namespace twinlight::fixed
