// What the page draws, without a browser.
#include "render/webgl/webgl_frame.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <regex>
#include <set>
#include <string>
#include <type_traits>

#include "app/web/page_scene.h"
#include "base/text/json.h"
#include "judge/compare/tolerance.h"
#include "judge/fuzz/random_states.h"
#include "render/programmable/numbers/program_uniforms.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::web::webgl_frame_test {

namespace {

using Json = nlohmann::json;

Json header_of(const std::string& text) {
    PageScene scene;
    const Json answer = Json::parse(scene.open(text, "scene", "", {64, 64}));
    EXPECT_EQ(answer["errors"], Json::array());
    return scene.webgl_frame({}).header;
}

std::string only_program(const Json& header, const char* stage) {
    EXPECT_EQ(header["programs"].size(), 1u);
    return header["programs"][0][stage];
}

// Those of the item's first pass.
Json uniforms_of(const Json& item, const Json& header) {
    Json all = Json::object();
    for (const std::size_t number : item["passes"][0]) all.update(header["uniforms"][number]);
    return all;
}

TEST(WebglFrame, HasProgramsInGlslEs) {
    const Json header = header_of("glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_GREATER, 0.5); glRectf(-1, -1, 1, 1);");
    for (const char* stage : {"vertex", "fragment"})
        EXPECT_TRUE(only_program(header, stage).starts_with("#version 300 es\nprecision highp float;")) << stage;
    EXPECT_NE(only_program(header, "fragment").find("if (!(color.a > u_alpha_ref)) discard;"), std::string::npos);
    EXPECT_EQ(uniforms_of(header["items"][0], header)["u_alpha_ref"], (Json{0.5}));
    EXPECT_EQ(header["missing"], Json::array());
}

TEST(WebglFrame, WritesNumbersThatDrawsShareOnce) {
    const Json header = header_of("glRectf(-1, -1, 0, 0); glRectf(0, 0, 1, 1);");
    ASSERT_EQ(header["items"].size(), 2u);
    EXPECT_EQ(header["items"][0]["passes"], header["items"][1]["passes"]);
    EXPECT_EQ(header["uniforms"].size(), 1u);
}

TEST(WebglFrame, HasTheTextsOverThePicture) {
    const Json header = header_of(
        "glOrtho(-2, 2, -2, 2, -1, 1);\n#pragma twinlight label(1, 1, 0, \"n = %g\", 2.5)\nglRectf(-1, -1, 1, 1);");
    EXPECT_EQ(header["labels"], (Json{{{"text", "n = 2.5"}, {"at", {48.0, 16.0}}}}));
    EXPECT_FALSE(header_of("glRectf(-1, -1, 1, 1);").contains("labels"));
}

// The names that a program declares, except samplers. Of a struct's members, the struct.
std::set<std::string> names_of_numbers(const Json& program) {
    static const std::regex kUniform("uniform (\\w+) (\\w+)");
    std::set<std::string> names;
    for (const char* stage : {"vertex", "fragment"}) {
        const std::string text = program[stage];
        for (std::sregex_iterator at(text.begin(), text.end(), kUniform), end; at != end; ++at)
            if (!(*at)[1].str().starts_with("sampler")) names.insert((*at)[2]);
    }
    return names;
}

// What OpenGL ES lacks is in numbers of each part of a draw: exactly those that its program declares.
TEST(WebglFrame, HasANumberForEachUniform) {
    std::set<std::string> met;
    const auto check = [&](const Json& header, const std::string& where) {
        for (const Json& item : header["items"]) {
            if (!item.contains("program")) continue;
            const std::set<std::string> declared = names_of_numbers(header["programs"][item["program"].get<int>()]);
            const Json numbers = uniforms_of(item, header);
            for (const std::string& name : declared) EXPECT_TRUE(numbers.contains(name)) << name << " of " << where;
            programmable::for_each_uniform([&]<class Value>(Value value) {
                if constexpr (std::is_same_v<Value, programmable::EsValue> ||
                              std::is_same_v<Value, programmable::EsTextureValue>) {
                    const std::string name = programmable::name_of(value);
                    if (declared.contains(name) || declared.contains(name + "0")) met.insert(name);
                    if (numbers.contains(name)) {
                        EXPECT_TRUE(declared.contains(name)) << name << " of " << where;
                    }
                }
            });
        }
    };
    for (int i = 0; i < 300; ++i) {
        const fuzz::Seed seed{.structure = static_cast<std::uint64_t>(i), .values = 1};
        check(webgl::webgl_frame(make_frame(fuzz::fragment_state(seed), {.width = 64, .height = 64}), {}).header,
              fmt::format("state {}", i));
    }
    for (const EmbeddedFile& file : kSceneFiles)
        check(webgl::webgl_frame(make_frame(read_built_in(file), {.width = 64, .height = 64}), {}).header,
              std::string(file.name));
    check(header_of("glEnable(GL_POLYGON_STIPPLE); glRectf(-1, -1, 1, 1);"), "a stippled polygon");
    programmable::for_each_uniform([&]<class Value>(Value value) {
        if constexpr (std::is_same_v<Value, programmable::EsValue>) {
            const std::string name = programmable::name_of(value);
            EXPECT_TRUE(value == programmable::EsValue::kFramebuffer || met.contains(name))
                << "no state needs " << name;
        }
    });
}

// GL's state: what a viewer changes when it turns the camera or switches a light off.
TEST(WebglFrame, HasGlsStateForAnyPose) {
    PageScene scene;
    scene.open(
        R"(glTranslatef(0, 0, -5); glClipPlane(GL_CLIP_PLANE1, (GLdouble[]){0, 1, 0, 2}); glEnable(GL_CLIP_PLANE1);
        glEnable(GL_LIGHTING); glEnable(GL_LIGHT2); glLightfv(GL_LIGHT2, GL_POSITION, (GLfloat[]){1, 2, 3, 1});
        glLightfv(GL_LIGHT2, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1}); glScalef(2, 2, 2); glRectf(-1, -1, 1, 1);)",
        "scene", "", {64, 64});
    PlanOptions options;
    options.for_any_pose = true;
    const Json header = webgl::webgl_frame(scene.scene().frame, options).header;
    EXPECT_EQ(header["middle"], (Json{0, 0, -5}));
    const Json uniforms = uniforms_of(header["items"][0], header);
    EXPECT_EQ(uniforms["ModelViewMatrix"], (Json{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, -5, 1}));
    EXPECT_EQ(uniforms["LightSource[2].position"], (Json{1, 2, -2, 1}));
    EXPECT_EQ(uniforms["ClipPlane"].size(), 32u);
    EXPECT_EQ(uniforms["ClipPlane"][5], 1);
    const std::string vertex = only_program(header, "vertex");
    for (const char* name : {"uniform mat4 ModelViewMatrix;", "LightSource[2].position"})
        EXPECT_NE(vertex.find(name), std::string::npos) << vertex;
}

