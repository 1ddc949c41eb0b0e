// #pragma twinlight texture("file.png"): pictures, equivalent commands, and files that it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "../pictures.h"
#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "scene/command/text.h"
#include "scene/scenes/images.h"
#include "scene/state/state.h"

namespace twinlight::texture_files_test {
namespace {

namespace fs = std::filesystem;

constexpr Rgba kRedPixel{1, 0, 0, 1}, kBluePixel{0, 0, 1, 1};

// Red above blue.
Image red_above_blue() {
    Image image(2, 2);
    image.pixels = {kRedPixel, kRedPixel, kBluePixel, kBluePixel};
    return image;
}

// The picture fills the window, upright.
constexpr const char* kScene = R"(
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glEnable(GL_TEXTURE_2D);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
#pragma twinlight texture("picture.png")
glBegin(GL_QUADS);
glTexCoord2f(0, 0); glVertex2f(-1, -1);
glTexCoord2f(1, 0); glVertex2f(1, -1);
glTexCoord2f(1, 1); glVertex2f(1, 1);
glTexCoord2f(0, 1); glVertex2f(-1, 1);
glEnd();
)";

class TextureFiles : public testing::Test {
  protected:
    TextureFiles() {
        write_png(in_ / "picture.png", red_above_blue());
        write_file_atomically(in_ / "scene.gl", kScene);
    }
    static ProgramResult run(const std::vector<std::string>& arguments) { return run_program("twinlight", arguments); }

    // A scene with this picture is refused with one error, at the place of the name.
    void expect_refused(const std::string& picture, const std::string& expected) {
        write_file_atomically(in_ / "refused.gl", "#pragma twinlight texture(" + picture + ")\nglutSolidCube(1);\n");
        const ProgramResult result = run({"render", in_ / "refused.gl", "--with", "reference", "-o", in_ / "p.png"});
        EXPECT_EQ(result.status, 2) << picture;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 3) << result.err;  // the error, the line, the caret
        EXPECT_TRUE(result.err.starts_with(in_ / "refused.gl:1:27: ")) << result.err;
        EXPECT_NE(result.err.find(expected), std::string::npos) << result.err << "  expected: " << expected;
        EXPECT_FALSE(fs::exists(in_ / "p.png"));
    }

    const TemporaryFolder in_, out_;
};

TEST_F(TextureFiles, AreDrawnUprightByAllRenderers) {
    for (const char* renderer : {"fixed", "shaders", "reference"}) {
        const std::string path = out_ / (std::string(renderer) + ".png");
        const ProgramResult result =
            run({"render", in_ / "scene.gl", "--with", renderer, "--size", "32x32", "-o", path});
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        const Image image = read_png(path);
        EXPECT_EQ(image.at(16, 4), kRedPixel) << renderer;
        EXPECT_EQ(image.at(16, 28), kBluePixel) << renderer;
    }
    EXPECT_EQ(run({"compare", in_ / "scene.gl", "--size", "32x32", "-o", out_ / "report"}).status, 0);
}

TEST_F(TextureFiles, AreFoundFromEveryFolder) {
    const ProgramResult result = run_shell("twinlight", "PROGRAM=$(realpath \"$PROGRAM\"); cd " + quoted(in_.str()) +
                                                            " && \"$PROGRAM\" render scene.gl --with reference "
                                                            "--size 8x8 -o p.png");
    EXPECT_EQ(result.status, 0) << result.err;
}

