// light_points for one number type. Each file that is compiled for an instruction set (points_avx2.cpp, ...)
// instantiates it.
//
// This file and its includes must contain only templates over that type. Other functions would be compiled for the wide
// instruction set, and the linker might use them on all processors (tests/unit/lighting/points_test.cpp checks the
// symbols).
#pragma once

#include <optional>
#include <type_traits>

#include "lighting/lanes.h"
#include "lighting/points.h"
#include "lighting/real_cast.h"

namespace twinlight::lighting {

// How many points a Real holds.
template <class Real>
inline constexpr std::size_t kPointsIn = 1;
template <class Scalar, class Arch, Range kRange, PowerBy kPower>
inline constexpr std::size_t kPointsIn<Lanes<Scalar, Arch, kRange, kPower>> = xsimd::batch<Scalar, Arch>::size;

// Loads as many points as a Real holds, from `first` on.
template <class Real>
[[gnu::always_inline]] inline Real load(const double* column, std::size_t first) {
    const double* from = column + first;
    if constexpr (std::is_floating_point_v<Real>) {
        return static_cast<Real>(*from);
    } else if constexpr (std::is_same_v<typename Real::Batch::value_type, double>) {
        return Real(Real::Batch::load_unaligned(from));
    } else {
        typename Real::Batch::value_type numbers[kPointsIn<Real>];
        for (std::size_t i = 0; i < kPointsIn<Real>; ++i)
            numbers[i] = static_cast<typename Real::Batch::value_type>(from[i]);
        return Real(Real::Batch::load_unaligned(numbers));
    }
}
template <class Real>
[[gnu::always_inline]] inline Vec3<Real> load(const Vec3<Column>& columns, std::size_t first) {
    return {load<Real>(columns.x.data(), first), load<Real>(columns.y.data(), first),
            load<Real>(columns.z.data(), first)};
}
template <class Real>
[[gnu::always_inline]] inline Material<Real> load(const Material<Column>& columns, std::size_t first) {
    return {.emission = load<Real>(columns.emission, first),
            .ambient = load<Real>(columns.ambient, first),
            .diffuse = load<Real>(columns.diffuse, first),
            .specular = load<Real>(columns.specular, first),
            .shininess = load<Real>(columns.shininess.data(), first)};
}

template <class Real>
[[gnu::always_inline]] inline void store(const Real& points, double* column, std::size_t first) {
    double* to = column + first;
    if constexpr (std::is_same_v<Real, long double>) {  // which may be beyond the largest double
        constexpr long double kLargest = Limits<double>::largest;
        *to = static_cast<double>(points > kLargest ? kLargest : points < -kLargest ? -kLargest : points);
    } else if constexpr (std::is_floating_point_v<Real>) {
        *to = static_cast<double>(points);
    } else if constexpr (std::is_same_v<typename Real::Batch::value_type, double>) {
        points.batch.store_unaligned(to);
    } else {
        typename Real::Batch::value_type numbers[kPointsIn<Real>];
        points.batch.store_unaligned(numbers);
        for (std::size_t i = 0; i < kPointsIn<Real>; ++i) to[i] = static_cast<double>(numbers[i]);
    }
}
template <class Real>
[[gnu::always_inline]] inline void store(const Vec3<Real>& points, Vec3<Column>& columns, std::size_t first) {
    store(points.x, columns.x.data(), first);
    store(points.y, columns.y.data(), first);
    store(points.z, columns.z.data(), first);
}

template <class Real>
[[gnu::always_inline]] inline bool is_finite(const Lit<Real>& /*lit*/) {
    return true;
}
template <class Scalar, class Arch, PowerBy kPower>
[[gnu::always_inline]] inline bool is_finite(const Lit<Lanes<Scalar, Arch, Range::kPlain, kPower>>& lit) {
    const auto [red, green, blue] = lit.primary;
    const auto sum = (red + green) + (blue + (lit.secondary.x + lit.secondary.y + lit.secondary.z));
    return xsimd::all(abs(sum).batch <= Limits<Scalar>::largest);
}

// Stands for a material whose colours are already multiplied into those of the lights and the model.
struct White {
    template <class Real>
    friend Vec3<Real> operator*(White /*white*/, Vec3<Real> color) {
        return color;
    }
};
template <class Real>
struct WhiteMaterial {
    Vec3<Real> emission{};
    White ambient{}, diffuse{}, specular{};
    Real diffuse_alpha{1}, shininess{0};
};

// The equation for one lighting state. The points must outlive it.
template <class Real>
class Kernel {
  public:
    Kernel(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points)
        : points_(points), model_(real_cast<Real>(model)) {
        lights_.reserve(lights.size());
        for (const Light<double>& light : lights) lights_.push_back(real_cast<Real>(light));
        if (points.has_one_material()) multiply_in(load<double>(points.material, 0), lights);
    }

