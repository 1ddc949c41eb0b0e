// The number type of a renderer, and its method for powers. The accuracy study (`twinlight study`) varies both.
#pragma once

#include <cstdint>

namespace twinlight {

enum class Number : std::uint8_t { kDouble, kFloat, kLongDouble };

enum class Powers : std::uint8_t {
    kPow,       // correct to one or two units in the last place
    kSquaring,  // whole exponents by repeated squaring; each product is rounded
    kTable,     // interpolates in a table (lighting/power_table.h)
};

struct Arithmetic {
    Number number = Number::kDouble;
    Powers powers = Powers::kPow;

    friend bool operator==(const Arithmetic&, const Arithmetic&) = default;
};

}  // namespace twinlight
