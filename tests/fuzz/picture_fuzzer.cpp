// The reference and the planner: whatever state commands come to, each pixel of the picture is a finite number.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "command_bytes.h"
#include "render/effect/plan.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

using namespace twinlight;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr int kSide = 12;
    const auto scene = std::make_shared<CommandList>("fuzz", commands_from({data, size}));
    State state({.width = kSide, .height = kSide});
    for (const Command& command : scene->commands) state.apply(command);
    constexpr std::size_t kMostItems = 64;  // of a picture's: an input is to take milliseconds
    if (state.exhausted() || state.inside_begin() || state.items().size() > kMostItems) return 0;
    std::size_t vertices = 0;
    for (const auto& item : state.items())
        if (const Draw* draw = std::get_if<Draw>(&item)) vertices += draw->vertices.size();
    constexpr std::size_t kMostVertices = 4096;
    if (vertices > kMostVertices) return 0;
    const Frame frame = state.take_frame();
    for (const auto& item : frame.items)
        if (const Draw* draw = std::get_if<Draw>(&item)) plan_effects(*draw, {});
    for (const Shading shading : {Shading::kGouraud, Shading::kPhong}) {
        const Image image = reference::render(frame, {{.shading = shading}});
        for (const Rgba& pixel : image.pixels)
            for (const float channel : pixel)
                if (!std::isfinite(channel)) {
                    std::fprintf(stderr, "a pixel is not finite in\n%s\n", print_scene(*scene).c_str());
                    std::abort();
                }
    }
    return 0;
}
