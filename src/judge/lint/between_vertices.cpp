// Rules about light that falls between the vertices of a surface. GL lights vertices only (2.14.1), so the light is lost.
#include "judge/lint/between_vertices.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/text/translation.h"
#include "judge/lint/seen.h"
#include "render/lighting_of.h"
#include "render/reference/vertices/draw_lighting.h"

namespace twinlight::lint {

namespace {

using reference::Face;
using reference::StageVertex;

// A flat surface may consist of many Draws of one place. All curved surfaces of a place are one: a vertex of one ball tells how
// bright the vertices of the next can be.
struct SurfaceKey {
    std::shared_ptr<const std::string> file;
    int line = 0, column = 0;
    bool is_flat = false;
    std::array<long, 4> plane{};  // rounded

    // Emscripten's library has no <=> for pointers and arrays.
    friend bool operator<(const SurfaceKey& a, const SurfaceKey& b) {
        return std::tie(a.file, a.line, a.column, a.is_flat, a.plane) <
               std::tie(b.file, b.line, b.column, b.is_flat, b.plane);
    }
};

// One light's part of the colours at a point.
struct PartOfLight {
    glm::dvec3 ambient_and_diffuse{0}, specular{0};
    double spot = 1;

    glm::dvec3 sum() const { return ambient_and_diffuse + specular; }
};

struct LitPoint {
    std::vector<PartOfLight> lights;  // the enabled ones
    glm::dvec3 color{0};              // clamped, as it is seen
};

// A place between the vertices that is much brighter if it is lit by itself.
struct BrightPlace {
    TriangleNumber triangle;
    glm::dvec4 position_clip;
    const Draw* draw;
    LostLight::Part part;
    int channel;
    double loss, light;  // of this channel
    double spot;
};

struct OfLight {
    std::array<double, 3> brightest_vertex{};  // for each channel
    double most_spot = 0;                      // of the vertices
    std::vector<BrightPlace> places;
};
using Surfaces = std::map<SurfaceKey, std::map<int, OfLight>>;

// The point of a triangle with these weights, as shading every pixel sees it: the normal has length 1.
StageVertex point_at(const std::array<const StageVertex*, 3>& corners, const glm::dvec3& weights) {
    StageVertex point = *corners[0];
    point.position_eye = point.position_clip = point.color = glm::dvec4(0);
    point.normal_eye = glm::dvec3(0);
    for (int i = 0; i < 3; ++i) {
        const StageVertex& corner = *corners[static_cast<std::size_t>(i)];
        point.position_eye += weights[i] * corner.position_eye;
        point.position_clip += weights[i] * corner.position_clip;
        point.color += weights[i] * corner.color;
        point.normal_eye += weights[i] * corner.normal_eye;
    }
    if (const double length = glm::length(point.normal_eye); length > 0) point.normal_eye /= length;
    return point;
}

bool is_in_view(const glm::dvec4& clip) {
    return std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) <= clip.w;
}

// The larger side of a triangle's box in normalised device coordinates, where the picture has sides of 2; 0 if it is out of view.
double extent(const std::array<const StageVertex*, 3>& corners) {
    glm::dvec2 low(1), high(-1);
    for (const StageVertex* corner : corners) {
        const glm::dvec4& clip = corner->position_clip;
        if (clip.w <= 0) return 2;
        low = glm::min(low, glm::dvec2(clip) / clip.w);
        high = glm::max(high, glm::dvec2(clip) / clip.w);
    }
    const glm::dvec2 size = glm::min(high, glm::dvec2(1)) - glm::max(low, glm::dvec2(-1));
    return std::min(size.x, size.y) < 0 ? 0 : std::max(size.x, size.y);
}

// Where a light may be brightest: a grid, the point that is nearest to the light, and where the axis of its cone meets the plane.
std::vector<glm::dvec3> weights_in(const std::array<const StageVertex*, 3>& corners, double size,
                                   const std::vector<lighting::Light<double>>& lights) {
    std::vector<glm::dvec3> weights;
    const int steps = std::clamp(static_cast<int>(size / 0.06), 4, 24);
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j) weights.push_back(glm::dvec3(i, j, steps - i - j) / double(steps));
    const glm::dvec3 a(corners[0]->position_eye), b(corners[1]->position_eye), c(corners[2]->position_eye);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double twice_area = glm::length(normal);
    if (twice_area == 0) return weights;
    const auto add = [&](const glm::dvec3& from, const glm::dvec3& way) {
        const double slope = glm::dot(normal, way);
        if (slope == 0) return;
        const double along = glm::dot(normal, a - from) / slope;
        if (!(along > 0)) return;
        const glm::dvec3 p = from + along * way;
        const auto part = [&](const glm::dvec3& u, const glm::dvec3& v) {
            return glm::dot(glm::cross(u - p, v - p), normal) / (twice_area * twice_area);
        };
        const glm::dvec3 at(part(b, c), part(c, a), part(a, b));
        if (at.x >= 0 && at.y >= 0 && at.z >= 0) weights.push_back(at);
    };
    for (const lighting::Light<double>& light : lights) {
        if (light.directional) continue;
        const glm::dvec3 place = vec3_cast<glm::dvec3>(light.position_eye);
        const double side = glm::dot(normal, place - a);
        add(place, side > 0 ? -normal : normal);
        if (light.is_spot) add(place, vec3_cast<glm::dvec3>(light.spot_dir_eye));
    }
    return weights;
}

