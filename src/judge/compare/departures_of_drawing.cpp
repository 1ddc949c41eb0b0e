// Departures in drawing primitives: clipping, polygon modes, lines, points, texturing, fog.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "judge/compare/departure_rules.h"
#include "render/reference/geometry/primitive_assembly.h"
#include "render/reference/vertices/tex_gen.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::compare {

namespace {

bool is_clipped(const Draw& draw) {
    return std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) {
        const glm::dvec4 eye = draw.eye_from_object * vertex.position_object, clip = draw.clip_from_eye * eye;
        for (const auto& plane : draw.raster.clip_planes_eye)
            if (plane && glm::dot(*plane, eye) < 0) return true;
        return std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) > clip.w;
    });
}

bool offsets_borders(const Draw& draw) {
    if (!draw.raster.depth_test) return false;  // otherwise the offset is invisible
    const auto draws_offset_borders = [&](Enum mode) {
        return mode != kGL_FILL && draw.raster.polygon_offset.is_enabled_for(mode);
    };
    return draws_offset_borders(draw.raster.polygon_mode_front) || draws_offset_borders(draw.raster.polygon_mode_back);
}

struct Corners {
    std::array<glm::dvec3, 3> window;
    double
        determinant;  // of their normalised (x, y, w) in clip coordinates; 0 if the corners lie in a plane with the eye
    double slope;     // m of 3.5.5, which is infinite then
};

glm::dvec4 clip_position(const Draw& draw, std::uint32_t vertex) {
    return draw.clip_from_eye * draw.eye_from_object * draw.vertices[vertex].position_object;
}

// Of three vertices: Corners::determinant.
double determinant_of(const Draw& draw, const std::array<std::uint32_t, 3>& vertices) {
    glm::dmat3 xyw(0);
    for (int k = 0; const std::uint32_t vertex : vertices) {
        const glm::dvec4 clip = clip_position(draw, vertex);
        const glm::dvec3 direction(clip.x, clip.y, clip.w);
        xyw[k++] = glm::length(direction) > 0 ? glm::normalize(direction) : direction;
    }
    return glm::determinant(xyw);
}

// Whether `are` is true for any three corners that a polygon of the Draw may be cut into.
bool any_corners(const Draw& draw, const std::function<bool(const Corners&)>& are) {
    const auto window = [&](const glm::dvec4& clip) {
        const RasterState& raster = draw.raster;
        const glm::dvec2 half_size = 0.5 * glm::dvec2(raster.viewport.width, raster.viewport.height);
        const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
        const double z = glm::mix(raster.depth_near, raster.depth_far, ndc.z * 0.5 + 0.5);
        return glm::dvec3(half_size * glm::dvec2(ndc), z);
    };
    for (std::size_t i = 2; i < draw.count(); ++i) {
        for (const std::size_t first : {std::size_t{0}, i - 2}) {
            Corners corners{};
            const std::array<std::uint32_t, 3> vertices{draw.index(first), draw.index(i - 1), draw.index(i)};
            for (std::size_t k = 0; k < vertices.size(); ++k)
                corners.window[k] = window(clip_position(draw, vertices[k]));
            corners.determinant = determinant_of(draw, vertices);
            const glm::dvec3 normal =
                glm::cross(corners.window[1] - corners.window[0], corners.window[2] - corners.window[0]);
            const double rise = std::max(std::abs(normal.x), std::abs(normal.y)), area = std::abs(normal.z);
            corners.slope = rise == 0 ? 0 : area == 0 ? HUGE_VAL : rise / area;
            if (are(corners)) return true;
        }
    }
    return false;
}

}  // namespace

bool draws_borders_of_clipped_polygons(const Draw& draw) { return draw.draws_borders() && is_clipped(draw); }

bool has_faces_on_borders(const Draw& draw) {
    return draw.draws_borders() && draw.lighting.enabled && draw.lighting.light_model.two_side;
}

bool has_faces_in_stencil_of_borders(const Draw& draw) {
    const auto& stencil = draw.fragment.stencil;
    return draw.draws_borders() && stencil && stencil->front != stencil->back;
}

bool has_smooth_points(const Draw& draw) {
    const bool is_opaque = !draw.lighting.enabled && !draw.texture.texture &&
                           std::ranges::all_of(draw.vertices, [](const Vertex& vertex) { return vertex.color.a == 1; });
    return draw.draws_points() && draw.raster.point_smooth && !is_opaque;
}

