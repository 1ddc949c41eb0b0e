// What the rules share: Watch, the base of each rule's code, and questions about Draws.
#pragma once

#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/image/image.h"
#include "judge/lint/lint.h"
#include "judge/lint/redraw.h"
#include "scene/command/command_set.h"
#include "scene/state/state.h"

namespace twinlight::lint {

// The code of a rule, for one scene. The commands of display lists come as they are executed. Vertices and texture coordinates
// do not come as commands, only in Draws.
class Watch {
  public:
    virtual ~Watch() = default;
    // Before the first command; null for a recorded program.
    virtual void start(const CommandList*) {}
    virtual void before(const Command&, const State&) {}
    virtual void after(const Command&, const State&) {}
    virtual void drawn(const Draw&, const State&) {}
    // A picture ends, and another follows.
    virtual void shown() {}
    // At the end of a whole program, with its next picture.
    virtual void redrawn(const Redraw&) {}
    // At the end, with the picture.
    virtual void finish(const Frame&, bool /*is_recorded*/) {}

    // drawn(), which makes the warnings that it gives ones about this Draw.
    void take(const Draw& draw, const State& state) {
        const std::size_t known = found_.size();
        drawn(draw, state);
        for (std::size_t i = known; i < found_.size(); ++i) found_[i].draw = draw.place;
    }

    // Whether it warns anew in each picture that has the mistake.
    virtual bool warns_again() const { return true; }

    std::vector<Warning> take() { return std::exchange(found_, {}); }

  protected:
    void warn(Warning warning) { found_.push_back(std::move(warning)); }

  private:
    std::vector<Warning> found_;
};

template <class Type>
std::unique_ptr<Watch> make_watch() {
    return std::make_unique<Type>();
}

// The rules of each file.
std::vector<Rule> light_rules(), material_rules(), overlay_rules(), normal_rules(), turned_normals_rules(),
    view_rules(), picture_rules(), between_vertices_rules(), redraw_rules(), later_picture_rules(),
    scaled_shininess_rules();

// Placeholders in the rules' scenes: a camera and a light that many share.
inline constexpr std::string_view kView = "// the view\n";
inline constexpr std::string_view kLight = "// the light\n";
std::string_view view_lines();
std::string_view light_lines();

// ---- Commands ----

bool is_effect(const Command& command, std::string_view effect);
// The number of GL_LIGHT0 to GL_LIGHT7; nullopt for other names.
std::optional<int> light_number(Enum light);
// glLight* of GL_LIGHT0 to GL_LIGHT7: the light's number; nullopt for other commands.
std::optional<int> light_of(const Command& command);
// The pname of glLight* or glMaterial*.
inline Enum pname_of(const Command& command) { return command.enumerant(1); }
// "line 7", "call 7".
std::string where(const Place& place);

// ---- Draws ----

std::vector<int> enabled_lights(const Draw& draw);  // of a lit Draw; empty for others
inline bool is_black(const glm::dvec4& color) { return color.r == 0 && color.g == 0 && color.b == 0; }
inline bool is_black(const LightSource& light) {
    return is_black(light.ambient) && is_black(light.diffuse) && is_black(light.specular);
}
// Flat drawing over the picture (orthographic, without depth test) that is lit as well. It is shown all Draws, in order.
class LitOverlays {
  public:
    bool is_overlay(const Draw& draw);

  private:
    bool has_perspective_ = false;
};

// Whether any enabled light has a colour of this kind.
bool has_specular_light(const Draw& draw);

// Whether a light of diffuse or specular colour lights it.
bool uses_normals(const Draw& draw);
// Whether the modelview matrix brings all of space onto a plane, as the matrix of a planar shadow does.
bool is_flattened(const Draw& draw);

// The direction from a point in eye coordinates to the viewer; of any length. A parallel projection may look along z, as one that
// is never set does, or along -z.
glm::dvec3 to_viewer(const Draw& draw, const glm::dvec3& point_eye);

// How many pixels of two pictures of one size differ by more than this in red, green or blue, from 0 to 1.
std::size_t differing_pixels(const Image& a, const Image& b, float visible);

// The frame with smaller sides; it shows the same.
Frame smaller(const Frame& frame);

// Triangles of a Draw by numbers of vertices; none for points and lines.
using Triangle = std::array<std::uint32_t, 3>;
std::vector<Triangle> triangles_of(const Draw& draw);
// Whether a triangle's height is more than rounding of its vertices, which are floats. The facets at the poles of a ball that a
// program computes can be as flat as 1e-17: they face nowhere.
bool has_direction(const Draw& draw, const Triangle& triangle);

// A lit vertex in eye coordinates.
struct EyeVertex {
    glm::dvec3 position, normal;  // the normal as GL lights it: after GL_NORMALIZE or GL_RESCALE_NORMAL
};
std::vector<EyeVertex> eye_vertices(const Draw& draw);

}  // namespace twinlight::lint