TEST(WebglFrame, DrawsQuadrilateralsAsTriangles) {
    const Json parts = header_of("glRectf(-1, -1, 1, 1);")["items"][0]["parts"];
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0][0], kGL_TRIANGLES);
    EXPECT_EQ(parts[0][2], 6);
}

TEST(WebglFrame, DrawsBordersWithoutTheDiagonal) {
    const Json parts =
        header_of("glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glRectf(-0.5, -0.5, 0.5, 0.5);")["items"][0]["parts"];
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0][0], kGL_LINES);
    EXPECT_EQ(parts[0][2], 8);
}

// WebGL refuses a depth range from far to near: z changes its sign instead.
// For each item: what it draws.
std::vector<Enum> modes_of(const Json& header) {
    std::vector<Enum> modes;
    for (const Json& item : header["items"]) modes.push_back(item["parts"][0][0]);
    return modes;
}

TEST(WebglFrame, DrawsFacesAndEdgesInTheirOrder) {
    // Back, front, front, back.
    const std::string turns =
        "glPolygonMode(GL_BACK, GL_LINE); glBegin(GL_TRIANGLES);"
        "glVertex2f(0, 0); glVertex2f(0, 0.5); glVertex2f(0.5, 0); glVertex2f(0, 0); glVertex2f(0.5, 0); glVertex2f(0, "
        "0.5);"
        "glVertex2f(0, 0); glVertex2f(0.5, 0); glVertex2f(0, 0.5); glVertex2f(0, 0); glVertex2f(0, 0.5); "
        "glVertex2f(0.5, 0);"
        "glEnd();";
    EXPECT_EQ(modes_of(header_of(turns)), (std::vector<Enum>{kGL_LINES, kGL_TRIANGLES, kGL_LINES}));
    EXPECT_EQ(modes_of(header_of("glEnable(GL_DEPTH_TEST);" + turns)), (std::vector<Enum>{kGL_LINES, kGL_TRIANGLES}));
    EXPECT_EQ(modes_of(header_of("glEnable(GL_DEPTH_TEST); glEnable(GL_BLEND);" + turns)).size(), 3u);

    const auto many = [&](int pairs) {
        std::string text = "glPolygonMode(GL_BACK, GL_LINE); glBegin(GL_QUADS);";
        for (int i = 0; i < pairs; ++i)
            text +=
                "glVertex2f(0, 0); glVertex2f(0, 0.5); glVertex2f(0.5, 0.5); glVertex2f(0.5, 0);"
                "glVertex2f(0, 0); glVertex2f(0.5, 0); glVertex2f(0.5, 0.5); glVertex2f(0, 0.5);";
        return header_of(text + "glEnd();");
    };
    EXPECT_EQ(many(32)["items"].size(), 64u);
    EXPECT_EQ(many(32)["missing"], Json::array());
    EXPECT_EQ(many(33)["items"].size(), 2u);
    EXPECT_EQ(many(33)["missing"][0]["message"],
              "faces, edges and corners of one glBegin are not drawn in their order");
}

