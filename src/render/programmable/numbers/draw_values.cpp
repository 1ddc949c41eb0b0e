#include "render/programmable/numbers/draw_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/math/directions.h"
#include "base/math/normal_matrix.h"
#include "render/effect/color_products.h"
#include "render/programmable/numbers/light_values.h"
#include "render/programmable/numbers/precise.h"
#include "render/programmable/numbers/program_uniforms.h"
#include "render/programmable/numbers/vertex_attributes.h"
#include "render/programmable/numbers/wide_range.h"

namespace twinlight::programmable {
namespace {

// The float cosine of two unit vectors may be too small by this much. "PV . s >= cos(cutoff)" includes equality
// (2.14.1), so the shader compares with a limit that is lower by this amount.
constexpr double kCosineRounding = 4.0 / (1 << 23);

glm::dvec3 rgb(const glm::dvec4& c) { return glm::dvec3(c); }

// A homogeneous position whose w, and whose largest component, are no denormal floats, which a processor may take for 0.
// A denormal w beside larger components is a point so far away that only its direction counts.
glm::dvec4 without_denormals(glm::dvec4 position) {
    constexpr double kSmallest = std::numeric_limits<float>::min();
    if (position.w == 0 || std::abs(position.w) >= kSmallest) return position;
    if (largest_component(glm::dvec3(position)) < kSmallest) return 0x1p60 * position;
    position.w = std::copysign(kSmallest, position.w);
    return position;
}

// ---- Ranges ----
// The shader squares lengths, and a float's square overflows above 1e38 and underflows below 1e-38. Lighting does not depend
// on the unit of length (attenuation does, so its factors are converted), nor on the length of normals that are scaled to 1.
// So lengths far from 1 are measured in another unit: a power of two, which rounds nothing.

bool needs_no_unit(double size) { return size > 1e-12 && size < 1e12; }

double eye_unit(const glm::dmat4& eye_from_object, const glm::dvec4& reach, const Plan& plan) {
    double size = reach_xyz(eye_from_object, reach);
    for (const glm::dvec3& place : places_eye(plan)) size = std::max(size, largest_component(place));
    return size > 1e-6 && size < 1e9 ? 1 : power_of_two(size);
}

// The largest components, in eye coordinates.
struct Sizes {
    double vertices = 0;    // after the division by w
    double places = 0;      // of places_eye()
    double directions = 0;  // of vertices with w = 0, and of lights that meet them (between_directions())
};
Sizes sizes_of(const Draw& draw, const Plan& plan) {
    Sizes sizes;
    const auto enlarge = [](double& size, const glm::dvec3& v) { size = std::max(size, largest_component(v)); };
    const bool meet = plan.effects.any_light(&LightEffects::meets_directions);
    for (const Vertex& vertex : draw.vertices) {
        const glm::dvec4 at = draw.eye_from_object * vertex.position_object;
        if (at.w != 0)
            enlarge(sizes.vertices, glm::dvec3(at) / at.w);
        else
            enlarge(sizes.directions, glm::dvec3(at));
    }
    for (const glm::dvec3& place : places_eye(plan)) enlarge(sizes.places, place);
    // Beside a light that is so much larger than all of these vertices, floats lose them, and it may come nearer.
    constexpr double kMuchLarger = 0x1p40;
    const double most = sizes.directions > 0 ? kMuchLarger * sizes.directions : HUGE_VAL;
    for (const PlannedLight& planned : plan.lights) {
        const glm::dvec4& p = plan.lighting.lights[static_cast<std::size_t>(planned.number)].position_eye;
        if (meet && p.w == 0)
            sizes.directions = std::max(sizes.directions, std::min(largest_component(glm::dvec3(p)), most));
    }
    return sizes;
}

// The unit of length where vertices keep their w, so that only the largest and the smallest lengths of all need one.
double unit_of_homogeneous(const Sizes& sizes, const Plan& plan) {
    // In scenes that are tiny as a whole, products of lengths would vanish. Vertices that are all directions have no distances.
    constexpr double kTiny = 1e-15;
    const double largest = std::max(sizes.vertices, sizes.places);
    if (sizes.vertices > 0 && std::max(largest, sizes.directions) < kTiny) return power_of_two(largest);
    double least = HUGE_VAL;           // factors that multiply a distance, or its square
    double slowest = HUGE_VAL;         // k_1
    double quickest = 0, squared = 0;  // the largest k_1, the largest k_2
    for (std::size_t i = 0; i < plan.lights.size(); ++i) {
        if (!plan.effects.lights[i].attenuated) continue;
        const LightSource& light = plan.lighting.lights[static_cast<std::size_t>(plan.lights[i].number)];
        const double k1 = light.linear_attenuation, k2 = light.quadratic_attenuation;
        if (k1 > 0) slowest = std::min(slowest, k1);
        for (const double k : {k1, k2})
            if (k > 0) least = std::min(least, k);
        quickest = std::max(quickest, k1);
        squared = std::max(squared, k2);
    }
    // Neither may the parts of vectors between tiny vertices, though a light be far away. Attenuation must keep its factors.
    constexpr double kVeryTiny = 1e-25, kUnit = 0x1p-50;
    if (sizes.vertices > 0 && std::max(sizes.vertices, sizes.directions) < kVeryTiny && least * kUnit * kUnit > 1e-36)
        return kUnit;
    // Vertices this far away need one if a light grows weaker so slowly that k_1 times the greatest distance of
    // the shader (distance_of() in equation.glsl) would not be large.
    constexpr double kFar = 1e28, kSlow = 1e-30, kMost = 1e37;
    const bool is_far = sizes.vertices > kFar;
    const double unit = power_of_two(kSlow / slowest);
    const bool keeps_factors = quickest * unit < kMost && squared * unit * unit < kMost;
    return slowest < kSlow && keeps_factors && is_far ? unit : 1;
}

// The matrix for normals (2.11.3). If normals are scaled to length 1 later, its scale does not matter.
glm::dmat3 normal_matrix_of(const Draw& draw, const Plan& plan) {
    glm::dmat3 normals = normal_matrix(glm::dmat3(draw.eye_from_object));
    const bool made_unit = makes_normals_unit(plan.effects);
    if (!made_unit && !plan.lighting.rescale_normal) return normals;
    double scale = 0;
    for (int column = 0; column < 3; ++column) scale = std::max(scale, largest_component(normals[column]));
    normals /= power_of_two(scale);
    // RESCALE_NORMAL's factor: 1 / sqrt(m31^2 + m32^2 + m33^2) of the inverse, whose third row is the third column here.
    const double third = glm::length(normals[2]);
    return made_unit || !(third > 0) ? normals : normals / third;
}

// ---- Uniforms ----

constexpr auto ambient_of_light = [](const LightSource& light) { return ambient_of(light); };
constexpr auto diffuse_of_light = [](const LightSource& light) { return diffuse_of(light); };
constexpr auto specular_of_light = [](const LightSource& light) { return specular_of(light); };

class DrawUniforms {
  public:
    DrawUniforms(const Draw& draw, const Plan& plan, const Code& code, const DrawProgram* like)
        : draw_(draw),
          plan_(plan),
          like_(like),
          effects_(code.effects),
          form_(code.form),
          lights_(code.lights),
          origin_object_(code.origin_object) {
        if (origin_object_) eye_from_object_ = glm::translate(draw.eye_from_object, *origin_object_);
    }