bool has_wide_lines(const Draw& draw) { return draw.draws_lines() && draw.raster.line_width > 1; }

template <class Holds>
bool any_unit(const Draw& draw, const Holds& holds) {
    bool any = false;
    draw.for_each_unit([&](std::size_t, const TextureUnit& unit) { any = any || holds(unit); });
    return any;
}

// A texture that uses the level of detail: with mipmaps, or with two different filters.
bool has_level_of_detail(const Draw& draw) {
    return any_unit(draw, [](const TextureUnit& unit) { return unit.texture->min_filter != unit.texture->mag_filter; });
}

bool has_levels_in_wrong_order(const Draw& draw) {
    return any_unit(draw, [](const TextureUnit& unit) { return unit.texture->min_lod > unit.texture->max_lod; });
}

bool compares_depths_in_one_dimension(const Draw& draw) {
    return any_unit(draw, [](const TextureUnit& unit) {
        return unit.texture->target == kGL_TEXTURE_1D && unit.texture->compares();
    });
}

// Such a plane is 0 (the ruling in scene/state/tex_gen.cpp).
bool has_eye_plane_of_singular_matrix(const Draw& draw) {
    return any_unit(draw, [](const TextureUnit& unit) {
        return std::ranges::any_of(unit.generated, [](const GeneratedCoordinate& one) {
            return one.mode == kGL_EYE_LINEAR && one.plane == glm::dvec4(0);
        });
    });
}

bool has_edge_flags_in_strip(const Draw& draw) {
    const bool strip = draw.mode == kGL_TRIANGLE_STRIP || draw.mode == kGL_TRIANGLE_FAN || draw.mode == kGL_QUAD_STRIP;
    return strip && draw.draws_borders() &&
           std::ranges::any_of(draw.vertices, [](const Vertex& vertex) { return !vertex.edge_flag; });
}

bool offsets_other_modes_alone(const Draw& draw) {
    const PolygonOffset& offset = draw.raster.polygon_offset;
    return draw.raster.depth_test && draws_polygons(draw.mode) && !draw.draws_borders() && !offset.fill &&
           (offset.line || offset.point) && (offset.units != 0 || offset.factor != 0);
}

bool offsets_one_of_two_modes(const Draw& draw) {
    const PolygonOffset& offset = draw.raster.polygon_offset;
    return offset.is_enabled_for(draw.raster.polygon_mode_front) !=
           offset.is_enabled_for(draw.raster.polygon_mode_back);
}

// A polygon seen edge-on has no slope m, but its lines and points are still drawn.
bool offsets_borders_without_area(const Draw& draw) {
    constexpr double kNoArea = 1e-7;
    return offsets_borders(draw) &&
           any_corners(draw, [](const Corners& corners) { return std::abs(corners.determinant) < kNoArea; });
}

bool shows_faces(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const auto& stencil = draw.fragment.stencil;
    return raster.polygon_mode_front != raster.polygon_mode_back || raster.cull_enabled ||
           (draw.lighting.enabled && draw.lighting.light_model.two_side) ||
           (stencil && stencil->front != stencil->back);
}

bool has_polygons_as_smooth_lines(const Draw& draw) {
    return draw.draws_polygons_as(kGL_LINE) && draw.raster.line_smooth;
}

bool clips_under_singular_projection(const Draw& draw) {
    return glm::determinant(draw.clip_from_eye) == 0 &&
           std::ranges::any_of(draw.raster.clip_planes_eye, [](const auto& plane) { return plane.has_value(); });
}

bool fills_one_face(const Draw& draw) { return draw.draws_borders() && draw.draws_polygons_as(kGL_FILL); }

bool has_faces_in_doubt(const Draw& draw) {
    constexpr double kNoArea = 1e-7;
    const bool has_faces = shows_faces(draw),
               is_cut = reference::is_quadrilaterals(draw) && (has_faces || draw.draws_borders());
    if (!draws_polygons(draw.mode) || (!is_cut && !has_faces)) return false;
    for (const auto cut : {reference::QuadCut::kFirstToThird, reference::QuadCut::kSecondToFourth}) {
        const std::vector<reference::Primitive> triangles = reference::assemble(draw, cut);
        double before = 0;  // the other triangle of a quadrilateral
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const double determinant = determinant_of(draw, triangles[i].vertices);
            if (has_faces && std::abs(determinant) < kNoArea) return true;
            if (is_cut && i % 2 == 1 && std::min(determinant, before) < -kNoArea &&
                std::max(determinant, before) > kNoArea)
                return true;
            before = determinant;
        }
    }
    return false;
}

