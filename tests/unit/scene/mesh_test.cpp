// Meshes from OBJ files: #pragma twinlight mesh("file.obj").
#include "scene/command/mesh.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "../compare_three_ways.h"
#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "scene/mesh/obj.h"
#include "scene/scenes/images.h"
#include "scene/scenes/load.h"
#include "scene/scenes/meshes.h"
#include "scene/shape/written_out.h"
#include "scene/state/state.h"

namespace twinlight::mesh_test {
namespace {

MeshFiles files_with(const std::string& mtl) {
    return {.text = [mtl](const std::string&) { return mtl; },
            .image =
                [](const std::string& name) {
                    if (name != "red.png") throw std::runtime_error("there is no such picture");
                    return ImageFile{1, 1, std::vector<std::byte>(4, std::byte{200})};
                }};
}

std::shared_ptr<const Mesh> read(const std::string& text, const std::string& mtl = {}) {
    return read_obj(text, files_with(mtl));
}

std::string error_of(const std::string& text, const std::string& mtl = {}) {
    try {
        read(text, mtl);
        return "no error";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

template <class Number>
std::vector<Number> numbers_of(const Memory& memory) {
    std::vector<Number> numbers(memory.bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), memory.bytes.data(), memory.bytes.size());
    return numbers;
}

using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;

// The normals of a mesh without texture coordinates, in the order of its vertices.
std::vector<glm::dvec3> normals_of(const Mesh& mesh) {
    const Floats values = numbers_of<float>(*mesh.vertices);
    std::vector<glm::dvec3> normals;
    for (std::size_t i = 0; i + 6 <= values.size(); i += 6)
        normals.emplace_back(values[i], values[i + 1], values[i + 2]);
    return normals;
}

const std::string kTriangle = "v 0 0 0\nv 2 0 0\nv 0 1 0\n";

// ---- Vertices ----

TEST(Mesh, HasTheVerticesOfItsFaces) {
    const auto mesh = read(kTriangle + "vt 0 0\nvt 1 0.5\nvn 0 0 2\nf 1/1/1 2/2/1 3/1/1\n");
    EXPECT_TRUE(mesh->has_tex_coords);
    ASSERT_EQ(mesh->parts.size(), 1U);
    EXPECT_EQ(numbers_of<float>(*mesh->vertices),
              (Floats{0, 0, 0, 0, 2, 0, 0, 0, 1, 0.5, 0, 0, 2, 2, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0}));
    EXPECT_EQ(numbers_of<std::uint32_t>(*mesh->parts[0].indices), (Indices{0, 1, 2}));
    EXPECT_EQ(mesh->vertex_count(), 3U);
    EXPECT_EQ(mesh->triangle_count(), 1U);
}

// A vertex is sent once for each of its texture coordinates and normals.
TEST(Mesh, SharesVerticesThatAreEqual) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    EXPECT_EQ(read(square + "f 1 2 3\nf 1 3 4\n")->vertex_count(), 4U);
    EXPECT_EQ(read(square + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/1 4/1\n")->vertex_count(), 5U);
    const auto quad = read(square + "f -4 -3 -2 -1\n");
    EXPECT_EQ(quad->vertex_count(), 4U);
    EXPECT_EQ(quad->triangle_count(), 2U);
}

TEST(Mesh, ReadsLinesAsProgramsWriteThem) {
    const auto expected = read(kTriangle + "f 1 2 3\n");
    for (const std::string text :
         {"# made by hand\r\nv 0 0 0\r\nv 2 0 0\r\nv 0 1 0\r\n\r\nf 1 2 3\r\n",
          "v 0 0 0 1\nv 2.0 0 -0\nv +0 1e0 .0\nf 1 2 3",
          "o a\ng b c\ns off\nv 0 0 0 1 0 0\n\tv 2 0 0 0 1 0\n v  0  1 0 0 0 1 # blue\nvp 1 2\nl 1 2\nf 1 2 3\n",
          "f 1 2 3\nv 0 0 0\nv 2 \\\n0 0\nv 0 1 0\n"}) {
        const auto mesh = read(text);
        EXPECT_EQ(numbers_of<std::uint32_t>(*mesh->parts[0].indices), (Indices{0, 1, 2})) << text;
        const Floats a = numbers_of<float>(*mesh->vertices), b = numbers_of<float>(*expected->vertices);
        EXPECT_EQ(a, b) << text;
    }
}

// ---- Normals ----

TEST(Mesh, WithoutNormalsHasThoseOfItsTriangles) {
    for (const glm::dvec3& normal : normals_of(*read(kTriangle + "f 1 2 3\n"))) EXPECT_EQ(normal, glm::dvec3(0, 0, 1));
    for (const glm::dvec3& normal : normals_of(*read(kTriangle + "f 3 2 1\n"))) EXPECT_EQ(normal, glm::dvec3(0, 0, -1));
}

// Two triangles at right angles share an edge. One is much larger, but their unit normals count equally: half way between.
TEST(Mesh, NormalsAreTheNormalisedSumOverAdjacentTriangles) {
    const auto normals = normals_of(*read("v 0 0 0\nv 1 0 0\nv 0 9 0\nv 0 0 -1\nf 1 2 3\nf 1 2 4\n"));
    ASSERT_EQ(normals.size(), 4U);
    const double half = std::sqrt(0.5);
    for (const std::size_t shared : {0U, 1U}) {
        EXPECT_NEAR(normals[shared].y, half, 1e-7);
        EXPECT_NEAR(normals[shared].z, half, 1e-7);
        EXPECT_EQ(normals[shared].x, 0);
    }
    EXPECT_EQ(normals[2], glm::dvec3(0, 0, 1));
    EXPECT_EQ(normals[3], glm::dvec3(0, 1, 0));
}

// The sum is over places, so that a seam of the texture stays smooth.
TEST(Mesh, NormalsAreSmoothAcrossASeamOfTheTexture) {
    const auto mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 2/2 4/2\n");
    const Floats values = numbers_of<float>(*mesh->vertices);
    ASSERT_EQ(values.size(), 6U * 8U);
    for (const std::size_t seam : {0U, 1U, 3U, 4U}) EXPECT_NEAR(values[seam * 8 + 4], std::sqrt(0.5), 1e-7) << seam;
}

TEST(Mesh, CornersWithoutANormalGetTheSum) {
    const auto normals = normals_of(*read(kTriangle + "vn 1 0 0\nf 1//1 2 3\n"));
    EXPECT_EQ(normals[0], glm::dvec3(1, 0, 0));
    EXPECT_EQ(normals[1], glm::dvec3(0, 0, 1));
}

TEST(Mesh, TrianglesWithoutAnAreaHaveNoNormal) {
    EXPECT_EQ(normals_of(*read(kTriangle + "f 1 2 3\nf 1 2 2\n"))[1], glm::dvec3(0, 0, 1));
    EXPECT_EQ(normals_of(*read(kTriangle + "f 1 1 1\n"))[0], glm::dvec3(0));
}

// ---- Materials ----

const std::string kMtl =
    "newmtl red\nKa 0.1 0 0\nKd 1 0 0\nKs 1 1 1\nNs 500\nd 0.5\nillum 2\nmap_Kd red.png\n"
    "newmtl matt\nKd 0 0 1\nKs 1 1 1\nNs 10\nillum 1\nKe 0 0.25 0\n";

TEST(Mesh, HasAPartForEachMaterial) {
    const auto mesh = read(
        "mtllib a.mtl\n" + kTriangle + "f 1 2 3\nusemtl red\nf 1 2 3\nf 3 2 1\no second\nusemtl matt\nf 1 2 3\n", kMtl);
    ASSERT_EQ(mesh->parts.size(), 3U);
    EXPECT_FALSE(mesh->parts[0].material);
    EXPECT_EQ(mesh->parts[1].indices->bytes.size(), 6 * sizeof(std::uint32_t));
    const MeshMaterial &red = *mesh->parts[1].material, &matt = *mesh->parts[2].material;
    EXPECT_EQ(red.ambient, (std::array<float, 4>{0.1F, 0, 0, 1}));
    EXPECT_EQ(red.diffuse, (std::array<float, 4>{1, 0, 0, 0.5F}));
    EXPECT_EQ(red.shininess, 128) << "the largest that GL has";
    EXPECT_TRUE(red.texture);
    EXPECT_EQ(matt.specular, (std::array<float, 4>{0, 0, 0, 0})) << "illumination model 1 has no highlight";
    EXPECT_EQ(matt.emission, (std::array<float, 4>{0, 0.25F, 0, 1}));
    EXPECT_FALSE(matt.texture);
}

TEST(Mesh, WithAMaterialThatNobodyDefinesKeepsTheScenes) {
    EXPECT_FALSE(read("mtllib a.mtl\n" + kTriangle + "usemtl green\nf 1 2 3\n", kMtl)->parts[0].material);
    EXPECT_FALSE(read(kTriangle + "usemtl red\nf 1 2 3\n")->parts[0].material);
}

// ---- Files that cannot be used ----

TEST(Mesh, BrokenFilesGetOneLine) {
    const std::string f = kTriangle + "f 1 2 3\n";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "this file has no faces; it must have lines such as 'f 1 2 3'"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "this file has no faces"},
        {"GIF89a\x01\x02", "this file has no faces"},
        {std::string("f\0", 2), "line 1: this is not a text file"},
        {kTriangle + "f 1 2 4\n", "line 4: this face uses vertex 4, but the file has only 3"},
        {kTriangle + "\nf 1 2 3\n\nf 1 2 99999999999999999999\n", "line 7: a face uses vertex '99999999999999999999'"},
        {kTriangle + "f 0 1 2\n", "line 4: a face uses vertex '0'; indices start at 1"},
        {kTriangle + "f -1 -2 -4\n", "line 4: this face uses vertex -4, but only 3 precede it"},
        {kTriangle + "f 1/1 2/1 3/1\n", "line 4: this face uses texture coordinate 1, but the file has only 0"},
        {kTriangle + "f 1//2 2//1 3//1\nvn 0 0 1\n", "line 4: this face uses normal 2, but the file has only 1"},
        {kTriangle + "f 1 2\n", "line 4: a face needs 3 corners, but 2 are given"},
        {kTriangle + "f 1 2 x\n", "line 4: 'x' is not a corner of a face; it must look like 7, 7/2, 7//3 or 7/2/3"},
        {kTriangle + "f 1/ 2 3\n", "line 4: '1/' is not a corner of a face"},
        {kTriangle + "f 1/1/1/1 2 3\nvt 0 0\nvn 0 0 1\n", "line 4: '1/1/1/1' is not a corner of a face"},
        {"v 0 0\n" + f, "line 1: vertex needs 3 numbers, but 2 are given"},
        {"v 0 0 nan\n" + f, "line 1: 'nan' is not a finite float"},
        {"v 0 0 -inf\n" + f, "line 1: '-inf' is not a finite float"},
        {"v 0 1e39 0\n" + f, "line 1: '1e39' is not a finite float"},
        {"v 0 1e999 0\n" + f, "line 1: '1e999' is not a finite float"},
        {"v 0 0 a\n" + f, "line 1: expected a number, found 'a'"},
        {"v 0 0 0x10\n" + f, "line 1: expected a number, found '0x10'"},
        {"vn 0 0\n" + f, "line 1: normal needs 3 numbers, but 2 are given"},
        {"vt 0 0 0 0\n" + f, "line 1: texture coordinate has at most 3 numbers"},
    };
    for (const auto& [text, expected] : cases) EXPECT_EQ(error_of(text).substr(0, expected.size()), expected) << text;
    std::string polygon = kTriangle + "f";
    for (int i = 0; i < 257; ++i) polygon += " 1";
    EXPECT_EQ(error_of(polygon), "line 4: a face can have at most 256 corners");
}

TEST(Mesh, BrokenMaterialsGetOneLine) {
    const std::string obj = "mtllib a.mtl\n" + kTriangle + "usemtl red\nf 1 2 3\n";
    EXPECT_EQ(error_of(obj, "newmtl red\nKd 1e39 0 0\n"), "the material 'red' has a colour that is not finite");
    EXPECT_EQ(error_of(obj, "newmtl red\nmap_Kd blue.png\n"),
              "the material 'red' has the picture 'blue.png': there is no such picture");
    EXPECT_EQ(error_of(obj, std::string("newmtl\0", 7)), "'a.mtl': this is not a text file");
}

// Ten million lines: refused at once, or read within the limits.
TEST(Mesh, LongFilesEndAtALimit) {
    const auto repeated = [](const std::string& line, std::size_t count) {
        std::string text;
        text.reserve(line.size() * count);
        for (std::size_t i = 0; i < count; ++i) text += line;
        return text;
    };
    constexpr std::size_t kLines = 10'000'000;
    EXPECT_EQ(error_of(kTriangle + repeated("f 1 2 3\n", kLines)),
              "this file has more than 64 MiB, the limit for a mesh; use a coarser mesh");
    EXPECT_EQ(error_of(kTriangle + repeated("f 1 2 3\n", 1'000'001)),
              "line 1000004: a mesh can have at most 1000000 triangles");
    EXPECT_EQ(error_of(repeated("vt 0\n", kLines)),
              "line 2000001: a mesh can have at most 2000000 of each: vertices, texture coordinates, normals");
    EXPECT_EQ(error_of(repeated("\n", kLines)).substr(0, 22), "this file has no faces");
}

// ---- The pragma ----

constexpr const char* kScene =
    R"(glMatrixMode(GL_PROJECTION); glFrustum(-0.4, 0.4, -0.3, 0.3, 1, 10); glMatrixMode(GL_MODELVIEW);
glTranslatef(0, 0, -4); glClearColor(0.3, 0.3, 0.4, 1); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_NORMALIZE);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3, 0});
glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0.2, 0.9, 0.3, 1});
#pragma twinlight mesh("figure.obj")
)";

