// Rules about the normals of faces that meet: those on the wrong side of the surface, and one normal for faces in many directions.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/text/translation.h"
#include "judge/lint/seen.h"

namespace twinlight::lint {

namespace {

constexpr double kClear = 0.7;  // the cosine between a face and a normal that is certainly on one of its sides

// A triangle of a surface that several Draws may make.
struct SurfaceFace {
    TriangleNumber number;
    const Draw* draw = nullptr;
    std::uint32_t vertex = 0;  // its first
    std::array<glm::dvec3, 3> corners_eye{};
    glm::dvec3 plane_eye{0};   // of length 1, by the order of the vertices
    glm::dvec3 normal_eye{0};  // of length 1: the mean of its vertices' normals
    glm::dvec4 center_clip{0};

    double cosine() const { return glm::dot(plane_eye, normal_eye); }
    glm::dvec3 center_eye() const { return (corners_eye[0] + corners_eye[1] + corners_eye[2]) / 3.0; }
};

// The faces of all Draws with one modelview matrix: the parts of an object meet, whatever their glBegin.
std::vector<std::vector<SurfaceFace>> faces_by_matrix(const Frame& frame) {
    std::map<std::array<double, 16>, std::vector<SurfaceFace>> all;
    const std::vector<const Draw*> draws = frame.draws();
    for (std::size_t d = 0; d < draws.size(); ++d) {
        const Draw& draw = *draws[d];
        if (!draws_polygons(draw.mode) || draw.draws_borders() || draw.surfaces || !uses_normals(draw) ||
            is_flattened(draw))
            continue;
        std::array<double, 16> matrix;
        std::copy_n(&draw.eye_from_object[0][0], 16, matrix.begin());
        std::vector<SurfaceFace>& faces = all[matrix];
        const std::vector<reference::StageVertex> vertices = reference::vertex_stage(draw);
        const std::vector<Triangle> triangles = triangles_of(draw);
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            if (!has_direction(draw, triangles[t])) continue;
            SurfaceFace face{.number = {d, t}, .draw = &draw, .vertex = triangles[t][0]};
            bool is_finite = true;
            for (std::size_t i = 0; i < 3; ++i) {
                const reference::StageVertex& vertex = vertices[triangles[t][i]];
                is_finite &= vertex.position_eye.w != 0 && std::isfinite(glm::length(vertex.position_eye));
                face.corners_eye[i] = glm::dvec3(vertex.position_eye) / vertex.position_eye.w;
                face.normal_eye += vertex.normal_eye;
                face.center_clip += vertex.position_clip / 3.0;
            }
            const auto& p = face.corners_eye;
            face.plane_eye = glm::cross(p[1] - p[0], p[2] - p[0]);
            if (!is_finite || !(glm::length(face.plane_eye) > 0) || !(glm::length(face.normal_eye) > 0)) continue;
            face.plane_eye = glm::normalize(face.plane_eye);
            face.normal_eye = glm::normalize(face.normal_eye);
            faces.push_back(face);
        }
    }
    std::vector<std::vector<SurfaceFace>> result;
    for (auto& [matrix, faces] : all) result.push_back(std::move(faces));
    return result;
}

// ---- Which faces meet ----

// The corners' numbers; corners at one place, but for rounding, have the same.
std::vector<std::array<int, 3>> joined_corners(const std::vector<SurfaceFace>& faces) {
    double size = 0;
    for (const SurfaceFace& face : faces)
        for (const glm::dvec3& p : face.corners_eye) size = std::max(size, glm::length(p));
    const double rounding = 1e-5 * size;
    std::map<std::tuple<long, long, long>, int> numbers;
    std::vector<std::array<int, 3>> corners(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 p = faces[f].corners_eye[i] / rounding;
            corners[f][i] = numbers
                                .try_emplace({std::lround(p.x), std::lround(p.y), std::lround(p.z)},
                                             static_cast<int>(numbers.size()))
                                .first->second;
        }
    }
    return corners;
}

