#include "render/programmable/numbers/uniforms.h"

#include <algorithm>
#include <cstring>

namespace twinlight::programmable {
namespace {

// Enough for most Draws.
constexpr std::size_t kUsualNames = 1024, kUsualUniforms = 48, kUsualFloats = 192;

}  // namespace

Uniforms::Uniforms(std::initializer_list<std::pair<std::string_view, std::vector<float>>> list) {
    for (const auto& [name, values] : list) set(name, values);
}

std::optional<std::size_t> Uniforms::find(std::string_view name) const {
    for (std::size_t i = 0; i < size(); ++i)
        if ((*this)[i].name == name) return i;
    return {};
}

void Uniforms::add(std::string_view name, std::initializer_list<std::string_view> rest_of_name) {
    if (entries_.empty()) {
        names_.reserve(kUsualNames);
        entries_.reserve(kUsualUniforms);
        floats_.reserve(kUsualFloats);
    }
    Entry& entry = entries_.emplace_back();
    entry.name_at = static_cast<std::uint32_t>(names_.size());
    names_ += name;
    for (const std::string_view part : rest_of_name) names_ += part;
    entry.name_length = static_cast<std::uint32_t>(names_.size()) - entry.name_at;
    names_ += ' ';
    entry.first = static_cast<std::uint32_t>(floats_.size());
}

void Uniforms::append(const Uniforms& other, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const auto [name, values] = other[i];
        add(name);
        floats_.insert(floats_.end(), values.begin(), values.end());
        entries_.back().count = static_cast<std::uint32_t>(values.size());
    }
}

void Uniforms::set(std::string_view name, std::span<const float> values) {
    const std::optional<std::size_t> place = find(name);
    if (!place) {
        add(name);
        for (const float value : values) push_back(value);
        return;
    }
    Entry& entry = entries_[*place];
    if (values.size() != entry.count) {  // the old floats stay unused
        entry.first = static_cast<std::uint32_t>(floats_.size());
        entry.count = static_cast<std::uint32_t>(values.size());
        floats_.resize(floats_.size() + values.size());
    }
    std::ranges::copy(values, floats_.begin() + entry.first);
}

bool are_same(std::span<const float> a, std::span<const float> b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

std::strong_ordering operator<=>(const Uniforms& a, const Uniforms& b) {
    if (const int order = a.names_.compare(b.names_); order != 0) return order <=> 0;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        const auto &one = a[i].values, &other = b[i].values;
        if (const auto order = one.size() <=> other.size(); order != 0) return order;
        if (one.empty()) continue;
        if (const int order = std::memcmp(one.data(), other.data(), one.size_bytes()); order != 0) return order <=> 0;
    }
    return a.size() <=> b.size();
}

}  // namespace twinlight::programmable
