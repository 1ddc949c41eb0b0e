// Each allocation is refused once: a command then prints one line, ends with status 2 and leaves nothing behind. It never gives another
// result. The driver's own memory is not refused, so these commands use no driver.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "../effort.h"
#include "../run_program.h"
#include "app/cli/command_line.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "judge/report/report.h"
#include "refused_memory.h"
#include "render/reference/reference.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"

namespace twinlight::out_of_memory_test {
namespace {

struct Outcome {
    int status = 0;
    std::string out, err;
    std::vector<std::string> files;  // names and contents
};

class OutOfMemory : public testing::Test {
  protected:
    // Runs the work with each allocation refused that is tried, alone or with all later ones.
    void try_all(const std::string& name, const std::function<int()>& work) {
        long count = 0;
        const Outcome whole = outcome(work, RefusedMemory::kNone, false, &count);
        ASSERT_LT(whole.status, 2) << name << ": " << whole.err;
        std::mt19937 random(1);
        int refused = 0;
        for (long number = 1; number <= count; number = next(number, count, random)) {
            const bool all_later = number % 3 == 0;
            const Outcome one = outcome(work, number, all_later);
            const std::string at = name + ", allocation " + std::to_string(number) + " of " + std::to_string(count) +
                                   (all_later ? " and all later" : "");
            if (one.status == whole.status) {  // it did without
                EXPECT_EQ(one.out, whole.out) << at;
                EXPECT_EQ(one.err, whole.err) << at;
                EXPECT_EQ(one.files, whole.files) << at;
            } else {
                ++refused;
                EXPECT_EQ(one.status, 2) << at;
                // What comes after the result may lack memory, too.
                EXPECT_TRUE(one.out.empty() || one.out == whole.out) << at << "\n" << one.out;
                EXPECT_TRUE(one.files == before_ || one.files == whole.files)
                    << at << testing::PrintToString(one.files);
                EXPECT_EQ(one.err, "twinlight: out of memory; try a smaller --size\n") << at;
            }
            if (HasFailure()) break;
        }
        if (tries_all()) std::printf("%s: %ld allocations\n", name.c_str(), count);
        EXPECT_GT(refused, 15) << name;
    }
    void try_command(std::vector<std::string> words) {
        const std::string name = words[0] + " " + words[1];
        try_all(name, [words = std::move(words)]() mutable {
            std::string program = "twinlight";
            std::vector<char*> arguments = {program.data()};
            for (std::string& word : words) arguments.push_back(word.data());
            arguments.push_back(nullptr);
            return cli::run(static_cast<int>(arguments.size()) - 1, arguments.data());
        });
    }
    // Writes a file that the work reads.
    std::string input(const std::string& name, const std::string& text) {
        write_file_atomically(folder_ / name, text);
        before_.push_back(name + ": " + text);
        std::ranges::sort(before_);
        return folder_ / name;
    }
    std::string output(const std::string& name) const { return folder_ / name; }

  private:
    // All of the first and of the last, when files are written, and some between them. ALL_CASES: every one, or 10,000 evenly spread if
    // there are more.
    static long next(long number, long count, std::mt19937& random) {
        constexpr long kFirst = 10, kLast = 24;
        if (number < kFirst || number >= count - kLast) return number + 1;
        if (tries_all()) return std::min(number + std::max(1L, count / 10'000), count - kLast);
        return std::min(number + std::uniform_int_distribution<long>(1, number)(random), count - kLast);
    }
    std::vector<std::string> files() const {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.str())) {
            const std::string name = entry.path().lexically_relative(folder_.str());
            all.push_back(name + ": " + (entry.is_regular_file() ? read_file(entry.path()) : "a folder"));
        }
        std::ranges::sort(all);
        return all;
    }
    // In a process of its own, which ends as the program does.
    Outcome outcome(const std::function<int()>& work, long number, bool all_later, long* count = nullptr) {
        const TemporaryFolder printed;
        const std::string out = printed / "out", err = printed / "err";
        std::array<int, 2> counted{};
        EXPECT_EQ(::pipe(counted.data()), 0);
        std::fflush(nullptr);
        const pid_t child = ::fork();
        if (child == 0) {
            ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
            ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
            const RefusedMemory refused(number, all_later);
            const int status = run_reporting_errors("twinlight", work);
            const long allocations = refused.allocations();
            const bool is_counted = ::write(counted[1], &allocations, sizeof allocations) == sizeof allocations;
            std::fflush(nullptr);
            ::_exit(is_counted ? status : 99);
        }
        ::close(counted[1]);
        int status = 0;
        ::waitpid(child, &status, 0);
        long allocations = 0;
        if (::read(counted[0], &allocations, sizeof allocations) == sizeof allocations && count) *count = allocations;
        ::close(counted[0]);
        Outcome result;
        result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        result.out = read_file(out);
        result.err = read_file(err);
        result.files = files();
        for (const auto& entry : std::filesystem::directory_iterator(folder_.str()))
            if (std::ranges::none_of(before_, [&](const std::string& file) {
                    return file.starts_with(entry.path().filename().string() + ": ");
                }))
                std::filesystem::remove_all(entry.path());
        return result;
    }

