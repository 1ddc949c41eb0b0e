// What lighting/ uses of xsimd, with a single lane: xsimd 8 (Debian 12) lacks WebAssembly's instructions, and with those of xsimd
// 13 pictures took as long.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>

namespace xsimd {

struct default_arch {
    static constexpr const char* name() { return "WebAssembly"; }
};

template <class Scalar, class Arch = default_arch>
struct batch_bool {
    bool lane;
    friend batch_bool operator&(batch_bool a, batch_bool b) { return {a.lane && b.lane}; }
};
template <class Scalar, class Arch>
bool all(batch_bool<Scalar, Arch> mask) {
    return mask.lane;
}

template <class Scalar, class Arch = default_arch>
struct batch {
    using value_type = Scalar;
    using Mask = batch_bool<Scalar, Arch>;
    static constexpr std::size_t size = 1;

    batch() = default;
    batch(Scalar all) : lane(all) {}
    static batch load_unaligned(const Scalar* from) { return *from; }
    void store_unaligned(Scalar* to) const { *to = lane; }
    Scalar get(std::size_t /*lane*/) const { return lane; }

    friend batch operator+(batch a, batch b) { return a.lane + b.lane; }
    friend batch operator-(batch a, batch b) { return a.lane - b.lane; }
    friend batch operator*(batch a, batch b) { return a.lane * b.lane; }
    friend batch operator/(batch a, batch b) { return a.lane / b.lane; }
    friend batch operator-(batch a) { return -a.lane; }
    friend Mask operator<(batch a, batch b) { return {a.lane < b.lane}; }
    friend Mask operator<=(batch a, batch b) { return {a.lane <= b.lane}; }
    friend Mask operator>(batch a, batch b) { return {a.lane > b.lane}; }
    friend Mask operator>=(batch a, batch b) { return {a.lane >= b.lane}; }
    friend Mask operator==(batch a, batch b) { return {a.lane == b.lane}; }

    Scalar lane;
};
template <class Scalar, class Arch>
batch<Scalar, Arch> select(batch_bool<Scalar, Arch> mask, batch<Scalar, Arch> a, batch<Scalar, Arch> b) {
    return mask.lane ? a : b;
}
template <class Scalar, class Arch>
batch<Scalar, Arch> abs(batch<Scalar, Arch> a) {
    return std::abs(a.lane);
}
template <class Scalar, class Arch>
batch<Scalar, Arch> sqrt(batch<Scalar, Arch> a) {
    return std::sqrt(a.lane);
}

template <class Type, std::size_t>
using aligned_allocator = std::allocator<Type>;

}  // namespace xsimd
