#include "render/reference/shading.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/math/srgb.h"
#include "render/reference/geometry/texture_place.h"
#include "render/reference/textures/texture_bounds.h"
#include "render/reference/textures/texture_environment.h"
#include "render/reference/vertices/tex_gen.h"

namespace twinlight::reference {

using lighting::Marked;

namespace {

Shading shading_of(const Draw& draw, const Options& options) {
    if (options.shading) return *options.shading;
    return draw.lighting.shade_model == kGL_FLAT ? Shading::kFlat : Shading::kGouraud;
}

// `#pragma twinlight transfer(srgb)`: encodes a linear colour for the display as sRGB. Alpha is not light and is not
// encoded.
double coded(double linear) { return srgb_coded(linear); }
Interval coded(Interval linear) { return {srgb_coded(linear.low), srgb_coded(linear.high)}; }
Marked coded(Marked linear) { return {srgb_coded(linear.value), linear.rulings}; }

// Casts a surface's ray only once per fragment.
template <class Visit>
auto with_point(const Fragment& fragment, const Visit& visit) {
    const Piece& piece = *fragment.piece;
    if (!piece.rays || fragment.point) return visit(fragment);
    const RayPoint point = piece.rays->point(fragment.position_window, piece.point).value();
    return visit(Fragment{&piece, fragment.position_window, &point});
}

}  // namespace

Shader::LitColors Shader::clamped_colors(const Colors& colors) {
    return {clamped(colors.primary), clamped(colors.secondary)};
}

Shader::Shader(const StagedDraw& staged, const Options& options, const CopyRanges* ranges)
    : draw_(*staged.draw),
      vertices_(staged.vertices),
      copied_(CopyRanges::of(ranges, draw_.pixels)),
      units_(units(staged, ranges)),
      combines_textures_(staged.draw->combines_textures()),
      shading_(shading_of(*staged.draw, options)),
      lighting_(*staged.draw, options.lecture_variants),
      srgb_coded_(options.lecture_variants && staged.draw->fragment.srgb_coded),
      arithmetic_(options.arithmetic),
      place_errors_{.snap = options.snap, .approximates_rho = options.approximates_rho} {
    if (!lights_pixels()) light_vertices();
}

std::vector<Shader::Unit> Shader::units(const StagedDraw& staged, const CopyRanges* ranges) const {
    std::vector<Unit> units;
    const auto sprite_origin = [&](const TextureUnit& unit) {
        return unit.coord_replace ? std::optional(draw_.raster.point_parameters.sprite_coord_origin) : std::nullopt;
    };
    const auto add = [&](std::size_t number, const TextureUnit& unit, const std::vector<glm::dvec4>* further) {
        units.push_back(
            {number, &unit, CopyRanges::of(ranges, unit.texture), TexCoords(vertices_, sprite_origin(unit), further)});
    };
    if (draw_.texture.texture) add(0, draw_.texture, nullptr);
    for (std::size_t i = 0; i < draw_.further_units.size(); ++i) {
        const FurtherUnit& further = draw_.further_units[i];
        add(further.number, further.unit, &staged.further_tex_coords[i]);
    }
    return units;
}

// 2.14.6: colours are clamped before they are interpolated.
void Shader::light_vertices() {
    const std::span<const StageVertex> vertices = vertices_.kept();
    const auto light = [&](Face face, std::vector<LitColors>& lit) {
        lit.reserve(vertices.size());
        if (!lighting_.enabled()) {
            const std::vector<glm::dvec4>* secondary_colors = draw_.column(VertexAttribute::kSecondaryColor);
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                lit.push_back(clamped_colors(lighting_.colors(vertices[i], face)));
                // 3.9: GL_COLOR_SUM.
                if (secondary_colors)
                    lit.back().secondary =
                        glm::dvec4(glm::clamp(glm::dvec3((*secondary_colors)[vertices_.number(i)]), 0.0, 1.0), 1);
            }
            return;
        }
        PointBatch batch(lighting_, PointBatch::Normals::kAsTheyAre);
        for (std::size_t first = 0; first < vertices.size(); first += PointBatch::kPoints) {
            batch.clear();
            const std::size_t end = std::min(first + PointBatch::kPoints, vertices.size());
            for (std::size_t i = first; i < end; ++i)
                batch.add(vertices[i], face, [&] { return lighting_.material(vertices[i], face); });
            batch.light(arithmetic_, [&](std::size_t, const glm::dvec4& primary, const glm::dvec4& secondary) {
                lit.push_back({clamped(primary), clamped(secondary)});
            });
        }
    };
    light(Face::kFront, lit_front_);
    if (lighting_.two_side()) light(Face::kBack, lit_back_);
}

