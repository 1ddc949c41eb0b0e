// The table of departures and what each asks.
#include "fuzz/departures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <set>

#include "context/context.h"

namespace twinlight::fuzz {

namespace {

// ---- Of the order of commands ----

using Id = CommandId;

bool is_one_of(const Command& command, std::initializer_list<std::string_view> prefixes) {
    return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return command.name().starts_with(prefix); });
}

// Whether a command of the first kind stands anywhere before one of the second.
bool stands_before(const CommandList& scene, std::string_view first, std::string_view second) {
    bool seen = false;
    for (const Command& command : scene.commands) {
        if (seen && command.name().starts_with(second)) return true;
        seen = seen || command.name().starts_with(first);
    }
    return false;
}

bool mixes_glcolor3_and_4(const CommandList& scene) { return stands_before(scene, "glColor4", "glColor3"); }

bool mixes_tex_coords(const CommandList& scene) {
    bool seen = false;
    for (const Command& command : scene.commands) {
        if (!command.name().starts_with("glTexCoord")) continue;
        if (command.name()[10] == '4')
            seen = true;
        else if (seen && command.name()[10] != 'P')
            return true;
    }
    return false;
}

// Between a glPushAttrib whose mask has one of `bits`, and none of `without`, and its glPopAttrib.
bool has_inside_push(const CommandList& scene, Enum bits, Enum without,
                     const std::function<bool(const Command&)>& is_it) {
    std::vector<Enum> masks;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glPushAttrib) masks.push_back(command.enumerant(0));
        if (command.id == Id::glPopAttrib && !masks.empty()) masks.pop_back();
        const bool saved =
            std::ranges::any_of(masks, [&](Enum mask) { return (mask & bits) != 0 && (mask & without) == 0; });
        if (saved && is_it(command)) return true;
    }
    return false;
}

bool sets_material_before_pop(const CommandList& scene) {
    return has_inside_push(scene, kGL_LIGHTING_BIT, 0,
                           [](const Command& command) { return command.name().starts_with("glMaterial"); });
}

// The same glShadeModel before and after a glPopAttrib of one list.
bool shades_after_pop_in_list(const CommandList& scene) {
    bool in_list = false, popped = false;
    std::set<Enum> before;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glNewList) {
            in_list = true;
            popped = false;
            before.clear();
        }
        if (command.id == Id::glEndList) in_list = false;
        if (command.id == Id::glPopAttrib) popped = in_list && !before.empty();
        if (command.id != Id::glShadeModel) continue;
        if (popped && before.contains(command.enumerant(0))) return true;
        if (in_list) before.insert(command.enumerant(0));
    }
    return false;
}

bool switches_lights_before_pop(const CommandList& scene) {
    const auto is_light = [](const Command& command) {
        return (command.id == Id::glEnable || command.id == Id::glDisable) && command.enumerant(0) >= kGL_LIGHT0 &&
               command.enumerant(0) < kGL_LIGHT0 + kMaxLights;
    };
    return has_inside_push(scene, kGL_ENABLE_BIT, kGL_LIGHTING_BIT, is_light);
}

bool generates_mipmaps_after_pop(const CommandList& scene) {
    return has_inside_push(scene, kGL_TEXTURE_BIT, 0, [](const Command& command) {
        return command.name().starts_with("glTexParameter") && command.enumerant(1) == kGL_GENERATE_MIPMAP;
    });
}

bool enables_color_material(const CommandList& scene) {
    return std::ranges::any_of(scene.commands, [](const Command& command) {
        return command.id == Id::glEnable && command.enumerant(0) == kGL_COLOR_MATERIAL;
    });
}

bool restores_tracked_color(const CommandList& scene) {
    return enables_color_material(scene) && has_inside_push(scene, kGL_CURRENT_BIT, 0, [](const Command& command) {
               return command.name().starts_with("glColor");
           });
}

