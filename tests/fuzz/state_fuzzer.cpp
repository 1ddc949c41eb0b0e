// GL's state machine: any commands come to a Frame and to errors that say what is wrong.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "command_bytes.h"
#include "scene/state/state.h"

using namespace twinlight;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto scene = std::make_shared<CommandList>("fuzz", commands_from({data, size}));
    State state({.width = 64, .height = 48});
    for (const Command& command : scene->commands) state.apply(command);
    for (const GlError& error : state.errors())
        if (error.message.empty() || error.message.find('\n') != std::string::npos) std::abort();
    state.unfinished();
    // What the input's last byte chooses of the names that can be asked for.
    const std::size_t chosen = size > 0 ? data[size - 1] : 0;
    for (std::size_t i = chosen; i < gl_names().size(); i += 64) {
        const Enum name = gl_names()[i].value;
        state.capability(name);
        state.get_light(kGL_LIGHT0, name);
        state.get_material(kGL_FRONT, name);
    }
    state.take_frame();
    return 0;
}