namespace {

// The least and the most depth of a triangle between the near and the far plane, before its offset; nothing if it has no slope.
struct OffsetTriangle {
    double least = 1, most = 0, slope = 0;
};
std::optional<OffsetTriangle> between_near_and_far(const Draw& draw, const reference::Primitive& triangle) {
    std::array<glm::dvec4, 3> clip{};
    glm::dmat3 xyw(0);
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        clip[i] = clip_position(draw, triangle.vertices[i]);
        xyw[k] = {clip[i].x, clip[i].y, clip[i].w};
    }
    if (glm::determinant(xyw) == 0) return std::nullopt;
    const RasterState& raster = draw.raster;
    const double scale = (raster.depth_far - raster.depth_near) / 2,
                 middle = (raster.depth_far + raster.depth_near) / 2;
    // z = change.x x + change.y y + change.z w
    const glm::dvec3 change = glm::dvec3(clip[0].z, clip[1].z, clip[2].z) * glm::inverse(xyw);
    OffsetTriangle result{.slope = std::abs(scale) * std::max(std::abs(change.x) * 2 / raster.viewport.width,
                                                              std::abs(change.y) * 2 / raster.viewport.height)};
    const auto add = [&](double ndc_z) {
        result.least = std::min(result.least, scale * ndc_z + middle);
        result.most = std::max(result.most, scale * ndc_z + middle);
    };
    for (std::size_t i = 0; i < clip.size(); ++i) {
        const glm::dvec4 &from = clip[i], &to = clip[(i + 1) % clip.size()];
        if (std::abs(from.z) <= from.w && from.w > 0) add(from.z / from.w);
        for (const double side : {-1, 1}) {
            const double before = from.z - side * from.w, after = to.z - side * to.w;
            if (before * after < 0 && glm::mix(from.w, to.w, before / (before - after)) > 0) add(side);
        }
    }
    return result;
}

bool offsets_filled_out_of_range(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const PolygonOffset& offset = raster.polygon_offset;
    if (!raster.depth_test || !offset.fill || !draw.draws_polygons_as(kGL_FILL)) return false;
    constexpr double kStep = 0x1p-24;
    for (const auto cut : {reference::QuadCut::kFirstToThird, reference::QuadCut::kSecondToFourth})
        for (const reference::Primitive& triangle : reference::assemble(draw, cut)) {
            const auto depths = between_near_and_far(draw, triangle);
            if (!depths) continue;
            const double by = offset.factor * depths->slope + 2 * kStep * offset.units;
            if (depths->least + by < -2 * kStep || depths->most + by > 1 + 2 * kStep) return true;
        }
    return false;
}

}  // namespace

// Less than two steps of the buffer beyond the range do not show in filled polygons: depths so near to each other are open.
bool offsets_out_of_range(const Draw& draw) {
    const PolygonOffset& offset = draw.raster.polygon_offset;
    if (offsets_filled_out_of_range(draw)) return true;
    constexpr double kRounding = 1e-5;  // of the slope
    constexpr double kStep =
        0x1p-24;  // r of 3.5.5 depends on the implementation: the reference uses this, Mesa twice it
    return offsets_borders(draw) && any_corners(draw, [&](const Corners& corners) {
               return std::ranges::any_of(corners.window, [&](const glm::dvec3& corner) {
                   for (const double r : {kStep, 2 * kStep}) {
                       const double by = offset.factor * corners.slope + offset.units * r;
                       const double margin = kRounding * std::abs(by) + 2 * kStep;
                       if (!(corner.z + by > margin && corner.z + by < 1 - margin)) return true;
                   }
                   return false;
               });
           });
}

// Whether a texture unit's texture and final texture coordinates at the vertex are so.
template <class Holds>
bool any_tex_coord(const Draw& draw, const Vertex& vertex, const Holds& holds) {
    const reference::StageVertex staged = reference::vertex_stage(draw, {&vertex, 1}).front();
    const std::size_t number = static_cast<std::size_t>(&vertex - draw.vertices.data());  // if it is one of the Draw's
    bool any = draw.texture.texture && holds(*draw.texture.texture, staged.tex_coord);
    for (const FurtherUnit& further : draw.further_units) {
        const glm::dvec4 own =
            number < draw.vertices.size() ? draw.tex_coord(further.number, number) : vertex.tex_coord;
        const glm::dvec4 generated =
            reference::generated_tex_coord(further.unit, vertex, own, staged.position_eye, staged.normal_eye);
        any = any || holds(*further.unit.texture, further.unit.texture_matrix * generated);
    }
    return any;
}

