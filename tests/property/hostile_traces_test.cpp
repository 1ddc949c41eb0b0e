// Malicious recordings. Each ends with a picture, if GL's rules allow one, or with one clear line. None takes more than
// seconds, or more memory than its state, and none reads out of bounds (make config=sanitize checks that).
#include "hostile_traces.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "../unit/sanitized.h"
#include "judge/fuzz/random.h"

namespace twinlight::hostile_traces_test {

namespace {

// ---- Text ----

TEST_F(HostileTraces, MayEndAnywhere) {
    const std::string dump =
        "// process.name = \"/bin/a \\\" b\"\n1 @0 glXMakeCurrent(dpy = 0x1, drawable = 2, ctx = 0xa) = True\n"
        "2 @0 glViewport(x = 0, y = 0, width = 32, height = 32) // fake\n"
        "3 @0 glLightfv(light = GL_LIGHT0, pname = GL_POSITION, params = {5, -5.25e-05, 10, 0})\n"
        "4 @0 glGenLists(range = 1) = 1\n5 @0 glGetString(name = GL_VERSION) = \"4.5\"\n"
        "6 @0 glClear(mask = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)\n"
        "7 @0 glVertexPointer(size = 3, type = GL_FLOAT, stride = 0, pointer = blob(\"triangle.bin\")) // fake\n"
        "8 @0 glEnableClientState(array = GL_VERTEX_ARRAY)\n"
        "9 @0 glDrawArrays(mode = GL_TRIANGLES, first = 0, count = 3)\n" +
        kSwap;
    int pictures = 0;
    for (std::size_t length = 0; length < dump.size(); ++length) {
        // Text that does not look like a dump is read as C.
        const std::string told = outcome(dump.substr(0, length), false);
        pictures += told == kPicture ? 1 : 0;
        if (told == kPicture) continue;
        EXPECT_TRUE(told.find("draws nothing") != std::string::npos || length < 110) << length << ": " << told;
    }
    EXPECT_GE(pictures, static_cast<int>(kSwap.size()) - 1);  // the draw is complete
}

TEST_F(HostileTraces, MayBeAnyBytes) {
    fuzz::Random random(1);
    for (int i = 0; i < 100; ++i) {
        std::string noise = i % 2 == 0 ? "// process.name = \"x\"\n" : "1 glBegin(";
        for (int n = random.below(2000); n > 0; --n) noise += static_cast<char>(random.below(256));
        EXPECT_NE(outcome(noise, false), kPicture);
    }
    for (const std::string& front :
         {std::string("\x1b["), std::string("\x1b[1"), std::string("\x1b[1m\x1b["), std::string("\0\0\0\0", 4),
          std::string("at"), std::string("1 a("), std::string()}) {
        EXPECT_NE(outcome(front, false), kPicture) << quoted(front);
    }
}

TEST_F(HostileTraces, MayHaveLinesOfAnyLength) {
    const std::string mega(4 << 20, '7');
    EXPECT_EQ(before_triangle("// " + mega + "\n"), kPicture);
    EXPECT_EQ(before_triangle("2 glGetString(name = \"" + mega + "\") = \"" + mega + "\"\n"), kPicture);
    EXPECT_NE(before_triangle("2 gl" + mega + "()\n"), kPicture);
    EXPECT_NE(before_triangle("2 glEnable(cap = " + mega + ")\n"), kPicture);
    EXPECT_NE(before_triangle("2 glEnable(cap = GL_" + mega + ")\n"), kPicture);
    EXPECT_NE(before_triangle("2 glVertexPointer(3, GL_FLOAT, 0, blob(\"" + mega + "\"))\n"), kPicture);
    EXPECT_NE(before_triangle("2 glLightfv(GL_LIGHT0, GL_POSITION, {" + times(1 << 18, "{") + "\n"), kPicture);
    EXPECT_NE(before_triangle("2 glLightfv(GL_LIGHT0, GL_POSITION, " + times(1 << 20, "a = ") + "\n"), kPicture);
    EXPECT_EQ(before_triangle("2 glDeleteTextures(n = 200000, textures = {" + times(199999, "7, ") + "7})\n"),
              kPicture);
    EXPECT_EQ(before_triangle("2 glLightfv(GL_LIGHT0, GL_POSITION, {1, 2, 3, 4, " + times(200000, "5, ") + "6})\n"),
              kPicture);
}

// GL raises no error for them, so the frame is drawn: with the same finite numbers by all renderers.
TEST_F(HostileTraces, MayHaveNumbersThatAreNotFinite) {
    write("dump.txt", kViewport +
                          "2 glEnable(cap = GL_LIGHTING)\n3 glEnable(cap = GL_LIGHT0)\n"
                          "4 glLightf(light = GL_LIGHT0, pname = GL_LINEAR_ATTENUATION, param = inf)\n"
                          "5 glLightfv(light = GL_LIGHT0, pname = GL_POSITION, params = {0, 0, 1, 1})\n"
                          "6 glMaterialfv(face = GL_FRONT, pname = GL_DIFFUSE, params = {0.5, 0.5, 0.5, nan})\n"
                          "7 glMaterialfv(face = GL_FRONT, pname = GL_EMISSION, params = {0.5, nan, 0.25, 1})\n"
                          "8 glLoadMatrixf(m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, nan, 0, 0, 0, 0, 1})\n" +
                          kTriangle + kSwap);
    const RecordedFrame recorded = make_recorded_frame(load_recording(folder_ / "dump.txt"),
                                                       {.number = {}, .width = kHostileSide, .height = kHostileSide});
    EXPECT_EQ(recorded.error_count, 0u);
    ASSERT_EQ(recorded.notes.size(), 1u);
    EXPECT_NE(recorded.notes[0].find("4 of the program's commands up to this frame have NaN or infinity; the first: "),
              std::string::npos)
        << recorded.notes[0];
    EXPECT_NE(recorded.notes[0].find("dump.txt: call 4 (glLightf)."), std::string::npos) << recorded.notes[0];

    const Image fixed = fixed::render(recorded.scene), expected = reference::render(recorded.scene.frame, {}),
                programmable = shaders()->render(recorded.scene.frame, {});
    const Rgba& inside = expected.at(19, 12);
    EXPECT_NEAR(inside[0], 0.5 + 0.2 * 0.2, 1e-6);  // emission and the scene's ambient light; the light is off
    EXPECT_NEAR(inside[1], 0.2 * 0.2, 1e-6);
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(fixed.at(19, 12)[c], inside[c], 1.01 / 255);
        EXPECT_NEAR(programmable.at(19, 12)[c], inside[c], 1.01 / 255);
    }

