// Rules about lights.
#include <algorithm>
#include <cmath>

#include "base/text/translation.h"
#include "judge/lint/watch.h"
#include "scene/command/text.h"

namespace twinlight::lint {

namespace {

// The last commands that set a light's parameters.
using Parameters = std::map<Enum, Command>;

bool is_identity(const glm::dmat4& matrix) { return matrix == glm::dmat4(1); }

// A light's position or spot direction as it was typed, and where.
struct Typed {
    Place place;
    glm::dvec4 value{0};
    Place camera{};  // of the gluLookAt after it that would have changed it
};

// GL_POSITION or GL_SPOT_DIRECTION before gluLookAt.
class BeforeCamera : public Watch {
  public:
    explicit BeforeCamera(Enum pname) : pname_(pname) {}

    void after(const Command& command, const State& state) override {
        if (is_effect(command, "look_at") && state.attributes().matrix_mode == kGL_MODELVIEW)
            return camera(command, state);
        const std::optional<int> light = light_of(command);
        if (!light) return;
        const auto at = static_cast<std::size_t>(*light);
        if (pname_of(command) == kGL_POSITION) position_at_[at] = !is_identity(state.modelview());
        if (pname_of(command) != pname_) return;
        typed_[at].reset();
        if (!is_identity(state.modelview())) return;
        Typed typed{command.place};
        for (int i = 0; i < static_cast<int>(command.array().size()) && i < 4; ++i)
            typed.value[i] = command.array()[static_cast<std::size_t>(i)];
        typed_[at] = typed;
    }

    void drawn(const Draw& draw, const State&) override {
        for (const int light : enabled_lights(draw)) {
            if (light >= kMaxLights) continue;
            const auto at = static_cast<std::size_t>(light);
            if (!typed_[at] || typed_[at]->camera.line == 0) continue;
            const bool is_direction = pname_ == kGL_SPOT_DIRECTION;
            if (is_direction && (!position_at_[at] || !draw.lighting.lights[at].has_cutoff())) continue;
            const Typed& typed = *typed_[at];
            warn({.place = typed.place,
                  .message =
                      tr("the {} of {} is set before gluLookAt ({}), so the light moves with the camera",
                         is_direction ? tr("spot direction") : tr("position"), light_name(light), where(typed.camera)),
                  .fix = tr("call glLightfv({}, {}, ...) after gluLookAt", light_name(light), enum_name(pname_)),
                  .edits = {{.place = typed.camera, .is_after = true, .moved = typed.place}},
                  .key = light_name(light)});
            typed_[at].reset();
        }
    }

  private:
    // Marks the values that this camera would have changed. A light at the eye, or along the view, is a headlight.
    void camera(const Command& command, const State& state) {
        for (auto& typed : typed_) {
            if (!typed || typed->camera.line != 0) continue;
            const glm::dvec4& v = typed->value;
            const bool is_headlight = v.x == 0 && v.y == 0 && (v.w == 0 || v.z == 0);
            const glm::dvec4 moved = state.modelview() * v;
            if (!is_headlight && glm::distance(moved, v) > 0.01 * glm::length(v)) typed->camera = command.place;
        }
    }

    Enum pname_;
    std::array<std::optional<Typed>, kMaxLights> typed_{};
    std::array<bool, kMaxLights> position_at_{};  // set after the camera
};

struct PositionBeforeCamera : BeforeCamera {
    PositionBeforeCamera() : BeforeCamera(kGL_POSITION) {}
};
struct DirectionBeforeCamera : BeforeCamera {
    DirectionBeforeCamera() : BeforeCamera(kGL_SPOT_DIRECTION) {}
};

// Collects, for each light, whether some state holds in every lit Draw that uses the light. Warns at the last command that set
// one of `pnames`.
class InEveryDraw : public Watch {
  public:
    void after(const Command& command, const State&) override {
        const std::optional<int> light = light_of(command);
        if (light) parameters_[static_cast<std::size_t>(*light)].insert_or_assign(pname_of(command), command);
    }
    void drawn(const Draw& draw, const State&) override {
        for (const int light : enabled_lights(draw)) {
            if (light >= kMaxLights) continue;
            const auto at = static_cast<std::size_t>(light);
            used_[at] = true;
            if (!is_wrong(draw.lighting.lights[at])) is_right_[at] = true;
        }
    }
    void finish(const Frame&, bool) override {
        for (int light = 0; light < kMaxLights; ++light) {
            const auto at = static_cast<std::size_t>(light);
            if (used_[at] && !is_right_[at]) report(light, parameters_[at]);
        }
    }

