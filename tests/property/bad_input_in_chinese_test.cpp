// The errors of bad input in the Chinese window. `make bad-input` does without this, and so without the window's texts.
#include <gtest/gtest.h>

#include <string>

#include "../unit/in_chinese.h"
#include "bad_input_rows.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::bad_input_in_chinese_test {
namespace {

TEST(BadInput, IsReportedInChinese) {
    const InChinese chinese;
    std::size_t count = 0;
    for (const std::string kind : {"scenes", "programs"})
        for (const Row& row : rows_of(kind)) {
            try {
                const ReadOptions options{.step = {}, .window = std::nullopt, .most_steps = 100'000};
                static_cast<void>(make_frame(read_scene(row.input, "bad.c", "bad.c", no_images, options),
                                             {.width = 16, .height = 16}));
            } catch (const SceneError& error) {
                for (const TextError& one : error.errors)
                    EXPECT_EQ(english_left(one.message, row.input), "") << one.message << "\nfor " << row.input;
                count += error.errors.size();
            }
        }
    EXPECT_GT(count, 400U);
}

}  // namespace
}  // namespace twinlight::bad_input_in_chinese_test
