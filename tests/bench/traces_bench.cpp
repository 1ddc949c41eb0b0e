// How fast recorded programs are read, in commands of GL a second.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "../unit/run_program.h"
#include "base/image/file.h"
#include "ratios.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::traces_bench {

namespace {

// How often the long dump repeats a frame, and how long glxgears is recorded.
struct Lengths {
    int frames = 2000;
    int gears_seconds = 20, gears_frames = 2000;
};
Lengths lengths(const bench::Results& results) {
    return results.is_quick() ? Lengths{.frames = 20, .gears_seconds = 2, .gears_frames = 2} : Lengths{};
}

// A dump of many frames: those of tests/traces/glxgears with the second one again and again, calls in immediate mode
// among them: of 2000 frames, some 440,000 commands.
class LongDump {
  public:
    explicit LongDump(int frames) : file_(folder_ / "dump.txt") {
        const std::string dump = read_file("tests/traces/glxgears/dump.txt");
        const std::size_t first_end = dump.find("\n\n") + 2;
        const std::string frame = dump.substr(first_end);
        std::string text = dump;
        for (int i = 0; i < frames; ++i) {
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

std::int64_t commands_of(const Recording& recording) {
    std::int64_t commands = 0;
    recording.for_each([&](const Step& step) {
        commands += step.kind == Step::Kind::kCommand;
        return true;
    });
    return commands;
}

void into_state(const Recording& recording) {
    State machine({.width = 300, .height = 300});
    recording.for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kCommand) machine.apply(step.command);
        if (step.kind == Step::Kind::kFrameEnd) machine.drop_picture();
        return true;
    });
}

// A trace of glxgears that is recorded first, and its dump.
class Glxgears {
  public:
    Glxgears(int seconds, int frames) {
        std::filesystem::copy_file("tests/traces/record.sh", folder_ / "record.sh");
        write_file_atomically(
            folder_ / "README.md",
            fmt::format("| `gears` | mesa-utils | MIT | gl | {} | {} | `glxgears -geometry 64x64` |\n", seconds,
                        frames));
        run_shell("", "vblank_mode=0 " + quoted(folder_ / "record.sh") + " -o " + quoted(folder()) + " gears");
    }
    std::string folder() const { return folder_ / "out"; }
    bool is_there() const { return std::filesystem::exists(folder() + "/gears.trace"); }

    std::shared_ptr<const Recording> recording() const { return load_recording(folder() + "/gears/dump.txt"); }

  private:
    TemporaryFolder folder_;
};

// For one command of GL each.
void compare_readers(bench::Results& results) {
    const bench::Rounds rounds{.clock = bench::Clock::kWall};  // apitrace is another process
    const Lengths length = lengths(results);
    const LongDump long_dump(length.frames);
    const auto recording = load_recording(long_dump.file());
    const auto commands = static_cast<double>(commands_of(*recording));
    const auto long_ones =
        results.compare("a long recording, a command",
                        {{"carried out by the state machine", [&] { into_state(*recording); }, commands},
                         {"read", [&] { commands_of(*recording); }, commands}},
                        rounds);
    results.ratio("read_dump_over_read_dump_into_state", bench::times_faster(long_ones[1], long_ones[0]));

    const Glxgears glxgears(length.gears_seconds, length.gears_frames);
    if (!glxgears.is_there())
        return results.remark("against apitrace: left out, needs apitrace, Xvfb and glxgears (mesa-utils)");
    const auto gears = glxgears.recording();
    const auto gears_commands = static_cast<double>(commands_of(*gears));
    // apitrace's own program.
    const std::string dump =
        "cd " + quoted(glxgears.folder()) + " && apitrace dump --color=never --blobs gears.trace >/dev/null";
    const auto two = results.compare("a recording of glxgears, a command",
                                     {{"apitrace dump", [&] { run_shell("", dump); }, gears_commands},
                                      {"read", [&] { commands_of(*gears); }, gears_commands}},
                                     rounds);
    results.ratio("read_glxgears_over_apitrace_dump_glxgears", bench::times_faster(two[1], two[0]));
}

// A recording of 1.6 million calls with their call stacks: as a .trace, and as what `apitrace dump` prints of it.
void compare_recordings(bench::Results& results) {
    const TemporaryFolder folder;
    const std::string trace = folder / "many.trace", dump = folder / "dump.txt";
    const ProgramResult recorded = run_shell(
        "twinlight",
        fmt::format("env -u DISPLAY \"$PROGRAM\" record --seconds {} --frames {} -o {} tests/bench/many_vertices.c",
                    results.is_quick() ? 2 : 30, results.is_quick() ? 1 : 4, quoted(trace)));
    if (!std::filesystem::exists(trace))
        return results.remark("left out, needs apitrace, Xvfb, cc and freeglut: " + recorded.err);
    const std::string print = "cd " + quoted(folder.str()) +
                              " && apitrace dump --color=never --thread-ids=yes "
                              "--arg-names=no --blobs many.trace >dump.txt";
    run_shell("", print);
    const auto binary = load_recording(trace), text = load_recording(dump);
    const auto commands = static_cast<double>(commands_of(*binary));
    results.remark(fmt::format("{} commands, {} MB", commands, std::filesystem::file_size(trace) >> 20));
    const auto times =
        results.compare("a recording of many vertices, a command",
                        {{"apitrace dump", [&] { run_shell("", print); }, commands},
                         {"its text read", [&] { commands_of(*text); }, commands},
                         {".trace read", [&] { commands_of(*binary); }, commands},
                         {".trace carried out by the state machine", [&] { into_state(*binary); }, commands}},
                        {.count = 5, .clock = bench::Clock::kWall});
    results.ratio("read_trace_over_apitrace_dump", bench::times_faster(times[2], times[0]));
    results.ratio("read_trace_over_read_dump", bench::times_faster(times[2], times[1]));
}

const bool added = bench::add_part("traces", compare_readers),
           added_recordings = bench::add_part("recordings", compare_recordings);

}  // namespace

}  // namespace twinlight::traces_bench