// Two faces at an edge that no third has.
struct Neighbour {
    std::size_t face;
    bool has_same_order;  // as seen from one side of the surface: both clockwise, or both counter-clockwise
};

std::vector<std::vector<Neighbour>> neighbours_of(const std::vector<SurfaceFace>& faces) {
    const std::vector<std::array<int, 3>> corners = joined_corners(faces);
    struct Use {
        std::size_t face;
        bool is_forward;
    };
    std::map<std::pair<int, int>, std::vector<Use>> edges;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto& c = corners[f];
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = c[i], to = c[(i + 1) % 3];
            edges[std::minmax(from, to)].push_back({f, from < to});
        }
    }
    std::vector<std::vector<Neighbour>> neighbours(faces.size());
    for (const auto& [edge, uses] : edges) {
        if (uses.size() != 2) continue;
        const bool has_same_order = uses[0].is_forward != uses[1].is_forward;
        neighbours[uses[0].face].push_back({uses[1].face, has_same_order});
        neighbours[uses[1].face].push_back({uses[0].face, has_same_order});
    }
    return neighbours;
}

// A connected surface: its faces, and for each whether its vertices' order is that of the first, seen from one side.
struct Surface {
    std::vector<std::pair<std::size_t, bool>> faces;
    bool has_two_sides = true;  // not so for a Moebius strip
};

std::vector<Surface> surfaces_of(const std::vector<SurfaceFace>& faces) {
    const std::vector<std::vector<Neighbour>> neighbours = neighbours_of(faces);
    std::vector<std::optional<bool>> order(faces.size());
    std::vector<Surface> surfaces;
    for (std::size_t first = 0; first < faces.size(); ++first) {
        if (order[first]) continue;
        Surface surface{.faces = {{first, true}}};
        order[first] = true;
        for (std::size_t i = 0; i < surface.faces.size(); ++i) {
            const auto [face, is_same] = surface.faces[i];
            for (const Neighbour& next : neighbours[face]) {
                const bool is_next_same = is_same == next.has_same_order;
                if (!order[next.face]) {
                    order[next.face] = is_next_same;
                    surface.faces.emplace_back(next.face, is_next_same);
                } else if (*order[next.face] != is_next_same) {
                    surface.has_two_sides = false;
                }
            }
        }
        surfaces.push_back(std::move(surface));
    }
    return surfaces;
}

// ---- The rules ----

std::string printed(const glm::dvec3& v) {
    const auto rounded = [](double x) { return std::round(x * 1000) / 1000 + 0.0; };  // + 0: without a sign of 0
    return fmt::format("{:.3g}, {:.3g}, {:.3g}", rounded(v.x), rounded(v.y), rounded(v.z));
}

// The normal of a face's plane in object coordinates, of length 1, on the side that its vertices' normals point to.
glm::dvec3 plane_object(const SurfaceFace& face) {
    const Draw& draw = *face.draw;
    const Triangle triangle = triangles_of(draw)[face.number.triangle];
    std::array<glm::dvec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = glm::dvec3(draw.vertices[triangle[i]].position_object);
    const glm::dvec3 plane = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    return glm::dot(plane, draw.vertices[face.vertex].normal_object) < 0 ? -plane : plane;
}

enum class Seen : std::uint8_t { kGrazing, kFromItsNormals, kFromBehind };

