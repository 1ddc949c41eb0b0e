#include "scene/scenes/beside.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "base/image/file.h"
#include "base/text/translation.h"
#include "scene/scenes/load.h"

namespace twinlight {

namespace fs = std::filesystem;

fs::path file_beside(const fs::path& folder, const std::string& name, std::string_view what, std::string_view example) {
    const bool is_bare = !name.empty() && name.find_first_of("/\\") == std::string::npos && name != "." && name != "..";
    if (!is_bare) {
        throw std::runtime_error(
            tr("a {} must be in the folder of the scene; give only its file name, such as \"{}\"", what, example));
    }
    std::error_code error;
    const fs::path home = fs::canonical(folder.empty() ? "." : folder, error);
    const fs::path file = error ? fs::path() : fs::canonical(home / name, error);
    if (error) throw std::runtime_error(tr("{}; the {} must be in the folder of the scene", tr(error.message()), what));
    if (file.parent_path() != home) {
        throw std::runtime_error(
            tr("this link points outside the folder of the scene; copy the {} into that folder", what));
    }
    if (!fs::is_regular_file(file, error))
        throw std::runtime_error(tr("this is not a file; give a name such as \"{}\"", example));
    return file;
}

std::optional<std::string_view> built_in_file(std::string_view name) {
    const auto file = std::ranges::find(kSceneAssets, name, &EmbeddedFile::name);
    if (file == kSceneAssets.end()) return {};
    return file->text;
}

std::string read_beside(const fs::path& folder, const std::string& name, std::string_view what,
                        std::string_view example, std::size_t most) {
    std::error_code ignored;
    const bool is_here = fs::exists(fs::symlink_status(folder / name, ignored));
    if (const auto built_in = is_here ? std::nullopt : built_in_file(name)) return std::string(*built_in);
    std::string bytes = read_file(file_beside(folder, name, what, example).string(), most + 1);
    if (bytes.size() > most)
        throw std::runtime_error(tr("the file has more than {} MiB; make the {} smaller", most >> 20, what));
    return bytes;
}

}  // namespace twinlight