bool lights_two_sides(const CommandList& scene) {
    return std::ranges::any_of(scene.commands, [](const Command& command) {
        return command.name().starts_with("glLightModel") && command.enumerant(0) == kGL_LIGHT_MODEL_TWO_SIDE &&
               command.number(1) != 0;
    });
}

// The back's material has parameters that vary from vertex to vertex, and they are not the front's: set by glMaterial of one
// side between glBegin and glEnd, or in another way, or the front's are others (2.14.3).
bool sets_sides_apart(const CommandList& scene) {
    if (!lights_two_sides(scene)) return false;
    enum Way { kByMaterial, kByColor };
    std::set<std::pair<Enum, Way>> front, back;
    Enum tracking_face = kGL_FRONT_AND_BACK, tracked = kGL_AMBIENT_AND_DIFFUSE;
    bool inside = false, has_values_of_one_side = false;
    const auto insert = [&](Enum face, Enum pname, Way way) {
        for (const Enum one :
             pname == kGL_AMBIENT_AND_DIFFUSE ? std::vector{kGL_AMBIENT, kGL_DIFFUSE} : std::vector{pname}) {
            if (face != kGL_BACK) front.emplace(one, way);
            if (face != kGL_FRONT) back.emplace(one, way);
        }
    };
    for (const Command& command : scene.commands) {
        if (command.id == Id::glBegin || command.id == Id::glEnd) inside = command.id == Id::glBegin;
        if (command.id == Id::glColorMaterial) {
            tracking_face = command.enumerant(0);
            tracked = command.enumerant(1);
        }
        if (command.id == Id::glEnable && command.enumerant(0) == kGL_COLOR_MATERIAL)
            insert(tracking_face, tracked, kByColor);
        if (!inside || !command.name().starts_with("glMaterial")) continue;
        insert(command.enumerant(0), command.enumerant(1), kByMaterial);
        has_values_of_one_side |= command.enumerant(0) != kGL_FRONT_AND_BACK;
    }
    for (auto* side : {&front, &back}) {  // what tracks the colour is not changed by glMaterial
        for (const auto& [pname, way] : std::set(*side)) {
            if (way == kByColor) side->erase({pname, kByMaterial});
        }
    }
    const auto is_by_material = [](const auto& one) { return one.second == kByMaterial; };
    const bool back_has_any = std::ranges::any_of(back, is_by_material);
    const bool any_material = back_has_any || std::ranges::any_of(front, is_by_material);
    return any_material && !back.empty() && (front != back || (back_has_any && has_values_of_one_side));
}

// A parameter of both sides' material that the first vertex of a glBegin does not have, but a later one.
bool sets_both_sides_after_vertex(const CommandList& scene) {
    if (!lights_two_sides(scene)) return false;
    std::set<Enum> set;
    bool has_vertex = false;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glBegin) {
            set.clear();
            has_vertex = false;
        }
        if (command.name().starts_with("glVertex")) has_vertex = true;
        if (!command.name().starts_with("glMaterial") || command.enumerant(0) != kGL_FRONT_AND_BACK) continue;
        if (!has_vertex)
            set.insert(command.enumerant(1));
        else if (!set.contains(command.enumerant(1)))
            return true;
    }
    return false;
}

bool sets_color_before_new_mode(const CommandList& scene) {
    bool enabled = false, color = false;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glEnable && command.enumerant(0) == kGL_COLOR_MATERIAL) enabled = true;
        if (enabled && is_one_of(command, {"glColor3", "glColor4"})) color = true;
        if (color && command.id == Id::glColorMaterial) return true;
    }
    return false;
}

// A glMaterial, then a glColor that the material follows, then a glNewList before anything is drawn.
bool tracks_color_before_list(const CommandList& scene) {
    bool material = false, color = false;
    for (const Command& command : scene.commands) {
        if (command.name().starts_with("glMaterial")) material = true;
        if (command.id == Id::glEnd) material = color = false;
        color = color || (material && is_one_of(command, {"glColor3", "glColor4"}));
        if (color && command.id == Id::glNewList) return enables_color_material(scene);
    }
    return false;
}