    Uniforms build(DrawProgram::OfState& of_state) {
        if (effects_.lighting) choose_coordinates();
        values_of_draw(effects_, form_).for_each([&](DrawValue value) {
            uniforms_.add(declaration_of(value).name);
            put(value);
        });
        textures();
        clip_planes();
        if (!effects_.lighting) return std::move(uniforms_);

        of_state = {.colors = uniforms_.size(), .lights = 0, .unit = unit_};
        const bool is_like = like_ && needs_same_of_lights(like_->code);
        if (is_like)
            uniforms_.append(like_->numbers, like_->of_state.colors, like_->of_state.lights);
        else
            colors();
        of_state.lights = uniforms_.size();
        if (is_like && has_lights_of_state(form_) && has_lights_of_state(like_->code.form) &&
            like_->of_state.unit == unit_)
            uniforms_.append(like_->numbers, like_->of_state.lights, like_->numbers.size());
        else
            lights();
        return std::move(uniforms_);
    }

  private:
    void colors() {
        values_of_model(effects_).for_each([&](ModelValue value) {
            uniforms_.add(declaration_of(value, effects_).name);
            put(value);
        });
        if (effects_.spectral_groups > 0) samples_of_lights();
        face("front", plan_.lighting.front, effects_.front);
        if (effects_.two_side) face("back", plan_.lighting.back, effects_.back);
    }

