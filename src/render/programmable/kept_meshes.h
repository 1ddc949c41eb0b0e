// KeptMeshes: keeps the planner's facts and the driver's buffers of vertices from earlier frames, for Draws with the
// same vertices under other lights and matrices.
//
// A Frame that is drawn again shares its vertices with those that are kept, which shows at once. State creates new
// vertices for each picture: those are compared bit by bit. A hash of a few vertices only finds what to compare with.
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
    // The limit counts the vertices and their buffers. Beyond it, the least recently drawn go first; those drawn in the
    // current frame never go, and what does not fit next to them is not kept. Vertices drawn in only one frame go after
    // the next frame, because moving vertices never come again.
    explicit KeptMeshes(std::size_t limit_bytes) : limit_bytes_(limit_bytes) {}

    // One of the Draws that are drawn as one.
    struct Part {
        Enum mode = kGL_TRIANGLES;
        SharedVector<Vertex> vertices;
        SharedVector<std::uint32_t> indices;
    };
    static std::vector<Part> parts_of(DrawRun run);

    struct Known {
        VertexFacts facts;

      private:
        friend class KeptMeshes;
        bool is(DrawRun run);
        bool has_same_rest(const Draw& draw) const;

        std::size_t sample = 0;  // its key in index_
        std::vector<Part> parts;
        std::vector<Materials> materials;
        std::vector<VertexColumn> columns;  // only of a single Draw
        std::shared_ptr<const WindowPixels> pixels;
        std::vector<std::pair<MeshForm, std::shared_ptr<const UploadedMesh>>> meshes;  // a few
        std::size_t bytes = 0;                                                         // 0: not kept
        std::uint64_t first_frame = 0, last_frame = 0;                                 // the frames that drew it
    };

    // The facts of the vertices of Draws that are drawn as one (joined_draws.h), from an earlier frame or computed now.
    std::shared_ptr<Known> known(DrawRun run);
    std::shared_ptr<Known> known(const Draw& draw) {
        const Draw* const one = &draw;
        return known({&one, 1});
    }
    // The buffers of these vertices for a program with these effects.
    std::shared_ptr<const UploadedMesh> mesh(Known& known, DrawRun run, const EffectSet& effects,
                                             const glm::dvec3& origin_object);
    void end_frame();

    const MeshCounters& counters() const { return counters_; }

  private:
    using Order = std::list<std::shared_ptr<Known>>;  // most recently drawn first
    // Draws of this frame or the last. They keep their memory, so that no others can have it.
    struct Seen {
        std::vector<Part> parts;
        std::weak_ptr<Known> known;
        Order::iterator place;  // unless `known` is gone
        std::uint64_t last_frame = 0;
    };
    std::shared_ptr<Known> seen(DrawRun run);
    std::shared_ptr<Known> note_use(Order::iterator place);
    bool make_room(std::size_t bytes);
    Order::iterator drop(Order::iterator known);  // returns the next

    std::size_t limit_bytes_;
    std::uint64_t frame_ = 1;
    Order order_;
    std::unordered_multimap<std::size_t, Order::iterator> index_;  // by sample()
    std::unordered_multimap<const Vertex*, Seen> seen_;            // by the memory of the first Draw's vertices
    MeshCounters counters_;
};

}  // namespace twinlight::programmable
