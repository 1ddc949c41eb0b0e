// Rules about the finished picture: what is seen, and how much light arrives.
#include <algorithm>
#include <cmath>

#include "base/text/translation.h"
#include "judge/lint/between_vertices.h"
#include "judge/lint/seen.h"
#include "render/lighting_of.h"
#include "render/reference/geometry/primitive_assembly.h"
#include "render/reference/reference.h"
#include "render/reference/vertices/lit_vertices.h"
#include "render/reference/vertices/vertex_stage.h"

namespace twinlight::lint {

namespace {

constexpr double kInvisible = 0.5 / 255;  // rounding to 8 bits hides it

// ---- What is in view ----

// The planes of the view volume (2.12), with words for what is beyond each.
struct Side {
    int axis;  // of clip coordinates
    double sign;
    const char* words;
    const char* fix;
};
constexpr Side kSides[] = {
    {2, -1, "behind the camera, or before the near plane",
     "move them away from the camera: gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)"},
    {2, 1, "beyond the far plane", "put the far plane further away, or the objects nearer"},
    {0, -1, "left of the picture", "turn the camera to them with gluLookAt"},
    {0, 1, "right of the picture", "turn the camera to them with gluLookAt"},
    {1, -1, "below the picture", "turn the camera to them with gluLookAt"},
    {1, 1, "above the picture", "turn the camera to them with gluLookAt"},
};

std::size_t corners_of(const reference::Primitive& primitive) {
    return primitive.shape == reference::Shape::kTriangle ? 3 : primitive.shape == reference::Shape::kLine ? 2 : 1;
}

// The side that all corners are beyond; nullptr if the primitive may be in view.
const Side* beyond(const reference::Primitive& primitive, const std::vector<reference::StageVertex>& vertices) {
    for (const Side& side : kSides) {
        bool all = true;
        for (std::size_t i = 0; i < corners_of(primitive); ++i) {
            const glm::dvec4& p = vertices[primitive.vertices[i]].position_clip;
            all &= side.sign * p[side.axis] > p.w;
        }
        if (all) return &side;
    }
    return nullptr;
}

struct View {
    std::array<std::size_t, std::size(kSides)> beyond{};  // counts of primitives
    std::size_t in_view = 0, culled = 0;
};

View view_of(const Frame& frame) {
    View view;
    for (const Draw* draw : frame.draws()) {
        const std::vector<reference::StageVertex> vertices = reference::vertex_stage(*draw);
        for (const reference::Primitive& primitive : reference::assemble(*draw, reference::QuadCut::kFirstToThird)) {
            if (const Side* side = lint::beyond(primitive, vertices)) {
                ++view.beyond[static_cast<std::size_t>(side - kSides)];
                continue;
            }
            const bool is_culled = draw->raster.cull_enabled && primitive.shape == reference::Shape::kTriangle &&
                                   culls(*draw, primitive, vertices);
            ++(is_culled ? view.culled : view.in_view);
            if (view.in_view > 0) return view;  // enough is known
        }
    }
    return view;
}

class NothingInView : public Watch {
    void finish(const Frame& frame, bool) override {
        const View view = view_of(frame);
        if (view.in_view > 0 || view.culled > 0 || frame.draws().empty()) return;
        const auto most = std::ranges::max_element(view.beyond);
        if (*most == 0) return;
        const Side& side = kSides[most - view.beyond.begin()];
        warn({.place = frame.draws().front()->place,
              .message = tr("nothing is in view: the objects are {}", tr(side.words)),
              .fix = tr(side.fix)});
    }
};

class EverythingCulled : public Watch {
    void finish(const Frame& frame, bool) override {
        const View view = view_of(frame);
        if (view.in_view > 0 || view.culled == 0) return;
        const Draw& first = *frame.draws().front();
        warn({.place = first.place,
              .message = tr("everything in view is culled: glCullFace({}) removes the faces that the camera sees",
                            enum_name(first.raster.cull_face)),
              .fix = tr("glFrontFace with the order of your vertices, or glDisable(GL_CULL_FACE)"),
              .edits = {{.place = first.place, .insert = "glDisable(GL_CULL_FACE);"}}});
    }
};

// Lit solids without depth test, where the test would change the picture.
class NoDepthTest : public Watch {
    static bool is_solid(const Draw& draw) {
        return draw.lighting.enabled && draw.clip_from_eye[2][3] != 0 && !draw.fragment.blend &&
               draws_polygons(draw.mode);
    }
    void finish(const Frame& frame, bool) override {
        const std::vector<const Draw*> draws = frame.draws();
        const auto first = std::ranges::find_if(draws, [](const Draw* draw) { return is_solid(*draw); });
        if (first == draws.end() ||
            std::ranges::any_of(draws, [](const Draw* draw) { return draw->raster.depth_test; }))
            return;
        Frame small = smaller(frame);
        const Image without = reference::render(small, {});
        for (Draw* draw : small.editable_draws()) draw->raster.depth_test = is_solid(*draw);
        const Image with = reference::render(small, {});
        std::size_t differing = 0;
        for (std::size_t i = 0; i < with.pixels.size(); ++i) {
            const auto &a = with.pixels[i], &b = without.pixels[i];
            differing += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) > 0.1;
        }
        if (differing * 200 < with.pixels.size()) return;
        warn({.place = (*first)->place,
              .message = tr("far faces are drawn over near ones: the depth test is never enabled"),
              .fix = "glEnable(GL_DEPTH_TEST);",
              .edits = {{.place = (*first)->place, .insert = "glEnable(GL_DEPTH_TEST);"}}});
    }
};

// ---- How much light arrives ----

// What keeps a light from a vertex.
enum class Dark : std::uint8_t { kNot, kFacesAway, kLightInside, kOutsideCone, kAttenuated, kMaterialBlack };

double largest(const glm::dvec3& color) { return std::max({color.r, color.g, color.b}); }

Dark dark_reason(const Draw& draw, const LightSource& light, const Arrival& arrival, const EyeVertex& vertex,
                 const Vertex& given) {
    const Material& material = draw.materials.empty() ? draw.lighting.front : draw.materials[given.material].front;
    const glm::dvec3 diffuse =
        draw.lighting.color_material.enabled ? glm::dvec3(given.color) : glm::dvec3(material.diffuse);
    const glm::dvec3 ambient =
        draw.lighting.color_material.enabled ? glm::dvec3(given.color) : glm::dvec3(material.ambient);
    const double facing = glm::dot(vertex.normal, arrival.to_light_dir);
    const double brightest = std::max({largest(light.ambient), largest(light.diffuse), largest(light.specular)});
    if (arrival.spot == 0) return Dark::kOutsideCone;
    if (arrival.attenuation * brightest < kInvisible) return Dark::kAttenuated;
    if (largest(ambient * glm::dvec3(light.ambient)) * arrival.attenuation >= kInvisible) return Dark::kNot;
    if (facing <= 0 && !(draw.lighting.light_model.two_side && facing < 0)) return Dark::kFacesAway;
    const glm::dvec3 both =
        diffuse * glm::dvec3(light.diffuse) + glm::dvec3(material.specular) * glm::dvec3(light.specular);
    return largest(both) < kInvisible ? Dark::kMaterialBlack : Dark::kNot;
}

// What the Draws of one object (one shape, or one glBegin) reach to, in eye coordinates.
struct Box {
    glm::dvec3 low{INFINITY}, high{-INFINITY};