TEST(WebglFrame, NamesEdgesThatClippingAdds) {
    const auto missing = [](const std::string& before, const char* mode) {
        return header_of(before + "glPolygonMode(GL_FRONT_AND_BACK, " + mode +
                         "); glRectf(0, 0, 0.9, 0.9);")["missing"];
    };
    const std::string plane = "glClipPlane(GL_CLIP_PLANE0, (GLdouble[]){-1, 0, 0, 0.5}); glEnable(GL_CLIP_PLANE0);";
    for (const char* mode : {"GL_LINE", "GL_POINT"}) {
        EXPECT_EQ(missing("", mode), Json::array()) << mode;
        for (const std::string& clips : {plane, std::string("glScalef(2, 2, 1);")}) {
            const Json found = missing(clips, mode);
            ASSERT_EQ(found.size(), 1u) << mode;
            EXPECT_EQ(found[0]["message"], "edges and corners that clipping adds to polygons are missing, as in Mesa");
        }
    }
    EXPECT_EQ(missing(plane, "GL_FILL"), Json::array());
}

TEST(WebglFrame, HasDepthRangesFromNearToFar) {
    const auto drawn = [](const std::string& range) {
        const Json header = header_of(range + " glTranslatef(0, 0, 0.25); glRectf(-1, -1, 1, 1);");
        return std::pair(header["items"][0]["depthRange"],
                         uniforms_of(header["items"][0], header)["u_clip_from_object"]);
    };
    const auto [range, clip_from_object] = drawn("glDepthRange(0.2, 0.9);");
    EXPECT_EQ(range, (Json{0.2, 0.9}));
    EXPECT_EQ(clip_from_object[14], 0.25);
    const auto [reversed_range, reversed_clip_from_object] = drawn("glDepthRange(0.9, 0.2);");
    EXPECT_EQ(reversed_range, (Json{0.2, 0.9}));
    EXPECT_EQ(reversed_clip_from_object[14], -0.25);
}

