#include "scene/record/record.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>

#include "base/image/descriptor.h"
#include "base/image/embedded.h"
#include "base/image/file.h"
#include "base/text/input_text.h"
#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/record/keys.h"
#include "scene/record/running.h"
#include "scene/record/trace_follower.h"
#include "scene/trace/call_stacks.h"
#include "scene/trace/contexts.h"
#include "scene/trace/functions.h"
#include "scene/trace/process.h"
#include "scene/trace/temporary_folder.h"
#include "scene/trace/trace.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kRecorderFiles;  // python_lines.py

namespace trace {

namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

// An X server without a screen.
class OwnDisplay {
  public:
    OwnDisplay() {
        need("Xvfb", "xvfb", tr("running a program where DISPLAY is not set"));
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw SceneError(std::string("Xvfb: ") + tr(std::strerror(errno)));
        const Descriptor number(ends[0]);
        Descriptor writes(ends[1]);
        process_ = start({{"Xvfb", "-displayfd", "1", "-screen", "0", "1280x1024x24", "-noreset", "-nolisten", "tcp"},
                          -1,
                          writes.get(),
                          -1,
                          "/",
                          true});
        writes.close();
        if (process_ > 0) read_number(number);
        if (name_.empty()) {
            stop();
            throw SceneError(tr("Xvfb: did not start; set DISPLAY to use a display that is already there"));
        }
    }
    ~OwnDisplay() { stop(); }
    OwnDisplay(const OwnDisplay&) = delete;
    OwnDisplay& operator=(const OwnDisplay&) = delete;

    const std::string& name() const { return name_; }  // ":1"

  private:
    // The server writes its number and a newline when it accepts connections.
    void read_number(const Descriptor& pipe) {
        constexpr int kMilliseconds = 20'000;
        std::string number;
        pollfd waiting{pipe.get(), POLLIN, 0};
        while (::poll(&waiting, 1, kMilliseconds) > 0) {
            char c = 0;
            if (::read(pipe.get(), &c, 1) != 1) return;
            if (c == '\n') {
                name_ = ":" + number;
                return;
            }
            number += c;
        }
    }
    void stop() {
        if (process_ <= 0) return;
        ::kill(process_, SIGTERM);
        wait_for(std::exchange(process_, 0));
    }

    pid_t process_ = 0;
    std::string name_;
};

}  // namespace

std::string find_program(const std::string& name) {
    std::error_code ignored;
    const std::string found = name.find('/') == std::string::npos && !fs::exists(name, ignored) ? in_path(name) : name;
    if (found.empty()) throw SceneError(tr("{}: there is no such program", name));
    if (!fs::exists(found, ignored)) throw SceneError(tr("{}: there is no such file", name));
    if (!is_executable(found))
        throw SceneError(tr("{}: is not a program; give a program, or a file of C, C++ or Python", name));
    return fs::absolute(found).string();
}

namespace {

constexpr std::size_t kMostProgram = 256u << 20;

}  // namespace

bool names_egl(const std::string& program) {
    return read_file(program, kMostProgram).find("libEGL.so") != std::string::npos;
}

WindowSystem window_system_of(const std::string& program) {
    const std::string bytes = read_file(program, kMostProgram);
    const auto names = [&](std::string_view library) { return bytes.find(library) != std::string::npos; };
    // libGL.so says nothing: programs with EGL may use it for GL's functions.
    const bool has_glx = names("libGLX.so") || names("libglut.so") || names("glXMakeC");
    return names("libEGL.so") && !has_glx ? WindowSystem::kEgl : WindowSystem::kGlx;
}

