// twinlight-demo [SCENE]: the options, the scene, the window.
#include <CLI/CLI.hpp>
#include <string>

#include "app/demo/controls.h"
#include "app/demo/window.h"
#include "app/program.h"
#include "scene/scenes/load.h"

namespace {

using namespace twinlight;

constexpr int kMaxFrames = 1'000'000;

int run(int argc, char** argv) {
    CLI::App app("Draws a scene in a window; a key switches between the driver's fixed function and shaders.",
                 "twinlight-demo");
    app.footer("Keys:\n" + demo::keys_help());
    app.set_version_flag("--version", std::string("twinlight-demo ") + kVersion);

    std::string scene = "report";
    Size size;
    demo::WindowOptions options;
    app.add_option("SCENE", scene, "a built-in scene, a .gl file, or - for standard input")
        ->capture_default_str()
        ->type_name("")
        ->check(not_empty());
    app.add_option_function<std::string>(
           "--with",
           [&](const std::string& name) {
               if (name != "fixed" && name != "programmable") {
                   throw CLI::ValidationError("--with", "'" + name + "' is not one of fixed, programmable");
               }
               options.renderer = name == "fixed" ? Path::kFixed : Path::kProgrammable;
           },
           "the renderer to start with: fixed or programmable")
        ->option_text("RENDERER");
    add_size_option(app, size);
    app.add_option("--keys", options.keys, "press these keys at the start")->option_text("STRING");
    app.add_option("--screenshot", options.screenshot, "the PNG file that the key s and --quit-after write")
        ->option_text("FILE")
        ->check(not_empty());
    app.add_option("--quit-after", options.quit_after, "write the screenshot and quit after this many frames")
        ->check(number_from(1, kMaxFrames))
        ->option_text("FRAMES");

    if (!parse_command_line(app, argc, argv)) return kFine;
    options.width = size.width;
    options.height = size.height;
    return demo::show(load_commands(scene), options);
}

}  // namespace

int main(int argc, char** argv) {
    return run_reporting_errors("twinlight-demo", [&] { return run(argc, argv); });
}