    void lights() {
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            light(i);
            if (loop_length(effects_, form_, i) == 0) continue;
            uniforms_.add(name_of_count(i));
            put(static_cast<double>(lights_[i].size()));
        }
    }
    bool needs_same_of_lights(const Code& other) const {
        if (lights_ != other.lights) return false;
        for (std::size_t i = 0; i < lights_.size(); ++i)
            if (values_of_light(effects_, form_, i) != values_of_light(other.effects, other.form, i)) return false;
        return true;
    }
    // Whether the lights' numbers follow from the state and the unit of length: the Draw's place and vertices do not matter.
    static bool has_lights_of_state(const Form& form) {
        return !form.object_space && !form.wide_range && !form.homogeneous;
    }

    // These append to the uniform that was added last: repeated, they give an array.
    void put(double value) { uniforms_.push_back(to_float(value)); }
    template <int kLength, class Number, glm::qualifier kQualifier>
    void put(const glm::vec<kLength, Number, kQualifier>& v) {
        for (int i = 0; i < kLength; ++i) put(v[i]);
    }
    template <int kColumns, int kRows, class Number, glm::qualifier kQualifier>
    void put(const glm::mat<kColumns, kRows, Number, kQualifier>& m) {
        for (int column = 0; column < kColumns; ++column) put(m[column]);
    }

    // Adds a uniform of the i-th light; put() follows, for each light that this one represents.
    void start_value(std::size_t i, LightValue value, std::string_view face = {}) {
        add_to(uniforms_, i, declaration_of(value, effects_, form_, i), face);
    }

    // The largest absolute value of each component of the uploaded positions.
    glm::dvec4 reach_object() const {
        const VertexFacts& facts = plan_.vertices;
        if (!origin_object_) return facts.position_reach;
        return facts.position_reach.w * glm::dvec4(glm::dvec3(facts.radius_object), 1);
    }

    // ---- Values of the whole Draw ----

    // The coordinates that the shader lights in, and their unit.
    void choose_coordinates() {
        if (form_.wide_range)
            wide_range();
        else if (form_.object_space)
            object_space();
        else
            eye_space();
        if (effects_.needs_normal() && !form_.object_space) normals();
    }

    void eye_space() {
        if (effects_.needs_position_eye())
            unit_ = form_.homogeneous ? unit_of_homogeneous(sizes_of(draw_, plan_), plan_)
                                      : eye_unit(eye_from_object_, reach_object(), plan_);
        lit_from_object_ = eye_from_object_;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) lit_from_object_[column][row] /= unit_;
        if (form_.homogeneous) {  // their scale does not matter
            const double scale = homogeneous_scale(reach_xyz(lit_from_object_, reach_object()),
                                                   reach_w(lit_from_object_, reach_object()));
            lit_from_object_ /= scale;
            unit_of_directions_ = unit_ * scale;
        }
    }

    void normals() {
        normals_ = normal_matrix_of(draw_, plan_);
        if (!form_.sized_normals) return;
        normal_unit_ = power_of_two(
            std::max({largest_component(normals_[0]), largest_component(normals_[1]), largest_component(normals_[2])}));
        normals_ /= normal_unit_;
    }

    // Brings the viewer and the lights to object coordinates.
    void object_space() {
        unit_ = similarity_scale(eye_from_object_);
        object_from_eye_ = glm::inverse(eye_from_object_);
    }

    void wide_range() {
        const glm::dvec4 reach = reach_object();
        const double longest = largest_component(glm::dvec3(reach));
        // x, y and z get a unit of their own beside a w that is much larger, so that their quotients need not be floats.
        constexpr double kMuchLarger = 0x1p20;
        const double unit_of_w = homogeneous_scale(longest, reach.w);
        const double unit_of_xyz =
            longest > 0 && longest * kMuchLarger < reach.w ? homogeneous_scale(0, longest) : unit_of_w;
        const Sizes sizes = sizes_of(draw_, plan_);
        unit_ = unit_of_homogeneous(sizes, plan_);
        // Directions stay floats, so that their difference does.
        constexpr double kMostDirection = 1e36;
        if (const double directions = sizes.directions / unit_of_w; directions > kMostDirection * unit_)
            unit_ = power_of_two(directions / kMostDirection);
        scale_of_xyz_ = unit_of_w / unit_of_xyz;
        unit_of_directions_ = unit_of_w * unit_ * eye_from_object_[3][3];  // keeping_w()
        object_scale_ = glm::dvec4(glm::dvec3(1 / unit_of_xyz), 1 / unit_of_w);
        if (effects_.local_viewer) viewer_ = nearest_vertex(draw_, glm::dvec3(0));
    }

