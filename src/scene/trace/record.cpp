#include "scene/trace/record.h"

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
#include "base/image/file.h"
#include "base/text/input_text.h"
#include "scene/command/text.h"
#include "scene/trace/contexts.h"
#include "scene/trace/functions.h"
#include "scene/trace/process.h"
#include "scene/trace/temporary_folder.h"
#include "scene/trace/trace.h"

namespace twinlight::trace {

namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

constexpr auto kPause = std::chrono::milliseconds(20);

bool is_executable(const fs::path& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

// A program in PATH; "" if there is none.
std::string in_path(const std::string& name) {
    const char* path = std::getenv("PATH");
    InputText folders(path ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path file = fs::path(folder.empty() ? "." : folder) / name;
        if (is_executable(file)) return fs::absolute(file).string();
    }
    return "";
}

void need(const std::string& tool, std::string_view package, std::string_view why) {
    if (in_path(tool).empty()) {
        throw SceneError(tool + ": is not installed; " + std::string(why) + " needs it (apt-get install " +
                         std::string(package) + ")");
    }
}

// The end of what a process wrote to a file.
std::string contents(const Descriptor& file) {
    constexpr off_t kMost = 1 << 16;
    const off_t size = std::max<off_t>(::lseek(file.get(), 0, SEEK_END), 0);
    const off_t from = std::max<off_t>(size - kMost, 0);
    std::string text(static_cast<std::size_t>(size - from), '\0');
    const ssize_t count = ::pread(file.get(), text.data(), text.size(), from);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
}

std::string without_apitrace(const std::string& text) {
    InputText lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("apitrace: ")) kept += line + "\n";
    return kept;
}

std::string last_line(const std::string& text) {
    InputText lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) last = line;
    return last;
}

// An X server without a screen.
class OwnDisplay {
  public:
    OwnDisplay() {
        need("Xvfb", "xvfb", "running a program where DISPLAY is not set");
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw SceneError(std::string("Xvfb: ") + std::strerror(errno));
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
            throw SceneError("Xvfb: did not start; set DISPLAY to use a display that is already there");
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

// A process with a session of its own; ends with all its children.
class Running {
  public:
    explicit Running(pid_t process) : process_(process) {}
    ~Running() { stop(SIGKILL, {}); }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    // Waits until it ends or `done` is true. Returns whether it ended.
    bool wait(const std::function<bool()>& done) {
        while (!ended()) {
            if (done()) return false;
            std::this_thread::sleep_for(kPause);
        }
        return true;
    }
    // Sends a signal to the process and its children, and waits so long for its end.
    bool stop(int signal, std::chrono::milliseconds limit) {
        if (process_ <= 0) return true;
        ::kill(-process_, signal);
        const auto end = steady_clock::now() + limit;
        if (signal == SIGKILL) {
            wait_for(std::exchange(process_, 0));
            return true;
        }
        return wait([&] { return steady_clock::now() >= end; });
    }

  private:
    bool ended() {
        if (process_ <= 0) return true;
        const pid_t found = ::waitpid(process_, nullptr, WNOHANG);
        if (found == 0 || (found < 0 && errno == EINTR)) return false;
        ::kill(-process_, SIGKILL);  // children that are left
        process_ = 0;
        return true;
    }

    pid_t process_;
};

// Runs a tool to its end. Returns its last message if it fails, else "".
std::string run_tool(const std::vector<std::string>& arguments) {
    const Descriptor messages = nameless_file();
    const pid_t process = start({arguments, -1, messages.get(), messages.get(), "."});
    if (process <= 0) return std::strerror(errno);
    const int status = wait_for(process);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
    const std::string words = last_line(contents(messages));
    return words.empty() ? arguments[0] + " failed" : words;
}

}  // namespace

bool is_source(const std::string& file) {
    const std::string extension = fs::path(file).extension().string();
    return extension == ".c" || extension == ".cc" || extension == ".cpp" || extension == ".cxx";
}

void compile_source(const std::string& source, const std::string& program) {
    const bool is_c = fs::path(source).extension() == ".c";
    const std::string compiler = is_c ? "cc" : "c++";
    std::error_code ignored;
    if (!fs::is_regular_file(source, ignored)) throw SceneError(source + ": there is no such file");
    need(compiler, is_c ? "gcc" : "g++", "compiling a program");
    const pid_t process = start(
        {{compiler, source, "-o", program, "-lglut", "-lGLU", "-lGL", "-lm"}, -1, STDERR_FILENO, STDERR_FILENO, "."});
    if (process <= 0) throw SceneError(compiler + ": " + std::strerror(errno));
    const int status = wait_for(process);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw SceneError(source + ": " + compiler +
                         " cannot compile it, see above; freeglut and GLU are in the packages freeglut3-dev and "
                         "libglu1-mesa-dev");
    }
}