// One Draw's light, at its vertices and between them.
class DrawLight {
  public:
    explicit DrawLight(const Draw& draw)
        : draw_(draw),
          lighting_(draw, false),
          vertices_(reference::vertex_stage(draw)),
          terms_(lighting_.lights().size()) {
        for (auto& face : at_vertices_) face.resize(vertices_.size());
    }

    const std::vector<StageVertex>& vertices() const { return vertices_; }
    const std::vector<lighting::Light<double>>& lights() const { return lighting_.lights(); }
    LitPoint light(const StageVertex& point, Face face) {
        const lighting::MeasuredLit<double> lit =
            lighting_.light_surface(lighting_.material(point, face),
                                    reference::surface_of(point.position_eye, point.normal_eye, face), terms_.data());
        LitPoint result;
        for (const lighting::LightTerms<double>& term : terms_)
            result.lights.push_back({.ambient_and_diffuse = vec3_cast<glm::dvec3>(term.ambient + term.diffuse),
                                     .specular = vec3_cast<glm::dvec3>(term.specular),
                                     .spot = term.spot});
        result.color = glm::clamp(vec3_cast<glm::dvec3>(lit.primary + lit.secondary), 0.0, 1.0);
        return result;
    }
    const LitPoint& at_vertex(std::uint32_t i, Face face) {
        std::optional<LitPoint>& known = at_vertices_[face == Face::kFront ? 0 : 1][i];
        if (!known) known = light(vertices_[i], face);
        return *known;
    }
    // The face that GL lights (2.14.1).
    Face face_of(const std::array<const StageVertex*, 3>& corners) const {
        if (!lighting_.two_side()) return Face::kFront;
        const auto row = [&](int axis) {
            return glm::dvec3(corners[0]->position_clip[axis], corners[1]->position_clip[axis],
                              corners[2]->position_clip[axis]);
        };
        const double area = glm::dot(glm::cross(row(0), row(1)), row(3));
        return (area > 0) == (draw_.raster.front_face == kGL_CCW) ? Face::kFront : Face::kBack;
    }

  private:
    const Draw& draw_;
    reference::DrawLighting lighting_;
    std::vector<StageVertex> vertices_;
    std::array<std::vector<std::optional<LitPoint>>, 2> at_vertices_;
    std::vector<lighting::LightTerms<double>> terms_;
};

bool can_lose_light(const Draw& draw) {
    const bool replaces = draw.texture.texture && draw.texture.env_mode != kGL_MODULATE;
    return draws_polygons(draw.mode) && !draw.draws_borders() && !enabled_lights(draw).empty() && !replaces &&
           !draw.combines_textures() && draw.raster.clip_plane_count() == 0 &&
           std::ranges::none_of(draw.vertices, [](const Vertex& v) { return v.position_object.w == 0; });
}

SurfaceKey key_of(const Draw& draw, const std::array<const StageVertex*, 3>& corners) {
    const glm::dvec3& normal = corners[0]->normal_eye;
    SurfaceKey key{.file = draw.place.file, .line = draw.place.line, .column = draw.place.column};
    key.is_flat = normal == corners[1]->normal_eye && normal == corners[2]->normal_eye;
    if (!key.is_flat) return key;
    constexpr double kSteps = 64;  // for each unit
    for (int i = 0; i < 3; ++i)
        key.plane[static_cast<std::size_t>(i)] = std::lround(std::clamp(kSteps * normal[i], -1e9, 1e9));
    const double distance = glm::dot(normal, glm::dvec3(corners[0]->position_eye));
    key.plane[3] = std::lround(std::clamp(kSteps * distance, -1e9, 1e9));
    return key;
}

