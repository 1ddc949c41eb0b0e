#include "lighting/points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lighting/points_kernel.h"
#include "lighting/power_table.h"

namespace twinlight::lighting {

#if defined(__x86_64__)
void light_points_avx2(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                       const Arithmetic& arithmetic, Lit<Column>& lit);
void light_points_avx512(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                         const Arithmetic& arithmetic, Lit<Column>& lit);
#endif

namespace {

// The most lanes of any instruction set: 16 floats in AVX-512.
constexpr std::size_t kMostLanes = 16;

template <class Visit>
void for_each_column(Points& points, const Visit& visit) {
    Material<Column>& m = points.material;
    for (Vec3<Column>* three :
         {&points.surface.position_eye, &points.surface.normal_eye, &m.emission, &m.ambient, &m.diffuse, &m.specular})
        for (Column* column : {&three->x, &three->y, &three->z}) visit(*column);
    visit(m.diffuse_alpha);
    visit(m.shininess);
}

// Repeats the last point until there are kMostLanes points.
Points padded(Points points) {
    const bool is_one = points.size() == 1;  // read before the first column grows
    for_each_column(points, [&](Column& column) {
        if (column.size() != 1 || is_one) column.resize(kMostLanes, column.back());
    });
    return points;
}

// Point by point, for a number type without SIMD instructions.
template <class Real>
void light_each(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                Lit<Column>& lit) {
    const Kernel<Real> kernel(model, lights, points);
    for (std::size_t i = 0; i < points.size(); ++i) kernel.light(i, lit);
}

void push_back(Vec3<Column>& columns, const Vec3<double>& v) {
    columns.x.push_back(v.x);
    columns.y.push_back(v.y);
    columns.z.push_back(v.z);
}

}  // namespace

void Points::clear() {
    for_each_column(*this, [](Column& column) { column.clear(); });
}

void Points::add(const SurfacePoint<double>& point) {
    push_back(surface.position_eye, point.position_eye);
    push_back(surface.normal_eye, point.normal_eye);
}

void Points::add(const Material<double>& point_material) {
    push_back(material.emission, point_material.emission);
    push_back(material.ambient, point_material.ambient);
    push_back(material.diffuse, point_material.diffuse);
    push_back(material.specular, point_material.specular);
    material.diffuse_alpha.push_back(point_material.diffuse_alpha);
    material.shininess.push_back(point_material.shininess);
}

PowerBy power_by(Powers powers, const std::vector<Light<double>>& lights, const Points& points) {
    const Column& shininess = points.material.shininess;
    const bool is_same = std::all_of(shininess.begin(), shininess.end(), [&](double s) { return s == shininess[0]; });
    if (!is_same) return PowerBy::kLibrary;
    if (powers == Powers::kTable) return PowerBy::kTable;
    const bool is_short =
        is_short_product(shininess[0]) && std::all_of(lights.begin(), lights.end(), [](const Light<double>& light) {
            return !light.is_spot || is_short_product(light.spot_exponent);
        });
    if (!is_short) return PowerBy::kLibrary;
    return powers == Powers::kPow ? PowerBy::kExactProducts : PowerBy::kRoundedProducts;
}

const std::vector<InstructionSet>& instruction_sets() {
    static const std::vector<InstructionSet> sets = [] {
        std::vector<InstructionSet> there;
#if defined(__x86_64__)
        // __builtin_cpu_supports also checks that the operating system saves the wide registers.
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
            __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
            there.push_back({"AVX-512", light_points_avx512});
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
            there.push_back({"AVX2", light_points_avx2});
        there.push_back({"SSE2", light_points_on<xsimd::default_arch>});
#else
        there.push_back({xsimd::default_arch::name(), light_points_on<xsimd::default_arch>});
#endif
        return there;
    }();
    return sets;
}

namespace {

// RULING (as divided() in real.h): a position that floats cannot hold is moved to the farthest one in its direction.
Vec3<double> within_floats(Vec3<double> v) {
    constexpr double kFar = Limits<float>::big;
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
        const auto direction = [](double x) { return std::isinf(x) ? std::copysign(1.0, x) : 0; };
        return Vec3<double>{direction(v.x), direction(v.y), direction(v.z)} * kFar;
    }
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest <= kFar ? v : v * (kFar / largest);
}

bool is_within_floats(const Points& points) {
    const Vec3<Column>& at = points.surface.position_eye;
    const auto is_within = [](double x) { return std::abs(x) <= Limits<float>::big; };
    return std::ranges::all_of(at.x, is_within) && std::ranges::all_of(at.y, is_within) &&
           std::ranges::all_of(at.z, is_within);
}

Points within_floats(Points points) {
    Vec3<Column>& at = points.surface.position_eye;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3<double> v = within_floats(Vec3<double>{at.x[i], at.y[i], at.z[i]});
        at.x[i] = v.x;
        at.y[i] = v.y;
        at.z[i] = v.z;
    }
    return points;
}

void resize(Vec3<Column>& columns, std::size_t count) {
    for (Column* column : {&columns.x, &columns.y, &columns.z}) column->resize(count);
}

}  // namespace

void light_points(const Model<double>& model, const std::vector<Light<double>>& lights, const Points& points,
                  const Arithmetic& arithmetic, Lit<Column>& lit) {
    const std::size_t count = points.size();
    if (count > 0 && count < kMostLanes) {
        light_points(model, lights, padded(points), arithmetic, lit);
    } else if (arithmetic.number == Number::kFloat && !is_within_floats(points)) {
        light_points(model, lights, within_floats(points), arithmetic, lit);
    } else {
        resize(lit.primary, count);
        if (model.separate_specular)
            resize(lit.secondary, count);
        else
            for (Column* column : {&lit.secondary.x, &lit.secondary.y, &lit.secondary.z}) column->assign(1, 0);
        if (arithmetic.number == Number::kLongDouble)
            light_each<long double>(model, lights, points, lit);
        else if (count > 0)
            instruction_sets().front().light_points(model, lights, points, arithmetic, lit);
    }
    resize(lit.primary, count);
    if (model.separate_specular) resize(lit.secondary, count);
    lit.alpha = points.material.diffuse_alpha;
}

// ---- Powers by table ----

const double* power_table(double exponent) {
    struct Kept {
        double exponent = 0;
        std::array<double, kPowerTableSteps + 2> entries{};
    };
    thread_local std::array<Kept, 16> kept;  // a Draw has at most 9 exponents: 8 lights and a material
    thread_local std::size_t oldest = 0;
    for (const Kept& k : kept)
        if (k.exponent == exponent) return k.entries.data();
    Kept& table = kept[oldest++ % kept.size()];
    table.exponent = exponent;
    for (std::size_t i = 0; i < table.entries.size(); ++i)
        table.entries[i] = std::pow(static_cast<double>(i) / kPowerTableSteps, exponent);
    return table.entries.data();
}

}  // namespace twinlight::lighting