template <class Real>
Shaded<Real> Shader::shade(const Fragment& fragment) const {
    return with_point(fragment, [&](const Fragment& whole) -> Shaded<Real> {
        const Finish<Real> finish = this->finish<Real>(whole);
        if constexpr (std::is_same_v<Real, Interval>) {
            if (copies_colors()) return {finished(copied_colors(*whole.piece), finish), finish.has_choice};
            if (const auto ranges = colors_beside_cones(whole)) return {finished(*ranges, finish), finish.has_choice};
        }
        const LitColors colors = lights_pixels(*whole.piece) ? lit(whole) : vertex_colors(whole);
        return {finished(colors, finish), finish.has_choice};
    });
}
template Shaded<double> Shader::shade(const Fragment& fragment) const;
template Shaded<Interval> Shader::shade(const Fragment& fragment) const;

std::vector<Channels<double>> Shader::colors(std::span<const Fragment> fragments) const {
    std::vector<Channels<double>> result(fragments.size());
    if (fragments.empty() || !lights_pixels()) {
        for (std::size_t i = 0; i < fragments.size(); ++i) result[i] = shade<double>(fragments[i]).color;
        return result;
    }
    const bool is_exact = fragments.front().piece->rays != nullptr;  // the same for all fragments of a Draw
    PointBatch batch(lighting_, is_exact ? PointBatch::Normals::kAsTheyAre : PointBatch::Normals::kMadeUnit);
    std::vector<Finish<double>> finishes;
    for (std::size_t first = 0; first < fragments.size(); first += finishes.size()) {
        batch.clear();
        finishes.clear();
        for (const Fragment& fragment :
             fragments.subspan(first, std::min(PointBatch::kPoints, fragments.size() - first)))
            with_point(fragment, [&](const Fragment& whole) {
                const LitPlace place = lit_place(whole);
                batch.add(place.vertex, place.face, [&] { return material(whole, place); });
                finishes.push_back(finish<double>(whole));
            });
        batch.light(arithmetic_, [&](std::size_t i, const glm::dvec4& primary, const glm::dvec4& secondary) {
            result[first + i] = finished(LitColors{clamped(primary), clamped(secondary)}, finishes[i]);
        });
    }
    return result;
}

std::vector<PointOfFragment> Shader::points(const Fragment& fragment) const {
    if (!lighting_.enabled()) return {};
    const Piece& piece = *fragment.piece;
    if (lights_pixels(piece)) {
        const LitPlace place = lit_place_of_unit_normal(fragment);
        return {{place.vertex, place.face, material(fragment, place)}};
    }
    std::vector<PointOfFragment> points;
    const auto add = [&](std::uint32_t number, double weight) {
        const StageVertex& v = vertices_[number];
        const Face face = lit_face(piece.face);
        points.push_back({v, face, lighting_.material(v, face), weight, number});
    };
    if (shading_ == Shading::kFlat) {
        add(piece.primitive.provoking, 1);
        return points;
    }
    const glm::dvec3 weights = weights_at(piece, fragment.position_window);
    for (int i = 0; i < 3; ++i)
        if (weights[i] != 0) add(piece.primitive.vertices[i], weights[i]);
    return points;
}