    bool contains(const glm::dvec3& place) const {
        return glm::all(glm::lessThan(low, place)) && glm::all(glm::lessThan(place, high));
    }
};
using Boxes = std::map<std::pair<int, int>, Box>;  // by line and column

Boxes boxes_of(const Frame& frame) {
    Boxes boxes;
    for (const Draw* draw : frame.draws()) {
        Box& box = boxes[{draw->place.line, draw->place.column}];
        for (const EyeVertex& vertex : eye_vertices(*draw)) {
            box.low = glm::min(box.low, vertex.position);
            box.high = glm::max(box.high, vertex.position);
        }
    }
    return boxes;
}

struct DarkFrame {
    Dark why = Dark::kNot;
    Place place{};
    int light = 0;
};

// Why no lit object of the frame gets light from any light; kNot if some vertex does.
DarkFrame dark_frame(const Frame& frame) {
    std::map<Dark, std::size_t> counts;
    DarkFrame result;
    struct FacingAway {
        const Draw& draw;
        const LightSource& light;
        std::size_t count;  // of vertices
    };
    std::vector<FacingAway> facing_away;  // its cause needs the boxes of objects; a lit picture needs none
    for (const Draw* draw : frame.draws()) {
        const std::vector<int> lights = enabled_lights(*draw);
        if (lights.empty()) continue;
        if (!is_black(draw->lighting.front.emission)) return {};
        const std::vector<EyeVertex> vertices = eye_vertices(*draw);
        for (const int number : lights) {
            const LightSource& light = draw->lighting.lights[static_cast<std::size_t>(number)];
            if (is_black(light)) continue;
            const lighting::Light<double> arriving = lighting_of(light);
            std::size_t away = 0;
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                if (vertices[i].normal == glm::dvec3(0)) return {};  // normal-zero
                const Dark why = dark_reason(*draw, light, arrival_at(vertices[i].position, arriving), vertices[i],
                                             draw->vertices[i]);
                if (why == Dark::kNot) return {};
                ++(why == Dark::kFacesAway ? away : counts[why]);
                if (result.place.line == 0) {
                    result.place = draw->place;
                    result.light = number;
                }
            }
            if (away > 0) facing_away.push_back({*draw, light, away});
        }
    }
    if (!facing_away.empty()) {
        const Boxes boxes = boxes_of(frame);
        for (const FacingAway& part : facing_away) {
            const glm::dvec4& at = part.light.position_eye;
            const bool is_inside =
                at.w != 0 && boxes.at({part.draw.place.line, part.draw.place.column}).contains(glm::dvec3(at) / at.w);
            counts[is_inside ? Dark::kLightInside : Dark::kFacesAway] += part.count;
        }
    }
    if (counts.empty()) return {};
    // Where only the material is missing, the light does arrive.
    if (counts.contains(Dark::kMaterialBlack)) counts = {{Dark::kMaterialBlack, 1}};
    result.why = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })->first;
    return result;
}