namespace {

// Where apitrace has its wrapper of GL, which a program loads before GL; "" if it is not in the usual place.
std::string tracer_library(WindowSystem window_system) {
    std::error_code error;
    const fs::path lib = fs::canonical(in_path("apitrace"), error).parent_path().parent_path() / "lib";
    const std::string name = window_system == WindowSystem::kEgl ? "egltrace.so" : "glxtrace.so";
    std::vector<fs::path> folders = {lib};
    for (fs::directory_iterator at(lib, error), end; !error && at != end; at.increment(error))
        if (at->path().filename().string().find("-linux-gnu") != std::string::npos) folders.push_back(at->path());
    for (const fs::path& folder : folders)
        if (fs::exists(folder / "apitrace/wrappers" / name, error)) return folder / "apitrace/wrappers" / name;
    return "";
}

// Prefixes of the functions whose calls are recorded with their stacks: all but those that a program calls for each vertex,
// glVertex3f, glNormal3f, glTexCoord2f, which would take four times as long.
constexpr std::string_view kCallsWithStacks =
    "glA* glB* glC* glD* glE* glF* glG* glH* glI* glL* glMa* glMe* glMi* glMultM* glMultT* glMultiD* glNew* "
    "glNormalPointer* glO* glP* glQ* glR* glS* glTexB* glTexE* glTexF* glTexG* glTexI* glTexP* glTexS* "
    "glTexCoordPointer* "
    "glTr* glU* glVertexA* glVertexP* glVi* glW*";

std::string with_before(const std::string& folder, const char* variable) {
    const char* const old = std::getenv(variable);
    return std::string(variable) + "=" + folder + (old && *old ? ":" + std::string(old) : "");
}

// What the program's environment has in addition. `folder` is for the files that it loads.
std::vector<std::string> environment(const std::string& folder, WindowSystem window_system) {
    std::vector<std::string> variables = {"APITRACE_BACKTRACE=" + std::string(kCallsWithStacks)};
    // PyOpenGL, and programs that are linked by CMake, load libOpenGL.so.0 instead of libGL.so.1.
    if (const std::string library = tracer_library(window_system); !library.empty()) {
        fs::create_directory(folder + "/libraries");
        fs::create_symlink(library, folder + "/libraries/libOpenGL.so.0");
        variables.push_back(with_before(folder + "/libraries", "LD_LIBRARY_PATH"));
    }
    fs::create_directory(folder + "/python");
    write_file_atomically(folder + "/python/sitecustomize.py", kRecorderFiles.front().text);
    variables.push_back(with_before(folder + "/python", "PYTHONPATH"));
    return variables;
}

// Between "caught signal" and "taking default action" apitrace prints the program's call stack.
struct Printed {
    std::string output, stack;  // the program's output, and the stack of a crash
};

Printed printed(const std::string& text) {
    Printed found;
    InputText lines(text);
    bool in_stack = false;
    for (std::string line; std::getline(lines, line);) {
        const bool is_apitraces = line.starts_with("apitrace: ");
        if (is_apitraces && line.find("caught signal") != line.npos) in_stack = true;
        if (is_apitraces && line.find("taking default action") != line.npos) in_stack = false;
        if (!is_apitraces) (in_stack ? found.stack : found.output) += line + "\n";
    }
    return found;
}

// "ended after 0.1 s by signal 11 (Segmentation fault), at lamp.c:3". `apitrace trace` gives 128 + the signal as a status.
std::string ending(int status, double seconds, const std::string& stack) {
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : code > 128 ? code - 128 : 0;
    std::string text = signal > 0
                           ? tr("ended after {:.1f} s by signal {} ({})", seconds, signal, tr(::strsignal(signal)))
                       : code > 0 ? tr("ended after {:.1f} s with status {}", seconds, code)
                                  : tr("ended after {:.1f} s", seconds);
    const Place place = CallStacks().place(stack, "");
    if (place.calls) text += tr(", at {}:{} ({})", *place.file, place.line, *place.calls);
    return text;
}

}  // namespace

