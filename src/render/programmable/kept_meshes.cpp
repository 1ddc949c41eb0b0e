#include "render/programmable/kept_meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
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
bool are_same(std::span<const Vertex> a, std::span<const Vertex> b) {
    if (a.size() != b.size()) return false;
    // With the padding at the end of each vertex, which mostly is the same too.
    if (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0) return true;
    return std::ranges::equal(a, b, [](const Vertex& x, const Vertex& y) {
        return std::memcmp(&x, &y, kVertexNumbers) == 0 && x.edge_flag == y.edge_flag && x.material == y.material;
    });
}

template <class Value>
bool are_same(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

template <class Value>
std::size_t bytes_of(const std::vector<Value>& values) {
    return values.size() * sizeof(Value);
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

bool KeptMeshes::Known::is(DrawRun run) const {
    if (parts.size() != run.size() || !are_same(materials, run.front()->materials)) return false;
    if (!std::ranges::equal(further_tex_coords, run.front()->further_units,
                            [](const std::vector<glm::dvec4>& kept, const FurtherUnit& unit) {
                                return are_same(kept, unit.tex_coords);
                            }))
        return false;
    if (!are_same(secondary_colors, run.front()->secondary_colors) || !are_same(fog_coords, run.front()->fog_coords))
        return false;
    std::size_t first_vertex = 0, first_index = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Draw& draw = *run[i];
        if (parts[i] != part_of(draw)) return false;
        if (!are_same(std::span(vertices).subspan(first_vertex, parts[i].vertices), draw.vertices)) return false;
        for (std::size_t k = 0; k < draw.indices.size(); ++k)
            if (indices[first_index + k] != first_vertex + draw.indices[k]) return false;
        first_vertex += parts[i].vertices;
        first_index += parts[i].indices;
    }
    return true;
}

// ---- Kept ----

std::shared_ptr<KeptMeshes::Known> KeptMeshes::known(DrawRun run) {
    const std::size_t key = sample(run);
    const auto [begin, end] = index_.equal_range(key);
    const auto found = std::find_if(begin, end, [&](const auto& entry) { return (*entry.second)->is(run); });
    if (found != end) {
        order_.splice(order_.begin(), order_, found->second);
        order_.front()->last_frame = frame_;
        return order_.front();
    }
    auto known = std::make_shared<Known>();
    JoinedDraws all;
    if (run.size() > 1) all = joined(run);
    const Draw& draw = run.size() > 1 ? all.draw : *run.front();
    known->facts = vertex_facts(draw);
    std::size_t bytes = bytes_of(draw.vertices) + bytes_of(draw.indices) + bytes_of(draw.materials) +
                        bytes_of(draw.secondary_colors) + bytes_of(draw.fog_coords);
    for (const FurtherUnit& unit : draw.further_units) bytes += bytes_of(unit.tex_coords);
    if (!make_room(bytes)) return known;
    known->sample = key;
    for (const Draw* part : run) known->parts.push_back(part_of(*part));
    known->vertices = draw.vertices;
    known->indices = draw.indices;
    known->materials = draw.materials;
    known->secondary_colors = draw.secondary_colors;
    known->fog_coords = draw.fog_coords;
    for (const FurtherUnit& unit : draw.further_units) known->further_tex_coords.push_back(unit.tex_coords);
    known->bytes = bytes;
    known->first_frame = known->last_frame = frame_;
    order_.push_front(known);
    index_.emplace(key, order_.begin());
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
    auto known = std::ranges::find_if(order_, [this](const auto& kept) { return kept->last_frame != frame_; });
    while (known != order_.end() && (*known)->last_frame + 1 == frame_)
        known = (*known)->first_frame == (*known)->last_frame ? drop(known) : std::next(known);
    ++frame_;
}

}  // namespace twinlight::programmable