    void put(DrawValue value) {
        const Fog& fog = draw_.fog;
        const PointParameters& points = draw_.raster.point_parameters;
        switch (value) {
            case DrawValue::kClipFromObject: {
                const glm::dmat4 clip_from_object = draw_.clip_from_eye * eye_from_object_;
                return put(clip_from_object / clip_scale(clip_from_object, reach_object()));
            }
            case DrawValue::kEyeFromObject: return put(lit_from_object_);
            case DrawValue::kEyeFromObjectNormal: return put(normals_);
            case DrawValue::kNormalScale: return;  // only for --precise, which has its own (precise.cpp)
            case DrawValue::kEyeFromObjectTurned:
                return put(glm::dmat3(keeping_w(eye_from_object_)) / scale_of_xyz_ / unit_);
            case DrawValue::kObjectScale: return put(object_scale_);
            case DrawValue::kNormalUnit: return put(normal_unit_);
            case DrawValue::kViewerObject: return put(point(glm::dvec3(0)));
            case DrawValue::kViewerNearObject: return put_near_vertex(viewer_);
            case DrawValue::kViewerWayEye: return put(viewer_.way_eye / unit_);
            case DrawValue::kViewerDirObject: return put(direction(glm::dvec3(0, 0, 1)));
            case DrawValue::kGeneratedEyeFromObject: return put(eye_from_object_ / unit_of_reach());
            case DrawValue::kGeneratedNormalFromObject: return put(generated_normals());
            case DrawValue::kPointEyeFromObject: {
                glm::dmat4 eye_from_object = eye_from_object_;
                for (int column = 0; column < 4; ++column)
                    for (int row = 0; row < 3; ++row) eye_from_object[column][row] /= unit_of_reach();
                return put(eye_from_object);
            }
            case DrawValue::kPointAttenuation: {
                const double unit = unit_of_reach();
                return put(points.distance_attenuation * glm::dvec3(1, unit, unit * unit));
            }
            case DrawValue::kPointSizes:
                return put(glm::dvec3(draw_.raster.point_size, points.size_min, points.size_max));
            case DrawValue::kEyeZFromObject: return put(glm::transpose(eye_from_object_)[2]);
            case DrawValue::kEyeWFromObject: return put(glm::transpose(eye_from_object_)[3]);
            case DrawValue::kFogColor: return put(rgb(fog.color));
            case DrawValue::kFogEnd: return put(fog.end);
            case DrawValue::kFogScale: {
                // RULING: linear fog with end = start is a step there.
                constexpr double kStep = 1e30;
                return put(fog.end == fog.start ? kStep : 1 / (fog.end - fog.start));
            }
            case DrawValue::kFogDensity: return put(fog.density);
        }
    }

    double unit_of_reach() const { return power_of_two(reach_xyz(eye_from_object_, reach_object())); }

    // For texture coordinates that are generated from the normal or the direction to the vertex, of all units.
    glm::dmat3 generated_normals() const {
        const glm::dmat3 normals = normal_matrix(glm::dmat3(draw_.eye_from_object));
        const double third = glm::length(normals[2]);  // of GL_RESCALE_NORMAL: see normal_matrix_of()
        if (effects_.generated_normal() == GeneratedNormal::kUnit)
            return normals / power_of_two(std::max({largest_component(normals[0]), largest_component(normals[1]),
                                                    largest_component(normals[2])}));
        return draw_.lighting.rescale_normal && third > 0 ? normals / third : normals;
    }

    // A vertex in the floats of the vertex array, so that nothing is left of its difference with itself. Its w is 1, or between 1
    // and 2 after a scale that rounds nothing.
    glm::dvec4 near_vertex(const NearestVertex& nearest) const {
        const glm::dvec3 origin = origin_object_.value_or(glm::dvec3(0));
        const glm::dvec4 p = nearest.vertex_object;
        glm::dvec4 uploaded = without_denormals(p - glm::dvec4(origin * p.w, 0));
        for (int i = 0; i < 4; ++i) uploaded[i] = to_float(uploaded[i]);
        uploaded /= power_of_two(std::abs(uploaded.w));
        return {scale_of_xyz_ * glm::dvec3(uploaded), uploaded.w};
    }
    // It is asked for more than once, and a mesh has many vertices.
    NearestVertex nearest_to(const LightSource& light, const glm::dvec3& place_eye) {
        const auto known = nearest_.find(&light);
        return known != nearest_.end() ? known->second
                                       : nearest_.emplace(&light, nearest_vertex(draw_, place_eye)).first->second;
    }
    void put_near_vertex(const NearestVertex& nearest) {
        const glm::dvec4 vertex = near_vertex(nearest);
        return form_.position_w ? put(vertex) : put(glm::dvec3(vertex));
    }