bool lists_edge_flags(const CommandList& scene) {
    bool in_list = false, flags = false, borders = false;
    for (const Command& command : scene.commands) {
        if (command.id == Id::glNewList || command.id == Id::glEndList) in_list = command.id == Id::glNewList;
        flags = flags || (in_list && command.name().starts_with("glEdgeFlag"));
        borders = borders || (command.id == Id::glPolygonMode && command.enumerant(1) != kGL_FILL);
    }
    return flags && borders;
}

// Where it can be seen: by colours that are no linear function, and where one is drawn again, by depths.
bool shows_cut_of_rectangles(const CommandList& scene) {
    bool lit = false;
    int rectangles = 0;
    for (const Command& command : scene.commands) {
        lit = lit || (command.id == Id::glEnable && command.enumerant(0) == kGL_LIGHTING);
        if (command.name().starts_with("glRect")) ++rectangles;
    }
    return rectangles > 1 || (rectangles > 0 && lit);
}

// ---- Of the state of a Draw ----

bool draws_borders(const Draw& draw) {
    return draw.raster.polygon_mode_front != kGL_FILL || draw.raster.polygon_mode_back != kGL_FILL;
}

bool is_clipped(const Draw& draw) {
    return std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) {
        const glm::dvec4 eye = draw.eye_from_object * vertex.position_object, clip = draw.clip_from_eye * eye;
        for (const auto& plane : draw.raster.clip_planes_eye)
            if (plane && glm::dot(*plane, eye) < 0) return true;
        return std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) > clip.w;
    });
}

bool draws_borders_of_clipped_polygons(const Draw& draw) { return draws_borders(draw) && is_clipped(draw); }

bool is_softpipe() { return driver_name().starts_with("softpipe"); }

bool has_faces_on_borders_in_softpipe(const Draw& draw) {
    return draws_borders(draw) && draw.lighting.enabled && draw.lighting.light_model.two_side && is_softpipe();
}

bool has_wide_lines_in_softpipe(const Draw& draw) {
    const RasterState& raster = draw.raster;
    const bool lines = draw.mode == kGL_LINES || draw.mode == kGL_LINE_STRIP || draw.mode == kGL_LINE_LOOP ||
                       raster.polygon_mode_front == kGL_LINE || raster.polygon_mode_back == kGL_LINE;
    return lines && raster.line_width > 1 && is_softpipe();
}

// Whatever chooses by the level of detail: a mipmap, or one of two filters.
bool has_level_of_detail_in_softpipe(const Draw& draw) {
    const Texture* texture = draw.texture.texture.get();
    return texture && texture->min_filter != texture->mag_filter && is_softpipe();
}

bool has_edge_flags_in_strip(const Draw& draw) {
    const bool strip = draw.mode == kGL_TRIANGLE_STRIP || draw.mode == kGL_TRIANGLE_FAN || draw.mode == kGL_QUAD_STRIP;
    return strip && draws_borders(draw) &&
           std::ranges::any_of(draw.vertices, [](const Vertex& vertex) { return !vertex.edge_flag; });
}

bool is_offset(const PolygonOffset& offset, Enum polygon_mode) {
    return polygon_mode == kGL_FILL ? offset.fill : polygon_mode == kGL_LINE ? offset.line : offset.point;
}

bool offsets_one_of_two_modes(const Draw& draw) {
    const PolygonOffset& offset = draw.raster.polygon_offset;
    return is_offset(offset, draw.raster.polygon_mode_front) != is_offset(offset, draw.raster.polygon_mode_back);
}

bool offsets_borders(const Draw& draw) {
    if (!draw.raster.depth_test) return false;  // which alone shows it
    const auto draws_offset_borders = [&](Enum mode) {
        return mode != kGL_FILL && is_offset(draw.raster.polygon_offset, mode);
    };
    return draws_offset_borders(draw.raster.polygon_mode_front) || draws_offset_borders(draw.raster.polygon_mode_back);
}

