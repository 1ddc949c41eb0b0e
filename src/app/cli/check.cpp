// twinlight check: the hard cases of golden/hard on this machine's driver.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/check_page.h"
#include "app/cli/command_line.h"
#include "app/cli/reproducer.h"
#include "base/image/file.h"
#include "judge/check/suite.h"

namespace twinlight::cli {

namespace {

using namespace check;

struct CheckArguments {
    std::vector<std::string> names;
    std::string reproducers, page;  // folders; empty: none
    bool json = false;
};

std::string colored(const std::string& text, Outcome outcome) {
    if (!result_in_color()) return text;
    switch (outcome) {
        case Outcome::kNotAsked: return text;
        case Outcome::kPass:
        case Outcome::kRuling: return "\x1b[32m" + text + "\x1b[0m";
        case Outcome::kDeparts: return "\x1b[33m" + text + "\x1b[0m";
        case Outcome::kNew:
        case Outcome::kVanished: return "\x1b[1;31m" + text + "\x1b[0m";
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
    std::string text = fmt::format("{:<{}}  {:<9}  {:<12}  {}\n", "case", width, "fixed", "programmable", "reference");
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto word = [&](Path path, int columns) {
            const Outcome outcome = results[i].outcomes.at(static_cast<std::size_t>(path));
            return colored(fmt::format("{:<{}}", word_of(outcome), columns), outcome);
        };
        text += fmt::format("{:<{}}  {}  {}  {}\n", cases[i].name, width, word(Path::kFixed, 9),
                            word(Path::kProgrammable, 12), word(Path::kReference, 9));
        for (const Finding& finding : results[i].findings) text += "    " + finding_text(cases[i], finding) + "\n";
        if (results[i].non_finite > 0)
            text += fmt::format("    {} values of shaders or the reference are not finite\n", results[i].non_finite);
        if (!results[i].error.empty()) text += "    refused: " + results[i].error + "\n";
    }
    return text;
}

std::string summary(const std::vector<Result>& results) {
    const Counts counts = counted(results);
    const auto fixed = [&](Outcome outcome) { return counts.fixed.at(static_cast<std::size_t>(outcome)); };
    return fmt::format(
        "\n{} case{}. The driver's fixed function: {} pass, {} depart as listed, {} answer otherwise where the "
        "specification is open,\n{} depart and are in no list, {} listed and gone, {} not asked. Values that are not "
        "finite, of shaders and the reference: {}.\nShaders are at most {:.1e} from the reference in long "
        "double.\n{}\n",
        results.size(), results.size() == 1 ? "" : "s", fixed(Outcome::kPass), fixed(Outcome::kDeparts),
        fixed(Outcome::kRuling), fixed(Outcome::kNew), fixed(Outcome::kVanished), fixed(Outcome::kNotAsked),
        counts.non_finite, counts.from_long_double,
        counts.failing == 0 ? "Nothing is unexpected."
                            : fmt::format("{} {}.", counts.failing, counts.failing == 1 ? "case fails" : "cases fail"));
}

// A colour's numbers, or an error's name.
nlohmann::ordered_json json_of(const std::optional<Seen>& seen) {
    if (!seen) return nullptr;
    if (std::holds_alternative<Enum>(*seen)) return text_of(seen);
    auto list = nlohmann::ordered_json::array();
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
    nlohmann::ordered_json json = {{"driver", driver}};
    auto& list = json["cases"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        nlohmann::ordered_json one = {{"name", cases[i].name},
                                      {"what", cases[i].what},
                                      {"text", cases[i].text},
                                      {"status", cases[i].is_ruling ? "ruling" : "defined"}};
        for (std::size_t path = 0; path < kPaths; ++path)
            one[std::string(kPathNames.at(path))] = word_of(results[i].outcomes.at(path));
        one["non_finite"] = results[i].non_finite;
        one["from_long_double"] = results[i].from_long_double;
        if (!results[i].error.empty()) one["refused"] = results[i].error;
        auto& findings = one["findings"] = nlohmann::ordered_json::array();
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
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
           "\n";  // a file's bytes may be any
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw FileError(folder + ": " + error.message());
}

// For each case that the fixed function departs from, NAME.c.
void write_reproducers(const std::string& folder, const std::string& driver, const std::vector<Case>& cases,
                       const std::vector<Result>& results) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string program = reproducer(driver, cases[i], results[i]);
        if (!program.empty())
            write_file_atomically((std::filesystem::path(folder) / (cases[i].name + ".c")).string(), program);
    }
}

int run_check(const CheckArguments& arguments) {
    const std::vector<Case> cases = load_cases(arguments.names);
    for (const std::string& folder : {arguments.reproducers, arguments.page})  // before the work, not after it
        if (!folder.empty()) make_folder(folder);
    Suite suite;
    std::vector<Result> results = suite.run(cases);
    if (!arguments.reproducers.empty()) write_reproducers(arguments.reproducers, suite.driver(), cases, results);
    if (!arguments.page.empty()) {
        for (std::size_t i = 0; i < cases.size(); ++i) suite.draw_vertices(cases[i], results[i]);
        write_file_atomically((std::filesystem::path(arguments.page) / "index.html").string(),
                              check_page(suite.driver(), cases, results));
    }
    write_result(arguments.json ? json_of(suite.driver(), cases, results)
                                : suite.driver() + "\n\n" + table(cases, results) + summary(results));
    return counted(results).failing == 0 ? kFine : kDifferent;
}

}  // namespace

Subcommand add_check(CLI::App& app) {
    const auto arguments = std::make_shared<CheckArguments>();
    CLI::App* check = app.add_subcommand("check", "Hold this machine's driver against the hard cases of lighting");
    check->add_option("CASE", arguments->names, "names of cases, or files of that form; all where none is given")
        ->type_name("");
    check
        ->add_option(
            "--write-reproducers", arguments->reproducers,
            "a C program (GLUT) that shows it, for each departure of the fixed function, into this folder, made if "
            "it is not there")
        ->type_name("DIR")
        ->check(not_empty());
    check
        ->add_option("--html", arguments->page,
                     "a page of all cases, by what is tested, into this folder, made if it is not there: index.html")
        ->type_name("DIR")
        ->check(not_empty());
    check->add_flag("--json", arguments->json, "print one JSON object instead of the table");
    check->footer(
        "Of the driver's fixed function: 'pass'; 'departs', as the case lists for this driver; 'ruling', where the\n"
        "specification leaves the answer open; 'NEW', a departure that no list has; 'VANISHED', one that is gone;\n"
        "'not asked', where a case is about what GL does not have.\n"
        "Shaders and the reference have to pass. GALLIUM_DRIVER=softpipe asks Mesa's other driver.\n"
        "Exit status: 0 nothing unexpected; 1 NEW or VANISHED, a scene that is refused, a value of shaders or the\n"
        "reference that is not finite, or shaders more than 3e-5 from the reference in long double; 2 bad input or "
        "use.");
    return {check, [arguments] { return run_check(*arguments); }};
}

}  // namespace twinlight::cli