    // From eye coordinates to the coordinates that the shader lights in.
    glm::dvec3 point(const glm::dvec3& eye) const {
        return form_.object_space ? glm::dvec3(object_from_eye_ * glm::dvec4(eye, 1)) : eye / unit_;
    }
    glm::dvec3 direction(const glm::dvec3& eye) const {
        return form_.object_space ? unit(glm::dmat3(object_from_eye_) * eye) : eye;
    }

    // (plane * matrix) . position_object = plane . position_eye, so the shader needs no eye coordinates.
    void clip_planes() {
        int count = 0;
        for (const auto& plane_eye : draw_.raster.clip_planes_eye)
            if (plane_eye) {
                uniforms_.add(clip_plane_name(count++));
                put(*plane_eye * eye_from_object_);
            }
    }

    // ---- Textures ----

    void textures() {
        if (effects_.has_texture()) texture(effects_.texture, 0, draw_.texture, "");
        for (const UnitEffects& unit : effects_.units)
            draw_.for_each_unit([&](std::size_t number, const TextureUnit& state) {
                if (number == unit.number) texture(unit.texture, number, state, std::to_string(number));
            });
    }

    // `suffix`: of the unit's uniforms.
    void texture(const TextureEffects& effects, std::size_t number, const TextureUnit& unit, std::string_view suffix) {
        values_of_texture(effects, form_, number).for_each([&](TextureValue value) {
            if (value == TextureValue::kSampler) return;  // reads the unit of its number
            uniforms_.add(declaration_of(value).name, {suffix});
            put(value, unit);
        });
    }

    void put(TextureValue value, const TextureUnit& unit) {
        switch (value) {
            case TextureValue::kMatrix: return put(unit.texture_matrix);
            case TextureValue::kPlaneSObject: return put_plane(unit, 0);
            case TextureValue::kPlaneTObject: return put_plane(unit, 1);
            case TextureValue::kPlaneRObject: return put_plane(unit, 2);
            case TextureValue::kPlaneQObject: return put_plane(unit, 3);
            case TextureValue::kEnvColor: return put(unit.env_color);
            case TextureValue::kSampler:
            case TextureValue::kPlaneSEye:  // only in shaders to keep (webgl/kept_values.cpp)
            case TextureValue::kPlaneTEye:
            case TextureValue::kPlaneREye:
            case TextureValue::kPlaneQEye: return;
        }
    }

    // Of generated texture coordinates (2.11.4). (plane * matrix) . position_object = plane . position_eye.
    void put_plane(const TextureUnit& unit, int coordinate) {
        for (const GeneratedCoordinate& one : unit.generated) {
            if (one.coordinate != coordinate) continue;
            const glm::dvec4 plane = one.mode == kGL_EYE_LINEAR ? one.plane * draw_.eye_from_object : one.plane;
            const glm::dvec4 origin(origin_object_.value_or(glm::dvec3(0)), 1);
            put(glm::dvec4(glm::dvec3(plane), glm::dot(plane, origin)));
        }
    }

    // ---- Materials and lights ----

    void put(ModelValue value) {
        const LightColor ambient{plan_.constant_ambient, {}};
        switch (value) {
            case ModelValue::kConstantAmbient:
                return effects_.spectral_products ? put(product_matrix(model(), ambient)) : put(ambient.rgb);
            case ModelValue::kRgbFromSamples: return put_filled(weights(*model().spectrum), 9);
        }
    }

    // The weights from samples to red, green and blue.
    static std::vector<double> weights(const SpectralSamples& spectrum) {
        std::vector<double> weights;
        for (int s = 0; s < spectrum.count(); ++s) {
            const Vec3<double> w = spectrum.weight(static_cast<std::size_t>(s));
            for (const double channel : {w.x, w.y, w.z}) weights.push_back(channel);
        }
        return weights;
    }
    // The last group is filled with 0.
    void put_filled(std::vector<double> values, std::size_t numbers_per_group, double factor = 1) {
        values.resize(numbers_per_group * static_cast<std::size_t>(effects_.spectral_groups));
        for (const double value : values) put(factor * value);
    }