bool has_no_q(const Draw& draw, const Vertex& vertex) {
    return any_tex_coord(draw, vertex, [](const Texture&, const glm::dvec4& coord) { return coord.w <= 1e-6; });
}

bool has_no_direction_into_cube(const Draw& draw, const Vertex& vertex) {
    return any_tex_coord(draw, vertex, [](const Texture& texture, const glm::dvec4& coord) {
        return texture.is_cube() && glm::length(glm::dvec3(coord)) <= 1e-6;
    });
}

bool has_wide_points(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const PointParameters& parameters = raster.point_parameters;
    return draw.draws_points() && (raster.point_size > 1 || parameters.size_min > 1 || parameters.attenuates());
}

// Mesa takes |z| for the distance.
bool attenuates_points_aside(const Draw& draw) {
    return draw.draws_points() && draw.raster.point_parameters.depends_on_distance() &&
           std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) {
               const glm::dvec4 eye = draw.eye_from_object * vertex.position_object;
               return glm::length(glm::dvec3(eye) / eye.w) != std::abs(eye.z);
           });
}

bool has_sizes_in_wrong_order(const Draw& draw) {
    const PointParameters& parameters = draw.raster.point_parameters;
    return draw.draws_points() && parameters.size_min > parameters.size_max;
}

bool has_no_size_of_points(const Draw& draw) {
    const glm::dvec3& factors = draw.raster.point_parameters.distance_attenuation;
    return draw.draws_points() && (std::min({factors.x, factors.y, factors.z}) < 0 || factors == glm::dvec3(0));
}

bool biases_level_of_points(const Draw& draw) {
    return draw.draws_points() && any_unit(draw, [](const TextureUnit& unit) { return unit.lod_bias > 0; });
}

bool adds_secondary_color_in_fog(const Draw& draw) {
    const bool separates = draw.lighting.enabled && draw.lighting.light_model.color_control != kGL_SINGLE_COLOR;
    return draw.fog.enabled && (separates || draw.column(VertexAttribute::kSecondaryColor));
}

namespace {

// Whether the sum of the two, each times some positive number, is (0, 0, 0, 0), as far as single precision can tell.
bool are_opposite(const glm::dvec4& a, const glm::dvec4& b) { return glm::length(a + b) < 1e-6; }

// The same of three of length 1.
bool are_around_0(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
    const double bc = glm::dot(b, c), determinant = 1 - bc * bc;
    if (determinant < 1e-12) return false;
    const double of_b = (bc * glm::dot(a, c) - glm::dot(a, b)) / determinant,
                 of_c = (bc * glm::dot(a, b) - glm::dot(a, c)) / determinant;
    return of_b >= 0 && of_c >= 0 && glm::length(a + of_b * b + of_c * c) < 1e-6;
}

}  // namespace

// Where the near plane is that of the eye, as with gluPerspective(90, 1, 0, 10), primitives through the eye.
bool contains_no_direction(const Draw& draw) {
    if (draw.mode == kGL_POINTS || draw.pixels) return false;
    for (const auto cut : {reference::QuadCut::kFirstToThird, reference::QuadCut::kSecondToFourth})
        for (const reference::Primitive& primitive : reference::assemble(draw, cut)) {
            const bool is_line = primitive.shape == reference::Shape::kLine;
            std::array<glm::dvec4, 3> clip{};
            for (std::size_t i = 0; i < clip.size(); ++i)
                clip[i] =
                    glm::normalize(clip_position(draw, primitive.vertices[is_line ? std::min<std::size_t>(i, 1) : i]));
            const auto& [a, b, c] = clip;
            if (are_opposite(a, b) || are_opposite(b, c) || are_opposite(c, a) || are_around_0(a, b, c)) return true;
        }
    return false;
}

// Points and lines have no back, and the stencil state of the front.
bool has_faces_in_stencil_of_lines(const Draw& draw) {
    const auto& stencil = draw.fragment.stencil;
    return !draws_polygons(draw.mode) && stencil && stencil->front != stencil->back;
}