// Two triangles. Each corner has the place of the line's other end, and says at which end and on which side it is.
TEST(WebglFrame, DrawsWideLinesAsRectangles) {
    PageScene scene;
    scene.open("glLineWidth(3); glBegin(GL_LINES); glVertex2f(-0.5, 0); glVertex2f(0.5, 0.25); glEnd();", "scene", "",
               {64, 64});
    const webgl::WebglFrame frame = scene.webgl_frame({});
    const Json header = frame.header, item = header["items"][0];
    EXPECT_EQ(header["missing"], Json::array());
    EXPECT_EQ(item["parts"][0][0], kGL_TRIANGLES);
    EXPECT_EQ(item["parts"][0][2], 6);
    const Json sizes = header["programs"][0]["attributes"];
    EXPECT_EQ(sizes, (Json{4, 4, 4, 3})) << "position, colour, the other end's position, which corner";
    const std::size_t first = item["vertices"][0], stride = 15;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        float own[4], other[4], which[3];
        const auto copy = [&](auto& to, std::size_t from) {
            std::memcpy(to, frame.words.data() + first + corner * stride + from, sizeof to);
        };
        copy(own, 0);
        copy(other, 8);
        copy(which, 12);
        EXPECT_EQ(own[0], corner < 2 ? -0.5F : 0.5F);
        EXPECT_EQ(other[0], corner < 2 ? 0.5F : -0.5F);
        EXPECT_EQ(which[0], corner < 2 ? -1 : 1);
        EXPECT_EQ(which[1], corner % 2 == 0 ? -1 : 1) << "right and left";
        EXPECT_EQ(which[2], 0);
    }
}

// Whether any fragment shader of the scene has this text.
bool has_fragment_text(const Json& header, const char* text) {
    return std::ranges::any_of(header["programs"], [&](const Json& program) {
        return program["fragment"].get<std::string>().find(text) != std::string::npos;
    });
}

// Also of lines that are not visible now, for any pose.
TEST(WebglFrame, HasAllLinesForAnyPose) {
    PageScene scene;
    scene.open(
        "glLineWidth(3); glBegin(GL_LINES); glVertex2f(2, 0); glVertex2f(3, 0); glVertex2f(0, 0); glVertex2f(0, 1); "
        "glEnd();",
        "scene", "", {64, 64});
    const auto count = [&](bool for_any_pose) {
        PlanOptions options;
        options.for_any_pose = for_any_pose;
        return webgl::webgl_frame(scene.scene().frame, options).header["items"][0]["parts"][0][2];
    };
    EXPECT_EQ(count(false), 6);
    EXPECT_EQ(count(true), 12);
}

// Lines and points are never culled, and have no polygon offset.
TEST(WebglFrame, DoesNotCullRectanglesOfLines) {
    const std::string state =
        "glEnable(GL_CULL_FACE); glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset(1, 1); glLineWidth(3); ";
    const Json line = header_of(state + "glBegin(GL_LINES); glVertex2f(0, 0); glVertex2f(1, 1); glEnd();")["items"][0],
               face = header_of(state + "glRectf(0, 0, 1, 1);")["items"][0];
    for (const char* name : {"cull", "offset"}) {
        EXPECT_FALSE(line.contains(name)) << name;
        EXPECT_TRUE(face.contains(name)) << name;
    }
}