// From which side the viewer sees a face: the one that its normals point to, or the other. GL may turn the normals of back faces
// (2.14.1).
Seen side_seen(const SurfaceFace& face) {
    constexpr double kGrazing = 0.1;
    glm::dvec3 to_eye = to_viewer(*face.draw, face.center_eye());
    if (glm::length(to_eye) == 0) return Seen::kGrazing;
    to_eye = glm::normalize(to_eye);
    const double plane = glm::dot(face.plane_eye, to_eye);
    // A projection that looks along z shows the other side, but keeps the vertices' order in the window.
    const glm::dmat4& projection = face.draw->clip_from_eye;
    const bool looks_along_z = projection[2][3] == 0 && projection[2][2] > 0;
    const bool is_front = ((plane > 0) != looks_along_z) == (face.draw->raster.front_face == kGL_CCW);
    const double turn = face.draw->lighting.light_model.two_side && !is_front ? -1 : 1;
    const double normal = turn * glm::dot(face.normal_eye, to_eye), side = turn * plane * face.cosine();
    if (side > 0 && normal > kGrazing) return Seen::kFromItsNormals;
    return side < 0 && normal < -kGrazing ? Seen::kFromBehind : Seen::kGrazing;
}

// On a surface, some normals are on one side and some on the other; and in the picture, the one kind shows its lit side, the other
// its unlit one.
class TurnedNormals : public Watch {
    void finish(const Frame& frame, bool) override {
        constexpr std::size_t kMost = 300'000;  // faces: else it takes seconds
        std::optional<SeenPoints> seen;
        for (const std::vector<SurfaceFace>& faces : faces_by_matrix(frame)) {
            if (faces.size() > kMost) continue;
            for (const Surface& surface : surfaces_of(faces)) {
                if (!surface.has_two_sides) continue;
                Side sides[2];
                for (const auto& [number, is_same] : surface.faces) {
                    const SurfaceFace& face = faces[number];
                    const double cosine = is_same ? face.cosine() : -face.cosine();
                    if (std::abs(cosine) < kClear) continue;
                    Side& side = sides[cosine > 0 ? 0 : 1];
                    switch (side_seen(face)) {
                        case Seen::kGrazing: break;
                        case Seen::kFromItsNormals: side.toward.push_back(&face); break;
                        case Seen::kFromBehind: side.away.push_back(&face); break;
                    }
                }
                for (const bool is_second : {false, true}) {
                    const Side &turned = sides[is_second ? 1 : 0], &other = sides[is_second ? 0 : 1];
                    if (turned.away.empty() || other.toward.empty()) continue;
                    if (!seen) seen.emplace(frame);
                    const SurfaceFace* away = first_shown(turned.away, *seen);
                    if (away && first_shown(other.toward, *seen) && !first_shown(other.away, *seen)) report(*away);
                }
            }
        }
    }

    struct Side {
        std::vector<const SurfaceFace*> toward, away;  // the viewer
    };
    static const SurfaceFace* first_shown(const std::vector<const SurfaceFace*>& faces, const SeenPoints& seen) {
        constexpr std::size_t kTries = 200;
        const std::size_t step = faces.size() / kTries + 1;
        for (std::size_t i = 0; i < faces.size(); i += step)
            if (seen.shows(faces[i]->number, faces[i]->center_clip)) return faces[i];
        return nullptr;
    }
    void report(const SurfaceFace& face) {
        const glm::dvec3 normal = face.draw->vertices[face.vertex].normal_object;
        warn({.place = face.draw->place,
              .message = tr("some normals, such as ({}), point to the back of the surface, unlike those of "
                            "the faces beside them, so the side that is seen is lit from behind",
                            printed(normal)),
              .fix = tr("turn these normals around: this one to glNormal3f({})", printed(-plane_object(face))),
              .key = "turned"});
    }
};

// Faces in many directions that all have one normal.
class OneNormal : public Watch {
    void finish(const Frame& frame, bool) override {
        for (const std::vector<SurfaceFace>& faces : faces_by_matrix(frame)) {
            std::map<std::tuple<std::shared_ptr<const std::string>, int, int>, std::vector<const SurfaceFace*>> objects;
            for (const SurfaceFace& face : faces) {
                const Place& place = face.draw->place;
                objects[{place.file, place.line, place.column}].push_back(&face);
            }
            for (const auto& [place, object] : objects)
                if (has_one_normal(object) && has_many_directions(object)) report(*object.front());
        }
    }

