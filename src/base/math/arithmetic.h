// In which numbers a renderer calculates, and how it takes powers: choices of the accuracy study.
#pragma once

#include <cstdint>

namespace twinlight {

enum class Number : std::uint8_t { kDouble, kFloat, kLongDouble };

enum class Powers : std::uint8_t {
    kPow,       // right to the last place or two
    kSquaring,  // whole exponents by repeated squaring: each product rounds
    kTable,     // between entries of a table (lighting/power_table.h)
};

struct Arithmetic {
    Number number = Number::kDouble;
    Powers powers = Powers::kPow;

    friend bool operator==(const Arithmetic&, const Arithmetic&) = default;
};

}  // namespace twinlight
