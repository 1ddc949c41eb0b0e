// write_seeds FOLDER SCENE.gl...: scenes as the bytes that state_fuzzer reads.
#include <exception>
#include <filesystem>
#include <iostream>

#include "command/text.h"
#include "command_bytes.h"
#include "image/file.h"
#include "scenes/images.h"

using namespace twinlight;

int main(int argc, char** argv) try {
    for (int i = 2; i < argc; ++i) {
        const std::filesystem::path scene = argv[i];
        const std::string name = scene.stem().string();
        const CommandList list = read_scene(read_file(scene.string()), scene.string(), name, images_beside(scene));
        write_file_atomically((std::filesystem::path(argv[1]) / name).string(), bytes_from(list.commands));
    }
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
}
