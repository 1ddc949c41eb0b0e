#include "render/reference/pixel_history.h"

#include <algorithm>
#include <span>

#include "base/math/normal_matrix.h"
#include "lighting/real_cast.h"
#include "render/reference/copied_pixels.h"
#include "render/reference/framebuffer.h"

namespace twinlight::reference {

using lighting::Marked;

namespace {

// The fragment's position, as a vertex.
VertexRulings rulings_of_place(const Draw& draw, const Fragment& fragment) {
    if (fragment.point) return vertex_rulings(draw, fragment.point->object, true);
    const glm::dvec3 weights = weights_at(*fragment.piece, fragment.position_window);
    VertexRulings all;
    for (int i = 0; i < 3; ++i) {
        if (weights[i] == 0) continue;
        const Vertex& vertex = draw.vertices[fragment.piece->primitive.vertices[static_cast<std::size_t>(i)]];
        const VertexRulings one = vertex_rulings(draw, vertex, draw.lighting.normalize);
        all.position |= one.position;
        all.normal |= one.normal;
    }
    return all;
}

NormalSteps normal_steps(const Draw& draw, const Vertex& vertex) {
    const glm::dmat3 normal_eye_from_object = normal_matrix(glm::dmat3(draw.eye_from_object));
    const bool rescales = draw.lighting.rescale_normal && !draw.lighting.normalize;
    return {.object = vec3_cast<Vec>(vertex.normal_object),
            .transformed = vec3_cast<Vec>(normal_eye_from_object * vertex.normal_object),
            .rescale = rescales ? rescale_factor(normal_eye_from_object) : 1};
}

LitPoint lit_point(const Draw& draw, const DrawLighting& lighting, const PointOfFragment& at, bool lecture_variants,
                   const VertexRulings& rulings) {
    if (lighting.differs_at(at.vertex.position_eye))
        return lit_point(draw, lighting.at(at.vertex.position_eye), at, lecture_variants, rulings);
    const std::vector<lighting::Light<Marked>> lights = marked_lights(draw, lecture_variants, at.vertex.position_eye);
    const lighting::SurfacePoint<double> surface = surface_of(at.vertex.position_eye, at.vertex.normal_eye, at.face);
    LitPoint point{.weight = at.weight,
                   .face = at.face,
                   .vertex = at.number,
                   .position_eye = at.vertex.position_eye,
                   .surface = surface,
                   .vpe_dir = lighting::toward_viewer(lighting.model(), surface.position_eye),
                   .material = at.material};
    if (at.number) {
        const Vertex& vertex = draw.vertices[*at.number];
        point.position_object = vertex.position_object;
        point.normal_steps = normal_steps(draw, vertex);
    }
    for (const lighting::Light<double>& light : lighting.lights())
        point.geometry.push_back(lighting::light_geometry(lighting.model(), surface, light));
    point.terms.resize(lights.size());
    point.formulas = lighting::formulas(lighting.model());
    const lighting::Lit<double> lit = lighting.light_surface(at.material, surface, point.terms.data());
    point.scene_ambient = lighting.scene_ambient(at.material);
    point.primary = lit.primary;
    point.secondary = lit.secondary;

    point.marked_terms.resize(lights.size());
    // A direction (w = 0) stands for all points far away in it: here one whose square is a float, so that no ruling about
    // squares is named.
    constexpr double kFar = 1e15;
    const Vec position_eye =
        at.vertex.position_eye.w == 0 ? kFar * lighting::unit(surface.position_eye) : surface.position_eye;
    const lighting::SurfacePoint<Marked> from{marked(vec3_cast<Vec3<Marked>>(position_eye), rulings.position),
                                              marked(vec3_cast<Vec3<Marked>>(surface.normal_eye), rulings.normal)};
    const lighting::Lit<Marked> with_rulings = lighting::measured_light<Marked>(
        lighting::real_cast<Marked>(lighting.model()), lighting::real_cast<Marked>(at.material), from, lights,
        point.marked_terms.data());
    point.marked_primary = with_rulings.primary;
    point.marked_secondary = with_rulings.secondary;
    return point;
}

std::vector<int> enabled_lights(const Draw& draw) {
    std::vector<int> numbers;
    const auto& lights = draw.lighting.lights;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].enabled) numbers.push_back(static_cast<int>(i));
    return numbers;
}

void add_corners(const Fragment& seen, PixelFragment& fragment) {
    if (seen.piece->rays) return;
    const glm::dvec3 weights = weights_at(*seen.piece, seen.position_window);
    for (int i = 0; i < 3; ++i)
        if (weights[i] != 0) fragment.corners.push_back({seen.piece->primitive.vertices[i], weights[i]});
}

