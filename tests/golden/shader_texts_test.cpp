// The text of shaders to keep, word for word, for ten small scenes in golden/shaders: a reader derives each text from the scene and the
// sections that it names. `make golden CASE=fog` writes one again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/image/file.h"
#include "render/programmable/export/kept_files.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::shader_texts_test {
namespace {

namespace fs = std::filesystem;

std::string shaders_of(const std::string& scene) {
    const Frame frame = make_frame(*load_commands(scene), {});
    std::string text;
    for (const NamedFile& file : programmable::kept_files(frame, {}, programmable::Glsl::k330, "scene"))
        if (file.name.ends_with(".vert") || file.name.ends_with(".frag"))
            text += fmt::format("{}// ==== {}\n{}", text.empty() ? "" : "\n", file.name, file.bytes);
    return text;
}

TEST(GoldenShaders, AreTheShortestTextThatDrawsTheScene) {
    const char* write = std::getenv("TWINLIGHT_WRITE_GOLDEN");
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator("golden/shaders")) {
        if (entry.path().extension() != ".gl") continue;
        ++count;
        const std::string name = entry.path().stem();
        const std::string file = fs::path(entry.path()).replace_extension(".glsl");
        const std::string text = shaders_of(entry.path());
        if (write && (std::string_view(write) == "*" || name == write)) {
            write_file_atomically(file, text);
            fmt::print("wrote {}\n", file);
        }
        EXPECT_EQ(text, read_file(file)) << name << ": make golden CASE=" << name << " writes it; read it first";
    }
    EXPECT_EQ(count, 10);
}

}  // namespace
}  // namespace twinlight::shader_texts_test
