#include "app/session/saving.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/image/file.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/export/kept_files.h"
#include "render/webgl/exported_page.h"
#include "scene/command/text.h"
#include "scene/shape/written_out.h"

namespace twinlight::session {
namespace {

namespace fs = std::filesystem;

// A scene names its pictures and meshes relative to its own folder.
std::string folder_of_scene(const Session& session, const std::string& folder) {
    const bool names_files = std::ranges::any_of(commands(session).commands, [](const Command& command) {
        return command.id == CommandId::pragma_texture || command.id == CommandId::pragma_mesh;
    });
    if (!names_files || !session.file) return folder;
    return fs::path(*session.file).parent_path().string();
}

// why_not: why the scene cannot be saved so; empty if it can.
void check_can_be_kept(const std::string& why_not, const Look& look) {
    if (look.shading == Shading::kExact)
        throw std::runtime_error(
            "exact surfaces are found by rays for one picture; choose another shading (key g) for shaders to keep");
    if (!why_not.empty()) throw std::runtime_error("shaders to keep cannot draw this scene: " + why_not);
}

}  // namespace

std::string stem_of(const std::string& scene) {
    std::string stem = scene == "-" ? "stdin" : fs::path(scene).stem().string();
    return stem.empty() ? "scene" : stem;
}

std::string free_path(const std::string& folder, const std::string& stem, const std::string& ending) {
    for (int number = 1;; ++number) {
        const std::string name = number == 1 ? stem + ending : fmt::format("{}-{}{}", stem, number, ending);
        const std::string path = folder.empty() ? name : (fs::path(folder) / name).string();
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(path, ignored))) return path;
    }
}

std::string save(const Session& session, Form form, const Look& look, const std::string& folder) {
    const CommandList& list = commands(session);
    const Frame& frame = session.scene.frame;
    const std::string ending = kForms[static_cast<std::size_t>(form)].ending;
    const std::string path =
        free_path(form == Form::kScene ? folder_of_scene(session, folder) : folder, stem_of(list.name), ending);
    switch (form) {
        case Form::kScene: write_file_atomically(path, print_scene(list)); break;
        case Form::kC: write_file_atomically(path, print_c_program(with_pragmas_written_out(list))); break;
        case Form::kHtml:
            check_can_be_kept(programmable::why_not_kept(frame), look);
            write_file_atomically(path, webgl::exported_page(frame, look, list.name));
            break;
        case Form::kGlsl: {
            check_can_be_kept(programmable::why_not_in_files(frame), look);
            const auto files = programmable::kept_files(frame, {{look}}, programmable::Glsl::k330, list.name);
            std::vector<FileToWrite> to_write;
            for (const programmable::NamedFile& file : files)
                to_write.push_back({(fs::path(path) / file.name).string(), file.bytes});
            write_files_atomically(to_write, {}, MissingFolders::kMade);
            return fmt::format("wrote {}/ with {} files; README.md explains them", path, files.size());
        }
    }
    return fmt::format("wrote {}, {} bytes", path, fs::file_size(path));
}

}  // namespace twinlight::session