struct Corners {
    std::array<glm::dvec3, 3> window;
    double determinant;  // of their unit x, y, w in clip coordinates: 0 where they are on one line through the eye
    double slope;        // m of 3.5.5; infinite where that is
};

// Whether any three corners that a polygon of the Draw may be cut to.
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
            glm::dmat3 xyw(0);
            for (int k = 0; const std::size_t corner : {first, i - 1, i}) {
                const glm::dvec4 clip =
                    draw.clip_from_eye * draw.eye_from_object * draw.vertices[draw.index(corner)].position_object;
                const glm::dvec3 direction(clip.x, clip.y, clip.w);
                xyw[k] = glm::length(direction) > 0 ? glm::normalize(direction) : direction;
                corners.window.at(static_cast<std::size_t>(k++)) = window(clip);
            }
            corners.determinant = glm::determinant(xyw);
            const glm::dvec3 normal =
                glm::cross(corners.window[1] - corners.window[0], corners.window[2] - corners.window[0]);
            const double rise = std::max(std::abs(normal.x), std::abs(normal.y)), area = std::abs(normal.z);
            corners.slope = rise == 0 ? 0 : area == 0 ? HUGE_VAL : rise / area;
            if (are(corners)) return true;
        }
    }
    return false;
}

// A polygon that is seen from its edge has no slope m, but lines and points.
bool offsets_borders_without_area(const Draw& draw) {
    constexpr double kNoArea = 1e-7;
    return offsets_borders(draw) &&
           any_corners(draw, [](const Corners& corners) { return std::abs(corners.determinant) < kNoArea; });
}

bool offsets_borders_out_of_range(const Draw& draw) {
    const PolygonOffset& offset = draw.raster.polygon_offset;
    constexpr double kStep = 0x1p-24, kRounding = 1e-5;  // of the slope
    return offsets_borders(draw) && any_corners(draw, [&](const Corners& corners) {
               const double by = offset.factor * corners.slope + offset.units * kStep;
               const double margin = kRounding * std::abs(by) + 2 * kStep;
               return std::ranges::any_of(corners.window, [&](const glm::dvec3& corner) {
                   return !(corner.z + by > margin && corner.z + by < 1 - margin);
               });
           });
}

bool has_no_q(const Draw& draw, const Vertex& vertex) {
    return draw.texture.texture && (draw.texture.texture_matrix * vertex.tex_coord).w <= 1e-6;
}

bool draws_points(const Draw& draw) {
    return draw.mode == kGL_POINTS || draw.raster.polygon_mode_front == kGL_POINT ||
           draw.raster.polygon_mode_back == kGL_POINT;
}

bool has_wide_points_in_softpipe(const Draw& draw) {
    return draws_points(draw) && draw.raster.point_size > 1 && is_softpipe();
}

bool biases_level_of_points(const Draw& draw) {
    return draws_points(draw) && draw.texture.texture && draw.texture.lod_bias > 0;
}

bool adds_secondary_color_in_fog(const Draw& draw) {
    return draw.fog.enabled && draw.lighting.enabled && draw.lighting.light_model.color_control != kGL_SINGLE_COLOR;
}

bool clamps_between_nearest_and_linear(const Draw& draw) {
    const Texture* texture = draw.texture.texture.get();
    if (!texture || (texture->wrap_s != kGL_CLAMP && texture->wrap_t != kGL_CLAMP)) return false;
    const bool min_nearest = texture->min_filter == kGL_NEAREST || texture->min_filter == kGL_NEAREST_MIPMAP_NEAREST ||
                             texture->min_filter == kGL_NEAREST_MIPMAP_LINEAR;
    return min_nearest != (texture->mag_filter == kGL_NEAREST);
}

// ---- Of lighting ----

glm::dvec3 eye_position(const Draw& draw, const Vertex& vertex) {
    const glm::dvec4 eye = draw.eye_from_object * vertex.position_object;
    return glm::dvec3(eye) / (eye.w == 0 ? 1 : eye.w);
}

