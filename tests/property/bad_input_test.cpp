// Bad input, as tables: tests/bad_input/*.txt. Each row has a part of the error and the input. Whatever is wrong ends with exit
// status 2 and one clear line for each error, without control characters. `make bad-input` runs this under the sanitizers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "../unit/run_program.h"
#include "bad_input_rows.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "judge/study/study.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight {
namespace {

bool has_control_characters(const std::string& text) {
    return std::ranges::any_of(text,
                               [](char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f; });
}

// Checks that reading a row's input ends with its error.
template <class Read>
void check(const std::vector<Row>& rows, std::size_t at_least, Read read) {
    EXPECT_GE(rows.size(), at_least);
    for (const Row& row : rows) {
        std::string printed = "no error";
        try {
            read(row.input);
        } catch (const SceneError& error) {
            printed = as_compilers_print(error);
        } catch (const FileError& error) {
            printed = one_line(error.what());
        }
        EXPECT_NE(printed.find(row.message), std::string::npos) << quoted(row.input) << "\ngives " << printed;
        std::erase(printed, '\t');  // a quoted line of the text keeps its tabs
        EXPECT_FALSE(has_control_characters(printed)) << quoted(printed);
    }
}

TEST(BadInput, Scenes) {
    const TemporaryFolder folder;
    check(rows_of("scenes"), 300, [&](const std::string& text) {
        write_file_atomically(folder / "bad.gl", text);
        const std::shared_ptr<const Recording> scene = load_recording(folder / "bad.gl");
        static_cast<void>(make_frame(*scene->command_list(), {.width = 16, .height = 16}));
    });
}

TEST(BadInput, Programs) {
    check(rows_of("programs"), 80, [](const std::string& text) {
        const ReadOptions options{.step = {}, .window = std::nullopt, .most_steps = 100'000};
        static_cast<void>(
            make_frame(read_scene(text, "bad.c", "bad.c", no_images, options), {.width = 16, .height = 16}));
    });
}

TEST(BadInput, Dumps) {
    const TemporaryFolder folder;
    check(rows_of("dumps"), 40, [&](const std::string& text) {
        write_file_atomically(folder / "dump.txt", text);
        static_cast<void>(make_recorded_frame(load_recording(folder / "dump.txt"),
                                              {.number = std::nullopt, .width = 16, .height = 16}));
    });
}

TEST(BadInput, Pictures) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "bad.gl", "#pragma twinlight texture(\"brick.png\")\nglutSolidSphere(1, 8, 8);");
    check(rows_of("pictures"), 30, [&](const std::string& bytes) {
        write_file_atomically(folder / "brick.png", bytes);
        static_cast<void>(load_recording(folder / "bad.gl"));
    });
}

// apitrace dumps those of old versions. What it says differs between its versions.
TEST(BadInput, Traces) {
    if (run_shell("", "command -v apitrace").status != 0) GTEST_SKIP() << "apitrace is not installed";
    const TemporaryFolder folder;
    check(rows_of("traces"), 60, [&](const std::string& bytes) {
        write_file_atomically(folder / "bad.trace", bytes);
        static_cast<void>(make_recorded_frame(load_recording(folder / "bad.trace"),
                                              {.number = std::nullopt, .width = 16, .height = 16}));
    });
}

// Rows with a place and the value that replaces the right one in tests/bad_input/study.json.
TEST(BadInput, Studies) {
    const std::string right = read_file("tests/bad_input/study.json");
    ASSERT_EQ(study::read_study(right, "A.json").points.size(), 2u);
    const auto with = [&](const std::string& place, const std::string& value) {
        if (place == "(text)") return value;
        nlohmann::ordered_json json = nlohmann::ordered_json::parse(right);
        const nlohmann::ordered_json::json_pointer pointer(place);
        if (value == "(none)") {
            json.at(pointer.parent_pointer()).erase(pointer.back());
            return json.dump();
        }
        json.at(pointer) = "@";
        std::string text = json.dump();
        return text.replace(text.find("\"@\""), 3, value);  // as it is: JSON has no 1e999
    };
    check(rows_of("studies"), 150, [&](const std::string& row) {
        const std::size_t tab = row.find('\t');
        try {
            static_cast<void>(study::read_study(with(row.substr(0, tab), row.substr(tab + 1)), "A.json"));
        } catch (const std::runtime_error& error) {
            throw FileError(error.what());
        }
    });
    nlohmann::ordered_json many = nlohmann::ordered_json::parse(right);
    many["points"] = std::vector<int>(10'001);
    EXPECT_THROW(study::read_study(many.dump(), "A.json"), std::runtime_error);
}

TEST(BadInput, CommandLines) {
    const TemporaryFolder folder;
    const std::vector<Row> rows = rows_of("command_lines");
    EXPECT_GE(rows.size(), 200u);
    std::string script = "PROGRAM=$(realpath \"$PROGRAM\"); cd " + quoted(folder.str()) + "; exec 2>&1\n";
    for (const Row& row : rows) script += "\"$PROGRAM\" " + row.input + "\nprintf '\\001%s\\001' $?\n";
    const std::string printed = run_shell("twinlight", script).out;
    std::size_t at = 0;
    for (const Row& row : rows) {
        const std::size_t end = printed.find('\1', at), after = printed.find('\1', end + 1);
        ASSERT_NE(after, std::string::npos);
        ProgramResult result;
        result.err = printed.substr(at, end - at);
        take_gl(result);  // a picture that cannot be written was drawn
        const std::string error = result.err, status = printed.substr(end + 1, after - end - 1);
        at = after + 1;
        EXPECT_EQ(status, "2") << row.input << ": " << error;
        EXPECT_NE(error.find(row.message), std::string::npos) << row.input << "\ngives " << error;
        EXPECT_EQ(std::ranges::count(error, '\n'), 1) << row.input << ": " << error;
        EXPECT_FALSE(has_control_characters(error)) << row.input;
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{});  // nothing was written
}

}  // namespace
}  // namespace twinlight