    const TemporaryFolder folder_;
    std::vector<std::string> before_;
};

const std::string kScene = R"(// A lit cube with a texture, blended, and a display list.
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT1);
glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){1, 2, 3, 1});
glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 30);
GLubyte texels[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
glEnable(GL_TEXTURE_2D);
glNewList(1, GL_COMPILE);
glBegin(GL_QUADS); glNormal3f(0, 0, 1);
glTexCoord2f(0, 0); glVertex3f(-0.8, -0.8, 0); glTexCoord2f(0, 1); glVertex3f(-0.8, 0.8, 0.1);
glTexCoord2f(1, 1); glVertex3f(0.8, 0.8, 0.2); glTexCoord2f(1, 0); glVertex3f(0.8, -0.8, 0.3);
glEnd();
glEndList();
glRotatef(30, 0, 1, 0); glCallList(1);
glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE);
glutSolidCube(0.5);
)";

const std::string kDump = R"(0 glViewport(x = 0, y = 0, width = 32, height = 24)
1 glEnable(cap = GL_LIGHTING)
2 glEnable(cap = GL_LIGHT0)
3 glBegin(mode = GL_TRIANGLES)
4 glVertex2f(x = -0.5, y = -0.5)
5 glVertex2f(x = 0.5, y = -0.5)
6 glVertex2f(x = 0, y = 0.5)
7 glEnd()
8 glXSwapBuffers(dpy = 0x1, drawable = 2)
)";

TEST_F(OutOfMemory, OfExplainIsOneLine) {
    const std::string scene = input("scene.gl", kScene);
    try_command({"explain", scene, "--size", "32x24"});
    try_command({"explain", scene, "--size", "32x24", "--json"});
}

TEST_F(OutOfMemory, OfExportIsOneLine) {
    const std::string scene = input("scene.gl", kScene);
    for (const char* form : {"c", "glsl", "scene", "html"}) try_command({"export", scene, "--as", form});
    try_command({"export", scene, "--as", "glsl", "-o", output("shaders")});
    try_command({"export", scene, "--as", "html", "-o", output("page.html")});
    try_command({"export", scene, "--as", "wgsl", "-o", output("wgsl")});
}

TEST_F(OutOfMemory, OfLintAndLessonsIsOneLine) {
    const std::string scene = input("scene.gl", kScene);
    try_command({"lint", scene, "--size", "32x24"});
    try_command({"lint", scene, "--json"});
    const std::string right = input("right.gl", read_file("tests/lessons/shininess/right-1.gl"));
    try_command({"lesson", "shininess", "--check", right});
    try_command({"lesson", "shininess", "-o", output("start.gl")});
    try_command({"scenes", "--json"});
}

TEST_F(OutOfMemory, OfTheReferenceIsOneLine) {
    const std::string scene = input("scene.gl", kScene);
    try_all("reference", [&] {
        const std::shared_ptr<const Recording> recording = load_recording(scene, WindowSize{48, 40});
        const Frame frame = make_frame(*recording->command_list(), {.width = 48, .height = 40});
        write_png(output("picture.png"), reference::render(frame, {}));
        return kFine;
    });
    const std::string dump = input("dump.txt", kDump);
    try_all("recording", [&] {
        const RecordedFrame frame = make_recorded_frame(load_recording(dump, std::nullopt), {});
        write_png(output("picture.png"), reference::render(frame.scene.frame, {{.shading = Shading::kPhong}}));
        return kFine;
    });
}

// The reference draws every picture here, because it needs no driver.
TEST_F(OutOfMemory, OfAComparisonIsOneLine) {
    const std::string scene_file = input("scene.gl", kScene);
    compare::Renderers renderers;
    renderers.fixed = [](const Scene& scene, const fixed::Options& options) {
        return reference::render(scene.frame, {{.shading = options.shading}});
    };
    renderers.programmable = [](const Frame& frame, const programmable::Options& options) {
        return reference::render(frame, {options});
    };
    renderers.reference = reference::render;
    renderers.allowed_difference = [](const Frame& frame, const reference::Options& options) {
        return reference::allowed_difference(frame, options);
    };
    try_all("compare", [&] {
        const auto list = load_recording(scene_file, WindowSize{32, 24});
        const Scene scene{list, make_frame(*list->command_list(), {.width = 32, .height = 24})};
        compare::Comparison comparison =
            compare::compare_scene(scene, {.driver = "test", .per_pixel = Shading::kPhong}, renderers);
        for (compare::Render& render : comparison.renders) render.ms = 1;
        const std::string text = report::comparison_json(comparison);
        report::write_report(comparison, output("report"));
        write_result(text);
        return comparison.within_tolerance() ? kFine : kDifferent;
    });
}

}  // namespace
}  // namespace twinlight::out_of_memory_test