  protected:
    virtual bool is_wrong(const LightSource& light) const = 0;
    virtual void report(int light, const Parameters& parameters) = 0;
    // The last of these parameters that was set; null if none was.
    static const Place* last_of(const Parameters& parameters, std::initializer_list<Enum> pnames) {
        const Place* last = nullptr;
        for (const Enum pname : pnames)
            if (const auto found = parameters.find(pname); found != parameters.end())
                if (!last || found->second.place.line > last->line) last = &found->second.place;
        return last;
    }

    // Warns about a light with w = 0, which w = 1 fixes.
    void warn_directional(int light, const Place& place, std::string message, const Parameters& parameters) {
        Warning warning{.place = place,
                        .message = std::move(message),
                        .fix = tr("set w of GL_POSITION to 1: glLightfv({}, GL_POSITION, (GLfloat[]){{x, y, z, 1}})",
                                  light_name(light))};
        if (const auto found = parameters.find(kGL_POSITION); found != parameters.end()) {
            Command positional = found->second;
            positional.arguments.back() = 1;
            warning.edits = {{.place = positional.place, .removes = true, .insert = print_command(positional)}};
        }
        warn(std::move(warning));
    }

  private:
    std::array<Parameters, kMaxLights> parameters_;
    std::array<bool, kMaxLights> used_{}, is_right_{};
};

class AttenuationOfDirectional : public InEveryDraw {
    bool is_wrong(const LightSource& light) const override {
        return light.is_directional() && !light.has_initial_attenuation();
    }
    void report(int light, const Parameters& parameters) override {
        const Place* place =
            last_of(parameters, {kGL_CONSTANT_ATTENUATION, kGL_LINEAR_ATTENUATION, kGL_QUADRATIC_ATTENUATION});
        if (!place) return;
        warn_directional(light, *place,
                         tr("the attenuation of {} has no effect, because {}", light_name(light),
                            parameters.contains(kGL_POSITION)
                                ? tr("its position has w = 0")
                                : tr("its position is never set, and the initial one (0, 0, 1, 0) has w = 0")),
                         parameters);
    }
};

// GL_LIGHT0 of which only the ambient colour is set. A light whose diffuse colour or position is set, or nothing at all, may be
// meant for the viewer's head.
class OnlyAmbientSet : public InEveryDraw {
    bool is_wrong(const LightSource& light) const override {
        const LightingState state;
        const LightSource& initial = state.lights[0];
        return light.diffuse == initial.diffuse && light.position_eye == initial.position_eye;
    }
    void report(int light, const Parameters& parameters) override {
        const Place* place = last_of(parameters, {kGL_AMBIENT});
        if (light != 0 || !place || parameters.size() != 1) return;
        warn({.place = *place,
              .message =
                  tr("only the ambient colour of GL_LIGHT0 is set: it also shines white, from the viewer, with its "
                     "initial diffuse colour and position"),
              .fix = tr("glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){x, y, z, 1}); or, for ambient light only, "
                        "GL_LIGHT_MODEL_AMBIENT instead of this light")});
    }
};

class SpotOfDirectional : public InEveryDraw {
    bool is_wrong(const LightSource& light) const override { return light.is_directional() && light.has_cutoff(); }
    void report(int light, const Parameters& parameters) override {
        const Place* place = last_of(parameters, {kGL_SPOT_CUTOFF});
        if (!place) return;
        warn_directional(light, *place,
                         tr("{} is a spotlight with w = 0: it has no place, so its cone contains all points or none",
                            light_name(light)),
                         parameters);
    }
};

class SpotWithoutCutoff : public InEveryDraw {
    bool is_wrong(const LightSource& light) const override { return !light.is_spot(); }
    void report(int light, const Parameters& parameters) override {
        const Place* place = last_of(parameters, {kGL_SPOT_DIRECTION, kGL_SPOT_EXPONENT});
        if (!place || parameters.contains(kGL_SPOT_CUTOFF)) return;
        const std::string call = fmt::format("glLightf({}, GL_SPOT_CUTOFF, 30);", light_name(light));
        warn({.place = *place,
              .message = tr("{} shines in all directions: its GL_SPOT_CUTOFF is 180, so its other spot values "
                            "have no effect",
                            light_name(light)),
              .fix = call,
              .edits = {{.place = *place, .insert = call, .is_after = true}}});
    }
};

// A light that is on, but has no colour because it is not GL_LIGHT0 and none was set.
class BlackLight : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (is_effect(command, "enable"))
            if (const int light = light_number(command.enumerant(0)).value_or(0); light > 0)
                enabled_.insert_or_assign(light, command.place);
        const std::optional<int> light = light_of(command);
        const auto is_color = [](Enum pname) {
            return pname == kGL_AMBIENT || pname == kGL_DIFFUSE || pname == kGL_SPECULAR;
        };
        if (light && is_color(pname_of(command))) colored_.insert(*light);
    }
    void drawn(const Draw& draw, const State&) override {
        for (const int light : enabled_lights(draw))
            if (is_black(draw.lighting.lights[static_cast<std::size_t>(light)])) used_.insert(light);
    }
    void finish(const Frame&, bool) override {
        for (const auto& [light, place] : enabled_) {
            if (colored_.contains(light) || !used_.contains(light)) continue;
            const std::string call =
                fmt::format("glLightfv({}, GL_DIFFUSE, (GLfloat[]){{1, 1, 1, 1}});", light_name(light));
            warn({.place = place,
                  .message = tr("{} is on but black: only GL_LIGHT0 starts with a colour", light_name(light)),
                  .fix = call,
                  .edits = {{.place = place, .insert = call}}});
        }
    }

