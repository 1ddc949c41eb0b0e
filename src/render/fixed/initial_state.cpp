// GL's initial state (6.2), in which a scene starts and ends. An attribute stack would be shorter, but its levels
// belong to the scene. State's initial values are used for everything that State has; the rest is here.
#include <array>

#include "render/context/gl.h"
#include "render/fixed/draw_state.h"
#include "render/fixed/fixed.h"
#include "render/stages/fixed_stages.h"
#include "scene/frame/parameter_rows.h"
#include "scene/state/capabilities.h"
#include "scene/state/state.h"

namespace twinlight::fixed {

namespace {

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

// A display list may call glBegin between glBegin and glEnd, which leaves some drivers there.
void end_primitives() {
    constexpr GLint kMostTries = 4;
    for (GLint i = 0; i < kMostTries; ++i) {
        GLint depth = -1;
        glGetIntegerv(GL_CLIENT_ATTRIB_STACK_DEPTH, &depth);  // unanswered between glBegin and glEnd (2.6.3)
        if (depth >= 0) return;
        glEnd();
    }
}

void close_and_empty_stacks() {
    end_primitives();
    if (integer(GL_LIST_INDEX) != 0) glEndList();
    for (GLint depth = integer(GL_ATTRIB_STACK_DEPTH); depth > 0; --depth) glPopAttrib();
    for (GLint depth = integer(GL_CLIENT_ATTRIB_STACK_DEPTH); depth > 0; --depth) glPopClientAttrib();
}

void reset_stack(GLenum mode, GLenum depth_name) {
    glMatrixMode(mode);
    for (GLint depth = integer(depth_name); depth > 1; --depth) glPopMatrix();
    glLoadIdentity();
}

void reset_pixels(const PixelStore& store) {
    for (const ParameterRow<PixelStore>& row : kPixelStoreParameters)
        glPixelStoref(row.pname, floats_of(store, row).front());
    glPixelZoom(1, 1);
    for (GLenum name : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE})
        glPixelTransferf(name, 1);
    for (GLenum name : {GL_MAP_COLOR, GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET, GL_RED_BIAS, GL_GREEN_BIAS,
                        GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS})
        glPixelTransferi(name, 0);
    const GLfloat zero = 0;
    for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_A_TO_A; ++map) glPixelMapfv(map, 1, &zero);
}

void reset_current_values(const VertexValues& current) {
    glColor4dv(&current.color[0]);
    glNormal3dv(&current.normal_object[0]);
    glEdgeFlag(current.edge_flag);
    glSecondaryColor3dv(&current.further(VertexAttribute::kSecondaryColor)[0]);
    glFogCoordd(current.further(VertexAttribute::kFogCoord).x);
}

void reset_stipples() {
    glLineStipple(1, 0xFFFF);
    std::array<GLubyte, 128> full{};
    full.fill(0xFF);
    glPolygonStipple(full.data());
}

void reset_fragments(const Attributes& start) {
    set_enabled(GL_FOG, start.fog.enabled);
    set_fog(start.fog);
    glFogf(GL_FOG_INDEX, 0);
    set_enabled(GL_COLOR_SUM, start.fragment.color_sum);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glStencilMask(~0U);
    glLogicOp(GL_COPY);
    const glm::vec4 color(start.clear.clear_color);
    glClearColor(color.r, color.g, color.b, color.a);
    glClearDepth(start.clear.clear_depth);
    glClearStencil(0);
    glClearAccum(0, 0, 0, 0);
}

// Resets the parameters of texture 0, and deletes its images by giving it empty ones.
void reset_texture(GLenum target) {
    const Texture start;
    glBindTexture(target, 0);
    for (const ParameterRow<Texture>& row : kTextureParameters)
        glTexParameterfv(target, row.pname, floats_of(start, row).data());
    const bool is_cube = target == GL_TEXTURE_CUBE_MAP;
    const GLint largest = integer(is_cube                   ? GL_MAX_CUBE_MAP_TEXTURE_SIZE
                                  : target == GL_TEXTURE_3D ? GL_MAX_3D_TEXTURE_SIZE
                                                            : GL_MAX_TEXTURE_SIZE);
    const auto empty_images = [&](GLenum image) {
        for (GLint level = 0; largest >> level > 0; ++level) {
            GLint width = 0;
            glGetTexLevelParameteriv(image, level, GL_TEXTURE_WIDTH, &width);
            if (width == 0) continue;
            if (image == GL_TEXTURE_1D) {
                glTexImage1D(image, level, GL_RGBA, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            } else if (image == GL_TEXTURE_3D) {
                glTexImage3D(image, level, GL_RGBA, 0, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            } else {
                glTexImage2D(image, level, GL_RGBA, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            }
        }
    };
    if (!is_cube) return empty_images(target);
    for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z; ++face) {
        empty_images(face);
    }
}

void reset_texture_units(const Vertex& current) {
    const TextureBindings start;
    for (GLint i = integer(GL_MAX_TEXTURE_UNITS) - 1; i >= 0; --i) {  // leaves unit 0 active
        const GLenum unit = GL_TEXTURE0 + static_cast<GLenum>(i);
        glActiveTexture(unit);
        set_enabled(GL_TEXTURE_1D, start.enabled_1d);
        set_enabled(GL_TEXTURE_2D, start.enabled_2d);
        set_enabled(GL_TEXTURE_3D, start.enabled_3d);
        set_enabled(GL_TEXTURE_CUBE_MAP, start.enabled_cube);
        for (const DriverOnlyCapability& row : driver_only_capabilities())
            if (row.is_per_unit()) glDisable(row.cap);
        reset_texture(GL_TEXTURE_1D);
        reset_texture(GL_TEXTURE_2D);
        reset_texture(GL_TEXTURE_3D);
        reset_texture(GL_TEXTURE_CUBE_MAP);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(start.env_mode));
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &glm::vec4(start.env_color)[0]);
        set_combine(start.combine);
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, static_cast<float>(start.lod_bias));
        glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, start.coord_replace);
        for (GLenum n = 0; n < start.tex_gen.size(); ++n) {
            const TexGen& gen = start.tex_gen[n];
            set_enabled(GL_TEXTURE_GEN_S + n, gen.enabled);
            glTexGeni(GL_S + n, GL_TEXTURE_GEN_MODE, static_cast<GLint>(gen.mode));
            glTexGendv(GL_S + n, GL_OBJECT_PLANE, &gen.object_plane[0]);
            glTexGendv(GL_S + n, GL_EYE_PLANE, &gen.plane_eye[0]);  // the modelview matrix is the identity
        }
        glMultiTexCoord4dv(unit, &current.tex_coord[0]);
        reset_stack(GL_TEXTURE, GL_TEXTURE_STACK_DEPTH);
    }
}

