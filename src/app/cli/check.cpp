// twinlight check: tests this machine's driver with the hard cases of golden/hard.
#include <fmt/format.h>

#include <cmath>

#include "app/cli/check_page.h"
#include "app/cli/command_line.h"
#include "base/image/file.h"
#include "base/image/named_file.h"
#include "base/text/json.h"
#include "judge/check/suite.h"
#include "judge/compare/releases.h"
#include "judge/conformance/case_programs.h"
#include "judge/conformance/case_report.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"

namespace twinlight::cli {

namespace {

using namespace check;

struct CheckArguments {
    std::vector<std::string> names;
    std::string programs, reports, page;  // folders; empty: not wanted
    bool json = false;
};

std::string colored(const std::string& text, Outcome outcome) {
    if (!result_in_color()) return text;
    switch (outcome) {
        case Outcome::kNotTested: return text;
        case Outcome::kPass:
        case Outcome::kOurChoice: return "\x1b[32m" + text + "\x1b[0m";
        case Outcome::kKnownBug: return "\x1b[33m" + text + "\x1b[0m";
        case Outcome::kNewBug:
        case Outcome::kFixedBug: return "\x1b[1;31m" + text + "\x1b[0m";
    }
    return text;
}

struct Counts {
    std::array<long, kOutcomes> fixed{};
    long failing = 0, non_finite = 0;
    double from_long_double = 0;
};

Counts counted(const std::vector<Result>& results) {
    Counts counts;
    for (const Result& result : results) {
        ++counts.fixed.at(static_cast<std::size_t>(result.outcomes[0]));
        counts.failing += result.fails();
        counts.non_finite += result.non_finite;
        counts.from_long_double = std::max(counts.from_long_double, result.from_long_double);
    }
    return counts;
}

std::string table(const std::vector<Case>& cases, const std::vector<Result>& results) {
    std::size_t width = 4;
    for (const Case& of : cases) width = std::max(width, of.name.size());
    std::string text = fmt::format("{:<{}}  {:<10}  {:<12}  {}\n", "case", width, "fixed", "shaders", "reference");
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto word = [&](Path path, int columns) {
            const Outcome outcome = results[i].outcomes.at(static_cast<std::size_t>(path));
            return colored(fmt::format("{:<{}}", word_of(outcome), columns), outcome);
        };
        text += fmt::format("{:<{}}  {}  {}  {}\n", cases[i].name, width, word(Path::kFixed, 10),
                            word(Path::kProgrammable, 12), word(Path::kReference, 9));
        for (const Finding& finding : results[i].findings) text += "    " + finding_text(cases[i], finding) + "\n";
        if (results[i].non_finite > 0)
            text +=
                fmt::format("    {} results of the shaders or the reference are not finite\n", results[i].non_finite);
        if (!results[i].error.empty()) text += "    rejected: " + results[i].error + "\n";
    }
    return text;
}

std::string summary(const std::string& driver, const std::vector<Result>& results) {
    const Counts counts = counted(results);
    const std::string unmeasured = compare::unmeasured_words(parse_driver_name(driver));
    const auto fixed = [&](Outcome outcome) { return counts.fixed.at(static_cast<std::size_t>(outcome)); };
    return fmt::format(
        "\n{}\n{} case{}. The driver's fixed function: {} pass, {} with a known bug, {} our choice (the specification "
        "is silent),\n{} with a new bug, {} with a fixed bug, {} not tested.\n"
        "The shaders are at most {:.1e} away from the reference in long double. Results that are not finite: {}.\n{}",
        counts.failing == 0 ? "Nothing unexpected."
                            : fmt::format("{} unexpected {}.", counts.failing, counts.failing == 1 ? "case" : "cases"),
        results.size(), results.size() == 1 ? "" : "s", fixed(Outcome::kPass), fixed(Outcome::kKnownBug),
        fixed(Outcome::kOurChoice), fixed(Outcome::kNewBug), fixed(Outcome::kFixedBug), fixed(Outcome::kNotTested),
        counts.from_long_double, counts.non_finite, unmeasured.empty() ? "" : unmeasured + "\n");
}

// A colour's numbers, or an error's name.
Json json_of(const std::optional<Seen>& seen) {
    if (!seen) return nullptr;
    if (std::holds_alternative<Enum>(*seen)) return text_of(seen);
    auto list = Json::array();
    const auto& color = std::get<glm::dvec4>(*seen);
    for (int i = 0; i < 4; ++i) {  // JSON has no NaN
        if (std::isfinite(color[i]))
            list.push_back(color[i]);
        else
            list.push_back(nullptr);
    }
    return list;
}

std::string json_of(const std::string& driver, const std::vector<Case>& cases, const std::vector<Result>& results) {
    Json json = {{"driver", driver}, {"library", gl_library()}};
    const std::string_view release = compare::counts_as(parse_driver_name(driver));
    if (!release.empty()) json["bugs_measured_on"] = release;
    auto& list = json["cases"] = Json::array();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        Json one = {{"name", cases[i].name},
                    {"what", cases[i].what},
                    {"text", cases[i].text},
                    {"status", cases[i].is_ruling ? "ruling" : "defined"}};
        for (std::size_t path = 0; path < kPaths; ++path)
            one[std::string(kPathNames.at(path))] = word_of(results[i].outcomes.at(path));
        one["non_finite"] = results[i].non_finite;
        one["from_long_double"] = results[i].from_long_double;
        if (!results[i].error.empty()) one["refused"] = results[i].error;
        auto& findings = one["findings"] = Json::array();
        for (const Finding& finding : results[i].findings) {
            findings.push_back({{"path", kPathNames.at(static_cast<std::size_t>(finding.path))},
                                {"variant", finding.variant},
                                {"verdict", word_of(finding.outcome)},
                                {"at", finding.spot.str()},
                                {"value", json_of(finding.value)},
                                {"expected", json_of(finding.expected)},
                                {"departure", finding.name}});
        }
        list.push_back(one);
    }
    const Counts counts = counted(results);
    json["failing"] = counts.failing;
    json["non_finite"] = counts.non_finite;
    return dumped_lines(json);
}

