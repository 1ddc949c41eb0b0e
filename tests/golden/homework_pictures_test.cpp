// The first pictures of the whole programs in tests/homework, by the reference, which leaves nothing to a driver.
//
// The golden pictures (golden/homework/PROGRAM.png) have a small window's size. They change only by
// `make golden CASE=PROGRAM`; look at them before they are committed.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/image/file.h"
#include "golden_picture.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::homework_pictures_test {

namespace {

constexpr WindowSize kWindow{.width = 240, .height = 180};

std::vector<std::string> program_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator("tests/homework"))
        if (entry.path().extension() == ".c") names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

class GoldenHomework : public testing::TestWithParam<std::string> {};

TEST_P(GoldenHomework, HasItsPicture) {
    const std::string& name = GetParam();
    const std::string file = "tests/homework/" + name + ".c";
    const CommandList program = read_scene(read_file(file), file, name, no_images, {.window = kWindow});
    const Frame frame = make_frame(program, {.width = kWindow.width, .height = kWindow.height});
    const Image image = reference::render(frame, {});
    expect_golden(name, "homework", name + ".png", image, nothing_is_allowed(image));
}

INSTANTIATE_TEST_SUITE_P(Programs, GoldenHomework, testing::ValuesIn(program_names()),
                         [](const testing::TestParamInfo<std::string>& program) { return program.param; });

}  // namespace

}  // namespace twinlight::homework_pictures_test