std::string find_program(const std::string& name) {
    std::error_code ignored;
    const std::string found = name.find('/') == std::string::npos && !fs::exists(name, ignored) ? in_path(name) : name;
    if (found.empty()) throw SceneError(name + ": there is no such program");
    if (!fs::exists(found, ignored)) throw SceneError(name + ": there is no such file");
    if (!is_executable(found)) throw SceneError(name + ": is not a program; give a program or a C file (.c)");
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

Recorded record(const RecordOptions& options) {
    need("apitrace", "apitrace", "recording");
    const WindowSystem window_system = options.window_system.value_or(window_system_of(options.command.front()));
    const TemporaryFolder folder;
    const std::string whole = folder.path() + "/whole.trace", kept = folder.path() + "/kept.trace";
    const char* display = std::getenv("DISPLAY");
    std::optional<OwnDisplay> own;
    if (!display || !*display) own.emplace();

    // Without WAYLAND_DISPLAY the program opens its window in the display.
    std::vector<std::string> arguments = {"env", "-u", "WAYLAND_DISPLAY"};
    if (own) arguments.push_back("DISPLAY=" + own->name());
    for (const char* word : {"apitrace", "trace"}) arguments.emplace_back(word);
    arguments.emplace_back(window_system == WindowSystem::kEgl ? "--api=egl" : "--api=gl");
    arguments.push_back("--output=" + whole);
    arguments.insert(arguments.end(), options.command.begin(), options.command.end());
    const Descriptor messages = nameless_file();
    const pid_t process = start({arguments, -1, messages.get(), messages.get(), ".", true});
    if (process <= 0) throw SceneError(std::string("env: ") + std::strerror(errno));

    Recorded recorded{.output = "", .has_own_display = own.has_value(), .window_system = window_system};
    {
        Running running(process);
        const auto end = steady_clock::now() + std::chrono::duration<double>(options.seconds);
        recorded.ended_itself = running.wait([&] { return steady_clock::now() >= end || options.stop_early(); });
        // On SIGINT apitrace writes its buffer. Some programs catch it and continue.
        if (!recorded.ended_itself) running.stop(SIGINT, std::chrono::seconds(3));
    }
    recorded.output = without_apitrace(contents(messages));
    std::error_code error;
    if (!fs::exists(whole, error) || fs::file_size(whole, error) == 0) {
        const std::string words = last_line(recorded.output);
        throw SceneError(options.command.front() + ": made no GL call that apitrace could record" +
                         (words.empty() ? "" : "; its last message: " + words) + "; --api " +
                         (window_system == WindowSystem::kEgl ? "glx" : "egl") + " records the other window system");
    }
    const std::string why =
        run_tool({"apitrace", "trim", "--frames=0-" + std::to_string(options.frames - 1), "-o", kept, whole});
    // A program that starts others may leave a trace whose end cannot be read.
    if (!why.empty()) recorded.not_trimmed = "apitrace trim: " + why;
    fs::copy_file(why.empty() ? kept : whole, options.trace, fs::copy_options::overwrite_existing, error);
    if (error) throw FileError(options.trace + ": " + error.message());
    return recorded;
}

std::optional<BusiestFrame> busiest_frame(const std::string& trace) {
    const std::shared_ptr<const Recording> recording = open_trace(trace);
    FunctionTable functions;
    ContextCounts counts;
    std::vector<double> vertices{0};  // of each frame
    double before = 0;
    recording->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kFrameEnd) vertices.push_back(0);
        if (step.kind != Step::Kind::kCommand) return true;
        counts.count(0, functions.find(step.command.name()), step.command.name(), step.command.arguments);
        vertices.back() += counts.all() - std::exchange(before, counts.all());
        return true;
    });
    const bool has_swaps = vertices.size() > 1;
    if (has_swaps && vertices.back() == 0) vertices.pop_back();
    const double most = *std::ranges::max_element(vertices);
    if (most == 0) return std::nullopt;
    const auto first = std::ranges::find_if(vertices, [&](double count) { return 10 * count >= 9 * most; });
    return BusiestFrame{static_cast<int>(first - vertices.begin()), static_cast<int>(vertices.size()), has_swaps,
                        recording->notes()};
}

}  // namespace twinlight::trace