// A tent of two materials and a part without one.
const std::string kFigure = R"(mtllib figure.mtl
v -1 -1 0
v 1 -1 0
v 0 1 0.5
v -1.2 1 0
v 1.2 1.1 0
vt 0 0
vt 1 0
vt 0.5 1
usemtl red
f 1/1 2/2 3/3
usemtl matt
f 1/1 3/3 4/2
usemtl none
f 2/1 5/2 3/3
)";

class MeshPragma : public testing::Test {
  protected:
    void SetUp() override {
        write_file_atomically(in_ / "figure.obj", kFigure);
        write_file_atomically(in_ / "figure.mtl", kMtl);
        Image red(2, 2, {1, 0.5, 0.5, 1});
        red.at(0, 0) = {1, 1, 0.2, 1};
        write_png(in_ / "red.png", red);
        write_file_atomically(in_ / "scene.gl", kScene);
    }
    Scene scene() const { return make_scene(load_commands(in_ / "scene.gl"), {.width = 160, .height = 120}); }

    TemporaryFolder in_;
};

TEST_F(MeshPragma, IsDrawnAlikeByAllRenderers) {
    const Scene drawn = scene();
    const compare::Comparison comparison = compare_three_ways(drawn);
    EXPECT_TRUE(comparison.within_tolerance());
    EXPECT_TRUE(comparison.unsupported.empty());
    // Each of the three parts shows: blue-green by its material, green by the scene's.
    int red = 0, green = 0, blue = 0;
    for (const Rgba& pixel : comparison.renders[2].image.pixels) {
        red += pixel[0] > 0.5 && pixel[2] < 0.3;
        green += pixel[1] > 0.6 && pixel[0] < 0.4;
        blue += pixel[2] > 0.6 && pixel[0] < 0.2;
    }
    EXPECT_GT(red, 100);
    EXPECT_GT(green, 100);
    EXPECT_GT(blue, 100);
}

