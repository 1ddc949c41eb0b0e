// The recordings of tests/traces, and those that `make bench BENCH=real` makes of other programs, drawn by the fixed function and by
// shaders.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ratios.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "ways.h"

namespace twinlight::real_bench {
namespace {

// Name and folder.
std::map<std::string, std::string> recordings() {
    std::map<std::string, std::string> found;
    for (const std::string& parent : {std::string("tests/traces"), bench::build_folder() + "/recorded"}) {
        if (!std::filesystem::exists(parent)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(parent))
            if (std::filesystem::exists(entry.path() / "dump.txt"))
                found.emplace(entry.path().filename(), entry.path());
    }
    return found;
}

// Nothing for a program that draws nothing, such as one that uses only shaders: then the reason is printed.
std::optional<RecordedFrame> frame_of(const std::string& folder, bench::Results& results) {
    try {
        return make_recorded_frame(load_recording(folder + "/dump.txt"), {});
    } catch (const SceneError& error) {
        results.remark(error.what());
        return {};
    }
}

// Three comparisons for each. Prepared: all is in the driver's buffers. From commands: the fixed function executes the
// program's commands; the shaders plan, look for what has not changed, and upload the rest. First: as `compare` draws, which
// plans, uploads and reads back one picture. Warm: the programs are compiled; cold: the driver compiles them, too.
void measure_recordings(bench::Results& results) {
    std::vector<double> prepared, from_commands, first;
    double least = 1e300;
    for (const auto& [name, folder] : recordings()) {
        const std::optional<RecordedFrame> recorded = frame_of(folder, results);
        if (!recorded) continue;
        const Frame& frame = recorded->scene.frame;
        const auto context = make_offscreen_context(frame.width, frame.height);
        const auto renderer = std::make_shared<programmable::Renderer>();
        const programmable::Options live = bench::options_for(programmable::Tier::kAuto, false);
        const auto draw_live = [&] {
            renderer->draw(frame, live);
            glFinish();
        };
        programmable::Renderer warm;
        const programmable::Options once = bench::options_for(programmable::Tier::kUniform, false);
        // A program is made in each of the first frames, until all that does not change is constant.
        for (int i = 0; i < (results.is_quick() ? 1 : 40); ++i) draw_live();
        const auto times =
            results.compare(fmt::format("{}, {} draws, a frame", name, frame.draws().size()),
                            {bench::fixed_way("fixed, prepared", frame, fixed::Scrub::kNothing, true),
                             bench::shader_way("shaders, prepared", frame, programmable::Tier::kUniform, true),
                             {"fixed, from commands",
                              [&] {
                                  fixed::draw(recorded->scene);
                                  glFinish();
                              }},
                             {"shaders, from commands", draw_live},
                             {"fixed, first, warm", [&] { fixed::render(recorded->scene); }},
                             {"shaders, first, warm", [&] { warm.render(frame, once); }},
                             {"shaders, first, cold", [&] { programmable::Renderer().render(frame, once); }}});
        prepared.push_back(bench::times_faster(times[1], times[0]));
        from_commands.push_back(bench::times_faster(times[3], times[2]));
        first.push_back(bench::times_faster(times[5], times[4]));
        least = std::min({least, prepared.back(), from_commands.back()});
        results.ratio("real_" + name + "_prepared", prepared.back(), bench::Bar{1});
        results.ratio("real_" + name + "_from_commands", from_commands.back(), bench::Bar{1});
        results.ratio("real_" + name + "_first", first.back(), bench::Bar{0.5});
        results.ratio("real_" + name + "_first_cold", bench::times_faster(times[6], times[4]));
    }
    results.ratio("real_shaders_over_fixed_first", bench::geometric_mean(first));
    results.ratio("real_shaders_over_fixed_prepared", bench::geometric_mean(prepared), bench::Bar{1.5});
    results.ratio("real_shaders_over_fixed_from_commands", bench::geometric_mean(from_commands), bench::Bar{1.5});
    results.ratio("real_least", least, bench::Bar{1});
}

const bool added = bench::add_part("real", measure_recordings);

}  // namespace
}  // namespace twinlight::real_bench
