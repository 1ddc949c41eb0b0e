// make bench: what is compared runs interleaved in one run; the table has medians, build/bench.json the ratios.
//
// x_over_y says how many times faster x is than y: y's time divided by x's, for one item of work each. A benchmark is named
// as in the ratio. Times are of the wall clock, for some work is another process's.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "image/file.h"

namespace {

struct Ratio {
    std::string fast, slow;  // by the names of benchmarks
};

const std::vector<Ratio>& ratios() {
    static const std::vector<Ratio> table = {
        {"read_glxgears", "apitrace_dump_glxgears"},
        {"read_dump", "read_dump_into_state"},
    };
    return table;
}

// Keeps the median of items a second of each benchmark, and prints the usual table.
class Reporter final : public benchmark::ConsoleReporter {
  public:
    Reporter() : ConsoleReporter(::isatty(STDOUT_FILENO) != 0 ? OO_Defaults : OO_None) {}
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.error_occurred || run.aggregate_name != "median") continue;
            const auto items = run.counters.find("items_per_second");
            if (items != run.counters.end()) rates[run.run_name.function_name] = items->second;
        }
    }
    std::map<std::string, double> rates;
};

}  // namespace

int main(int argc, char** argv) {
    std::vector<char*> arguments(argv, argv + argc);
    std::string defaults[] = {"--benchmark_repetitions=7", "--benchmark_enable_random_interleaving=true",
                              "--benchmark_report_aggregates_only=true", "--benchmark_min_time=0.3"};
    for (std::string& text : defaults)
        arguments.insert(arguments.begin() + 1, text.data());  // what is typed comes later
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;

    Reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);

    nlohmann::ordered_json json = {{"ratios", nlohmann::json::object()}, {"items_per_second", reporter.rates}};
    for (const auto& [fast, slow] : ratios()) {
        if (!reporter.rates.contains(fast) || !reporter.rates.contains(slow)) continue;
        const double ratio = reporter.rates[fast] / reporter.rates[slow];
        const std::string name = fast + "_over_" + slow;
        json["ratios"][name] = ratio;
        fmt::print("{:<50} {:.2f}\n", name, ratio);
    }
    const char* build = std::getenv("TWINLIGHT_BUILD");
    const std::string file = std::string(build ? build : "build") + "/bench.json";
    twinlight::write_file_atomically(file, json.dump(2) + "\n");
    fmt::print("wrote {}\n", file);
}