TEST_F(MeshPragma, LeavesNoStateBehind) {
    State state;
    const auto list = load_commands(in_ / "scene.gl");
    for (const Command& command : list->commands) state.apply(command);
    EXPECT_TRUE(state.errors().empty());
    const auto with = [](const std::string& more) {
        return make_frame(
            read_scene(std::string(kScene).substr(0, std::string(kScene).find("#pragma")) + more, "s.gl", "s"), {});
    };
    const Frame after =
        make_frame(read_scene(std::string(kScene) + "glutSolidCube(1);", "s.gl", "s", images_beside(in_ / "scene.gl"),
                              {.load_mesh = meshes_beside(in_ / "scene.gl")}),
                   {});
    const Frame without = with("glutSolidCube(1);");
    const Draw &a = *after.draws().back(), &b = *without.draws().back();
    for (const auto face : {&LightingState::front, &LightingState::back}) {
        EXPECT_EQ((a.lighting.*face).diffuse, (b.lighting.*face).diffuse);
        EXPECT_EQ((a.lighting.*face).shininess, (b.lighting.*face).shininess);
    }
    EXPECT_EQ(a.texture.texture == nullptr, b.texture.texture == nullptr);
}

// In a display list, and with vertex arrays and buffers of the scene's own around it.
TEST_F(MeshPragma, IsIndependentOfTheScenesArrays) {
    const std::string text = kScene;
    const std::size_t at = text.find("#pragma");
    const std::string mesh = text.substr(at);
    const std::string around[] = {
        "glNewList(1, GL_COMPILE);\n" + mesh + "glEndList();\nglCallList(1);\n",
        "GLfloat corner[] = {0, 0, 0};\nGLuint buffer;\nglGenBuffers(1, &buffer);\nglBindBuffer(GL_ARRAY_BUFFER, "
        "buffer);\n"
        "glBufferData(GL_ARRAY_BUFFER, 12, corner, GL_STATIC_DRAW);\nglVertexPointer(3, GL_FLOAT, 0, NULL);\n"
        "glEnableClientState(GL_VERTEX_ARRAY);\nglEnableClientState(GL_COLOR_ARRAY);\n"
        "glColorPointer(3, GL_FLOAT, 0, NULL);\n" +
            mesh};
    const auto picture = [&](const std::string& scene) {
        write_file_atomically(in_ / "around.gl", scene);
        const Scene drawn = make_scene(load_commands(in_ / "around.gl"), {.width = 160, .height = 120});
        const compare::Comparison comparison = compare_three_ways(drawn);
        EXPECT_TRUE(comparison.within_tolerance());
        return comparison.renders[2].image.pixels;
    };
    const auto expected = picture(text);
    for (const std::string& other : around) EXPECT_EQ(picture(text.substr(0, at) + other), expected) << other;
}

