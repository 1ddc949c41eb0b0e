// Rules about a program's second picture: what its first one left in GL's state, and how lights and objects moved.
#include <algorithm>
#include <cmath>

#include "base/text/translation.h"
#include "judge/lint/watch.h"
#include "render/reference/reference.h"
#include "scene/frame/parameter_rows.h"

namespace twinlight::lint {

namespace {

constexpr std::size_t kMostDraws = 2000;  // of a picture that are looked at

// A Draw's statement, and how often its picture ran it before.
using Occurrence = std::tuple<std::string, int, int, int>;

class Occurrences {
  public:
    // Calls of a recording without places of its source are counted.
    Occurrence next(const Place& place) {
        const bool is_call = place.column == Place::kCallNumber;
        const std::tuple<std::string, int, int> key{place.file ? *place.file : "", is_call ? 0 : place.line,
                                                    place.column};
        return std::tuple_cat(key, std::tuple(counts_[key]++));
    }

  private:
    std::map<std::tuple<std::string, int, int>, int> counts_;
};

// ---- What one picture leaves for the next ----

// A part of the state that one command sets: {glEnable, GL_LIGHTING}, {glLight, GL_LIGHT1, GL_POSITION}.
struct Variable {
    enum class Kind : std::uint8_t { kEnable, kLight, kMaterial, kLightModel, kShadeModel, kColor };
    Kind kind;
    Enum first = 0, second = 0;