    // The report's page and its JSON have the note, too.
    const ProgramResult compared = run_program(
        "twinlight", {"compare", folder_ / "dump.txt", "--size", "16x16", "--json", "-o", folder_ / "report"});
    EXPECT_EQ(compared.status, 0) << compared.err;
    const std::string note = "4 of the program's commands up to this frame have NaN or infinity";
    EXPECT_NE(read_file(folder_ / "report/index.html").find(note), std::string::npos);
    EXPECT_NE(compared.out.find(R"("notes": [)"), std::string::npos) << compared.out;
    EXPECT_NE(compared.out.find("have NaN or infinity"), std::string::npos) << compared.out;

    // What is exported can be read.
    const ProgramResult exported = run_program("twinlight", {"export", folder_ / "dump.txt", "--as", "scene"});
    ASSERT_EQ(exported.status, 0) << exported.err;
    write("again.gl", exported.out);
    const auto again = load_recording(folder_ / "again.gl");
    const Frame frame = make_frame(*again->command_list(), {.width = kHostileSide, .height = kHostileSide});
    EXPECT_EQ(reference::render(frame, {}).pixels, expected.pixels);
}

// Recordings of real programs, with one error at a time.
TEST_F(HostileTraces, AreRealOnesWithMistakes) {
    const std::vector<std::string> replacements = {
        "2147483647", "-2147483648", "4294967295",         "1e300", "-1e-300",         "inf", "nan", "NULL",
        "?",          "{1, 2}",      "blob(\"tiny.bin\")", "\"",    "GL_NO_SUCH_NAME", "0",   "-1"};
    int pictures = 0, told = 0;
    std::uint64_t seed = 0;
    for (const auto& entry : std::filesystem::directory_iterator("tests/traces")) {
        if (!entry.is_directory()) continue;
        for (const auto& blob : std::filesystem::directory_iterator(entry.path())) {
            std::filesystem::copy_file(blob.path(), folder_ / blob.path().filename().string(),
                                       std::filesystem::copy_options::overwrite_existing);
        }
        const std::string dump = read_file(folder_ / "dump.txt");
        for (int i = 0; i < 24; ++i) {
            fuzz::Random random(++seed);
            SCOPED_TRACE(fmt::format("{}, seed {}", entry.path().string(), seed));
            std::string wrong = dump;
            const auto somewhere = [&] {
                return static_cast<std::size_t>(random.below(static_cast<int>(wrong.size())));
            };
            const auto after_line = [&wrong](std::size_t at) {
                return std::min(wrong.find('\n', at), wrong.size() - 1) + 1;
            };
            switch (i % 4) {
                case 0: wrong.resize(somewhere()); break;
                case 1:  // another value
                    for (int n = 0; n < 4; ++n) {
                        const std::size_t value = wrong.find(" = ", somewhere());
                        if (value == std::string::npos) continue;
                        const std::size_t end = std::min(wrong.find_first_of(",)\n", value + 3), wrong.size());
                        wrong.replace(value + 3, end - value - 3,
                                      replacements[static_cast<std::size_t>(
                                          random.below(static_cast<int>(replacements.size())))]);
                    }
                    break;
                case 2:  // other bytes
                    for (int n = 0; n < 3; ++n) wrong[somewhere()] = static_cast<char>(random.below(256));
                    break;
                default: {  // lines moved
                    for (int n = 0; n < 8; ++n) {
                        const std::size_t from = after_line(somewhere()), to = after_line(somewhere());
                        const std::size_t end = from < wrong.size() ? after_line(from) : from;
                        wrong.insert(to, wrong.substr(from, end - from));
                    }
                    break;
                }
            }
            // The reference is slow for the shapes of real programs, so it draws only a few.
            const std::string found = outcome(wrong, i == 1 || i == 3);
            (found == kPicture ? pictures : told) += 1;
        }
    }
    EXPECT_GT(pictures, 50);
    EXPECT_GT(told, 50);
}

// ---- Blobs ----

TEST_F(HostileTraces, NameFilesThatAreNotTheirs) {
    std::filesystem::create_symlink("/etc/passwd", folder_ / "link.bin");
    std::filesystem::create_directory(folder_ / "folder");
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    for (const char* name : {"../dump.txt", "/etc/passwd", "link.bin", "missing.bin", "", ".", "..", "folder", "pipe",
                             "a\\x00b", "folder/x"}) {
        const std::string told =
            before_triangle(fmt::format("2 glVertexPointer(3, GL_FLOAT, 0, blob(\"{}\"))\n", name));
        EXPECT_NE(told.find("dump.txt: call 2: "), std::string::npos) << name << ": " << told;
        EXPECT_NE(told.find("the blob '"), std::string::npos) << name << ": " << told;
    }
}

// ---- The program itself ----

class HostileFiles : public HostileTraces {
  protected:
    // twinlight compare, with at most `megabytes` of memory.
    ProgramResult compare(const std::string& file, int megabytes = 0) {
        const std::string limit = megabytes > 0 && !kSanitized ? fmt::format("ulimit -v {}; ", megabytes << 10) : "";
        return run_shell("twinlight", limit + "ulimit -t 20; \"$PROGRAM\" compare " + quoted(folder_ / file) + " -o " +
                                          quoted(folder_ / "report"));
    }
    void expect_one_line(const ProgramResult& result) {
        EXPECT_EQ(result.status, 2) << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "report"));
    }
};

