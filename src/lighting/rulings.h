// Rulings: our choices where the specification is silent. These are the ones that can change a colour.
// docs/hard-cases.md has them as a table: `make tables` writes it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string_view>

namespace twinlight::lighting {

enum class Ruling : std::uint8_t {
    kLightAtVertex,
    kAttenuation,
    kZeroNormal,
    kSingularModelview,
    kAtInfinity,
    kOppositeHalfVector,
    kEqualCones,
    kSquares,
    kNoNumber,
    kSpotBorder,
    kRescaled,
    kZeroSpotDirection,
    kVertexAtEye,
    kFarFromOrigin,
    kFogWithoutDepth,
    kDecal,
    kZeroQuotient,
    kUncountable,
    kMixedOutcomes,
};

struct RulingText {
    Ruling ruling;
    std::string_view state, answer, reason;
};

inline constexpr RulingText kRulings[] = {
    {Ruling::kLightAtVertex, "a light exactly at the vertex, or whose direction is (0, 0, 0)",
     "the light adds only its ambient term", "0/0 has no limit, and the ambient term needs no direction"},
    {Ruling::kAttenuation, "attenuation whose denominator is 0 or negative", "the light contributes 0",
     "1/d grows without bound, so there is no limit"},
    {Ruling::kZeroNormal, "a zero normal that is to be scaled to length 1", "it stays 0: ambient and emission only",
     "0/0 has no limit, and 2.14.1 uses a zero normal as it is"},
    {Ruling::kSingularModelview, "a singular modelview: its rank is less than 3 for numbers of 21 bits",
     "every normal becomes 0", "the inverse does not exist, and rounding would decide the normal"},
    {Ruling::kAtInfinity, "the distance of a vertex with eye w = 0 from a positional light, and in fog",
     "infinite: attenuation with k_1 or k_2 is 0, and fog hides all", "that is the limit as w goes to 0"},
    {Ruling::kOppositeHalfVector, "a half vector of length 0 (L = -V)", "no highlight, except for shininess 0: 0^0 = 1",
     "a zero vector has no cosine; section 2.1.1 requires 0^0 = 1"},
    {Ruling::kEqualCones, "a smooth spot whose cones are equal", "a step that includes its border",
     "that is the limit of ever narrower slopes, with the >= of section 2.14.1"},
    {Ruling::kSquares, "coordinates whose squares overflow or underflow", "scaled by a power of two, which is exact",
     "a unit vector does not depend on the length"},
    {Ruling::kNoNumber, "terms beyond the largest number with both signs, or infinite state", "they contribute 0",
     "not even the sign of the sum is known; with one sign, 2.14.6 clamps the colour as any other"},
    {Ruling::kSpotBorder, "a cosine that equals the spot's cutoff",
     "lit; the comparison allows 4 epsilon for rounding, so in floats a cone of 0 degrees reaches 0.056 degrees",
     "section 2.14.1 requires >=, and rounding must not darken the border"},
    {Ruling::kRescaled, "RESCALE_NORMAL: rescale or normalise",
     "rescale by the factor of 2.11.3; with NORMALIZE as well, normalise",
     "section 2.11.3 allows both; the factor is what the name says"},
    {Ruling::kZeroSpotDirection, "a spot direction of length 0",
     "its cosine with every direction is 0, so cones narrower than 90 degrees are dark", "as for a zero normal"},
    {Ruling::kVertexAtEye, "a vertex at the eye, local viewer", "VP_e is 0, so the half vector is VP",
     "a direction of length 0 adds nothing"},
    {Ruling::kFarFromOrigin, "object and camera far from the origin",
     "as exact as near the origin: the distances cancel in double precision",
     "section 2.1.1 allows an error of 1e-5 of the distance, but the picture should not depend on the origin"},
    {Ruling::kFogWithoutDepth, "linear fog that ends where it starts",
     "no fog before that distance, full fog from there on", "that is the limit of ever shorter ranges"},
    {Ruling::kDecal, "DECAL with a format that lacks red, green, blue", "the fragment keeps its colour",
     "section 3.8.13 leaves it undefined, and the texture has no colour to put on"},
    {Ruling::kZeroQuotient, "q of 0 in texture coordinates", "the quotient is 0", "there is no limit; 0 is finite"},
    {Ruling::kUncountable, "a texture coordinate beyond 1e15 or not a number", "0",
     "it has no fraction left that could choose a texel"},
    {Ruling::kMixedOutcomes, "a linear filter of a texture that compares its depths with r",
     "each depth is compared, and the outcomes are mixed",
     "section 3.8.14 asks for a number proportional to the passes; a mean of depths would lie on no surface"},
};
constexpr bool are_in_enum_order() {
    for (std::size_t i = 0; i < std::size(kRulings); ++i)
        if (kRulings[i].ruling != static_cast<Ruling>(i)) return false;
    return true;
}
static_assert(are_in_enum_order());
constexpr const RulingText& text_of(Ruling ruling) { return kRulings[static_cast<std::size_t>(ruling)]; }

class RulingSet {
  public:
    constexpr RulingSet() = default;
    constexpr RulingSet(std::initializer_list<Ruling> rulings) {
        for (const Ruling ruling : rulings) bits_ |= 1u << static_cast<unsigned>(ruling);
    }
    constexpr bool contains(Ruling ruling) const { return (bits_ >> static_cast<unsigned>(ruling) & 1u) != 0; }
    constexpr bool empty() const { return bits_ == 0; }
    constexpr RulingSet& operator|=(RulingSet other) {
        bits_ |= other.bits_;
        return *this;
    }
    friend constexpr RulingSet operator|(RulingSet a, RulingSet b) { return a |= b; }
    friend constexpr bool operator==(RulingSet, RulingSet) = default;

  private:
    std::uint32_t bits_ = 0;
};
static_assert(std::size(kRulings) <= 32);

}  // namespace twinlight::lighting