    friend auto operator<=>(const Variable&, const Variable&) = default;
};

std::vector<Variable> variables_of(const Command& command) {
    using Kind = Variable::Kind;
    if (is_effect(command, "enable") || is_effect(command, "disable")) return {{Kind::kEnable, command.enumerant(0)}};
    if (light_of(command)) return {{Kind::kLight, command.enumerant(0), pname_of(command)}};
    if (is_effect(command, "light_model")) return {{Kind::kLightModel, command.enumerant(0)}};
    if (is_effect(command, "shade_model")) return {{Kind::kShadeModel}};
    if (is_effect(command, "color")) return {{Kind::kColor}};
    if (!is_effect(command, "material") || command.enumerant(0) == kGL_BACK) return {};
    if (pname_of(command) != kGL_AMBIENT_AND_DIFFUSE) return {{Kind::kMaterial, kGL_FRONT, pname_of(command)}};
    return {{Kind::kMaterial, kGL_FRONT, kGL_AMBIENT}, {Kind::kMaterial, kGL_FRONT, kGL_DIFFUSE}};
}

// glDisable(GL_LIGHTING), glLightfv(GL_LIGHT1, GL_POSITION): without values.
std::string short_call(const Command& command) {
    std::string names;
    const auto& parameters = command.sig().parameters;
    for (std::size_t i = 0; i < parameters.size() && parameters[i].kind == Kind::kEnum; ++i)
        names += fmt::format("{}{}", i == 0 ? "" : ", ", enum_name(command.enumerant(i)));
    return names.empty() ? std::string(command.name()) : fmt::format("{}({})", command.name(), names);
}

bool* flag_of(Draw& draw, Enum capability) {
    switch (capability) {
        case kGL_LIGHTING: return &draw.lighting.enabled;
        case kGL_NORMALIZE: return &draw.lighting.normalize;
        case kGL_RESCALE_NORMAL: return &draw.lighting.rescale_normal;
        case kGL_COLOR_MATERIAL: return &draw.lighting.color_material.enabled;
        case kGL_DEPTH_TEST: return &draw.raster.depth_test;
        case kGL_CULL_FACE: return &draw.raster.cull_enabled;
        case kGL_BLEND: return &draw.fragment.blend;
        default: break;
    }
    if (const auto light = light_number(capability))
        return &draw.lighting.lights[static_cast<std::size_t>(*light)].enabled;
    return nullptr;
}

// Visits what a Draw has of each Variable that can count for it: visit(variable, values).
template <class Visit>
void for_each_variable(const Draw& draw, const Visit& visit) {
    using Kind = Variable::Kind;
    const LightingState& lighting = draw.lighting;
    const auto visit_flag = [&](Enum capability, bool value) {
        visit(Variable{Kind::kEnable, capability}, std::vector<double>{value ? 1.0 : 0.0});
    };
    visit_flag(kGL_LIGHTING, lighting.enabled);
    visit_flag(kGL_DEPTH_TEST, draw.raster.depth_test);
    visit_flag(kGL_CULL_FACE, draw.raster.cull_enabled);
    visit_flag(kGL_BLEND, draw.fragment.blend);
    const bool has_one_color = !draw.vertices.empty() && std::ranges::all_of(draw.vertices, [&](const Vertex& vertex) {
        return vertex.color == draw.vertices.front().color;
    });
    if (has_one_color && !draw.pixels && (!lighting.enabled || lighting.color_material.enabled)) {
        const glm::dvec4& color = draw.vertices.front().color;
        visit(Variable{Kind::kColor}, std::vector<double>{color.r, color.g, color.b, color.a});
    }
    if (!lighting.enabled) return;
    visit_flag(kGL_NORMALIZE, lighting.normalize);
    visit_flag(kGL_RESCALE_NORMAL, lighting.rescale_normal);
    visit_flag(kGL_COLOR_MATERIAL, lighting.color_material.enabled);
    visit(Variable{Kind::kShadeModel}, std::vector<double>{static_cast<double>(lighting.shade_model)});
    for (const auto& row : kLightModelParameters)
        visit(Variable{Kind::kLightModel, row.pname}, values_of(lighting.light_model, row));
    for (std::size_t i = 0; i < kMaxLights; ++i) {
        const LightSource& light = lighting.lights[i];
        const Enum name = kGL_LIGHT0 + static_cast<Enum>(i);
        visit_flag(name, light.enabled);
        if (!light.enabled) continue;
        for (const auto& row : kLightParameters) visit(Variable{Kind::kLight, name, row.pname}, values_of(light, row));
    }
    if (!draw.materials.empty() || lighting.color_material.enabled) return;
    for (const auto& row : kMaterialParameters)
        visit(Variable{Kind::kMaterial, kGL_FRONT, row.pname}, values_of(lighting.front, row));
}

void set(Draw& draw, const Variable& variable, const std::vector<double>& values) {
    switch (variable.kind) {
        case Variable::Kind::kEnable:
            if (bool* flag = flag_of(draw, variable.first)) *flag = values[0] != 0;
            break;
        case Variable::Kind::kLight:
            set_parameter(draw.lighting.lights[variable.first - kGL_LIGHT0],
                          *find_parameter_row<LightSource>(variable.second), values);
            break;
        case Variable::Kind::kMaterial:
            set_parameter(draw.lighting.front, *find_parameter_row<Material>(variable.second), values);
            break;
        case Variable::Kind::kLightModel:
            set_parameter(draw.lighting.light_model, *find_parameter_row<LightModel>(variable.first), values);
            break;
        case Variable::Kind::kShadeModel: draw.lighting.shade_model = static_cast<Enum>(values[0]); break;
        case Variable::Kind::kColor:
            for (Vertex& vertex : draw.vertices.edit()) vertex.color = {values[0], values[1], values[2], values[3]};
            break;
    }
}

// A call late in a picture whose effect stays, and changes earlier objects of the next picture.
class LeftForNextPicture : public Watch {
  public:
    void after(const Command& command, const State&) override {
        if (picture_ > 1) {
            for (const Variable& variable : variables_of(command)) last_.erase(variable);
        } else {
            for (const Variable& variable : variables_of(command))
                last_.insert_or_assign(variable, Set{command, drawn_});
        }
    }
    void shown() override {
        ++picture_;
        drawn_ = 0;
        occurrences_ = {};
        found_.clear();
    }
    void drawn(const Draw& draw, const State&) override {
        if (drawn_ >= kMostDraws || picture_ > 2) return;
        const Occurrence occurrence = occurrences_.next(draw.place);
        const std::size_t number = drawn_++;
        if (picture_ == 1) {
            Before before{number, {}};
            for_each_variable(draw, [&](const Variable& variable, std::vector<double> values) {
                before.values.emplace(variable, std::move(values));
            });
            first_.emplace(occurrence, std::move(before));
            return;
        }
        const auto before = first_.find(occurrence);
        if (before == first_.end()) return;
        for_each_variable(draw, [&](const Variable& variable, const std::vector<double>& values) {
            const auto set_late = last_.find(variable);
            const auto value = before->second.values.find(variable);
            if (set_late == last_.end() || set_late->second.drawn <= before->second.number) return;
            if (value == before->second.values.end() || value->second == values) return;
            Left& left = found_.try_emplace(variable, Left{set_late->second.command, {}}).first->second;
            left.changes.push_back({number, draw.place, value->second});
        });
    }
    void finish(const Frame& frame, bool) override {
        if (picture_ != 2) return;
        const std::vector<const Draw*> draws = frame.draws();
        if (found_.empty() || draws.size() != drawn_) return;
        constexpr float kVisible = 10.0F / 255;
        constexpr std::size_t kFew = 12;  // pixels at borders
        const Frame small = smaller(frame);
        const Image picture = reference::render(small, {});
        for (const auto& [variable, left] : found_) {
            Frame other = small;
            const std::vector<Draw*> changed = other.editable_draws();
            for (const Change& change : left.changes) set(*changed[change.number], variable, change.value);
            if (differing_pixels(picture, reference::render(other, {}), kVisible) > kFew) report(variable, left);
        }
    }

