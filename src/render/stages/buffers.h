// Static buffers of vertices, flags and indices.
#pragma once

#include <cstddef>
#include <vector>

#include "render/context/gl.h"

namespace twinlight {

inline const void* buffer_offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}  // NOLINT: GL's way

// Creates a buffer with the values and binds it to the target, GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER. The caller
// deletes it.
template <class Values>
GLuint filled_buffer(GLenum target, const Values& values) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(values[0])), values.data(), GL_STATIC_DRAW);
    return name;
}

}  // namespace twinlight
