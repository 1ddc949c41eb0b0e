#include "golden_picture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "../unit/pictures.h"
#include "base/image/png.h"
#include "judge/compare/comparison.h"
#include "picture_failure.h"

namespace twinlight {

void expect_golden(const std::string& name, const std::string& folder, const std::string& file_name, const Image& image,
                   const AllowedDifference& allowed) {
    const char* write = std::getenv("TWINLIGHT_WRITE_GOLDEN");
    const std::string file = "golden/" + folder + "/" + file_name;
    if (write && (std::string_view(write) == "*" || name == write)) {
        std::filesystem::create_directories("golden/" + folder);
        write_png(file, image);
        fmt::print("wrote {}\n", file);
        return;
    }
    ASSERT_TRUE(std::filesystem::exists(file))
        << "there is no " << file << "; make golden CASE=" << name << " writes it";
    const Image golden = read_png(file);
    Image actual = image;
    for (Rgba& pixel : actual.pixels) pixel[3] = 1;  // pictures in files have no alpha
    if (compare::judge(difference(actual, golden, allowed), {}) == compare::Verdict::kBeyond)
        ADD_FAILURE() << picture_failure(name + "-" + file_name, actual, golden).message();
}

AllowedDifference nothing_is_allowed(const Image& image) { return {image.width, image.height}; }

}  // namespace twinlight
