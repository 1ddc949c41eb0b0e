#include "render/programmable/kept_meshes.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string_view>
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
bool is_same(const Vertex& a, const Vertex& b) {
    return std::memcmp(&a, &b, kVertexNumbers) == 0 && a.edge_flag == b.edge_flag && a.material == b.material;
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
std::size_t sample(const Draw& draw) {
    std::size_t hash = draw.mode;
    const auto add = [&](std::size_t value) { hash = (hash ^ value) * 0x9E3779B97F4A7C15U; };
    add(draw.vertices.size());
    add(draw.indices.size());
    add(draw.materials.size());
    constexpr std::size_t kSamples = 16;
    const auto add_some = [&](const auto& values, const auto& bytes) {
        for (std::size_t i = 0; i < std::min(kSamples, values.size()); ++i) {
            const auto& value = values[i * (values.size() - 1) / (kSamples - 1)];
            add(std::hash<std::string_view>{}({reinterpret_cast<const char*>(&value), bytes}));  // NOLINT: its bytes
        }
    };
    add_some(draw.vertices, kVertexNumbers);
    add_some(draw.indices, sizeof(std::uint32_t));
    return hash;
}

}  // namespace

bool KeptMeshes::Known::is(const Draw& draw) const {
    return mode == draw.mode && are_same(indices, draw.indices) && are_same(materials, draw.materials) &&
           std::ranges::equal(vertices, draw.vertices, is_same);
}

// ---- Kept ----

std::shared_ptr<KeptMeshes::Known> KeptMeshes::known(const Draw& draw) {
    const std::size_t key = sample(draw);
    const auto [begin, end] = index_.equal_range(key);
    const auto found = std::find_if(begin, end, [&](const auto& entry) { return (*entry.second)->is(draw); });
    if (found != end) {
        order_.splice(order_.begin(), order_, found->second);
        order_.front()->last_frame = frame_;
        return order_.front();
    }
    auto known = std::make_shared<Known>();
    known->facts = vertex_facts(draw);
    const std::size_t bytes = bytes_of(draw.vertices) + bytes_of(draw.indices) + bytes_of(draw.materials);
    if (!make_room(bytes)) return known;
    known->sample = key;
    known->mode = draw.mode;
    known->vertices = draw.vertices;
    known->indices = draw.indices;
    known->materials = draw.materials;
    known->bytes = bytes;
    known->first_frame = known->last_frame = frame_;
    order_.push_front(known);
    index_.emplace(key, order_.begin());
    counters_.bytes += bytes;
    return known;
}

std::shared_ptr<const UploadedMesh> KeptMeshes::mesh(Known& known, const Draw& draw, const EffectSet& effects,
                                                     const glm::dvec3& origin_object) {
    const MeshForm form = mesh_form(draw, effects, origin_object);
    const auto found = std::ranges::find(known.meshes, form, [](const auto& entry) { return entry.first; });
    if (found != known.meshes.end()) {
        ++counters_.hits;
        return found->second;
    }
    const auto mesh = std::make_shared<const UploadedMesh>(draw, effects, false, origin_object);
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