    // Lights the points from `first` on. Returns false, and stores nothing, if a lane needs a guard of real.h that Real
    // lacks. flatten keeps all Reals in registers.
    [[gnu::flatten]] bool light(std::size_t first, Lit<Column>& columns) const {
        const Vec3<Real> normal = load<Real>(points_.surface.normal_eye, first);
        const SurfacePoint<Real> surface{load<Real>(points_.surface.position_eye, first),
                                         points_.makes_unit_normals ? unit(normal) : normal};
        const Lit<Real> lit = points_.has_one_material()
                                  ? light_surface<Real>(model_, material_, surface, lights_)
                                  : light_surface<Real>(model_, load<Real>(points_.material, first), surface, lights_);
        if (!is_finite(lit)) return false;
        store(lit.primary, columns.primary, first);
        if (model_.separate_specular) store(lit.secondary, columns.secondary, first);
        return true;
    }
    // Lights all points. There must be at least as many as a Real holds; some of the last ones may be lit twice. Where
    // light() returns false, it calls again(first).
    template <class Again>
    [[gnu::flatten]] void light_all(Lit<Column>& columns, const Again& again) const {
        const std::size_t count = points_.size(), last = count - kPointsIn<Real>;
        for (std::size_t i = 0; i < count; i += kPointsIn<Real>) {
            const std::size_t first = i < last ? i : last;
            if (!light(first, columns)) again(first);
        }
    }

  private:
    void multiply_in(const Material<double>& material, const std::vector<Light<double>>& lights) {
        const auto own = real_cast<Real>(material);
        material_ = {.emission = own.emission, .shininess = own.shininess};
        model_.ambient = own.ambient * model_.ambient;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            Light<Real>& light = lights_[i];
            light.ambient = own.ambient * light.ambient;
            light.diffuse = own.diffuse * light.diffuse;
            light.specular = own.specular * light.specular;
            light.has_ambient = material.ambient * lights[i].ambient != Vec3<double>{};
            light.has_specular = material.specular * lights[i].specular != Vec3<double>{};
        }
    }

    const Points& points_;
    Model<Real> model_;
    std::vector<Light<Real>> lights_;
    WhiteMaterial<Real> material_;  // used if all points share one material
};

// There must be at least as many points as lanes.
template <class Scalar, class Arch, PowerBy kPower>
void light_lanes(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                 Lit<Column>& lit) {
    using Plain = Lanes<Scalar, Arch, Range::kPlain, kPower>;
    using Guarded = Lanes<Scalar, Arch, Range::kAny, PowerBy::kLibrary>;
    std::optional<Kernel<Guarded>> guarded;  // most states never need it
    // noinline, because light_all is flattened and should not include this rare case.
    const auto again = [&](std::size_t first) __attribute__((noinline)) {
        if (!guarded) guarded.emplace(model, lights, points);
        guarded->light(first, lit);
    };
    Kernel<Plain>(model, lights, points).light_all(lit, again);
}

// The fastest method for these exponents that `powers` allows.
PowerBy power_by(Powers powers, const std::vector<Light<double>>& lights, const Points& points);

template <class Scalar, class Arch>
void light_points_in(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                     Powers powers, Lit<Column>& lit) {
    // Without fused products the library is as fast.
    constexpr PowerBy kExact = FusedProduct<Arch>::kAvailable ? PowerBy::kExactProducts : PowerBy::kLibrary;
    switch (power_by(powers, lights, points)) {
        case PowerBy::kLibrary: return light_lanes<Scalar, Arch, PowerBy::kLibrary>(model, lights, points, lit);
        case PowerBy::kExactProducts: return light_lanes<Scalar, Arch, kExact>(model, lights, points, lit);
        case PowerBy::kRoundedProducts:
            return light_lanes<Scalar, Arch, PowerBy::kRoundedProducts>(model, lights, points, lit);
        case PowerBy::kTable: return light_lanes<Scalar, Arch, PowerBy::kTable>(model, lights, points, lit);
    }
}

template <class Arch>
void light_points_on(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                     const Arithmetic& arithmetic, Lit<Column>& lit) {
    if (arithmetic.number == Number::kFloat)
        light_points_in<float, Arch>(model, lights, points, arithmetic.powers, lit);
    else
        light_points_in<double, Arch>(model, lights, points, arithmetic.powers, lit);
}

}  // namespace twinlight::lighting