struct NotLitText {
    const char *message, *fix;
};
constexpr NotLitText not_lit_text(Dark why) {
    switch (why) {
        case Dark::kNot: break;
        case Dark::kFacesAway:
            return {"every normal points away from every light",
                    "move the light to the side that the normals point to, or turn the normals around"};
        case Dark::kLightInside:
            return {"the light is inside the object, and the normals point outwards",
                    "move the light outside with glLightfv(GL_LIGHT0, GL_POSITION, ...)"};
        case Dark::kOutsideCone:
            return {"everything is outside the cone of the spotlight",
                    "aim GL_SPOT_DIRECTION at the objects, or make GL_SPOT_CUTOFF larger"};
        case Dark::kAttenuated:
            return {"attenuation leaves less than 1/255 of the light",
                    "make GL_LINEAR_ATTENUATION or GL_QUADRATIC_ATTENUATION smaller"};
        case Dark::kMaterialBlack:
            return {"the materials are black in the colours of the lights",
                    "set GL_DIFFUSE or GL_AMBIENT_AND_DIFFUSE of the material"};
    }
    return {"", ""};
}

template <Dark kWhy>
class NotLit : public Watch {
    void finish(const Frame& frame, bool) override {
        const DarkFrame dark = dark_frame(frame);
        if (dark.why != kWhy || dark.light >= kMaxLights || view_of(frame).in_view == 0) return;
        if (kWhy == Dark::kOutsideCone && !lost_lights(frame, kInvisible).empty()) return;
        const NotLitText text = not_lit_text(kWhy);
        warn({.place = dark.place, .message = tr("no object is lit: {}", tr(text.message)), .fix = tr(text.fix)});
    }
};

