#include "counted_work.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "../bench/lit_spheres.h"
#include "render/effect/plan.h"
#include "render/reference/vertices/lit_vertices.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/shape/vertex_order.h"
#include "scene/state/state.h"

namespace twinlight::counted {
namespace {

struct Made {
    std::vector<Frame> frames;
    std::vector<std::vector<Command>> pictures;  // of the recording, each with the commands that make it
    Draw sphere;
};

// The scenes of the course change more often than the code that is counted.
std::vector<EmbeddedFile> read_files() {
    std::vector<EmbeddedFile> files;
    for (const EmbeddedFile& file : kSceneFiles)
        if (file.name == "commands.gl" || file.name == "legacy.gl") files.push_back(file);
    return files;
}

const Made& made() {
    static const Made all = [] {
        Made m;
        for (const EmbeddedFile& file : read_files())
            m.frames.push_back(make_frame(read_built_in(file), {.width = 64, .height = 64}));
        load_recording("tests/traces/glxgears/dump.txt")->for_each([&](const Step& step) {
            if (m.pictures.empty() || step.kind == Step::Kind::kFrameEnd) m.pictures.emplace_back();
            if (step.kind == Step::Kind::kCommand) m.pictures.back().push_back(step.command);
            return true;
        });
        m.sphere = bench::sphere(64, 32);
        m.sphere.lighting = bench::seven_scenes(m.sphere).at(1).draw.lighting;
        return m;
    }();
    return all;
}

std::size_t plans() {
    std::size_t lights = 0;
    for (const Frame& frame : made().frames)
        for (const auto& item : frame.items)
            if (const Draw* draw = std::get_if<Draw>(&item)) lights += plan_effects(*draw, {}).lights.size();
    return lights;
}

}  // namespace

void prepare() { made(); }
// The second time, all memory is what the first one freed. What the first one finds hangs on the tests that are linked: 0.8 %.
void prepare_plans() { plans(); }

// Functions that the compiler must not take apart.
extern "C" {

__attribute__((noinline)) std::size_t counted_read() {
    std::size_t commands = 0;
    for (const EmbeddedFile& file : read_files()) commands += read_built_in(file).commands.size();
    return commands;
}

__attribute__((noinline)) std::size_t counted_state() {
    State machine({.width = 300, .height = 300});
    std::size_t applied = 0;
    for (const std::vector<Command>& picture : made().pictures) {
        for (const Command& command : picture) machine.apply(command);
        machine.drop_picture();
        applied += picture.size();
    }
    return applied;
}

__attribute__((noinline)) std::size_t counted_plan() { return plans(); }

__attribute__((noinline)) std::size_t counted_reference() {
    return reference::light_vertices(made().sphere, {}, true).size();
}

__attribute__((noinline)) std::size_t counted_patches() {
    return patched(made().sphere.indices, made().sphere.vertices.size()).patches.size();
}
}

}  // namespace twinlight::counted
