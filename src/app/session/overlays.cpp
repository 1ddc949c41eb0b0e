#include "app/session/overlays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <set>
#include <span>

#include "base/text/translation.h"
#include "render/reference/geometry/primitive_assembly.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::session {
namespace {

using reference::Primitive;
using reference::Shape;
using reference::StageVertex;

constexpr glm::vec4 kWire{1, 1, 1, 1};
constexpr glm::vec4 kUnitNormal{0.35F, 0.9F, 0.5F, 0.9F};
constexpr glm::vec4 kOtherNormal{1, 0.35F, 0.3F, 1};
constexpr glm::vec4 kProvoking{1, 0.75F, 0.2F, 0.85F};
constexpr glm::vec4 kBackFace{0.25F, 0.5F, 1, 0.55F};
constexpr glm::vec3 kAboveOne{1, 0, 0.75F};
constexpr double kFinePixels = 12;  // between the points that are lit
constexpr int kMostParts = 40;      // of an edge

constexpr double kNormalShare = 1.0 / 30;               // of the scene's radius
constexpr double kLongestNormal = 4;                    // longer ones are cut
constexpr double kUnitTolerance = 0.005;                // what a reader of two digits would call 1
constexpr float kCornerShare = 0.3F;                    // of an edge
constexpr double kLineHeight = 18, kLetterWidth = 7.5;  // of labels, in pixels
constexpr double kSamePlace = 12;                       // for labels with the same text: in pixels

// The box around a shape's points in eye space.
struct Bounds {
    glm::dvec3 least{std::numeric_limits<double>::infinity()}, most{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec4& position_eye) {
        const glm::dvec3 point = glm::dvec3(position_eye) / position_eye.w;
        if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) return;
        least = glm::min(least, point);
        most = glm::max(most, point);
    }
    void add(const Bounds& other) {
        least = glm::min(least, other.least);
        most = glm::max(most, other.most);
    }
    bool is_empty() const { return !(least.x <= most.x); }
    glm::dvec3 middle() const { return (least + most) / 2.0; }
    double radius() const { return is_empty() ? 1 : glm::length(most - least) / 2; }
};

// 2.14.1: the sign of the area in window coordinates. This form also holds for a triangle that reaches behind the eye.
bool faces_back(const Draw& draw, const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
    const double area =
        glm::determinant(glm::dmat3(glm::dvec3(a.x, a.y, a.w), glm::dvec3(b.x, b.y, b.w), glm::dvec3(c.x, c.y, c.w)));
    return draw.raster.front_face == kGL_CCW ? area < 0 : area > 0;
}

bool is_culled(const RasterState& raster, bool back) {
    return raster.cull_enabled &&
           (raster.cull_face == kGL_FRONT_AND_BACK || raster.cull_face == (back ? kGL_BACK : kGL_FRONT));
}

glm::vec4 mix(const glm::vec4& a, const glm::vec4& b, float share) { return a + share * (b - a); }

// The part of the overlays that belongs to one Draw.
class OverlayWriter {
  public:
    OverlayWriter(const Draw& draw, const std::vector<StageVertex>& vertices, DrawOverlay& out)
        : draw_(draw),
          vertices_(vertices),
          primitives_(reference::assemble(draw, reference::QuadCut::kFirstToThird)),
          out_(out) {}

    // The triangles that culling leaves, and the lines and points.
    void surface(bool wireframe) {
        const bool filled = draw_.draws_polygons_as(kGL_FILL);
        out_.hides = filled && draw_.raster.depth_test && draw_.raster.depth_mask && !draw_.fragment.blend;
        for (const Primitive& primitive : primitives_) {
            if (primitive.shape == Shape::kTriangle) {
                if (is_culled(draw_.raster, is_back(primitive))) continue;
                for (std::size_t i = 0; i < 3; ++i) {
                    out_.faces_clip.push_back(clip(primitive.vertices[i]));
                    out_.edges.push_back(primitive.boundary[i] ? 1 : 0);
                }
            } else if (wireframe && primitive.shape == Shape::kLine) {
                for (std::size_t i = 0; i < 2; ++i) out_.lines.push_back({clip(primitive.vertices[i]), kWire});
            } else if (wireframe && primitive.shape == Shape::kPoint) {
                out_.points.push_back({clip(primitive.vertices[0]), kWire});
            }
        }
    }

