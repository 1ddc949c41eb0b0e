#include "reference/shading.h"

#include <cmath>

#include "math/srgb.h"
#include "reference/fog.h"
#include "reference/texture_bounds.h"
#include "reference/texture_environment.h"
#include "reference/texture_place.h"

namespace twinlight::reference {

namespace {

Shading shading_of(const Draw& draw, const RenderOptions& options) {
    if (options.shading) return *options.shading;
    return draw.lighting.shade_model == kGL_FLAT ? Shading::kFlat : Shading::kGouraud;
}

// `#pragma twinlight transfer(srgb)`: what is linear light up to here is coded as the display takes it; alpha is no light.
double coded(double linear) { return srgb_coded(linear); }
Interval coded(Interval linear) { return {srgb_coded(linear.low), srgb_coded(linear.high)}; }

}  // namespace

Shader::Shader(const StagedDraw& staged, const RenderOptions& options)
    : draw_(*staged.draw),
      vertices_(staged.vertices),
      shading_(shading_of(*staged.draw, options)),
      lighting_(*staged.draw, options.lecture_variants),
      srgb_coded_(options.lecture_variants && staged.draw->fragment.srgb_coded) {
    if (!lights_pixels()) lit_ = light_vertices(draw_, options, true);
}

glm::dvec4 Shader::color(const Piece& piece, const glm::dvec2& position_window) const {
    if (piece.rays) return exact_color(piece, position_window);
    const LitColors colors = lit(piece, position_window);
    const double fog = draw_.fog.enabled ? fog_at(piece, position_window) : 1;
    if (!draw_.texture.texture) return color_of(finished<double>(colors, nullptr, fog));
    const Channels<double> texel = channels<double>(sampled(texture_place(vertices_, piece, position_window)));
    return color_of(finished(colors, &texel, fog));
}

glm::dvec4 Shader::exact_color(const Piece& piece, const glm::dvec2& position_window) const {
    const SurfacePoint point = piece.rays->point(position_window, piece.point).value();
    const glm::dvec4& eye = point.vertex.position_eye;
    const double fog = draw_.fog.enabled ? fog_factor(draw_.fog, std::abs(quotient(eye.z, eye.w))) : 1;
    if (!draw_.texture.texture) return color_of(finished<double>(exact(point), nullptr, fog));
    const Channels<double> texel = channels<double>(sampled(point.place));
    return color_of(finished(exact(point), &texel, fog));
}

glm::dvec4 Shader::sampled(const TexturePlace& place) const {
    const TextureUnit& unit = draw_.texture;
    return sample(*unit.texture, place.st, level_of_detail(scale_factor(*unit.texture, place), unit.lod_bias));
}

FragmentBounds Shader::bounds(const Piece& piece, const glm::dvec2& position_window) const {
    const LitColors colors = lit(piece, position_window);
    const Interval fog = draw_.fog.enabled ? fog_at(piece, position_window) : 1;
    const TextureUnit& unit = draw_.texture;
    if (!unit.texture) return {finished<Interval>(colors, nullptr, fog), false};
    const TexturePlaceBounds place = texture_place_bounds(vertices_, piece, position_window, *unit.texture);
    const TexelBounds texel = sample_bounds(unit, place.st, place.st_error, place.rho);
    return {finished(colors, &texel.texel, fog), texel.has_choice};
}

// 3.9: after texturing the secondary colour is added to the primary one; the alpha is the primary one's. The clamp to
// [0,1] is for the sum; both colours were clamped before.
template <class Real>
Channels<Real> Shader::finished(const LitColors& colors, const Channels<Real>* texel, Real fog) const {
    Channels<Real> result = channels<Real>(colors.primary);
    if (texel) result = textured(draw_.texture, draw_.texture.texture->levels[0].base_format, result, *texel);
    for (int i = 0; i < 3; ++i) result[i] = result[i] + Real(colors.secondary[i]);
    for (Real& channel : result) channel = clamp01(channel);
    if (draw_.fog.enabled) result = fogged(draw_.fog, fog, result);
    if (srgb_coded_)
        for (int i = 0; i < 3; ++i) result[i] = coded(result[i]);
    return result;
}

Shader::LitColors Shader::lit(const Piece& piece, const glm::dvec2& position_window) const {
    if (shading_ == Shading::kFlat) return flat(piece);
    const glm::dvec3 weights = weights_at(piece, position_window);
    return lights_pixels() ? phong(piece, weights) : gouraud(piece, weights);
}

// 2.14.7: one colour for the whole primitive.
Shader::LitColors Shader::flat(const Piece& piece) const {
    const LitVertex& v = lit_[piece.primitive.provoking];
    if (piece.face == Face::kFront) return {v.front_primary, v.front_secondary};
    return {v.back_primary, v.back_secondary};
}

Shader::LitColors Shader::gouraud(const Piece& piece, const glm::dvec3& weights) const {
    LitColors sum;
    for (int i = 0; i < 3; ++i) {
        const LitVertex& v = lit_[piece.primitive.vertices[i]];
        const bool front = piece.face == Face::kFront;
        sum.primary += weights[i] * (front ? v.front_primary : v.back_primary);
        sum.secondary += weights[i] * (front ? v.front_secondary : v.back_secondary);
    }
    return sum;
}

// RULING (not GL's): the interpolated normal is made a unit vector; the material is interpolated as colours are, what of
// it tracks the current colour with that colour; the clamp of 2.14.6 is the pixel's.
Shader::LitColors Shader::phong(const Piece& piece, const glm::dvec3& weights) const {
    const Face face = lighting_.two_side() ? piece.face : Face::kFront;
    StageVertex pixel;
    std::array<LitMaterial, 3> materials;
    for (int i = 0; i < 3; ++i) {
        const StageVertex& v = vertices_[piece.primitive.vertices[i]];
        pixel.position_eye += weights[i] * v.position_eye;
        pixel.normal_eye += weights[i] * v.normal_eye;
        pixel.color += weights[i] * v.color;
        if (lighting_.has_vertex_materials()) materials[i] = lighting_.material(v, face);
    }
    const LitMaterial material =
        lighting_.has_vertex_materials() ? mixed(weights, materials) : lighting_.material(pixel, face);
    const Vec normal_dir = lighting::unit(vec3_cast<Vec>(pixel.normal_eye));
    const Colors colors = lighting_.lit(pixel.position_eye, vec3_cast<glm::dvec3>(normal_dir), material, face);
    return {clamped(colors.primary), clamped(colors.secondary)};
}

// A point of a surface is lit as a vertex is; the clamp is the pixel's.
Shader::LitColors Shader::exact(const SurfacePoint& point) const {
    const Colors colors = lighting_.colors(point.vertex, lighting_.two_side() ? point.face : Face::kFront);
    return {clamped(colors.primary), clamped(colors.secondary)};
}

double Shader::fog_at(const Piece& piece, const glm::dvec2& position_window) const {
    const glm::dvec3 weights = weights_at(piece, position_window);
    double z = 0, w = 0;
    for (int i = 0; i < 3; ++i) {
        const StageVertex& v = vertices_[piece.primitive.vertices[i]];
        z += weights[i] * v.position_eye.z;
        w += weights[i] * v.position_eye.w;
    }
    return fog_factor(draw_.fog, std::abs(quotient(z, w)));
}

}  // namespace twinlight::reference
