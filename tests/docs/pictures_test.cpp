// The pictures of docs/lighting.md are what the reference draws.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "../unit/run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"

namespace twinlight::pictures_test {
namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
    return names;
}

// Of a page's picture. Compressors differ.
PngPixels pixels_of(const std::string& file) { return decode_png_pixels(read_file(file), 2000); }

TEST(DocsPictures, OfTheLightingAreCurrent) {
    const TemporaryFolder folder;
    const ProgramResult drawn =
        run_shell("twinlight", "tests/docs/lighting_pictures.sh " + quoted(folder / "lighting"));
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    const std::set<std::string> names = names_in(folder / "lighting");
    EXPECT_GE(names.size(), 16u);
    EXPECT_EQ(names_in("docs/lighting"), names);
    const std::string page = read_file("docs/lighting.md");
    for (const std::string& name : names) {
        EXPECT_TRUE(pixels_of("docs/lighting/" + name) == pixels_of(folder / ("lighting/" + name)))
            << name << ": tests/docs/lighting_pictures.sh draws it again";
        EXPECT_NE(page.find("(lighting/" + name + ")"), page.npos) << "docs/lighting.md does not show " << name;
    }
}

}  // namespace
}  // namespace twinlight::pictures_test
