// twinlight explain: which effects and lights each draw of a scene needs, and why the others are skipped.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/explain_pixel.h"
#include "app/cli/run_program.h"
#include "judge/explain/derivation.h"
#include "render/effect/explanation.h"
#include "scene/command/text.h"

namespace twinlight::cli {

namespace {

struct ExplainArguments {
    std::string scene;
    std::optional<Shading> shading;
    bool variants = false;
    std::optional<Size> size;
    RecordedPart part;
    RunInstead run;
    std::string step;
    MemoryBudget memory;
    std::string pixel, vertex, form, output;
    double budget = PlanOptions{}.budget;
    bool json = false, all = false, calls = false;
};

// ---- As text ----

std::string colored(const std::string& text, bool used) {
    return result_in_color() ? (used ? "\x1b[32m" : "\x1b[2m") + text + "\x1b[0m" : text;
}

// Without `all`, leaves out lights and effects that the scene does not turn on.
std::string table(const Plan& plan, bool all) {
    std::vector<ExplainedEffect> rows = explain_effects(plan);
    std::erase_if(rows, [all](const ExplainedEffect& row) { return !all && row.is_off; });
    std::size_t width = 0;
    for (const ExplainedEffect& row : rows) width = std::max(width, row.what.size());
    std::string text;
    for (const ExplainedEffect& row : rows)
        text += "  " + colored(fmt::format("{:<{}}  {:<7}", row.what, width, row.in ? "used" : "skipped"), row.in) +
                "  " + one_line(row.why) + "\n";
    return text;
}

std::string counted(std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// At most ten names, so that a scene with many lights stays readable.
std::string listed(const std::set<std::string>& items, const char* none, const char* separator = ", ") {
    constexpr std::size_t kMost = 10;
    if (items.empty()) return none;
    const std::vector<std::string> shown(
        items.begin(), std::next(items.begin(), static_cast<std::ptrdiff_t>(std::min(items.size(), kMost))));
    return fmt::format("{}", fmt::join(shown, separator)) +
           (items.size() > kMost ? fmt::format(" and {} more", items.size() - kMost) : "");
}

// Ten lines at most: what a reader with a wrong picture looks at first.
std::string summary(const Scene& scene, const std::vector<ExplainedDraw>& draws, double budget) {
    std::size_t unlit = 0, count = 0;
    std::set<std::string> shadings, matters, skipped, effects;
    std::map<std::string, std::set<std::string>> reasons;  // why a light is skipped, in some draw
    for (const ExplainedDraw& draw : draws) {
        count += draw.numbers.size();
        const EffectSet& facts = draw.plan.effects;
        if (!facts.lighting) unlit += draw.numbers.size();
        if (facts.lighting) shadings.insert(name_of(facts.shading));
        for (const LightBound& light : draw.plan.light_bounds) {
            if (light.in()) matters.insert(light_name(light.number));
            if (!light.in() && light.fate != LightFate::kDisabled)
                reasons[light_name(light.number)].insert(reason(light));
        }
        for (const std::string& fact : effect_words(draw.plan).of_draw)
            if (!fact.ends_with("lighting") && !fact.ends_with(" shading")) effects.insert(fact);
        if (facts.two_side) effects.insert("two-sided lighting");
    }
    for (const auto& [light, why] : reasons)
        if (!matters.contains(light)) skipped.insert(light + " (" + *why.begin() + ")");
    std::string text = fmt::format("{}, {} x {}: {} with {} of effects; allowed change of a channel: {}\n",
                                   scene.title(), scene.frame.width, scene.frame.height, counted(count, "draw"),
                                   counted(draws.size(), "different set"), in_codes(budget));
    text += fmt::format("  lit:                    {} of {}{}\n", count - unlit, count,
                        unlit == 0 ? "" : "; GL_LIGHTING is disabled for the rest, which show glColor");
    text += "  shading:                " + listed(shadings, "no draw is lit") + "\n";
    text += "  lights that matter:     " + listed(matters, "none") + "\n";
    text += "  enabled, but skipped:   " + listed(skipped, "none", "; ") + "\n";
    text += "  effects in use:         " + listed(effects, "none", "; ") + "\n";
    const double error = error_bound(draws);
    text += "  skipping changes:       " +
            (error == 0 ? "no pixel" : fmt::format("a channel by at most {}", in_codes(error))) + "\n";
    return text + "  one pixel, one vertex:  --pixel X,Y and --vertex DRAW,N; everything that is off: --all\n";
}

std::string explanation(const Scene& scene, const std::vector<ExplainedDraw>& draws, double budget, bool all,
                        bool calls) {
    std::string text = summary(scene, draws, budget);
    for (const ExplainedDraw& draw : draws) {
        text += "\n" + explain::bold(name_of(draw), result_in_color());
        if (calls && draw.place.calls) text += "\n  calls: " + one_line(*draw.place.calls);
        text += "\n  effects: " + fmt::format("{}", fmt::join(effect_words(draw.plan).of_draw, ", ")) + "\n" +
                table(draw.plan, all);
        if (draw.plan.error_bound > 0)
            text += fmt::format("  all skipped lights together change a channel by at most {}\n",
                                in_codes(draw.plan.error_bound));
        if (draw.plan.budget < budget)
            text += "  nothing is skipped that changes a pixel, because blending may add up such errors\n";
    }
    return text;
}

// ---- As JSON ----

// JSON has no infinity; null replaces it.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json json_of(const ExplainedDraw& draw) {
    const EffectWords facts = effect_words(draw.plan);
    Json json = {{"draws", draw.numbers}, {"place", draw.place.str()}, {"effects", facts.of_draw}};
    std::size_t in = 0;
    json["lights"] = Json::array();
    for (const LightBound& light : draw.plan.light_bounds)
        json["lights"].push_back({{"name", light_name(light.number)},
                                  {"in", light.in()},
                                  {"effects", light.in() ? facts.of_lights.at(in++) : ""},
                                  {"reason", reason(light)},
                                  {"bound", {number(light.bound.r), number(light.bound.g), number(light.bound.b)}}});
    json["left_out"] = Json::array();
    for (const LeftOut& left_out : draw.plan.left_out)
        json["left_out"].push_back({{"what", left_out.what}, {"why", left_out.why}, {"is_off", left_out.is_off}});
    json["budget"] = draw.plan.budget;
    json["error_bound"] = draw.plan.error_bound;
    return json;
}

std::string json_text(const Scene& scene, const std::vector<ExplainedDraw>& draws, double budget) {
    Json json = {{"scene", scene.name()}, {"size", {scene.frame.width, scene.frame.height}}, {"budget", budget}};
    json["error_bound"] = error_bound(draws);
    json["plans"] = Json::array();
    for (const ExplainedDraw& draw : draws) json["plans"].push_back(json_of(draw));
    return dumped_lines(json);
}

int run_explain(ExplainArguments& arguments) {
    if (!arguments.pixel.empty() && !arguments.vertex.empty())
        throw UsageError("--pixel and --vertex are two questions; give one of them");
    if (!arguments.vertex.empty() && arguments.shading)
        throw UsageError("--shading does not change how a vertex is lit; leave it out, or use --pixel X,Y");
    const bool is_exercise = arguments.form == "exercise";
    if (is_exercise && (arguments.pixel.empty() || arguments.output.empty()))
        throw UsageError("--as exercise needs --pixel X,Y and -o FILE.html");
    if (!is_exercise && !arguments.output.empty()) throw UsageError("-o needs --as exercise");
    if (is_exercise && arguments.json) throw UsageError("choose --json or --as exercise");
    if (!arguments.pixel.empty()) arguments.memory.bytes_of_pixel = 100;
    const std::string file = recorded_first(arguments.run, arguments.scene, arguments.part);
    const Scene scene = load_scene(file, arguments.size, arguments.part, arguments.step, arguments.memory);
    const PlanOptions options{look_of(arguments.shading, arguments.variants), arguments.budget};
    if (is_exercise) {
        // One point to calculate, not three vertices, unless the teacher wants these.
        const Look look = look_of(arguments.shading.value_or(Shading::kPhong), arguments.variants);
        write_output(arguments.output, exercise_of_pixel(scene, look, arguments.pixel));
        return kFine;
    }
    const ExplainOptions of_point{options, arguments.json, arguments.all, arguments.calls};
    if (!arguments.pixel.empty()) {
        write_result(explain_pixel(scene, of_point, arguments.pixel));
        return kFine;
    }
    if (!arguments.vertex.empty()) {
        write_result(explain_vertex(scene, of_point, arguments.vertex));
        return kFine;
    }
    const std::vector<ExplainedDraw> draws =
        explain_draws(scene.frame, PlanOptions{{.shading = arguments.shading}, arguments.budget});
    write_result(arguments.json ? json_text(scene, draws, arguments.budget)
                                : explanation(scene, draws, arguments.budget, arguments.all, arguments.calls));
    return kFine;
}

}  // namespace

Subcommand add_explain(CLI::App& app) {
    const auto arguments = std::make_shared<ExplainArguments>();
    CLI::App* command = app.add_subcommand(
        "explain", "Show which effects a scene uses, or the lighting equation with its numbers at a pixel");
    add_scene_argument(*command, arguments->scene);
    add_shading_option(*command, arguments->shading);
    add_variants_option(*command, arguments->variants);
    add_size_option(*command, arguments->size);
    add_recorded_options(*command, arguments->part);
    add_run_flag(*command, arguments->run);
    add_step_option(*command, arguments->step);
    add_memory_option(*command, arguments->memory);
    add_gl_option(*command);
    add_budget_option(*command, arguments->budget);
    command
        ->add_option("--pixel", arguments->pixel,
                     "show the lighting equation with its numbers at one pixel; 0,0 is the top left corner")
        ->type_name("X,Y")
        ->check(not_empty());
    command->add_option("--vertex", arguments->vertex, "the same at a vertex; draws and vertices are counted from 1")
        ->type_name("DRAW,N")
        ->check(not_empty());
    command->add_flag("--all", arguments->all,
                      "also show lights and effects that the scene does not turn on, and every vertex of a pixel");
    command
        ->add_option("--as", arguments->form,
                     "exercise: with --pixel, an exam sheet: the equation with its numbers left blank, and a second "
                     "page with the "
                     "solution; lit at the pixel, unless --shading says gouraud or flat")
        ->type_name("exercise")
        ->check(CLI::IsMember({"exercise"}).description(""));
    command->add_option("-o", arguments->output, "the file of the exam sheet, a page to print; - for standard output")
        ->type_name("FILE")
        ->check(not_empty());
    add_calls_flag(*command, arguments->calls);
    command->add_flag("--json", arguments->json, "print one JSON object instead of the text");
    return {command, [arguments] { return run_explain(*arguments); }};
}

}  // namespace twinlight::cli