template <class Real>
Shader::Finish<Real> Shader::finish(const Fragment& fragment) const {
    Finish<Real> finish;
    if (draw_.fog.enabled) add_fog(fragment, finish);
    add_texels(fragment, finish);
    return finish;
}

double Shader::fog_distance(const Fragment& fragment) const {
    if (draw_.fog.by_coordinates) {
        const glm::dvec3 weights = weights_at(*fragment.piece, fragment.position_window);
        const std::vector<glm::dvec4>& coordinates = *draw_.column(VertexAttribute::kFogCoord);
        double coordinate = 0;
        for (int i = 0; i < 3; ++i) coordinate += weights[i] * coordinates[fragment.piece->primitive.vertices[i]].x;
        return coordinate;
    }
    const glm::dvec2 zw = eye_zw(fragment);
    return reference::fog_distance(zw.x, zw.y);
}

// 3.10: f may be computed at each vertex and interpolated. Linear f is computed from the interpolated distance.
double Shader::fog_of_vertices(const Fragment& fragment) const {
    const glm::dvec3 weights = weights_at(*fragment.piece, fragment.position_window);
    double distance = 0;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec4& eye = vertices_[fragment.piece->primitive.vertices[i]].position_eye;
        distance += weights[i] * reference::fog_distance(eye.z, eye.w);
    }
    return fog_factor(draw_.fog, distance);
}

bool Shader::has_linear_fog_behind_eye(const Piece& piece) const {
    if (!draw_.fog.enabled || draw_.fog.by_coordinates || draw_.fog.mode != kGL_LINEAR || piece.rays) return false;
    const auto z_eye = [&](int i) { return vertices_[piece.primitive.vertices[i]].position_eye.z; };
    const auto [least, most] = std::minmax({z_eye(0), z_eye(1), z_eye(2)});
    return least < 0 && most > 0;
}

bool Shader::has_several_colors(const Piece& piece) const {
    return piece.rays || !units_.empty() || has_linear_fog_behind_eye(piece) || copies_colors() ||
           (lights_pixels(piece) && lighting_.has_cones());
}

Why Shader::why_several_colors(const Piece& piece) const {
    if (copies_colors()) return Why::kCopies;
    if (has_linear_fog_behind_eye(piece)) return Why::kFog;
    if (!units_.empty()) return Why::kTextures;
    return piece.rays && !lighting_.has_cones() ? Why::kCurve : Why::kCone;
}

// Where it is in doubt which pixel is copied, it may have any colour.
Shader::LitRanges Shader::copied_colors(const Piece& piece) const {
    LitRanges colors;
    colors.primary.fill({0, 1});
    if (piece.is_perhaps_clipped) return colors;
    const auto& [low, high] = copied_->colors[piece.primitive.vertices[0]];
    for (int i = 0; i < 4; ++i) colors.primary[static_cast<std::size_t>(i)] = {low[i], high[i]};
    return colors;
}

std::optional<Shader::LitRanges> Shader::colors_beside_cones(const Fragment& fragment) const {
    if (!lights_pixels(*fragment.piece) || !lighting_.enabled() || !lighting_.has_cones()) return std::nullopt;
    const LitPlace place = lit_place_of_unit_normal(fragment);
    const StageVertex& v = place.vertex;
    const auto both = lighting_.beside_cones(v.position_eye, v.normal_eye, material(fragment, place), place.face);
    if (!both) return std::nullopt;
    const LitColors inside = clamped_colors((*both)[0]), outside = clamped_colors((*both)[1]);
    LitRanges ranges;
    for (int i = 0; i < 4; ++i) {
        const auto channel = static_cast<std::size_t>(i);
        ranges.primary[channel] = hull(inside.primary[i], outside.primary[i]);
        ranges.secondary[channel] = hull(inside.secondary[i], outside.secondary[i]);
    }
    return ranges;
}

void Shader::add_fog(const Fragment& fragment, Finish<double>& finish) const { finish.fog = fog(fragment); }

