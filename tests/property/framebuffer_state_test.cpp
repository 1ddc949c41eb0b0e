// The driver as a second opinion on framebuffer objects: after each of many random commands it raises the same error, finds the
// bound objects as complete, and has the same ones bound.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "judge/fuzz/random.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::framebuffer_state_test {
namespace {

class RandomCommands {
  public:
    explicit RandomCommands(std::uint64_t seed) : random_(seed) {}

    std::string next() {
        switch (random_.below(22)) {
            case 0:
            case 1: return fmt::format("glBindFramebuffer({}, {});", target(), name(3));
            case 2:
                return fmt::format("glBindRenderbuffer({}, {});", rarely("GL_FRAMEBUFFER", "GL_RENDERBUFFER"), name(4));
            case 3:
            case 4:
                return fmt::format("glRenderbufferStorage(GL_RENDERBUFFER, {}, {}, {});",
                                   one({"GL_DEPTH_COMPONENT", "GL_DEPTH_COMPONENT16", "GL_DEPTH24_STENCIL8",
                                        "GL_STENCIL_INDEX8", "GL_RGBA8", "GL_RGB", "GL_LUMINANCE", "GL_FRONT"}),
                                   size(), size());
            case 5:
            case 6:
            case 7:
                return fmt::format("glFramebufferTexture2D({}, {}, {}, {}, {});", target(), attachment(),
                                   one({"GL_TEXTURE_2D", "GL_TEXTURE_2D", "GL_TEXTURE_2D", "GL_TEXTURE_1D",
                                        "GL_TEXTURE_CUBE_MAP_POSITIVE_X"}),
                                   name(4), one({"0", "0", "0", "0", "15", "-1"}));
            case 8:
            case 9:
            case 10:
                return fmt::format("glFramebufferRenderbuffer({}, {}, {}, {});", target(), attachment(),
                                   rarely("GL_TEXTURE_2D", "GL_RENDERBUFFER"), name(4));
            case 11: return fmt::format("glBindTexture({}, {});", rarely("GL_TEXTURE_1D", "GL_TEXTURE_2D"), name(4));
            case 12:
                return fmt::format("glTexImage2D(GL_TEXTURE_2D, 0, {}, {}, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);",
                                   one({"GL_RGBA8", "GL_RGB", "GL_LUMINANCE", "GL_RGBA4"}), random_.below(9));
            case 13:
                return fmt::format(
                    "glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, {}, 8, 0, GL_DEPTH_COMPONENT, "
                    "GL_UNSIGNED_INT, NULL);",
                    random_.below(9));
            case 14:
                return one({"glClear(GL_COLOR_BUFFER_BIT);", "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);"});
            case 15: return "glRectf(-1, -1, 1, 1);";
            case 16:
                return fmt::format("glDrawBuffer({});", one({"GL_NONE", "GL_COLOR_ATTACHMENT0", "GL_COLOR_ATTACHMENT0",
                                                             "GL_COLOR_ATTACHMENT1", "GL_COLOR_ATTACHMENT15"}));
            case 17: return rarely("glAccum(GL_LOAD, 1);", "glGenerateMipmap(GL_TEXTURE_2D);");
            case 18: return fmt::format("glDeleteTextures(1, (GLuint[]){{{}}});", name(4));
            case 19: return fmt::format("glDeleteRenderbuffers(1, (GLuint[]){{{}}});", name(4));
            case 20: return fmt::format("glDeleteFramebuffers(1, (GLuint[]){{{}}});", name(3));
            default:
                return fmt::format("glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, {}, 8, 0);",
                                   1 + random_.below(8));
        }
    }

  private:
    std::string one(const std::vector<std::string>& choices) {
        return choices[static_cast<std::size_t>(random_.below(static_cast<int>(choices.size())))];
    }
    std::string rarely(const std::string& rare, const std::string& usual) { return random_.chance(0.1) ? rare : usual; }
    std::string target() {
        return one({"GL_FRAMEBUFFER", "GL_FRAMEBUFFER", "GL_FRAMEBUFFER", "GL_DRAW_FRAMEBUFFER", "GL_READ_FRAMEBUFFER",
                    "GL_RENDERBUFFER"});
    }
    std::string attachment() {
        return one({"GL_COLOR_ATTACHMENT0", "GL_COLOR_ATTACHMENT0", "GL_DEPTH_ATTACHMENT", "GL_DEPTH_ATTACHMENT",
                    "GL_STENCIL_ATTACHMENT", "GL_DEPTH_STENCIL_ATTACHMENT", "GL_COLOR_ATTACHMENT1",
                    "GL_COLOR_ATTACHMENT15", "GL_FRONT"});
    }
    int name(int most) { return random_.below(most + 1); }
    std::string size() { return one({"0", "8", "8", "8", "9", "-1", "20000"}); }

