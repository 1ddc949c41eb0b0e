#include "judge/conformance/c_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "scene/shape/written_out.h"

namespace twinlight::conformance {

namespace {

// The only function of GLU in the built-in cases, as the one of GL that it calls, so that GLU is not needed.
Command without_glu(const Command& command) {
    if (command.id != CommandId::gluPerspective) return command;
    const double near_z = command.number(2), top = near_z * std::tan(command.number(0) * std::numbers::pi / 360);
    const double right = top * command.number(1);
    return {CommandId::glFrustum, {-right, right, -top, top, near_z, command.number(3)}, command.place};
}

// Sets a parameter of glPixelTransfer back, because it would change what glReadPixels returns, too.
std::optional<Command> undone(const Command& command) {
    if (command.id != CommandId::glPixelTransferi && command.id != CommandId::glPixelTransferf) return std::nullopt;
    switch (command.enumerant(0)) {
        case kGL_RED_SCALE:
        case kGL_GREEN_SCALE:
        case kGL_BLUE_SCALE:
        case kGL_ALPHA_SCALE:
        case kGL_DEPTH_SCALE: return Command{command.id, {command.number(0), 1}, command.place};
        default: return Command{command.id, {command.number(0), 0}, command.place};
    }
}

}  // namespace

CommandList c_scene(const CommandList& scene) {
    CommandList written{scene.name, {}};
    for (const Command& command : with_pragmas_written_out(scene).commands) {
        if (command.name().starts_with("glut"))
            std::ranges::move(shape_commands(command), std::back_inserter(written.commands));
        else
            written.commands.push_back(without_glu(command));
    }
    for (const Command& command : scene.commands)
        if (const std::optional<Command> back = undone(command)) written.commands.push_back(*back);
    return written;
}

bool needs_glu(const CommandList& scene) {
    return std::ranges::any_of(scene.commands, [](const Command& command) {
        return command.name().starts_with("glu") && !command.name().starts_with("glut");
    });
}

std::string c_literal(const std::string& text) {
    std::string literal = "\"";
    for (const char c : text) literal += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return literal + "\"";
}

}  // namespace twinlight::conformance