void Shader::add_fog(const Fragment& fragment, Finish<Interval>& finish) const {
    finish.fog = fog(fragment);
    if (has_linear_fog_behind_eye(*fragment.piece)) finish.fog = hull(finish.fog, fog_of_vertices(fragment));
}

TexturePlace Shader::texture_place_of(const Fragment& fragment, const Unit& unit) const {
    return fragment.point
               ? fragment.point->place
               : texture_place(unit.tex_coords, *fragment.piece, fragment.position_window, *unit.state->texture);
}

template <class Real>
void Shader::add_texels(const Fragment& fragment, Finish<Real>& finish) const {
    if (units_.empty()) return;
    if (!combines_textures_) return find_texel(fragment, units_.front(), finish.texel.emplace(), finish.has_choice);
    finish.texels.resize(units_.size());
    for (std::size_t i = 0; i < units_.size(); ++i)
        find_texel(fragment, units_[i], finish.texels[i], finish.has_choice);
}

void Shader::find_texel(const Fragment& fragment, const Unit& unit, Channels<double>& texel, bool&) const {
    const Texture& texture = *unit.state->texture;
    const TexturePlace place = texture_place_of(fragment, unit);
    const double lambda = level_of_detail(scale_factor(texture, place), *unit.state);
    texel = channels<double>(sample(texture, place.str, lambda, place.face));
}

// `has_choice` stays true if it is.
void Shader::find_texel(const Fragment& fragment, const Unit& unit, Channels<Interval>& texel, bool& has_choice) const {
    PlaceErrors errors = place_errors_;
    if (!unit.state->generated.empty())  // then the Draw has no exact surfaces
        for (const std::uint32_t i : fragment.piece->primitive.vertices)
            errors.vertex =
                std::max(errors.vertex, generated_error(draw_, *unit.state, draw_.vertices[i], vertices_[i]));
    if (unit.state->texture->is_cube()) {
        std::optional<TexelBounds> all;
        for (const TexturePlaceBounds& place : cube_place_bounds(
                 unit.tex_coords, *fragment.piece, fragment.position_window, *unit.state->texture, errors)) {
            const TexelBounds one = sample_bounds(*unit.state, place.str, place.str_error, place.rho, place.face,
                                                  place.change, unit.copied);
            all = all ? choice(*all, one) : one;
        }
        texel = all->texel;
        has_choice |= all->has_choice;
        return;
    }
    const TexturePlaceBounds place = fragment.point
                                         ? surface_place_bounds(fragment.point->place, *unit.state->texture)
                                         : texture_place_bounds(unit.tex_coords, *fragment.piece,
                                                                fragment.position_window, *unit.state->texture, errors);
    const TexelBounds bounds =
        sample_bounds(*unit.state, place.str, place.str_error, place.rho, 0, place.change, unit.copied);
    texel = bounds.texel;
    has_choice |= bounds.has_choice;
}

Channels<Marked> Shader::marked_color(const Fragment& fragment, const MarkedColors& lit,
                                      lighting::RulingSet position) const {
    Finish<Marked> finish;
    if (draw_.fog.enabled) {
        const glm::dvec2 zw = eye_zw(fragment);
        finish.fog = fog_factor(draw_.fog, draw_.fog.by_coordinates
                                               ? Marked(fog_distance(fragment))
                                               : reference::fog_distance(Marked(zw.x, position), Marked(zw.y)));
    }
    if (!units_.empty()) {
        Finish<double> unmarked;
        add_texels(fragment, unmarked);
        const auto marked = [&](const Channels<double>& texel, const Unit& unit) {
            lighting::RulingSet rulings =
                fragment.point || unit.state->texture->is_cube()
                    ? lighting::RulingSet{}
                    : texture_rulings(unit.tex_coords, *fragment.piece, fragment.position_window, *unit.state->texture);
            const auto is_mixed = [](double channel) { return channel > 0 && channel < 1; };
            if (unit.state->texture->compares() && std::ranges::any_of(texel, is_mixed))
                rulings |= {lighting::Ruling::kMixedOutcomes};
            Channels<Marked> result;
            for (std::size_t i = 0; i < result.size(); ++i) result[i] = {texel[i], rulings};
            return result;
        };
        if (unmarked.texel) finish.texel = marked(*unmarked.texel, units_.front());
        for (std::size_t i = 0; i < unmarked.texels.size(); ++i)
            finish.texels.push_back(marked(unmarked.texels[i], units_[i]));
    }
    return finished(lit, finish);
}