    // Visits the three colours of materials and lights: visit(value, the light's, the material's, what comes with each vertex).
    template <class Visit>
    static void for_each_color(const Material& material, const FaceEffects& varying, const Visit& visit) {
        const Material::Reflectances& reflectances = material.reflectances;
        visit(LightValue::kAmbient, ambient_of_light, MaterialColor{rgb(material.ambient), reflectances.ambient},
              ambient_of(varying));
        visit(LightValue::kDiffuse, diffuse_of_light, MaterialColor{rgb(material.diffuse), reflectances.diffuse},
              diffuse_of(varying));
        visit(LightValue::kSpecular, specular_of_light, MaterialColor{rgb(material.specular), reflectances.specular},
              specular_of(varying));
    }

    void samples_of_lights() {
        const LightValues needed = sampled_colors(effects_);
        for (std::size_t i = 0; i < lights_.size(); ++i)
            for_each_color({}, {}, [&](LightValue value, const auto& light_color_of, const auto&, PerVertexColor) {
                if (!needed.contains(value)) return;
                const std::size_t planned = lights_[i].front();
                uniforms_.add(name_of_light_samples(i, value));
                put_filled(samples_of(*model().spectrum, light_color_of(source(planned))), 3, reach_of(planned));
            });
    }

    // The colours of a face, and their products with the lights'.
    void face(std::string_view name, const Material& material, const FaceEffects& varying) {
        values_of_face(effects_, varying).for_each([&](FaceValue value) {
            add_to(uniforms_, name, value, effects_);
            put(value, material, varying);
        });
        const LightValues sampled = sampled_colors(effects_);
        for_each_color(material, varying,
                       [&](LightValue value, const auto&, const MaterialColor& color, PerVertexColor) {
                           if (!sampled.contains(value)) return;
                           uniforms_.add(name_of_face_samples(name, value));
                           put_filled(samples_of(*model().spectrum, color), 3);
                       });
        for (std::size_t i = 0; effects_.spectral_groups == 0 && i < lights_.size(); ++i) {
            const LightValues needed = values_of_light(effects_, form_, i);
            for_each_color(material, varying,
                           [&](LightValue value, const auto& light_color_of, const MaterialColor& color,
                               PerVertexColor per_vertex) {
                               if (!needed.contains(value)) return;
                               start_value(i, value, name);
                               for (const std::size_t planned : lights_[i]) {
                                   const LightColor light_color = light_color_of(source(planned));
                                   const double reach = reach_of(planned);
                                   if (!per_vertex)
                                       put(reach * product_of(model(), light_color, color));
                                   else if (effects_.spectral_products)
                                       put(reach * product_matrix(model(), light_color));
                                   else
                                       put(reach * light_color.rgb);
                               }
                           });
        }
    }

    void put(FaceValue value, const Material& material, const FaceEffects& varying) {
        switch (value) {
            case FaceValue::kBase: {  // without the parts that come with each vertex
                glm::dvec3 base(0);
                if (!emission_of(varying)) base += rgb(material.emission);
                if (!ambient_of(varying))
                    base += product_of(model(), {plan_.constant_ambient, {}},
                                       {rgb(material.ambient), material.reflectances.ambient});
                return put(base);
            }
            case FaceValue::kAlpha: return put(material.diffuse.a);
            case FaceValue::kShininess: return put(normal_exponent(material.shininess));
        }
    }

    void light(std::size_t i) {
        values_of_light(effects_, form_, i).for_each([&](LightValue value) {
            if (is_color(value)) return;  // face() has them
            start_value(i, value);
            for (const std::size_t planned : lights_[i]) put(value, source(planned));
        });
    }

