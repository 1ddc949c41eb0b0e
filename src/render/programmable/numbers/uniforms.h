// Uniforms: names and their floats, in the order in which they were added. Matrices are stored column by column, arrays
// element by element.
//
// Every Draw of every frame makes one, so it is flat: all names in one string, all floats in one array.
#pragma once

#include <compare>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace twinlight::programmable {

class Uniforms {
  public:
    struct Uniform {
        std::string_view name;
        std::span<const float> values;
    };

    Uniforms() = default;
    Uniforms(std::initializer_list<std::pair<std::string_view, std::vector<float>>> list);

    std::size_t size() const { return entries_.size(); }
    bool empty() const { return entries_.empty(); }
    Uniform operator[](std::size_t i) const {
        const Entry& entry = entries_[i];
        return {std::string_view(names_).substr(entry.name_at, entry.name_length),
                std::span(floats_).subspan(entry.first, entry.count)};
    }
    std::optional<std::size_t> find(std::string_view name) const;
    bool contains(std::string_view name) const { return find(name).has_value(); }

    // Adds a uniform that is not there yet; push_back() then appends its values.
    void add(std::string_view name, std::initializer_list<std::string_view> rest_of_name = {});
    void push_back(float value) {
        floats_.push_back(value);
        ++entries_.back().count;
    }
    // Adds the other's uniforms with the numbers first, first + 1, ... last - 1.
    void append(const Uniforms& other, std::size_t first, std::size_t last);
    // Replaces a uniform's values, or adds it.
    void set(std::string_view name, std::span<const float> values);
    void set(std::string_view name, std::initializer_list<float> values) {
        set(name, std::span(values.begin(), values.size()));
    }

    // Those whose numbers (from 0) the predicate accepts, in the same order.
    template <class Predicate>
    Uniforms filtered(const Predicate& accepts) const {
        Uniforms result;
        for (std::size_t i = 0; i < size(); ++i) {
            if (!accepts(i)) continue;
            result.add((*this)[i].name);
            for (const float value : (*this)[i].values) result.push_back(value);
        }
        return result;
    }

    bool has_same_names(const Uniforms& other) const {
        return names_ == other.names_ && entries_.size() == other.entries_.size();
    }

    friend std::strong_ordering operator<=>(const Uniforms& a, const Uniforms& b);
    friend bool operator==(const Uniforms& a, const Uniforms& b) { return (a <=> b) == 0; }

  private:
    struct Entry {
        std::uint32_t name_at = 0, name_length = 0;  // in names_
        std::uint32_t first = 0, count = 0;          // in floats_
        friend auto operator<=>(const Entry&,
                                const Entry&) = default;  // NOLINT: clang-tidy takes it for a null pointer
    };
    std::string names_;  // each ends in a space
    std::vector<Entry> entries_;
    std::vector<float> floats_;
};

// Whether the floats are the same bit by bit: a NaN equals itself.
bool are_same(std::span<const float> a, std::span<const float> b);

}  // namespace twinlight::programmable
