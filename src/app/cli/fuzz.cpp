// twinlight fuzz: compares random scenes across the three renderers, or with the oracle.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "app/cli/command_line.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "judge/fuzz/against_oracle.h"
#include "judge/fuzz/fuzzer.h"
#include "judge/report/words.h"
#include "render/context/context.h"
#include "scene/command/names.h"
#include "scene/command/text.h"

namespace twinlight::cli {

namespace {

using fuzz::Options;
using fuzz::Summary;

constexpr const char* kOracle = "oracle";
const std::map<std::string, const char*> kJudges = {
    {kOracle, "equations in 60 digits judge the shaders and the reference"},
    {"renderers", "the three renderers are compared with each other"},
};

struct FuzzArguments {
    Options options;
    std::string against = "renderers";
    std::string folder = "fuzz-failures";
    bool json = false;
    std::uint64_t baked_every = fuzz::OracleOptions{}.baked_every;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string minutes(double seconds) {
    const auto whole = static_cast<long>(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string file_of(const FuzzArguments& arguments, std::uint64_t state) {
    const std::string name = fmt::format("seed-{}-state-{}.gl", arguments.options.seed, state);
    return (std::filesystem::path(arguments.folder) / name).string();
}

// Written as soon as it is found, because a long run may be killed.
void write_failure(const FuzzArguments& arguments, std::uint64_t state, const std::string& scene) {
    write_files_atomically({{file_of(arguments, state), scene}}, {}, MissingFolders::kMade);
}

std::string grouped(long n) { return report::grouped(static_cast<std::size_t>(n)); }

void append_left_out(std::string& text, const char* what, const fuzz::LeftOutCounts& counts) {
    for (const auto& [departure, count] : counts) {
        text += fmt::format("  {:>11}  {:>11}  {}: {}\n", grouped(count.cases), grouped(count.differing), what,
                            departure->name);
    }
}

std::string summary_text(const FuzzArguments& arguments, const Summary& summary, double seconds) {
    const std::uint64_t states = summary.float_states + summary.picture_states;
    std::string text = fmt::format(
        "{} random scenes, seed {}{}, {} min ({:.0f} per second): {} compared by vertex colours in floats, "
        "{} by pictures\n",
        report::grouped(states), arguments.options.seed, summary.broken_off ? " (stopped early)" : "", minutes(seconds),
        static_cast<double>(states) / std::max(seconds, 1e-9), report::grouped(summary.float_states),
        report::grouped(summary.picture_states));
    text += fmt::format("\n{:<26}  {:>11}  {:>8}  {:>9}  {:>13}  {:>9}  {:>5}  {:>9}\n", "pair", "vertices", "worst",
                        "in scene", "pixels", "differing", "worst", "in scene");
    for (std::size_t pair = 0; pair < fuzz::kPairs; ++pair) {
        text += fmt::format("{:<26}  {:>11}  {:>8.1e}  {:>9}  {:>13}  {:>9}  {:>5}  {:>9}\n", fuzz::kPairNames.at(pair),
                            grouped(summary.vertices.at(pair)), summary.worst_float.at(pair).value,
                            summary.worst_float.at(pair).state, grouped(summary.pixels.at(pair)),
                            grouped(summary.differing_pixels.at(pair)), summary.worst_picture.at(pair).value,
                            summary.worst_picture.at(pair).state);
    }
    text +=
        "Vertices: the worst difference is relative to the sum of the magnitudes of a colour's terms.\n"
        "Pixels: all that can be checked. They count as differing, and the worst is given in 1/255, where the "
        "difference is "
        "larger\nthan filters and blending allow; at edges, where a pixel has none of the colours that may be there.\n";
    if (!summary.vertices_left_out.empty() || !summary.pictures_left_out.empty()) {
        text += "\nSkipped for known bugs, or because rounding decides; and how many of them differ:\n";
        append_left_out(text, "vertices", summary.vertices_left_out);
        append_left_out(text, "pictures", summary.pictures_left_out);
    }
    text += "\n";
    for (const fuzz::Failure& failure : summary.failures) {
        text += fmt::format("scene {}: {}: {}\n  reduced to {} of {} commands: {}\n", failure.state,
                            failure.pair < fuzz::kPairs ? fuzz::kPairNames.at(failure.pair) : "rejected", failure.what,
                            failure.scene.commands.size(), failure.commands_before,
                            one_line(file_of(arguments, failure.state)));
    }
    if (summary.failures.empty())
        text += summary.fails() ? "Too many pixels differ by 1/255.\n" : "No unexplained difference.\n";
    return text;
}

Json left_out_json(const fuzz::LeftOutCounts& counts) {
    auto list = Json::array();
    for (const auto& [departure, count] : counts)
        list.push_back({{"name", departure->name}, {"cases", count.cases}, {"differing", count.differing}});
    return list;
}

std::string summary_json(const FuzzArguments& arguments, const Summary& summary, double seconds) {
    Json json = {{"driver", summary.driver},
                 {"library", gl_library()},
                 {"seed", arguments.options.seed},
                 {"first", arguments.options.first},
                 {"count", arguments.options.count},
                 {"float_states", summary.float_states},
                 {"picture_states", summary.picture_states},
                 {"seconds", seconds}};
    auto& pairs = json["pairs"] = Json::array();
    for (std::size_t pair = 0; pair < fuzz::kPairs; ++pair) {
        pairs.push_back({{"name", fuzz::kPairNames.at(pair)},
                         {"vertices", summary.vertices.at(pair)},
                         {"worst_relative", summary.worst_float.at(pair).value},
                         {"pixels", summary.pixels.at(pair)},
                         {"differing_pixels", summary.differing_pixels.at(pair)},
                         {"worst_codes", summary.worst_picture.at(pair).value}});
    }
    json["left_out"] = {{"vertices", left_out_json(summary.vertices_left_out)},
                        {"pictures", left_out_json(summary.pictures_left_out)}};
    auto& failures = json["failures"] = Json::array();
    for (const fuzz::Failure& failure : summary.failures) {
        failures.push_back({{"state", failure.state},
                            {"pair", failure.pair < fuzz::kPairs ? fuzz::kPairNames.at(failure.pair) : "refused"},
                            {"what", failure.what},
                            {"file", file_of(arguments, failure.state)}});
    }
    // File names may hold any bytes.
    return dumped_lines(json);
}

// Shows what a run has done so far: its progress function, for either kind of run.
template <class AnySummary>
auto shown_on(ProgressBar& bar, const FuzzArguments& arguments, std::chrono::steady_clock::time_point start) {
    return [&bar, &arguments, start](std::uint64_t done, const AnySummary& so_far, const char* doing) {
        const double seconds = seconds_since(start), rate = static_cast<double>(done) / std::max(seconds, 1e-9);
        const double left = static_cast<double>(arguments.options.count - done) / std::max(rate, 1e-9);
        std::string line = doing ? std::string(doing) : fmt::format("{:.0f}/s, {} left", rate, minutes(left));
        if (!so_far.failures.empty()) line += fmt::format(", {} found", so_far.failures.size());
        bar.show(static_cast<int>(done), static_cast<int>(arguments.options.count), line);
    };
}

// ---- Against the oracle ----

// The range of condition numbers, and the power of ten that half of them reach.
std::string in_words(const std::map<int, long>& conditions) {
    if (conditions.empty()) return "";
    long all = 0, below = 0;
    for (const auto& [power, count] : conditions) all += count;
    auto middle = conditions.begin();
    while (2 * (below += middle->second) < all) ++middle;
    return fmt::format("condition numbers 1e{} to 1e{}, half from 1e{}", conditions.begin()->first,
                       conditions.rbegin()->first + 1, middle->first);
}

std::string summary_text(const FuzzArguments& arguments, const fuzz::OracleSummary& summary, double seconds) {
    std::string text = fmt::format(
        "{} random scenes at the limits of floats, seed {}{}, {} min ({:.0f} per second), checked in 60 digits; "
        "{} are not in view\n\n",
        report::grouped(summary.states), arguments.options.seed, summary.broken_off ? " (stopped early)" : "",
        minutes(seconds), static_cast<double>(summary.states) / std::max(seconds, 1e-9),
        report::grouped(summary.out_of_view));
    text += fmt::format("{:<28}  {:>9}  {:>9}  {:>7}\n", "who", "colours", "right", "worst");
    std::map<std::string, std::map<std::string, long>> reasons;  // by reason, then by who
    for (const auto& [who, counts] : summary.counts) {
        const auto right = counts.verdicts.find(fuzz::kRight);
        text += fmt::format("{:<28}  {:>9}  {:>9}  {:>7.1e}\n", who, grouped(counts.compared()),
                            grouped(right == counts.verdicts.end() ? 0 : right->second), counts.worst_right);
        for (const auto& [verdict, count] : counts.verdicts)
            if (verdict != fuzz::kRight) reasons[verdict][who] = count;
    }
    text +=
        "Right: within 1e-12 of the oracle for doubles, and 3e-5 for floats and shaders, relative to the larger of 1 "
        "and the sum\nof the terms' magnitudes. The worst difference is that of a right colour.\n";
    if (!reasons.empty()) text += "\nThe others, by reason:\n";
    for (const auto& [reason, by_who] : reasons) {
        text += fmt::format("  {}\n", reason);
        for (const auto& [who, count] : by_who) {
            text += fmt::format("    {:<26}  {:>9}", who, grouped(count));
            if (reason == fuzz::kIllConditioned) text += "  " + in_words(summary.counts.at(who).conditions);
            text += "\n";
        }
    }
    text += "\n";
    for (const fuzz::OracleFailure& failure : summary.failures)
        text += fmt::format("scene {}: {}\n  reduced to {} of {} commands: {}\n", failure.state, failure.what,
                            failure.scene.commands.size(), failure.commands_before,
                            one_line(file_of(arguments, failure.state)));
    if (summary.failures.empty()) text += "No unexplained difference.\n";
    return text;
}

std::string summary_json(const FuzzArguments& arguments, const fuzz::OracleSummary& summary, double seconds) {
    Json json = {{"driver", summary.driver},
                 {"library", gl_library()},
                 {"against", kOracle},
                 {"seed", arguments.options.seed},
                 {"first", arguments.options.first},
                 {"count", arguments.options.count},
                 {"states", summary.states},
                 {"out_of_view", summary.out_of_view},
                 {"seconds", seconds}};
    auto& results = json["results"] = Json::array();
    for (const auto& [who, counts] : summary.counts) {
        Json verdicts = Json::object();
        for (const auto& [verdict, count] : counts.verdicts) verdicts[verdict] = count;
        Json conditions = Json::object();
        for (const auto& [power, count] : counts.conditions) conditions[fmt::format("1e{}", power)] = count;
        results.push_back({{"name", who},
                           {"compared", counts.compared()},
                           {"worst_right", counts.worst_right},
                           {"verdicts", std::move(verdicts)},
                           {"conditions", std::move(conditions)}});
    }
    auto& failures = json["failures"] = Json::array();
    for (const fuzz::OracleFailure& failure : summary.failures)
        failures.push_back({{"state", failure.state},
                            {"name", failure.who},
                            {"what", failure.what},
                            {"file", file_of(arguments, failure.state)}});
    return dumped_lines(json);
}

int run_against_oracle(const FuzzArguments& arguments) {
    const Interrupt interrupt;
    const auto start = std::chrono::steady_clock::now();
    fuzz::OracleSummary summary;
    {
        ProgressBar bar;
        fuzz::OracleProgress progress;
        progress.stop = [] { return Interrupt::came(); };
        progress.found = [&](const fuzz::OracleFailure& failure) {
            write_failure(arguments, failure.state, fuzz::failure_text(failure, arguments.options.seed));
        };
        progress.show = shown_on<fuzz::OracleSummary>(bar, arguments, start);
        summary = fuzz::run_against_oracle(
            {static_cast<const fuzz::RunOptions&>(arguments.options), arguments.baked_every}, progress);
    }
    const double seconds = seconds_since(start);
    write_result(arguments.json ? summary_json(arguments, summary, seconds)
                                : summary.driver + "\n" + summary_text(arguments, summary, seconds));
    return summary.failures.empty() ? kFine : kDifferent;
}

int run_fuzz(const FuzzArguments& arguments) {
    try_folder(arguments.folder);  // most runs find nothing, so it is not made yet
    name_gl();
    if (arguments.against == kOracle) return run_against_oracle(arguments);
    const Interrupt interrupt;
    const auto start = std::chrono::steady_clock::now();
    Summary summary;
    {
        ProgressBar bar;
        fuzz::Progress progress;
        progress.stop = [] { return Interrupt::came(); };
        progress.found = [&](const fuzz::Failure& failure) {
            write_failure(arguments, failure.state, fuzz::failure_text(failure, arguments.options));
        };
        progress.show = shown_on<Summary>(bar, arguments, start);
        summary = fuzz::run(arguments.options, progress);
    }
    const double seconds = seconds_since(start);
    write_result(arguments.json ? summary_json(arguments, summary, seconds)
                                : summary.driver + "\n" + summary_text(arguments, summary, seconds));
    return summary.fails() ? kDifferent : kFine;
}

// Empty if `text` is a name of departures(); else a message that suggests a similar name.
std::string checked_departure(const std::string& text) {
    std::vector<std::string_view> names;
    for (const compare::Departure& departure : compare::departures()) names.push_back(departure.name);
    if (std::ranges::find(names, text) != names.end()) return "";
    const auto near = nearest(text, names);
    return fmt::format("there is no known bug '{}'; {}", text,
                       near ? fmt::format("did you mean '{}'?", *near) : "golden/known_differences lists them");
}

}  // namespace

Subcommand add_fuzz(CLI::App& app) {
    const auto arguments = std::make_shared<FuzzArguments>();
    Options& options = arguments->options;
    CLI::App* fuzz = app.add_subcommand("fuzz", "Compare random scenes across the three renderers, or with an oracle");
    const auto most = static_cast<std::uint64_t>(1) << 31;
    add_gl_option(*fuzz);
    fuzz->add_option("--count", options.count, "number of random scenes")
        ->type_name("N")
        ->capture_default_str()
        ->check(number_from(std::uint64_t{1}, most - 1));
    fuzz->add_option("--seed", options.seed, "random seed; a seed gives the same scenes on every machine")
        ->type_name("S")
        ->check(number_from(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    fuzz->add_option("--first", options.first,
                     "number of the first scene, to repeat a failure or to continue an earlier run")
        ->type_name("N")
        ->capture_default_str()
        ->check(number_from(std::uint64_t{0}, most << 20));
    fuzz->add_option(
            "--most-failures", options.most_failures,
            fmt::format("stop after this many failures; only the first {} are reduced", fuzz::RunOptions::kMostShrunk))
        ->type_name("N")
        ->capture_default_str()
        ->check(number_from(std::size_t{1}, static_cast<std::size_t>(most)));
    fuzz->add_option("--against", arguments->against,
                     "compare the renderers with each other ('renderers'), or the shaders and the reference with "
                     "equations in 60 digits ('oracle')")
        ->type_name("JUDGE")
        ->capture_default_str()
        ->check(one_of(kJudges));
    CLI::Option* baked_every =
        fuzz->add_option("--baked-every", arguments->baked_every,
                         "with --against oracle: try shaders with constants in one of N scenes; each compiles its own")
            ->type_name("N")
            ->capture_default_str()
            ->check(number_from(std::uint64_t{1}, most));
    CLI::Option* floats_only = fuzz->add_flag_callback(
        "--float-only", [&options] { options.pictures = false; }, "compare only vertex colours, in floats");
    CLI::Option* pictures_only = fuzz->add_flag_callback(
        "--pictures-only", [&options] { options.floats = false; }, "compare only pictures");
    pictures_only->excludes(floats_only);
    CLI::Option* lift =
        fuzz->add_option("--lift", options.lifted,
                         "do not skip this known bug, but look for it (golden/known_differences lists the names)")
            ->type_name("NAME")
            ->check(CLI::Validator(checked_departure, ""));
    fuzz->add_option("-o", arguments->folder, "folder for failing scenes; created if there are any")
        ->type_name("DIR")
        ->capture_default_str()
        ->check(not_empty());
    fuzz->add_flag("--json", arguments->json, "print one JSON object instead of the table");
    fuzz->footer(
        "Each failure is reduced to the smallest scene that still fails, and saved as a scene file.\n"
        "Ctrl-C stops the run and keeps all failures. GALLIUM_DRIVER=softpipe tests Mesa's other software driver.\n"
        "Exit status: 0 no unexplained difference, 1 an unexplained difference, 2 bad input or usage.");
    return {fuzz, [=] {
                for (const CLI::Option* option : {floats_only, pictures_only, lift})
                    if (arguments->against == kOracle && option->count() > 0)
                        throw UsageError(option->get_name() + " does not go with --against oracle");
                if (arguments->against != kOracle && baked_every->count() > 0)
                    throw UsageError("--baked-every goes only with --against oracle");
                return run_fuzz(*arguments);
            }};
}

}  // namespace twinlight::cli
