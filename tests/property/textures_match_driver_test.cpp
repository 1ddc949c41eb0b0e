// The driver as a second opinion on texture images: what glGetTexImage returns is what State holds, level by level.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "judge/fuzz/random.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/command/text.h"
#include "scene/frame/parameter_rows.h"
#include "scene/state/answers.h"
#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight::textures_match_driver_test {

namespace {

constexpr Enum kInternalFormats[] = {1,
                                     2,
                                     3,
                                     4,
                                     kGL_ALPHA,
                                     kGL_LUMINANCE,
                                     kGL_LUMINANCE_ALPHA,
                                     kGL_INTENSITY,
                                     kGL_RGB,
                                     kGL_RGBA,
                                     kGL_ALPHA4,
                                     kGL_ALPHA8,
                                     kGL_ALPHA16,
                                     kGL_LUMINANCE4,
                                     kGL_LUMINANCE8,
                                     kGL_LUMINANCE16,
                                     kGL_LUMINANCE8_ALPHA8,
                                     kGL_LUMINANCE16_ALPHA16,
                                     kGL_INTENSITY8,
                                     kGL_INTENSITY16,
                                     kGL_R3_G3_B2,
                                     kGL_RGB4,
                                     kGL_RGB5,
                                     kGL_RGB8,
                                     kGL_RGB16,
                                     kGL_RGBA2,
                                     kGL_RGBA4,
                                     kGL_RGB5_A1,
                                     kGL_RGBA8,
                                     kGL_RGB10_A2,
                                     kGL_RGBA16};
constexpr Enum kFormats[] = {kGL_RED,       kGL_GREEN,           kGL_BLUE, kGL_ALPHA, kGL_RGB, kGL_BGR,
                             kGL_LUMINANCE, kGL_LUMINANCE_ALPHA, kGL_RGBA, kGL_BGRA};
constexpr Enum kTypes[] = {kGL_UNSIGNED_BYTE,
                           kGL_BYTE,
                           kGL_UNSIGNED_SHORT,
                           kGL_SHORT,
                           kGL_UNSIGNED_INT,
                           kGL_INT,
                           kGL_FLOAT,
                           kGL_UNSIGNED_BYTE_3_3_2,
                           kGL_UNSIGNED_SHORT_5_6_5,
                           kGL_UNSIGNED_SHORT_4_4_4_4_REV,
                           kGL_UNSIGNED_SHORT_5_5_5_1,
                           kGL_UNSIGNED_INT_8_8_8_8,
                           kGL_UNSIGNED_INT_8_8_8_8_REV,
                           kGL_UNSIGNED_INT_2_10_10_10_REV};

template <std::size_t n>
double one_of(fuzz::Random& random, const Enum (&choices)[n]) {
    return choices[random.below(static_cast<int>(n))];
}

std::shared_ptr<const Memory> random_memory(fuzz::Random& random, std::size_t size, Enum type) {
    auto memory = std::make_shared<Memory>();
    memory->bytes.resize(size);
    for (std::size_t i = 0; i < size; ++i) memory->bytes[i] = static_cast<std::byte>(random.below(256));
    if (type != kGL_FLOAT) return memory;
    for (std::size_t i = 0; i + 4 <= size; i += 4) {  // numbers around [0,1], not any bits
        const auto value = static_cast<float>(random.uniform(-0.2, 1.2));
        std::memcpy(&memory->bytes[i], &value, 4);
    }
    return memory;
}

struct Difference {
    double largest = 0;
    double mean = 0;
};

// The difference between the texels and those that the driver returns.
//
// libglu 9.0.2's scaling to a power of two stops reading before the last row or column that it needs (scale_internal_*,
// "Clamp here to be sure we don't read beyond input buffer"), and makes the last row black where only the width is
// scaled: State does not copy that, so with `scaled` the last rows and columns, and the levels made of them, are left
// out.
Difference difference(const Texture& texture, bool scaled) {
    Difference result;
    int compared = 0;
    for (std::size_t level = 0; level < (scaled ? 1 : texture.levels.size()); ++level) {
        const TextureImage& image = texture.levels[level];
        std::vector<glm::vec4> driver(image.texels.size());
        glGetTexImage(texture.target, static_cast<GLint>(level), GL_RGBA, GL_FLOAT, driver.data());
        for (std::size_t i = 0; i < driver.size(); ++i) {
            const int x = static_cast<int>(i) % image.width, y = static_cast<int>(i) / image.width % image.height;
            if (scaled && (x + 1 == image.width || y + 1 == image.height)) continue;
            // 6.1.4: glGetTexImage gives luminance and intensity as red; green and blue are 0 then.
            const Enum base = image.base_format;
            const bool gray = base == kGL_LUMINANCE || base == kGL_LUMINANCE_ALPHA || base == kGL_INTENSITY;
            const glm::dvec4 d = glm::abs(glm::dvec4(driver[i]) - glm::dvec4(image.texels[i]));
            const double colors = gray ? d.r : std::max({d.r, d.g, d.b});
            const double here = std::max(colors, base == kGL_INTENSITY ? 0.0 : d.a);
            result.largest = std::max(result.largest, here);
            result.mean += here;
            ++compared;
        }
    }
    result.mean /= std::max(compared, 1);
    return result;
}

// Returns the mean difference in steps.
double expect_same(State& state, fixed::Driver& driver, const std::vector<Command>& commands, double step,
                   bool scaled) {
    for (const Command& command : commands) {
        state.apply(command);
        driver.execute(command);
    }
    EXPECT_TRUE(state.errors().empty()) << state.errors().front().message;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    const Texture* texture = state.textures().named.contains(1) ? state.textures().named.at(1).get() : nullptr;
    if (!texture) {
        ADD_FAILURE() << "no texture";
        return 0;
    }
    std::string numbers;
    for (double v : commands.back().arguments) numbers += fmt::format("{:#x} ", static_cast<int>(v));
    // Right roundings of one number may differ by a step where it lies between two, which is rare.
    const Difference found = difference(*texture, scaled);
    EXPECT_LE(found.largest, 1.001 * step) << commands.back().name() << " " << numbers;
    return found.mean / step;
}

constexpr double kByteStep = 1.0 / 255;
// Signed types: the driver has the rule of GL 4.2 (table 2.9 was changed there), State that of 2.1: 1/255 apart at
// most.
double step_of(double internal) {
    const InternalFormat format = *internal_format(internal);
    return 1 / (std::exp2(std::min({8, format.red, format.green, format.blue, format.alpha})) - 1);
}

TEST(TexturesMatchDriver, ImagesOfEveryFormatAndType) {
    const auto context = make_offscreen_context(16, 16);
    fuzz::Random random(31);
    double total = 0;
    int images = 0;
    for (int i = 0; i < 1500 && !testing::Test::HasFailure(); ++i) {
        fixed::Driver driver(16, 16);
        State state({.width = 16, .height = 16});
        const double format = one_of(random, kFormats), type = one_of(random, kTypes);
        const PixelSource source{.width = 1 + random.below(9),
                                 .height = 1 + random.below(6),
                                 .format = static_cast<Enum>(format),
                                 .type = static_cast<Enum>(type)};
        if (!pixel_bytes(source.format, source.type)) continue;
        const double alignment = 1 << random.below(4), swap = random.below(2);
        PixelStore store;
        store.unpack_alignment = static_cast<int>(alignment);
        store.unpack_swap_bytes = swap != 0;
        const bool is_float = source.type == kGL_FLOAT;
        const auto memory = random_memory(random, bytes_read(source, store), source.type);
        const double internal = one_of(random, kInternalFormats);
        total += expect_same(state, driver,
                             {{CommandId::glPixelStorei, {kGL_UNPACK_ALIGNMENT, alignment}, {}},
                              {CommandId::glPixelStorei, {kGL_UNPACK_SWAP_BYTES, is_float ? 0 : swap}, {}},
                              {CommandId::glBindTexture, {kGL_TEXTURE_2D, 1}, {}},
                              {CommandId::glTexImage2D,
                               {kGL_TEXTURE_2D, 0, internal, static_cast<double>(source.width),
                                static_cast<double>(source.height), 0, format, type, 0},
                               {},
                               memory}},
                             step_of(internal), false);
        ++images;
        glBindTexture(GL_TEXTURE_2D, 0);
        const GLuint name = 1;
        glDeleteTextures(1, &name);
    }
    EXPECT_LE(total / images, 0.1);
}

// With the parameters of glPixelStore that only these have.
TEST(TexturesMatchDriver, ImagesOfThreeDimensions) {
    const auto context = make_offscreen_context(16, 16);
    fuzz::Random random(33);
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        fixed::Driver driver(16, 16);
        State state({.width = 16, .height = 16});
        const double format = one_of(random, kFormats), type = one_of(random, kTypes);
        PixelSource source{.width = 1 + random.below(5),
                           .height = 1 + random.below(5),
                           .depth = 1 + random.below(5),
                           .format = static_cast<Enum>(format),
                           .type = static_cast<Enum>(type),
                           .is_volume = true};
        if (!pixel_bytes(source.format, source.type)) continue;
        // By GLU, whose images have sides that are powers of 2. Its halveImageSlice() (libglu 9.0.2) takes wrong pixels where
        // only one of width and height is 1; State takes the right ones.
        const bool builds = random.chance(0.2);
        if (builds) {
            const int side = 1 << random.below(4);
            source = {side, side, 1 << random.below(4), kGL_RGB, kGL_UNSIGNED_BYTE, true};
        }
        PixelStore store;
        store.unpack_alignment = builds ? 1 : 1 << random.below(4);
        store.unpack_row_length = builds || random.chance(0.5) ? 0 : source.width + random.below(3);
        store.unpack_image_height = builds || random.chance(0.5) ? 0 : source.height + random.below(3);
        store.unpack_skip_images = builds ? 0 : random.below(3);
        store.unpack_skip_rows = builds ? 0 : random.below(2);
        const auto memory = random_memory(random, bytes_read(source, store), source.type);
        std::vector<Command> commands;
        for (const ParameterRow<PixelStore>& row : kPixelStoreParameters)
            commands.push_back(
                {CommandId::glPixelStorei, {static_cast<double>(row.pname), values_of(store, row).front()}, {}});
        commands.push_back({CommandId::glBindTexture, {kGL_TEXTURE_3D, 1}, {}});
        const double internal = builds ? kGL_RGB : one_of(random, kInternalFormats), width = source.width,
                     height = source.height, depth = source.depth;
        if (builds)
            commands.push_back({CommandId::gluBuild3DMipmaps,
                                {kGL_TEXTURE_3D, internal, width, height, depth, kGL_RGB, kGL_UNSIGNED_BYTE, 0},
                                {},
                                memory});
        else
            commands.push_back({CommandId::glTexImage3D,
                                {kGL_TEXTURE_3D, 0, internal, width, height, depth, 0, format, type, 0},
                                {},
                                memory});
        expect_same(state, driver, commands, step_of(internal), false);
        for (const Enum pname : {kGL_TEXTURE_WIDTH, kGL_TEXTURE_HEIGHT, kGL_TEXTURE_DEPTH}) {
            GLint size = 0;
            glGetTexLevelParameteriv(kGL_TEXTURE_3D, 0, pname, &size);
            EXPECT_EQ(size, tex_level_answer(state, kGL_TEXTURE_3D, 0, pname)[0]);
        }
    }
}