  private:
    struct Set {
        Command command;
        std::size_t drawn;  // how many Draws of the first picture came before it
    };
    struct Before {
        std::size_t number;  // in its picture
        std::map<Variable, std::vector<double>> values;
    };
    struct Change {
        std::size_t number;  // of the Draw in the second picture
        Place place;
        std::vector<double> value;  // in the first picture
    };

    struct Left {
        Command command;
        std::vector<Change> changes;
    };

    void report(const Variable& variable, const Left& left) {
        const Command& command = left.command;
        const Change& change = left.changes.front();
        Warning warning{.place = command.place,
                        .message = tr("this {} still holds when the next picture starts: {} is drawn without "
                                      "it in the first picture, and with it in all others",
                                      short_call(command), where(change.place)),
                        .fix = {},
                        .key = fmt::format("{}:{}", command.place.line, command.place.column)};
        if (variable.kind == Variable::Kind::kEnable) {
            // Light is what objects of a lit scene lack.
            const bool is_light = variable.first == kGL_LIGHTING || light_number(variable.first);
            const std::string call = fmt::format("{}({});", is_light || change.value[0] != 0 ? "glEnable" : "glDisable",
                                                 enum_name(variable.first));
            warning.fix = tr("{} before {}", call, where(change.place));
            warning.edits = {{.place = change.place, .insert = call}};
        } else {
            warning.fix =
                tr("call it before {} in each picture, or set the value back after the object that "
                   "it is for",
                   where(change.place));
        }
        warn(std::move(warning));
    }

    int picture_ = 1;
    std::size_t drawn_ = 0;
    Occurrences occurrences_;
    std::map<Variable, Set> last_;  // of the first picture, and not set again since
    std::map<Occurrence, Before> first_;
    std::map<Variable, Left> found_;
};

// ---- How lights move from one picture to the next ----

// A GL_POSITION or GL_SPOT_DIRECTION, as a picture set it.
struct SetLight {
    Command command;
    glm::dmat4 modelview;
    bool is_before_identity = true;  // no glLoadIdentity in this picture came before it
    std::optional<Place> camera{};   // of the gluLookAt before it
    std::optional<Place> turn{};     // of the last glRotate before it
};

bool same_matrix(const glm::dmat4& a, const glm::dmat4& b) {
    constexpr double kRounding = 1e-5;  // of matrices that programs compute in floats
    double size = 0, difference = 0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            size = std::max(size, std::abs(a[column][row]));
            difference = std::max(difference, std::abs(a[column][row] - b[column][row]));
        }
    return difference <= kRounding * size;
}

// Collects the lights of the first two pictures, each set by the same statement with the same values.
class MovingLights : public Watch {
  public:
    void after(const Command& command, const State& state) override {
        if (picture_ > 2) return;
        if (state.attributes().matrix_mode == kGL_MODELVIEW) {
            if (is_effect(command, "load_identity") || is_effect(command, "load_matrix")) {
                reset_ = command.place;
                turn_.reset();
                camera_.reset();
                loaded();
            }
            if (is_effect(command, "look_at")) {
                camera_ = command.place;
                turn_.reset();
            }
            if (is_effect(command, "rotate")) turn_ = command.place;
        }
        const std::optional<int> light = light_of(command);
        const bool moves = light && (pname_of(command) == kGL_POSITION || pname_of(command) == kGL_SPOT_DIRECTION);
        if (!moves) return;
        SetLight now{command, state.modelview(), !reset_, camera_, turn_};
        const Occurrence occurrence = occurrences_.next(command.place);
        if (picture_ == 1) {
            first_.insert_or_assign(occurrence, std::move(now));
            return;
        }
        const auto before = first_.find(occurrence);
        if (before == first_.end() || before->second.command.arguments != command.arguments) return;
        if (!same_matrix(before->second.modelview, now.modelview)) moved(*light, before->second, now);
    }
    void shown() override {
        ++picture_;
        occurrences_ = {};
        reset_.reset();
        camera_.reset();
        turn_.reset();
    }

