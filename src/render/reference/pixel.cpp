#include "render/reference/pixel.h"

#include <algorithm>

#include "lighting/real_cast.h"
#include "render/reference/coverage.h"
#include "render/reference/fragment_operations.h"
#include "render/reference/framebuffer.h"
#include "render/reference/stages.h"

namespace twinlight::reference {

using lighting::Marked;

namespace {

StageVertex between(const std::vector<StageVertex>& vertices, const Primitive& primitive, const glm::dvec3& weights) {
    StageVertex pixel;
    for (int i = 0; i < 3; ++i) {
        const StageVertex& v = vertices[primitive.vertices[static_cast<std::size_t>(i)]];
        pixel.position_eye += weights[i] * v.position_eye;
        pixel.normal_eye += weights[i] * v.normal_eye;
        pixel.color += weights[i] * v.color;
    }
    pixel.normal_eye = vec3_cast<glm::dvec3>(lighting::unit(vec3_cast<Vec>(pixel.normal_eye)));
    return pixel;
}

LitMaterial material_between(const DrawLighting& lighting, const std::vector<StageVertex>& vertices,
                             const Primitive& primitive, const glm::dvec3& weights, Face face) {
    std::array<LitMaterial, 3> materials;
    for (std::size_t i = 0; i < 3; ++i) materials[i] = lighting.material(vertices[primitive.vertices[i]], face);
    return mixed(weights, materials);
}

// Of the place that the fragment shows.
VertexRulings rulings_of_place(const Draw& draw, const Piece& piece, const glm::dvec2& position_window) {
    if (piece.rays) return surface_rulings(draw, piece.rays->point(position_window, piece.point).value().object);
    const glm::dvec3 weights = weights_at(piece, position_window);
    VertexRulings all;
    for (int i = 0; i < 3; ++i) {
        if (weights[i] == 0) continue;
        const VertexRulings one =
            vertex_rulings(draw, draw.vertices[piece.primitive.vertices[static_cast<std::size_t>(i)]]);
        all.position |= one.position;
        all.normal |= one.normal;
    }
    return all;
}

void add_points(const StagedDraw& staged, const Piece& piece, const glm::dvec2& position_window,
                const VertexRulings& of_place, const Options& options, PixelFragment& fragment) {
    const DrawLighting lighting(*staged.draw, options.lecture_variants);
    fragment.is_lit = lighting.enabled();
    if (!lighting.enabled()) return;
    const auto& lights = staged.draw->lighting.lights;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].enabled) fragment.lights.push_back(static_cast<int>(i));
    const Face face = lighting.two_side() ? fragment.face : Face::kFront;
    const auto marked = marked_lights(*staged.draw, options.lecture_variants);
    const auto point = [&](const StageVertex& v, const LitMaterial& material, const VertexRulings& rulings) {
        return lighting.point(v, material, face, marked, rulings);
    };
    if (piece.rays) {
        const StageVertex pixel = piece.rays->point(position_window, piece.point).value().vertex;
        fragment.points.push_back(point(pixel, lighting.material(pixel, face), of_place));
        return;
    }
    const glm::dvec3 weights = weights_at(piece, position_window);
    if (fragment.shading == Shading::kPhong || fragment.shading == Shading::kExact) {
        const StageVertex pixel = between(staged.vertices, piece.primitive, weights);
        VertexRulings rulings = of_place;
        if (pixel.normal_eye == glm::dvec3(0) && rulings.normal.empty())
            rulings.normal = {lighting::Ruling::kZeroNormal};
        const LitMaterial material = lighting.has_vertex_materials()
                                         ? material_between(lighting, staged.vertices, piece.primitive, weights, face)
                                         : lighting.material(pixel, face);
        fragment.points.push_back(point(pixel, material, rulings));
        return;
    }
    const auto add = [&](std::uint32_t vertex, double weight) {
        const StageVertex& v = staged.vertices[vertex];
        fragment.points.push_back(
            point(v, lighting.material(v, face), vertex_rulings(*staged.draw, staged.draw->vertices[vertex])));
        fragment.points.back().weight = weight;
    };
    if (fragment.shading == Shading::kFlat) return add(piece.primitive.provoking, 1);
    for (int i = 0; i < 3; ++i)
        if (weights[i] != 0) add(piece.primitive.vertices[static_cast<std::size_t>(i)], weights[i]);
}

// Lit, or the current colour, which no ruling decides: 2.14.6's clamp, then between the points.
Shader::MarkedColors marked_colors(const PixelFragment& fragment) {
    Shader::MarkedColors colors;
    if (!fragment.is_lit) colors.primary.fill(1);
    for (const LitPoint& point : fragment.points) {
        const auto add = [&](Channels<Marked>& sum, const Vec3<Marked>& color) {
            const Marked channels[] = {color.x, color.y, color.z};
            for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + Marked(point.weight) * lighting::clamp01(channels[i]);
        };
        add(colors.primary, point.marked_primary);
        add(colors.secondary, point.marked_secondary);
    }
    return colors;
}