TEST_F(HostileFiles, EndInOneLineAndStatus2) {
    write(
        "bomb.txt",
        kViewport + "glNewList(1, GL_COMPILE)\nglCallList(1)\nglCallList(1)\nglEndList()\nglCallList(1)\n" + kTriangle);
    expect_one_line(compare("bomb.txt", 1500));
    write("blob.txt", kViewport + "glVertexPointer(3, GL_FLOAT, 0, blob(\"../../etc/passwd\"))\n" + kTriangle);
    expect_one_line(compare("blob.txt", 1500));
    write("noise.trace", std::string("at\x10\0\0\0", 6) + std::string(5000, '\xa5'));
    expect_one_line(compare("noise.trace"));
    write("text.trace", "glEnable(GL_LIGHTING);\n");
    expect_one_line(compare("text.trace"));
    write("zip.trace", std::string("\x1f\x8b\x08\0\0\0\0\0", 8) + std::string(5000, '\0'));
    expect_one_line(compare("zip.trace"));
    write("empty.trace", "");
    expect_one_line(compare("empty.trace"));
}

TEST_F(HostileFiles, MayHaveNoEnd) {
    for (const std::string& arguments :
         {"render /dev/zero --with reference -o " + quoted(folder_ / "report"), std::string("explain /dev/zero"),
          std::string("export /dev/zero --as c"), std::string("check /dev/zero"),
          "study /dev/zero -o " + quoted(folder_ / "report"),
          "study --merge /dev/zero -o " + quoted(folder_ / "report")}) {
        SCOPED_TRACE(arguments);
        const std::string limit = kSanitized ? "" : "ulimit -v 3000000; ";
        expect_one_line(run_shell("twinlight", limit + "ulimit -t 20; \"$PROGRAM\" " + arguments));
    }
}

