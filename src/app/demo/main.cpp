// twinlight-demo [SCENE]: the options, the scene, the window.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "app/demo/controls.h"
#include "app/demo/window.h"
#include "command/text.h"
#include "scenes/load.h"

namespace {

using namespace twinlight;

constexpr int kBadInput = 2;
constexpr int kMaxSize = 8192;  // what every driver's viewport can hold

bool read_size(const std::string& text, demo::WindowOptions& options) {
    int end = 0;
    return std::sscanf(text.c_str(), "%5dx%5d%n", &options.width, &options.height, &end) == 2 &&
           end == static_cast<int>(text.size()) && options.width > 0 && options.height > 0 &&
           options.width <= kMaxSize && options.height <= kMaxSize;
}

int run(int argc, char** argv) {
    CLI::App app(
        "Draws a scene in a window with the driver's fixed function and with shaders, and switches it live.");
    app.footer("Keys:\n" + demo::keys_help());
    app.set_version_flag("--version", "twinlight-demo 0.1");

    std::string scene = "report";
    std::string size = "640x480";
    demo::WindowOptions options;
    app.add_option("SCENE", scene, "a built-in scene's name, a .gl file, or - for standard input")
        ->capture_default_str();
    app.add_option_function<std::string>(
           "--with",
           [&](const std::string& name) {
               if (name != "fixed" && name != "programmable") {
                   throw CLI::ValidationError("--with", "'" + name + "' is not one of fixed, programmable");
               }
               options.renderer = name == "fixed" ? demo::Renderer::kFixed : demo::Renderer::kProgrammable;
           },
           "the renderer to start with: fixed or programmable")
        ->option_text("RENDERER");
    app.add_option("--size", size, "of the picture, in pixels")->option_text("WxH")->capture_default_str();
    app.add_option("--keys", options.keys, "press these keys at the start")->option_text("STRING");
    app.add_option("--screenshot", options.screenshot, "the PNG that the key s and --quit-after write")
        ->option_text("FILE");
    app.add_option("--quit-after", options.quit_after, "write the screenshot and quit after so many frames")
        ->check(CLI::PositiveNumber)
        ->option_text("FRAMES");

    try {
        app.parse(argc, argv);
        if (!read_size(size, options)) {
            throw CLI::ValidationError("--size",
                                       "'" + size + "' is not a size; it must be WxH, such as 640x480");
        }
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
        std::fprintf(stderr, "twinlight-demo: %s; see 'twinlight-demo --help'\n", e.what());
        return kBadInput;
    }

    return demo::show(std::make_shared<const CommandList>(load_scene(scene)), options);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const SceneError& e) {  // begins with the place
        std::fprintf(stderr, "%s\n", e.what());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "twinlight-demo: %s\n", e.what());
    }
    return kBadInput;
}
