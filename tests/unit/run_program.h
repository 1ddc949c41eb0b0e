// Runs a built program, as a user's shell would, and gives back what it printed.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/image/file.h"

namespace twinlight {

// A folder of the test's own, gone with it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "twinlight-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string str() const { return path_.string(); }
    // The names of what it holds, sorted.
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(path_)) names.push_back(entry.path().filename());
        std::ranges::sort(names);
        return names;
    }

  private:
    std::filesystem::path path_;
};

// The folder of the binaries: make test says which.
inline std::string build_folder() {
    const char* folder = std::getenv("TWINLIGHT_BUILD");
    return folder != nullptr ? folder : "build";
}

struct ProgramResult {
    int status = -1;  // of the exit; 128 + the signal's number where one ended it
    std::string out, err;
    std::string
        gl;  // which GL drew, and its library: the first line of standard error, which `err` lacks; empty if nothing was drawn
};

// Moves the line about GL out of `err`.
inline void take_gl(ProgramResult& result) {
    if (!result.err.starts_with("twinlight: OpenGL is ")) return;
    const std::size_t length = result.err.find('\n') + 1;
    result.gl = result.err.substr(0, length);
    result.err.erase(0, length);
}

inline std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

// Runs a line of shell, in which $PROGRAM is the program; standard input is empty unless the line says otherwise.
inline ProgramResult run_shell(const std::string& program, const std::string& line) {
    const TemporaryFolder folder;
    const std::string command = "PROGRAM=" + quoted(build_folder() + "/" + program) + "; { " + line +
                                "\n} </dev/null 2>" + quoted(folder / "err");
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("no shell");
    ProgramResult result;
    std::array<char, 4096> block;
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe)) {
        result.out.append(block.data(), count);
    }
    const int status = ::pclose(pipe);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.err = read_file(folder / "err");
    take_gl(result);
    return result;
}

inline constexpr const char* kCannotTrace = "strace is not installed, or cannot trace";
inline bool can_trace() { return run_shell("", "strace -o /dev/null true").status == 0; }

inline ProgramResult run_program(const std::string& program, const std::vector<std::string>& arguments) {
    std::string line = "\"$PROGRAM\"";
    for (const std::string& argument : arguments) line += " " + quoted(argument);
    return run_shell(program, line);
}

}  // namespace twinlight
