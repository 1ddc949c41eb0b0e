// make bench: twinlight-bench [--quick] [REGEX] measures the parts whose names REGEX finds. The ratios are also in build/bench.json,
// and those of a quick run, which say little, in build/bench-quick.json.
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <regex>
#include <string>
#include <vector>

#include "app/cli/study_samples.h"
#include "base/image/file.h"
#include "lighting/points.h"
#include "ratios.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"

namespace {

// "AMD EPYC, 2 cores, AVX-512, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile) Mesa 22.3.6"
std::string where_it_runs() {
    using namespace twinlight;
    const auto context = make_offscreen_context(1, 1);
    const study::Machine machine = cli::this_machine();
    return fmt::format("{}, {} cores, {}, {}", machine.processor, machine.cores,
                       lighting::instruction_sets().front().name, driver_name());
}

}  // namespace

int main(int argc, char** argv) try {
    using namespace twinlight;
    // llvmpipe on this thread alone, and compiling anew what it has compiled in other runs; before any context is made.
    ::setenv("LP_NUM_THREADS", "0", 1);
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    keep_freed_memory();  // as the programs do

    std::vector<std::string> arguments(argv + 1, argv + argc);
    const bool is_quick = !arguments.empty() && arguments.front() == "--quick";
    if (is_quick) arguments.erase(arguments.begin());
    const std::string chosen = arguments.empty() ? "." : arguments.front();
    bench::Results results(is_quick, where_it_runs());
    fmt::print("{}\n", results.where());
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
    const std::string file = bench::build_folder() + (is_quick ? "/bench-quick.json" : "/bench.json");
    write_file_atomically(file, results.json());
    fmt::print("wrote {}\n", file);
    return 0;
} catch (const std::exception& failure) {
    fmt::print(stderr, "twinlight-bench: {}\n", failure.what());
    return 2;
}