void reset_arrays() {
    const ClientArrays start;
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_INDEX_ARRAY, GL_EDGE_FLAG_ARRAY,
                         GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY})
        glDisableClientState(array);
    glVertexPointer(start.vertex.size, start.vertex.type, 0, nullptr);
    glNormalPointer(start.normal.type, 0, nullptr);
    glColorPointer(start.color.size, start.color.type, 0, nullptr);
    glEdgeFlagPointer(0, nullptr);
    for (GLint i = integer(GL_MAX_TEXTURE_UNITS) - 1; i >= 0; --i) {
        glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(start.tex_coord[0].size, start.tex_coord[0].type, 0, nullptr);
    }
}

// 5.1, table 6.24: maps of order 1, with (0, 0, 0, 1), (1, 1, 1, 1) for colours, (0, 0, 1) for normals, 1 for indices.
void reset_evaluators() {
    glMapGrid1f(1, 0, 1);
    glMapGrid2f(1, 0, 1, 1, 0, 1);
    const std::array<GLfloat, 4> origin{0, 0, 0, 1}, white{1, 1, 1, 1}, forward{0, 0, 1, 0};
    for (GLenum i = 0; i <= GL_MAP1_VERTEX_4 - GL_MAP1_COLOR_4; ++i) {
        const GLenum one = GL_MAP1_COLOR_4 + i, two = GL_MAP2_COLOR_4 + i;
        const bool is_white = one == GL_MAP1_COLOR_4 || one == GL_MAP1_INDEX;
        const GLfloat* point = is_white ? white.data() : one == GL_MAP1_NORMAL ? forward.data() : origin.data();
        glMap1f(one, 0, 1, 4, 1, point);
        glMap2f(two, 0, 1, 4, 1, 0, 1, 4, 1, point);
    }
}

void reset(int width, int height, std::uint32_t framebuffer) {
    const State initial({.width = width, .height = height});
    const Attributes& start = initial.attributes();
    close_and_empty_stacks();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    reset_stack(GL_PROJECTION, GL_PROJECTION_STACK_DEPTH);
    reset_stack(GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH);  // before lights and clip planes, which it transforms
    reset_pixels(initial.pixel_store());                  // before the stipple patterns, which it unpacks
    for (const DriverOnlyCapability& row : driver_only_capabilities())
        if (!row.is_per_unit()) set_enabled(row.cap, *initial.capability(row.cap));
    for (const auto& [target, mode] : start.hints) glHint(target, mode);
    glListBase(start.list_base);
    reset_current_values(start.current);
    set_lighting(start.lighting, true);
    glMaterialfv(GL_FRONT_AND_BACK, GL_COLOR_INDEXES, &glm::vec3(start.lighting.front.color_indexes)[0]);
    glShadeModel(start.lighting.shade_model);
    FixedStages::set(start.raster, start.fragment);
    for (GLint i = 0; i < integer(GL_MAX_CLIP_PLANES); ++i) {
        glDisable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
        glClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), &ClipPlane{}.equation_eye[0]);
    }
    reset_stipples();
    reset_fragments(start);
    reset_texture_units(start.current);
    // With the current values. They are set again, because Mesa (22.3) forgets here that they are new, and then a
    // glPopAttrib(GL_CURRENT_BIT) of the scene does not restore them.
    glWindowPos3f(0, 0, 0);
    reset_current_values(start.current);
    reset_texture_units(start.current);
    reset_evaluators();  // needs unit 0 active
    reset_arrays();
    glMatrixMode(start.matrix_mode);
}

}  // namespace

Enum draw_buffer() { return static_cast<Enum>(integer(GL_DRAW_BUFFER)); }
std::uint32_t draw_framebuffer() { return static_cast<std::uint32_t>(integer(GL_DRAW_FRAMEBUFFER_BINDING)); }
std::uint32_t read_framebuffer() { return static_cast<std::uint32_t>(integer(GL_READ_FRAMEBUFFER_BINDING)); }

InitialState::InitialState(int width, int height)
    : width_(width), height_(height), framebuffer_(draw_framebuffer()), draw_buffer_(draw_buffer()) {
    reset(width_, height_, framebuffer_);
}

InitialState::~InitialState() {
    reset(width_, height_, framebuffer_);
    glDrawBuffer(draw_buffer_);
}

}  // namespace twinlight::fixed