TEST_F(MeshPragma, IsPrintedByItsNameAndWrittenOutForC) {
    const auto list = load_commands(in_ / "scene.gl");
    const std::string printed = print_scene(*list);
    EXPECT_NE(printed.find("#pragma twinlight mesh(\"figure.obj\")\n"), std::string::npos) << printed;
    const CommandList again = read_scene(printed, "s.gl", "s", images_beside(in_ / "scene.gl"),
                                         {.load_mesh = meshes_beside(in_ / "scene.gl")});
    EXPECT_EQ(again.commands, list->commands);
    const CommandList written = with_pragmas_written_out(*list);
    const CommandList read_again = read_scene(print_scene(written), "s.gl", "s");
    EXPECT_EQ(print_scene(read_again), print_scene(written));
    const auto vertices = [](const Frame& frame) {
        std::vector<Vertex> all;
        for (const Draw* draw : frame.draws()) all.insert(all.end(), draw->vertices.begin(), draw->vertices.end());
        return all.size();
    };
    EXPECT_EQ(vertices(make_frame(written, {})), vertices(make_frame(*list, {})));
}

// Another mesh in the same file is another command.
TEST_F(MeshPragma, EqualsOnlyTheSameMesh) {
    const Command before = load_commands(in_ / "scene.gl")->commands.back();
    EXPECT_EQ(load_commands(in_ / "scene.gl")->commands.back(), before);
    std::string changed = kFigure;
    changed.replace(changed.find("v 0 1 0.5"), 9, "v 0 1 0.6");
    write_file_atomically(in_ / "figure.obj", changed);
    EXPECT_NE(load_commands(in_ / "scene.gl")->commands.back(), before);
    write_file_atomically(in_ / "figure.obj", kFigure);
    write_file_atomically(in_ / "figure.mtl", "newmtl red\nKd 1 1 0\n");
    EXPECT_NE(load_commands(in_ / "scene.gl")->commands.back(), before);
}