// GLU's arithmetic, byte for byte. Its scaled images are in rows without padding, which it reads with padding: alignment 1 here.
TEST(TexturesMatchDriver, GluMipmapsOfVolumesOfEverySize) {
    const auto context = make_offscreen_context(16, 16);
    fuzz::Random random(34);
    for (int i = 0; i < 100 && !testing::Test::HasFailure(); ++i) {
        fixed::Driver driver(16, 16);
        State state({.width = 16, .height = 16});
        // Width and height become 4, or 8: GLU's halves of others are wrong (see ImagesOfThreeDimensions).
        const bool is_small = random.chance(0.3);
        const auto side = [&] { return is_small ? 3 + random.below(3) : 6 + random.below(6); };
        const Enum type = random.chance(0.7) ? kGL_UNSIGNED_BYTE : kGL_UNSIGNED_SHORT,
                   format = random.chance(0.5) ? kGL_RGB : kGL_LUMINANCE_ALPHA;
        const PixelSource source{side(), side(), 1 + random.below(9), format, type, true};
        PixelStore store;
        store.unpack_alignment = 1;
        const auto memory = random_memory(random, bytes_read(source, store), source.type);
        const double internal = format == kGL_RGB           ? (type == kGL_UNSIGNED_BYTE ? kGL_RGB8 : kGL_RGB16)
                                : type == kGL_UNSIGNED_BYTE ? kGL_LUMINANCE8_ALPHA8
                                                            : kGL_LUMINANCE16_ALPHA16;
        expect_same(state, driver,
                    {{CommandId::glPixelStorei, {kGL_UNPACK_ALIGNMENT, 1}, {}},
                     {CommandId::glBindTexture, {kGL_TEXTURE_3D, 1}, {}},
                     {CommandId::gluBuild3DMipmaps,
                      {kGL_TEXTURE_3D, internal, static_cast<double>(source.width), static_cast<double>(source.height),
                       static_cast<double>(source.depth), static_cast<double>(format), static_cast<double>(type), 0},
                      {},
                      memory}},
                    1e-6, false);
        glBindTexture(GL_TEXTURE_3D, 0);
        const GLuint name = 1;
        glDeleteTextures(1, &name);
    }
}

