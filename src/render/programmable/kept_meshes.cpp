#include "render/programmable/kept_meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace twinlight::programmable {
namespace {

// The approximate memory that a driver needs for a buffer, an array object and their names: many small meshes are not
// free.
constexpr std::size_t kObjectBytes = 4096;

// ---- The same vertices ----

// The doubles of a Vertex come first, without padding; after them there is some.
constexpr std::size_t kVertexNumbers = offsetof(Vertex, edge_flag);
static_assert(kVertexNumbers == (4 + 3 + 4 + 4) * sizeof(double) && std::is_trivially_copyable_v<Vertex>);
static_assert(sizeof(Materials) == 2 * ((4 * 4 + 1 + 3) * sizeof(double) + 3 * sizeof(void*)) &&
              std::is_trivially_copyable_v<Materials>);

// Compares bits: 0 and -0 differ, and a NaN equals itself.
template <class Values>
bool are_same_bits(const Values& a, const Values& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

bool are_same(const SharedVector<Vertex>& a, const SharedVector<Vertex>& b) {
    // With the padding at the end of each vertex, which mostly is the same too.
    if (a.shares_memory_with(b) || are_same_bits(a, b)) return true;
    return std::ranges::equal(a, b, [](const Vertex& x, const Vertex& y) {
        return std::memcmp(&x, &y, kVertexNumbers) == 0 && x.edge_flag == y.edge_flag && x.material == y.material;
    });
}

template <class Values>
std::size_t bytes_of(const Values& values) {
    return values.size() * sizeof(values[0]);
}

// A hash of a few vertices, evenly spread: equal for equal vertices, usually different for others.
std::size_t sample(DrawRun run) {
    constexpr std::size_t kParts = 8, kVerticesOfAll = 12, kIndices = 4;
    std::size_t hash = run.size();
    const auto add = [&](std::uint64_t value) {
        hash = (hash ^ value) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 32;
    };
    const auto for_some = [](std::size_t most, std::size_t size, const auto& visit) {
        const std::size_t count = std::min(most, size);
        for (std::size_t i = 0; i < count; ++i) visit(count == 1 ? 0 : i * (size - 1) / (count - 1));
    };
    for (const Draw* draw : run) add(draw->mode + (draw->vertices.size() << 8) + (draw->indices.size() << 36));
    add(run.front()->materials.size());
    for_some(kParts, run.size(), [&](std::size_t part) {
        const Draw& draw = *run[part];
        for_some(std::max<std::size_t>(kVerticesOfAll / std::min(kParts, run.size()), 1), draw.vertices.size(),
                 [&](std::size_t i) {
                     std::array<std::uint64_t, kVertexNumbers / sizeof(std::uint64_t)> words;
                     std::memcpy(words.data(), &draw.vertices[i], kVertexNumbers);
                     for (const std::uint64_t word : words) add(word);
                 });
        for_some(kIndices, draw.indices.size(), [&](std::size_t i) { add(draw.indices[i]); });
    });
    return hash;
}

}  // namespace

std::vector<KeptMeshes::Part> KeptMeshes::parts_of(DrawRun run) {
    std::vector<Part> parts;
    parts.reserve(run.size());
    for (const Draw* draw : run) parts.push_back({draw->mode, draw->vertices, draw->indices});
    return parts;
}

// Draws that are drawn as one have the same materials, and no values of vertices besides Draw::vertices.
bool KeptMeshes::Known::has_same_rest(const Draw& draw) const {
    const auto is_same = [](const VertexColumn& kept, const VertexColumn& column) {
        return kept.attribute == column.attribute && are_same_bits(kept.values, column.values);
    };
    const bool at_same_pixels = pixels == draw.pixels || (pixels && draw.pixels && *pixels == *draw.pixels);
    return at_same_pixels && are_same_bits(materials, draw.materials) &&
           std::ranges::equal(columns, draw.columns, is_same);
}

bool KeptMeshes::Known::is(DrawRun run) {
    if (parts.size() != run.size() || !has_same_rest(*run.front())) return false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Draw& draw = *run[i];
        if (parts[i].mode != draw.mode || parts[i].indices != draw.indices ||
            !are_same(parts[i].vertices, draw.vertices))
            return false;
    }
    parts = parts_of(run);  // the memory of the frame before can go
    return true;
}

// ---- Kept ----

