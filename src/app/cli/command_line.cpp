#include "app/cli/command_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "image/file.h"
#include "scenes/load.h"
#include "state/state.h"

namespace twinlight::cli {

namespace {

const std::map<std::string, Shading> kShadings = {
    {"flat", Shading::kFlat},
    {"gouraud", Shading::kGouraud},
    {"phong", Shading::kPhong},
};

}  // namespace

void add_scene_argument(CLI::App& app, std::string& scene) {
    app.add_option("SCENE", scene, "a built-in scene's name, a .gl file, or - for standard input")
        ->required()
        ->type_name("")
        ->check(not_empty());
}

void add_shading_option(CLI::App& app, std::optional<Shading>& shading) {
    app.add_option_function<std::string>(
           "--shading", [&shading](const std::string& name) { shading = kShadings.at(name); },
           "what the scene's glShadeModel says, unless given")
        ->type_name("flat|gouraud|phong")
        ->check(one_of(kShadings));
}

Frame load_frame(const std::string& scene, Size size) {
    StateOptions options;
    options.width = size.width;
    options.height = size.height;
    return make_frame(std::make_shared<const CommandList>(load_scene(scene)), options);
}

void write_result(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0) {
        throw FileError(std::string("standard output: ") + std::strerror(errno));
    }
}

bool result_in_color() {
    const char* no_color = std::getenv("NO_COLOR");
    return ::isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == '\0');
}

}  // namespace twinlight::cli