TEST(TexturesMatchDriver, GluMipmapsOfEverySize) {
    const auto context = make_offscreen_context(16, 16);
    fuzz::Random random(32);
    double total = 0;
    int images = 0;
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        fixed::Driver driver(16, 16);
        State state({.width = 16, .height = 16});
        const double type = random.chance(0.7) ? kGL_UNSIGNED_BYTE : kGL_FLOAT;
        const double format = random.chance(0.5) ? kGL_RGB : kGL_LUMINANCE_ALPHA;
        const PixelSource source{.width = 1 + random.below(17),
                                 .height = 1 + random.below(17),
                                 .format = static_cast<Enum>(format),
                                 .type = static_cast<Enum>(type)};
        // With rows that need padding GLU gives its first halved level in the wrong layout: alignment 1 here.
        PixelStore store;
        store.unpack_alignment = 1;
        const auto memory = random_memory(random, bytes_read(source, store), source.type);
        total += expect_same(state, driver,
                             {{CommandId::glPixelStorei, {kGL_UNPACK_ALIGNMENT, 1}, {}},
                              {CommandId::glBindTexture, {kGL_TEXTURE_2D, 1}, {}},
                              {CommandId::gluBuild2DMipmaps,
                               {kGL_TEXTURE_2D, format == kGL_RGB ? 3.0 : 2.0, static_cast<double>(source.width),
                                static_cast<double>(source.height), format, type, 0},
                               {},
                               memory}},
                             kByteStep,
                             !std::has_single_bit(static_cast<unsigned>(source.width)) ||
                                 !std::has_single_bit(static_cast<unsigned>(source.height)));
        ++images;
        glBindTexture(GL_TEXTURE_2D, 0);
        const GLuint name = 1;
        glDeleteTextures(1, &name);
    }
    EXPECT_LE(total / images, 0.1);
}

// Mesa reads beyond its images if GL_TEXTURE_BASE_LEVEL is large, and may crash: such a level does not reach it.
TEST(TexturesMatchDriver, ABaseLevelBeyondAllImagesDrawsWithoutTexture) {
    const auto context = make_offscreen_context(16, 16);
    const auto red_at_center = [](double level) {
        const std::string text = fmt::format(
            "GLubyte t[64] = {{0}}; glEnable(GL_TEXTURE_2D); glColor3f(1, 0, 0);\n"
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
            "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, t);\n"
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, {:.0f});\n"
            "glRectf(-1, -1, 1, 1);\n",
            level);
        const auto list = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
        const float red = fixed::render(make_scene(list, {.width = 16, .height = 16})).at(8, 8)[0];
        GLint given = 0;
        glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, &given);
        EXPECT_LT(given, kMaxTextureLevels) << level;
        return red;
    };
    EXPECT_EQ(red_at_center(0), 0);
    for (const double level : {1, 14, 15, 115, 1000, 2147483647}) EXPECT_EQ(red_at_center(level), 1) << level;
}

}  // namespace

}  // namespace twinlight::textures_match_driver_test