    void put(LightValue value, const LightSource& light) {
        const auto vp_dir = [&] { return unit(rgb(light.position_eye)); };
        switch (value) {
            case LightValue::kDirection: return put(direction(vp_dir()));
            case LightValue::kHalfDir: return put(direction(unit(vp_dir() + glm::dvec3(0, 0, 1))));
            case LightValue::kToward: return put(toward(light));
            case LightValue::kPosition: return put(placed(light).place);
            case LightValue::kNearVertex: return put_near_vertex(placed(light).nearest);
            case LightValue::kWay: return put(placed(light).nearest.way_eye);
            case LightValue::kAttenuation: return put(attenuation(light));
            case LightValue::kSpotDir: return put(direction(unit(light.spot_direction_eye)));
            case LightValue::kCosCutoff: return put(cos_deg(light.spot_cutoff_deg) - kCosineRounding);
            case LightValue::kSpotExponent: return put(normal_exponent(light.spot_exponent));
            case LightValue::kCosOuter: return put(smooth_cone_values(light).cos_outer);
            case LightValue::kConeSlope: return put(smooth_cone_values(light).slope);
            case LightValue::kAmbient:
            case LightValue::kDiffuse:
            case LightValue::kSpecular: return;  // depend on the face
        }
    }

    glm::dvec3 toward(const LightSource& light) const {
        // It stays a normal float: vertices with another w need its direction.
        constexpr double kLeast = 1e-36;
        const glm::dvec3 toward = rgb(light.position_eye) / unit_of_directions_;
        const double size = largest_component(toward);
        return size > 0 ? toward * (std::clamp(size, kLeast, kMostDistant) / size) : toward;
    }

    // A place that floats cannot hold comes nearer, in the same direction; then its distance has another unit.
    struct Placed {
        glm::dvec3 place;
        NearestVertex nearest{};
        double length_unit = 1;
    };
    Placed placed(const LightSource& light) {
        if (light.is_directional())  // only "toward" counts
            return Placed{.place = glm::dvec3(0), .nearest = {}, .length_unit = unit_};
        const glm::dvec3 eye = rgb(light.position_eye) / light.position_eye.w;
        Placed result{.place = point(eye), .nearest = {}, .length_unit = unit_};
        if (form_.wide_range) result.nearest = nearest_to(light, eye);
        glm::dvec3& far = form_.wide_range ? result.nearest.way_eye : result.place;
        if (form_.wide_range) far /= unit_;
        const double largest = largest_component(far);
        if (largest > kMostDistant) {
            result.length_unit *= largest / kMostDistant;
            far *= kMostDistant / largest;
        }
        return result;
    }

    glm::dvec3 attenuation(const LightSource& light) {
        const double length_unit = placed(light).length_unit;
        // In the unit of a tiny scene a factor may vanish. Infinitely far from the light it still counts.
        constexpr double kLeast = 1e-36;
        const auto in_unit = [&](double k, double factor) {
            return k > 0 && factor < 1 ? std::max(k * factor, kLeast) : k * factor;
        };
        return attenuation_scale(light) * glm::dvec3(light.constant_attenuation,
                                                     in_unit(light.linear_attenuation, length_unit),
                                                     in_unit(light.quadratic_attenuation, length_unit * length_unit));
    }

    // The processor may take denormal floats for 0, so the factors and the light's colours become larger together.
    static double attenuation_scale(const LightSource& light) {
        const auto is_denormal = [](double k) { return k > 0 && k < std::numeric_limits<float>::min(); };
        const bool has_denormal = is_denormal(light.constant_attenuation) || is_denormal(light.linear_attenuation) ||
                                  is_denormal(light.quadratic_attenuation);
        return has_denormal ? 0x1p60 : 1;
    }
    // What the shader multiplies a light's colours by, at every vertex.
    double reach_of(std::size_t planned) const {
        const auto& lights = plan_.effects.lights;
        const bool attenuated = lights[planned].attenuated;
        return plan_.lights[planned].constant_reach * (attenuated ? attenuation_scale(source(planned)) : 1);
    }

    const LightModel& model() const { return plan_.lighting.light_model; }
    const LightSource& source(std::size_t planned) const {
        return plan_.lighting.lights[static_cast<std::size_t>(plan_.lights[planned].number)];
    }

    const Draw& draw_;
    const Plan& plan_;
    const DrawProgram* const like_;
    const EffectSet& effects_;
    const Form& form_;
    const std::vector<std::vector<std::size_t>>& lights_;
    const std::optional<glm::dvec3> origin_object_;
    glm::dmat4 eye_from_object_ = draw_.eye_from_object;  // from positions relative to origin_object_
    double unit_of_directions_ = 1;                       // the shader's unit of vertices with w = 0
    double scale_of_xyz_ = 1;        // of form_.wide_range: what the shader multiplies object coordinates by
    double unit_ = 1;                // the shader's unit of length, in eye coordinates
    glm::dmat4 lit_from_object_{1};  // to the coordinates that the shader lights in, if these are eye coordinates
    glm::dmat4 object_from_eye_{1};  // used if form_.object_space
    glm::dmat3 normals_{1};          // for normals, if the shader lights in eye coordinates
    double normal_unit_ = 1;         // what normals_ was divided by
    glm::dvec4 object_scale_{1};     // used if form_.wide_range
    NearestVertex viewer_{};         // the same
    std::map<const LightSource*, NearestVertex> nearest_;  // used if form_.wide_range
    Uniforms uniforms_;
};

}  // namespace

