// A scene: its commands, and the Frame that State builds from them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/command/command.h"
#include "scene/frame/frame.h"

namespace twinlight {

struct Scene {
    std::shared_ptr<const Recording> recording;  // the fixed function executes these commands
    Frame frame;                                 // shaders and the reference draw this
    std::vector<std::string> notes{};            // of a recorded program: what a viewer of its picture should know

    const std::string& name() const { return recording->name; }
    std::string title() const { return recording->title(); }  // the name and, if there is one, the step
};

}  // namespace twinlight
