// The core of the state machine: calls the function of each command, collects errors, handles Begin and End, builds
// Draws. The other files of this folder implement the commands.
#include "scene/state/state.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "scene/command/command_set.h"
#include "scene/state/capabilities.h"
#include "scene/state/not_finite.h"

namespace twinlight {

namespace {

// The commands allowed between Begin and End (2.6.3). begin, end and perspective are listed because they raise their
// own errors, GLU's quadrics because they are not GL commands.
constexpr CommandSet kLegalInside =
    CommandSet::of({"vertex",          "normal",      "color",       "tex_coord",
                    "edge_flag",       "material",    "begin",       "end",
                    "multi_tex_coord", "eval_coord",  "eval_point",  "driver_only_attribute",
                    "secondary_color", "fog_coord",   "call_list",   "call_lists",
                    "array_element",   "perspective", "new_quadric", "delete_quadric",
                    "set_quadric"});

// The commands that change no state of a later Draw, only its vertices; glColor does so if no material follows it (2.14.3).
// What a display list does, its own commands do.
constexpr CommandSet kKeepsState =
    CommandSet::of({"vertex", "normal", "tex_coord", "multi_tex_coord", "secondary_color", "fog_coord", "edge_flag",
                    "begin", "end", "call_list", "call_lists", "label"});
constexpr CommandSet kSetsColor = CommandSet::of({"color"});

// Each is given once, so that Draws of different States have different numbers.
std::uint64_t new_state_number() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

// Adds one to the count of `name`.
void count(std::vector<Unsupported>& list, std::string_view name, const Place& place, MissingFrom missing_from) {
    const auto find = [&] {
        return std::find_if(list.begin(), list.end(), [&](const Unsupported& u) { return u.name == name; });
    };
    auto found = find();
    if (found == list.end() && list.size() >= kMaxUnsupportedKept) {
        name = "more commands";
        found = find();
    }
    if (found != list.end())
        found->count += found->count < std::numeric_limits<int>::max() ? 1 : 0;
    else
        list.push_back({std::string(name), 1, place, missing_from});
}

}  // namespace

State::State(const StateOptions& options) : options_(options), state_number_(new_state_number()) {
    a_.raster.viewport = a_.fragment.scissor.box = {0, 0, options.width, options.height};
}

void State::apply(const Command& command) {
    if (!compile(command)) carry_out(command);
}

void State::carry_out(const Command& command) {
    static constexpr void (State::*kCarriedOutBy[])(const Command&) = {
#define GL_COMMAND(name, effect, ...) &State::effect,
#include "scene/command/commands.def"
    };
    if (open_ && !kLegalInside.contains(command.id)) return raise_inside(command);
    // RULING: GL leaves NaN and infinity undefined (2.1.1). Here commands refuse them, so they cannot spread. Only
    // vertices accept them, because real programs send such vertices; see sanitize(). In a recorded program other
    // commands have finite numbers already; see made_finite().
    if (const auto wrong = number_that_is_not_finite(command)) {
        if (std::isfinite(*wrong))
            return raise(kGL_INVALID_VALUE, command, "{} is given {}; the largest float is 3.4e+38", command.name(),
                         *wrong);
        return raise(kGL_INVALID_VALUE, command, "{} needs finite numbers, but a value is NaN or infinite",
                     command.name());
    }
    if ((framebuffers_.draw != 0 || framebuffers_.read != 0) && !use_framebuffers(command)) return;
    const bool keeps_state =
        kKeepsState.contains(command.id) || (kSetsColor.contains(command.id) && !a_.lighting.color_material.enabled);
    if (!keeps_state) state_number_ = new_state_number();
    (this->*kCarriedOutBy[static_cast<std::size_t>(command.id)])(command);
}

void State::raise(GlError error) {
    ++error_count_;
    if (error.code == kGL_OUT_OF_MEMORY && !exhausted_) exhausted_ = error;
    if (errors_.size() >= kMaxErrorsKept) return;
    if (const ListCall* call = lists_.call.get()) {
        while (call->outer) call = call->outer.get();
        error.message += fmt::format("; this command is in the display list that is called at {}", call->place.str());
    }
    errors_.push_back(std::move(error));
}

void State::raise_inside(const Command& command) {
    raise(kGL_INVALID_OPERATION, command, "{} is not allowed between glBegin and glEnd; the glBegin is at {}",
          command.name(), open_->place.str());
}

bool State::has_room(const Command& command, std::size_t bytes) {
    if (bytes <= options_.memory - std::min(item_bytes_, options_.memory)) {
        item_bytes_ += bytes;
        return true;
    }
    raise(kGL_OUT_OF_MEMORY, command,
          "this picture needs more than {:.2g} GB of memory; draw fewer vertices, or run twinlight with a larger "
          "--memory",
          static_cast<double>(options_.memory) / 1e9);
    return false;
}

std::size_t State::vertex_bytes(Enum mode, std::size_t vertices, std::size_t indices) const {
    const auto is_in_use = [](const TextureBindings& unit) { return unit.is_enabled(); };
    const std::size_t further =
        open_ ? open_->further_units.size()
              : static_cast<std::size_t>(std::count_if(a_.units.begin() + 1, a_.units.end(), is_in_use));
    return bytes_of_vertices(a_.raster, mode, vertices, indices) + further * bytes_of_tex_coords(vertices);
}

bool State::has_time(const Command& command, double work) {
    work_ += work;
    if (work_ <= static_cast<double>(kMaxFrameWork)) return true;
    raise(kGL_OUT_OF_MEMORY, command,
          "the display lists, images and shapes of one picture can have at most {} commands, texels and vertices "
          "together",
          kMaxFrameWork);
    return false;
}

bool State::known(const Command& command, Enum value, std::initializer_list<Enum> allowed) {
    if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return true;
    std::vector<std::string> names;
    for (Enum e : allowed) names.push_back(enum_name(e));
    raise(kGL_INVALID_ENUM, command, "{} is given {}; expected {}", command.name(), enum_name(value),
          fmt::join(names, ", "));
    return false;
}

// ---- Begin, End and the commands between them (2.6, 2.7) ----

void State::begin(const Command& c) {
    if (open_) {
        return raise(kGL_INVALID_OPERATION, c, "glBegin inside another glBegin; the one at {} has no glEnd yet",
                     open_->place.str());
    }
    if (c.enumerant(0) > kGL_POLYGON) {
        return raise(kGL_INVALID_ENUM, c, "glBegin is given {}; expected a primitive type, GL_POINTS to GL_POLYGON",
                     enum_name(c.enumerant(0)));
    }
    open_bytes_ = bytes_of_draw();
    if (!has_room(c, open_bytes_)) return;
    open_ = new_draw(c.enumerant(0), c.place);
}

constexpr std::size_t kMuchRoom = 1000;  // in vertices

void State::end(const Command& c) {
    if (!open_) return raise(kGL_INVALID_OPERATION, c, "glEnd without a glBegin");
    if (open_->vertices.empty()) {
        item_bytes_ -= std::min(item_bytes_, open_bytes_);
    } else {
        // What the vector has grown by in vain stays as long as the frame.
        std::vector<Vertex>& vertices = open_->vertices.edit();
        if (vertices.capacity() - vertices.size() > kMuchRoom) vertices.shrink_to_fit();
        show(std::move(*open_));
    }
    open_.reset();
    a_.current.material = 0;  // the next Draw starts its own list of materials
}

void State::vertex(const Command& c) {
    if (!open_) return;  // 2.7: undefined outside Begin and End; ignored here, as by the driver
    if (!has_room(c, vertex_bytes(open_->mode, 1))) return;
    a_.current.position_object = {0, 0, 0, 1};
    for (std::size_t i = 0; i < c.arguments.size(); ++i) a_.current.position_object[static_cast<int>(i)] = c.number(i);
    sanitize(a_.current);
    open_->vertices.edit().push_back(a_.current);
    fill_columns(*open_, a_.current);
}

void State::normal(const Command& c) {
    const Kind kind = c.sig().parameters[0].kind;
    for (int i = 0; i < 3; ++i) a_.current.normal_object[i] = to_real(c.number(static_cast<std::size_t>(i)), kind);
    sanitize(a_.current);
}

void State::color(const Command& c) {
    const Kind kind = c.sig().parameters[0].kind;
    a_.current.color.a = 1;
    for (std::size_t i = 0; i < c.arguments.size(); ++i)
        a_.current.color[static_cast<int>(i)] = to_real(c.number(i), kind);
    sanitize(a_.current);
    track_color();
}

void State::secondary_color(const Command& c) {
    const Kind kind = c.sig().parameters[0].kind;
    glm::dvec4& color = a_.current.further(VertexAttribute::kSecondaryColor);
    for (std::size_t i = 0; i < c.arguments.size(); ++i) color[static_cast<int>(i)] = to_real(c.number(i), kind);
    sanitize(color);
}

void State::fog_coord(const Command& c) {
    glm::dvec4& coordinate = a_.current.further(VertexAttribute::kFogCoord);
    coordinate.x = c.number(0);
    sanitize(coordinate);
}

void State::tex_coord(const Command& c) {
    a_.current.tex_coord = {0, 0, 0, 1};
    for (std::size_t i = 0; i < c.arguments.size(); ++i) a_.current.tex_coord[static_cast<int>(i)] = c.number(i);
    sanitize(a_.current);
}

void sanitize(Vertex& vertex) {
    const auto all_in_range = [](const auto& v) {
        bool all = true;
        for (int i = 0; i < v.length(); ++i) all &= is_in_float_range(v[i]);
        return all;
    };
    if (!all_in_range(vertex.position_object)) vertex.position_object = glm::dvec4(0);
    if (!all_in_range(vertex.normal_object)) vertex.normal_object = glm::dvec3(0);
    sanitize(vertex.color);
    sanitize(vertex.tex_coord);
}

void sanitize(glm::dvec4& values) {
    for (int i = 0; i < 4; ++i)
        if (!is_in_float_range(values[i])) values[i] = 0;
}

void State::multi_tex_coord(const Command& c) {
    if (auto error = wrong_texture_unit(c)) return raise(std::move(*error));
    glm::dvec4& tex_coord = a_.current.tex_coord_of(c.enumerant(0) - kGL_TEXTURE0);
    tex_coord = {0, 0, 0, 1};
    for (std::size_t i = 1; i < c.arguments.size(); ++i) tex_coord[static_cast<int>(i) - 1] = c.number(i);
    sanitize(tex_coord);
}

double State::to_real(double c, Kind kind) const { return real_from(c, kind, options_.signed_rule); }

// ---- Draws ----

TextureUnit State::texture_unit(std::size_t number) const {
    const TextureBindings& bindings = a_.units[number];
    TextureUnit unit{.texture = complete_texture(bindings),
                     .env_mode = bindings.env_mode,
                     .env_color = bindings.env_color,
                     .lod_bias = bindings.lod_bias,
                     .texture_matrix = texture_[number].back().matrix};
    if (!unit.texture) return unit;
    unit.coord_replace = bindings.coord_replace;
    unit.lod_bias =
        std::clamp(unit.lod_bias + unit.texture->lod_bias, -kMaxLodBias, kMaxLodBias);  // 3.8.8, equation 3.19
    unit.generated = generated_coordinates(bindings);
    if (unit.env_mode == kGL_COMBINE) unit.combine = bindings.combine;
    return unit;
}

std::vector<VertexColumn> State::columns_of(const Draw& draw, bool has_secondary_colors) {
    std::vector<VertexColumn> columns;
    for (const FurtherUnit& further : draw.further_units) columns.push_back({tex_coord_attribute(further.number)});
    if (has_secondary_colors) columns.push_back({VertexAttribute::kSecondaryColor});
    if (draw.fog.enabled && draw.fog.by_coordinates) columns.push_back({VertexAttribute::kFogCoord});
    return columns;
}

void State::fill_columns(Draw& draw, const VertexValues& values) {
    for (VertexColumn& column : draw.columns)
        column.values.resize(draw.vertices.size(), values.further(column.attribute));
}

namespace {

// Leaves a Draw the state of points that counts for it (3.3).
void keep_state_of_points(Draw& draw) {
    RasterState& raster = draw.raster;
    const RasterState initial;
    raster.point_sprite = draw.draws_sprites();
    raster.point_smooth = raster.point_smooth && draw.draws_points() && !raster.point_sprite;  // 3.3.1
    raster.point_parameters.fade_threshold_size = initial.point_parameters.fade_threshold_size;
    if (!draw.draws_points()) raster.point_parameters = initial.point_parameters;
    if (!raster.point_sprite)
        raster.point_parameters.sprite_coord_origin = initial.point_parameters.sprite_coord_origin;
    const auto keep = [&](TextureUnit& unit) {
        unit.coord_replace = unit.coord_replace && raster.point_sprite;
        if (!unit.coord_replace || !draw.draws_only_points()) return;
        unit.texture_matrix = glm::dmat4(1);
        unit.generated.clear();
    };
    keep(draw.texture);
    for (FurtherUnit& further : draw.further_units) keep(further.unit);
}

}  // namespace

Draw State::new_draw(Enum mode, const Place& place) {
    Draw draw;
    draw.mode = mode;
    draw.state_number = state_number_;
    draw.lighting = a_.lighting;
    draw.raster = a_.raster;
    draw.eye_from_object = modelview();
    draw.clip_from_eye = projection();
    draw.place = place;
    draw.in_list = lists_.nesting > 0 || lists_.open_name != 0;
    draw.list = lists_.call;
    if (!elsewhere_.empty())
        for (const TextureBindings& unit : a_.units)
            if (unit.is_enabled()) show_shared(SharedObject::Kind::kTexture, unit.bound(unit.target()));
    draw.texture = texture_unit(0);
    for (std::size_t i = 1; i < a_.units.size(); ++i)
        if (a_.units[i].is_enabled())
            if (TextureUnit unit = texture_unit(i); unit.texture)
                draw.further_units.push_back({.number = i, .unit = std::move(unit)});
    // 3.8.13: then the result is undefined.
    draw.for_each_unit([&](std::size_t, const TextureUnit& unit) {
        for (std::size_t i = 0; i < a_.units.size() && unit.env_mode == kGL_COMBINE; ++i)
            if (unit.combine.reads_unit(i) && !complete_texture(a_.units[i]))
                note_unsupported("glTexEnv(GL_COMBINE) that reads a unit without a texture", place);
    });
    draw.fog = a_.fog;
    draw.fragment = a_.fragment;
    draw.columns = columns_of(draw, draw.fragment.color_sum && !draw.lighting.enabled);
    if (!draws_color()) draw.fragment.color_mask.fill(false);
    if (a_.stencil_enabled) draw.fragment.stencil = a_.stencil_test;
    if (a_.logic_op_enabled) draw.fragment.logic_op = a_.logic_op;
    if (a_.line_stipple_enabled && draw.draws_lines()) draw.raster.line_stipple = a_.line_stipple;
    if (a_.polygon_stipple_enabled && draws_polygons(mode)) draw.raster.polygon_stipple = a_.polygon_stipple;
    draw.raster.line_smooth &= draw.draws_lines();
    keep_state_of_points(draw);
    for (std::size_t i = 0; i < a_.clip_planes.size(); ++i)
        if (a_.clip_planes[i].enabled) draw.raster.clip_planes_eye[i] = a_.clip_planes[i].equation_eye;
    for (const auto& [capability, where] : a_.driver_only) {
        const DriverOnlyCapability& row = driver_only_capability(capability.first);
        if (!row.changes_pixels) continue;
        note_unsupported(fmt::format("glEnable({})", enum_name(row.cap)), where);
    }
    bool replaces = false;
    draw.for_each_unit([&](std::size_t, const TextureUnit& unit) { replaces = replaces || unit.coord_replace; });
    if (replaces && !draw.draws_only_points())
        note_unsupported("point sprites for one face of polygons", place, MissingFrom::kShaders);
    // `#pragma twinlight light(8, ...)`: GL has only eight lights.
    const auto& lights = draw.lighting.lights;
    const bool has_more =
        lights.size() > kMaxLights &&
        std::any_of(lights.begin() + kMaxLights, lights.end(), [](const LightSource& light) { return light.enabled; });
    if (draw.lighting.enabled && has_more)
        note_unsupported("a light beyond GL_LIGHT7", place, MissingFrom::kFixedFunction);
    return draw;
}

// 5.2, 5.3: in selection and feedback mode drawing and clearing change no pixel.
void State::show(FrameItem item) {
    const auto is_black = [](const VertexColumn& column) {
        return column.attribute == VertexAttribute::kSecondaryColor &&
               std::ranges::all_of(column.values, [](const glm::dvec4& c) { return glm::dvec3(c) == glm::dvec3(0); });
    };
    if (Draw* draw = std::get_if<Draw>(&item)) std::erase_if(draw->columns, is_black);
    if (render_mode_ != kGL_RENDER) return;
    if (framebuffers_.draw != 0) return show_in_object(std::move(item));
    if (const Draw* draw = watch_draw_ ? std::get_if<Draw>(&item) : nullptr) return watch_draw_(*draw);
    items_.push_back(std::move(item));
}

// 2.10: the same as a GL_POLYGON with four vertices.
void State::rect(const Command& c) {
    if (!has_room(c, bytes_of_draw() + vertex_bytes(kGL_POLYGON, 4))) return;
    const double x1 = c.number(0), y1 = c.number(1), x2 = c.number(2), y2 = c.number(3);
    Draw draw = new_draw(kGL_POLYGON, c.place);
    for (const auto& [x, y] : {std::pair(x1, y1), {x2, y1}, {x2, y2}, {x1, y2}}) {
        a_.current.position_object = {x, y, 0, 1};
        draw.vertices.edit().push_back(a_.current);
    }
    fill_columns(draw, a_.current);
    show(std::move(draw));
}

void State::note_unsupported(const std::string& name, const Place& place, MissingFrom missing_from) {
    if (render_mode_ != kGL_RENDER) return;
    count(unsupported_, name, place, missing_from);
}

void State::note_lasting(std::string_view name, const Place& place) {
    count(outside_, name, place, MissingFrom::kFrame);
}

void State::outside(std::string_view function, const Place& place) {
    count(outside_, function, place, MissingFrom::kEverything);
}

void State::made_elsewhere(const SharedObject& object, std::string_view function, const Place& place) {
    constexpr std::size_t kMost = 1 << 16;
    if (elsewhere_.size() >= kMost && !elsewhere_.contains(object)) return outside(function, place);
    elsewhere_.insert_or_assign(object, std::pair(std::string(function), place));
}

void State::show_shared(SharedObject::Kind kind, std::uint32_t name) {
    if (elsewhere_.empty()) return;
    const auto found = elsewhere_.find({kind, name});
    if (found == elsewhere_.end()) return;
    const auto& [function, place] = found->second;
    if (lists_.open_name != 0)
        outside(function, place);  // later pictures may show the list
    else
        note_unsupported(function, place, MissingFrom::kEverything);
}

void State::show_shared_buffers() {
    if (elsewhere_.empty()) return;
    for (const std::uint32_t name : arrays_.buffers_read()) show_shared(SharedObject::Kind::kBuffer, name);
}

std::optional<GlError> State::unfinished() const {
    if (lists_.open_name != 0)
        return GlError{kGL_INVALID_OPERATION, lists_.opened,
                       tr("this glNewList has no glEndList; add it after the commands of the list")};
    if (open_)
        return GlError{kGL_INVALID_OPERATION, open_->place,
                       tr("this glBegin has no glEnd; add it after the last vertex")};
    std::vector<const MatrixStack*> stacks{&modelview_, &projection_};
    for (const MatrixStack& one : texture_) stacks.push_back(&one);
    for (const MatrixStack* s : stacks)
        if (s->size() > 1)
            return GlError{kGL_STACK_OVERFLOW, s->back().pushed,
                           tr("this glPushMatrix has no glPopMatrix; each push needs a pop")};
    if (!attribute_stack_.empty())
        return GlError{kGL_STACK_OVERFLOW, attribute_stack_.back().pushed,
                       tr("this glPushAttrib has no glPopAttrib; each push needs a pop")};
    return std::nullopt;
}

std::vector<Command> State::endings() const {
    std::vector<Command> endings;
    const auto add = [&](CommandId id, std::vector<double> arguments = {}) {
        endings.push_back({id, std::move(arguments), {}});
    };
    const auto pop_all = [&](const MatrixStack& stack, Enum mode) {
        if (stack.size() < 2) return;
        add(CommandId::glMatrixMode, {static_cast<double>(mode)});
        for (std::size_t i = 1; i < stack.size(); ++i) add(CommandId::glPopMatrix);
    };
    if (open_) add(CommandId::glEnd);
    if (lists_.open_name != 0) add(CommandId::glEndList);
    for (std::size_t i = 0; i < attribute_stack_.size(); ++i) add(CommandId::glPopAttrib);
    pop_all(modelview_, kGL_MODELVIEW);
    pop_all(projection_, kGL_PROJECTION);
    for (std::size_t i = 0; i < texture_.size(); ++i) {
        if (texture_[i].size() < 2) continue;
        add(CommandId::glActiveTexture, {static_cast<double>(kGL_TEXTURE0) + static_cast<double>(i)});
        pop_all(texture_[i], kGL_TEXTURE);
    }
    return endings;
}

Frame State::take_frame() {
    Frame frame{options_.width, options_.height, std::move(items_), outside_};
    std::move(unsupported_.begin(), unsupported_.end(), std::back_inserter(frame.unsupported));
    frame.lists_called_before_made.assign(lists_.called_before_made.begin(), lists_.called_before_made.end());
    frame.typed_lights = typed_lights_;
    frame.labels = std::move(labels_);
    frame.copies_pixels = copies_pixels_ && std::ranges::any_of(frame.draws(), &Draw::shows_copies);
    if (frame.copies_pixels)
        for (const KeptPicture& kept : kept_pictures_) frame.earlier.push_back(kept.items);
    frame.bytes = item_bytes_;
    for (const auto& held : object_pictures_)
        if (const auto picture = held.lock())
            frame.object_pixels = std::max(frame.object_pixels, static_cast<std::size_t>(picture->width) *
                                                                    static_cast<std::size_t>(picture->height));
    drop_picture();
    return frame;
}

void State::drop_picture() {
    keep_for_copies(items_.size());
    items_.clear();
    labels_.clear();
    item_bytes_ = bytes_of_kept_pictures() + bytes_of_object_pictures();
    work_ = 0;
    unsupported_.clear();
    drop_typed_lights();
}

namespace {

// Whether an item leaves something in the stencil buffer or the accumulation buffer.
bool fills_stencil(const FrameItem& item) {
    if (const Clear* clear = std::get_if<Clear>(&item)) return clear->stencil && clear->clear_stencil != 0;
    const Draw* draw = std::get_if<Draw>(&item);
    return draw && draw->fragment.stencil;
}
bool fills_accumulation(const FrameItem& item) {
    if (const Clear* clear = std::get_if<Clear>(&item))
        return clear->accumulation && clear->clear_accumulation != glm::dvec4(0);
    return std::holds_alternative<Accumulate>(item);
}

// Whether a Clear leaves nothing of these earlier items for later commands.
bool hides(const Clear& clear, std::span<const FrameItem> earlier) {
    const bool whole = !clear.scissor.enabled;
    const bool clears_stencil = clear.stencil && whole && (~clear.stencil_mask & kMaxStencil) == 0;
    return clear.hides_picture() && (clears_stencil || std::ranges::none_of(earlier, fills_stencil)) &&
           ((clear.accumulation && whole) || std::ranges::none_of(earlier, fills_accumulation));
}

}  // namespace

std::size_t hidden_items(std::span<const FrameItem> items) {
    if (items.size() < 2) return 0;
    const std::size_t last = items.size() - 1;
    if (const Clear* clear = std::get_if<Clear>(&items[last])) return hides(*clear, items.first(last)) ? last : 0;
    // GL_LOAD replaces all that was accumulated. Then the last Clear of the picture hides what came before it.
    const Accumulate* load = std::get_if<Accumulate>(&items[last]);
    if (!load || load->op != kGL_LOAD || load->scissor.enabled) return 0;
    for (std::size_t i = last; i-- > 0;) {
        if (const Accumulate* other = std::get_if<Accumulate>(&items[i]); other && other->op == kGL_RETURN) return 0;
        const Clear* clear = std::get_if<Clear>(&items[i]);
        if (!clear || !clear->hides_picture()) continue;
        return clear->stencil || std::ranges::none_of(items.first(i), fills_stencil) ? i : 0;
    }
    return 0;
}

std::size_t State::bytes_of(const FrameItems& items) const {
    std::size_t bytes = 0;
    for (const FrameItem& item : items)
        if (const Draw* draw = std::get_if<Draw>(&item))
            bytes += bytes_of_draw() +
                     bytes_of_vertices(draw->raster, draw->mode, draw->vertices.size(), draw->indices.size()) +
                     draw->further_units.size() * bytes_of_tex_coords(draw->vertices.size());
    return bytes;
}

std::size_t State::bytes_of_kept_pictures() const {
    std::size_t bytes = 0;
    for (const KeptPicture& kept : kept_pictures_) bytes += kept.bytes;
    return bytes;
}

void State::drop_hidden() {
    const std::size_t hidden = hidden_items(items_);
    if (hidden == 0) return;
    keep_for_copies(hidden);
    items_.erase(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(hidden));
    item_bytes_ = bytes_of(items_) + bytes_of_kept_pictures() + bytes_of_object_pictures();
    if (items_.size() == 1) {
        unsupported_.clear();
        work_ = 0;
    }
}

}  // namespace twinlight
