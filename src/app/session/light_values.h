// Light values: for one drawing command, the lights, materials and models that light it, and which command set each value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/command/command.h"
#include "scene/frame/frame.h"
#include "scene/frame/parameter_rows.h"

namespace twinlight::session {

// A command that draws: a shape, glBegin, glDrawArrays or glCallList.
struct DrawingCommand {
    std::size_t command = 0;                     // index into the commands
    std::size_t first_draw = 0, draw_count = 0;  // its Draws in the frame; a cylinder has three
    bool is_lit = false;                         // the first of them
    std::string name;                            // "glutSolidSphere, line 44", "glBegin(GL_QUADS), line 12"
};
std::vector<DrawingCommand> drawing_commands(const CommandList& commands);
// The one that a command belongs to: the first that draws at or after it; the last one if none does. `drawing` must not
// be empty.
std::size_t drawing_command_of(const std::vector<DrawingCommand>& drawing, std::size_t command);

// Where a value comes from.
enum class Source : std::uint8_t {
    kInitial,   // GL's initial value
    kCommand,   // glLight, glMaterial, glLightModel, ...
    kColor,     // the current colour, because GL_COLOR_MATERIAL is on (2.14.3)
    kOldColor,  // the current colour as it was while GL_COLOR_MATERIAL was on
    kOther,     // a display list or glPopAttrib
};
struct SetBy {
    Source source = Source::kInitial;
    std::optional<std::size_t> command{};  // index into the commands; empty for kInitial
};

// What set each value, in the order of the rows of parameter_rows.h.
struct LightValues {
    LightSource stored;  // position and spot direction in eye space, as GL stores them
    TypedLight typed;    // as glLight was given them
    SetBy enabled;
    std::array<SetBy, kLightParameters.size()> set_by{};

    const SetBy& set_by_of(Enum pname) const { return set_by[number_of_parameter<LightSource>(pname)]; }
};

struct FaceValues {
    Material material;  // with GL_COLOR_MATERIAL: the first vertex's
    std::array<SetBy, kMaterialParameters.size()> set_by{};

    const SetBy& set_by_of(Enum pname) const { return set_by[number_of_parameter<Material>(pname)]; }
};

// What set the values of all lights, both materials and the light model.
struct ValueOrigins {
    std::vector<LightValues> lights = std::vector<LightValues>(kMaxLights);
    FaceValues front, back;
    std::array<SetBy, kLightModelParameters.size()> light_model{};
    SetBy color_material, color_material_mode;  // glEnable(GL_COLOR_MATERIAL), glColorMaterial

    const SetBy& light_model_set_by(Enum pname) const { return light_model[number_of_parameter<LightModel>(pname)]; }
};

struct LightingValues : ValueOrigins {
    DrawingCommand drawing;
    LightingState state;                         // of the first Draw
    std::optional<std::size_t> color_command{};  // the last glColor before the first vertex
};
// For the drawing command with this index; nullopt if it draws nothing.
std::optional<LightingValues> lighting_values(const CommandList& commands, std::size_t drawing_command);

// What colour material does to a Draw: "GL_AMBIENT and GL_DIFFUSE of both faces follow glColor".
std::string color_material_words(const LightingValues& values);

// ---- Edits ----

// Sets a parameter for this drawing command: the values of the call that set it change, with all that share the call. If
// no call did, or one that sets more than this, a new call is inserted before the drawing command (glLight: at the
// start, or after the call that set the light's other parameters).
CommandList with_light_parameter(const CommandList& commands, const LightingValues& values, int light, Enum pname,
                                 const std::vector<double>& numbers);
CommandList with_material_parameter(const CommandList& commands, const LightingValues& values, Enum face, Enum pname,
                                    const std::vector<double>& numbers);
// The same for GL_LIGHT_MODEL_AMBIENT and GL_LIGHT_MODEL_COLOR_CONTROL. A new call is inserted at the start.
CommandList with_light_model(const CommandList& commands, const LightingValues& values, Enum pname,
                             const std::vector<double>& numbers);
// Sets both arguments of glColorMaterial. A new call is inserted before the drawing command's GL_COLOR_MATERIAL was
// switched, or at the start.
CommandList with_color_material(const CommandList& commands, const LightingValues& values, Enum face, Enum mode);

}  // namespace twinlight::session
