#include "random_states.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <stdexcept>
#include <string>

#include "context/context.h"
#include "reference/reference.h"

namespace twinlight {

namespace {

class Builder {
  public:
    explicit Builder(std::uint64_t seed) : structure_(seed / kStatesPerStructure), random_(seed) {}

    CommandList build(int triangles) {
        matrices();
        light_model();
        for (int i = 0; i < kMaxLights; ++i) {
            if (structure_.chance(0.35)) light(kGL_LIGHT0 + static_cast<Enum>(i));
        }
        materials();
        add("glEnable", {kGL_LIGHTING});
        add("glBegin", {kGL_TRIANGLES});
        for (int i = 0; i < 3 * triangles; ++i) vertex();
        add("glEnd", {});
        return std::move(list_);
    }

  private:
    // Numbers are rounded to what the driver is given: floats.
    void add(std::string_view name, std::vector<double> arguments) {
        const CommandId id = *find_command(name);
        const Parameter* last = signature(id).parameters.empty() ? nullptr : &signature(id).parameters.back();
        for (double& v : arguments) {
            if (last && last->kind != Kind::kDouble) v = static_cast<double>(static_cast<float>(v));
        }
        list_.commands.push_back({id, std::move(arguments), {}});
    }
    double coordinate() { return random_.uniform(0.05, 1) * (random_.chance(0.5) ? 1 : -1); }
    glm::dvec3 direction() {
        glm::dvec3 v(coordinate(), coordinate(), coordinate());
        return glm::normalize(v);
    }
    void color(std::string_view name, std::vector<double> head) {
        for (int i = 0; i < 4; ++i) head.push_back(random_.uniform(0, 1.5));
        add(name, head);
    }

    void matrices() {
        add("glMatrixMode", {kGL_PROJECTION});
        add("glOrtho", {-20, 20, -20, 20, -20, 20});
        add("glMatrixMode", {kGL_MODELVIEW});
        add("glTranslated", {coordinate(), coordinate(), coordinate() - 3});
        const glm::dvec3 axis = direction();
        add("glRotated", {random_.uniform(-180, 180), axis.x, axis.y, axis.z});
        switch (structure_.below(4)) {
            case 0: break;
            case 1: {
                const double s = random_.uniform(0.4, 2.5);
                add("glScaled", {s, s, s});
                add("glEnable", {kGL_RESCALE_NORMAL});
                break;
            }
            default:
                add("glScaled", {random_.uniform(0.5, 2), random_.uniform(0.5, 2), random_.uniform(0.5, 2)});
                add("glEnable", {kGL_NORMALIZE});
        }
    }

    void light_model() {
        color("glLightModelfv", {kGL_LIGHT_MODEL_AMBIENT});
        add("glLightModeli", {kGL_LIGHT_MODEL_LOCAL_VIEWER, structure_.chance(0.5) ? 1.0 : 0.0});
        add("glLightModeli", {kGL_LIGHT_MODEL_TWO_SIDE, structure_.chance(0.5) ? 1.0 : 0.0});
        add("glLightModeli",
            {kGL_LIGHT_MODEL_COLOR_CONTROL,
             static_cast<double>(structure_.chance(0.3) ? kGL_SEPARATE_SPECULAR_COLOR : kGL_SINGLE_COLOR)});
    }

    void light(Enum name) {
        const double l = name;
        for (Enum pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR}) color("glLightfv", {l, static_cast<double>(pname)});
        const bool directional = structure_.chance(0.4);
        const double reach = directional ? 1 : 4;
        add("glLightfv", {l, kGL_POSITION, reach * coordinate(), reach * coordinate(), reach * coordinate(),
                          directional ? 0 : random_.uniform(0.5, 2)});
        if (structure_.chance(0.4)) {
            const glm::dvec3 d = direction();
            add("glLightfv", {l, kGL_SPOT_DIRECTION, d.x, d.y, d.z});
            add("glLightf", {l, kGL_SPOT_CUTOFF, random_.uniform(20, 89)});
            add("glLightf", {l, kGL_SPOT_EXPONENT, structure_.chance(0.3) ? 0 : random_.uniform(0.5, 40)});
        }
        if (structure_.chance(0.6)) {
            add("glLightf", {l, kGL_CONSTANT_ATTENUATION, random_.uniform(0.2, 2)});
            add("glLightf", {l, kGL_LINEAR_ATTENUATION, random_.uniform(0, 1)});
            add("glLightf", {l, kGL_QUADRATIC_ATTENUATION, random_.uniform(0, 0.5)});
        }
        add("glEnable", {l});
    }