glm::dvec3 eye_normal(const Draw& draw, const Vertex& vertex) {
    const glm::dmat3 m = glm::transpose(glm::inverse(glm::dmat3(draw.eye_from_object)));
    return glm::normalize(m * vertex.normal_object);
}

glm::dvec3 toward(const LightSource& light, const glm::dvec3& position_eye) {
    const glm::dvec3 p(light.position_eye);
    return glm::normalize(light.position_eye.w == 0 ? p : p / light.position_eye.w - position_eye);
}

template <class Predicate>
bool any_light(const Draw& draw, Predicate predicate) {
    if (!draw.lighting.enabled) return false;
    return std::any_of(draw.lighting.lights.begin(), draw.lighting.lights.end(),
                       [&](const LightSource& light) { return light.enabled && predicate(light); });
}

// Of either face, whichever vertex has it.
bool any_material(const Draw& draw, const std::function<bool(const Material&, const Material&)>& predicate) {
    if (predicate(draw.lighting.front, draw.lighting.back)) return true;
    return std::ranges::any_of(draw.materials, [&](const Materials& m) { return predicate(m.front, m.back); });
}

bool has_shininess_0_with_factors(const Draw& draw) {
    const bool two_side = draw.lighting.light_model.two_side;
    const bool has_0 = any_material(draw, [&](const Material& front, const Material& back) {
        return front.shininess == 0 || (two_side && back.shininess == 0);
    });
    return has_0 && any_light(draw, [](const LightSource& light) {
               const bool attenuated =
                   light.position_eye.w != 0 && (light.constant_attenuation != 1 || light.linear_attenuation != 0 ||
                                                 light.quadratic_attenuation != 0);
               return attenuated || light.spot_cutoff_deg != 180;
           });
}

bool has_shininess_0_on_one_side(const Draw& draw) {
    return draw.lighting.enabled && draw.lighting.light_model.two_side &&
           any_material(draw, [](const Material& front, const Material& back) {
               return (front.shininess == 0) != (back.shininess == 0);
           });
}

bool has_color_material_of_no_color(const Draw& draw, const Vertex& vertex) {
    return draw.lighting.color_material.enabled && vertex.color == Vertex{}.color;
}

bool has_color_material_on_back_alone(const Draw& draw) {
    const ColorMaterial& color_material = draw.lighting.color_material;
    return draw.lighting.light_model.two_side && color_material.enabled && color_material.face == kGL_BACK &&
           color_material.mode != kGL_EMISSION;
}

bool has_w_under_positional_light(const Draw& draw, const Vertex& vertex) {
    const double w = (draw.eye_from_object * vertex.position_object).w;
    return std::abs(w - 1) > 1e-9 &&
           (draw.lighting.light_model.local_viewer ||
            any_light(draw, [](const LightSource& light) { return light.position_eye.w != 0; }));
}

bool has_w_in_fog(const Draw& draw) {
    return draw.fog.enabled && std::ranges::any_of(draw.vertices, [&](const Vertex& vertex) {
               return std::abs((draw.eye_from_object * vertex.position_object).w - 1) > 1e-9;
           });
}

// The squares of such lengths are 0, subnormal or infinite in floats.
bool leaves_floats(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length < 1e-18 || length > 1e18;
}

bool has_extreme_direction(const Draw& draw, const Vertex& vertex) {
    return draw.lighting.enabled &&
           (leaves_floats(vertex.normal_object) || any_light(draw, [](const LightSource& light) {
                return light.position_eye.w == 0 && leaves_floats(glm::dvec3(light.position_eye));
            }));
}

bool rescales_much(const Draw& draw) {
    if (!draw.lighting.enabled || !draw.lighting.rescale_normal || draw.lighting.normalize) return false;
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(draw.eye_from_object))));
    return scale > 1e5 || scale < 1e-5;
}

