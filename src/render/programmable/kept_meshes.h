// KeptMeshes: of the Draws of earlier frames what hangs on their vertices alone, the planner's facts and the driver's buffers,
// for Draws that come again with the same vertices under other lights and matrices.
//
// A Frame has no names for its vertices: each picture's State makes them anew. So they are known again by what they are,
// bit by bit, against a copy; a hash of a few of them finds the copy, and decides nothing.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "render/effect/vertex_facts.h"
#include "render/programmable/programmable.h"
#include "render/programmable/uploaded_mesh.h"

namespace twinlight::programmable {

// Owns buffers: dies before their context does.
class KeptMeshes {
  public:
    // Of the vertices kept and of their buffers; of more, those go that were not drawn for the longest time, but none that
    // this frame has drawn: what does not fit beside these is not kept. What one frame alone has drawn goes after the next:
    // vertices that move never come again.
    explicit KeptMeshes(std::size_t limit_bytes) : limit_bytes_(limit_bytes) {}

    struct Known {
        VertexFacts facts;

      private:
        friend class KeptMeshes;
        bool is(const Draw& draw) const;

        std::size_t sample = 0;  // where index_ has it
        Enum mode = 0;
        std::vector<Vertex> vertices;
        std::vector<std::uint32_t> indices;
        std::vector<Materials> materials;
        std::vector<std::pair<MeshForm, std::shared_ptr<const UploadedMesh>>> meshes;  // few
        std::size_t bytes = 0;                                                         // 0: it is not kept
        std::uint64_t first_frame = 0, last_frame = 0;                                 // that drew it
    };

    // What is known of the Draw's vertices, or found out now.
    std::shared_ptr<Known> known(const Draw& draw);
    // Their buffers for a program of these effects.
    std::shared_ptr<const UploadedMesh> mesh(Known& known, const Draw& draw, const EffectSet& effects,
                                             const glm::dvec3& origin_object);
    void end_frame();

    const MeshCounters& counters() const { return counters_; }

  private:
    using Order = std::list<std::shared_ptr<Known>>;  // those drawn last first
    bool make_room(std::size_t bytes);
    Order::iterator drop(Order::iterator known);  // gives the next

    std::size_t limit_bytes_;
    std::uint64_t frame_ = 1;
    Order order_;
    std::unordered_multimap<std::size_t, Order::iterator> index_;  // by sample()
    MeshCounters counters_;
};

}  // namespace twinlight::programmable