// WebGL refuses different references or masks of front and back. Where no polygons are culled, each side is drawn by itself.
TEST(WebglFrame, DrawsEachSideThatHasItsOwnStencilReference) {
    const auto item = [](const std::string& text) {
        const Json header =
            header_of("glEnable(GL_STENCIL_TEST); glStencilFuncSeparate(GL_BACK, GL_EQUAL, 3, 7); " + text);
        EXPECT_EQ(header["missing"], Json::array());
        return header["items"][0];
    };
    const std::string two_squares =
        "glBegin(GL_QUADS); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(1, 1); glVertex2f(0, 1); "
        "glVertex2f(0.5, 0); glVertex2f(0.5, 1); glVertex2f(1, 1); glVertex2f(1, 0); glEnd();";
    EXPECT_EQ(item(two_squares)["sides"], true);
    EXPECT_EQ(item(two_squares)["parts"].size(), 2u) << "they overlap";
    EXPECT_FALSE(item("glBegin(GL_LINES); glVertex2f(0, 0); glVertex2f(1, 1); glEnd();").contains("sides"));
    const Json culled = item("glEnable(GL_CULL_FACE); glCullFace(GL_FRONT); " + two_squares);
    EXPECT_FALSE(culled.contains("sides"));
    EXPECT_EQ(culled["stencil"][0], culled["stencil"][1]);
    EXPECT_EQ(culled["stencil"][0][1], 3);
}

TEST(WebglFrame, StipplesInTheFragmentShader) {
    const Json lines = header_of(
        "glEnable(GL_LINE_STIPPLE); glLineStipple(3, 0x3F3F); glBegin(GL_LINES); glVertex2f(0, 0); glVertex2f(0.5, 0); "
        "glEnd();");
    EXPECT_EQ(lines["missing"], Json::array());
    EXPECT_TRUE(has_fragment_text(lines, "u_line_stipple_pattern >> (count / u_line_stipple_factor % 16)"));
    EXPECT_EQ(uniforms_of(lines["items"][0], lines)["u_line_stipple_factor"], (Json{3}));
    EXPECT_EQ(uniforms_of(lines["items"][0], lines)["u_line_stipple_pattern"], (Json{0x3F3F}));

    const Json polygons = header_of("glEnable(GL_POLYGON_STIPPLE); glRectf(-1, -1, 1, 1);");
    EXPECT_EQ(polygons["missing"], Json::array());
    EXPECT_TRUE(has_fragment_text(polygons, "u_polygon_stipple[pixel.y] >> pixel.x & 1u"));
    EXPECT_EQ(uniforms_of(polygons["items"][0], polygons)["u_polygon_stipple"].size(), 32u);
}

// The edges of a back face are triangles that gl_FrontFacing knows as such.
TEST(WebglFrame, DrawsEdgesOfBackFacesAsRectanglesIfTheyHaveTheirOwnColours) {
    const std::string scene =
        "glEnable(GL_LIGHTING); glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); glMaterialfv(GL_BACK, GL_EMISSION, "
        "(GLfloat[]){1, 0, 0, 1}); glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); ";
    const Json front = header_of(scene + "glRectf(-0.5, -0.5, 0.5, 0.5);"),
               back = header_of(scene + "glRectf(0.5, -0.5, -0.5, 0.5);");
    EXPECT_EQ(front["items"][0]["parts"][0][0], kGL_LINES);
    EXPECT_EQ(back["items"][0]["parts"][0][0], kGL_TRIANGLES);
    EXPECT_EQ(back["items"][0]["parts"][0][2], 24);
    EXPECT_EQ(back["missing"], Json::array());
}

