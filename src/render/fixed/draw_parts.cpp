#include "render/fixed/draw_parts.h"

#include <array>

#include "render/context/gl.h"
#include "scene/frame/frame.h"

namespace twinlight::fixed {

namespace {

template <std::size_t n>
using Floats = std::array<GLfloat, n>;

Floats<3> floats(const glm::dvec3& v) {
    return {static_cast<GLfloat>(v.x), static_cast<GLfloat>(v.y), static_cast<GLfloat>(v.z)};
}
Floats<2> floats(const glm::dvec2& v) { return {static_cast<GLfloat>(v.x), static_cast<GLfloat>(v.y)}; }

void draw_by_arrays(const ShapePart& part) {
    std::vector<Floats<3>> positions, normals;
    std::vector<Floats<2>> tex_coords;
    for (const ShapeVertex& v : part.vertices) {
        positions.push_back(floats(v.position_object));
        normals.push_back(floats(v.normal_object));
        if (part.sends_tex_coords) tex_coords.push_back(floats(v.tex_coord));
    }
    glVertexPointer(3, GL_FLOAT, 0, positions.data());
    glNormalPointer(GL_FLOAT, 0, normals.data());
    if (part.sends_tex_coords) {
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(2, GL_FLOAT, 0, tex_coords.data());
    }
    if (part.indices.empty()) {
        glDrawArrays(part.mode, 0, static_cast<GLsizei>(positions.size()));
    } else {
        glDrawElements(part.mode, static_cast<GLsizei>(part.indices.size()), GL_UNSIGNED_INT, part.indices.data());
    }
}

}  // namespace

void draw_by_arrays(const Command& command) {
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    for (const GLenum array :
         {GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY, GL_EDGE_FLAG_ARRAY, GL_INDEX_ARRAY}) {
        glDisableClientState(array);
    }
    for (std::size_t unit = kMaxTextureUnits; unit-- > 0;) {  // leaves unit 0 active
        glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    for_each_part(command, [](ShapePart&& part) {
        draw_by_arrays(part);
        return true;
    });
    glPopClientAttrib();
}

void draw_immediately(const std::vector<ShapePart>& parts) {
    for (const ShapePart& part : parts) {
        glBegin(part.mode);
        for (std::size_t i = 0; i < part.vertices.size(); ++i) {
            const ShapeVertex& v = part.vertices[i];
            if (i >= part.first_normal) glNormal3fv(floats(v.normal_object).data());
            if (part.sends_tex_coords) glTexCoord2fv(floats(v.tex_coord).data());
            glVertex3fv(floats(v.position_object).data());
        }
        glEnd();
    }
}

}  // namespace twinlight::fixed
