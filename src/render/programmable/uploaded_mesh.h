// UploadedMesh: a Draw's vertices and indices in buffers of the current context.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/programmable/joined_draws.h"
#include "render/programmable/numbers/vertex_attributes.h"
#include "render/stages/elements.h"
#include "scene/frame/frame.h"

namespace twinlight::programmable {

// Everything besides the vertices, their order and materials that determines an UploadedMesh.
struct MeshForm {
    std::vector<Attribute> attributes;
    bool unit_normals = false;
    bool borders = false;         // edge flags matter
    glm::dvec3 origin_object{0};  // positions are relative to this (draw_values.h)

    friend bool operator==(const MeshForm&, const MeshForm&) = default;
};
MeshForm mesh_form(const Draw& draw, const EffectSet& effects, const glm::dvec3& origin_object);

// Must be destroyed before its context.
class UploadedMesh {
  public:
    // Uploads the attributes that a program with these effects takes.
    UploadedMesh(const Draw& draw, const EffectSet& effects, bool patches, const glm::dvec3& origin_object);
    // Of joined Draws (joined_draws.h), without edge flags.
    UploadedMesh(const JoinedDraws& draws, const EffectSet& effects, const glm::dvec3& origin_object);
    ~UploadedMesh();
    UploadedMesh(const UploadedMesh&) = delete;
    UploadedMesh& operator=(const UploadedMesh&) = delete;

    // Draws a range of it (ElementsPart::begins_range) with the current program.
    void draw(std::size_t range = 0) const;

    std::size_t bytes() const { return bytes_ + elements_.bytes(); }  // size of the buffers

  private:
    void upload(const Draw& draw, const EffectSet& effects, const glm::dvec3& origin_object);

    unsigned array_ = 0, vertices_ = 0, edge_flags_ = 0;
    std::size_t bytes_ = 0;
    Elements elements_;
};

}  // namespace twinlight::programmable
