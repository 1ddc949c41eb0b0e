#include "scene/command/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "base/text/translation.h"
#include "scene/command/mesh.h"

namespace twinlight {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The table, read as signatures.
const std::vector<Signature>& table() {
    using enum Kind;
    static const std::vector<Signature> rows = {
#define PARAMETER(name, kind, extent, count) \
    Parameter { #name, kind, Extent::extent, count }
#define GL_COMMAND(name, effect, ...) {#name, Family::kGl, {__VA_ARGS__}},
#define SHAPE_COMMAND(name, effect, ...) {#name, Family::kShape, {__VA_ARGS__}},
#define QUADRIC_COMMAND(name, effect, ...) {#name, Family::kQuadric, {__VA_ARGS__}},
#define PRAGMA_COMMAND(name, effect, ...) {#name, Family::kPragma, {__VA_ARGS__}},
#include "scene/command/commands.def"
    };
    return rows;
}

std::unordered_map<std::string_view, CommandId> index_commands(bool pragmas) {
    std::unordered_map<std::string_view, CommandId> index;
    for (std::size_t i = 0; i < table().size(); ++i) {
        if ((table()[i].family == Family::kPragma) == pragmas) {
            index.emplace(table()[i].name, static_cast<CommandId>(i));
        }
    }
    return index;
}

std::optional<CommandId> find(const std::unordered_map<std::string_view, CommandId>& index, std::string_view name) {
    const auto found = index.find(name);
    return found == index.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

bool operator==(const Command& a, const Command& b) {
    const auto same_mesh = [&] {
        const auto &one = a.memory->mesh, &other = b.memory->mesh;
        return one == other || (one && other && *one == *other);
    };
    const bool same_memory = a.memory == b.memory || (a.memory && b.memory && a.memory->bytes == b.memory->bytes &&
                                                      a.memory->file == b.memory->file && same_mesh());
    return a.id == b.id && a.arguments == b.arguments && same_memory;
}

namespace {

bool is_single(const Parameter& parameter) {
    return parameter.extent == Extent::kValue || parameter.extent == Extent::kPointer ||
           parameter.extent == Extent::kOutputMemory || parameter.extent == Extent::kResult;
}

// The number of coordinates of a control point (section 5.1); 0 if `target` is not a target of glMap.
int coordinates_of_map(Enum target) {
    const bool is_two = target >= kGL_MAP2_COLOR_4;
    switch (is_two ? target - kGL_MAP2_COLOR_4 + kGL_MAP1_COLOR_4 : target) {
        case kGL_MAP1_INDEX:
        case kGL_MAP1_TEXTURE_COORD_1: return 1;
        case kGL_MAP1_TEXTURE_COORD_2: return 2;
        case kGL_MAP1_NORMAL:
        case kGL_MAP1_TEXTURE_COORD_3:
        case kGL_MAP1_VERTEX_3: return 3;
        case kGL_MAP1_COLOR_4:
        case kGL_MAP1_TEXTURE_COORD_4:
        case kGL_MAP1_VERTEX_4: return 4;
        default: return 0;
    }
}

// The number of values from the first control point to the last; 0 if the command has an error, so that GL reads none.
std::size_t control_point_values(const Command& c) {
    constexpr double kMaxOrder = 64;  // above GL_MAX_EVAL_ORDER of any driver (at least 8)
    const int coordinates = coordinates_of_map(c.enumerant(0));
    double last = 0;  // the index of the last point's first value
    for (std::size_t stride = 3; stride + 1 < c.sig().parameters.size(); stride += 4) {
        const double order = c.number(stride + 1);
        if (order < 1 || order > kMaxOrder || c.number(stride) < coordinates) return 0;
        last += c.number(stride) * (order - 1);
    }
    return coordinates == 0 ? 0 : static_cast<std::size_t>(last) + static_cast<std::size_t>(coordinates);
}

}  // namespace

bool Parameter::is_array() const {
    return !is_single(*this) && extent != Extent::kImage && extent != Extent::kMesh && extent != Extent::kText &&
           extent != Extent::kRest;
}

std::size_t Signature::first_array() const {
    std::size_t i = 0;
    while (i < parameters.size() && is_single(parameters[i])) ++i;
    return i;
}

std::size_t Signature::c_arguments() const {
    const bool has_result = !parameters.empty() && parameters.back().extent == Extent::kResult;
    return parameters.size() - (has_result ? 1 : 0);
}

std::size_t Command::first(std::size_t parameter) const {
    std::size_t position = 0;
    for (std::size_t i = 0; i < parameter; ++i) position += count(i);
    return position;
}

std::size_t Command::counted(std::size_t parameter) const {
    const std::vector<Parameter>& parameters = sig().parameters;
    for (std::size_t i = parameter; i-- > 0;) {
        if (parameters[i].kind == Kind::kSizei) return static_cast<std::size_t>(std::max(0.0, number(first(i))));
    }
    return 0;
}

std::size_t Command::count(std::size_t parameter) const {
    const std::vector<Parameter>& parameters = sig().parameters;
    switch (parameters[parameter].extent) {
        case Extent::kValue:
        case Extent::kPointer:
        case Extent::kOutputMemory:
        case Extent::kResult: return 1;
        case Extent::kControlPoints: return control_point_values(*this);
        case Extent::kArray:
        case Extent::kImage:
        case Extent::kMesh: return static_cast<std::size_t>(parameters[parameter].count);
        case Extent::kText:
        case Extent::kOutput:
        case Extent::kOutputByPname:
        case Extent::kOutputByCount: return 0;
        case Extent::kArrayByCount:
        case Extent::kNewNames: return counted(parameter);
        case Extent::kArrayByPname:
        case Extent::kRest: return arguments.size() - std::min(arguments.size(), first(parameter));
    }
    return 0;
}

std::span<const double> Command::values(std::size_t parameter) const {
    const std::size_t from = std::min(first(parameter), arguments.size());
    return std::span(arguments).subspan(from, std::min(count(parameter), arguments.size() - from));
}

std::span<const double> Command::array() const {
    const std::size_t parameter = sig().first_array();
    return parameter < sig().parameters.size() ? values(parameter) : std::span<const double>{};
}

std::string_view Command::text() const {
    if (!memory) return {};
    return {reinterpret_cast<const char*>(memory->bytes.data()), memory->bytes.size()};
}

std::string Signature::usage() const {
    std::vector<std::string> names;
    for (const Parameter& parameter : std::span(parameters).first(c_arguments())) {
        names.emplace_back(parameter.name);
        if (parameter.extent == Extent::kRest) names.back() += "...";
    }
    return fmt::format("{}({})", name, fmt::join(names, ", "));
}

const Signature& signature(CommandId id) { return table()[static_cast<std::size_t>(id)]; }

std::span<const Signature> signatures() { return table(); }

std::optional<CommandId> find_command(std::string_view name) {
    static const auto index = index_commands(false);
    return find(index, name);
}

std::optional<CommandId> find_command_or_extension(std::string_view name) {
    if (const auto id = find_command(name)) return id;
    // These differ from the core: EXT_vertex_array also takes a count, and the bias of EXT_polygon_offset is a depth.
    for (std::string_view other : {"glVertexPointerEXT", "glNormalPointerEXT", "glColorPointerEXT",
                                   "glTexCoordPointerEXT", "glEdgeFlagPointerEXT", "glPolygonOffsetEXT"}) {
        if (name == other) return std::nullopt;
    }
    const bool is_of_extension = name.ends_with("ARB") || name.ends_with("EXT");
    return is_of_extension ? find_command(name.substr(0, name.size() - 3)) : std::nullopt;
}

std::optional<CommandId> find_pragma(std::string_view name) {
    static const auto index = index_commands(true);
    return find(index, name);
}

std::string Place::str() const {
    const std::string_view name = file ? std::string_view(*file) : "scene";
    if (column == kCallNumber) return tr("{}: call {}", name, line);
    if (line == 0) return std::string(name);
    if (column == 0) return fmt::format("{}:{}", name, line);
    return fmt::format("{}:{}:{}", name, line, column);
}

void CommandList::for_each(const std::function<bool(const Step&)>& visit) const {
    for (const Command& command : commands) {
        if (!visit({.command = command})) return;
    }
}

std::string CommandList::title() const {
    return step == 0 ? name : fmt::format("{}, step {}: {}", name, step, steps[step - 1]);
}

std::span<const ParameterInfo> parameter_infos() {
    static const std::vector<ParameterInfo> rows = {
#define PARAMETER(owner, name, count, meaning, smallest, largest) \
    {Owner::owner, kGL_##name, count, Meaning::meaning, smallest, largest},
#include "scene/command/parameters.def"
#undef PARAMETER
    };
    return rows;
}

const ParameterInfo* find_parameter(Owner owner, Enum pname) {
    for (const ParameterInfo& info : parameter_infos()) {
        if (info.owner == owner && info.pname == pname) return &info;
    }
    return nullptr;
}

namespace {

std::optional<Owner> owner_by_name(std::string_view name) {
    if (name.starts_with("glLightModel")) return Owner::kLightModel;
    if (name.starts_with("glLight") || name.starts_with("glGetLight")) return Owner::kLight;
    if (name.starts_with("glMaterial") || name.starts_with("glGetMaterial")) return Owner::kMaterial;
    if (name.starts_with("glFog")) return Owner::kFog;
    if (name.starts_with("glTexEnv") || name.starts_with("glGetTexEnv")) return Owner::kTexEnv;
    if (name.starts_with("glTexGen") || name.starts_with("glGetTexGen")) return Owner::kTexGen;
    if (name.starts_with("glTexParameter") || name.starts_with("glGetTexParameter")) return Owner::kTexture;
    if (name.starts_with("glPixelStore")) return Owner::kPixelStore;
    if (name.starts_with("glPointParameter")) return Owner::kPoint;
    return std::nullopt;
}

}  // namespace

std::optional<Owner> owner_of(CommandId id) {
    static const std::vector<std::optional<Owner>> owners = [] {
        std::vector<std::optional<Owner>> found;
        for (const Signature& signature : signatures()) found.push_back(owner_by_name(signature.name));
        return found;
    }();
    return owners[static_cast<std::size_t>(id)];
}

namespace {

// glTexEnv has parameters of three targets.
const ParameterInfo* find_of_any_target(Owner owner, Enum pname) {
    const ParameterInfo* info = find_parameter(owner, pname);
    for (const Owner other : {Owner::kTexFilterControl, Owner::kPointSprite})
        if (!info && owner == Owner::kTexEnv) info = find_parameter(other, pname);
    return info;
}

}  // namespace

const ParameterInfo* parameter_info(const Command& command) {
    const std::optional<Owner> owner = owner_of(command.id);
    if (!owner) return nullptr;
    const std::vector<Parameter>& parameters = command.sig().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].name == "pname") return find_of_any_target(*owner, command.enumerant(i));
    }
    return nullptr;
}

std::optional<int> query_length(Enum pname) {
    switch (pname) {
        case kGL_MODELVIEW_MATRIX:
        case kGL_PROJECTION_MATRIX:
        case kGL_TEXTURE_MATRIX:
        case kGL_TRANSPOSE_MODELVIEW_MATRIX:
        case kGL_TRANSPOSE_PROJECTION_MATRIX:
        case kGL_TRANSPOSE_TEXTURE_MATRIX: return 16;
        case kGL_ACCUM_CLEAR_VALUE:
        case kGL_BLEND_COLOR:
        case kGL_COLOR_CLEAR_VALUE:
        case kGL_COLOR_WRITEMASK:
        case kGL_CURRENT_COLOR:
        case kGL_CURRENT_RASTER_COLOR:
        case kGL_CURRENT_RASTER_SECONDARY_COLOR:
        case kGL_CURRENT_RASTER_POSITION:
        case kGL_CURRENT_RASTER_TEXTURE_COORDS:
        case kGL_CURRENT_SECONDARY_COLOR:
        case kGL_CURRENT_TEXTURE_COORDS:
        case kGL_FOG_COLOR:
        case kGL_LIGHT_MODEL_AMBIENT:
        case kGL_MAP2_GRID_DOMAIN:
        case kGL_SCISSOR_BOX:
        case kGL_VIEWPORT: return 4;
        case kGL_CURRENT_NORMAL:
        case kGL_POINT_DISTANCE_ATTENUATION: return 3;
        case kGL_ALIASED_LINE_WIDTH_RANGE:
        case kGL_ALIASED_POINT_SIZE_RANGE:
        case kGL_DEPTH_RANGE:
        case kGL_LINE_WIDTH_RANGE:
        case kGL_MAP1_GRID_DOMAIN:
        case kGL_MAP2_GRID_SEGMENTS:
        case kGL_MAX_VIEWPORT_DIMS:
        case kGL_POINT_SIZE_RANGE:
        case kGL_POLYGON_MODE: return 2;
        default: return std::nullopt;
    }
}

std::optional<int> array_length(CommandId id, std::optional<Enum> pname) {
    const Signature& sig = signature(id);
    const Parameter& array = sig.parameters.at(sig.first_array());
    if (array.extent == Extent::kArray || array.extent == Extent::kOutput) return array.count;
    const bool asks_state = array.extent == Extent::kOutputByPname && sig.parameters[0].name == "pname";
    if (asks_state) return pname ? query_length(*pname) : std::nullopt;
    const std::optional<Owner> owner = owner_of(id);
    const ParameterInfo* info = owner && pname ? find_of_any_target(*owner, *pname) : nullptr;
    return info ? std::optional(info->count) : std::nullopt;
}

}  // namespace twinlight
