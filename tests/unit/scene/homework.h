// Whole programs as a test reads them.
#pragma once

#include <string>
#include <vector>

#include "base/image/file.h"
#include "scene/command/text.h"

namespace twinlight::homework {

inline CommandList read_program(const std::string& text, const ReadOptions& options = {}) {
    return read_scene(text, "homework.c", "homework", no_images, options);
}

inline std::string error_of(const std::string& text, const ReadOptions& options = {}) {
    try {
        read_program(text, options);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

// The arguments of all commands, one after the other.
inline std::vector<double> arguments_of(const CommandList& program) {
    std::vector<double> values;
    for (const Command& command : program.commands)
        values.insert(values.end(), command.arguments.begin(), command.arguments.end());
    return values;
}

}  // namespace twinlight::homework
