// The gate against code that grows slow: instructions counted by callgrind, which repeat where times do not. Counts belong to
// a compiler and a C library; tests/instructions/counts.txt has them by both.
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "../unit/run_program.h"
#include "../unit/sanitized.h"
#include "base/image/file.h"
#include "counted_work.h"

namespace twinlight::instructions_test {
namespace {

constexpr const char* kFile = "tests/instructions/counts.txt";
constexpr double kTolerance = 0.005;  // where memory lies changes a count a little; code that changes, more

#ifdef __OPTIMIZE__
constexpr bool kOptimised = true;
#else
constexpr bool kOptimised = false;
#endif

#ifdef __clang__
constexpr const char* kCompiler = "clang " __clang_version__;
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

std::string machine() { return fmt::format("{}, glibc {}", kCompiler, ::gnu_get_libc_version()); }

using Counts = std::map<std::string, double>;

// "machine: work count"
std::map<std::string, Counts> kept_counts() {
    std::map<std::string, Counts> kept;
    if (!std::filesystem::exists(kFile)) return kept;
    std::istringstream lines(read_file(kFile));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        const std::size_t colon = line.rfind(": ");
        std::istringstream rest(line.substr(colon + 2));
        std::string work;
        double count = 0;
        rest >> work >> count;
        kept[line.substr(0, colon)][work] = count;
    }
    return kept;
}

void write_counts(std::map<std::string, Counts> all) {
    std::string text =
        "# Instructions of the work in counted_work.cpp, by compiler and C library. `make instructions` counts them "
        "anew.\n";
    for (const auto& [name, counts] : all)
        for (const auto& [work, count] : counts) text += fmt::format("{}: {} {:.0f}\n", name, work, count);
    write_file_atomically(kFile, text);
}

// The C library chooses among its functions by the processor: here those that any x86-64 has. What an allocation costs hangs on
// what was freed before: less where the C library keeps what is freed by its size, with nothing to join or to split.
constexpr const char* kAnyProcessor =
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX512BW,-AVX2,-AVX,-FMA,-FMA4,-BMI2,-ERMS,-FSRM,-SSE4_2,"
    "-SSE4_1,-SSSE3:glibc.malloc.tcache_count=60000:glibc.malloc.tcache_max=4194304 ";

// What callgrind counts inside the functions, with all that they call.
Counts counted() {
    const TemporaryFolder folder;
    const std::string out = folder / "callgrind.out";
    const ProgramResult run = run_shell(
        "twinlight-tests",
        std::string(kAnyProcessor) +
            "valgrind --quiet --tool=callgrind --toggle-collect='counted_*' --callgrind-out-file=" + quoted(out) +
            " \"$PROGRAM\" --gtest_filter='CountedWork.*' --gtest_brief=1 && "
            "callgrind_annotate --inclusive=yes --threshold=100 " +
            quoted(out));
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    // "1,234,567 (12.3%)  tests/instructions/counted_work.cpp:counted_read [/path/of/the/program]"
    Counts counts;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(":counted_");
        if (at == line.npos) continue;
        std::string digits;
        for (const char c : line.substr(0, line.find('(')))
            if (c >= '0' && c <= '9') digits += c;
        const std::string name = line.substr(at + 1, line.find(' ', at) - at - 1);
        counts[name] = std::max(counts[name], std::stod(digits));
    }
    return counts;
}

// The work itself, which callgrind runs by this name.
TEST(CountedWork, IsDone) {
    counted::prepare();
    EXPECT_GT(counted::counted_read(), 1000u);
    EXPECT_GT(counted::counted_state(), 100u);
    counted::prepare_plans();
    EXPECT_GT(counted::counted_plan(), 100u);
    EXPECT_EQ(counted::counted_reference(), 65u * 33u);
    EXPECT_EQ(counted::counted_patches(), (64u * 32 * 2 * 3 + 4094) / 4095);
}

TEST(Instructions, StayWithinHalfAPercent) {
    if (!kOptimised || kSanitized) GTEST_SKIP() << "counts are of the release build";
    if (run_shell("", "command -v valgrind").status != 0) GTEST_SKIP() << "valgrind is not installed";
    std::map<std::string, Counts> kept = kept_counts();
    const bool writes = std::getenv("TWINLIGHT_WRITE_INSTRUCTIONS") != nullptr;
    if (!writes && !kept.contains(machine()))
        GTEST_SKIP() << kFile << " has no counts for " << machine() << "; make instructions counts them";
    const Counts now = counted();
    if (writes) {
        kept[machine()] = now;
        return write_counts(kept);
    }
    const Counts& before = kept[machine()];
    for (const auto& [work, count] : now) {
        ASSERT_TRUE(before.contains(work)) << work << " is not in " << kFile << "; make instructions counts it";
        const double change = count / before.at(work) - 1;
        fmt::print("{:<20} {:>12.0f} instructions, {:+.2f} %\n", work, count, 100 * change);
        EXPECT_LE(std::abs(change), kTolerance)
            << work
            << fmt::format(": {:+.1f} % since {} was written. Where that is meant, make instructions", 100 * change,
                           kFile);
    }
    EXPECT_EQ(now.size(), before.size());
}

}  // namespace
}  // namespace twinlight::instructions_test
