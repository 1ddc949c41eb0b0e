// A scene's commands for a window of another size.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "app/session/session.h"
#include "scene/command/command.h"

namespace twinlight::session {
namespace {

// The index of x among the arguments of a glCopyTexImage or glCopyTexSubImage; y follows, then the width and, for
// images of more than one dimension, the height.
std::optional<std::size_t> copied_rectangle(CommandId id) {
    switch (id) {
        case CommandId::glCopyTexImage1D:
        case CommandId::glCopyTexImage2D:
        case CommandId::glCopyTexSubImage1D: return 3;
        case CommandId::glCopyTexSubImage2D: return 4;
        case CommandId::glCopyTexSubImage3D: return 5;
        default: return {};
    }
}

bool lies_within_copy(const Command& viewport, const Command& copy, std::size_t first) {
    const auto& at = viewport.arguments;
    const auto& from = copy.arguments;
    const bool one_row = copy.id == CommandId::glCopyTexImage1D || copy.id == CommandId::glCopyTexSubImage1D;
    const double height = one_row ? 1 : from[first + 3];
    return at[0] >= from[first] && at[0] + at[2] <= from[first] + from[first + 2] && at[1] >= from[first + 1] &&
           at[1] + at[3] <= from[first + 1] + height;
}

// For each command whether it is a glViewport or glScissor for pixels of an image, which has its size whatever the
// window's is: one that a framebuffer object draws, or a texture to which all of the viewport is copied. The whole
// window always counts as the window.
std::vector<bool> is_for_image(const std::vector<Command>& commands, WindowSize window) {
    std::vector<bool> result(commands.size());
    bool object = false;
    std::vector<std::size_t> boxes;  // the last glViewport, and each glScissor after it
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Command& command = commands[i];
        if (command.id == CommandId::glBindFramebuffer) {
            if (command.enumerant(0) != kGL_READ_FRAMEBUFFER) object = command.number(1) != 0;
        } else if (command.id == CommandId::glViewport) {
            result[i] = object;
            boxes = {i};
        } else if (command.id == CommandId::glScissor) {
            result[i] = object;
            if (!boxes.empty()) boxes.push_back(i);
        } else if (const auto first = copied_rectangle(command.id); first && !boxes.empty()) {
            const Command& viewport = commands[boxes.front()];
            const bool is_window = viewport.number(2) == window.width && viewport.number(3) == window.height;
            if (!is_window && lies_within_copy(viewport, command, *first))
                for (const std::size_t box : boxes) result[box] = true;
        }
    }
    return result;
}

}  // namespace

CommandList scaled(const CommandList& commands, WindowSize from, WindowSize to) {
    CommandList result = commands;
    if (from == to) return result;
    const std::vector<bool> keeps_size = is_for_image(commands.commands, from);
    const double across = static_cast<double>(to.width) / from.width;
    const double up = static_cast<double>(to.height) / from.height;
    for (std::size_t i = 0; i < result.commands.size(); ++i) {
        Command& command = result.commands[i];
        std::vector<double>& arguments = command.arguments;
        if (command.name().starts_with("glWindowPos")) {
            arguments[0] = std::round(arguments[0] * across);
            arguments[1] = std::round(arguments[1] * up);
            continue;
        }
        const bool is_box = command.id == CommandId::glViewport || command.id == CommandId::glScissor ||
                            command.id == CommandId::glCopyPixels;
        if (!is_box || keeps_size[i]) continue;
        // Both borders are rounded, so that viewports that touch still touch.
        const auto scale = [&](std::size_t start, std::size_t length, double factor) {
            const double first = std::round(arguments[start] * factor);
            const double last = std::round((arguments[start] + arguments[length]) * factor);
            arguments[start] = first;
            if (arguments[length] > 0) arguments[length] = std::max(last - first, 1.0);
        };
        scale(0, 2, across);
        scale(1, 3, up);
    }
    return result;
}

}  // namespace twinlight::session