  private:
    std::map<int, Place> enabled_;
    std::set<int> colored_, used_;
};

// A light whose values are set, but that no Draw uses, although other lights are used.
class LightNeverEnabled : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (const std::optional<int> light = light_of(command)) first_.try_emplace(*light, command.place);
        if (is_effect(command, "enable") || is_effect(command, "disable"))
            if (const std::optional<int> light = light_number(command.enumerant(0))) switched_.insert(*light);
    }
    void drawn(const Draw& draw, const State&) override { is_lit_ |= draw.lighting.enabled; }
    void finish(const Frame&, bool) override {
        if (!is_lit_) return;
        for (const auto& [light, place] : first_) {
            if (switched_.contains(light)) continue;
            const std::string call = fmt::format("glEnable({});", light_name(light));
            warn({.place = place,
                  .message = tr("{} is set, but never enabled", light_name(light)),
                  .fix = call,
                  .edits = {{.place = place, .insert = call}}});
        }
    }

  private:
    std::map<int, Place> first_;
    std::set<int> switched_;
    bool is_lit_ = false;
};

class LightingOff : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (is_effect(command, "disable") && command.enumerant(0) == kGL_LIGHTING) is_chosen_ = true;
        const bool enables_light = is_effect(command, "enable") && light_number(command.enumerant(0));
        if (first_.line == 0 && (light_of(command) || enables_light)) first_ = command.place;
        if (material_.line == 0 && is_effect(command, "material")) material_ = command.place;
    }
    void drawn(const Draw& draw, const State&) override { is_lit_ |= draw.lighting.enabled; }
    void finish(const Frame&, bool) override {
        const bool has_light = first_.line != 0;
        const Place& place = has_light ? first_ : material_;
        if (place.line == 0 || is_lit_ || is_chosen_) return;
        warn({.place = place,
              .message = tr("the scene sets {}, but nothing is lit: GL_LIGHTING is never enabled",
                            has_light ? tr("lights") : tr("a material")),
              .fix = has_light ? "glEnable(GL_LIGHTING);" : tr("glEnable(GL_LIGHTING); and glEnable(GL_LIGHT0);"),
              .edits = {
                  {.place = place,
                   .insert = has_light ? "glEnable(GL_LIGHTING);" : "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);"}}});
    }

  private:
    Place first_, material_;
    bool is_lit_ = false, is_chosen_ = false;
};

