// UploadedMesh: a Draw's vertices and indices in buffers of the current context.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/programmable/vertex_attributes.h"
#include "render/stages/elements.h"
#include "scene/state/frame.h"

namespace twinlight::programmable {

// What decides an UploadedMesh beside the vertices, their order and materials.
struct MeshForm {
    std::vector<Attribute> attributes;
    bool unit_normals = false;
    bool borders = false;         // edge flags count
    glm::dvec3 origin_object{0};  // that positions are relative to (draw_values.h)

    friend bool operator==(const MeshForm&, const MeshForm&) = default;
};
MeshForm mesh_form(const Draw& draw, const EffectSet& effects, const glm::dvec3& origin_object);

// Dies before its context does.
class UploadedMesh {
  public:
    // The attributes that the program of these effects takes.
    UploadedMesh(const Draw& draw, const EffectSet& effects, bool patches, const glm::dvec3& origin_object);
    ~UploadedMesh();
    UploadedMesh(const UploadedMesh&) = delete;
    UploadedMesh& operator=(const UploadedMesh&) = delete;

    // With the program that is current.
    void draw() const;

    std::size_t bytes() const { return bytes_ + elements_.bytes(); }  // of the buffers

  private:
    unsigned array_ = 0, vertices_ = 0, edge_flags_ = 0;
    std::size_t bytes_ = 0;
    Elements elements_;
};

}  // namespace twinlight::programmable
