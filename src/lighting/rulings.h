// Rulings: our choices where the specification is silent. These are the ones that can change a colour.
// docs/hard-cases.md gives the reason for each; a test compares the two lists.
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
    kBehindSpot,
    kRescaled,
    kZeroSpotDirection,
    kVertexAtEye,
    kFarFromOrigin,
    kFogWithoutDepth,
    kDecal,
    kZeroQuotient,
    kUncountable,
};

struct RulingText {
    Ruling ruling;
    std::string_view state, answer;  // the first two columns of the document's tables
};

inline constexpr RulingText kRulings[] = {
    {Ruling::kLightAtVertex, "a light exactly at the vertex, or whose direction is (0, 0, 0)",
     "only its ambient term counts; diffuse and specular need a direction and are 0"},
    {Ruling::kAttenuation, "attenuation whose denominator is 0 or negative (k = 0, 0, 0; k_0 = 0 at the vertex)",
     "the light contributes 0"},
    {Ruling::kZeroNormal, "a zero normal", "ambient and emission only"},
    {Ruling::kSingularModelview, "a singular modelview", "every normal becomes 0"},
    {Ruling::kAtInfinity, "a vertex with eye w = 0", "lit like a vertex very far away in that direction"},
    {Ruling::kOppositeHalfVector, "a half vector of length 0 (L = -V)",
     "no highlight, except for shininess 0: 0^0 = 1"},
    {Ruling::kEqualCones, "a smooth spot whose cones are equal", "a step that includes its border"},
    {Ruling::kSquares, "coordinates whose squares overflow or underflow", "scaled by a power of two, which is exact"},
    {Ruling::kNoNumber, "a colour beyond the largest number", "that term contributes 0"},
    {Ruling::kSpotBorder, "a cosine that equals the spot's cutoff",
     "lit (2.14.1 requires >=); the comparison allows 4 epsilon for rounding, so in floats a cone of 0 degrees reaches "
     "0.056 degrees"},
    {Ruling::kBehindSpot,
     "behind a spot of 90 degrees and exponent 0 (2.14.1 compares max(PV . s, 0), which cos 90 never exceeds)", "dark"},
    {Ruling::kRescaled, "RESCALE_NORMAL: rescale or normalise",
     "rescale by the factor of 2.11.3; with NORMALIZE as well, normalise"},
    {Ruling::kZeroSpotDirection, "a spot direction of length 0",
     "its cosine with every direction is 0, so cones narrower than 90 degrees are dark"},
    {Ruling::kVertexAtEye, "a vertex at the eye, local viewer", "VP_e is 0, so the half vector is VP"},
    {Ruling::kFarFromOrigin,
     "object and camera far from the origin (2.1.1 leaves a driver 1e-5 of their distance from it)",
     "the distances cancel in double precision, so the result is as exact as near the origin"},
    {Ruling::kFogWithoutDepth, "linear fog that ends where it starts",
     "no fog before that distance, full fog from there on"},
    {Ruling::kDecal, "DECAL with a format that lacks red, green, blue (3.8.13)", "the fragment keeps its colour"},
    {Ruling::kZeroQuotient, "q or w of 0 in texture coordinates and fog", "the quotient is 0"},
    {Ruling::kUncountable, "a texture coordinate beyond 1e15 or not a number", "0"},
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