// Adds the Draw's vertices and bright places to its surfaces.
void add(const Draw& draw, std::size_t number, double least, Surfaces& surfaces) {
    DrawLight lit(draw);
    const std::vector<int> numbers = enabled_lights(draw);
    const bool is_flat_shaded = draw.lighting.shade_model == kGL_FLAT;
    const std::vector<Triangle> triangles = triangles_of(draw);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& triangle = triangles[t];
        std::array<const StageVertex*, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) corners[i] = &lit.vertices()[triangle[i]];
        const Face face = lit.face_of(corners);
        std::array<const LitPoint*, 3> at_corners{};
        for (std::size_t i = 0; i < 3; ++i) at_corners[i] = &lit.at_vertex(triangle[i], face);
        std::map<int, OfLight>& surface = surfaces[key_of(draw, corners)];
        for (std::size_t l = 0; l < numbers.size(); ++l) {
            OfLight& of = surface[numbers[l]];
            for (const LitPoint* corner : at_corners) {
                of.most_spot = std::max(of.most_spot, corner->lights[l].spot);
                for (int c = 0; c < 3; ++c) {
                    double& most = of.brightest_vertex[static_cast<std::size_t>(c)];
                    most = std::max(most, corner->lights[l].sum()[c]);
                }
            }
        }
        constexpr double kLarge = 0.1;  // the light within a smaller triangle is hardly seen
        const double size = extent(corners);
        if (!(size >= kLarge)) continue;
        for (const glm::dvec3& weights : weights_in(corners, size, lit.lights())) {
            const StageVertex point = point_at(corners, weights);
            if (!is_in_view(point.position_clip)) continue;
            const LitPoint here = lit.light(point, face);
            for (int c = 0; c < 3; ++c) {
                const auto from_corners = [&](const auto& value) {
                    const double x = value(*at_corners[0]), y = value(*at_corners[1]), z = value(*at_corners[2]);
                    return is_flat_shaded ? std::max({x, y, z}) : x * weights.x + y * weights.y + z * weights.z;
                };
                const double loss = here.color[c] - from_corners([&](const LitPoint& p) { return p.color[c]; });
                if (!(loss > least)) continue;
                for (std::size_t l = 0; l < numbers.size(); ++l) {
                    const PartOfLight& light = here.lights[l];
                    const double diffuse = light.ambient_and_diffuse[c] - from_corners([&](const LitPoint&p) {
                                               return p.lights[l].ambient_and_diffuse[c];
                                           }),
                                 specular = light.specular[c] -
                                            from_corners([&](const LitPoint&p) { return p.lights[l].specular[c]; });
                    if (!(diffuse + specular > least)) continue;
                    surface[numbers[l]].places.push_back(
                        {.triangle = {number, t},
                         .position_clip = point.position_clip,
                         .draw = &draw,
                         .part = specular > diffuse ? LostLight::Part::kHighlight : LostLight::Part::kLamp,
                         .channel = c,
                         .loss = std::min(loss, diffuse + specular),
                         .light = light.sum()[c],
                         .spot = light.spot});
                }
            }
        }
    }
}

// The place where most is lost, if the picture shows it, and no vertex of the surface is nearly as bright.
std::optional<LostLight> lost_of(int number, OfLight& of, const SeenPoints& seen) {
    constexpr double kShare = 0.4;
    std::erase_if(of.places, [&](const BrightPlace& place) {
        return of.brightest_vertex[static_cast<std::size_t>(place.channel)] > kShare * place.light;
    });
    constexpr std::size_t kTries = 30;
    const std::size_t tries = std::min(of.places.size(), kTries);
    std::partial_sort(of.places.begin(), of.places.begin() + static_cast<std::ptrdiff_t>(tries), of.places.end(),
                      [](const BrightPlace& a, const BrightPlace& b) { return a.loss > b.loss; });
    for (std::size_t i = 0; i < tries; ++i) {
        const BrightPlace& place = of.places[i];
        if (!seen.shows(place.triangle, place.position_clip)) continue;
        return LostLight{.draw = place.draw,
                         .light = number,
                         .part = of.most_spot < kShare * place.spot ? LostLight::Part::kCone : place.part,
                         .brightest_vertex = of.brightest_vertex[static_cast<std::size_t>(place.channel)],
                         .between = place.light};
    }
    return std::nullopt;
}

constexpr const char* words_of(LostLight::Part part) {
    switch (part) {
        case LostLight::Part::kCone: return "the cone";
        case LostLight::Part::kHighlight: return "the highlight";
        case LostLight::Part::kLamp: return "the light";
    }
    return "";
}

