// GL's state machine: any commands come to a Frame and to errors that say what is wrong.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "command_bytes.h"
#include "state/state.h"

using namespace twinlight;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto scene = std::make_shared<CommandList>("fuzz", commands_from({data, size}));
    State state({.width = 64, .height = 48});
    for (const Command& command : scene->commands) {
        const std::size_t errors = state.error_count();
        state.apply(command);
        if (state.error_count() == errors) continue;
        for (const GlError& error : state.errors())
            if (error.message.empty() || error.message.find('\n') != std::string::npos) std::abort();
    }
    state.unfinished();
    for (const NamedValue& name : gl_names()) state.get(name.value);
    state.take_frame(scene);
    return 0;
}