// (n . h)^s with attenuation and cone, section 2.14.1.
double highlight(const Draw& draw, const lighting::Light<double>& light, const EyeVertex& point, bool local_viewer) {
    const Arrival arrival = arrival_at(point.position, light);
    const glm::dvec3 way = arrival.to_light_dir;
    if (glm::dot(point.normal, way) <= 0) return 0;
    glm::dvec3 eye(0, 0, 1);
    if (local_viewer && glm::length(point.position) > 0) eye = -glm::normalize(point.position);
    const glm::dvec3 half = way + eye;
    if (glm::length(half) == 0) return 0;
    const double cosine = std::max(0.0, glm::dot(point.normal, glm::normalize(half)));
    const Material& front = draw.lighting.front;
    return std::pow(cosine, front.shininess) * arrival.reach() *
           largest(vec3_cast<glm::dvec3>(light.specular) * glm::dvec3(front.specular));
}

// Flat surfaces of many vertices, all with the same highlight, where a local viewer sees a bright place.
class HighlightEverywhere : public Watch {
    void finish(const Frame& frame, bool) override {
        std::map<std::pair<int, int>, std::vector<const Draw*>> objects;  // by line and column
        for (const Draw* draw : frame.draws())
            if (may_be_plane(*draw)) objects[{draw->place.line, draw->place.column}].push_back(draw);
        for (const auto& [place, draws] : objects) {
            const Draw& first = *draws.front();
            std::vector<EyeVertex> in_view;
            if (!add_plane(draws, in_view) || in_view.size() < kManyVertices) continue;
            for (const int number : enabled_lights(first)) {
                const lighting::Light<double> light =
                    lighting_of(first.lighting.lights[static_cast<std::size_t>(number)]);
                double least = INFINITY, most = 0;
                for (const EyeVertex& vertex : in_view) {
                    const double local = highlight(first, light, vertex, true);
                    least = std::min(least, local);
                    most = std::max(most, local);
                }
                if (most - least < 0.25) continue;
                const std::string call = "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);";
                warn({.place = first.place,
                      .message = tr("this flat surface has the same highlight everywhere: {} is directional, and "
                                    "GL_LIGHT_MODEL_LOCAL_VIEWER is off",
                                    light_name(number)),
                      .fix = call,
                      .edits = {{.place = first.place, .insert = call}},
                      .key = "flat"});
                break;
            }
        }
    }

    // A surface of fewer vertices has no highlight in its middle, whatever the viewer.
    static constexpr std::size_t kManyVertices = 36;

    static bool may_be_plane(const Draw& draw) {
        const Material& front = draw.lighting.front;
        return draws_polygons(draw.mode) && has_specular_light(draw) && !is_black(front.specular) &&
               front.shininess >= 1 && !draw.lighting.light_model.local_viewer && draw.clip_from_eye[2][3] != 0 &&
               draw.lighting.shade_model == kGL_SMOOTH && draw.materials.empty() &&
               std::ranges::none_of(draw.lighting.lights, [](const LightSource& light) {
                   return light.enabled && !light.is_directional() && !is_black(light.specular);
               });
    }

    // Adds the vertices in view; false if the normals differ.
    static bool add_plane(const std::vector<const Draw*>& draws, std::vector<EyeVertex>& in_view) {
        std::optional<glm::dvec3> normal;
        for (const Draw* draw : draws) {
            for (const reference::StageVertex& vertex : reference::vertex_stage(*draw)) {
                if (!normal) normal = vertex.normal_eye;
                if (glm::length(vertex.normal_eye - *normal) > 1e-6) return false;
                const glm::dvec4& clip = vertex.position_clip;
                if (std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) > clip.w) continue;
                in_view.push_back({glm::dvec3(vertex.position_eye), vertex.normal_eye});
            }
        }
        return true;
    }
};

