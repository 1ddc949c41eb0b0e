// twinlight-demo [SCENE]: the options, the scene, the window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "app/demo/theme.h"
#include "app/demo/window.h"
#include "app/memory.h"
#include "app/program.h"
#include "app/session/keys.h"
#include "app/session/language.h"
#include "app/session/recorded_program.h"
#include "app/session/tutor.h"
#include "judge/lesson/lesson.h"
#include "scene/command/names.h"

namespace {

using namespace twinlight;

constexpr int kMaxFrames = 1'000'000;
constexpr double kMaxScale = 4;

template <class Row, std::size_t size>
std::string keys_of(const Row (&table)[size], const std::string& between) {
    std::string keys;
    for (const Row& row : table) keys += (keys.empty() ? "" : between) + std::string(row.key);
    return keys;
}

// The value of the row of `table` with this key.
template <class Row, std::size_t size>
auto value_of(const Row (&table)[size], const std::string& key, const std::string& option) {
    for (const Row& row : table)
        if (row.key == key) return row.value;
    throw CLI::ValidationError(option, "'" + key + "' is not one of " + keys_of(table, ", "));
}

session::Probe probe_at(const std::string& text) {
    session::Probe probe;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d,%d%c", &probe.x, &probe.y, &rest) != 2 || probe.x < 0 || probe.y < 0)
        throw CLI::ValidationError("--probe", "'" + text + "' is not X,Y, such as 320,240");
    return probe;
}

// The codes of keys such as f1<Left><Ctrl+O>.
std::vector<int> keys_in(const std::string& text) {
    std::vector<int> keys;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '<') {
            keys.push_back(static_cast<unsigned char>(text[i]));
            continue;
        }
        const std::size_t end = std::min(text.find('>', i), text.size());
        const std::string name = text.substr(i + 1, end - i - 1);
        const auto key = session::find_key(name);
        if (!key)
            throw CLI::ValidationError("--keys", "'<" + name + ">' is no key of the window, as <Left> or <Ctrl+O> is");
        keys.push_back(*key);
        i = end;
    }
    return keys;
}

// Chinese needs a font with its letters.
lesson::Language shown_language(lesson::Language wanted) {
    if (wanted == lesson::Language::kEnglish || !demo::chinese_font().empty()) return wanted;
    print_message(
        "twinlight-demo: no font with Chinese letters was found, so the window is in English; install "
        "fonts-noto-cjk\n");
    return lesson::Language::kEnglish;
}

int run(int argc, char** argv) {
    CLI::App app("Opens a window that draws a scene three ways, side by side, and lets you change every call in it.",
                 "twinlight-demo");
    app.footer("Keys:\n" + session::keys_help());
    add_version_flag(app, "twinlight-demo");

    std::string scene = "report";
    demo::WindowOptions options;
    std::optional<Size> size;
    app.add_option("SCENE", scene, "a built-in scene, a .gl file, or - for standard input")
        ->capture_default_str()
        ->type_name("")
        ->check(not_empty());
    std::string lesson_name;
    app.add_option("--lesson", lesson_name, "open a lesson instead of a scene; 'twinlight lesson' lists them")
        ->option_text("NAME")
        ->check(not_empty());
    app.add_option_function<std::string>(
           "--tutor", [&](const std::string& name) { options.tutor = value_of(session::kTutors, name, "--tutor"); },
           "open a tutor instead of a scene: six calls whose numbers you drag, the world and the picture")
        ->option_text(keys_of(session::kTutors, "|"));
    options.language = lesson::users_language();
    add_language_option(app, options.language,
                        "language of the window: English or Chinese (default: the environment's language)");
    std::string step;
    app.add_option("--step", step, "the step of a scene with steps to show first: its number, from 1, or its title")
        ->option_text("N")
        ->check(not_empty());
    app.add_option_function<std::string>(
           "--view", [&](const std::string& name) { options.view = value_of(session::kViews, name, "--view"); },
           "what to show first (default: slider)")
        ->option_text(keys_of(session::kViews, "|"));
    app.add_option_function<std::string>(
           "--panel", [&](const std::string& name) { options.panel = value_of(session::kPanels, name, "--panel"); },
           "the tab to open (default: the last one)")
        ->option_text(keys_of(session::kPanels, "|"));
    app.add_option_function<std::string>(
           "--probe",
           [&](const std::string& text) {
               options.probe = probe_at(text);
               options.panel = session::Panel::kProbe;
           },
           "explain the pixel at X,Y of the picture, from its top left")
        ->option_text("X,Y");
    add_size_option(app, size, "the last one, or what fits the screen");
    app.add_option("--scale", options.scale, "the size of letters: 1 for 96 dots per inch (default: the screen's)")
        ->check(number_from(0.5, kMaxScale))
        ->option_text("NUMBER");
    app.add_option_function<std::string>(
           "--keys", [&](const std::string& text) { options.keys = keys_in(text); },
           "press these keys at the start; <Left>, <F1> and <Ctrl+O> name keys")
        ->option_text("STRING");
    app.add_option("--screenshot", options.screenshot,
                   "the PNG file that the key p and --quit-after write: the whole window")
        ->option_text("FILE")
        ->check(not_empty());
    app.add_option("--quit-after", options.quit_after, "write the screenshot and quit after this many frames")
        ->check(number_from(1, kMaxFrames))
        ->option_text("FRAMES");
    app.add_option("--times", options.times,
                   "write the milliseconds of each frame to this JSON file, those from each key of --keys to the "
                   "frame that answers it, and the texts of the last frame and where they are cut or overlap")
        ->option_text("FILE")
        ->check(not_empty());

    if (!parse_command_line(app, argc, argv)) return kFine;
    if (size) options.size = {size->width, size->height};
    options.language = shown_language(options.language);
    session::set_language(options.language);
    constexpr std::size_t kBytesOfPixel = 60;  // measured: 52, in all views
    if (size)
        check_fits({.has_option = false}, size->width, size->height,
                   pixels_of(size->width, size->height) * kBytesOfPixel);
    if (!lesson_name.empty()) {
        if (app.count("SCENE") > 0) throw UsageError("give either SCENE or --lesson");
        options.lesson = load_lesson(lesson_name, options.language);
        return demo::show(lesson::commands_of(*options.lesson, options.lesson->scene), options);
    }
    if (!options.tutor.empty()) {
        if (app.count("SCENE") > 0) throw UsageError("give either SCENE or --tutor");
        return demo::show(session::tutor_scene(options.tutor), options);
    }
    session::Opened opened = session::load_openable(scene, step);
    options.file = std::move(opened.file);
    return demo::show(std::move(opened.scene), options);
}

}  // namespace

int main(int argc, char** argv) {
    return run_reporting_errors("twinlight-demo", [&] { return run(argc, argv); });
}
