#include "ratios.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "app/cli/progress.h"
#include "base/text/json.h"

namespace twinlight::bench {

namespace {

double now(Clock clock) {
    if (clock == Clock::kWall) {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds_of(const Way& way, int runs, Clock clock) {
    const double begin = now(clock);
    for (int i = 0; i < runs; ++i) way.run();
    return (now(clock) - begin) / runs;
}

// At the place `share` of the sorted values.
double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5));
}

std::string duration_text(double seconds) {
    if (seconds < 1e-6) return fmt::format("{:.3g} ns", 1e9 * seconds);
    if (seconds < 1e-3) return fmt::format("{:.3g} us", 1e6 * seconds);
    return seconds < 1 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

bool is_reached(double value, const Bar& bar) { return bar.at_most ? value <= bar.value : value >= bar.value; }

std::map<std::string, Part>& all_parts() {
    static std::map<std::string, Part> table;
    return table;
}

}  // namespace

std::string build_folder() {
    const char* folder = std::getenv("TWINLIGHT_BUILD");
    return folder ? folder : "build";
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values.at(half) : (values.at(half - 1) + values.at(half)) / 2;
}

double geometric_mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / static_cast<double>(values.size()));
}

double Timed::median() const { return bench::median(seconds); }
double Timed::least() const { return std::ranges::min(seconds); }
double Timed::spread() const { return (quantile(seconds, 0.75) - quantile(seconds, 0.25)) / 2 / median(); }

double times_faster(const Timed& fast, const Timed& slow) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < fast.seconds.size(); ++i) ratios.push_back(slow.seconds.at(i) / fast.seconds[i]);
    return median(ratios);
}

std::vector<Timed> Results::compare(std::string_view title, const std::vector<Way>& ways, const Rounds& rounds) {
    const int count = is_quick_ ? 1 : rounds.count;
    cli::ProgressBar progress;
    progress.show(0, count, title);
    std::vector<Timed> timed;
    std::vector<int> runs;
    for (const Way& way : ways) {
        way.run();  // what is made once: programs, buffers
        const double once = is_quick_ ? rounds.least_seconds : seconds_of(way, 1, rounds.clock);
        runs.push_back(std::clamp(static_cast<int>(std::ceil(rounds.least_seconds / once)), 1, 1 << 20));
        timed.push_back({way.name, {}});
    }
    for (int round = 0; round < count; ++round) {
        progress.show(round, count, title);
        for (std::size_t i = 0; i < ways.size(); ++i)
            timed[i].seconds.push_back(seconds_of(ways[i], runs[i], rounds.clock) / ways[i].items);
    }
    progress.wipe();
    fmt::print("\n{}\n", title);
    for (const Timed& way : timed) {
        fmt::print("  {:<44} {:>9} +-{:4.1f} %", way.name, duration_text(way.median()), 100 * way.spread());
        if (&way != &timed.front()) fmt::print("  {:7.2f} x", times_faster(way, timed.front()));
        fmt::print("\n");
        seconds_[fmt::format("{}: {}", title, way.name)] = way.median();
    }
    std::fflush(stdout);
    return timed;
}

void Results::ratio(const std::string& name, double value, std::optional<Bar> bar) {
    ratios_.push_back({name, value, is_quick_ ? std::nullopt : bar});
}

void Results::remark(std::string_view text) { fmt::print("  {}\n", text); }

void Results::print_ratios() const {
    fmt::print("\n{:<52} {:>9}\n", "ratio", "");
    for (const auto& [name, value, bar] : ratios_) {
        fmt::print("{:<52} {:9.4g}", name, value);
        if (bar)
            fmt::print("  {} {:g}: {}", bar->at_most ? "at most" : "at least", bar->value,
                       is_reached(value, *bar) ? "reached" : "NOT reached");
        fmt::print("\n");
    }
}

std::string Results::json() const {
    nlohmann::ordered_json json = {{"where", where_}, {"ratios", nlohmann::json::object()}};
    for (const auto& [name, value, bar] : ratios_) json["ratios"][name] = value;
    json["seconds"] = seconds_;
    return json.dump(2) + "\n";
}

bool add_part(std::string name, Part run) { return all_parts().emplace(std::move(name), run).second; }
const std::map<std::string, Part>& parts() { return all_parts(); }

}  // namespace twinlight::bench