    fuzz::Random random_;
};

constexpr const char* kStart =
    "glBindTexture(GL_TEXTURE_2D, 1); glBindRenderbuffer(GL_RENDERBUFFER, 1); glBindFramebuffer(GL_FRAMEBUFFER, 1);\n"
    "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);\n"
    "glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 8, 8);\n"
    "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 1, 0);\n"
    "glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 1);\n";

// What Mesa (22.3) refuses, but not the specification: mipmaps of a texture without an image, and a renderbuffer without both depths
// and stencil as both. A driver without an accumulation buffer (EGL's, windows') gives another error for glAccum.
bool is_departure(const std::string& line, const State& state) {
    GLint accumulation_bits = 0;
    glGetIntegerv(GL_ACCUM_RED_BITS, &accumulation_bits);
    if (accumulation_bits == 0 && line.starts_with("glAccum")) return true;
    if (line.starts_with("glGenerateMipmap")) {
        const std::vector<TextureImage>& levels = state.bound_texture(kGL_TEXTURE_2D).levels;
        return levels.empty() || levels.front().texels.empty();
    }
    return line.starts_with("glFramebufferRenderbuffer") && line.find("GL_DEPTH_STENCIL") != std::string::npos &&
           line.find(", 0)") == std::string::npos;
}

TEST(FramebufferState, IsTheDriversAfterRandomCommands) {
    const auto context = make_offscreen_context(16, 16);
    int errors = 0, complete = 0;
    for (std::uint64_t seed = 1; seed <= 1000 && !testing::Test::HasFailure(); ++seed) {
        fixed::Driver driver(16, 16);
        State state({.width = 16, .height = 16});
        RandomCommands random(seed);
        std::string text;
        for (const Command& command : read_scene(kStart, "start", "start").commands) {
            driver.execute(command);
            state.apply(command);
        }
        for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
            const std::string line = random.next();
            text += line + "\n";
            SCOPED_TRACE(fmt::format("seed {}, after\n{}{}", seed, kStart, text));
            if (is_departure(line, state)) continue;
            const std::size_t before = state.errors().size();
            for (const Command& command : read_scene(line, "line", "line").commands) {
                driver.execute(command);
                state.apply(command);
            }
            const GLenum expected = state.errors().size() > before ? state.errors().back().code : GLenum{GL_NO_ERROR};
            EXPECT_EQ(glGetError(), expected) << (expected == GL_NO_ERROR ? "" : state.errors().back().message);
            errors += expected != GL_NO_ERROR ? 1 : 0;
            const Framebuffers& framebuffers = state.framebuffers();
            for (const GLenum target : {GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER}) {
                const Enum status = state.framebuffer_status(target);
                EXPECT_EQ(glCheckFramebufferStatus(target), status);
                const std::uint32_t bound = target == GL_DRAW_FRAMEBUFFER ? framebuffers.draw : framebuffers.read;
                complete += bound != 0 && status == kGL_FRAMEBUFFER_COMPLETE ? 1 : 0;
            }
            const auto is_bound = [&](GLenum query, ObjectType type, std::uint32_t name) {
                GLint found = -1;
                glGetIntegerv(query, &found);
                EXPECT_EQ(static_cast<std::uint32_t>(found), driver.name_of(type, name));
            };
            is_bound(GL_DRAW_FRAMEBUFFER_BINDING, ObjectType::kFramebuffer, framebuffers.draw);
            is_bound(GL_READ_FRAMEBUFFER_BINDING, ObjectType::kFramebuffer, framebuffers.read);
            is_bound(GL_RENDERBUFFER_BINDING, ObjectType::kRenderbuffer, framebuffers.renderbuffer);
        }
    }
    EXPECT_GT(errors, 5000);
    EXPECT_GT(complete, 5000);
}

}  // namespace
}  // namespace twinlight::framebuffer_state_test