bool has_w_in_fog(const Draw& draw) {
    return draw.fog.enabled && !draw.fog.by_coordinates &&
           std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) {
               return std::abs((draw.eye_from_object * vertex.position_object).w - 1) > 1e-9;
           });
}

// Linear fog does not depart: 3.10 allows f to be computed at each vertex and interpolated, which gives the same colour.
bool has_exponential_fog_behind_the_eye(const Draw& draw) {
    if (!draw.fog.enabled || draw.fog.by_coordinates || draw.fog.mode == kGL_LINEAR || draw.mode == kGL_POINTS)
        return false;
    const auto z_eye = [&](const Vertex& vertex) { return (draw.eye_from_object * vertex.position_object).z; };
    return std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) { return z_eye(vertex) > 0; }) &&
           std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) { return z_eye(vertex) < 0; });
}

bool has_negative_fog_coords(const Draw& draw) {
    const std::vector<glm::dvec4>* coordinates = draw.column(VertexAttribute::kFogCoord);
    return coordinates && std::ranges::any_of(*coordinates, [](const glm::dvec4& c) { return c.x < 0; });
}

// Mesa makes separate lines of the strips in a list if another strip or line follows, so the count begins with each.
bool stipples_listed_strips(const Draw& draw) {
    return draw.raster.line_stipple && draw.in_list && (draw.mode == kGL_LINE_STRIP || draw.mode == kGL_LINE_LOOP);
}

// Depths are linear in the window, so they do not count.
bool stipples_in_perspective(const Draw& draw) {
    if (!draw.raster.line_stipple || !draw.draws_lines()) return false;
    const glm::dvec4 row = glm::row(draw.clip_from_eye * draw.eye_from_object, 3);
    const auto w = [&](const Vertex& vertex) { return glm::dot(row, vertex.position_object); };
    return std::ranges::any_of(draw.vertices,
                               [&](const Vertex& vertex) { return w(vertex) != w(draw.vertices.front()); });
}

bool stipples_borders(const Draw& draw) {
    const RasterState& raster = draw.raster;
    return raster.polygon_stipple && draw.draws_borders() && draw.draws_polygons_as(kGL_FILL);
}

bool has_scissored_sprites(const Draw& draw) { return draw.draws_sprites() && draw.fragment.scissor.enabled; }

// A mirrored image begins with the texels of its edge.
bool wraps_cube_maps(const Draw& draw) {
    const auto is_at_edge = [](Enum wrap) { return wrap == kGL_CLAMP_TO_EDGE || wrap == kGL_MIRRORED_REPEAT; };
    return any_unit(draw, [&](const TextureUnit& unit) {
        const Texture& texture = *unit.texture;
        return texture.is_cube() && !(is_at_edge(texture.wrap_s) && is_at_edge(texture.wrap_t)) &&
               (texture.min_filter != kGL_NEAREST || texture.mag_filter != kGL_NEAREST);
    });
}

bool clamps_between_nearest_and_linear(const Draw& draw) {
    return any_unit(draw, [](const TextureUnit& unit) {
        const Texture& texture = *unit.texture;
        const bool clamps_r = texture.is_volume() && texture.wrap_r == kGL_CLAMP;
        if (texture.wrap_s != kGL_CLAMP && texture.wrap_t != kGL_CLAMP && !clamps_r) return false;
        const bool min_nearest = texture.min_filter == kGL_NEAREST ||
                                 texture.min_filter == kGL_NEAREST_MIPMAP_NEAREST ||
                                 texture.min_filter == kGL_NEAREST_MIPMAP_LINEAR;
        return min_nearest != (texture.mag_filter == kGL_NEAREST);
    });
}

bool has_clipped_wide_points(const Draw& draw) {
    const glm::dmat4 clip_from_object = draw.clip_from_eye * draw.eye_from_object;
    return has_wide_points(draw) && std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) {
               const glm::dvec4 clip = clip_from_object * vertex.position_object;
               return std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) > clip.w;
           });
}

bool has_sprites_between_sizes(const Draw& draw) {
    constexpr double kSizesPerPixel = 8;
    const double size = kSizesPerPixel * draw.raster.point_size;
    return draw.draws_sprites() && (size != std::round(size) || draw.raster.point_parameters.attenuates());
}

bool scales_dot3_rgba(const Draw& draw) {
    return any_unit(draw, [](const TextureUnit& unit) {
        return unit.combine.gives_alpha() && unit.combine.rgb_scale != unit.combine.alpha_scale;
    });
}

}  // namespace twinlight::compare