bool has_no_answer(const Draw& draw, const Vertex& vertex) {
    const glm::dvec4 eye = draw.eye_from_object * vertex.position_object;
    if (eye.w <= 0) return true;
    if (!draw.lighting.enabled) return false;
    if (vertex.normal_object == glm::dvec3(0) || glm::determinant(glm::dmat3(draw.eye_from_object)) == 0) return true;
    return any_light(draw, [&](const LightSource& light) {
        const glm::dvec3 p(light.position_eye);
        const bool is_here = light.position_eye.w == 0
                                 ? p == glm::dvec3(0)
                                 : glm::length(p / light.position_eye.w - eye_position(draw, vertex)) < 1e-3;
        const double attenuation = light.constant_attenuation + light.linear_attenuation + light.quadratic_attenuation;
        const bool has_axis = light.spot_cutoff_deg == 180 || light.spot_direction_eye != glm::dvec3(0);
        return is_here || !has_axis || (light.position_eye.w != 0 && attenuation == 0);
    });
}

// Float rounding moves a cosine of unit vectors by some 1e-6: nearer than this to a jump, it decides.
constexpr double kJump = 1e-5;

bool is_at_edge_of_cone(const Draw& draw, const Vertex& vertex) {
    return any_light(draw, [&](const LightSource& light) {
        const double cos_angle =
            glm::dot(-toward(light, eye_position(draw, vertex)), glm::normalize(light.spot_direction_eye));
        return light.spot_cutoff_deg != 180 &&
               std::abs(cos_angle - std::cos(light.spot_cutoff_deg * M_PI / 180)) < kJump;
    });
}

// On the axis of a cone of 0 degrees, or at 90 degrees in one of 90: floats have no other answer than the text's.
bool is_at_exact_edge_of_cone(const Draw& draw, const Vertex& vertex) {
    return is_at_edge_of_cone(draw, vertex) && any_light(draw, [&](const LightSource& light) {
               return light.spot_cutoff_deg == 0 || light.spot_cutoff_deg == 90;
           });
}

bool is_near_edge_of_cone(const Draw& draw, const Vertex& vertex) {
    return is_at_edge_of_cone(draw, vertex) && !is_at_exact_edge_of_cone(draw, vertex);
}

bool has_light_at_horizon(const Draw& draw, const Vertex& vertex) {
    return any_light(draw, [&](const LightSource& light) {
        return std::abs(glm::dot(eye_normal(draw, vertex), toward(light, eye_position(draw, vertex)))) < kJump;
    });
}

}  // namespace

