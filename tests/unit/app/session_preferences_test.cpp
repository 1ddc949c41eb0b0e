// What the window remembers.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/session/preferences.h"
#include "base/image/file.h"

namespace twinlight::session::session_preferences_test {
namespace {

TEST(SessionPreferences, AreReadAsTheyWereWritten) {
    const std::string folder = testing::TempDir() + "twinlight-preferences", file = folder + "/a/window.json";
    std::filesystem::remove_all(folder);
    EXPECT_EQ(read_preferences(file), Preferences{});
    const Preferences some{900, 700, "lint", {"shininess", "overlay"}, true, {"/a/b.gl", "/c.gl"}};
    write_preferences(file, some);
    EXPECT_EQ(read_preferences(file), some);
    write_file_atomically(file, "{\"width\": \"wide\"}");
    EXPECT_EQ(read_preferences(file), Preferences{});
    write_preferences("", some);
    write_preferences("/proc/nowhere/window.json", some);
    std::filesystem::remove_all(folder);
}

TEST(SessionPreferences, AreInTheUsersConfigurationFolder) {
    ::setenv("TWINLIGHT_TEST_FOLDER", "/somewhere", 1);
    EXPECT_EQ(users_folder("TWINLIGHT_TEST_FOLDER", ".config"), "/somewhere/twinlight");
    ::setenv("TWINLIGHT_TEST_FOLDER", "not/absolute", 1);
    const char* home = std::getenv("HOME");
    EXPECT_EQ(users_folder("TWINLIGHT_TEST_FOLDER", ".config"),
              home && *home == '/' ? std::string(home) + "/.config/twinlight" : "");
    ::unsetenv("TWINLIGHT_TEST_FOLDER");
}

}  // namespace
}  // namespace twinlight::session::session_preferences_test