// The state of each of these would be many gigabytes.
TEST_F(HostileFiles, StayWithinTheMemoryOfWhatTheyKeep) {
    const std::filesystem::path large = folder_ / "large.bin";
    write("large.bin", "");
    std::filesystem::resize_file(large, std::uintmax_t{200} << 20);  // no bytes on the disk
    const std::string pointers =
        times(12, "glVertexPointer(3, GL_FLOAT, 0, blob(\"large.bin\"))\nglPushClientAttrib(2)\n");
    write("pointers.txt", kViewport + pointers + kTriangle);
    expect_one_line(compare("pointers.txt", 3000));
    // Skipped one after the other.
    write("streams.txt",
          kViewport + times(6, "glVertexPointer(3, GL_FLOAT, 0, blob(\"large.bin\"))\n") + kTriangle + kSwap);
    const ProgramResult streams = compare("streams.txt", 2500);
    EXPECT_EQ(streams.status, 0) << streams.err;
    std::filesystem::remove_all(folder_ / "report");
    // One texture for each draw.
    write("textures.txt",
          kViewport +
              "glEnable(GL_TEXTURE_2D)\nglTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)\n"
              "glTexImage2D(GL_TEXTURE_2D, 0, 3, 2048, 2048, 0, GL_RGB, GL_FLOAT, NULL)\n" +
              times(100, kTriangle + "glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_FLOAT, NULL)\n"));
    expect_one_line(compare("textures.txt", 3000));
    std::string many = kViewport;
    for (int i = 1; i < 40; ++i) {
        many += fmt::format(
            "glBindTexture(GL_TEXTURE_2D, {})\nglTexImage2D(GL_TEXTURE_2D, 0, 3, 4096, 1024, 0, GL_RGB, "
            "GL_FLOAT, NULL)\n",
            i);
    }
    write("many.txt", many + kTriangle);
    expect_one_line(compare("many.txt", 3000));
}

}  // namespace

}  // namespace twinlight::hostile_traces_test