const std::vector<Departure>& departures() {
    static const std::vector<Departure> list = {
        // What shaders share comes first: where one of these applies, the others do not matter.
        {.name = "no answer in the text",
         .section = "2.1.1, 2.11.3, 2.14.1: singular matrices, directions of length 0, a vertex without a place, a "
                    "light at it",
         .leaves = Leaves::kOpen,
         .of_vertex = has_no_answer},
        {.name = "light at the horizon of a vertex",
         .section = "2.14.1: f_i jumps at n.VP = 0, and rounding decides",
         .leaves = Leaves::kOpen,
         .of_vertex = has_light_at_horizon},
        {.name = "a vertex on the edge of a spot's cone",
         .section = "2.14.1: lit where the angle is the cutoff: on the axis of a cone of 0, at 90 degrees in one of 90",
         .of_vertex = is_at_exact_edge_of_cone},
        {.name = "vertex near the edge of a spot's cone",
         .section = "2.14.1: spot_i jumps at the cutoff, and rounding decides",
         .leaves = Leaves::kOpen,
         .of_vertex = is_near_edge_of_cone},
        {.name = "texture coordinates whose q is 0",
         .section = "3.8.7: s/q and t/q have no value",
         .leaves = Leaves::kOpen,
         .of_vertex = has_no_q},
        {.name = "clipped polygons as lines and points",
         .section = "2.12, 3.5.4",
         .leaves = Leaves::kDriver,
         .of_draw = draws_borders_of_clipped_polygons},
        {.name = "edge flags of strips and fans",
         .section = "2.6.2",
         .leaves = Leaves::kDriver,
         .of_draw = has_edge_flags_in_strip},
        {.name = "polygon offset of borders without area",
         .section = "3.5.5: m is a slope, which these polygons do not have",
         .leaves = Leaves::kOpen,
         .of_draw = offsets_borders_without_area},
        {.name = "polygon offset of borders that leaves the depth range",
         .section = "3.5.5: fragments' depths are offset and clamped; the driver clamps those of corners",
         .leaves = Leaves::kDriver,
         .of_draw = offsets_borders_out_of_range},
        {.name = "polygon offset of one of two polygon modes",
         .section = "3.5.5",
         .leaves = Leaves::kDriver,
         .of_draw = offsets_one_of_two_modes},
        {.name = "level of detail of points",
         .section = "3.8.8",
         .leaves = Leaves::kDriver,
         .of_draw = biases_level_of_points},
        {.name = "faces of borders in softpipe's shaders",
         .section = "GLSL 1.20, 7.2: gl_FrontFacing is that of the primitive; docs/architecture.md",
         .leaves = Leaves::kDriver,
         .of_draw = has_faces_on_borders_in_softpipe,
         .only_on = "softpipe"},
        {.name = "wide lines in softpipe",
         .section = "3.4.2: a wide line ends where the thin one does; softpipe's is half a pixel further along",
         .leaves = Leaves::kDriver,
         .of_draw = has_wide_lines_in_softpipe,
         .only_on = "softpipe"},
        {.name = "wide points in softpipe",
         .section = "3.3: a square of a whole number of pixels about a corner or a centre; softpipe's is as it falls",
         .leaves = Leaves::kDriver,
         .of_draw = has_wide_points_in_softpipe,
         .only_on = "softpipe"},
        {.name = "level of detail in softpipe",
         .section = "3.8.8: rho may be as small as the larger of m_u and m_v; the reference's freedom is not as wide",
         .leaves = Leaves::kOpen,
         .of_draw = has_level_of_detail_in_softpipe,
         .only_on = "softpipe"},
        {.name = "the colour sum in fog", .section = "3.9, 3.10", .of_draw = adds_secondary_color_in_fog},
        {.name = "GL_CLAMP between a nearest and a linear filter",
         .section = "3.8.7, 3.8.8",
         .leaves = Leaves::kDriver,
         .of_draw = clamps_between_nearest_and_linear},
        {.name = "shininess 0 with attenuation or a spot",
         .section = "2.14.1: a factor of 1; the driver gives (n.VP)^(n.VP)",
         .of_draw = has_shininess_0_with_factors},
        {.name = "shininess 0 on one side of two",
         .section = "2.14.1: a factor of 1 on that side whatever the other has",
         .of_draw = has_shininess_0_on_one_side},
        {.name = "colour material before the first glColor",
         .section = "2.14.3: the material follows the current colour from glEnable on",
         .of_vertex = has_color_material_of_no_color},
        {.name = "glMaterial, a tracked glColor, glNewList",
         .section = "2.14.3: the material follows the colour",
         .of_commands = tracks_color_before_list},
        {.name = "colour material on the back alone of two sides",
         .section =
             "2.14.3: all channels of the back's material follow; the driver's program multiplies the red one only",
         .of_draw = has_color_material_on_back_alone},
        {.name = "materials of vertices that two sides do not share",
         .section = "2.14.2: glMaterial between glBegin and glEnd changes all channels of the side that it names",
         .of_commands = sets_sides_apart},
        {.name = "glMaterial of two sides after a vertex",
         .section = "2.6, 2.14.2: the vertices before it in the same glBegin have the material that each side had",
         .of_commands = sets_both_sides_after_vertex},
        {.name = "glColor before a new glColorMaterial",
         .section = "2.14.3",
         .of_commands = sets_color_before_new_mode},
        {.name = "colour material after glPopAttrib", .section = "2.14.3", .of_commands = restores_tracked_color},
        {.name = "glColor3 after glColor4", .section = "2.7", .of_commands = mixes_glcolor3_and_4},
        {.name = "glTexCoord1 to 3 after glTexCoord4", .section = "2.7", .of_commands = mixes_tex_coords},
        {.name = "glMaterial right before glPopAttrib", .section = "6.1.14", .of_commands = sets_material_before_pop},
        {.name = "edge flags in a display list",
         .section = "5.4, 2.6.2: a list draws what its commands draw",
         .of_commands = lists_edge_flags},
        {.name = "glRect as a quadrilateral",
         .section = "2.10: glRect is a GL_POLYGON",
         .of_commands = shows_cut_of_rectangles},
        {.name = "glShadeModel after glPopAttrib in a display list",
         .section = "5.4: a list holds every command that may be compiled",
         .of_commands = shades_after_pop_in_list},
        {.name = "lights after glPopAttrib of GL_ENABLE_BIT",
         .section = "6.2, table 6.10",
         .of_commands = switches_lights_before_pop},
        {.name = "GL_GENERATE_MIPMAP after glPopAttrib",
         .section = "6.2, table 6.17",
         .of_commands = generates_mipmaps_after_pop},
        {.name = "a vertex whose w is not 1 under a positional light",
         .section = "2.14.1: P1P2 is homogeneous",
         .of_vertex = has_w_under_positional_light},
        {.name = "fog of a vertex whose w is not 1", .section = "3.10", .of_draw = has_w_in_fog},
        {.name = "a direction whose square leaves the floats",
         .section = "2.14.1, 2.1.1: positions and normals up to 2^32 are representable, and unit vectors have length 1",
         .of_vertex = has_extreme_direction},
        {.name = "rescaling under a great scale", .section = "2.11.3", .of_draw = rescales_much},
    };
    return list;
}

