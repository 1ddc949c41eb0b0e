// The text of shaders to keep, word for word, for ten small scenes in golden/shaders: a reader derives each text from the scene and the
// sections that it names. Some also as WGSL and as GLSL for Vulkan. `make golden CASE=fog` writes one again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/file.h"
#include "render/programmable/export/kept_files.h"
#include "render/webgpu/ported_files.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::shader_texts_test {
namespace {

namespace fs = std::filesystem;

bool is_shader(const NamedFile& file) { return file.name.starts_with("kind") && file.name != "kinds.c"; }

std::string shaders_in(const std::vector<NamedFile>& files) {
    std::string text;
    for (const NamedFile& file : files)
        if (is_shader(file)) text += fmt::format("{}// ==== {}\n{}", text.empty() ? "" : "\n", file.name, file.bytes);
    return text;
}

// Compares the text with the file, or writes it.
void expect_golden(const std::string& name, const std::string& file, const std::string& text) {
    const char* write = std::getenv("TWINLIGHT_WRITE_GOLDEN");
    if (write && (std::string_view(write) == "*" || name == write)) {
        write_file_atomically(file, text);
        fmt::print("wrote {}\n", file);
    }
    EXPECT_EQ(text, read_file(file)) << name << ": make golden CASE=" << name << " writes it; read it first";
}

Frame frame_of(const std::string& name) { return make_frame(*load_commands("golden/shaders/" + name + ".gl"), {}); }

TEST(GoldenShaders, AreTheShortestTextThatDrawsTheScene) {
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator("golden/shaders")) {
        if (entry.path().extension() != ".gl") continue;
        ++count;
        const std::string name = entry.path().stem();
        const auto files = programmable::kept_files(frame_of(name), {}, programmable::Glsl::k330, "scene");
        expect_golden(name, "golden/shaders/" + name + ".glsl", shaders_in(files));
    }
    EXPECT_EQ(count, 10);
}

TEST(GoldenShaders, SayTheSameInWgslAndForVulkan) {
    for (const std::string name : {"spotlight", "two-side", "separate-specular"}) {
        const auto text = [&](webgpu::Target target) {
            return shaders_in(webgpu::ported_files(frame_of(name), {}, target, "scene"));
        };
        expect_golden(name, "golden/shaders/" + name + ".wgsl", text(webgpu::Target::kWgsl));
        expect_golden(name, "golden/shaders/" + name + "-vulkan.glsl", text(webgpu::Target::kVulkan));
    }
}

}  // namespace
}  // namespace twinlight::shader_texts_test
