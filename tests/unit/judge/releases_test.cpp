// Which measured release a driver counts as, and which releases a range contains.
#include "judge/compare/releases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace twinlight::compare::releases_test {
namespace {

Driver driver(const std::string& version) { return parse_driver_name("llvmpipe, 4.5 " + version + ", EGL"); }

std::string_view newest(std::string_view maker) {
    std::string_view last;
    for (const std::string_view release : kMeasuredReleases)
        if (release.starts_with(maker)) last = release;
    return last;
}

TEST(Releases, CountAsAMeasuredOne) {
    struct Row {
        const char* version;
        std::string_view release;
    };
    for (const Row& row : {
             Row{"Mesa 22.3.6", "Mesa 22.3"},
             Row{"Mesa 25.0.7", "Mesa 25.0"},
             Row{"Mesa 25.1.0-devel", "Mesa 25.1"},
             Row{"Mesa 24.0.5", "Mesa 22.3"},  // between two: as the older one
             Row{"Mesa 25.10.1", "Mesa 25.1"},
             Row{"Mesa 22.2.9", "Mesa 22.3"},  // before all: as the oldest
             Row{"Mesa 7.11", "Mesa 22.3"},
             Row{"Mesa 99.1.0", newest("Mesa")},
             Row{"Mesa 100.0.0", newest("Mesa")},
             Row{"NVIDIA 580.159.04", "NVIDIA 580"},
             Row{"NVIDIA 535.54.03", "NVIDIA 580"},
             Row{"NVIDIA 610.1", newest("NVIDIA")},
             Row{"AMD 26.1", ""},
             Row{"Mesa-like 25.0", ""},
             Row{"", ""},
         })
        EXPECT_EQ(counts_as(driver(row.version)), row.release) << row.version;
    EXPECT_EQ(counts_as({}), "");
}

TEST(Releases, WereMeasuredWithTheirPatches) {
    for (const std::string_view release : kMeasuredReleases) {
        EXPECT_TRUE(has_measured_release(driver(std::string(release) + ".4"))) << release;
        EXPECT_EQ(measured_note(driver(std::string(release) + ".4")), "");
        EXPECT_EQ(unmeasured_words(driver(std::string(release) + ".4")), "");
        EXPECT_EQ(counts_as(driver(std::string(release) + ".4")), release);  // in order
    }
    for (const char* version : {"Mesa 24.0.5", "Mesa 99.1.0", "NVIDIA 535.54.03", "AMD 26.1", ""})
        EXPECT_FALSE(has_measured_release(driver(version))) << version;
}

TEST(Releases, SayWhichWasMeasured) {
    EXPECT_EQ(measured_note(driver("Mesa 24.0.5")), "measured on Mesa 22.3; this is 24.0.5");
    EXPECT_EQ(measured_note(driver("Mesa 24.0.5-1ubuntu0.3")), "measured on Mesa 22.3; this is 24.0.5");
    EXPECT_EQ(measured_note(driver("NVIDIA 535.54.03")), "measured on NVIDIA 580; this is 535.54.03");
    EXPECT_EQ(unmeasured_words(driver("Mesa 24.0.5")),
              "Mesa 24.0.5 was not measured and counts as Mesa 22.3: bugs that it fixed or added are not listed.");
    EXPECT_EQ(measured_note(driver("Mesa 25.1.0-devel")), "");
    for (const char* version : {"AMD 26.1", ""}) {
        EXPECT_EQ(measured_note(driver(version)), "") << version;
        EXPECT_EQ(unmeasured_words(driver(version)), "") << version;
    }
}

TEST(Releases, AreARangeOfNumbers) {
    struct Row {
        Releases releases;
        const char* version;
        bool is_in;
    };
    for (const Row& row : {
             Row{{}, "Mesa 22.3.6", true},
             Row{{}, "", true},
             Row{{.before = "25.0"}, "Mesa 24.3.9", true},
             Row{{.before = "25.0"}, "Mesa 9.2.1", true},
             Row{{.before = "25.0"}, "Mesa 25.0.0", false},
             Row{{.before = "25.0"}, "Mesa 100.0.0", false},
             Row{{.before = "25.0"}, "", false},
             Row{{.from = "25.0"}, "Mesa 24.3.9", false},
             Row{{.from = "25.0"}, "Mesa 25.0.0-devel", true},
             Row{{.from = "25.0"}, "Mesa 100.0.0", true},
             Row{{.from = "25.0"}, "", false},
             Row{{.from = "25.0", .before = "26.1"}, "Mesa 26.0.3", true},
             Row{{.from = "25.0", .before = "26.1"}, "Mesa 26.1.0", false},
             Row{{.from = "25.0", .before = "26.1"}, "Mesa 22.3.6", false},
             Row{{.from = "580.159"}, "NVIDIA 580.159.04", true},
             Row{{.from = "580.159"}, "NVIDIA 580.82.07", false},
         })
        EXPECT_EQ(row.releases.contain(driver(row.version)), row.is_in)
            << row.releases.from << " to " << row.releases.before << ": " << row.version;
}

}  // namespace
}  // namespace twinlight::compare::releases_test