    static bool has_one_normal(const std::vector<const SurfaceFace*>& object) {
        const glm::dvec3& normal = object.front()->draw->vertices.front().normal_object;
        const Draw* last = nullptr;
        for (const SurfaceFace* face : object) {
            if (face->draw == last) continue;
            last = face->draw;
            if (!std::ranges::all_of(last->vertices, [&](const Vertex& v) { return v.normal_object == normal; }))
                return false;
        }
        return true;
    }
    // Whether two faces have more than 45 degrees between them, whatever the order of their vertices, and so have most.
    static bool has_many_directions(const std::vector<const SurfaceFace*>& object) {
        const auto differ = [](const SurfaceFace* a, const SurfaceFace* b) {
            return std::abs(glm::dot(a->plane_eye, b->plane_eye)) < kClear;
        };
        std::vector<const SurfaceFace*> directions;
        for (const SurfaceFace* face : object) {
            constexpr std::size_t kEnough = 20;
            if (std::ranges::any_of(directions, [&](const SurfaceFace* known) { return differ(known, face); }))
                return true;
            if (directions.size() < kEnough) directions.push_back(face);
        }
        return false;
    }
    void report(const SurfaceFace& face) {
        const Draw& draw = *face.draw;
        const glm::dvec3 normal = draw.vertices[face.vertex].normal_object;
        warn({.place = draw.place,
              .message = tr("all faces of this object have the normal ({}), although they face different ways: they "
                            "all get the same light",
                            printed(normal)),
              .fix = tr("call glNormal before each face, such as glNormal3f({}); for the first",
                        printed(plane_object(face))),
              .key = "one"});
    }
};

}  // namespace

std::vector<Rule> turned_normals_rules() {
    static const std::vector<std::string_view> kNormalRules = {"normal-missing", "normal-stale", "normal-array-off",
                                                               "scale-zero", "winding-against-normals"};
    return {
        {"normals-turned",
         "Some normals of a surface point to one side of it, and some to the other. Where the side without normals "
         "is "
         "seen, it is dark.",
         "Section 2.14.1: n . VP is 0 where the light is behind the surface, and the normal decides where that is. "
         "One-sided "
         "lighting ignores the order of the vertices.",
         "glNormal3f(-nx, -ny, -nz);",
         R"(// the view
// the light
 glRotatef(-30, 0, 1, 0);
 glBegin(GL_QUADS);
 glNormal3f(0, 0, 1);
 glVertex3f(-1, -1, 1);
 glVertex3f(1, -1, 1);
 glVertex3f(1, 1, 1);
 glVertex3f(-1, 1, 1);
-glNormal3f(-1, 0, 0);
+glNormal3f(1, 0, 0);
 glVertex3f(1, -1, 1);
 glVertex3f(1, -1, -1);
 glVertex3f(1, 1, -1);
 glVertex3f(1, 1, 1);
 glEnd();
)",
         make_watch<TurnedNormals>, kNormalRules},
        {"one-normal",
         "The faces of an object face different ways, but all have one normal. They all get the same light, so the "
         "object "
         "looks flat.",
         "Section 2.7: the current normal holds until the next `glNormal`.",
         "glNormal3f(nx, ny, nz); for each face",
         R"(// the view
// the light
-glNormal3f(0, 1, 0);
 glBegin(GL_TRIANGLES);
+glNormal3f(-0.6, 0.7, 0.4);
 glVertex3f(0, 1.5, 0);
 glVertex3f(-2, 0, 0);
 glVertex3f(0, 0, 2);
+glNormal3f(0.6, 0.7, 0.4);
 glVertex3f(0, 1.5, 0);
 glVertex3f(0, 0, 2);
 glVertex3f(2, 0, 0);
 glEnd();
)",
         make_watch<OneNormal>,
         {"normal-missing", "normal-stale", "normal-array-off"}},
    };
}

}  // namespace twinlight::lint