void write_page(const std::string& folder, Suite& suite, const std::vector<Case>& cases, std::vector<Result>& results) {
    for (std::size_t i = 0; i < cases.size(); ++i) suite.draw_vertices(cases[i], results[i]);
    write_folder_atomically(folder, {{"index.html", check_page(suite.driver(), cases, results)}});
}

// NAME.md for each bug of the driver, by the name of its shortest case. All files, or none if the disk is full.
void write_reports(const std::string& folder, const std::string& driver, const std::vector<Case>& cases,
                   const std::vector<Result>& results) {
    write_folder_atomically(folder, conformance::case_reports(driver, cases, results));
    make_folder(folder);  // also if there is nothing to report
}

// The cases as C programs: all files, or none if the disk is full. Nothing is drawn.
int write_programs(const std::string& folder, const std::vector<Case>& cases) {
    const conformance::CasePrograms programs = conformance::case_programs(cases);
    write_folder_atomically(folder, programs.files);
    const bool is_one = programs.written.size() == 1;
    std::string text = fmt::format("{} case{} in {}: run {} with `make report` there (README.md).\n",
                                   programs.written.size(), is_one ? "" : "s", folder, is_one ? "it" : "them");
    if (!programs.left_out.empty())
        text += fmt::format("Not written, because GL's fixed function lacks what they need: {}.\n",
                            fmt::join(programs.left_out, ", "));
    write_result(text);
    return kFine;
}

int run_check(const CheckArguments& arguments) {
    const std::vector<Case> cases = load_cases(arguments.names);
    for (const std::string& folder :
         {arguments.programs, arguments.reports, arguments.page})  // before the work: a bad folder fails at once
        if (!folder.empty()) try_folder(folder);
    if (!arguments.programs.empty()) return write_programs(arguments.programs, cases);
    name_gl();
    Suite suite;
    std::vector<Result> results = suite.run(cases);
    if (!arguments.reports.empty()) write_reports(arguments.reports, suite.driver(), cases, results);
    if (!arguments.page.empty()) write_page(arguments.page, suite, cases, results);
    write_result(arguments.json ? json_of(suite.driver(), cases, results)
                                : suite.driver() + "\n\n" + table(cases, results) + summary(suite.driver(), results));
    return counted(results).failing == 0 ? kFine : kDifferent;
}

}  // namespace

Subcommand add_check(CLI::App& app) {
    const auto arguments = std::make_shared<CheckArguments>();
    CLI::App* check = app.add_subcommand("check", "Test this machine's driver with the hard cases of lighting");
    check
        ->add_option("CASE", arguments->names,
                     "names of built-in cases, or your own case files (default: all built-in cases)")
        ->type_name("");
    CLI::Option* programs =
        check
            ->add_option(
                "--write-cases", arguments->programs,
                "instead of testing, write the cases as C programs into this folder, with a Makefile that runs them on "
                "any GL; created if it does not exist")
            ->type_name("DIR")
            ->check(not_empty());
    check
        ->add_option("--write-reports", arguments->reports,
                     "for each bug that the cases find in the driver, write a report with a C program, NAME.md, into "
                     "this folder; created if it does not exist")
        ->type_name("DIR")
        ->check(not_empty())
        ->excludes(programs);
    check
        ->add_option("--html", arguments->page,
                     "write a page of all cases, index.html, into this folder; created if it does not exist")
        ->type_name("DIR")
        ->check(not_empty())
        ->excludes(programs);
    add_gl_option(*check);
    check->add_flag("--json", arguments->json, "print one JSON object instead of the table")->excludes(programs);
    check->footer(
        "Results of the driver's fixed function:\n"
        "  pass        the expected answer\n"
        "  our choice  another answer; the specification is silent, so the expected one is only our choice\n"
        "  known bug   a wrong answer that the case lists for this driver\n"
        "  new bug     a wrong answer that is not listed: unexpected\n"
        "  fixed bug   the expected answer, although a wrong one is listed: unexpected\n"
        "  not tested  GL has no such feature, or the driver may crash\n"
        "The shaders and the reference must pass. GALLIUM_DRIVER=softpipe tests Mesa's other software driver.\n"
        "Exit status: 0 nothing unexpected; 1 a new bug, a fixed bug, a scene that GL rejects, a result of the "
        "shaders\n"
        "or the reference that is not finite, or shaders more than 3e-5 away from the reference in long double;\n"
        "2 bad input or usage.");
    return {check, [arguments] { return run_check(*arguments); }};
}

}  // namespace twinlight::cli