  protected:
    virtual void moved(int light, const SetLight& before, const SetLight& now) = 0;
    virtual void loaded() {}
    int picture() const { return picture_; }
    const std::optional<Place>& reset() const { return reset_; }

  private:
    int picture_ = 1;
    Occurrences occurrences_;
    std::map<Occurrence, SetLight> first_;
    std::optional<Place> reset_, camera_, turn_;  // of this picture
};

// A light that is set before glLoadIdentity, with the matrix that the picture before left.
class LightBeforeIdentity : public MovingLights {
    void moved(int, const SetLight&, const SetLight& now) override {
        if (now.is_before_identity) waiting_.push_back(now.command);
    }
    void loaded() override {
        for (const Command& command : waiting_)
            warn({.place = command.place,
                  .message =
                      tr("the {} of {} is set before glLoadIdentity ({}): from the second picture on the "
                         "matrix that the previous picture left moves it",
                         enum_name(pname_of(command)), light_name(light_of(command).value_or(0)), where(*reset())),
                  .fix = tr("call glLoadIdentity before it, and set the camera there"),
                  .edits = {{.place = *reset(), .is_after = true, .moved = command.place}},
                  .key = fmt::format("{}:{}", command.place.line, command.place.column)});
        waiting_.clear();
    }

    std::vector<Command> waiting_;
};

// A light that turns together with all that it lights.
class LightTurnsWithObjects : public MovingLights {
  public:
    void drawn(const Draw& draw, const State&) override {
        if (picture() > 2 || drawn_ >= kMostDraws || !draw.lighting.enabled) return;
        ++drawn_;
        const Occurrence occurrence = draws_.next(draw.place);
        if (picture() == 1)
            matrices_.emplace(occurrence, draw.eye_from_object);
        else if (const auto before = matrices_.find(occurrence); before != matrices_.end())
            steps_.push_back({draw.place, draw.eye_from_object * glm::inverse(before->second)});
        else
            has_new_ = true;
    }
    void shown() override {
        MovingLights::shown();
        drawn_ = 0;
        draws_ = {};
    }
    void finish(const Frame&, bool) override {
        if (picture() != 2 || has_new_ || steps_.empty()) return;
        const bool is_one_object =
            std::ranges::all_of(steps_, [&](const DrawnStep& step) { return step.place == steps_.front().place; });
        for (const TurnedLight& light : turned_) {
            // Where only matrices turn all objects, these may be the camera.
            if (!light.camera && !is_one_object) continue;
            if (!std::ranges::all_of(steps_, [&](const DrawnStep& step) { return same_matrix(step.step, light.step); }))
                continue;
            Warning warning{
                .place = light.place,
                .message = tr("{} turns with the objects, so the same sides are always lit: its position is set "
                              "after their glRotate ({})",
                              light.name, where(light.turn)),
                .fix = tr("set its position before the glRotate, right after the camera"),
                .key = light.name};
            if (light.camera) warning.edits = {{.place = *light.camera, .is_after = true, .moved = light.place}};
            warn(std::move(warning));
        }
    }

  private:
    struct DrawnStep {
        Place place;
        glm::dmat4 step;  // from the eye coordinates of the first picture to those of the second
    };
    struct TurnedLight {
        std::string name;
        Place place, turn;
        std::optional<Place> camera;
        glm::dmat4 step;
    };

    void moved(int light, const SetLight& before, const SetLight& now) override {
        if (pname_of(now.command) != kGL_POSITION || now.is_before_identity || !now.turn) return;
        glm::dvec4 typed(0);
        for (int i = 0; i < 4; ++i) typed[i] = now.command.array()[static_cast<std::size_t>(i)];
        const glm::dvec4 was = before.modelview * typed, is = now.modelview * typed;
        if (glm::distance(was, is) <= 1e-5 * glm::length(was)) return;  // it is on the axis
        turned_.push_back({light_name(light), now.command.place, *now.turn, now.camera,
                           now.modelview * glm::inverse(before.modelview)});
    }

    std::size_t drawn_ = 0;
    Occurrences draws_;
    std::map<Occurrence, glm::dmat4> matrices_;  // eye_from_object of the first picture's lit Draws
    std::vector<DrawnStep> steps_;
    std::vector<TurnedLight> turned_;
    bool has_new_ = false;
};

}  // namespace

