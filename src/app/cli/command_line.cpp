#include "app/cli/command_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "image/file.h"
#include "scenes/load.h"
#include "state/state.h"

namespace twinlight::cli {

namespace {

// The whole of `text` as a side's length, or 0.
int parse_side(std::string_view text) {
    int side = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && side >= kMinSide && side <= kMaxSide ? side : 0;
}

const std::map<std::string, Shading> kShadings = {
    {"flat", Shading::kFlat},
    {"gouraud", Shading::kGouraud},
    {"phong", Shading::kPhong},
};

}  // namespace

Size parse_size(const std::string& text) {
    const std::size_t x = text.find('x');
    if (x != std::string::npos) {
        const std::string_view view = text;
        const Size size = {.width = parse_side(view.substr(0, x)), .height = parse_side(view.substr(x + 1))};
        if (size.width != 0 && size.height != 0) return size;
    }
    throw CLI::ValidationError(
        "--size", fmt::format("'{}' is not a size; it must be WxH, from {}x{} to {}x{}", text, kMinSide,
                              kMinSide, kMaxSide, kMaxSide));
}

void add_scene_argument(CLI::App& app, std::string& scene) {
    app.add_option("SCENE", scene, "a built-in scene's name, a .gl file, or - for standard input")
        ->required()
        ->type_name("");
}

void add_size_option(CLI::App& app, Size& size) {
    app.add_option_function<std::string>(
           "--size", [&size](const std::string& text) { size = parse_size(text); },
           "the picture's size in pixels")
        ->type_name("WxH")
        ->default_str(fmt::format("{}x{}", size.width, size.height));
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
