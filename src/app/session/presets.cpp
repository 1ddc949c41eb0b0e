#include "app/session/presets.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "app/session/edits.h"
#include "scene/command/command_set.h"
#include "scene/frame/parameter_rows.h"

namespace twinlight::session {
namespace {

// teapots.c gives the shininess as a share of 128.
constexpr MaterialPreset kPresets[] = {
    {"emerald", {0.0215, 0.1745, 0.0215}, {0.07568, 0.61424, 0.07568}, {0.633, 0.727811, 0.633}, 0.6 * 128},
    {"jade", {0.135, 0.2225, 0.1575}, {0.54, 0.89, 0.63}, {0.316228, 0.316228, 0.316228}, 0.1 * 128},
    {"obsidian", {0.05375, 0.05, 0.06625}, {0.18275, 0.17, 0.22525}, {0.332741, 0.328634, 0.346435}, 0.3 * 128},
    {"pearl", {0.25, 0.20725, 0.20725}, {1, 0.829, 0.829}, {0.296648, 0.296648, 0.296648}, 0.088 * 128},
    {"ruby", {0.1745, 0.01175, 0.01175}, {0.61424, 0.04136, 0.04136}, {0.727811, 0.626959, 0.626959}, 0.6 * 128},
    {"turquoise", {0.1, 0.18725, 0.1745}, {0.396, 0.74151, 0.69102}, {0.297254, 0.30829, 0.306678}, 0.1 * 128},
    {"brass",
     {0.329412, 0.223529, 0.027451},
     {0.780392, 0.568627, 0.113725},
     {0.992157, 0.941176, 0.807843},
     0.21794872 * 128},
    {"bronze", {0.2125, 0.1275, 0.054}, {0.714, 0.4284, 0.18144}, {0.393548, 0.271906, 0.166721}, 0.2 * 128},
    {"chrome", {0.25, 0.25, 0.25}, {0.4, 0.4, 0.4}, {0.774597, 0.774597, 0.774597}, 0.6 * 128},
    {"copper", {0.19125, 0.0735, 0.0225}, {0.7038, 0.27048, 0.0828}, {0.256777, 0.137622, 0.086014}, 0.1 * 128},
    {"gold", {0.24725, 0.1995, 0.0745}, {0.75164, 0.60648, 0.22648}, {0.628281, 0.555802, 0.366065}, 0.4 * 128},
    {"silver", {0.19225, 0.19225, 0.19225}, {0.50754, 0.50754, 0.50754}, {0.508273, 0.508273, 0.508273}, 0.4 * 128},
    {"black plastic", {0, 0, 0}, {0.01, 0.01, 0.01}, {0.5, 0.5, 0.5}, 0.25 * 128},
    {"cyan plastic", {0, 0.1, 0.06}, {0, 0.50980392, 0.50980392}, {0.50196078, 0.50196078, 0.50196078}, 0.25 * 128},
    {"green plastic", {0, 0, 0}, {0.1, 0.35, 0.1}, {0.45, 0.55, 0.45}, 0.25 * 128},
    {"red plastic", {0, 0, 0}, {0.5, 0, 0}, {0.7, 0.6, 0.6}, 0.25 * 128},
    {"white plastic", {0, 0, 0}, {0.55, 0.55, 0.55}, {0.7, 0.7, 0.7}, 0.25 * 128},
    {"yellow plastic", {0, 0, 0}, {0.5, 0.5, 0}, {0.6, 0.6, 0.5}, 0.25 * 128},
    {"black rubber", {0.02, 0.02, 0.02}, {0.01, 0.01, 0.01}, {0.4, 0.4, 0.4}, 0.078125 * 128},
    {"cyan rubber", {0, 0.05, 0.05}, {0.4, 0.5, 0.5}, {0.04, 0.7, 0.7}, 0.078125 * 128},
    {"green rubber", {0, 0.05, 0}, {0.4, 0.5, 0.4}, {0.04, 0.7, 0.04}, 0.078125 * 128},
    {"red rubber", {0.05, 0, 0}, {0.5, 0.4, 0.4}, {0.7, 0.04, 0.04}, 0.078125 * 128},
    {"white rubber", {0.05, 0.05, 0.05}, {0.5, 0.5, 0.5}, {0.7, 0.7, 0.7}, 0.078125 * 128},
    {"yellow rubber", {0.05, 0.05, 0}, {0.5, 0.5, 0.4}, {0.7, 0.7, 0.04}, 0.078125 * 128},
};

constexpr std::array<Enum, 4> kPresetPnames = {kGL_AMBIENT, kGL_DIFFUSE, kGL_SPECULAR, kGL_SHININESS};

Command material_call(Enum face, Enum pname, std::vector<double> values) {
    values.insert(values.begin(), {static_cast<double>(face), static_cast<double>(pname)});
    return new_command(values.size() == 3 ? CommandId::glMaterialf : CommandId::glMaterialfv, std::move(values));
}

std::vector<double> opaque(const std::array<double, 3>& color) { return {color[0], color[1], color[2], 1}; }

std::vector<double> property_of(const Material& material, Enum pname) {
    return values_of(material, *find_parameter_row<Material>(pname));
}

// Whether the preset sets all that this glMaterial sets.
bool is_replaced(const Command& command) {
    constexpr CommandSet kMaterial = CommandSet::of({"material"});
    if (!kMaterial.contains(command.id)) return false;
    const Enum pname = command.enumerant(1);
    return pname == kGL_AMBIENT_AND_DIFFUSE || std::ranges::find(kPresetPnames, pname) != kPresetPnames.end();
}

// Calls that give the drawing commands after this one the values that they had.
std::vector<Command> restoring(const CommandList& commands, const LightingValues& values, std::size_t last) {
    std::vector<Command> calls;
    const std::vector<DrawingCommand> drawing = drawing_commands(commands);
    const auto next = std::ranges::find_if(drawing, [&](const DrawingCommand& d) { return d.command > last; });
    if (next == drawing.end()) return calls;
    const auto later = lighting_values(commands, next->command);
    if (!later) return calls;
    for (const Enum pname : kPresetPnames) {
        const auto needs = [&](const FaceValues& face) {
            const SetBy& by = face.set_by_of(pname);
            return by.source != Source::kColor && (!by.command || *by.command < values.drawing.command);
        };
        const bool front = needs(later->front), back = needs(later->back);
        const std::vector<double> of_front = property_of(values.front.material, pname),
                                  of_back = property_of(values.back.material, pname);
        if (front && back && of_front == of_back) {
            calls.push_back(material_call(kGL_FRONT_AND_BACK, pname, of_front));
            continue;
        }
        if (front) calls.push_back(material_call(kGL_FRONT, pname, of_front));
        if (back) calls.push_back(material_call(kGL_BACK, pname, of_back));
    }
    return calls;
}

}  // namespace

std::span<const MaterialPreset> material_presets() { return kPresets; }

CommandList with_preset(const CommandList& commands, std::size_t drawing_command, const MaterialPreset& preset) {
    const auto values = lighting_values(commands, drawing_command);
    if (!values) return commands;
    const std::size_t last = end_of_group(commands, drawing_command);
    const std::vector<Command> after = restoring(commands, *values, last);
    CommandList result = commands;
    std::vector<Command>& list = result.commands;
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(last) + 1, after.begin(), after.end());

    const Command calls[] = {material_call(kGL_FRONT_AND_BACK, kGL_AMBIENT, opaque(preset.ambient)),
                             material_call(kGL_FRONT_AND_BACK, kGL_DIFFUSE, opaque(preset.diffuse)),
                             material_call(kGL_FRONT_AND_BACK, kGL_SPECULAR, opaque(preset.specular)),
                             material_call(kGL_FRONT_AND_BACK, kGL_SHININESS, {preset.shininess})};
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(drawing_command), std::begin(calls), std::end(calls));

    // What the new calls replace: glMaterial between this drawing command and the one before it.
    const std::vector<DrawingCommand> drawing = drawing_commands(commands);
    std::size_t from = 0;
    for (const DrawingCommand& other : drawing)
        if (other.command < drawing_command) from = end_of_group(commands, other.command) + 1;
    constexpr CommandSet kBorders = CommandSet::of({"push_attrib", "pop_attrib", "new_list", "end_list"});
    for (std::size_t i = drawing_command; i-- > from && !kBorders.contains(commands.commands[i].id);)
        if (is_replaced(commands.commands[i])) list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    return result;
}

}  // namespace twinlight::session
