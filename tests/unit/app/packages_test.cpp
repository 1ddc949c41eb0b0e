// tools/deps.sh, which `make deps` runs: apt installs what is missing, and other systems get the names of their packages.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"

namespace twinlight::packages_test {
namespace {

namespace fs = std::filesystem;

using Programs = std::map<std::string, std::string>;  // a name, and its shell script

// A system with the usual tools and these programs, each a shell script.
class System {
  public:
    explicit System(const Programs& programs) {
        for (const char* tool : {"sh", "awk", "sed", "tr", "grep", "cat", "env"}) {
            const std::string path = run_shell("", fmt::format("command -v {}", tool)).out;
            fs::create_symlink(path.substr(0, path.find('\n')), folder_ / tool);
        }
        for (const auto& [name, script] : programs) {
            write_file_atomically(folder_ / name, "#!/bin/sh\n" + script);
            fs::permissions(folder_ / name, fs::perms::owner_all);
        }
    }
    // Runs tools/deps.sh where these lines of DEPENDENCIES hold.
    ProgramResult deps(const std::string& lines) const {
        return run_shell(
            "", fmt::format("env -i PATH={} DEPENDENCIES={} sh tools/deps.sh", quoted(folder_ / ""), quoted(lines)));
    }
    std::string log() const { return read_file(folder_ / "log"); }

  private:
    TemporaryFolder folder_;
};

constexpr const char* kMissing =
    "g++ false\nlibosmesa6|libegl-mesa0 false\nlibglm-dev true\nlibjs-chart.js false\nxvfb false\n";

TEST(Packages, OfOtherSystemsAreNamedAndNotInstalled) {
    struct Row {
        const char *manager, *system, *packages;
    };
    for (const Row& row : {Row{"dnf", "Fedora", "dnf install gcc-c++ mesa-libEGL xorg-x11-server-Xvfb\n"},
                           Row{"pacman", "Arch", "pacman -S --needed gcc mesa xorg-server-xvfb\n"},
                           Row{"zypper", "openSUSE", "zypper install gcc-c++ Mesa-libEGL1 xorg-x11-server-Xvfb\n"}}) {
        const ProgramResult result = System(Programs{{row.manager, "echo ran >&2; exit 9"}}).deps(kMissing);
        EXPECT_EQ(result.status, 1);
        EXPECT_EQ(result.out, "");
        for (const std::string& words :
             {std::string(row.packages), std::string("not tried"), std::string("Nothing was installed"),
              fmt::format("{} has no package of these: libjs-chart.js\n", row.system)})
            EXPECT_NE(result.err.find(words), std::string::npos) << words << " is not in:\n" << result.err;
        EXPECT_EQ(result.err.find("ran\n"), std::string::npos);
    }
}

TEST(Packages, HaveDebiansNamesWhereTheSystemIsNotKnown) {
    const ProgramResult result = System(Programs{}).deps(kMissing);
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find(" g++ libegl-mesa0 libjs-chart.js xvfb\n"), std::string::npos) << result.err;
}

TEST(Packages, AreNotLookedForIfNothingIsMissing) {
    const ProgramResult result = System(Programs{}).deps("g++ true\n");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out + result.err, "");
}

// Mesa 25.1 was the last with OSMesa.
TEST(Packages, TakeEglWhereAptHasNoOsmesa) {
    for (const bool has_osmesa : {false, true}) {
        const System system(Programs{{"id", "echo 0"},
                                     {"apt-get", "echo \"$*\" >>\"${0%/*}/log\""},
                                     {"apt-cache", fmt::format("case $2 in libosmesa6) echo \"  Candidate: {}\" ;; "
                                                               "*) echo \"  Candidate: 1.0\" ;; esac",
                                                               has_osmesa ? "25.0" : "(none)")}});
        const ProgramResult result = system.deps(kMissing);
        EXPECT_EQ(result.status, 1);  // this apt-get installs nothing
        EXPECT_NE(result.err.find("Still missing"), std::string::npos);
        const std::string mesa = has_osmesa ? "libosmesa6" : "libegl-mesa0";
        EXPECT_EQ(system.log(),
                  "update -qq\ninstall -y --no-install-recommends g++ " + mesa + " libjs-chart.js xvfb\n");
    }
}

// Every row of the table is about a package that the Makefile names.
TEST(Packages, OfTheTableAreThoseOfTheMakefile) {
    const std::string makefile = read_file("Makefile");
    std::istringstream table(read_file("tools/package-names"));
    int rows = 0;
    for (std::string line; std::getline(table, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream words(line);
        std::vector<std::string> row;
        for (std::string word; words >> word;) row.push_back(word);
        ASSERT_EQ(row.size(), 4u) << line;
        int named = 0;
        for (const char* before : {"\n", ",", "|"})
            for (const char* after : {" ", "|"}) named += makefile.find(before + row[0] + after) != std::string::npos;
        EXPECT_GT(named, 0) << row[0];
        ++rows;
    }
    EXPECT_GT(rows, 20);
}

TEST(Packages, AreNotAskedForByMakePrograms) {
    const TemporaryFolder folder;
    for (const char* name : {"apt-get", "apt-cache", "apt", "dpkg", "dpkg-query", "sudo"}) {
        write_file_atomically(folder / name, "#!/bin/sh\necho \"$0 $*\" >>\"${0%/*}/log\"\nexit 9\n");
        fs::permissions(folder / name, fs::perms::owner_all);
    }
    const ProgramResult result = run_shell(
        "", fmt::format("env -u MAKEFLAGS -u MAKELEVEL PATH={}:\"$PATH\" make -n programs", quoted(folder / "")));
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_FALSE(fs::exists(folder / "log")) << read_file(folder / "log");
}

}  // namespace
}  // namespace twinlight::packages_test