LeftOut::LeftOut(const CommandList& scene, const std::vector<std::string_view>& lifted) {
    for (const Departure& departure : departures()) {
        if (std::ranges::find(lifted, departure.name) != lifted.end()) continue;
        if (departure.of_draw || departure.of_vertex) asked_.push_back(&departure);
        if (!of_all_ && departure.of_commands && departure.of_commands(scene)) of_all_ = &departure;
    }
}

const Departure* LeftOut::find(const std::function<bool(const Departure&)>& applies) const {
    const Departure* found = of_all_;
    for (const Departure* departure : asked_) {
        if (found && departure->leaves == Leaves::kFixedFunction) continue;
        if (applies(*departure)) {
            if (departure->leaves != Leaves::kFixedFunction) return departure;
            found = departure;
        }
    }
    return found;
}

const Departure* LeftOut::at(const Draw& draw, const Vertex& vertex) const {
    return find([&](const Departure& departure) {
        return departure.of_draw ? departure.of_draw(draw) : departure.of_vertex(draw, vertex);
    });
}

namespace {

bool applies_in(const Departure& departure, const Frame& frame) {
    return std::ranges::any_of(frame.items, [&](const auto& item) {
        const Draw* draw = std::get_if<Draw>(&item);
        if (!draw) return false;
        if (departure.of_draw) return departure.of_draw(*draw);
        return std::ranges::any_of(draw->vertices,
                                   [&](const Vertex& vertex) { return departure.of_vertex(*draw, vertex); });
    });
}

}  // namespace

const Departure* LeftOut::in(const Frame& frame) const {
    return find([&](const Departure& departure) { return applies_in(departure, frame); });
}

std::vector<const Departure*> departures_in(const Frame& frame) {
    constexpr std::size_t kMostCommands = 1'000'000;
    CommandList scene;
    if (frame.commands) {
        frame.commands->for_each([&](const Step& step) {
            if (step.kind == Step::Kind::kCommand) scene.commands.push_back(step.command);
            return scene.commands.size() < kMostCommands;
        });
    }
    std::vector<const Departure*> found;
    for (const Departure& departure : departures()) {
        if (departure.leaves == Leaves::kOpen) continue;
        if (departure.of_commands ? departure.of_commands(scene) : applies_in(departure, frame))
            found.push_back(&departure);
    }
    return found;
}

}  // namespace twinlight::fuzz