class NoLightOn : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (is_effect(command, "enable") && command.enumerant(0) == kGL_LIGHTING && place_.line == 0)
            place_ = command.place;
    }
    void drawn(const Draw& draw, const State&) override {
        if (!draw.lighting.enabled) return;
        is_lit_ = true;
        has_light_ |= !enabled_lights(draw).empty() || !is_black(draw.lighting.front.emission);
    }
    void finish(const Frame&, bool) override {
        if (!is_lit_ || has_light_ || place_.line == 0) return;
        warn({.place = place_,
              .message = tr("GL_LIGHTING is enabled, but no light is: there is only dim ambient light"),
              .fix = "glEnable(GL_LIGHT0);",
              .edits = {{.place = place_, .insert = "glEnable(GL_LIGHT0);", .is_after = true}}});
    }

  private:
    Place place_;
    bool is_lit_ = false, has_light_ = false;
};

class OddW : public Watch {
    void after(const Command& command, const State&) override {
        const std::optional<int> light = light_of(command);
        if (!light || pname_of(command) != kGL_POSITION || command.array().size() < 4) return;
        const double w = command.array()[3];
        if (w == 0 || w == 1) return;
        warn({.place = command.place,
              .message = tr("the fourth number (w) of {}'s position is {}: GL divides x, y and z by it",
                            light_name(*light), w),
              .fix = tr("give four numbers: w is 1 for a place, 0 for a direction"),
              .key = light_name(*light)});
    }
};

// Colours in 0..255 for parameters that count from 0 to 1.
class Color255 : public Watch {
    void after(const Command& command, const State& state) override {
        const ParameterInfo* info = parameter_info(command);
        const bool is_parameter =
            info && info->meaning == Meaning::kColor && command.sig().parameters.back().kind == Kind::kFloat;
        const bool is_color =
            (is_effect(command, "color") || is_effect(command, "clear_color")) &&
            (command.sig().parameters[0].kind == Kind::kFloat || command.sig().parameters[0].kind == Kind::kDouble);
        if ((!is_parameter && !is_color) || state.render_mode() != kGL_RENDER) return;
        const auto values = is_parameter ? command.array() : std::span<const double>(command.arguments);
        double largest = 0;
        for (std::size_t i = 0; i < values.size() && i < 3; ++i) {
            if (values[i] < 0 || values[i] > 255 || values[i] != std::floor(values[i])) return;
            largest = std::max(largest, values[i]);
        }
        if (largest < 16) return;
        Command divided = command;
        for (std::size_t i = divided.arguments.size() - values.size(); i < divided.arguments.size(); ++i)
            divided.arguments[i] = std::round(std::min(1.0, divided.arguments[i] / 255) * 1000) / 1000;
        warn({.place = command.place,
              .message = tr("{} is given the colour {}, {}, {}, but colours here go from 0 to 1", command.name(),
                            values[0], values[1], values[2]),
              .fix = tr("divide by 255: {}", print_command(divided)),
              .edits = {{.place = command.place, .removes = true, .insert = print_command(divided)}}});
    }
};

