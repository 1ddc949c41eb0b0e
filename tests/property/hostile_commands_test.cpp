// Recordings with harmful commands: they read outside their memory, need too much memory, or never end.
#include <gtest/gtest.h>

#include "hostile_traces.h"

namespace twinlight::hostile_commands_test {

namespace {

class HostileCommands : public HostileTraces {};

// ---- Memory ----

TEST_F(HostileCommands, GiveBlobsOfWrongSizes) {
    const std::string arrays = "glEnableClientState(GL_VERTEX_ARRAY)\n";
    for (const char* name : {"tiny.bin", "empty.bin", "triangle.bin", "zeros.bin", "nan.bin"}) {
        SCOPED_TRACE(name);
        const auto with = [&](const std::string& text) {
            return before_triangle(
                fmt::format(fmt::runtime(text), fmt::arg("blob", fmt::format("blob(\"{}\")", name))));
        };
        EXPECT_EQ(with(arrays + "glVertexPointer(3, GL_FLOAT, 0, {blob})\nglDrawArrays(GL_TRIANGLES, 0, 9)\n"),
                  kPicture);
        EXPECT_EQ(
            with(arrays + "glVertexPointer(3, GL_FLOAT, 0, {blob})\nglDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, "
                          "blob(\"indices.bin\"))\n"),
            kPicture);
        EXPECT_EQ(with("glInterleavedArrays(GL_T4F_C4F_N3F_V4F, 0, {blob})\nglBegin(GL_LINES)\nglArrayElement(0)\n"
                       "glArrayElement(70)\nglArrayElement(-1)\nglArrayElement(2147483647)\nglEnd()\n"),
                  kPicture);
        EXPECT_EQ(with("glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, {blob})\n"
                       "glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGB, GL_UNSIGNED_SHORT, {blob})\n"
                       "glEnable(GL_TEXTURE_2D)\n"),
                  kPicture);
        // Formats that State does not support.
        for (const char* format :
             {"GL_DEPTH_COMPONENT, GL_FLOAT", "GL_COLOR_INDEX, GL_BITMAP", "6401, GL_UNSIGNED_BYTE", "0x8227, GL_FLOAT",
              "0x84F9, 0x84FA", "0x8D99, GL_INT", "0x1901, GL_BITMAP"}) {
            EXPECT_EQ(with(fmt::format("glTexImage2D(GL_TEXTURE_2D, 0, 0x1902, 512, 512, 0, {0}, {{blob}})\n"
                                       "glRasterPos2f(0, 0)\nglDrawPixels(512, 512, {0}, {{blob}})\n",
                                       format)),
                      kPicture);
        }
        EXPECT_EQ(
            with("glNewList(1, GL_COMPILE)\nglCallLists(1000000, GL_UNSIGNED_INT, {blob})\n"
                 "glTexImage1D(GL_TEXTURE_1D, 0, 3, 4096, 0, GL_RGB, GL_FLOAT, {blob})\nglEndList()\nglCallList(1)\n"),
            kPicture);
        EXPECT_EQ(
            with("glBindBuffer(GL_ARRAY_BUFFER, 1)\nglBufferData(GL_ARRAY_BUFFER, 65536, {blob}, GL_STATIC_DRAW)\n"
                 "glBufferSubData(GL_ARRAY_BUFFER, 0, 65536, {blob})\n"),
            kPicture);
        EXPECT_EQ(with("gluBuild2DMipmaps(GL_TEXTURE_2D, 3, 64, 64, GL_RGB, GL_UNSIGNED_BYTE, {blob})\n"
                       "gluBuild2DMipmaps(GL_TEXTURE_2D, 3, 64, 64, GL_DEPTH_COMPONENT, GL_FLOAT, {blob})\n"),
                  kPicture);
    }
}

TEST_F(HostileCommands, GiveNoMemoryWhereItIsNeeded) {
    for (const char* call :
         {"glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, NULL)", "glCallLists(9, GL_INT, NULL)",
          "gluBuild2DMipmaps(GL_TEXTURE_2D, 3, 64, 64, GL_RGB, GL_UNSIGNED_BYTE, NULL)",
          "glTexImage2D(GL_TEXTURE_2D, 0, 3, 8, 8, 0, GL_RGB, GL_FLOAT, 0x1234)",
          "glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGB, GL_FLOAT, NULL)",
          "glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, 0x1234)",
          "glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, NULL)",
          "glBufferData(GL_ARRAY_BUFFER, 8, 0x1234, GL_STATIC_DRAW)", "glCallLists(9, GL_INT, 0x1234)"}) {
        for (const char* before :
             {"", "glNewList(1, GL_COMPILE)\n", "glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 3)\n",
              "glBindBuffer(GL_ARRAY_BUFFER, 3)\n", "glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 3)\n"}) {
            const std::string end =
                *before != '\0' && std::string(before).starts_with("glNewList") ? "glEndList()\nglCallList(1)\n" : "";
            EXPECT_EQ(before_triangle(fmt::format("2 glRasterPos2f(0, 0)\nglEnableClientState(GL_VERTEX_ARRAY)\n"
                                                  "glVertexPointer(3, GL_FLOAT, 0, blob(\"triangle.bin\"))\n{}{}\n{}",
                                                  before, call, end)),
                      kPicture)
                << before << call;
        }
    }
}

// Drivers accept commands of later GL versions, and refuse others, by their own rules.
TEST_F(HostileCommands, LeadTheDriverElsewhereThanState) {
    const std::string good =
        "2 glEnableClientState(GL_VERTEX_ARRAY)\nglVertexPointer(3, GL_FLOAT, 0, blob(\"zeros.bin\"))\n";
    const std::string tiny =
        "2 glEnableClientState(GL_VERTEX_ARRAY)\nglVertexPointer(3, GL_FLOAT, 0, blob(\"tiny.bin\"))\n";
    const std::string draw = "glDrawArrays(GL_POINTS, 0, 300)\n";
    // GL_HALF_FLOAT and GL_FIXED; BGRA for a size; a mode of GL 3.2.
    EXPECT_EQ(before_triangle(good + "glVertexPointer(3, 0x140B, 0, blob(\"tiny.bin\"))\n" + draw), kPicture);
    EXPECT_EQ(before_triangle(good + "glVertexPointer(3, 0x140C, 0, blob(\"tiny.bin\"))\n" + draw), kPicture);
    EXPECT_EQ(before_triangle(
                  good + "glEnableClientState(GL_COLOR_ARRAY)\nglColorPointer(4, GL_FLOAT, 0, blob(\"zeros.bin\"))\n"
                         "glColorPointer(0x80E1, GL_UNSIGNED_BYTE, 0, blob(\"tiny.bin\"))\n"
                         "glDrawArrays(GL_POINTS, 0, 200)\n"),
              kPicture);
    EXPECT_EQ(before_triangle(tiny + "glDrawArrays(0xA, 0, 4000000)\n"), kPicture);
    // A stride larger than the driver allows: the old pointer stays.
    write("wide.bin", std::string(300 * 4096, '\0'));
    EXPECT_EQ(before_triangle(tiny + "glVertexPointer(3, GL_FLOAT, 4096, blob(\"wide.bin\"))\n" + draw), kPicture);
    // Pointers, switches and buffers are refused between glBegin and glEnd.
    EXPECT_EQ(before_triangle(
                  tiny + "glBegin(GL_POINTS)\nglVertexPointer(3, GL_FLOAT, 0, blob(\"zeros.bin\"))\nglEnd()\n" + draw),
              kPicture);
    EXPECT_EQ(before_triangle(tiny +
                              "glNewList(1, GL_COMPILE)\nglBegin(GL_POINTS)\nglEndList()\nglCallList(1)\n"
                              "glVertexPointer(3, GL_FLOAT, 0, blob(\"zeros.bin\"))\nglEnd()\n" +
                              draw),
              kPicture);
    EXPECT_EQ(before_triangle(tiny + "glBegin(GL_POINTS)\nglDisableClientState(GL_VERTEX_ARRAY)\nglEnd()\n" + draw),
              kPicture);
    EXPECT_EQ(before_triangle(good + "glBegin(GL_POINTS)\nglBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 1)\nglBufferData("
                                     "GL_ELEMENT_ARRAY_BUFFER, 4, blob(\"tiny.bin\"), GL_STATIC_DRAW)\nglEnd()\n"
                                     "glDrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, 3)\n"),
              kPicture);
    EXPECT_EQ(before_triangle(
                  "2 glBegin(GL_POINTS)\nglBindBuffer(GL_PIXEL_UNPACK_BUFFER, 1)\nglEnd()\nglTexImage2D(GL_TEXTURE_2D, "
                  "0, 3, 8, 8, 0, GL_RGB, GL_FLOAT, 0x1234)\n"),
              kPicture);
    // Buffer targets that State does not support.
    EXPECT_EQ(before_triangle(
                  "2 glBindBuffer(0x8F37, 5)\nglBufferData(0x8F37, 100000000, blob(\"tiny.bin\"), GL_STATIC_DRAW)\n"
                  "glBufferSubData(0x8F37, 0, 100000000, blob(\"tiny.bin\"))\n"),
              kPicture);
    // A range beyond the end of the array.
    write("same.bin", std::string(4096, '\0'));
    EXPECT_EQ(before_triangle(
                  "2 glEnableClientState(GL_VERTEX_ARRAY)\nglVertexPointer(3, GL_FLOAT, 0, blob(\"triangle.bin\"))\n"
                  "glDrawRangeElements(GL_POINTS, 0, 4095, 4096, GL_UNSIGNED_BYTE, blob(\"same.bin\"))\n"
                  "glDrawRangeElements(GL_POINTS, 0, 4294967295, 4096, GL_UNSIGNED_BYTE, blob(\"same.bin\"))\n"),
              kPicture);
    // A texture name with a different owner when the attributes are restored.
    EXPECT_EQ(
        before_triangle(
            "2 glBindTexture(GL_TEXTURE_2D, 5)\nglPushAttrib(GL_TEXTURE_BIT)\nglDeleteTextures(1, {5})\n"
            "glGenTextures(1, {5})\nglPopAttrib()\nglTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP)\n"),
        kPicture);
}

// ---- Numbers ----

TEST_F(HostileCommands, HaveIndicesAndStridesBeyondAllMemory) {
    write("last.bin", std::string(16, '\xff'));
    const std::string arrays = "2 glEnableClientState(GL_VERTEX_ARRAY)\n";
    for (const char* stride : {"0", "1", "2147483647"}) {
        for (const char* offset : {"0", "-12", "9007199254740991", "-9007199254740991", "4294967296"}) {
            const std::string in_buffer = arrays +
                                          "glBindBuffer(GL_ARRAY_BUFFER, 1)\nglBufferData(GL_ARRAY_BUFFER, 36, "
                                          "blob(\"triangle.bin\"), GL_STATIC_DRAW)\n" +
                                          fmt::format("glVertexPointer(3, GL_FLOAT, {}, {})\n", stride, offset);
            EXPECT_EQ(
                before_triangle(in_buffer + "glDrawElements(GL_POINTS, 4, GL_UNSIGNED_INT, blob(\"last.bin\"))\n"
                                            "glDrawArrays(GL_POINTS, 2147483647, 1)\nglDrawArrays(GL_POINTS, -1, 1)\n"),
                kPicture);
            EXPECT_EQ(before_triangle(arrays +
                                      "glVertexPointer(3, GL_FLOAT, 0, blob(\"triangle.bin\"))\nglBindBuffer("
                                      "GL_ELEMENT_ARRAY_BUFFER, 1)\nglBufferData(GL_ELEMENT_ARRAY_BUFFER, 16, "
                                      "blob(\"zeros.bin\"), GL_STATIC_DRAW)\n" +
                                      fmt::format("glDrawElements(GL_POINTS, 3, GL_UNSIGNED_BYTE, {})\n", offset)),
                      kPicture);
        }
    }
    // 2^30 rows of 2^34 bytes: 2^64 in all, which wraps to 0.
    for (const char* rows : {"1073741823", "1073741824", "2147483647"}) {
        EXPECT_EQ(
            before_triangle(fmt::format("2 glPixelStorei(GL_UNPACK_ROW_LENGTH, 1073741824)\nglPixelStorei("
                                        "GL_UNPACK_SKIP_ROWS, {})\nglTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, "
                                        "GL_RGBA, GL_FLOAT, blob(\"zeros.bin\"))\n",
                                        rows)),
            kPicture);
    }
}

TEST_F(HostileCommands, HaveAbsurdCounts) {
    const std::string most = "2147483647";
    // GL errors, and commands that do nothing: the picture is drawn.
    for (const std::string& call : std::vector<std::string>{
             "glGenLists(" + most + ") = 1",
             "glGenLists(" + most + ") = 4294967295",
             "glGenLists(-1) = 0",
             "glDeleteLists(1, " + most + ")",
             "glDeleteLists(4294967295, " + most + ")",
             "glDeleteLists(0, -1)",
             "glTexImage2D(GL_TEXTURE_2D, 0, 3, " + most + ", " + most + ", 0, GL_RGB, GL_FLOAT, NULL)",
             "glTexImage2D(GL_TEXTURE_2D, " + most + ", 3, 1, 1, 0, GL_RGB, GL_FLOAT, NULL)",
             "glTexImage2D(GL_TEXTURE_2D, 0, 3, -1, 1, " + most + ", GL_RGB, GL_FLOAT, NULL)",
             "glTexSubImage2D(GL_TEXTURE_2D, 0, " + most + ", -1, " + most + ", 5, GL_RGB, GL_FLOAT, NULL)",
             "glPixelStorei(GL_UNPACK_ROW_LENGTH, -5)",
             std::string("glPixelStoref(GL_UNPACK_SKIP_ROWS, 1e30)"),
             "glVertexPointer(4, GL_DOUBLE, " + most + ", NULL)",
             "glLineWidth(1e30)",
             "glPointSize(1e30)",
             "glLineStipple(" + most + ", 65535)",
             "glGenTextures(-1, {})",
             "glListBase(4294967295)",
             "glCopyPixels(-5, -5, " + most + ", " + most + ", GL_COLOR)",
             "glCopyPixels(0, 0, -1, 1, GL_COLOR)",
             "glViewport(-2147483648, -2147483648, " + most + ", " + most + ")",
             "glViewport(0, 0, 0, 0)",
             "glScissor(-2147483648, 5, " + most + ", " + most + ")\nglEnable(GL_SCISSOR_TEST)",
             "glMapGrid2f(" + most + ", 0, 1, " + most + ", 0, 1)",
             "glActiveTexture(4294967295)",
             "glEnable(4294967295)",
             "glClear(4294967295)",
             "glPushAttrib(4294967295)",
             "glBufferData(GL_ARRAY_BUFFER, -1, NULL, GL_STATIC_DRAW)",
             "glBindTexture(GL_TEXTURE_2D, 4294967295)\nglTexImage2D(GL_TEXTURE_2D, 0, 3, 1, 1, 0, GL_RGB, GL_FLOAT, "
             "NULL)"}) {
        EXPECT_EQ(before_triangle("2 " + call + "\n"), kPicture) << call;
    }
    // More memory than any machine has, and lists shorter than they claim.
    for (const std::string& call : std::vector<std::string>{
             "glDrawArrays(GL_POINTS, 0, " + most + ")", "glDeleteTextures(" + most + ", {1})",
             "glGenTextures(" + most + ", {1})", "glGenBuffers(" + most + ", {1})",
             "glTexImage2D(GL_TEXTURE_2D, 0, 3, 16384, 16384, 0, GL_RGB, GL_FLOAT, NULL)",
             "glBindBuffer(GL_ARRAY_BUFFER, 1)\nglBufferData(GL_ARRAY_BUFFER, 1000000000000, NULL, GL_STATIC_DRAW)",
             "glEnable(GL_MAP1_VERTEX_3)\nglEvalMesh1(GL_LINE, 0, " + most + ")",
             "glEvalMesh2(GL_FILL, -2147483648, " + most + ", 0, " + most + ")",
             "glEvalMesh1(GL_LINE, " + most + ", " + most + ")"}) {
        const std::string told = before_triangle("2 " + call + "\n");
        EXPECT_TRUE(told.find("dump.txt: call ") != std::string::npos) << call << ": " << told;
    }
}

TEST_F(HostileCommands, HaveNumbersThatAreNone) {
    for (const char* value : {"inf", "-inf", "nan", "-nan", "1e38", "-1e38", "1e-45", "1e308"}) {
        EXPECT_EQ(
            before_triangle(fmt::format(
                "2 glMatrixMode(GL_PROJECTION)\nglScaled({0}, {0}, {0})\nglScaled({0}, {0}, {0})\nglScaled({0}, {0}, "
                "{0})\nglMatrixMode(GL_MODELVIEW)\nglTranslatef({0}, 0, {0})\nglRotatef({0}, {0}, 1, 0)\nglEnable("
                "GL_LIGHTING)\nglEnable(GL_LIGHT0)\nglLightfv(GL_LIGHT0, GL_POSITION, {{{0}, 1, {0}, 1}})\n"
                "glMaterialf(GL_FRONT, GL_SHININESS, {0})\nglFogf(GL_FOG_DENSITY, {0})\nglEnable(GL_FOG)\nglDepthRange("
                "{0}, 0)\nglPolygonOffset({0}, {0})\nglEnable(GL_POLYGON_OFFSET_FILL)\nglClipPlane(GL_CLIP_PLANE0, {{"
                "{0}, 1, 1, 1}})\nglEnable(GL_CLIP_PLANE0)\nglBegin(GL_QUADS)\nglColor4f({0}, 1, 1, "
                "{0})\nglNormal3f({0}, "
                "{0}, 1)\nglTexCoord2f({0}, {0})\nglVertex4f({0}, 1, 1, 1)\nglVertex4f(0, {0}, 0, {0})\nglVertex3f(1, "
                "1, "
                "1)\nglVertex2f(0, 0)\nglEnd()\n",
                value)),
            kPicture)
            << value;
    }
}

// ---- Lists and stacks ----

TEST_F(HostileCommands, NestListsTenThousandDeep) {
    std::string lists;
    for (int i = 1; i <= 10'000; ++i) {
        lists += fmt::format("glNewList({0}, GL_COMPILE)\nglCallList({1})\nglEndList()\n", i, i + 1);
    }
    EXPECT_EQ(before_triangle(lists + "glCallList(1)\nglCallList(9990)\n"), kPicture);
    // glNewList in glNewList is GL's own error.
    std::string nested;
    for (int i = 1; i <= 10'000; ++i) nested += fmt::format("glNewList({}, GL_COMPILE_AND_EXECUTE)\n", i);
    EXPECT_EQ(before_triangle(nested + "glEndList()\n"), kPicture);
}

TEST_F(HostileCommands, HaveListsThatCallThemselves) {
    EXPECT_EQ(before_triangle(
                  "2 glNewList(1, GL_COMPILE)\nglCallList(1)\nglRotatef(1, 0, 0, 1)\nglEndList()\nglCallList(1)\n"),
              kPicture);
    EXPECT_EQ(
        before_triangle("2 glNewList(1, GL_COMPILE)\nglCallList(2)\nglEndList()\nglNewList(2, GL_COMPILE_AND_EXECUTE)\n"
                        "glCallList(1)\nglEndList()\nglCallList(2)\n"),
        kPicture);
}

TEST_F(HostileCommands, HaveListsThatComeToTwoToTheFortieth) {
    const auto bomb = [](const std::string& inside) {
        std::string lists = "glNewList(1, GL_COMPILE)\n" + inside + "glEndList()\n";
        for (int i = 2; i <= 40; ++i) {
            lists +=
                fmt::format("glNewList({0}, GL_COMPILE)\nglCallList({1})\nglCallList({1})\nglEndList()\n", i, i - 1);
        }
        return lists + "glCallList(40)\n";
    };
    for (const std::string& inside : std::vector<std::string>{
             std::string(), std::string("glRotatef(1, 0, 0, 1)\n"), kTriangle, std::string("glMatrixMode(GL_FRONT)\n"),
             std::string("glTexImage2D(GL_TEXTURE_2D, 0, 3, 4096, 4096, 0, GL_RGB, GL_FLOAT, NULL)\n")}) {
        const std::string told = before_triangle(bomb(inside));
        EXPECT_TRUE(told.find("call 202") != std::string::npos || told.find("at most") != std::string::npos ||
                    told.find("needs more than 2 GB of memory") != std::string::npos)
            << told;
    }
    const std::string self_twice =
        "2 glNewList(1, GL_COMPILE)\nglCallList(1)\nglCallList(1)\nglEndList()\nglCallList(1)\n";
    EXPECT_NE(before_triangle(self_twice).find("at most"), std::string::npos);
    // A million names per call, of lists that do not exist.
    EXPECT_EQ(before_triangle("2 glCallLists(1048576, GL_UNSIGNED_BYTE, blob(\"names.bin\"))\n"), kPicture);
    EXPECT_NE(before_triangle("2 " + times(60, "glCallLists(1048576, GL_UNSIGNED_BYTE, blob(\"names.bin\"))\n"))
                  .find("at most"),
              std::string::npos);
}

TEST_F(HostileCommands, FillEveryStack) {
    for (const char* push :
         {"glPushMatrix()", "glPushAttrib(1048575)", "glPushClientAttrib(4294967295)", "glPushName(1)",
          "glMatrixMode(GL_TEXTURE)\nglPushMatrix()", "glInitNames()\nglPushName(4294967295)"}) {
        EXPECT_EQ(before_triangle("2 " + times(5000, std::string(push) + "\n")), kPicture) << push;
    }
    EXPECT_EQ(before_triangle("2 " + times(5000, "glPopMatrix()\nglPopAttrib()\nglPopClientAttrib()\nglPopName()\n")),
              kPicture);
}

}  // namespace

}  // namespace twinlight::hostile_commands_test