// Objects that are plain white, because every vertex is clamped.
class Overexposed : public Watch {
    void finish(const Frame& frame, bool) override {
        const Draw* first = nullptr;
        for (const Draw* draw : frame.draws()) {
            if (enabled_lights(*draw).empty()) continue;
            const std::vector<reference::LitVertex> lit = reference::light_vertices(*draw, {}, false);
            const bool is_white = std::ranges::all_of(lit, [](const reference::LitVertex& vertex) {
                const glm::dvec4 sum = vertex.front_primary + vertex.front_secondary;
                return sum.r >= 1 && sum.g >= 1 && sum.b >= 1 && sum.r + sum.g + sum.b > 3.3;
            });
            if (!is_white) return;
            if (!first) first = draw;
        }
        if (!first) return;
        warn({.place = first->place,
              .message =
                  tr("lit objects are plain white: at every vertex the sum of the lights is above 1, and is clamped"),
              .fix = tr("make the lights or the material darker: GL_LIGHT_MODEL_AMBIENT, GL_AMBIENT, GL_DIFFUSE")});
    }
};

}  // namespace

std::vector<Rule> picture_rules() {
    static const std::vector<std::string_view> kMatrixRules = {"projection-in-modelview", "camera-in-projection",
                                                               "projection-not-reset",    "near-plane",
                                                               "angle-in-radians",        "rotate-no-axis"};
    static const std::vector<std::string_view> kLightRules = {"light-before-camera",
                                                              "normal-array-off",
                                                              "spot-direction-before-camera",
                                                              "light-w",
                                                              "spot-directional",
                                                              "projection-in-modelview",
                                                              "camera-in-projection",
                                                              "scale-zero",
                                                              "normal-zero",
                                                              "color-255"};
    return {
        {"nothing-in-view", "No object is in view.",
         "Section 2.12: what is outside the view volume is clipped away. Initially the camera is at the origin and "
         "looks along -z.",
         "gluLookAt(0, 0, 5,  0, 0, 0,  0, 1, 0);",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glEnable(GL_DEPTH_TEST);
 glMatrixMode(GL_PROJECTION);
 gluPerspective(45, 4.0 / 3.0, 1, 100);
 glMatrixMode(GL_MODELVIEW);
-gluLookAt(0, 0, 5,  0, 0, 9,  0, 1, 0);
+gluLookAt(0, 0, 5,  0, 0, 0,  0, 1, 0);
// the light
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<NothingInView>, kMatrixRules},
        {"everything-culled",
         "Every face in view is culled. The picture is empty.",
         "Section 3.5.1: `glFrontFace` decides by the order of the vertices in the window which faces are front faces, "
         "and `glCullFace` which are removed.",
         "glFrontFace(GL_CW); or glDisable(GL_CULL_FACE);",
         R"(// the view
// the light
 glEnable(GL_CULL_FACE);
-glCullFace(GL_FRONT);
+glCullFace(GL_BACK);
 glBegin(GL_TRIANGLES);
 glNormal3f(0, 0, 1);
 glVertex3f(-2, -1, 0);
 glVertex3f(2, -1, 0);
 glVertex3f(0, 2, 0);
 glEnd();
)",
         make_watch<EverythingCulled>,
         {"winding-against-normals", "nothing-in-view"}},
        {"no-depth-test",
         "The depth test is never enabled, and the order of drawing shows far faces before near ones.",
         "Section 4.1.6: without `GL_DEPTH_TEST` every fragment replaces what was drawn before.",
         "glEnable(GL_DEPTH_TEST);",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glMatrixMode(GL_PROJECTION);
 gluPerspective(45, 4.0 / 3.0, 1, 100);
 glMatrixMode(GL_MODELVIEW);
 gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
// the light
+glEnable(GL_DEPTH_TEST);
 glRotatef(40, 1, 1, 0);
 glutSolidTorus(0.6, 1.4, 20, 40);
)",
         make_watch<NoDepthTest>,
         {"left-for-next-picture"}},
        {"normals-face-away", "No object is lit, because every normal points away from every light.",
         "Section 2.14.1: n . VP is 0 where the light is behind the surface.",
         "move the light, or turn the normals around",
         R"(// the view
// the light
 glBegin(GL_TRIANGLES);
-glNormal3f(0, 0, -1);
+glNormal3f(0, 0, 1);
 glVertex3f(-2, -1, 0);
 glVertex3f(2, -1, 0);
 glVertex3f(0, 2, 0);
 glEnd();
)",
         make_watch<NotLit<Dark::kFacesAway>>, kLightRules},
        {"light-inside", "No object is lit, because the light is inside the object.",
         "Section 2.14.1: n . VP is 0 where the light is behind the surface; GL casts no shadows, but lights only the "
         "sides that face the light.",
         "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});",
         R"(// the view
-glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 0, 1});
+glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<NotLit<Dark::kLightInside>>, kLightRules},
        {"outside-cone", "No object is lit, because everything is outside the cone of the spotlight.",
         "Section 2.14.1: the spotlight factor is 0 outside the cone. `GL_SPOT_DIRECTION` is a direction, not a place; "
         "`GL_SPOT_CUTOFF` is half of the cone's angle.",
         "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0});",
         R"(// the view
 glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 4, 0, 1});
 glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 15);
-glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, 1, 0});
+glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0});
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 80, 40);
)",
         make_watch<NotLit<Dark::kOutsideCone>>, kLightRules},
        {"attenuated-away", "No object is lit, because attenuation leaves almost nothing of the light.",
         "Section 2.14.1: the factor is 1 / (k0 + k1 d + k2 d * d), with the distance d in units of the scene.",
         "glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.05);",
         R"(// the view
// the light
-glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 50);
+glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.05);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<NotLit<Dark::kAttenuated>>, kLightRules},
        {"material-black", "No object is lit, because the product of material and light is black.",
         "Section 2.14.1: the colours of material and light are multiplied, channel by channel: a blue surface in red "
         "light is black.",
         "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});",
         R"(// the view
// the light
 glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){1, 0, 0, 1});
-glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0, 0, 1, 1});
+glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<NotLit<Dark::kMaterialBlack>>, kLightRules},
        {"highlight-everywhere",
         "A flat surface has the same highlight everywhere, although it is divided into many pieces. The light is "
         "directional, and `GL_LIGHT_MODEL_LOCAL_VIEWER` is off.",
         "Section 2.14.1: without a local viewer, the direction to the viewer is (0, 0, 1) at every vertex. With a "
         "directional light, the highlight then depends on the normal only, and a flat surface has one normal.",
         "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);",
         R"(// the view
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 2, -6, 0});
 glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.6, 0.6, 0.6, 1});
 glMaterialf(GL_FRONT, GL_SHININESS, 100);
+glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
 glRotatef(-90, 1, 0, 0);
 GLUquadric* floor = gluNewQuadric();
 gluDisk(floor, 0, 3, 60, 60);
)",
         make_watch<HighlightEverywhere>},
        {"overexposed",
         "The lights add up to more than 1 everywhere. The objects are plain white, without shading.",
         "Section 2.14.6: colours are clamped to [0, 1] after the sum.",
         "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ...);",
         R"(// the view
// the light
-glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){2, 2, 2, 1});
+glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){0.2, 0.2, 0.2, 1});
 glMaterialfv(GL_FRONT, GL_AMBIENT, (GLfloat[]){0.8, 0.8, 0.8, 1});
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<Overexposed>,
         {"color-255", "scale-without-normalize", "normal-length"}},
    };
}

}  // namespace twinlight::lint
