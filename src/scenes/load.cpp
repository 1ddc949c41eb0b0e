#include "scenes/load.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "command/text.h"
#include "image/file.h"
#include "scenes/scenes.h"

namespace twinlight {

namespace {

// One byte more than the limit tells a text that is too long from one that just fits.
constexpr std::size_t kReadAtMost = kMaxSceneBytes + 1;

CommandList read_limited(const std::string& text, const std::string& file, const std::string& name) {
    if (text.size() > kMaxSceneBytes) {
        throw SceneError(file + ": is larger than " + std::to_string(kMaxSceneBytes >> 20) +
                         " MiB; a scene is a program's commands, without its data");
    }
    return read_scene(text, file, name);
}

}  // namespace

CommandList load_scene(const std::string& scene) {
    if (scene == "-") return read_limited(read_standard_input(kReadAtMost), "<stdin>", "stdin");
    std::vector<std::string_view> names;
    for (const EmbeddedFile& file : kSceneFiles) {
        names.push_back(file.name.substr(0, file.name.rfind(".gl")));
        if (names.back() == scene) return read_scene(file.text, std::string(file.name), scene);
    }
    const std::filesystem::path path = scene;
    if (path.extension() == ".trace") {
        throw SceneError(scene + ": traces are not read yet; give a scene as C statements in a .gl file");
    }
    // A word that is no file was meant as a name.
    std::error_code ignored;
    if (!path.has_parent_path() && !path.has_extension() && !std::filesystem::exists(path, ignored)) {
        const auto near = nearest(scene, names);
        throw SceneError(scene + ": there is no built-in scene and no file of this name; " +
                         (near ? "did you mean '" + std::string(*near) + "'?" : "'twinlight scenes' lists the scenes"));
    }
    return read_limited(read_file(scene, kReadAtMost), scene, path.filename().string());
}

}  // namespace twinlight