// A rim of one texel, only where the border shows.
TEST(WebglFrame, PutsTheBordersColourAroundTextures) {
    const std::string texture =
        "GLubyte red[] = {255, 0, 0, 255}; glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, "
        "red); glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, (GLfloat[]){0, 0, 1, 1}); "
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER); glEnable(GL_TEXTURE_2D); ";
    const std::string square =
        "glBegin(GL_TRIANGLES); glVertex2f(0, 0); glTexCoord2f(2, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();";
    PageScene scene;
    scene.open(texture + "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); " + square, "scene", "",
               {64, 64});
    const webgl::WebglFrame frame = scene.webgl_frame({});
    const Json image = frame.header["textures"][0]["images"][0];
    EXPECT_EQ(frame.header["textures"][0]["images"].size(), 1u);
    EXPECT_EQ((Json{image[2], image[3], image[4]}), (Json{3, 1, 1}));
    const std::size_t first = image[5];
    EXPECT_EQ(frame.words[first], 0xFFFF0000u) << "blue";
    EXPECT_EQ(frame.words[first + 1], 0xFF0000FFu) << "red";
    EXPECT_EQ(frame.words[first + 2], 0xFFFF0000u);
    const Json inside = uniforms_of(frame.header["items"][0], frame.header)["u_texture_inside"];
    EXPECT_EQ(inside, (Json{1.0 / 3, 1, 1}));
    EXPECT_EQ(Json(frame.header["missing"]), Json::array());

    const Json mipmapped = header_of(texture + square);
    EXPECT_EQ(mipmapped["textures"][0]["images"][0][2], 1);
    ASSERT_EQ(mipmapped["missing"].size(), 1u);
    EXPECT_EQ(mipmapped["missing"][0]["message"],
              "the border colour of cube maps and textures with mipmaps is replaced by their last texels");
}

// Each primitive sees those before it, also those of its own draw. Where none overlap, one copy of the picture is enough.
TEST(WebglFrame, CombinesEachPrimitiveWithThePictureBeforeIt) {
    const auto counts_of = [](const std::string& commands) {
        const Json header = header_of("glEnable(GL_COLOR_LOGIC_OP); glLogicOp(GL_XOR); " + commands);
        EXPECT_EQ(header["missing"], Json::array());
        EXPECT_TRUE(has_fragment_text(header, "color = vec4((source ^ stored) & 255u) / 255.0;"));
        EXPECT_EQ(header["items"][0]["framebuffer"], "u_framebuffer");
        Json counts = Json::array();
        for (const Json& part : header["items"][0]["parts"]) counts.push_back(part[2]);
        return counts;
    };
    const auto squares = [](double x) {
        return fmt::format(
            "glBegin(GL_QUADS); glVertex2f(-0.5, -0.5); glVertex2f(0, -0.5); glVertex2f(0, 0.5); glVertex2f(-0.5, "
            "0.5); "
            "glVertex2f({0}, -0.5); glVertex2f(0.9, -0.5); glVertex2f(0.9, 0.5); glVertex2f({0}, 0.5); glEnd();",
            x);
    };
    EXPECT_EQ(counts_of(squares(0.3)), (Json{12})) << "apart";
    EXPECT_EQ(counts_of(squares(0)), (Json{12})) << "a common edge";
    EXPECT_EQ(counts_of(squares(-0.1)), (Json{6, 6}));
    EXPECT_EQ(counts_of("glBegin(GL_TRIANGLE_STRIP); glVertex2f(0, 0); glVertex2f(0.5, 0); glVertex2f(0, 0.5); "
                        "glVertex2f(0.5, 0.5); glVertex2f(0, 0.2); glEnd();"),
              (Json{6, 3}))
        << "the last triangle folds back";
    EXPECT_EQ(counts_of("glBegin(GL_LINE_STRIP); glVertex2f(0, 0); glVertex2f(0.5, 0); glVertex2f(0, 0.5); glEnd();"),
              (Json{2, 2}));

    const Json header = header_of("glEnable(GL_COLOR_LOGIC_OP); glLogicOp(GL_COPY_INVERTED); " + squares(-0.1));
    EXPECT_EQ(header["items"][0]["parts"].size(), 1u) << "needs no copy";
    EXPECT_FALSE(header["items"][0].contains("framebuffer"));
}

