// write_seeds FOLDER SCENE.gl...: pieces of scenes as the bytes that state_fuzzer reads.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <span>
#include <string>

#include "base/image/file.h"
#include "command_bytes.h"
#include "scene/command/text.h"
#include "scene/scenes/images.h"
#include "scene/scenes/meshes.h"

using namespace twinlight;

int main(int argc, char** argv) try {
    for (int i = 2; i < argc; ++i) {
        const std::filesystem::path scene = argv[i];
        const std::string name = scene.stem().string();
        const CommandList list = read_scene(read_file(scene.string()), scene.string(), name, images_beside(scene),
                                            {.load_mesh = meshes_beside(scene)});
        constexpr std::size_t kPiece = 24;
        for (std::size_t from = 0; from < list.commands.size(); from += kPiece) {
            const auto rest = std::span(list.commands).subspan(from);
            const auto file = std::filesystem::path(argv[1]) / (name + "-" + std::to_string(from));
            write_file_atomically(file.string(), bytes_from(rest.first(std::min(kPiece, rest.size()))));
        }
    }
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
}
