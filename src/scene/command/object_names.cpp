#include "scene/command/object_names.h"

#include <algorithm>

namespace twinlight {

std::optional<ObjectType> named_objects(const Parameter& parameter) {
    if (parameter.kind != Kind::kUint) return std::nullopt;
    if (parameter.name == "texture" || parameter.name == "textures") return ObjectType::kTexture;
    if (parameter.name == "buffer" || parameter.name == "buffers") return ObjectType::kBuffer;
    if (parameter.name == "list") return ObjectType::kList;
    if (parameter.name == "framebuffer" || parameter.name == "framebuffers") return ObjectType::kFramebuffer;
    if (parameter.name == "renderbuffer" || parameter.name == "renderbuffers") return ObjectType::kRenderbuffer;
    return std::nullopt;
}

std::uint32_t ObjectNames::next(ObjectType type, std::uint32_t count) const {
    constexpr std::uint64_t kNames = std::uint64_t{1} << 32;
    std::uint64_t candidate = 1;
    if (const auto rows = taken_.find(type); rows != taken_.end()) {
        // Names are never freed, so the search continues where an earlier one for the same count, or a smaller one,
        // stopped.
        auto& ends = searched_[type];
        if (const auto more = ends.upper_bound(count); more != ends.begin()) candidate = std::prev(more)->second;
        auto row = rows->second.upper_bound(candidate);
        if (row != rows->second.begin()) --row;
        for (; row != rows->second.end() && candidate + count > row->first; ++row) {
            candidate = std::max(candidate, row->second);
        }
        ends[count] = candidate;
    }
    return candidate + count <= kNames ? static_cast<std::uint32_t>(candidate) : 0;
}

void ObjectNames::take(ObjectType type, double first, double count) {
    if (first < 1 || count < 1) return;
    auto from = static_cast<std::uint64_t>(first), end = from + static_cast<std::uint64_t>(count);
    auto& rows = taken_[type];
    // Merges ranges that overlap or touch.
    auto row = rows.upper_bound(from);
    if (row != rows.begin() && std::prev(row)->second >= from) --row;
    while (row != rows.end() && row->first <= end) {
        from = std::min(from, row->first);
        end = std::max(end, row->second);
        row = rows.erase(row);
    }
    rows.emplace(from, end);
}

void ObjectNames::follow(const Command& command) {
    const Signature& sig = command.sig();
    // glGenLists(range) returns the first of consecutive names.
    if (!sig.parameters.empty() && sig.parameters.back().extent == Extent::kResult) {
        if (named_objects(sig.parameters.back())) {
            take(ObjectType::kList, command.arguments.back(), command.number(0));
        }
        return;
    }
    for (std::size_t i = 0; i < sig.parameters.size(); ++i) {
        const auto type = named_objects(sig.parameters[i]);
        if (!type) continue;
        for (double name : command.values(i)) take(*type, name, 1);
    }
}

}  // namespace twinlight