// A size that is not a power of two, so GLU scales the pixels. The result is the same as from an array, in a display
// list too.
TEST(TextureFile, EqualsGluBuild2DMipmapsOfItsPixels) {
    std::string bytes;
    ImageFile image{5, 3, {}};
    for (int i = 0; i < 5 * 3 * 4; ++i) {
        image.rgba.push_back(static_cast<std::byte>(i * 37 % 256));
        bytes += std::to_string(i * 37 % 256) + ", ";
    }
    const auto levels = [&image](const std::string& text) {
        State state;
        for (const Command& command :
             read_scene(text, "scene.gl", "scene", [&image](const std::string&) { return image; }).commands) {
            state.apply(command);
        }
        EXPECT_TRUE(state.errors().empty());
        return state.textures().named.at(3)->levels;
    };
    const std::string bind = "glBindTexture(GL_TEXTURE_2D, 3);\n", pragma = "#pragma twinlight texture(\"a.png\")\n";
    const auto expected = levels(bind + "GLubyte pixels[] = {" + bytes +
                                 "};\ngluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGBA, 5, 3, GL_RGBA, GL_UNSIGNED_BYTE, "
                                 "pixels);\n");
    ASSERT_EQ(expected.size(), 3U);  // 4 x 4, 2 x 2, 1 x 1
    for (const std::string& text :
         {bind + pragma, bind + "glNewList(1, GL_COMPILE);\n" + pragma + "glEndList(); glCallList(1);\n"}) {
        const auto found = levels(text);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t level = 0; level < found.size(); ++level) {
            EXPECT_EQ(found[level].texels, expected[level].texels);
            EXPECT_EQ(found[level].internal_format, expected[level].internal_format);
        }
    }
}

TEST_F(TextureFiles, AreReadOnceHoweverOftenTheyAreNamed) {
    int reads = 0;
    const CommandList scene = read_scene("#pragma twinlight texture(\"a.png\")\n#pragma twinlight texture(\"a.png\")\n",
                                         "scene.gl", "scene", [&reads](const std::string&) {
                                             ++reads;
                                             return ImageFile{1, 1, std::vector<std::byte>(4)};
                                         });
    EXPECT_EQ(reads, 1);
    EXPECT_EQ(scene.commands[0].memory, scene.commands[1].memory);
}

TEST_F(TextureFiles, AreExportedAsArraysAndKeptByPrinting) {
    const ProgramResult result = run({"export", in_ / "scene.gl", "--as", "c"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out.find("#pragma twinlight"), std::string::npos);
    // The bottom row (blue) comes first.
    EXPECT_NE(result.out.find("0, 0, 255, 255, 0, 0, 255, 255, 255, 0, 0, 255, 255, 0, 0, 255};"), std::string::npos);
    EXPECT_NE(result.out.find("gluBuild2DMipmaps(GL_TEXTURE_2D, "), std::string::npos);
    const std::string pragma = "#pragma twinlight texture(\"picture.png\")\n";
    const ProgramResult as_scene = run({"export", in_ / "scene.gl", "--as", "scene"});
    EXPECT_NE(as_scene.out.find(pragma), std::string::npos) << as_scene.err;
    const CommandList scene = read_scene(pragma, "scene.gl", "scene", images_beside(in_ / "scene.gl"));
    EXPECT_EQ(print_scene(scene), pragma);
}

// ---- Names that are refused ----

TEST_F(TextureFiles, LieInTheScenesFolder) {
    const std::string elsewhere = "must be in the folder of the scene; give only its file name";
    expect_refused("\"../picture.png\"", elsewhere);
    expect_refused("\"" + (in_ / "picture.png") + "\"", elsewhere);
    expect_refused("\"./picture.png\"", elsewhere);
    expect_refused("\"..\"", elsewhere);
    expect_refused("\"\"", elsewhere);
    expect_refused("\"none.png\"",
                   "'none.png': No such file or directory; the picture must be in the folder of the scene");
    write_png(out_ / "picture.png", red_above_blue());
    fs::create_symlink(out_ / "picture.png", in_ / "link.png");
    expect_refused("\"link.png\"", "this link points outside the folder of the scene");
    fs::create_symlink("loop.png", in_ / "loop.png");
    expect_refused("\"loop.png\"", "Too many levels of symbolic links");
    fs::create_directory(in_ / "folder.png");
    expect_refused("\"folder.png\"", "this is not a file");
    EXPECT_EQ(run_shell("", "mkfifo " + quoted(in_ / "pipe.png")).status, 0);
    expect_refused("\"pipe.png\"", "this is not a file");
}

TEST_F(TextureFiles, MayBeReachedByALinkWithinTheFolder) {
    fs::create_symlink("picture.png", in_ / "alias.png");
    EXPECT_EQ(images_beside(in_ / "scene.gl")("alias.png").width, 2);
}

TEST_F(TextureFiles, HaveNoFolderInStandardInputAndPipes) {
    for (const std::string scene : {"-", "/dev/stdin"}) {
        const ProgramResult result =
            run_shell("twinlight", "cat " + quoted(in_ / "scene.gl") + " | \"$PROGRAM\" render " + scene +
                                       " --with reference -o " + quoted(out_ / "p.png"));
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find("save the scene in a file next to the picture"), std::string::npos) << result.err;
    }
}

