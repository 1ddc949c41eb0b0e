// The parts of the lists of uniforms (program_uniforms.h, light_values.h).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace twinlight::programmable {

// How a shader declares a uniform: "uniform TYPE NAME ARRAY;  // COMMENT". `above` is the text of comments in the lines before.
struct Declaration {
    std::string_view type, name, comment = "", array = "", above = "";
};

// A set of an enum's values.
template <class Value>
class ValueSet {
  public:
    bool contains(Value value) const { return (values_ & bit(value)) != 0; }
    void add(Value value, bool is_needed = true) {
        if (is_needed) values_ |= bit(value);
    }
    void add(std::initializer_list<Value> values, bool is_needed = true) {
        for (const Value value : values) add(value, is_needed);
    }
    // In the enum's order.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (std::uint64_t rest = values_; rest != 0; rest &= rest - 1)
            visit(static_cast<Value>(std::countr_zero(rest)));
    }
    friend bool operator==(const ValueSet&, const ValueSet&) = default;

  private:
    static std::uint64_t bit(Value value) { return std::uint64_t{1} << static_cast<unsigned>(value); }

    std::uint64_t values_ = 0;
};

}  // namespace twinlight::programmable
