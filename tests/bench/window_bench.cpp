// The window: how long its frames take while the camera turns and the reference works beside it.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "../unit/run_program.h"
#include "../window/xvfb.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "ratios.h"

namespace twinlight::window_bench {
namespace {

// Keys: the shaders' pane lights vertices, as the fixed function does; the camera turns.
constexpr const char* kKeys = "ggg ";
constexpr int kFrames = 300, kFramesOfQuickRun = 5;
constexpr std::size_t kFirst = 60;  // until then, shaders are made

struct Times {
    std::vector<double> frame_ms;
    std::vector<std::vector<double>> pane_ms;
};

Times run_window(const Xvfb& server, const std::string& view, int frames) {
    const TemporaryFolder folder;
    const std::string file = folder / "times.json";
    // As users run it: with llvmpipe's threads and the driver's cache of shaders.
    const std::string command = fmt::format(
        "env -u LP_NUM_THREADS -u MESA_SHADER_CACHE_DISABLE LIBGL_ALWAYS_SOFTWARE=1 DISPLAY={} {}/twinlight-demo "
        "report "
        "--size 1280x800 --scale 1 --view {} --keys '{}' --quit-after {} --times {}",
        server.display(), build_folder(), view, kKeys, frames, file);
    if (std::system(command.c_str()) != 0) throw std::runtime_error("the window failed: " + command);
    const auto json = nlohmann::json::parse(read_file(file));
    const auto tail = [&](const nlohmann::json& list) {
        auto all = list.get<std::vector<double>>();
        all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(kFirst, all.size() / 2)));
        return all;
    };
    Times times{tail(json.at("frame_ms")), {}};
    for (const auto& pane : json.at("pane_ms")) times.pane_ms.push_back(tail(pane));
    return times;
}

double share_of(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void measure_window(bench::Results& results) {
    const Xvfb server;
    if (!server.running()) {
        results.remark("the window is not measured: " + server.reason());
        return;
    }
    const int frames = results.is_quick() ? kFramesOfQuickRun : kFrames;
    const Times grid = run_window(server, "grid", frames);
    results.remark(
        fmt::format("report, 1280 x 800, 2 x 2, the camera turns, the reference works: a frame takes {:.1f} ms "
                    "(median), {:.1f} ms (19 of 20 take less)",
                    bench::median(grid.frame_ms), share_of(grid.frame_ms, 0.95)));
    results.ratio("window_frame_ms_median", bench::median(grid.frame_ms), bench::Bar{50, true});
    results.ratio("window_frame_ms_19_of_20", share_of(grid.frame_ms, 0.95), bench::Bar{50, true});
    // Both panes draw in each frame.
    std::vector<double> ratios;
    for (std::size_t i = 0; i < grid.pane_ms[0].size(); ++i) ratios.push_back(grid.pane_ms[0][i] / grid.pane_ms[1][i]);
    results.ratio("window_changing_shaders_over_fixed", bench::median(ratios), bench::Bar{1});
}

// Without the driver's cache of shaders, so that each key is the first of its kind: the longest frame after the first one, which is what
// the window needs for an answer.
double longest_cold_frame(const Xvfb& server, bool is_quick) {
    const TemporaryFolder folder;
    const std::string file = folder / "times.json", display = "DISPLAY=" + server.display() + " ";
    std::string keys;
    for (const char* key : {"f", "g", "t", "g", "x", "l", "r"})
        keys += fmt::format("key {} sleep {} ", key, is_quick ? 0 : 2);
    const std::string command = fmt::format(
        "env -u LP_NUM_THREADS MESA_SHADER_CACHE_DISABLE=true LIBGL_ALWAYS_SOFTWARE=1 XDG_CONFIG_HOME={0} "
        "XDG_STATE_HOME={0} "
        "{1}{2}/twinlight-demo report --size 1280x800 --scale 1 --times {3} & {1}xdotool search --sync --onlyvisible "
        "--name "
        "twinlight sleep 4 mousemove 900 300 {4} key Escape > /dev/null 2>&1; wait",
        folder / "config", display, build_folder(), file, keys);
    if (std::system(command.c_str()) != 0) throw std::runtime_error("the window failed: " + command);
    const auto frames = nlohmann::json::parse(read_file(file)).at("frame_ms").get<std::vector<double>>();
    return *std::max_element(frames.begin() + 1, frames.end());
}

void measure_cold_keys(bench::Results& results) {
    const Xvfb server;
    if (!server.running() || std::system("command -v xdotool > /dev/null") != 0) {
        results.remark("cold keys are not measured: Xvfb or xdotool is missing");
        return;
    }
    results.ratio("window_cold_key_ms_most", longest_cold_frame(server, results.is_quick()), bench::Bar{150, true});
}

const bool added_cold_keys = bench::add_part("cold_keys", measure_cold_keys);
const bool added = bench::add_part("window", measure_window);

}  // namespace
}  // namespace twinlight::window_bench
