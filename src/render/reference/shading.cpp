#include "render/reference/shading.h"

#include <algorithm>
#include <cmath>

#include "base/math/srgb.h"
#include "render/reference/fog.h"
#include "render/reference/texture_bounds.h"
#include "render/reference/texture_environment.h"
#include "render/reference/texture_place.h"

namespace twinlight::reference {

using lighting::Marked;

namespace {

Shading shading_of(const Draw& draw, const Options& options) {
    if (options.shading) return *options.shading;
    return draw.lighting.shade_model == kGL_FLAT ? Shading::kFlat : Shading::kGouraud;
}

// `#pragma twinlight transfer(srgb)`: what is linear light up to here is coded as the display takes it; alpha is no light.
double coded(double linear) { return srgb_coded(linear); }
Interval coded(Interval linear) { return {srgb_coded(linear.low), srgb_coded(linear.high)}; }
Marked coded(Marked linear) { return {srgb_coded(linear.value), linear.rulings}; }

}  // namespace

Shader::LitColors Shader::clamped_colors(const Colors& colors) {
    return {clamped(colors.primary), clamped(colors.secondary)};
}

Shader::Shader(const StagedDraw& staged, const Options& options)
    : draw_(*staged.draw),
      vertices_(staged.vertices),
      shading_(shading_of(*staged.draw, options)),
      lighting_(*staged.draw, options.lecture_variants),
      srgb_coded_(options.lecture_variants && staged.draw->fragment.srgb_coded),
      arithmetic_(options.arithmetic) {
    if (!lights_pixels()) light_vertices();
}

// 2.14.6: colours are clamped before they are interpolated.
void Shader::light_vertices() {
    lit_.resize(vertices_.size());
    const auto light = [&](Face face, LitColors LitFaces::*place) {
        if (!lighting_.enabled()) {
            for (std::size_t i = 0; i < vertices_.size(); ++i)
                lit_[i].*place = clamped_colors(lighting_.colors(vertices_[i], face));
            return;
        }
        PointBatch batch(lighting_, PointBatch::Normals::kAsTheyAre);
        for (const StageVertex& v : vertices_) batch.add(v, face, [&] { return lighting_.material(v, face); });
        batch.light(arithmetic_, [&](std::size_t i, const glm::dvec4& primary, const glm::dvec4& secondary) {
            lit_[i].*place = {clamped(primary), clamped(secondary)};
        });
    };
    light(Face::kFront, &LitFaces::front);
    if (lighting_.two_side())
        light(Face::kBack, &LitFaces::back);
    else
        for (LitFaces& vertex : lit_) vertex.back = vertex.front;
}

glm::dvec4 Shader::color(const Piece& piece, const glm::dvec2& position_window) const {
    const Fragment fragment{&piece, position_window};
    if (lights_pixels(piece)) {
        const LitPlace place = lit_place(fragment);
        return finished(lit(fragment, place), place.finish);
    }
    const LitColors colors = vertex_colors(piece, position_window);
    const double fog = draw_.fog.enabled ? fog_at(piece, position_window) : 1;
    if (!draw_.texture.texture) return color_of(finished<double>(colors, nullptr, fog));
    const Channels<double> texel = channels<double>(sampled(texture_place(vertices_, piece, position_window)));
    return color_of(finished(colors, &texel, fog));
}

std::vector<glm::dvec4> Shader::colors(const std::vector<Fragment>& fragments) const {
    std::vector<glm::dvec4> result(fragments.size());
    if (fragments.empty() || !lights_pixels()) {
        for (std::size_t i = 0; i < fragments.size(); ++i)
            result[i] = color(*fragments[i].piece, fragments[i].position_window);
        return result;
    }
    const bool is_exact = fragments.front().piece->rays != nullptr;  // all of a Draw are, or none
    PointBatch batch(lighting_, is_exact ? PointBatch::Normals::kAsTheyAre : PointBatch::Normals::kMadeUnit);
    const std::span all(fragments);
    for (std::size_t first = 0; first < all.size(); first += PointBatch::kPoints) {
        light_together(batch, all.subspan(first, std::min(PointBatch::kPoints, all.size() - first)),
                       result.data() + first);
        batch.clear();
    }
    return result;
}

void Shader::light_together(PointBatch& batch, std::span<const Fragment> fragments, glm::dvec4* colors) const {
    std::vector<Finish> finishes;
    finishes.reserve(fragments.size());
    for (const Fragment& fragment : fragments) {
        const LitPlace place = lit_place(fragment);
        batch.add(place.vertex, place.face, [&] { return material(fragment, place); });
        finishes.push_back(place.finish);
    }
    batch.light(arithmetic_, [&](std::size_t i, const glm::dvec4& primary, const glm::dvec4& secondary) {
        colors[i] = finished({clamped(primary), clamped(secondary)}, finishes[i]);
    });
}

glm::dvec4 Shader::finished(const LitColors& colors, const Finish& finish) const {
    return color_of(finished(colors, finish.texel ? &*finish.texel : nullptr, finish.fog));
}

glm::dvec4 Shader::sampled(const TexturePlace& place) const {
    const TextureUnit& unit = draw_.texture;
    return sample(*unit.texture, place.st, level_of_detail(scale_factor(*unit.texture, place), unit.lod_bias));
}

Channels<Marked> Shader::marked_color(const Piece& piece, const glm::dvec2& position_window, const MarkedColors& lit,
                                      lighting::RulingSet position) const {
    const LitPlace place = lit_place({&piece, position_window});
    const glm::dvec4& eye = place.vertex.position_eye;
    const Marked fog =
        draw_.fog.enabled ? fog_factor(draw_.fog, abs(quotient(Marked(eye.z, position), Marked(eye.w)))) : 1;
    if (!place.finish.texel) return finished<Marked>(lit, nullptr, fog);
    const lighting::RulingSet rulings =
        piece.rays ? lighting::RulingSet{} : texture_rulings(vertices_, piece, position_window);
    Channels<Marked> texel{};
    for (std::size_t i = 0; i < texel.size(); ++i) texel[i] = {(*place.finish.texel)[i], rulings};
    return finished<Marked>(lit, &texel, fog);
}

FragmentBounds Shader::bounds(const Piece& piece, const glm::dvec2& position_window) const {
    const LitColors colors = lights_pixels(piece) ? lit({&piece, position_window}, lit_place({&piece, position_window}))
                                                  : vertex_colors(piece, position_window);
    const Interval fog = draw_.fog.enabled ? fog_at(piece, position_window) : 1;
    const TextureUnit& unit = draw_.texture;
    if (!unit.texture) return {finished<Interval>(colors, nullptr, fog), false};
    const TexturePlaceBounds place = texture_place_bounds(vertices_, piece, position_window, *unit.texture);
    const TexelBounds texel = sample_bounds(unit, place.st, place.st_error, place.rho);
    return {finished(colors, &texel.texel, fog), texel.has_choice};
}

// 3.9: after texturing the secondary colour is added to the primary one; the alpha is the primary one's. The clamp to
// [0,1] is for the sum; both colours were clamped before.
template <class Real, class Colors>
Channels<Real> Shader::finished(const Colors& colors, const Channels<Real>* texel, Real fog) const {
    Channels<Real> result;
    for (int i = 0; i < 4; ++i) result[i] = Real(colors.primary[i]);
    if (texel) result = textured(draw_.texture, draw_.texture.texture->levels[0].base_format, result, *texel);
    for (int i = 0; i < 3; ++i) result[i] = result[i] + Real(colors.secondary[i]);
    for (Real& channel : result) channel = clamp01(channel);
    if (draw_.fog.enabled) result = fogged(draw_.fog, fog, result);
    if (srgb_coded_)
        for (int i = 0; i < 3; ++i) result[i] = coded(result[i]);
    return result;
}

// Flat (2.14.7): one colour for the whole primitive. Gouraud: between those of the vertices.
Shader::LitColors Shader::vertex_colors(const Piece& piece, const glm::dvec2& position_window) const {
    const auto of_vertex = [&](std::uint32_t number) -> const LitColors& {
        return piece.face == Face::kFront ? lit_[number].front : lit_[number].back;
    };
    if (shading_ == Shading::kFlat) return of_vertex(piece.primitive.provoking);
    const glm::dvec3 weights = weights_at(piece, position_window);
    LitColors sum;
    for (int i = 0; i < 3; ++i) {
        const LitColors& v = of_vertex(piece.primitive.vertices[i]);
        sum.primary += weights[i] * v.primary;
        sum.secondary += weights[i] * v.secondary;
    }
    return sum;
}

// A point of a surface is a vertex of its own; of a mesh, what lies between its vertices.
Shader::LitPlace Shader::lit_place(const Fragment& fragment) const {
    const Piece& piece = *fragment.piece;
    LitPlace place;
    std::optional<TexturePlace> texture;
    if (piece.rays) {
        const SurfacePoint point = piece.rays->point(fragment.position_window, piece.point).value();
        place.vertex = point.vertex;
        if (lighting_.two_side()) place.face = point.face;
        texture = point.place;
    } else {
        const glm::dvec3 weights = weights_at(piece, fragment.position_window);
        for (int i = 0; i < 3; ++i) {
            const StageVertex& v = vertices_[piece.primitive.vertices[i]];
            place.vertex.position_eye += weights[i] * v.position_eye;
            place.vertex.normal_eye += weights[i] * v.normal_eye;
            place.vertex.color += weights[i] * v.color;
        }
        if (lighting_.two_side()) place.face = piece.face;
        if (draw_.texture.texture) texture = texture_place(vertices_, piece, fragment.position_window);
    }
    const glm::dvec4& eye = place.vertex.position_eye;
    if (draw_.fog.enabled) place.finish.fog = fog_factor(draw_.fog, std::abs(quotient(eye.z, eye.w)));
    if (draw_.texture.texture) place.finish.texel = channels<double>(sampled(*texture));
    return place;
}

// RULING (not GL's): the material is interpolated as colours are, what of it tracks the current colour with that colour.
LitMaterial Shader::material(const Fragment& fragment, const LitPlace& place) const {
    const Piece& piece = *fragment.piece;
    if (piece.rays || !lighting_.has_vertex_materials()) return lighting_.material(place.vertex, place.face);
    std::array<LitMaterial, 3> materials;
    for (int i = 0; i < 3; ++i) materials[i] = lighting_.material(vertices_[piece.primitive.vertices[i]], place.face);
    return mixed(weights_at(piece, fragment.position_window), materials);
}

// RULING (not GL's): the interpolated normal is made a unit vector; the clamp of 2.14.6 is the pixel's.
Shader::LitColors Shader::lit(const Fragment& fragment, const LitPlace& place) const {
    const StageVertex& v = place.vertex;
    if (!lighting_.enabled()) return clamped_colors(lighting_.colors(v, place.face));
    const glm::dvec3 normal_eye =
        fragment.piece->rays ? v.normal_eye : vec3_cast<glm::dvec3>(lighting::unit(vec3_cast<Vec>(v.normal_eye)));
    return clamped_colors(lighting_.lit(v.position_eye, normal_eye, material(fragment, place), place.face));
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
