// Warnings as text, as JSON, and the page docs/lint.md.
#include <algorithm>

#include "base/text/json.h"
#include "judge/lint/watch.h"
#include "scene/command/text.h"

namespace twinlight::lint {

namespace {

bool is_call(const Place& place) { return place.column == Place::kCallNumber; }

// The lines of a rule's scene that have one of these signs before them.
std::string lines_with(std::string_view scene, std::string_view signs) {
    std::string text;
    for (std::size_t start = 0; start < scene.size();) {
        const std::size_t end = scene.find('\n', start) + 1;
        const std::string_view line = scene.substr(start, end - start);
        start = end;
        if (line == kView)
            text += view_lines();
        else if (line == kLight)
            text += light_lines();
        else if (signs.find(line[0]) != signs.npos)
            text += line.substr(1);
    }
    return text;
}

}  // namespace

std::string wrong_scene(const Rule& rule) { return lines_with(rule.scene, " -"); }
std::string corrected_scene(const Rule& rule) { return lines_with(rule.scene, " +"); }

std::string message_of(const Warning& warning) {
    return warning.when.empty() ? warning.message : fmt::format("{} ({})", warning.message, warning.when);
}

std::string headline(const Warning& warning) {
    std::string text = fmt::format("{}: warning: {}", warning.place.str(), message_of(warning));
    if (warning.count > 1) text += fmt::format(" ({} times; this is the first)", warning.count);
    return text + fmt::format(" [{}]", warning.rule->name);
}

std::string full_text(const Warning& warning, std::string_view source, bool calls) {
    std::string text = one_line(headline(warning)) + "\n";
    if (!is_call(warning.place)) text += line_with_caret(source, warning.place);
    if (calls && warning.place.calls) text += fmt::format("  calls: {}\n", one_line(*warning.place.calls));
    return text + fmt::format("  why: {}\n  fix: {}\n", warning.rule->why, warning.fix);
}

std::string json_text(const std::string& scene, std::span<const Warning> warnings) {
    Json json = {{"scene", scene}};
    json["warnings"] = Json::array();
    for (const Warning& warning : warnings) {
        Json one = {{"name", warning.rule->name}, {"line", warning.place.line}};
        if (warning.place.file) one["file"] = *warning.place.file;
        if (warning.place.calls) one["calls"] = *warning.place.calls;
        one["column"] = is_call(warning.place) ? Json(nullptr) : Json(warning.place.column);
        one["count"] = warning.count;
        one["when"] = warning.when.empty() ? Json(nullptr) : Json(warning.when);
        one["message"] = warning.message;
        one["why"] = warning.rule->why;
        one["fix"] = warning.fix;
        json["warnings"].push_back(one);
    }
    // A scene's name may hold any bytes; JSON is UTF-8.
    return dumped_lines(json);
}

std::string markdown() {
    std::string text = fmt::format(
        "# What `twinlight lint` finds\n\n"
        "Most mistakes in lighting are not GL errors: the program runs, but the picture is wrong. `twinlight lint "
        "SCENE` finds {} of them.\n\n"
        "    $ twinlight lint scene.gl\n"
        "    scene.gl:7:1: warning: GL_LIGHT1 is on but black: only GL_LIGHT0 starts with a colour [light-black]\n"
        "    glEnable(GL_LIGHT1);\n"
        "    ^\n"
        "      why: Table 2.10: the initial diffuse and specular colours are white for `GL_LIGHT0`, and black for all "
        "others.\n"
        "      fix: glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){{1, 1, 1, 1}});\n\n"
        "- SCENE may be a recorded program as well; `twinlight lint --run lamp.cpp` runs and records one "
        "([real-programs.md](real-programs.md)). A repeated warning is printed once, with its count.\n"
        "- The linter looks at several pictures of a program: the first, the second, one after a second and one after "
        "a "
        "key that changes it; of a recording, at the first that draws, the next, and the last of the next 50 "
        "(`--frame N`: only that one). A warning that does not hold in all of them says when. A mistake that only a "
        "later picture has is a warning if the first two do not run its statement.\n"
        "- A fix is tried before it is offered: with it, in each of these pictures, the warning must be gone, no other "
        "may appear, and nothing else may change. `--fix` writes only such fixes; other `fix:` lines are "
        "advice. (Fixes of recordings with more than 300,000 calls are not tried.)\n"
        "- Several files, or a folder, give one line each: the file, the number of its warnings, and their rules. "
        "`twinlight lint --csv homework > homework.csv` writes a table for a spreadsheet: one row for each warning, "
        "with "
        "its line, its message and the fix, and one for each file without any. In a folder and its subfolders, it "
        "reads scenes (`.gl`), programs (`.c`) and recordings (`.trace`). C++ and Python are named, but not run; "
        "`lint --run homework` runs and lints each program in a folder. A file that cannot be read has a line with the "
        "reason, and the others follow.\n"
        "- `--json` prints one object for programs: for one file its warnings, for several a list of files. The exit "
        "status is 0 without warnings, 1 with some, 2 for bad input or a file that could not be read.\n"
        "- `--fix NAME -o FILE` fixes the first warning of that name, if a call can fix it, and writes the changed "
        "scene "
        "or a changed copy of the recorded program's source.\n"
        "- The comment `// twinlight: allow(NAME)` at the end of a line silences a warning for that line; on a line of "
        "its own, for the whole scene.\n"
        "- `render` and `compare` print the same warnings in one line each, and the page of `compare` shows them.\n\n"
        "The linter warns only where it is sure. It does not check shadows, which GL's lighting does not have, nor "
        "whether a light was meant to be elsewhere. Not covered: `GL_LIGHT_MODEL_LOCAL_VIEWER` (both settings are "
        "right), the "
        "cost of `GL_NORMALIZE`, the aspect ratio of a window that a scene does not know, a material that was meant "
        "for another object.\n\n"
        "This page is generated: `twinlight lint --rules`. Left pictures show the scene with the mistake, right ones "
        "the corrected scene. In the text of a scene, - marks wrong lines and + the lines that fix them. The line "
        "`// the view` is short for\n\n",
        rules().size());
    const auto indented = [](std::string_view lines) {
        std::string block;
        for (std::size_t start = 0; start < lines.size();) {
            const std::size_t end = lines.find('\n', start) + 1;
            block += "    " + std::string(lines.substr(start, end - start));
            start = end;
        }
        return block;
    };
    text += indented(view_lines()) + "\nand `// the light` for\n\n" + indented(light_lines()) +
            "\n| rule | what is wrong |\n|---|---|\n";
    for (const Rule& rule : rules()) text += fmt::format("| [{0}](#{0}) | {1} |\n", rule.name, rule.what);
    for (const Rule& rule : rules()) {
        text += fmt::format(
            "\n## {0}\n\n{1} {2}\n\nTo fix it: `{3}`\n\n"
            "| wrong | right |\n|---|---|\n| ![{0}: wrong](lint/{0}-wrong.png) | ![{0}: right](lint/{0}-right.png) "
            "|\n\n"
            "```diff\n{4}```\n",
            rule.name, rule.what, rule.why, rule.fix, rule.scene);
    }
    return text;
}

}  // namespace twinlight::lint
