// The errors of bad input in the Chinese window. `make bad-input` does without this, and so without the window's texts.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../unit/in_chinese.h"
#include "../unit/run_program.h"
#include "bad_input_rows.h"
#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::bad_input_in_chinese_test {
namespace {

void read_text(const std::string& text) {
    const ReadOptions options{.step = {}, .window = std::nullopt, .most_steps = 100'000};
    static_cast<void>(make_frame(read_scene(text, "bad.c", "bad.c", no_images, options), {.width = 16, .height = 16}));
}

void read_recording(const std::string& file, const std::string& bytes) {
    write_file_atomically(file, bytes);
    static_cast<void>(make_recorded_frame(load_recording(file), {.number = std::nullopt, .width = 16, .height = 16}));
}

template <class Read>
std::vector<std::string> errors_of(const Read& read) {
    std::vector<std::string> messages;
    try {
        read();
    } catch (const SceneError& error) {
        for (const TextError& one : error.errors) messages.push_back(one.message);
        if (messages.empty()) messages.emplace_back(error.what());
    }
    return messages;
}

TEST(BadInput, IsReportedInChinese) {
    const InChinese chinese;
    const TemporaryFolder folder;
    const auto check = [](const std::string& kind, std::size_t at_least, const auto& read) {
        std::size_t count = 0;
        for (const Row& row : rows_of(kind))
            for (std::string message : errors_of([&] { read(row.input); })) {
                ++count;
                message.resize(std::min(message.size(), message.find("apitrace: ")));  // then its own words follow
                EXPECT_EQ(english_left(message, row.input), "") << message << "\nfor " << row.input;
            }
        EXPECT_GT(count, at_least) << kind;
    };
    check("scenes", 300, read_text);
    check("programs", 80, read_text);
    check("dumps", 40, [&](const std::string& text) { read_recording(folder / "dump.txt", text); });
    check("traces", 60, [&](const std::string& bytes) { read_recording(folder / "bad.trace", bytes); });
}

}  // namespace
}  // namespace twinlight::bad_input_in_chinese_test
