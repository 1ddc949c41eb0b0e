// Mesh: a Draw's vertices and indices in buffers of the current context.
#pragma once

#include "effect/effect_set.h"
#include "stages/elements.h"
#include "state/frame.h"

namespace twinlight::programmable {

// Dies before its context does.
class Mesh {
  public:
    // The attributes that the program of these effects takes.
    Mesh(const Draw& draw, const EffectSet& effects, const RenderOptions& options = {});
    ~Mesh();
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;

    // With the program that is current.
    void draw() const;

  private:
    unsigned array_ = 0, vertices_ = 0, edge_flags_ = 0;
    Elements elements_;
};

}  // namespace twinlight::programmable