TEST_F(MeshPragma, ErrorsNameTheFileAndTheLine) {
    const auto refusal = [&](const std::string& pragma) -> std::string {
        write_file_atomically(in_ / "scene.gl", "glFlush();\n#pragma twinlight mesh(" + pragma + ")\n");
        try {
            load_commands(in_ / "scene.gl");
            return "no error";
        } catch (const SceneError& error) {
            return std::string(error.what()).substr((in_ / "scene.gl").size());
        }
    };
    EXPECT_EQ(refusal("\"none.obj\""),
              ":2:24: 'none.obj': No such file or directory; the mesh must be in the folder of the scene");
    EXPECT_EQ(refusal("\"../figure.obj\""),
              ":2:24: '../figure.obj': a mesh must be in the folder of the scene; give only its file name, such as "
              "\"bunny.obj\"");
    EXPECT_EQ(refusal("figure").substr(0, 46), ":2:24: expected the name of an OBJ file in quo");
    write_file_atomically(in_ / "figure.obj", "v 1 2 3\nf 1 2 3\n");
    EXPECT_EQ(refusal("\"figure.obj\""),
              ":2:24: 'figure.obj': line 2: this face uses vertex 3, but the file has only 1");
    write_file_atomically(in_ / "figure.obj", kFigure);
    std::filesystem::remove(in_ / "figure.mtl");
    EXPECT_EQ(
        refusal("\"figure.obj\""),
        ":2:24: 'figure.obj': 'figure.mtl': No such file or directory; the material file must be in the folder of "
        "the scene");
}

TEST(Meshes, OfBuiltInScenesAreFoundFromEveryFolder) {
    TemporaryFolder folder;
    write_file_atomically(folder / "cat.gl",
                          "#pragma twinlight texture(\"cat.png\")\n#pragma twinlight mesh(\"cat.obj\")\n");
    EXPECT_EQ(load_commands(folder / "cat.gl")->commands.back().number(1), 2784);
}

}  // namespace
}  // namespace twinlight::mesh_test
