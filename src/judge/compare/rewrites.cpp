#include "judge/compare/rewrites.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "judge/compare/departure_rules.h"

namespace twinlight::compare {

namespace {

using Id = CommandId;
using Emit = std::function<void(const Command&)>;

template <CommandId id>
bool is(const Command& command) {
    return command.id == id;
}
template <Enum capability>
bool enables(const Command& command) {
    return command.id == Id::glEnable && command.enumerant(0) == capability;
}
bool is_rectangle(const Command& command) { return command.name().starts_with("glRect"); }
bool is_color_3(const Command& command) { return command.name().starts_with("glColor3"); }
bool has_w(const Command& command) { return command.name().starts_with("glVertex4"); }
bool copies_image(const Command& command) {
    return command.id == Id::glCopyTexImage1D || command.id == Id::glCopyTexImage2D;
}

// Changes nothing, and is an error between glBegin and glEnd.
void ask(const State& state, const Place& place, const Emit& emit) {
    if (!state.inside_begin()) emit({Id::glGetMaterialfv, {kGL_FRONT, kGL_SHININESS}, place});
}

template <bool (*is_it)(const Command&)>
void ask_before(State& state, const Command& command, const Emit& emit) {
    if (is_it(command)) ask(state, command.place, emit);
    state.apply(command);
    emit(command);
}

Command with_values(Id id, std::vector<double> arguments, const std::vector<double>& values, const Place& place) {
    arguments.insert(arguments.end(), values.begin(), values.end());
    return {id, std::move(arguments), place};
}

void set_color(const glm::dvec4& color, const Place& place, const Emit& emit) {
    emit({Id::glColor4f, {color.r, color.g, color.b, color.a}, place});
}

bool succeeds_in_pop(State& state, const Command& command, const Emit& emit) {
    const std::size_t depth = state.attribute_depth();
    state.apply(command);
    emit(command);
    return command.id == Id::glPopAttrib && state.attribute_depth() < depth;
}

// By way of another colour, because a driver may take no notice of one that it has.
void set_color_after_pop(State& state, const Command& command, const Emit& emit) {
    if (!succeeds_in_pop(state, command, emit) || !state.lighting().color_material.enabled) return;
    const glm::dvec4 color = state.attributes().current.color;
    set_color(glm::dvec4(1) - color, command.place, emit);
    ask(state, command.place, emit);
    set_color(color, command.place, emit);
}

void set_lights_after_pop(State& state, const Command& command, const Emit& emit) {
    if (!succeeds_in_pop(state, command, emit)) return;
    for (int i = 0; i < kMaxLights; ++i) {
        const bool is_on = state.lighting().lights[static_cast<std::size_t>(i)].enabled;
        emit({is_on ? Id::glEnable : Id::glDisable, {static_cast<double>(kGL_LIGHT0) + i}, command.place});
    }
}

void set_mipmaps_after_pop(State& state, const Command& command, const Emit& emit) {
    if (!succeeds_in_pop(state, command, emit)) return;
    for (const Enum target : {kGL_TEXTURE_1D, kGL_TEXTURE_2D, kGL_TEXTURE_3D, kGL_TEXTURE_CUBE_MAP}) {
        const double generates = state.bound_texture(target).generate_mipmap ? 1 : 0;
        emit({Id::glTexParameteri, {static_cast<double>(target), kGL_GENERATE_MIPMAP, generates}, command.place});
    }
}

// The largest value of a type that stands for 1 (table 2.9).
double one_of(Kind kind) {
    switch (kind) {
        case Kind::kByte: return 127;
        case Kind::kShort: return 32767;
        case Kind::kInt: return 2147483647;
        case Kind::kUbyte: return 255;
        case Kind::kUshort: return 65535;
        case Kind::kUint: return 4294967295;
        default: return 1;
    }
}

// "glTexCoord2fv" with prefix "glTexCoord": the same command with four components. nullopt: it is no such command, or has four.
std::optional<Command> with_four(const Command& command, std::string_view prefix, std::size_t named, double last) {
    const std::string_view name = command.name();
    if (!name.starts_with(prefix) || name.size() <= prefix.size()) return std::nullopt;
    const char count = name[prefix.size()];
    if (count < '1' || count > '3') return std::nullopt;
    const auto id = find_command(std::string(prefix) + "4" + std::string(name.substr(prefix.size() + 1)));
    if (!id) return std::nullopt;
    Command result = command;
    result.id = *id;
    while (result.arguments.size() < named + 3) result.arguments.push_back(0);
    result.arguments.push_back(last);
    return result;
}

void send_alpha(State& state, const Command& command, const Emit& emit) {
    state.apply(command);
    std::optional<Command> four;
    if (is_color_3(command)) four = with_four(command, "glColor", 0, one_of(command.sig().parameters.back().kind));
    emit(four ? *four : command);
}

void send_all_coordinates(State& state, const Command& command, const Emit& emit) {
    state.apply(command);
    auto four = with_four(command, "glTexCoord", 0, 1);
    if (!four) four = with_four(command, "glMultiTexCoord", 1, 1);
    emit(four ? *four : command);
}

void divide_by_w(State& state, const Command& command, const Emit& emit) {
    state.apply(command);
    if (!has_w(command) || !(command.number(3) > 0) || command.number(3) == 1) return emit(command);
    const double w = command.number(3);
    emit({Id::glVertex4d, {command.number(0) / w, command.number(1) / w, command.number(2) / w, 1}, command.place});
}

void set_both_sides(State& state, const Command& command, const Emit& emit) {
    state.apply(command);
    emit(command);
    const bool changes = command.id == Id::glBegin || command.name().starts_with("glMaterial");
    if (!changes || !state.inside_begin()) return;
    for (const Enum face : {kGL_FRONT, kGL_BACK})
        for (const Enum pname : {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_EMISSION, kGL_SHININESS})
            emit(with_values(Id::glMaterialfv, {static_cast<double>(face), static_cast<double>(pname)},
                             state.get_material(face, pname), command.place));
}

// What a listed command read from arrays or pixels when it was compiled is not read again, so such lists change.
void spell_out_lists(State& state, const Command& command, const Emit& emit) {
    const auto is_call = [](const Command& c) { return c.id == Id::glCallList || c.id == Id::glCallLists; };
    const bool makes = command.id == Id::glNewList || command.id == Id::glEndList;
    const bool only_compiles = state.lists().open_name != 0 && state.lists().open_mode == kGL_COMPILE;
    if (!makes && !only_compiles && !is_call(command)) emit(command);
    state.watch_lists([&](const Command& listed, bool is_done) {
        if (!is_done && !is_call(listed)) emit(listed);
    });
    state.apply(command);
    state.watch_lists({});
}

void spell_out_rectangles(State& state, const Command& command, const Emit& emit) {
    const bool is_drawn = is_rectangle(command) && !state.inside_begin();
    state.apply(command);
    if (!is_drawn) return emit(command);
    const double x1 = command.number(0), y1 = command.number(1), x2 = command.number(2), y2 = command.number(3);
    emit({Id::glBegin, {kGL_POLYGON}, command.place});
    for (const auto& [x, y] : {std::pair(x1, y1), {x2, y1}, {x2, y2}, {x1, y2}})
        emit({Id::glVertex2d, {x, y}, command.place});
    emit({Id::glEnd, {}, command.place});
}

void spell_out_evaluated_meshes(State& state, const Command& command, const Emit& emit) {
    const bool is_drawn = command.id == Id::glEvalMesh2 && command.enumerant(0) == kGL_FILL && !state.inside_begin();
    state.apply(command);
    if (!is_drawn) return emit(command);
    for (double j = command.number(3); j < command.number(4); ++j) {
        emit({Id::glBegin, {kGL_QUAD_STRIP}, command.place});
        for (double i = command.number(1); i <= command.number(2); ++i) {
            emit({Id::glEvalPoint2, {i, j}, command.place});
            emit({Id::glEvalPoint2, {i, j + 1}, command.place});
        }
        emit({Id::glEnd, {}, command.place});
    }
}

void limit_sprites_to_points(State& state, const Command& command, const Emit& emit) {
    const Command off{Id::glDisable, {kGL_POINT_SPRITE}, command.place},
        on{Id::glEnable, {kGL_POINT_SPRITE}, command.place};
    if (draws_other_than_points(command) && !state.inside_begin()) emit(off);
    state.apply(command);
    emit(command);
    const bool has_drawn = draws_other_than_points(command) || command.id == Id::glEnd;
    if (has_drawn && !state.inside_begin() && state.capability(kGL_POINT_SPRITE) == true) emit(on);
}

void set_mode_after_copy(State& state, const Command& command, const Emit& emit) {
    state.apply(command);
    emit(command);
    if (!copies_image(command)) return;
    const Enum target = command.id == Id::glCopyTexImage1D ? kGL_TEXTURE_1D : kGL_TEXTURE_2D;
    const Enum mode = state.bound_texture(target).depth_mode;
    // By way of another mode, because a driver takes no notice of one that it has.
    for (const Enum value : {mode == kGL_ALPHA ? kGL_LUMINANCE : kGL_ALPHA, mode})
        emit({Id::glTexParameteri,
              {static_cast<double>(target), kGL_DEPTH_TEXTURE_MODE, static_cast<double>(value)},
              command.place});
}

void set_some_shininess(State& state, const Command& command, const Emit& emit) {
    constexpr double kSome = 1e-6;
    state.apply(command);
    const bool is_0 =
        command.name().starts_with("glMaterial") && command.enumerant(1) == kGL_SHININESS && command.number(2) == 0;
    emit(is_0 ? Command{Id::glMaterialf, {command.number(0), kGL_SHININESS, kSome}, command.place} : command);
    if (!enables<kGL_LIGHTING>(command) || state.inside_begin()) return;
    for (const Enum face : {kGL_FRONT, kGL_BACK})
        if (state.get_material(face, kGL_SHININESS)[0] == 0)
            emit({Id::glMaterialf, {static_cast<double>(face), kGL_SHININESS, kSome}, command.place});
}

glm::dvec3 unit(const Command& command, std::size_t first) {
    const glm::dvec3 v(command.number(first), command.number(first + 1), command.number(first + 2));
    return v == glm::dvec3(0) ? v : glm::normalize(v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

void send_unit_directions(State& state, const Command& command, const Emit& emit) {
    state.apply(command);
    const bool is_light = command.id == Id::glLightfv && command.enumerant(1) == kGL_POSITION && command.number(5) == 0;
    const bool is_normal = (command.id == Id::glNormal3f || command.id == Id::glNormal3fv ||
                            command.id == Id::glNormal3d || command.id == Id::glNormal3dv) &&
                           state.lighting().normalize;
    if (!is_light && !is_normal) return emit(command);
    const glm::dvec3 n = unit(command, is_light ? 2 : 0);
    if (is_light)
        emit({Id::glLightfv, {command.number(0), kGL_POSITION, n.x, n.y, n.z, 0}, command.place});
    else
        emit({Id::glNormal3d, {n.x, n.y, n.z}, command.place});
}

void normalize_for_rescaling(State& state, const Command& command, const Emit& emit) {
    state.apply(command);
    const bool switches =
        (command.id == Id::glEnable || command.id == Id::glDisable) && command.enumerant(0) == kGL_RESCALE_NORMAL;
    emit(switches ? Command{command.id, {kGL_NORMALIZE}, command.place} : command);
}

class Rewritten final : public Recording {
  public:
    Rewritten(std::shared_ptr<const Recording> whole, const Rewrite& rewrite, const StateOptions& options)
        : Recording(whole->name), whole_(std::move(whole)), rewrite_(rewrite), options_(options) {}

    void for_each(const std::function<bool(const Step&)>& visit) const override {
        State state(options_);
        whole_->for_each([&](const Step& step) {
            if (step.kind == Step::Kind::kFrameEnd) state.drop_picture();
            if (step.kind != Step::Kind::kCommand) return visit(step);
            bool goes_on = true;
            rewrite_.carry_out(state, step.command,
                               [&](const Command& command) { goes_on = goes_on && visit({.command = command}); });
            return goes_on;
        });
    }
    std::vector<std::string> notes() const override { return whole_->notes(); }

  private:
    std::shared_ptr<const Recording> whole_;
    const Rewrite& rewrite_;
    StateOptions options_;
};

}  // namespace

const Rewrite asks_before_color_material{ask_before<enables_color_material>};
const Rewrite asks_before_new_mode{ask_before<is<Id::glColorMaterial>>};
const Rewrite asks_before_list{ask_before<is<Id::glNewList>>};
const Rewrite asks_before_pop{ask_before<is<Id::glPopAttrib>>};
const Rewrite sets_color_after_pop{set_color_after_pop};
const Rewrite sets_lights_after_pop{set_lights_after_pop};
const Rewrite sets_mipmaps_after_pop{set_mipmaps_after_pop};
const Rewrite sends_alpha{send_alpha};
const Rewrite sends_all_coordinates{send_all_coordinates};
const Rewrite divides_by_w{divide_by_w, false};
const Rewrite sets_both_sides{set_both_sides};
const Rewrite spells_out_rectangles{spell_out_rectangles};
const Rewrite spells_out_evaluated_meshes{spell_out_evaluated_meshes};
const Rewrite spells_out_lists{spell_out_lists};
const Rewrite limits_sprites_to_points{limit_sprites_to_points};
const Rewrite sets_mode_after_copy{set_mode_after_copy};
const Rewrite sets_some_shininess{set_some_shininess};
const Rewrite sets_some_shininess_of_sides{set_some_shininess, false};
const Rewrite sends_unit_directions{send_unit_directions, false};
const Rewrite normalizes_for_rescaling{normalize_for_rescaling};

std::shared_ptr<const Recording> rewritten(std::shared_ptr<const Recording> recording, const Rewrite& rewrite,
                                           const StateOptions& options) {
    return std::make_shared<const Rewritten>(std::move(recording), rewrite, options);
}

}  // namespace twinlight::compare