std::vector<Rule> later_picture_rules() {
    return {
        {"left-for-next-picture",
         "A call late in the display function changes the state, and nothing sets it back. Objects before it look "
         "different from the second picture on. (The pictures here show the second call.)",
         "Section 2.1: GL's state stays until a command changes it, also from one picture to the next.",
         "glEnable(GL_LIGHTING); at the start of the display function",
         R"( #include <GL/glut.h>
 void display(void) {
     glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
     glLoadIdentity();
     gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
     glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});
+    glEnable(GL_LIGHTING);
     glutSolidSphere(1.5, 40, 20);
     glDisable(GL_LIGHTING);
     glBegin(GL_LINES);
     glVertex3f(-3, 0, 0);
     glVertex3f(3, 0, 0);
     glEnd();
     glutSwapBuffers();
 }
 int main(int argc, char** argv) {
     glutInit(&argc, argv);
     glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
     glutInitWindowSize(160, 120);
     glutCreateWindow("ball");
     glMatrixMode(GL_PROJECTION);
     gluPerspective(45, 4.0 / 3.0, 1, 100);
     glMatrixMode(GL_MODELVIEW);
     glEnable(GL_DEPTH_TEST);
     glEnable(GL_LIGHTING);
     glEnable(GL_LIGHT0);
     glutDisplayFunc(display);
     glutMainLoop();
 }
)",
         make_watch<LeftForNextPicture>,
         {},
         true},
        {"light-before-identity",
         "The position of a light is set before `glLoadIdentity`. From the second picture on it is moved by the matrix "
         "that the previous picture left. (The pictures here show the second call.)",
         "Section 2.14.1: a position is transformed by the modelview matrix of the moment when it is set. Section "
         "2.11.2: the matrix stays until a command changes it.",
         "glLoadIdentity(); before the position",
         R"( #include <GL/glut.h>
 void display(void) {
     glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
-    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 5, 3, 1});
     glLoadIdentity();
+    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 5, 3, 1});
     glTranslatef(0, 0, -6);
     glRotatef(100, 0, 0, 1);
     glutSolidSphere(1.5, 40, 20);
     glutSwapBuffers();
 }
 int main(int argc, char** argv) {
     glutInit(&argc, argv);
     glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
     glutInitWindowSize(160, 120);
     glutCreateWindow("ball");
     glMatrixMode(GL_PROJECTION);
     gluPerspective(45, 4.0 / 3.0, 1, 100);
     glMatrixMode(GL_MODELVIEW);
     glEnable(GL_DEPTH_TEST);
     glEnable(GL_LIGHTING);
     glEnable(GL_LIGHT0);
     glutDisplayFunc(display);
     glutMainLoop();
 }
)",
         make_watch<LightBeforeIdentity>,
         {"light-before-camera"},
         true},
        {"light-turns-with-objects",
         "The position of a light is set after the `glRotate` of the objects. It turns with them, so the same sides "
         "are "
         "always lit. (For a camera that moves around the scene this is right: silence the warning. The pictures here "
         "show the second call.)",
         "Section 2.14.1: a position is transformed by the modelview matrix of the moment when it is set.",
         "glLightfv(GL_LIGHT0, GL_POSITION, ...) before glRotatef",
         R"( #include <GL/glut.h>
 float angle = 0;
 void display(void) {
     glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
     glLoadIdentity();
     gluLookAt(0, 2, 6,  0, 0, 0,  0, 1, 0);
+    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});
     glRotatef(angle, 0, 1, 0);
-    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 4, 5, 1});
     glutSolidCube(2);
     glutSwapBuffers();
 }
 void idle(void) {
     angle += 120;
     glutPostRedisplay();
 }
 int main(int argc, char** argv) {
     glutInit(&argc, argv);
     glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
     glutInitWindowSize(160, 120);
     glutCreateWindow("cube");
     glMatrixMode(GL_PROJECTION);
     gluPerspective(45, 4.0 / 3.0, 1, 100);
     glMatrixMode(GL_MODELVIEW);
     glEnable(GL_DEPTH_TEST);
     glEnable(GL_LIGHTING);
     glEnable(GL_LIGHT0);
     glutDisplayFunc(display);
     glutIdleFunc(idle);
     glutMainLoop();
 }
)",
         make_watch<LightTurnsWithObjects>,
         {},
         true},
    };
}

}  // namespace twinlight::lint
