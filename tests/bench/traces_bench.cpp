// How fast recorded programs are read, in commands of GL a second.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "../unit/run_program.h"
#include "image/file.h"
#include "scenes/load.h"
#include "state/state.h"

namespace twinlight {

namespace {

constexpr int kFrames = 2000;

// A dump of many frames: those of tests/traces/glxgears with the second one again and again, calls in immediate mode
// among them, some 440,000 commands.
class LongDump {
  public:
    LongDump() : file_(folder_ / "dump.txt") {
        const std::string dump = read_file("tests/traces/glxgears/dump.txt");
        const std::size_t first_end = dump.find("\n\n") + 2;
        const std::string frame = dump.substr(first_end);
        std::string text = dump;
        for (int i = 0; i < kFrames; ++i) {
            text += frame;
            for (int k = 0; k < 40; ++k) {
                text += fmt::format(
                    "{0} glNormal3f(nx = 0.3, ny = -0.25, nz = 0.9205977)\n{0} glColor4ub(red = 12, green = 200, blue "
                    "= 3, "
                    "alpha = 255)\n{0} glTexCoord2f(s = 0.5, t = 1.25)\n{0} glVertex3f(x = 1.5e-05, y = -12.75, z = "
                    "{1})\n",
                    i, k);
            }
        }
        write_file_atomically(file_, text);
    }
    const std::string& file() const { return file_; }

  private:
    TemporaryFolder folder_;
    std::string file_;
};

const std::string& long_dump() {
    static const LongDump dump;
    return dump.file();
}

std::int64_t commands_of(const Recording& recording) {
    std::int64_t commands = 0;
    recording.for_each([&](const Step& step) {
        commands += step.kind == Step::Kind::kCommand;
        return true;
    });
    return commands;
}

void read_dump(benchmark::State& state) {
    const auto recording = load_recording(long_dump());
    std::int64_t commands = 0;
    for (auto _ : state) commands += commands_of(*recording);
    state.SetItemsProcessed(commands);
}
BENCHMARK(read_dump)->Unit(benchmark::kMillisecond)->UseRealTime();

void read_dump_into_state(benchmark::State& state) {
    const auto recording = load_recording(long_dump());
    std::int64_t commands = 0;
    for (auto _ : state) {
        State machine({.width = 300, .height = 300});
        recording->for_each([&](const Step& step) {
            if (step.kind == Step::Kind::kCommand) {
                machine.apply(step.command);
                ++commands;
            }
            if (step.kind == Step::Kind::kFrameEnd) machine.drop_picture();
            return true;
        });
        benchmark::DoNotOptimize(machine.errors().size());
    }
    state.SetItemsProcessed(commands);
}
BENCHMARK(read_dump_into_state)->Unit(benchmark::kMillisecond)->UseRealTime();

// A trace of glxgears that is recorded first, and its dump.
class Glxgears {
  public:
    Glxgears() {
        std::filesystem::copy_file("tests/traces/record.sh", folder_ / "record.sh");
        write_file_atomically(folder_ / "README.md",
                              "| `gears` | mesa-utils | MIT | gl | 20 | 2000 | `glxgears -geometry 64x64` |\n");
        run_shell("", "vblank_mode=0 " + quoted(folder_ / "record.sh") + " -o " + quoted(folder()) + " gears");
    }
    std::string folder() const { return folder_ / "out"; }
    bool is_there() const { return std::filesystem::exists(folder() + "/gears.trace"); }

    static const Glxgears& instance() {
        static const Glxgears glxgears;
        return glxgears;
    }
    std::shared_ptr<const Recording> recording() const { return load_recording(folder() + "/gears/dump.txt"); }

  private:
    TemporaryFolder folder_;
};

constexpr const char* kNeeds = "needs apitrace, Xvfb and glxgears (mesa-utils)";

void read_glxgears(benchmark::State& state) {
    if (!Glxgears::instance().is_there()) return state.SkipWithError(kNeeds);
    const auto recording = Glxgears::instance().recording();
    std::int64_t commands = 0;
    for (auto _ : state) commands += commands_of(*recording);
    state.SetItemsProcessed(commands);
}
BENCHMARK(read_glxgears)->Unit(benchmark::kMillisecond)->UseRealTime();

// apitrace's own program.
void apitrace_dump_glxgears(benchmark::State& state) {
    if (!Glxgears::instance().is_there()) return state.SkipWithError(kNeeds);
    const std::int64_t commands = commands_of(*Glxgears::instance().recording());
    const std::string dump = "cd " + quoted(Glxgears::instance().folder()) +
                             " && apitrace dump --color=never --blobs gears.trace >/dev/null";
    for (auto _ : state) run_shell("", dump);
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * commands);
}
BENCHMARK(apitrace_dump_glxgears)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace twinlight
