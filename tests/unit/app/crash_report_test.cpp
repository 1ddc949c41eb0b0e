// A crash is blamed on the GL driver only where it happened in a call of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string>

#include "../run_program.h"
#include "../sanitized.h"
#include "base/image/file.h"

namespace twinlight::crash_report_test {
namespace {

class Crashes : public testing::Test {
  protected:
    // A library with this function crashes instead of the one of this name. `variable` says how it is loaded: LD_PRELOAD, or TWINLIGHT_GL;
    // then it has all other functions of GL from the usual library. The shell may add a line of its own, so only the first one counts.
    ProgramResult crash_in(const std::string& variable, const std::string& library, const std::string& function,
                           const std::string& before = "") {
        const std::string gl = run_shell("twinlight", "\"$PROGRAM\" check light-none").gl,
                          usual = gl.substr(gl.rfind('(') + 1, gl.rfind(')') - gl.rfind('(') - 1);
        write_file_atomically(folder_ / "crash.c", function);
        ProgramResult result = run_shell(
            "twinlight", "cc -shared -fPIC -O0 -o " + quoted(folder_ / library) + " " + quoted(folder_ / "crash.c") +
                             " -Wl,--no-as-needed " + quoted(usual) + " || exit 77; " + before + " " + variable + "=" +
                             quoted(folder_ / library) + " \"$PROGRAM\" check light-none");
        result.err.resize(std::min(result.err.find('\n') + 1, result.err.size()));
        return result;
    }

    const TemporaryFolder folder_;
};

TEST_F(Crashes, SentByAnotherProcessSayWhich) {
    if (kSanitized) GTEST_SKIP() << "the sanitizer reports crashes itself";
    const ProgramResult result =
        run_shell("twinlight",
                  "timeout --foreground --preserve-status -s SEGV 0.5 \"$PROGRAM\" fuzz --count 1000000 >/dev/null & "
                  "echo $!; wait $!");
    EXPECT_EQ(result.status, 128 + SIGSEGV);
    EXPECT_EQ(result.err, "twinlight: process " + result.out.substr(0, result.out.size() - 1) +
                              " ended this program with SIGSEGV\n");
}

TEST_F(Crashes, NameTheDriverOnlyWhereItCrashed) {
    if (kSanitized) GTEST_SKIP() << "the sanitizer reports crashes itself";
    if (run_shell("", "command -v cc").status != 0) GTEST_SKIP() << "there is no C compiler";
    const std::string segv = "void glBegin(int mode) { *(volatile int*)0 = mode; }\n",
                      abort = "#include <stdlib.h>\nint isatty(int file) { abort(); }\n";

    const ProgramResult driver = crash_in("TWINLIGHT_GL", "libGLcrash.so", segv);
    EXPECT_EQ(driver.status, 128 + SIGSEGV);
    EXPECT_EQ(driver.err,
              "twinlight: crashed (SIGSEGV) in libGLcrash.so, during a call of the GL driver; the environment variable "
              "GALLIUM_DRIVER, set to llvmpipe or softpipe, chooses another driver. If that crashes too, please report "
              "the scene.\n");

    const ProgramResult other = crash_in("TWINLIGHT_GL", "libother.so", segv);
    EXPECT_EQ(other.status, 128 + SIGSEGV);
    EXPECT_EQ(
        other.err,
        "twinlight: crashed (SIGSEGV) in libother.so, which it called; please report the command and the scene.\n");

    // Named as the C library, which runs what its caller wants.
    const ProgramResult own = crash_in("LD_PRELOAD", "libc.so.crash", abort);
    EXPECT_EQ(own.status, 128 + SIGABRT);
    EXPECT_EQ(own.err, "twinlight: crashed (SIGABRT) in its own code; please report the command and the scene.\n");

    const ProgramResult memory =
        crash_in("TWINLIGHT_GL", "libGLcrash.so",
                 "#include <stdlib.h>\n#include <sys/mman.h>\nvoid glBegin(int mode) {\n"
                 "    for (size_t size = 1 << 30; size >= 1 << 20; size /= 2)\n"
                 "        while (mmap(0, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED) {}\n"
                 "    abort();\n}\n",
                 "ulimit -v 2000000;");
    EXPECT_EQ(memory.status, 128 + SIGABRT);
    EXPECT_EQ(memory.err, "twinlight: out of memory (SIGABRT); try a smaller --size\n");
}

TEST(GalliumDriver, ThatIsNotThereIsOneLine) {
    for (const char* name : {"nope", "zink"}) {
        const ProgramResult result =
            run_shell("twinlight", "GALLIUM_DRIVER=" + std::string(name) + " \"$PROGRAM\" check light-none");
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find("the environment variable GALLIUM_DRIVER is '" + std::string(name) +
                                  "'; set it to llvmpipe or softpipe, or unset it\n"),
                  std::string::npos)
            << result.err;
        EXPECT_EQ(result.err.find('\n'), result.err.size() - 1);
    }
}

}  // namespace
}  // namespace twinlight::crash_report_test