TEST(WebglFrame, NamesWhatWebglLacks) {
    const Json missing = header_of(
        "glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){1, "
        "2, 3, 4});\n"
        "glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){1, "
        "2, 3, 4});\n"
        "glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){1, "
        "2, 3, 4});\n"
        "glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){1, "
        "2, 3, 4});\n"
        "glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Z, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){1, "
        "2, 3, 4});\n"
        "glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){1, "
        "2, 3, 4});\n"
        "glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);\n"
        "glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);\n"
        "glEnable(GL_TEXTURE_CUBE_MAP); glRectf(0, 0, 1, 1);")["missing"];
    ASSERT_EQ(missing.size(), 1u);
    EXPECT_EQ(missing[0]["line"], 9);
    EXPECT_EQ(missing[0]["message"],
              "the border colour of cube maps and textures with mipmaps is replaced by their last texels");
}

TEST(PageScene, ShowsErrorsAtTheirPlaces) {
    PageScene scene;
    const Json answer = Json::parse(scene.open("glRectf(0, 0, 1, 1);\n  glFoo();\n", "scene", "", {64, 64}));
    ASSERT_EQ(answer["errors"].size(), 1u);
    EXPECT_EQ(answer["errors"][0]["line"], 2);
    EXPECT_EQ(answer["errors"][0]["column"], 3);
    EXPECT_FALSE(scene.is_open());
}

// A ramp of 0.1 a pixel: half of 1/16 pixel moves a colour by 0.1 / 32.
// The border of two texels is 0.02 pixels to the right of a column's centres.
TEST(PageScene, AllowsTheNextTexelWithinTheStepOfTheBrowsersPositions) {
    PageScene scene;
    scene.open(
        "GLubyte texels[] = {255, 0, 0, 255,  0, 255, 0, 255}; glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, "
        "GL_RGBA, "
        "GL_UNSIGNED_BYTE, texels); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);"
        "glMatrixMode(GL_TEXTURE); glTranslated((0.5 - 0.02) / 64, 0, 0);"
        "glBegin(GL_QUADS); glTexCoord2f(0, 0); glVertex2f(-1, -1); glTexCoord2f(1, 0); glVertex2f(1, -1);"
        "glTexCoord2f(1, 1); glVertex2f(1, 1); glTexCoord2f(0, 1); glVertex2f(-1, 1); glEnd();",
        "scene", "", {64, 64});
    const auto right = scene.reference({}, 0, 64);
    std::vector<std::uint8_t> drawn(right.begin(), right.end());
    std::vector<float> reference;
    for (const std::uint8_t code : drawn) reference.push_back(static_cast<float>(code) / 255);
    const auto is_within = [&](int bits) -> bool {
        return Json::parse(scene.judged({}, drawn, reference, bits))["within"];
    };
    for (const std::size_t column : {31u, 30u}) {
        ASSERT_EQ(drawn[4 * (64 * 20 + column)], 255) << "the left texel";
        for (std::size_t y = 0; y < 64; ++y) {
            drawn[4 * (64 * y + column)] = 0;
            drawn[4 * (64 * y + column) + 1] = 255;
        }
        EXPECT_EQ(is_within(4), column == 31u) << "half of 1/16 is more than 0.02, and less than 1.02";
        EXPECT_FALSE(is_within(8)) << "1/256 is less";
    }
}

TEST(Tolerance, AllowsWhatRoundedPositionsChange) {
    Image ramp(4, 1);
    for (int x = 0; x < 4; ++x) ramp.at(x, 0) = {0.1F * static_cast<float>(x), 0, 0, 1};
    AllowedDifference allowed(4, 1);
    allowed.edge[3] = true;
    compare::allow_rounded_positions(allowed, ramp, 4);
    for (int x = 0; x < 3; ++x) {
        EXPECT_FLOAT_EQ(allowed.channels(static_cast<std::size_t>(x))[0], 0.1F / 32);
        EXPECT_EQ(allowed.channels(static_cast<std::size_t>(x))[1], 0);
    }
}

}  // namespace

}  // namespace twinlight::web::webgl_frame_test
