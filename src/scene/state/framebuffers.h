// Framebuffer objects and renderbuffers (EXT_framebuffer_object; OpenGL 3.0, section 4.4).
//
// What a program draws into an object is a picture of its own (ObjectPicture). When the object is unbound, the picture becomes the
// content of its images: a texture has it as copied pixels.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "scene/frame/frame.h"

namespace twinlight {

inline constexpr std::size_t kMaxColorAttachments = 8;  // GL_MAX_COLOR_ATTACHMENTS: at least 1; 8 in Mesa
inline constexpr int kMaxRenderbufferSize = 16384;      // GL_MAX_RENDERBUFFER_SIZE: at least 1; llvmpipe's

struct Attachment {
    Enum type = kGL_NONE;  // or GL_TEXTURE, GL_RENDERBUFFER
    std::uint32_t name = 0;
    std::size_t face = 0, level = 0;  // of a texture
    bool is_deleted = false;          // the texture has no name any more; the object keeps it

    bool is_whole_texture() const { return type == kGL_TEXTURE && face == 0 && level == 0 && !is_deleted; }
    friend bool operator==(const Attachment&, const Attachment&) = default;
};

struct FramebufferObject {
    std::array<Attachment, kMaxColorAttachments> colors{};
    Attachment depth{}, stencil{};
    Enum draw_buffer = kGL_COLOR_ATTACHMENT0, read_buffer = kGL_COLOR_ATTACHMENT0;  // or GL_NONE, another attachment

    // Returns the attachment that glDrawBuffer or glReadBuffer chose, or null if nothing is attached there.
    const Attachment* color(Enum buffer) const {
        if (buffer == kGL_NONE) return nullptr;
        const Attachment& attachment = colors.at(buffer - kGL_COLOR_ATTACHMENT0);
        return attachment.type == kGL_NONE ? nullptr : &attachment;
    }
    // Calls visit(Attachment&) for all.
    template <class Visit>
    void for_each(const Visit& visit) {
        for (Attachment& color : colors) visit(color);
        visit(depth);
        visit(stencil);
    }
};

struct Renderbuffer {
    Enum internal_format = kGL_RGBA;
    int width = 0, height = 0;
    std::shared_ptr<const ObjectPicture> drawn{};  // its content; null: undefined
};

struct Framebuffers {
    // nullopt: the name was generated but not yet bound.
    std::map<std::uint32_t, std::optional<FramebufferObject>> named;
    std::map<std::uint32_t, std::optional<Renderbuffer>> renderbuffers;
    std::uint32_t draw = 0, read = 0, renderbuffer = 0;  // the bound ones; 0: the window's

    FramebufferObject& drawn() { return *named.at(draw); }
    const FramebufferObject& drawn() const { return *named.at(draw); }
};

}  // namespace twinlight
