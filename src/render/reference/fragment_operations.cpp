#include "render/reference/fragment_operations.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace twinlight::reference {

namespace {

constexpr int kColorCodes = 255;
// The error of a colour in float arithmetic (2.1.1: 1 part in 10^5 per operation), for the alpha test.
constexpr double kArithmetic = 1e-4;

// The number of products in the blend equation that round: all except those with 0 or 1.
int rounding_products(const FragmentState& state, std::size_t i) {
    const Enum equation = blend_equation(state, i);
    if (equation == kGL_MIN || equation == kGL_MAX) return 0;
    const auto rounds = [](Enum factor) { return factor != kGL_ZERO && factor != kGL_ONE ? 1 : 0; };
    return i == 3 ? rounds(state.blend_src_alpha) + rounds(state.blend_dst_alpha)
                  : rounds(state.blend_src) + rounds(state.blend_dst);
}

}  // namespace

Outcome stipple_outcome(const LineStipple& stipple, int count, int doubt) {
    const auto bit = [&](int number) {
        return (stipple.pattern >> (std::max(number, 0) / stipple.factor % 16) & 1) != 0;
    };
    const bool is_even = stipple.pattern == 0 || stipple.pattern == 0xFFFF;
    for (int i = -doubt; !is_even && i <= doubt; ++i)
        if (bit(count + i) != bit(count)) return Outcome::kOpen;
    return bit(count) ? Outcome::kPasses : Outcome::kFails;
}

PixelRect scissored(const Scissor& scissor, const PixelRect& rect) {
    if (!scissor.enabled) return rect;
    const auto end = [](int start, int size) {  // the sum may overflow an int
        return static_cast<int>(std::min<std::int64_t>(std::int64_t{start} + size, INT32_MAX));
    };
    return {std::max(rect.x0, scissor.box.x), std::max(rect.y0, scissor.box.y),
            std::min(rect.x1, end(scissor.box.x, scissor.box.width)),
            std::min(rect.y1, end(scissor.box.y, scissor.box.height))};
}

Outcome alpha_outcome(const FragmentState& state, double alpha) {
    return outcome_of(compares(state.alpha_func, held(alpha), held(state.alpha_ref)));
}

Outcome alpha_outcome(const FragmentState& state, const Interval& alpha) {
    const double reference = clamp01(state.alpha_ref);
    const bool equal = alpha == Interval(reference);
    const bool may_be_equal = alpha.low - kArithmetic - 1.0 / kColorCodes <= reference &&
                              reference <= alpha.high + kArithmetic + 1.0 / kColorCodes;
    if (!equal && may_be_equal && state.alpha_func != kGL_ALWAYS && state.alpha_func != kGL_NEVER)
        return Outcome::kOpen;
    return alpha_outcome(state, alpha.low);
}

bool passes_stencil(const StencilFace& face, int stored) {
    const auto mask = static_cast<int>(face.mask & kMaxStencil);
    return compares(face.func, std::clamp(face.ref, 0, kMaxStencil) & mask, stored & mask);
}

int stencil_after(const StencilFace& face, Enum operation, int stored) {
    const auto result = [&]() -> int {
        switch (operation) {
            case kGL_ZERO: return 0;
            case kGL_REPLACE: return std::clamp(face.ref, 0, kMaxStencil);
            case kGL_INCR: return std::min(stored + 1, kMaxStencil);
            case kGL_DECR: return std::max(stored - 1, 0);
            case kGL_INVERT: return ~stored;
            case kGL_INCR_WRAP: return stored + 1;
            case kGL_DECR_WRAP: return stored - 1;
        }
        return stored;  // GL_KEEP
    };
    const auto mask = static_cast<int>(face.write_mask & kMaxStencil);
    return (stored & ~mask) | (result() & mask);
}

int cleared_stencil(const Clear& clear, int stored) {
    const auto mask = static_cast<int>(clear.stencil_mask & kMaxStencil);
    return (stored & ~mask) | (clear.clear_stencil & mask);
}

double held(double channel) { return std::floor(clamp01(channel) * kColorCodes + 0.5) / kColorCodes; }

Interval held(const Interval& channel) { return {held(channel.low - kArithmetic), held(channel.high + kArithmetic)}; }

Interval rounded_factor(const Interval& channel) { return hull(channel, held(channel)); }

