// The C dialect: any text is a scene or one clear line; and what was read, printed, is read as the same commands.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "scene/command/text.h"

using namespace twinlight;

namespace {

ImageFile image(const std::string& name) {
    return {2, 2, std::vector<std::byte>(2 * 2 * 4, static_cast<std::byte>(name.size()))};
}

[[noreturn]] void fail(const char* what, const std::string& text) {
    std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
    std::abort();
}

void check_message(const std::string& message) {
    for (const char c : message)
        if (c == '\n' || c == '\0') fail("a message of more than a line", message);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    CommandList scene;
    try {
        // A program that does not end would take a sanitizer's build a minute with the usual limit.
        scene = read_scene(text, "fuzz.gl", "fuzz", image, {.most_steps = 100'000});
    } catch (const SceneError& error) {
        check_message(error.what());
        for (const char c : as_compilers_print(error))
            if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F)
                fail("a control character in an error", error.what());
        return 0;
    }
    const std::string printed = print_scene(scene);
    try {
        if (read_scene(printed, "printed.gl", "fuzz", image).commands != scene.commands)
            fail("printed, this is read as other commands", printed);
    } catch (const SceneError& error) {
        fail(error.what(), printed);
    }
    print_c_program(scene);
    return 0;
}
