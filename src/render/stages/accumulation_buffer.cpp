#include "render/stages/accumulation_buffer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "render/context/gl.h"
#include "render/stages/textures.h"

namespace twinlight {

namespace {

// Pixels are copied as they are: no fragment operation but the scissor test and the colour mask, no change of pixels on
// their way (3.6.4).
class CopiesPixels {
  public:
    CopiesPixels() {
        glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
        glGetIntegerv(GL_MATRIX_MODE, &matrix_mode_);
        color_sum_ = glIsEnabled(GL_COLOR_SUM);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
        glUseProgram(0);
        for (GLenum capability : {GL_ALPHA_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_FOG,
                                  GL_COLOR_SUM, GL_DITHER})
            glDisable(capability);
        disable_textures();
        for (GLenum buffer : {GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER}) glBindBuffer(buffer, 0);
        for (GLenum name : {GL_PACK_SWAP_BYTES, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
                            GL_UNPACK_SWAP_BYTES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS})
            glPixelStorei(name, 0);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        for (GLenum name : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE}) glPixelTransferf(name, 1);
        for (GLenum name : {GL_MAP_COLOR, GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS})
            glPixelTransferi(name, 0);
        glPixelZoom(1, 1);
    }
    ~CopiesPixels() {
        glPopClientAttrib();
        glPopAttrib();
        if (color_sum_ == GL_TRUE) glEnable(GL_COLOR_SUM);  // Mesa (22.3 to 26.1) does not pop it
        glUseProgram(static_cast<GLuint>(program_));
        glMatrixMode(static_cast<GLenum>(matrix_mode_));
    }
    CopiesPixels(const CopiesPixels&) = delete;
    CopiesPixels& operator=(const CopiesPixels&) = delete;

  private:
    GLint program_ = 0, matrix_mode_ = GL_MODELVIEW;
    GLboolean color_sum_ = GL_FALSE;
};

constexpr std::size_t kChannels = 4;

}  // namespace

Rectangle AccumulationBuffer::scissored(const Scissor& scissor) const {
    if (!scissor.enabled) return {0, 0, width_, height_};
    const auto cut = [](int start, int size, int all) {
        const std::int64_t first = std::clamp(start, 0, all);
        const std::int64_t end = std::clamp<std::int64_t>(std::int64_t{start} + size, first, all);
        return std::pair(static_cast<int>(first), static_cast<int>(end - first));
    };
    const auto [x, width] = cut(scissor.box.x, scissor.box.width, width_);
    const auto [y, height] = cut(scissor.box.y, scissor.box.height, height_);
    return {x, y, width, height};
}

template <class Visit>
void AccumulationBuffer::for_each(const Rectangle& box, const Visit& visit) {
    for (int y = box.y; y < box.y + box.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
        for (int x = box.x; x < box.x + box.width; ++x)
            visit(&channels_[kChannels * (first + static_cast<std::size_t>(x))]);
    }
}

void AccumulationBuffer::need_memory() {
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    if (channels_.empty()) channels_.resize(kChannels * pixels);
}

void AccumulationBuffer::clear(const Clear& clear) {
    if (!clear.accumulation) return;
    need_memory();
    const glm::vec4 color(clear.clear_accumulation);
    for_each(scissored(clear.scissor), [&](float* pixel) {
        for (std::size_t i = 0; i < kChannels; ++i) pixel[i] = color[static_cast<int>(i)];
    });
}

void AccumulationBuffer::apply(const Accumulate& accumulate) {
    const Rectangle box = scissored(accumulate.scissor);
    if (box.width == 0 || box.height == 0) return;
    need_memory();
    const auto value = static_cast<float>(accumulate.value);
    std::vector<float> colors;
    const auto resize = [&] {
        colors.resize(kChannels * static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height));
    };
    std::size_t next = 0;
    if (accumulate.op == kGL_RETURN) {
        resize();
        for_each(box, [&](const float* pixel) {
            for (std::size_t i = 0; i < kChannels; ++i) colors[next++] = std::clamp(pixel[i] * value, 0.0F, 1.0F);
        });
        const CopiesPixels copies;
        const auto mask = accumulate.color_mask;
        glColorMask(mask[0], mask[1], mask[2], mask[3]);
        glDisable(GL_SCISSOR_TEST);
        glWindowPos2i(box.x, box.y);
        glDrawPixels(box.width, box.height, GL_RGBA, GL_FLOAT, colors.data());
        return;
    }
    const bool reads = accumulate.op == kGL_ACCUM || accumulate.op == kGL_LOAD;
    if (reads) {
        resize();
        const CopiesPixels copies;
        glReadPixels(box.x, box.y, box.width, box.height, GL_RGBA, GL_FLOAT, colors.data());
    }
    // A result outside [-1, 1] is undefined.
    const auto set = [](float& channel, float result) { channel = std::clamp(result, -1.0F, 1.0F); };
    for_each(box, [&](float* pixel) {
        for (std::size_t i = 0; i < kChannels; ++i) {
            const float color = reads ? colors[next++] : 0;
            switch (accumulate.op) {
                case kGL_ACCUM: set(pixel[i], pixel[i] + color * value); break;
                case kGL_LOAD: set(pixel[i], color * value); break;
                case kGL_ADD: set(pixel[i], pixel[i] + value); break;
                default: set(pixel[i], pixel[i] * value); break;  // GL_MULT
            }
        }
    });
}

}  // namespace twinlight