void add_rulings(const Shader& shader, const Piece& piece, const glm::dvec2& position_window,
                 const VertexRulings& of_place, PixelFragment& fragment) {
    lighting::RulingSet decided;
    for (const Marked& channel :
         shader.marked_color(piece, position_window, marked_colors(fragment), of_place.position))
        decided |= channel.rulings;
    for (const lighting::RulingText& text : lighting::kRulings) {
        if (!decided.contains(text.ruling)) continue;
        PixelFragment::Decided& one = fragment.rulings.emplace_back(PixelFragment::Decided{text.ruling, {}});
        for (std::size_t i = 0; i < fragment.lights.size(); ++i)
            if (std::ranges::any_of(fragment.points, [&](const LitPoint& point) {
                    const lighting::LightTerms<Marked>& terms = point.marked_terms[i];
                    return (rulings_of(terms.ambient) | rulings_of(terms.diffuse) | rulings_of(terms.specular))
                        .contains(text.ruling);
                }))
                one.lights.push_back(fragment.lights[i]);
    }
}

}  // namespace

LitPoint DrawLighting::point(const StageVertex& v, const LitMaterial& material, Face face,
                             const std::vector<lighting::Light<Marked>>& lights, const VertexRulings& rulings) const {
    const lighting::SurfacePoint<double> surface = surface_of(v.position_eye, v.normal_eye, face);
    LitPoint point{.material = material};
    point.terms.resize(lights_.size());
    point.formulas = lighting::formulas(model_);
    const lighting::Lit<double> lit = light_surface(material, surface, point.terms.data());
    point.scene_ambient =
        spectral_ ? spectral_->scene_ambient(material) : lighting::finite_or_zero(material.ambient * model_.ambient);
    point.primary = lit.primary;
    point.secondary = lit.secondary;

    point.marked_terms.resize(lights.size());
    const Vec3<Marked> normal = vec3_cast<Vec3<Marked>>(surface.normal_eye);
    const lighting::SurfacePoint<Marked> from{
        marked(lighting::divided(vec3_cast<Vec3<Marked>>(v.position_eye), Marked(v.position_eye.w)), rulings.position),
        marked(normal, rulings.normal)};
    const lighting::Lit<Marked> told =
        lighting::measured_light<Marked>(lighting::real_cast<Marked>(model_), lighting::real_cast<Marked>(material),
                                         from, lights, point.marked_terms.data());
    point.marked_primary = told.primary;
    point.marked_secondary = told.secondary;
    return point;
}

std::vector<PixelFragment> pixel_fragments(const Frame& frame, const Options& options, int x, int y) {
    const Stages stages = run_stages(frame, options);
    const std::vector<Shader> shaders = make_shaders(stages, options);
    const PixelRect pixel{x, y, x + 1, y + 1};
    std::vector<PixelFragment> fragments;
    double stored = 1;
    for (const Step& step : stages.steps) {
        if (step.clear < 0) {
            const Clear& clear = stages.clear(step.clear);
            if (clear.depth && scissored(clear.scissor, pixel).contains(x, y)) stored = clear.clear_depth;
        }
        for (std::size_t i = step.first_piece; i < step.end_piece; ++i) {
            const Piece& piece = stages.pieces[i];
            const Draw& draw = stages.draw_of(piece);
            for_each_pixel(piece, scissored(draw.fragment.scissor, pixel), [&](int, int) {
                const glm::dvec2 centre = pixel_centre(x, y);
                PixelFragment fragment{.draw = piece.draw, .face = piece.face, .depth = depth_at(piece, centre)};
                if (piece.rays) fragment.face = piece.rays->point(centre, piece.point).value().face;
                fragment.shading = options.shading.value_or(draw.lighting.shade_model == kGL_FLAT ? Shading::kFlat
                                                                                                  : Shading::kGouraud);
                fragment.color = shaders[piece.draw].color(piece, centre);
                const bool tested = draw.raster.depth_test;
                fragment.passes = (!tested || depth_passes(draw.raster.depth_func, fragment.depth, stored)) &&
                                  (!draw.fragment.alpha_test || alpha_passes(draw.fragment, fragment.color.a));
                if (fragment.passes && tested && draw.raster.depth_mask) stored = fragment.depth;
                const VertexRulings of_place = rulings_of_place(draw, piece, centre);
                add_points(stages.draws[piece.draw], piece, centre, of_place, options, fragment);
                add_rulings(shaders[piece.draw], piece, centre, of_place, fragment);
                fragments.push_back(std::move(fragment));
            });
        }
    }
    return fragments;
}

LitPoint mean_of(const PixelFragment& fragment) {
    LitPoint mean{.material = {{.diffuse_alpha = 0}}};
    mean.terms.resize(fragment.lights.size());
    for (lighting::LightTerms<double>& terms : mean.terms) terms.attenuation = terms.spot = 0;
    for (const LitPoint& point : fragment.points) {
        const double w = point.weight;
        mean.formulas = point.formulas;
        mean.material.emission += w * point.material.emission;
        mean.scene_ambient += w * point.scene_ambient;
        mean.primary += w * point.primary;
        mean.secondary += w * point.secondary;
        for (std::size_t i = 0; i < mean.terms.size(); ++i) {
            const lighting::LightTerms<double>& of = point.terms[i];
            lighting::LightTerms<double>& terms = mean.terms[i];
            terms.attenuation += w * of.attenuation;
            terms.spot += w * of.spot;
            terms.n_dot_vp += w * of.n_dot_vp;
            terms.highlight += w * of.highlight;
            terms.ambient += w * of.ambient;
            terms.diffuse += w * of.diffuse;
            terms.specular += w * of.specular;
        }
    }
    return mean;
}

}  // namespace twinlight::reference