TEST_F(TextureFiles, OfBuiltInScenesServeStandardInputInEveryStep) {
    for (const std::string name : {"report", "tutorial"}) {  // the second has a mesh, too
        const ProgramResult result =
            run_shell("twinlight", "cat src/scene/scenes/" + name + ".gl | \"$PROGRAM\" compare - --size 80x60 -o " +
                                       quoted(out_ / name));
        EXPECT_EQ(result.status, 0) << result.err;
    }
}

TEST_F(TextureFiles, AreNamedInQuotes) {
    expect_refused("picture", "expected the name of a picture in quotes, such as \"brick.png\"");
    expect_refused("3", "expected the name of a picture in quotes");
    expect_refused("\"picture.png", "this string has no end on its line");
    EXPECT_THROW(read_scene("#pragma twinlight texture(\"a\\nb\")\n", "s.gl", "s"), SceneError);
    EXPECT_THROW(read_scene("#pragma twinlight texture(\"a\tb\")\n", "s.gl", "s"), SceneError);
    EXPECT_THROW(read_scene("glEnable(\"a\");\n", "s.gl", "s"), SceneError);
}

// ---- Files that are not pictures ----

std::string four_bytes(std::size_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
    return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
    return four_bytes(data.size()) + type + data + four_bytes(0);  // the decoder ignores check sums
}

// A PNG of grey pixels, whose data unpacks to `bytes` zeros: in stored blocks (RFC 1951, 3.2.4).
std::string png_of_zeros(std::size_t width, std::size_t height, std::size_t bytes) {
    std::string data("\x78\x01", 2);
    for (std::size_t left = bytes; left > 0;) {
        const std::size_t size = std::min<std::size_t>(left, 65535);
        left -= size;
        data += static_cast<char>(left == 0 ? 1 : 0);
        for (const std::size_t field : {size, ~size}) {
            data += static_cast<char>(field & 0xFF);
            data += static_cast<char>(field >> 8 & 0xFF);
        }
        data.append(size, '\0');
    }
    const std::string header = four_bytes(width) + four_bytes(height) + std::string("\x08\0\0\0\0", 5);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", data + four_bytes(bytes)) + chunk("IEND", "");
}

TEST_F(TextureFiles, ArePngsOfALimitedSize) {
    const auto put = [this](const std::string& bytes) { write_file_atomically(in_ / "a.png", bytes); };
    put("");
    expect_refused("\"a.png\"", "this is not a PNG; convert it to one");
    put("\xff\xd8\xff\xe0 a JPEG");
    expect_refused("\"a.png\"", "this is not a PNG; convert it to one");
    const std::string whole = encode_png(red_above_blue());
    for (std::size_t size = 8; size < whole.size(); size += 7) {
        put(whole.substr(0, size));
        expect_refused("\"a.png\"", "save it again");
    }
    put(png_of_zeros(4, 3, 15));  // one byte per row gives the filter
    EXPECT_EQ(images_beside(in_ / "scene.gl")("a.png").rgba.size(), 4U * 3 * 4);
    put(png_of_zeros(kMaxImageSide + 1, 1, kMaxImageSide + 2));
    expect_refused("\"a.png\"", "the picture has 2049 x 1 pixels; the limit is 2048 x 2048; make it smaller");
    put(png_of_zeros(0x7fffffff, 0x7fffffff, 10));
    expect_refused("\"a.png\"", "");
    put(png_of_zeros(4, 3, 1 << 20));  // a picture of 15 bytes that unpacks to a mebibyte
    expect_refused("\"a.png\"", "more than its size allows");
    put(whole + std::string(kMaxImageFileBytes, '\0'));
    expect_refused("\"a.png\"", "the file has more than 32 MiB");
}

}  // namespace
}  // namespace twinlight::texture_files_test
