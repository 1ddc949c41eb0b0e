// make bench: the parts whose names the regular expression of the command line finds; build/bench.json has the ratios.
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <regex>
#include <string>

#include "base/image/file.h"
#include "ratios.h"

int main(int argc, char** argv) try {
    using namespace twinlight;
    // llvmpipe on this thread alone, and compiling anew what it has compiled in other runs; before any context is made.
    ::setenv("LP_NUM_THREADS", "0", 1);
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);

    const std::string chosen = argc > 1 ? argv[1] : ".";
    bench::Results results;
    int run = 0;
    for (const auto& [name, part] : bench::parts()) {
        if (!std::regex_search(name, std::regex(chosen))) continue;
        part(results);
        ++run;
    }
    if (run == 0) {
        std::string names;
        for (const auto& [name, part] : bench::parts()) names += " " + name;
        fmt::print(stderr, "twinlight-bench: '{}' finds none of these parts:{}\n", chosen, names);
        return 2;
    }
    results.print_ratios();
    const char* build = std::getenv("TWINLIGHT_BUILD");
    const std::string file = std::string(build ? build : "build") + "/bench.json";
    write_file_atomically(file, results.json());
    fmt::print("wrote {}\n", file);
    return 0;
} catch (const std::exception& failure) {
    fmt::print(stderr, "twinlight-bench: {}\n", failure.what());
    return 2;
}
