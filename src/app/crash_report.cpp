#include "app/crash_report.h"

#include <dlfcn.h>
#include <execinfo.h>
#include <link.h>
#include <sys/mman.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <string>

namespace twinlight {

namespace {

// Everything here is called from a signal handler, so it takes no memory and no locks.
std::string crashed_program;  // written before

struct CrashSignal {
    int number;
    std::string_view name;
};
constexpr std::array<CrashSignal, 5> kCrashSignals = {
    {{SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"}, {SIGFPE, "SIGFPE"}, {SIGILL, "SIGILL"}, {SIGABRT, "SIGABRT"}}};

// One line, written piece by piece.
void say(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}
void say_number(long number) {
    std::array<char, 24> digits;
    auto at = digits.end();
    do {
        *--at = static_cast<char>('0' + number % 10);
        number /= 10;
    } while (number > 0);
    say({at, static_cast<std::size_t>(digits.end() - at)});
}

// ---- Whose code ----

enum class CodeOwner { kProgram, kRuntime, kDriver, kLibrary, kNoFile };

struct Code {
    CodeOwner owner = CodeOwner::kNoFile;
    std::string_view file;  // without folders
};

CodeOwner code_owner(std::string_view file) {
    const auto starts = [&](std::initializer_list<std::string_view> names) {
        return std::ranges::any_of(names, [&](std::string_view name) { return file.starts_with(name); });
    };
    if (starts({"libc.so", "libstdc++.", "libgcc_s.", "libm.so", "libpthread.", "ld-linux", "ld64.", "linux-vdso"}))
        return CodeOwner::kRuntime;
    if (starts({"libGLU.", "libGLEW."})) return CodeOwner::kLibrary;
    if (starts({"libOSMesa", "libGL", "libEGL", "libOpenGL", "libgallium", "libglapi", "libLLVM", "libnvidia"}) ||
        file.ends_with("_dri.so"))
        return CodeOwner::kDriver;
    return CodeOwner::kLibrary;
}

Code code_at(void* address) {
    dl_find_object found{};
    if (::_dl_find_object(address, &found) != 0 || !found.dlfo_link_map) return {};
    std::string_view path = found.dlfo_link_map->l_name;
    if (path.empty()) return {CodeOwner::kProgram, {}};
    path.remove_prefix(path.rfind('/') + 1);
    return {code_owner(path), path};
}

// Where the processor was.
void* place_of(const void* context) {
    [[maybe_unused]] const auto& machine = static_cast<const ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
    return reinterpret_cast<void*>(machine.gregs[REG_RIP]);  // NOLINT(performance-no-int-to-ptr)
#elif defined(__aarch64__)
    return reinterpret_cast<void*>(machine.pc);  // NOLINT(performance-no-int-to-ptr)
#else
    return nullptr;
#endif
}

// The innermost code that is not of the C and C++ libraries, and whether the driver or this program had called it last.
struct Crash {
    Code innermost;
    CodeOwner caller = CodeOwner::kNoFile;  // kDriver, kProgram, or kNoFile if the stack does not show it
};

// `is_jump`: the processor was where no code is.
Crash crash_in(const std::array<void*, 64>& stack, int depth, void* place, bool is_jump) {
    Crash crash;
    const auto end = stack.begin() + depth;
    auto at = std::find(stack.begin(), end, place);
    if (at == end) at = stack.begin() + std::min(depth, 2);  // after the handler and the kernel's return from it
    bool found = false;
    for (; at != end; ++at) {
        // A return address may be the first byte after its call.
        const Code code = code_at(*at == place ? place : static_cast<char*>(*at) - 1);
        if (code.owner == CodeOwner::kRuntime) continue;
        if (!found) crash.innermost = code;
        found = true;
        if (code.owner != CodeOwner::kDriver && code.owner != CodeOwner::kProgram) continue;
        crash.caller = code.owner;
        break;
    }
    // Only drivers generate code, and the stack cannot be followed out of it.
    if (found && !is_jump && crash.innermost.owner == CodeOwner::kNoFile && crash.caller == CodeOwner::kNoFile)
        crash.caller = CodeOwner::kDriver;
    return crash;
}

// ---- The line ----

// Whether the process could not get a little more memory either.
bool out_of_memory() {
    constexpr std::size_t kLittle = std::size_t{16} << 20;
    void* more = ::mmap(nullptr, kLittle, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (more == MAP_FAILED) return true;
    ::munmap(more, kLittle);
    return false;
}

void report_crash(int signal, siginfo_t* about, void* context) {
    std::array<void*, 64> stack{};
    const auto* known = std::ranges::find(kCrashSignals, signal, &CrashSignal::number);
    say(crashed_program);
    if (about->si_code <= 0 && about->si_pid != ::getpid()) {  // of kill(), not of the processor or abort()
        say(": process ");
        say_number(about->si_pid);
        say(" ended this program with ");
        say(known->name);
    } else if (out_of_memory()) {
        say(": out of memory (");
        say(known->name);
        say("); try a smaller --size");
    } else {
        say(": crashed (");
        say(known->name);
        say(")");
        const int depth = ::backtrace(stack.data(), static_cast<int>(stack.size()));
        void* place = place_of(context);
        const Crash crash = crash_in(stack, depth, place, signal == SIGSEGV && about->si_addr == place);
        if (!crash.innermost.file.empty()) {
            say(" in ");
            say(crash.innermost.file);
        }
        switch (crash.caller) {
            case CodeOwner::kDriver:
                say(crash.innermost.owner == CodeOwner::kNoFile ? " in code that the GL driver generated"
                                                                : ", during a call of the GL driver");
                say("; the environment variable GALLIUM_DRIVER, set to llvmpipe or softpipe, chooses another driver. "
                    "If that crashes too, please report the scene.");
                break;
            case CodeOwner::kProgram:
                say(crash.innermost.owner == CodeOwner::kProgram ? " in its own code" : ", which it called");
                say("; please report the command and the scene.");
                break;
            default: say("; please report the command and the scene.");
        }
    }
    say("\n");
    std::raise(signal);
}

// The handler needs a stack of its own where the program's is used up.
alignas(16) std::array<char, 1 << 16> stack_of_handler;

}  // namespace

void report_crashes(std::string_view program) {
    crashed_program = program;
    std::array<void*, 1> loaded{};
    ::backtrace(loaded.data(), 1);  // the first call loads a library
    const stack_t stack = {.ss_sp = stack_of_handler.data(), .ss_flags = 0, .ss_size = stack_of_handler.size()};
    ::sigaltstack(&stack, nullptr);
    for (const auto& [signal, name] : kCrashSignals) {
        struct sigaction before {
        }, action{};
        if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;  // a sanitizer's
        action.sa_sigaction = report_crash;
        action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_SIGINFO | SA_ONSTACK;
        ::sigaction(signal, &action, nullptr);
    }
}

}  // namespace twinlight