// 3.9: after texturing, the secondary colour is added to the primary one; alpha is the primary one's. The sum is
// clamped to [0,1]; both colours were clamped before.
template <class Real, class Colors>
Channels<Real> Shader::finished(const Colors& colors, const Finish<Real>& finish) const {
    return finished(colors, finish, [](Step, const Channels<Real>&) {});
}

template <class Real, class Colors, class See>
Channels<Real> Shader::finished(const Colors& colors, const Finish<Real>& finish, const See& see) const {
    Channels<Real> result;
    for (int i = 0; i < 4; ++i) result[i] = Real(colors.primary[i]);
    if (combines_textures_) {
        const Channels<Real> primary = result;
        const auto texel_of = [&](std::size_t number) {
            const auto unit = std::ranges::find(units_, number, &Unit::number);
            return unit == units_.end() ? Channels<Real>{}
                                        : finish.texels[static_cast<std::size_t>(unit - units_.begin())];
        };
        for (std::size_t i = 0; i < units_.size(); ++i) {
            const TextureUnit& unit = *units_[i].state;
            result = unit.env_mode == kGL_COMBINE
                         ? combined(unit, units_[i].number, primary, result, texel_of)
                         : textured(unit, unit.texture->base_format(), result, finish.texels[i]);
            see(Step::kTextured, result);
        }
    } else {
        if (finish.texel) {
            const TextureUnit& unit = *units_.front().state;
            result = textured(unit, unit.texture->base_format(), result, *finish.texel);
        }
        see(Step::kTextured, result);
    }
    for (int i = 0; i < 3; ++i) result[i] = result[i] + Real(colors.secondary[i]);
    for (Real& channel : result) channel = clamp01(channel);
    see(Step::kSummed, result);
    if (draw_.fog.enabled) result = fogged(draw_.fog, finish.fog, result);
    see(Step::kFogged, result);
    if (srgb_coded_)
        for (int i = 0; i < 3; ++i) result[i] = coded(result[i]);
    return result;
}

ColorSteps Shader::steps(const Fragment& fragment) const {
    return with_point(fragment, [&](const Fragment& whole) {
        const LitColors colors = lights_pixels(*whole.piece) ? lit(whole) : vertex_colors(whole);
        ColorSteps steps{.primary = colors.primary, .secondary = colors.secondary};
        for (const Unit& unit : units_) {
            const TexturePlace place = texture_place_of(whole, unit);
            glm::dvec4 coordinates(place.str, 1);  // of a surface or a sprite
            if (!whole.point && !unit.tex_coords.are_replaced(*whole.piece)) {
                coordinates = glm::dvec4(0);
                const glm::dvec3 weights = weights_at(*whole.piece, whole.position_window);
                for (int i = 0; i < 3; ++i)
                    coordinates += weights[i] * unit.tex_coords[whole.piece->primitive.vertices[i]];
            }
            steps.textures.push_back(texture_steps(*unit.state, coordinates, place));
            steps.textures.back().unit = unit.number;
        }
        if (draw_.fog.enabled) steps.fog = {.distance = fog_distance(whole), .factor = fog(whole)};
        std::size_t next = 0;  // of steps.textures
        finished(colors, finish<double>(whole), [&](Step step, const Channels<double>& color) {
            if (step == Step::kTextured && next < steps.textures.size()) {
                steps.textures[next].fragment = next == 0 ? steps.primary : steps.textures[next - 1].result;
                steps.textures[next++].result = color_of(color);
            }
            if (step == Step::kSummed) steps.sum = color_of(color);
            if (step == Step::kFogged && steps.fog) steps.fog->result = color_of(color);
        });
        return steps;
    });
}

