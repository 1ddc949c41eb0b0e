#include "scene/trace/framebuffers.h"

#include <utility>

namespace twinlight::trace {

namespace {

constexpr std::size_t kMostTextures = 1 << 16;  // a hostile dump may name any number

}  // namespace

bool Framebuffers::follow(Command& c) {
    const auto draws = [&c] { return c.enumerant(0) != kGL_READ_FRAMEBUFFER; };
    switch (c.id) {
        case CommandId::glBindFramebuffer:
            if (draws()) draw_ = c.number(1);
            if (c.enumerant(0) != kGL_DRAW_FRAMEBUFFER) read_ = c.number(1);
            c.arguments[1] = name_of(c.number(1));
            return true;
        case CommandId::glFramebufferTexture2D: {
            const double object = draws() ? draw_ : read_;
            const bool is_whole = c.enumerant(2) == kGL_TEXTURE_2D && c.number(4) == 0;
            if (c.enumerant(1) == kGL_COLOR_ATTACHMENT0 &&
                (textures_.size() < kMostTextures || textures_.contains(object)))
                textures_[object] = is_whole ? c.number(3) : 0;
            return name_of(object) != 0 || object == 0;
        }
        case CommandId::glFramebufferRenderbuffer: {
            const double object = draws() ? draw_ : read_;
            if (c.enumerant(1) == kGL_COLOR_ATTACHMENT0) textures_.erase(object);
            return name_of(object) != 0 || object == 0;
        }
        case CommandId::glDrawBuffer: return draw_ == 0 || name_of(draw_) != 0;
        case CommandId::glReadBuffer: return read_ == 0 || name_of(read_) != 0;
        default: return true;
    }
}

std::optional<std::vector<Command>> Framebuffers::blit(std::span<const double> numbers, const Place& place) const {
    const bool reads_window = name_of(read_) == 0, draws_window = name_of(draw_) == 0;
    if (any_shown() && reads_window && draws_window) return std::vector<Command>{};
    if (numbers.size() != 10) return std::nullopt;
    const double x = numbers[0], y = numbers[1], width = numbers[2] - x, height = numbers[3] - y;
    const double to_x = numbers[4], to_y = numbers[5];
    const bool keeps_size = numbers[6] - to_x == width && numbers[7] - to_y == height && width > 0 && height > 0;
    const auto texture = textures_.find(draw_);
    if (!keeps_size || draws_window || texture == textures_.end() || texture->second == 0 ||
        numbers[8] != kGL_COLOR_BUFFER_BIT)
        return std::nullopt;
    return std::vector{
        Command{CommandId::glPushAttrib, {kGL_TEXTURE_BIT}, place},
        Command{CommandId::glBindTexture, {kGL_TEXTURE_2D, texture->second}, place},
        Command{CommandId::glCopyTexSubImage2D, {kGL_TEXTURE_2D, 0, to_x, to_y, x, y, width, height}, place},
        Command{CommandId::glPopAttrib, {}, place},
    };
}

}  // namespace twinlight::trace