Interval rounded_products(const FragmentState& state, std::size_t i, const Interval& sum) {
    constexpr double kRoundedProduct = 0.5 / kColorCodes;
    return widened(sum, kRoundedProduct * rounding_products(state, i));
}

namespace {

constexpr double kAccumulationStep = 1.0 / 32767;  // of 16 bits with a sign

}  // namespace

Interval kept_accumulation(const Interval& value) {
    const Interval near = widened(value, kAccumulationStep);
    return {std::clamp(near.low, -1.0, 1.0), std::clamp(near.high, -1.0, 1.0)};
}

// The middle, because drivers that cut values do not leave the range with weights whose sum is 1.
bool leaves_accumulation(const Interval& value) {
    constexpr double kRounding = 1e-6;  // of weights given as floats
    return std::abs(value.low + value.high) / 2 > 1 + kRounding;
}

Interval blended_over_alpha(const FragmentState& state, std::size_t i, const Channels<Interval>& source,
                            const Channels<Interval>& destination, const Channels<Interval>& constant) {
    const bool is_linear =
        i < 3 && state.blend_src != kGL_SRC_ALPHA_SATURATE && state.blend_dst != kGL_SRC_ALPHA_SATURATE;
    if (!is_linear) return blended(state, i, source, destination, constant);
    Channels<Interval> least = source, most = source;
    least[3] = source[3].low;
    most[3] = source[3].high;
    return hull(blended(state, i, least, destination, constant), blended(state, i, most, destination, constant));
}

double combined(Enum logic_op, double source, double stored) {
    const auto code = [](double channel) { return static_cast<unsigned>(std::lround(held(channel) * kColorCodes)); };
    const unsigned s = code(source), d = code(stored);
    const auto result = [&]() -> unsigned {
        switch (logic_op) {
            case kGL_CLEAR: return 0;
            case kGL_AND: return s & d;
            case kGL_AND_REVERSE: return s & ~d;
            case kGL_AND_INVERTED: return ~s & d;
            case kGL_NOOP: return d;
            case kGL_XOR: return s ^ d;
            case kGL_OR: return s | d;
            case kGL_NOR: return ~(s | d);
            case kGL_EQUIV: return ~(s ^ d);
            case kGL_INVERT: return ~d;
            case kGL_OR_REVERSE: return s | ~d;
            case kGL_COPY_INVERTED: return ~s;
            case kGL_OR_INVERTED: return ~s | d;
            case kGL_NAND: return ~(s & d);
            case kGL_SET: return ~0U;
        }
        return s;  // GL_COPY
    };
    return (result() & kColorCodes) / static_cast<double>(kColorCodes);
}

Interval combined(Enum logic_op, const Interval& source, const Interval& stored) {
    const bool needs_source =
        logic_op != kGL_CLEAR && logic_op != kGL_SET && logic_op != kGL_NOOP && logic_op != kGL_INVERT;
    const bool needs_stored =
        logic_op != kGL_CLEAR && logic_op != kGL_SET && logic_op != kGL_COPY && logic_op != kGL_COPY_INVERTED;
    const Interval s = needs_source ? held(source) : Interval(0), d = needs_stored ? held(stored) : Interval(0);
    constexpr double kMostCodes = 8;  // beyond them nearly all results are possible
    if (std::max(s.width(), d.width()) * kColorCodes > kMostCodes && needs_source && needs_stored) return {0, 1};
    constexpr double kCode = 1.0 / kColorCodes;
    Interval result = combined(logic_op, s.low, d.low);
    for (double from = s.low; from < s.high + kCode / 2; from += kCode)
        for (double to = d.low; to < d.high + kCode / 2; to += kCode)
            result = hull(result, Interval(combined(logic_op, from, to)));
    return result;
}

bool overwrites_color(const FragmentState& state) {
    if (state.logic_op) return false;
    const bool adds = state.blend_equation == kGL_FUNC_ADD && state.blend_equation_alpha == kGL_FUNC_ADD;
    const bool blends = state.blend && (!adds || state.blend_src != kGL_ONE || state.blend_dst != kGL_ZERO ||
                                        state.blend_src_alpha != kGL_ONE || state.blend_dst_alpha != kGL_ZERO);
    return !blends && std::ranges::all_of(state.color_mask, [](bool on) { return on; });
}

bool writes_color(const FragmentState& state) {
    return std::ranges::any_of(state.color_mask, [](bool on) { return on; });
}

}  // namespace twinlight::reference