// RULING: if the inner angle equals the outer one (or is wider), the cone is a step at the outer angle, which belongs
// to the cone: a very steep slope just outside it.
SmoothConeValues smooth_cone_values(const LightSource& light) {
    const double outer = cos_deg(light.smooth_cone->outer_deg);
    const double span = cos_deg(light.smooth_cone->inner_deg) - outer;
    if (span > 0) return {.cos_outer = outer, .slope = 1 / span};
    return {.cos_outer = outer - 2 * kCosineRounding, .slope = 1 / kCosineRounding};
}

DrawProgram draw_program(const Draw& draw, const Plan& plan, bool precise, const DrawProgram* like) {
    if (precise && floats_suffice(draw, plan)) {
        Code code = precise_code(draw, plan);
        Uniforms numbers = precise_uniforms(draw, plan, code);
        return {std::move(code), std::move(numbers)};
    }
    DrawProgram program{.code = code_for(draw, plan), .numbers = {}};
    program.numbers = DrawUniforms(draw, plan, program.code, like).build(program.of_state);
    return program;
}

Uniforms uniforms(const Draw& draw, const Plan& plan, const Code& code) {
    DrawProgram::OfState of_state;
    return DrawUniforms(draw, plan, code, nullptr).build(of_state);
}

std::vector<float> vertex_array(const Draw& draw, const EffectSet& effects, const std::vector<std::uint32_t>& vertices,
                                const glm::dvec3& origin_object) {
    const bool normals_made_unit = makes_normals_unit(effects);
    const std::vector<VertexProperty> properties = vertex_properties(effects);
    std::vector<std::pair<const std::vector<glm::dvec4>*, int>> further;
    for (const VertexAttribute attribute : further_attributes(effects))
        further.emplace_back(draw.column(attribute), row_of(attribute).size);
    std::size_t floats_per_vertex = 0;
    for (const Attribute& attribute : attributes(effects))
        floats_per_vertex += static_cast<std::size_t>(attribute.size);
    std::vector<float> values((vertices.empty() ? draw.vertices.size() : vertices.size()) * floats_per_vertex);
    float* next = values.data();
    const auto add = [&next](const auto& v, int size) {
        for (int i = 0; i < size; ++i) *next++ = to_float(v[i]);
    };
    const bool is_normal_taken = effects.takes_normal(), is_color_taken = effects.needs_color(),
               is_tex_coord_taken = effects.takes_tex_coord();
    for_each_vertex(draw, vertices, [&](const Vertex& vertex) {
        const glm::dvec4& position = vertex.position_object;
        const glm::dvec4 from_origin = position - glm::dvec4(origin_object * position.w, 0);
        add(position.w == 1 ? from_origin : without_denormals(from_origin), 4);
        if (is_normal_taken) {
            const double size = largest_component(vertex.normal_object);
            const bool rescaled = normals_made_unit && !needs_no_unit(size);
            add(rescaled ? vertex.normal_object / power_of_two(size) : vertex.normal_object, 3);
            *next++ = 0;
        }
        if (is_color_taken) add(vertex.color, 4);
        if (is_tex_coord_taken) add(vertex.tex_coord, 4);
        const auto number = static_cast<std::size_t>(&vertex - draw.vertices.data());
        for (const auto& [column, size] : further) add(column ? (*column)[number] : vertex.tex_coord, size);
        if (effects.at_pixels)
            add(glm::dvec3((glm::dvec2(draw.pixels->places.at(number)) + 0.5) / (kMostWindowPixels / 2.0),
                           2 * draw.pixels->depth(number)) -
                    1.0,
                3);
        for (const VertexProperty& property : properties) {
            const Material& material = draw.materials.at(vertex.material).*property.face;
            if (property.color)
                add(material.*property.color, property.size);
            else
                *next++ = to_float(normal_exponent(material.shininess));
        }
    });
    return values;
}

}  // namespace twinlight::programmable
