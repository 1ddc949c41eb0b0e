#include <sys/utsname.h>

#include <fstream>
#include <string>
#include <thread>

#include "app/cli/study_samples.h"

namespace twinlight::cli {

namespace {

// The text after `separator` in the first line that starts with `name`; empty if there is none.
std::string value_in(const char* file, const std::string& name, char separator) {
    std::ifstream lines(file);
    lines.exceptions(std::ios::badbit);  // when memory is short
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(name)) continue;
        const std::size_t at = line.find(separator);
        if (at == std::string::npos) continue;
        const std::size_t begin = line.find_first_not_of(" \t\"", at + 1), end = line.find_last_not_of(" \t\"");
        return begin == std::string::npos ? "" : line.substr(begin, end + 1 - begin);
    }
    return {};
}

}  // namespace

study::Machine this_machine() {
    utsname kernel{};
    ::uname(&kernel);
    study::Machine machine;
    machine.processor = value_in("/proc/cpuinfo", "model name", ':');
    if (machine.processor.empty()) machine.processor = kernel.machine;
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    const std::string distribution = value_in("/etc/os-release", "PRETTY_NAME", '=');
    machine.system = (distribution.empty() ? "" : distribution + ", ") + kernel.sysname + " " + kernel.release;
    return machine;
}

}  // namespace twinlight::cli