template <LostLight::Part kPart>
class BetweenVertices : public Watch {
    void finish(const Frame& frame, bool) override {
        for (const LostLight& lost : lost_lights(frame)) {
            if (lost.part != kPart) continue;
            warn({.place = lost.draw->place,
                  .message = tr("{} of {} falls between the vertices and is lost: there it would add {:.2f}, "
                                "but GL lights vertices only, and it adds at most {:.2f} to those of this surface",
                                tr(words_of(kPart)), light_name(lost.light), std::min(lost.between, 1.0),
                                lost.brightest_vertex),
                  .fix = tr("divide the surface into smaller pieces, or use shaders (--shading phong)"),
                  .key = light_name(lost.light)});
        }
    }
};

}  // namespace

std::vector<LostLight> lost_lights(const Frame& frame, double least) {
    Surfaces surfaces;
    const std::vector<const Draw*> draws = frame.draws();
    for (std::size_t i = 0; i < draws.size(); ++i)
        if (can_lose_light(*draws[i])) add(*draws[i], i, least, surfaces);
    std::vector<LostLight> lost;
    std::optional<SeenPoints> seen;
    for (auto& [key, lights] : surfaces) {
        for (auto& [number, of] : lights) {
            if (of.places.empty()) continue;
            if (!seen) seen.emplace(frame);
            if (const auto found = lost_of(number, of, *seen)) lost.push_back(*found);
        }
    }
    return lost;
}

std::vector<Rule> between_vertices_rules() {
    static const std::vector<std::string_view> kLengthRules = {"scale-without-normalize", "normal-length", "color-255",
                                                               "projection-in-modelview", "light-w"};
    return {
        {"spot-between-vertices",
         "A spotlight shines on a surface, but no vertex of the surface is in its cone. Its light is lost.",
         "Section 2.14.1: lighting happens at vertices; between them colours are interpolated.",
         "divide the surface into smaller pieces",
         R"(// the view
 glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 2, 0, 1});
 glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0});
 glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 25);
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
-glNormal3f(0, 1, 0);
-glBegin(GL_QUADS);
-glVertex3f(-3, 0, 3);
-glVertex3f(3, 0, 3);
-glVertex3f(3, 0, -3);
-glVertex3f(-3, 0, -3);
-glEnd();
+glRotatef(-90, 1, 0, 0);
+GLUquadric* floor = gluNewQuadric();
+gluDisk(floor, 0, 3, 60, 60);
)",
         make_watch<BetweenVertices<LostLight::Part::kCone>>, kLengthRules},
        {"highlight-between-vertices",
         "A highlight lies on a surface, but no vertex of the surface is bright. It is lost.",
         "Section 2.14.1: lighting happens at vertices; between them colours are interpolated.",
         "divide the surface into smaller pieces",
         R"(// the view
 glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 1.2, -0.6, 1});
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});
 glMaterialf(GL_FRONT, GL_SHININESS, 60);
-glNormal3f(0, 1, 0);
-glBegin(GL_QUADS);
-glVertex3f(-3, 0, 3);
-glVertex3f(3, 0, 3);
-glVertex3f(3, 0, -3);
-glVertex3f(-3, 0, -3);
-glEnd();
+glRotatef(-90, 1, 0, 0);
+GLUquadric* floor = gluNewQuadric();
+gluDisk(floor, 0, 3, 60, 60);
)",
         make_watch<BetweenVertices<LostLight::Part::kHighlight>>, kLengthRules},
        {"lamp-between-vertices",
         "A lamp is near the middle of a large surface, but all vertices of the surface are far away from it. Its "
         "light "
         "is lost.",
         "Section 2.14.1: lighting happens at vertices; between them colours are interpolated. Near a lamp, the angle "
         "and the attenuation change quickly.",
         "divide the surface into smaller pieces",
         R"(// the view
 glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0.5, 0, 1});
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
-glNormal3f(0, 1, 0);
-glBegin(GL_QUADS);
-glVertex3f(-3, 0, 3);
-glVertex3f(3, 0, 3);
-glVertex3f(3, 0, -3);
-glVertex3f(-3, 0, -3);
-glEnd();
+glRotatef(-90, 1, 0, 0);
+GLUquadric* floor = gluNewQuadric();
+gluDisk(floor, 0, 3, 60, 60);
)",
         make_watch<BetweenVertices<LostLight::Part::kLamp>>, kLengthRules},
    };
}

}  // namespace twinlight::lint