    void normals(double scene_radius, double& shortest, double& longest) {
        const double share = kNormalShare * scene_radius;
        for (const std::uint32_t i : used_vertices()) {
            const StageVertex& vertex = vertices_[i];
            const double length = glm::length(vertex.normal_eye);
            if (!std::isfinite(length) || vertex.position_eye.w == 0) continue;
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
            const glm::dvec3 shown = vertex.normal_eye * (share * std::min(1.0, kLongestNormal / length));
            const glm::dvec4 tip_eye = vertex.position_eye + glm::dvec4(shown * vertex.position_eye.w, 0);
            const glm::vec4 color = std::abs(length - 1) <= kUnitTolerance ? kUnitNormal : kOtherNormal;
            out_.lines.push_back({clip(i), color});
            out_.lines.push_back({glm::vec4(draw_.clip_from_eye * tip_eye), color});
        }
    }

    void provoking_vertices() {
        for (const Primitive& primitive : primitives_) {
            if (primitive.shape != Shape::kTriangle) {
                out_.points.push_back({clip(primitive.provoking), kProvoking});
                continue;
            }
            if (is_culled(draw_.raster, is_back(primitive))) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                if (primitive.vertices[i] != primitive.provoking) continue;
                const glm::vec4 corner = clip(primitive.vertices[i]);
                for (const glm::vec4& position :
                     {corner, mix(corner, clip(primitive.vertices[(i + 1) % 3]), kCornerShare),
                      mix(corner, clip(primitive.vertices[(i + 2) % 3]), kCornerShare)})
                    out_.marks.push_back({position, kProvoking});
                break;
            }
        }
    }

    void back_faces() {
        for (const Primitive& primitive : primitives_) {
            if (primitive.shape != Shape::kTriangle || !is_back(primitive) || is_culled(draw_.raster, true)) continue;
            for (const std::uint32_t i : primitive.vertices) out_.tints.push_back({clip(i), kBackFace});
        }
    }

    // Half the largest channel before the clamp, at each vertex.
    void above_one(const Look& look) {
        reference::Options options;
        static_cast<Look&>(options) = look;
        const bool per_pixel = lights_every_pixel(look.shading);
        const Draw fine = per_pixel ? subdivided() : Draw{};
        const Draw& draw = per_pixel ? fine : draw_;
        const std::vector<reference::LitVertex> lit = reference::light_vertices(draw, options, false);
        const auto vertex = [&](std::uint32_t i, bool back) {
            const glm::dvec4& primary = back ? lit[i].back_primary : lit[i].front_primary;
            const glm::dvec4& secondary = back ? lit[i].back_secondary : lit[i].front_secondary;
            const double most = std::max({primary.r, primary.g, primary.b, secondary.r, secondary.g, secondary.b});
            const auto half = static_cast<float>(std::clamp(most / 2, 0.0, 1.0));
            return OverlayVertex{glm::vec4(lit[i].position_clip), glm::vec4(kAboveOne, half)};
        };
        // Rounding of the sums is no excess.
        const auto exceeds = [](const OverlayVertex& v) { return v.color.a > 0.5F + 1e-6F; };
        for (const Primitive& primitive : reference::assemble(draw, reference::QuadCut::kFirstToThird)) {
            if (primitive.shape != Shape::kTriangle) {
                const OverlayVertex mark = vertex(primitive.vertices[0], false);
                if (exceeds(mark)) out_.point_brightness.push_back(mark);
                continue;
            }
            const auto at = [&](std::size_t i) { return lit[primitive.vertices[i]].position_clip; };
            const bool back = faces_back(draw, at(0), at(1), at(2));
            if (is_culled(draw.raster, back)) continue;
            std::array<OverlayVertex, 3> corners{};
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = vertex(primitive.vertices[i], back && draw.lighting.light_model.two_side);
            if (std::ranges::any_of(corners, exceeds))
                out_.brightness.insert(out_.brightness.end(), corners.begin(), corners.end());
        }
    }

  private:
    glm::vec4 clip(std::uint32_t i) const { return glm::vec4(vertices_[i].position_clip); }
    bool is_back(const Primitive& p) const {
        return faces_back(draw_, vertices_[p.vertices[0]].position_clip, vertices_[p.vertices[1]].position_clip,
                          vertices_[p.vertices[2]].position_clip);
    }
    // The triangles as a mesh so fine that colours between its vertices are nearly linear. Lighting per pixel scales
    // normals to length 1.
    Draw subdivided() const {
        Draw fine = draw_;
        fine.mode = kGL_TRIANGLES;
        fine.lighting.normalize = true;
        fine.indices = {};
        std::vector<Vertex> vertices;
        for (const Primitive& primitive : primitives_) {
            if (primitive.shape != Shape::kTriangle) continue;
            const auto corner = [&](std::size_t i) -> const Vertex& {
                return draw_.vertices[primitive.vertices[i % 3]];
            };
            double longest = 0;
            for (std::size_t i = 0; i < 3; ++i)
                longest = std::max(longest,
                                   glm::distance(place(primitive.vertices[i]), place(primitive.vertices[(i + 1) % 3])));
            const int parts =
                std::clamp(static_cast<int>(std::min(longest / kFinePixels, 1.0 * kMostParts)), 1, kMostParts);
            const auto vertex = [&](int i, int j) {  // weights (n - i - j, i, j) / n
                const double b = 1.0 * i / parts, c = 1.0 * j / parts, a = 1 - b - c;
                Vertex result = corner(0);
                const auto between = [&](auto member) {
                    result.*member = a * corner(0).*member + b * corner(1).*member + c * corner(2).*member;
                };
                between(&Vertex::position_object);
                between(&Vertex::normal_object);
                between(&Vertex::color);
                return result;
            };
            for (int i = 0; i < parts; ++i) {
                for (int j = 0; j < parts - i; ++j) {
                    vertices.insert(vertices.end(), {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
                    if (i + j + 2 <= parts)
                        vertices.insert(vertices.end(), {vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
                }
            }
        }
        fine.vertices = std::move(vertices);
        return fine;
    }
    // In pixels; far away for a vertex behind the eye.
    glm::dvec2 place(std::uint32_t i) const {
        const glm::dvec4& p = vertices_[i].position_clip;
        if (!(p.w > 0)) return glm::dvec2(1e6);
        const glm::dvec2 size(draw_.raster.viewport.width, draw_.raster.viewport.height);
        return glm::clamp(glm::dvec2(p) / p.w, -2.0, 2.0) / 2.0 * size;
    }
    std::set<std::uint32_t> used_vertices() const {
        std::set<std::uint32_t> used;
        for (std::size_t i = 0; i < draw_.count(); ++i) used.insert(draw_.index(i));
        return used;
    }

    const Draw& draw_;
    const std::vector<StageVertex>& vertices_;
    const std::vector<Primitive> primitives_;
    DrawOverlay& out_;
};

// "0, 2 to 4"
std::string runs(const std::set<int>& numbers) {
    std::string text;
    for (auto first = numbers.begin(); first != numbers.end();) {
        auto last = first;
        int count = 1;
        for (auto next = std::next(last); next != numbers.end() && *next == *last + 1; ++next, ++count) last = next;
        if (count == 2) last = first;
        text += (text.empty() ? "" : ", ") + std::to_string(*first);
        if (last != first) text += tr(" to {}", *last);
        first = std::next(last);
    }
    return text;
}

// "lights 0, 2; not 1": those that are on and count, and those that are on and do not.
std::string lights_text(std::span<const Draw* const> shape, const PlanOptions& options) {
    std::set<int> kept, left_out;
    for (const Draw* draw : shape) {
        for (const LightBound& light : plan_effects(*draw, options).light_bounds) {
            if (light.in() || light.fate == LightFate::kAmbientOnly)
                kept.insert(light.number);
            else if (light.fate != LightFate::kDisabled)
                left_out.insert(light.number);
        }
    }
    for (const int number : kept) left_out.erase(number);
    const std::string others = left_out.empty() ? "" : tr("; not {}", runs(left_out));
    if (kept.empty()) return tr("no light") + others;
    return (kept.size() == 1 ? tr("light {}", runs(kept)) : tr("lights {}", runs(kept))) + others;
}

std::string normals_text(double shortest, double longest) {
    const std::string from = fmt::format("{:.2g}", shortest), to = fmt::format("{:.2g}", longest);
    return from == to ? tr("normals {} long", from) : tr("normals {} to {} long", from, to);
}

// In pixels from the top left; outside the picture for a point behind the eye.
glm::dvec2 place_of(const Draw& draw, const Frame& frame, const glm::dvec3& point_eye) {
    const glm::dvec4 clip = draw.clip_from_eye * glm::dvec4(point_eye, 1);
    if (!(clip.w > 0)) return {-1, -1};
    const Rectangle& viewport = draw.raster.viewport;
    return {viewport.x + (clip.x / clip.w + 1) / 2 * viewport.width,
            frame.height - (viewport.y + (clip.y / clip.w + 1) / 2 * viewport.height)};
}

// Labels that would cover each other move down; equal ones at one place are one.
void add_label(const Frame& frame, OverlayPicture& picture, Label label) {
    if (label.place.x < 0 || label.place.y < 0 || label.place.x >= frame.width || label.place.y >= frame.height) return;
    const auto covers = [&](const Label& other) {
        const double width = kLetterWidth * static_cast<double>(label.text.size() + other.text.size()) / 2;
        return std::abs(label.place.x - other.place.x) < width && std::abs(label.place.y - other.place.y) < kLineHeight;
    };
    const auto repeats = [&](const Label& other) {
        return other.text == label.text && glm::distance(other.place, label.place) < kSamePlace;
    };
    if (std::ranges::any_of(picture.labels, repeats)) return;
    for (auto other = std::ranges::find_if(picture.labels, covers); other != picture.labels.end();
         other = std::ranges::find_if(picture.labels, covers))
        label.place.y = other->place.y + kLineHeight;
    picture.labels.push_back(std::move(label));
}

glm::vec4 background_of(const Frame& frame) {
    for (const auto& item : frame.items)
        if (const Clear* clear = std::get_if<Clear>(&item); clear && clear->color)
            return glm::vec4(glm::clamp(clear->clear_color, 0.0, 1.0));
    return {0, 0, 0, 1};
}

}  // namespace

bool any(const Overlays& overlays) { return overlays != Overlays{}; }

OverlayPicture overlays_of(const Frame& frame, const Overlays& overlays, const PlanOptions& plan_options) {
    OverlayPicture picture{.wireframe = overlays.wireframe, .background = background_of(frame)};
    const std::vector<const Draw*> draws = frame.draws();
    std::vector<std::vector<StageVertex>> stages;
    std::vector<Bounds> bounds(draws.size());
    Bounds all;
    const bool any_lit = std::ranges::any_of(draws, [](const Draw* draw) { return draw->lighting.enabled; });
    for (std::size_t d = 0; d < draws.size(); ++d) {
        stages.push_back(reference::vertex_stage(*draws[d]));
        for (const StageVertex& vertex : stages[d]) bounds[d].add(vertex.position_eye);
        all.add(bounds[d]);
    }

    for (std::size_t first = 0, next = 0; first < draws.size(); first = next) {
        double shortest = std::numeric_limits<double>::infinity(), longest = 0;
        Bounds shape;
        do {
            const Draw& draw = *draws[next];
            DrawOverlay overlay{.viewport = draw.raster.viewport,
                                .depth_near = draw.raster.depth_near,
                                .depth_far = draw.raster.depth_far};
            OverlayWriter writer(draw, stages[next], overlay);
            writer.surface(overlays.wireframe != Wireframe::kOff);
            if (overlays.back_faces) writer.back_faces();
            if (overlays.above_one) writer.above_one(plan_options);
            if (overlays.provoking_vertices) writer.provoking_vertices();
            if (overlays.normals && (draw.lighting.enabled || !any_lit))
                writer.normals(all.radius(), shortest, longest);
            picture.draws.push_back(std::move(overlay));
            shape.add(bounds[next]);
        } while (++next < draws.size() && are_one_shape(*draws[next - 1], *draws[next]));

        const Draw& draw = *draws[first];
        if (shape.is_empty() || !draw.lighting.enabled) continue;
        const glm::dvec2 place = place_of(draw, frame, shape.middle());
        if (overlays.kept_lights)
            add_label(frame, picture,
                      {place, lights_text(std::span(draws).subspan(first, next - first), plan_options)});
        const bool all_unit = shortest >= 1 - kUnitTolerance && longest <= 1 + kUnitTolerance;
        if (overlays.normals && !all_unit && longest >= shortest)
            add_label(frame, picture, {place, normals_text(shortest, longest), true});
    }
    return picture;
}

}  // namespace twinlight::session