Recorded record(const RecordOptions& options) {
    need("apitrace", "apitrace", tr("recording"));
    const WindowSystem window_system = options.window_system.value_or(window_system_of(options.command.front()));
    const TemporaryFolder folder;
    const std::string whole = folder.path() + "/whole.trace";
    const char* display = std::getenv("DISPLAY");
    std::optional<OwnDisplay> own;
    // Keys must not reach other programs.
    if (!display || !*display || !options.keys.empty()) own.emplace();

    // Without WAYLAND_DISPLAY the program opens its window in the display.
    std::vector<std::string> arguments = {"env", "-u", "WAYLAND_DISPLAY"};
    if (own) arguments.push_back("DISPLAY=" + own->name());
    std::vector<std::string> sender = options.keys.empty() ? std::vector<std::string>() : sender_of(options.keys);
    sender.insert(sender.begin(), arguments.begin(), arguments.end());
    std::ranges::move(environment(folder.path(), window_system), std::back_inserter(arguments));
    for (const char* word : {"apitrace", "trace"}) arguments.emplace_back(word);
    arguments.emplace_back(window_system == WindowSystem::kEgl ? "--api=egl" : "--api=gl");
    arguments.push_back("--output=" + whole);
    arguments.insert(arguments.end(), options.command.begin(), options.command.end());
    const Descriptor messages = nameless_file();
    const auto start_time = steady_clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(steady_clock::now() - start_time).count(); };
    const pid_t process = start({arguments, -1, messages.get(), messages.get(), ".", true});
    if (process <= 0) throw SceneError(std::string("env: ") + tr(std::strerror(errno)));

    Recorded recorded{.output = "", .has_own_display = own.has_value(), .window_system = window_system};
    TraceFollower trace(whole);
    int last = options.frames;  // the frame to end after
    std::optional<int> status;
    double end = 0;
    {
        Running running(process);
        std::optional<Running> sending;
        if (!options.keys.empty()) sending.emplace(start({sender, -1, -1, -1, ".", true}));
        const bool ended_itself = running.wait([&] {
            constexpr int kMostChunks = 16;
            trace.read_on(kMostChunks);
            if (sending && sending->wait([] { return true; })) {
                sending.reset();
                last += trace.frames();
            }
            const bool has_frames =
                !sending && trace.has_drawn() && trace.frames() >= std::max(last, trace.first_drawn() + 1);
            return has_frames || seconds() >= options.seconds || options.stop_early();
        });
        end = seconds();
        if (ended_itself)
            status = running.status();
        else
            running.end();
    }
    const Printed words = printed(written_to(messages));
    recorded.output = words.output;
    if (status) {
        recorded.ended = ending(*status, end, words.stack);
        recorded.has_failed = *status != 0;
    }
    trace.read_on();
    recorded.not_cut = trace.failure();
    recorded.has_drawn = trace.has_drawn() || !trace.failure().empty();
    std::error_code error;
    recorded.has_calls = fs::exists(whole, error) && fs::file_size(whole, error) > 0;
    if (recorded.has_calls) trace.copy_frames(std::max(last, trace.first_drawn() + 1), options.trace);
    return recorded;
}

namespace {

// What every program calls before it draws.
bool sets_up(std::string_view name) {
    static constexpr std::array<std::string_view, 11> kStarts = {"glClear", "glMatrixMode", "glLoad",  "glMult",
                                                                 "glOrtho", "glFrustum",    "glTrans", "glRotate",
                                                                 "glScale", "glLight",      "glColor"};
    return name == "glEnable" ||
           std::ranges::any_of(kStarts, [&](std::string_view start) { return name.starts_with(start); });
}

}  // namespace

std::optional<BusiestFrame> busiest_frame(const std::string& trace) {
    const std::shared_ptr<const Recording> recording = open_trace(trace, std::nullopt, Blobs::kAreLeftOut);
    FunctionTable functions;
    ContextCounts counts;
    std::vector<double> vertices{0};  // of each frame
    double before = 0;
    bool has_setup = false;
    recording->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kFrameEnd) vertices.push_back(0);
        if (step.kind != Step::Kind::kCommand) return true;
        has_setup = has_setup || sets_up(step.command.name());
        counts.count(0, functions.find(step.command.name()), step.command.name(), step.command.arguments);
        vertices.back() += counts.all() - std::exchange(before, counts.all());
        return true;
    });
    const bool has_swaps = vertices.size() > 1;
    if (has_swaps && vertices.back() == 0) vertices.pop_back();
    const double most = *std::ranges::max_element(vertices);
    if (most == 0) return std::nullopt;
    const auto first = std::ranges::find_if(vertices, [&](double count) { return 10 * count >= 9 * most; });
    return BusiestFrame{.number = static_cast<int>(first - vertices.begin()),
                        .frames = static_cast<int>(vertices.size()),
                        .has_setup = has_setup,
                        .has_swaps = has_swaps,
                        .notes = recording->notes()};
}

}  // namespace trace
}  // namespace twinlight