// Flat (2.14.7): one colour for the whole primitive. Gouraud: interpolated between the vertices.
Shader::LitColors Shader::vertex_colors(const Fragment& fragment) const {
    const Piece& piece = *fragment.piece;
    const auto of_vertex = [&](std::uint32_t number) -> const LitColors& {
        const std::vector<LitColors>& lit = lit_face(piece.face) == Face::kFront ? lit_front_ : lit_back_;
        return lit[vertices_.place(number)];
    };
    if (shading_ == Shading::kFlat) return of_vertex(piece.primitive.provoking);
    const glm::dvec3 weights = weights_at(piece, fragment.position_window);
    LitColors sum;
    for (int i = 0; i < 3; ++i) {
        const LitColors& v = of_vertex(piece.primitive.vertices[i]);
        sum.primary += weights[i] * v.primary;
        sum.secondary += weights[i] * v.secondary;
    }
    return sum;
}

// On an exact surface the point has its own attributes; on a mesh they are interpolated between the vertices.
Shader::LitPlace Shader::lit_place(const Fragment& fragment) const {
    const Piece& piece = *fragment.piece;
    if (fragment.point) return {fragment.point->vertex, lit_face(fragment.point->face)};
    LitPlace place{.vertex = {}, .face = lit_face(piece.face)};
    const glm::dvec3 weights = weights_at(piece, fragment.position_window);
    for (int i = 0; i < 3; ++i) {
        const StageVertex& v = vertices_[piece.primitive.vertices[i]];
        place.vertex.position_eye += weights[i] * v.position_eye;
        place.vertex.normal_eye += weights[i] * v.normal_eye;
        place.vertex.color += weights[i] * v.color;
    }
    return place;
}

// RULING (not in GL): the interpolated normal is scaled to length 1.
Shader::LitPlace Shader::lit_place_of_unit_normal(const Fragment& fragment) const {
    LitPlace place = lit_place(fragment);
    glm::dvec3& normal = place.vertex.normal_eye;
    if (!fragment.point) normal = vec3_cast<glm::dvec3>(lighting::unit(vec3_cast<Vec>(normal)));
    return place;
}

// RULING (not in GL): materials are interpolated like colours; properties that track the current colour follow its
// interpolation.
LitMaterial Shader::material(const Fragment& fragment, const LitPlace& place) const {
    const Piece& piece = *fragment.piece;
    if (piece.rays || !lighting_.has_vertex_materials()) return lighting_.material(place.vertex, place.face);
    std::array<LitMaterial, 3> materials;
    for (int i = 0; i < 3; ++i) materials[i] = lighting_.material(vertices_[piece.primitive.vertices[i]], place.face);
    return mixed(weights_at(piece, fragment.position_window), materials);
}

// RULING (not in GL): the clamp of 2.14.6 applies to each pixel.
Shader::LitColors Shader::lit(const Fragment& fragment) const {
    const LitPlace place = lit_place_of_unit_normal(fragment);
    const StageVertex& v = place.vertex;
    if (!lighting_.enabled()) return clamped_colors(lighting_.colors(v, place.face));
    return clamped_colors(lighting_.lit(v.position_eye, v.normal_eye, material(fragment, place), place.face));
}

// The eye coordinates z and w, from which fog computes the distance.
glm::dvec2 Shader::eye_zw(const Fragment& fragment) const {
    if (fragment.point) return {fragment.point->vertex.position_eye.z, fragment.point->vertex.position_eye.w};
    const glm::dvec3 weights = weights_at(*fragment.piece, fragment.position_window);
    glm::dvec2 zw(0);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec4& eye = vertices_[fragment.piece->primitive.vertices[i]].position_eye;
        zw += weights[i] * glm::dvec2(eye.z, eye.w);
    }
    return zw;
}

}  // namespace twinlight::reference