    void materials() {
        for (Enum face : {kGL_FRONT, kGL_BACK}) {
            for (Enum pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_EMISSION}) {
                color("glMaterialfv", {static_cast<double>(face), static_cast<double>(pname)});
            }
            // 0 is seldom: the driver departs from the text there.
            const double any = random_.uniform(0, 128);
            const double shininess[] = {0, 1, 2, 5, 32, 64, 128, any, any, any};
            add("glMaterialf", {static_cast<double>(face), kGL_SHININESS, shininess[structure_.below(10)]});
        }
        if (structure_.chance(0.4)) {
            const Enum modes[] = {kGL_EMISSION, kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_AMBIENT_AND_DIFFUSE};
            const Enum faces[] = {kGL_FRONT, kGL_BACK, kGL_FRONT_AND_BACK};
            add("glColorMaterial",
                {static_cast<double>(faces[structure_.below(3)]), static_cast<double>(modes[structure_.below(5)])});
            add("glEnable", {kGL_COLOR_MATERIAL});
        }
    }

    void vertex() {
        if (first_vertex_ ? random_.chance(0.9) : random_.chance(0.5)) color("glColor4f", {});
        first_vertex_ = false;
        const glm::dvec3 n = direction();
        add("glNormal3f", {n.x, n.y, n.z});
        add("glVertex3f", {coordinate(), coordinate(), coordinate()});
    }

    Random structure_;  // what decides which code lights the scene
    Random random_;     // the values
    bool first_vertex_ = true;
    CommandList list_;
};

// ---- What an exclusion asks ----

glm::dvec3 eye_position(const Draw& draw, const Vertex& vertex) {
    return glm::dvec3(draw.eye_from_object * vertex.position_object);
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
    return std::any_of(draw.lighting.lights.begin(), draw.lighting.lights.end(),
                       [&](const LightSource& light) { return light.enabled && predicate(light); });
}

bool has_shininess_0(const LightingState& lighting) {
    return lighting.front.shininess == 0 || (lighting.light_model.two_side && lighting.back.shininess == 0);
}

// Float rounding moves a cosine of unit vectors by some 1e-6: nearer than this to a jump, it decides.
constexpr double kJump = 1e-5;

}  // namespace

CommandList random_state(std::uint64_t seed, int triangles) { return Builder(seed).build(triangles); }

const std::vector<Exclusion>& exclusions() {
    static const std::vector<Exclusion> list = {
        {"shininess 0 with attenuation or a spot", "2.14.1: a factor of 1; the driver gives (n.VP)^(n.VP)", true,
         [](const Draw& draw, const Vertex&) {
             return has_shininess_0(draw.lighting) && any_light(draw, [](const LightSource& light) {
                        const bool attenuated = light.position_eye.w != 0 &&
                                                (light.constant_attenuation != 1 || light.linear_attenuation != 0 ||
                                                 light.quadratic_attenuation != 0);
                        return attenuated || light.spot_cutoff_deg != 180;
                    });
         }},
        {"shininess 0 on one side of two", "2.14.1: a factor of 1 on that side whatever the other has", true,
         [](const Draw& draw, const Vertex&) {
             return draw.lighting.light_model.two_side &&
                    (draw.lighting.front.shininess == 0) != (draw.lighting.back.shininess == 0);
         }},
        {"colour material before the first glColor", "2.14.3: the material follows the current colour from glEnable on",
         true,
         [](const Draw& draw, const Vertex& vertex) {
             return draw.lighting.color_material.enabled && vertex.color == Vertex{}.color;
         }},
        {"colour material on the back alone of two sides",
         "2.14.3: all channels of the back's material follow; the driver's program multiplies the red one "
         "only",
         true,
         [](const Draw& draw, const Vertex&) {
             const ColorMaterial& color_material = draw.lighting.color_material;
             return draw.lighting.light_model.two_side && color_material.enabled && color_material.face == kGL_BACK &&
                    color_material.mode != kGL_EMISSION;
         }},
        {"vertex at the edge of a spot's cone", "2.14.1: spot_i jumps at the cutoff, and rounding decides", false,
         [](const Draw& draw, const Vertex& vertex) {
             return any_light(draw, [&](const LightSource& light) {
                 const double cos_angle =
                     glm::dot(-toward(light, eye_position(draw, vertex)), glm::normalize(light.spot_direction_eye));
                 return light.spot_cutoff_deg != 180 &&
                        std::abs(cos_angle - std::cos(light.spot_cutoff_deg * M_PI / 180)) < kJump;
             });
         }},
        {"light at the horizon of a vertex", "2.14.1: f_i jumps at n.VP = 0, and rounding decides", false,
         [](const Draw& draw, const Vertex& vertex) {
             return any_light(draw, [&](const LightSource& light) {
                 return std::abs(glm::dot(eye_normal(draw, vertex), toward(light, eye_position(draw, vertex)))) < kJump;
             });
         }},
    };
    return list;
}

bool is_listed_driver() {
    constexpr std::string_view kMeasuredOn = "measured on: ";
    std::ifstream file("golden/known_differences");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(kMeasuredOn)) continue;
        const std::string listed = line.substr(kMeasuredOn.size(), line.find(" (") - kMeasuredOn.size());
        return driver_name().find(listed + '.') != std::string::npos;
    }
    throw std::runtime_error("golden/known_differences does not say on which driver it was measured");
}

}  // namespace twinlight