void add_points(const Draw& draw, const Shader& shader, const Fragment& seen, const VertexRulings& of_place,
                bool lecture_variants, PixelFragment& fragment) {
    fragment.is_lit = shader.lighting().enabled();
    if (!fragment.is_lit) return;
    fragment.lights = enabled_lights(draw);
    for (const PointOfFragment& point : shader.points(seen)) {
        VertexRulings rulings = of_place;
        if (point.number) rulings = vertex_rulings(draw, draw.vertices[*point.number], draw.lighting.normalize);
        const bool is_between = !point.number && !seen.point;
        if (is_between && point.vertex.normal_eye == glm::dvec3(0) && rulings.normal.empty())
            rulings.normal = {lighting::Ruling::kZeroNormal};
        fragment.points.push_back(lit_point(draw, shader.lighting(), point, lecture_variants, rulings));
    }
}

// The lit colour, or the current colour, which depends on no ruling: clamped (2.14.6), then interpolated.
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

// The rulings with the lights whose terms they affected.
std::vector<PixelFragment::Decided> with_lights(lighting::RulingSet decided, const std::vector<int>& lights,
                                                std::span<const LitPoint> points) {
    std::vector<PixelFragment::Decided> rulings;
    for (const lighting::RulingText& text : lighting::kRulings) {
        if (!decided.contains(text.ruling)) continue;
        PixelFragment::Decided& one = rulings.emplace_back(PixelFragment::Decided{text.ruling, {}});
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (std::ranges::any_of(points, [&](const LitPoint& point) {
                    const lighting::LightTerms<Marked>& terms = point.marked_terms[i];
                    return (rulings_of(terms.ambient) | rulings_of(terms.diffuse) | rulings_of(terms.specular))
                        .contains(text.ruling);
                }))
                one.lights.push_back(lights[i]);
    }
    return rulings;
}

void add_rulings(const Shader& shader, const Fragment& seen, const VertexRulings& of_place, PixelFragment& fragment) {
    lighting::RulingSet decided;
    for (const Marked& channel : shader.marked_color(seen, marked_colors(fragment), of_place.position))
        decided |= channel.rulings;
    fragment.rulings = with_lights(decided, fragment.lights, fragment.points);
}

}  // namespace

PixelHistory pixel_history(const Frame& frame, const Options& options, int x, int y) {
    const DrawableFrame whole = drawable(frame, options);
    const StagedFrame stages = run_stages(*whole, options);
    const std::vector<Shader> shaders = make_shaders(stages, options);
    Framebuffer pixel(stages, shaders, {x, y, x + 1, y + 1});
    PixelHistory history;
    pixel.draw([&](const Fragment& seen, Outcome outcome) {
        const Draw& draw = stages.draw_of(*seen.piece);
        const Shader& shader = shaders[seen.piece->draw];
        PixelFragment fragment{.draw = seen.piece->draw,
                               .face = seen.point ? seen.point->face : seen.piece->face,
                               .depth = DrawnPixels::depth(seen),
                               .passes = outcome == Outcome::kPasses,
                               .shading = shader.shading(),
                               .after = color_of(pixel.colors().front())};
        const bool is_seen = fragment.passes && overwrites_color(draw.fragment);
        fragment.color = is_seen ? fragment.after : color_of(shader.shade<double>(seen).color);
        if (!is_seen && seen.piece->is_smooth) fragment.color.a *= coverage_of(*seen.piece, x, y);
        fragment.steps = shader.steps(seen);
        const VertexRulings of_place = rulings_of_place(draw, seen);
        add_corners(seen, fragment);
        add_points(draw, shader, seen, of_place, options.lecture_variants, fragment);
        add_rulings(shader, seen, of_place, fragment);
        history.fragments.push_back(std::move(fragment));
    });
    history.color = rgba(pixel.colors().front());
    return history;
}

VertexHistory vertex_history(const Draw& draw, const Options& options, std::uint32_t vertex, Face face) {
    const DrawLighting lighting(draw, options.lecture_variants);
    const StageVertex staged = vertex_stage(draw).at(vertex);
    const PointOfFragment at{
        .vertex = staged, .face = face, .material = lighting.material(staged, face), .number = vertex};
    const VertexRulings rulings = vertex_rulings(draw, draw.vertices[vertex], draw.lighting.normalize);
    VertexHistory history{.lights = enabled_lights(draw)};
    history.point = lit_point(draw, lighting, at, options.lecture_variants, rulings);
    const lighting::RulingSet decided =
        rulings_of(history.point.marked_primary) | rulings_of(history.point.marked_secondary);
    history.rulings = with_lights(decided, history.lights, std::span(&history.point, 1));
    return history;
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