// If these very Draws were drawn before.
std::shared_ptr<KeptMeshes::Known> KeptMeshes::seen(DrawRun run) {
    const auto is_same = [](const Part& part, const Draw* draw) {
        return part.mode == draw->mode && part.vertices.shares_memory_with(draw->vertices) &&
               part.indices.shares_memory_with(draw->indices);
    };
    const auto [begin, end] = seen_.equal_range(run.front()->vertices.data());
    for (auto entry = begin; entry != end; ++entry) {
        Seen& seen = entry->second;
        const std::shared_ptr<Known> known = seen.known.lock();
        if (!known || !std::ranges::equal(seen.parts, run, is_same) || !known->has_same_rest(*run.front())) continue;
        seen.last_frame = frame_;
        return note_use(seen.place);
    }
    return nullptr;
}

std::shared_ptr<KeptMeshes::Known> KeptMeshes::note_use(Order::iterator place) {
    order_.splice(order_.begin(), order_, place);
    (*place)->last_frame = frame_;
    return *place;
}

std::shared_ptr<KeptMeshes::Known> KeptMeshes::known(DrawRun run) {
    if (std::shared_ptr<Known> same = seen(run)) return same;
    const std::size_t key = sample(run);
    const auto [begin, end] = index_.equal_range(key);
    const auto found = std::find_if(begin, end, [&](const auto& entry) { return (*entry.second)->is(run); });
    if (found != end) {
        seen_.emplace(run.front()->vertices.data(), Seen{parts_of(run), *found->second, found->second, frame_});
        return note_use(found->second);
    }
    auto known = std::make_shared<Known>();
    JoinedDraws all;
    if (run.size() > 1) all = joined(run);
    const Draw& draw = run.size() > 1 ? all.draw : *run.front();
    known->facts = vertex_facts(draw);
    std::size_t bytes = bytes_of(draw.materials);
    for (const Draw* part : run) bytes += bytes_of(part->vertices) + bytes_of(part->indices);
    for (const VertexColumn& column : draw.columns) bytes += bytes_of(column.values);
    if (!make_room(bytes)) return known;
    known->sample = key;
    known->parts = parts_of(run);
    known->materials = draw.materials;
    known->columns = draw.columns;
    known->pixels = draw.pixels;
    known->bytes = bytes;
    known->first_frame = known->last_frame = frame_;
    order_.push_front(known);
    index_.emplace(key, order_.begin());
    seen_.emplace(run.front()->vertices.data(), Seen{known->parts, known, order_.begin(), frame_});
    counters_.bytes += bytes;
    return known;
}

std::shared_ptr<const UploadedMesh> KeptMeshes::mesh(Known& known, DrawRun run, const EffectSet& effects,
                                                     const glm::dvec3& origin_object) {
    const MeshForm form = mesh_form(*run.front(), effects, origin_object);
    const auto found = std::ranges::find(known.meshes, form, [](const auto& entry) { return entry.first; });
    if (found != known.meshes.end()) {
        ++counters_.hits;
        return found->second;
    }
    const auto mesh = run.size() > 1
                          ? std::make_shared<const UploadedMesh>(joined(run), effects, origin_object)
                          : std::make_shared<const UploadedMesh>(*run.front(), effects, false, origin_object);
    ++counters_.made;
    const std::size_t bytes = mesh->bytes() + kObjectBytes;
    if (known.bytes == 0 || !make_room(bytes)) return mesh;
    known.meshes.emplace_back(form, mesh);
    known.bytes += bytes;
    counters_.bytes += bytes;
    return mesh;
}

bool KeptMeshes::make_room(std::size_t bytes) {
    while (counters_.bytes + bytes > limit_bytes_ && !order_.empty() && order_.back()->last_frame != frame_)
        drop(std::prev(order_.end()));
    return counters_.bytes + bytes <= limit_bytes_;
}

KeptMeshes::Order::iterator KeptMeshes::drop(Order::iterator known) {
    const auto [begin, end] = index_.equal_range((*known)->sample);
    index_.erase(std::find_if(begin, end, [&](const auto& entry) { return entry.second == known; }));
    counters_.bytes -= (*known)->bytes;
    counters_.evicted += (*known)->meshes.size();
    return order_.erase(known);
}

void KeptMeshes::end_frame() {
    std::erase_if(seen_, [this](const auto& entry) { return entry.second.last_frame != frame_; });
    auto known = std::ranges::find_if(order_, [this](const auto& kept) { return kept->last_frame != frame_; });
    while (known != order_.end() && (*known)->last_frame + 1 == frame_)
        known = (*known)->first_frame == (*known)->last_frame ? drop(known) : std::next(known);
    ++frame_;
}

}  // namespace twinlight::programmable