// Integers that GL maps to almost 0.
class TinyInteger : public Watch {
    void after(const Command& command, const State&) override {
        const ParameterInfo* info = parameter_info(command);
        const bool is_parameter = info && info->meaning == Meaning::kColor;
        if (!is_parameter && !is_effect(command, "color")) return;
        const Kind kind = is_parameter ? command.sig().parameters.back().kind : command.sig().parameters[0].kind;
        if (kind != Kind::kInt && kind != Kind::kUint && kind != Kind::kShort && kind != Kind::kUshort &&
            kind != Kind::kUbyte)
            return;
        const auto values = is_parameter ? command.array() : std::span<const double>(command.arguments);
        double largest = 0;
        for (std::size_t i = 0; i < values.size() && i < 3; ++i) largest = std::max(largest, std::abs(values[i]));
        if (largest == 0 || largest > (kind == Kind::kUbyte ? 1 : 255)) return;
        const double white = kind == Kind::kUbyte    ? 255
                             : kind == Kind::kShort  ? 32767
                             : kind == Kind::kUshort ? 65535
                             : kind == Kind::kInt    ? 2147483647
                                                     : 4294967295.0;
        warn({.place = command.place,
              .message = tr("{} is given whole numbers up to {}, but for this type white is {}: the colour is "
                            "almost black",
                            command.name(), largest, white),
              .fix = kind == Kind::kUbyte ? tr("use glColor3f for colours from 0 to 1")
                                          : tr("use glColor3ub for colours from 0 to 255, or floats from 0 to 1")});
    }
};

}  // namespace

std::vector<Rule> light_rules() {
    return {
        {"lighting-off",
         "Lights or materials are set, but `GL_LIGHTING` is never enabled, so every object has its plain colour.",
         "Section 2.14.1: without `GL_LIGHTING` the vertex has the current colour.", "glEnable(GL_LIGHTING);",
         R"(// the view
 glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});
+glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<LightingOff>},
        {"no-light-on", "`GL_LIGHTING` is enabled, but no light is. Only the ambient light of the scene is left.",
         "Section 2.14.1: the sum is over the enabled lights; initially all are disabled (table 6.8).",
         "glEnable(GL_LIGHT0);",
         R"(// the view
 glEnable(GL_LIGHTING);
+glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<NoLightOn>},
        {"light-never-enabled", "The values of a light are set, but the light is never enabled.",
         "Section 2.14.1: a light that is not enabled adds nothing.", "glEnable(GL_LIGHT1);",
         R"(// the view
// the light
+glEnable(GL_LIGHT1);
 glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){-5, 0, 3, 1});
 glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){0.2, 0.3, 1, 1});
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<LightNeverEnabled>},
        {"light-black", "A light other than `GL_LIGHT0` is on, but its colours were never set. They are black.",
         "Table 2.10: the initial diffuse and specular colours are white for `GL_LIGHT0`, and black for all others.",
         "glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});",
         R"(// the view
// the light
 glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){-5, 0, 3, 1});
+glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});
 glEnable(GL_LIGHT1);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<BlackLight>},
        {"light-before-camera",
         "The position of a light is set before `gluLookAt`. The light then keeps its place relative to the camera, "
         "not to the scene. (For a lamp on the camera this is right: silence the warning.)",
         "Section 2.14.1: a position is transformed by the modelview matrix of the moment when it is set, and kept in "
         "eye coordinates.",
         "glLightfv(GL_LIGHT0, GL_POSITION, ...) after gluLookAt",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glEnable(GL_DEPTH_TEST);
 glMatrixMode(GL_PROJECTION);
 gluPerspective(45, 4.0 / 3.0, 1, 100);
 glMatrixMode(GL_MODELVIEW);
-glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 5, 1, 1});
 gluLookAt(5, 1, 0,  0, 0, 0,  0, 1, 0);
+glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 5, 1, 1});
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<PositionBeforeCamera>},
        {"spot-direction-before-camera",
         "The direction of a spotlight is set before `gluLookAt`, but its position after it. The cone then turns with "
         "the camera.",
         "Section 2.14.1: a spot direction is transformed by the upper left 3x3 of the modelview matrix of the moment "
         "when it is set.",
         "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, ...) after gluLookAt",
         R"( glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
 glEnable(GL_DEPTH_TEST);
 glMatrixMode(GL_PROJECTION);
 gluPerspective(45, 4.0 / 3.0, 1, 100);
 glMatrixMode(GL_MODELVIEW);
-glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0});
 gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
+glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0});
 glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 4, 0, 1});
 glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 15);
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 80, 40);
)",
         make_watch<DirectionBeforeCamera>},
        {"attenuation-directional",
         "A light has an attenuation, but its position has w = 0. The attenuation has no effect.",
         "Section 2.14.1: the attenuation factor is 1 where the light's w is 0. Such a light is a direction, "
         "infinitely far away.",
         "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){x, y, z, 1});",
         R"(// the view
-glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3, 0});
+glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3, 1});
 glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.3);
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<AttenuationOfDirectional>},
        {"light0-initial",
         "Only the ambient colour of `GL_LIGHT0` is set. The light also shines white, from the viewer. (For a lamp at "
         "the "
         "viewer's head, set its position or its diffuse colour.)",
         "Table 2.10: the initial diffuse and specular colours of `GL_LIGHT0` are white, and its initial position is "
         "(0, 0, 1, 0), the direction to the viewer. `GL_LIGHT_MODEL_AMBIENT` is ambient light without a lamp.",
         "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){x, y, z, 1});",
         R"(// the view
 glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){0.3, 0.3, 0.3, 1});
+glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<OnlyAmbientSet>},
        {"spot-directional",
         "A light is a spotlight, but its position has w = 0. Every point lies in the same direction from it, so the "
         "cone contains everything or nothing.",
         "Section 2.14.1: the cone compares the direction to the vertex with the spot direction; with w = 0 it is the "
         "same for all vertices.",
         "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){x, y, z, 1});",
         R"(// the view
-glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 4, 0, 0});
+glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 4, 0, 1});
 glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0});
 glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 15);
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 80, 40);
)",
         make_watch<SpotOfDirectional>},
        {"spot-without-cutoff",
         "The direction or the exponent of a spotlight is set, but not its cutoff. The light shines in all directions.",
         "Section 2.14.1: the spotlight factor is 1 where `GL_SPOT_CUTOFF` is 180, its initial value.",
         "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);",
         R"(// the view
 glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 2.5, 0, 1});
 glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0});
+glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 80, 40);
)",
         make_watch<SpotWithoutCutoff>},
        {"light-w",
         "The fourth number (w) of a light's position is neither 0 nor 1. Often the array has only three numbers, and "
         "GL reads what lies after it in memory.",
         "Section 2.14.1: positions are homogeneous: x, y and z are divided by w, and w = 0 is a direction.",
         "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){x, y, z, 1});",
         R"(// the view
-glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 2.5});
+glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});
 glEnable(GL_LIGHTING);
 glEnable(GL_LIGHT0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<OddW>},
        {"color-255", "A colour is given as 0 to 255, but GL's range is 0 to 1. Everything it lights is white.",
         "Section 2.14.1: colours are floats; 1 is full intensity, and sums above 1 are clamped (2.14.6).",
         "divide by 255, or use glColor3ub",
         R"(// the view
// the light
-glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){255, 128, 64, 255});
+glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.5, 0.25, 1});
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<Color255>},
        {"color-integer", "A colour is given as small whole numbers to a function for integers. It is almost black.",
         "Table 2.9: the largest number of an integer type is 1.0, so 255 as a GLint is 0.00000012.",
         "glColor3f for 0 to 1, glColor3ub for 0 to 255",
         R"(// the view
-glColor3i(1, 0, 0);
+glColor3f(1, 0, 0);
 glutSolidSphere(1.5, 40, 20);
)",
         make_watch<TinyInteger>},
    };
}

}  // namespace twinlight::lint
