// GL's initial state (6.2), set value by value: a scene starts from it, and leaves nothing behind. An attribute stack
// would be shorter, but its levels belong to the scene.
#include <array>

#include "render/context/gl.h"
#include "render/fixed/fixed.h"

namespace twinlight::fixed {

namespace {

void close_and_empty_stacks() {
    GLint list = 0, depth = 0;
    glGetIntegerv(GL_LIST_INDEX, &list);
    if (list != 0) glEndList();
    for (glGetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth); depth > 0; --depth) glPopAttrib();
    for (glGetIntegerv(GL_CLIENT_ATTRIB_STACK_DEPTH, &depth); depth > 0; --depth) glPopClientAttrib();
}

void reset_stack(GLenum mode, GLenum depth_name) {
    glMatrixMode(mode);
    GLint depth = 1;
    for (glGetIntegerv(depth_name, &depth); depth > 1; --depth) glPopMatrix();
    glLoadIdentity();
}

void reset_lights() {
    const std::array<GLfloat, 4> black{0, 0, 0, 1}, white{1, 1, 1, 1}, forward{0, 0, 1, 0};
    const std::array<GLfloat, 3> down{0, 0, -1};
    for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light) {
        const auto& bright = light == GL_LIGHT0 ? white : black;
        glDisable(light);
        glLightfv(light, GL_AMBIENT, black.data());
        glLightfv(light, GL_DIFFUSE, bright.data());
        glLightfv(light, GL_SPECULAR, bright.data());
        glLightfv(light, GL_POSITION, forward.data());
        glLightfv(light, GL_SPOT_DIRECTION, down.data());
        glLightf(light, GL_SPOT_EXPONENT, 0);
        glLightf(light, GL_SPOT_CUTOFF, 180);
        glLightf(light, GL_CONSTANT_ATTENUATION, 1);
        glLightf(light, GL_LINEAR_ATTENUATION, 0);
        glLightf(light, GL_QUADRATIC_ATTENUATION, 0);
    }
}

void reset_lighting() {
    const std::array<GLfloat, 4> dim{0.2F, 0.2F, 0.2F, 1}, gray{0.8F, 0.8F, 0.8F, 1}, black{0, 0, 0, 1};
    const std::array<GLfloat, 3> indexes{0, 1, 1};
    std::array<GLfloat, 4> answer{};
    glColor4f(1, 1, 1, 1);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glDisable(GL_COLOR_MATERIAL);
    glDisable(GL_LIGHTING);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, dim.data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, gray.data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, black.data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, black.data());
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 0);
    glMaterialfv(GL_FRONT_AND_BACK, GL_COLOR_INDEXES, indexes.data());
    // Mesa carries glMaterial out late, over what the colour has given the material meanwhile; but before it answers.
    glGetMaterialfv(GL_FRONT, GL_AMBIENT, answer.data());
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, dim.data());
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_FALSE);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_FALSE);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
    glShadeModel(GL_SMOOTH);
    glDisable(GL_NORMALIZE);
    glDisable(GL_RESCALE_NORMAL);
    reset_lights();
}

void reset_raster(int width, int height) {
    glViewport(0, 0, width, height);
    glDepthRange(0, 1);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPolygonOffset(0, 0);
    glLineWidth(1);
    glPointSize(1);
    const std::array<GLfloat, 3> constant{1, 0, 0};
    std::array<GLfloat, 2> sizes{1, 1};
    glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, sizes.data());
    glPointParameterf(GL_POINT_SIZE_MIN, 0);
    glPointParameterf(GL_POINT_SIZE_MAX, sizes[1]);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 1);
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, constant.data());
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_UPPER_LEFT);
    glLineStipple(1, 0xFFFF);
    const std::array<GLubyte, 128> full = [] {
        std::array<GLubyte, 128> bits{};
        bits.fill(0xFF);
        return bits;
    }();
    glPolygonStipple(full.data());
    const std::array<GLdouble, 4> everything{0, 0, 0, 0};
    GLint planes = 6;
    glGetIntegerv(GL_MAX_CLIP_PLANES, &planes);
    for (GLint i = 0; i < planes; ++i) {
        glDisable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
        glClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), everything.data());
    }
    for (GLenum hint : {GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT,
                        GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT, GL_GENERATE_MIPMAP_HINT, GL_TEXTURE_COMPRESSION_HINT})
        glHint(hint, GL_DONT_CARE);
}

void reset_fragments(int width, int height) {
    const std::array<GLfloat, 4> nothing{0, 0, 0, 0};
    glScissor(0, 0, width, height);
    glAlphaFunc(GL_ALWAYS, 0);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glStencilMask(~0U);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBlendEquation(GL_FUNC_ADD);
    glBlendColor(0, 0, 0, 0);
    glLogicOp(GL_COPY);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glClearStencil(0);
    glClearAccum(0, 0, 0, 0);
    glFogi(GL_FOG_MODE, GL_EXP);
    glFogf(GL_FOG_DENSITY, 1);
    glFogf(GL_FOG_START, 0);
    glFogf(GL_FOG_END, 1);
    glFogf(GL_FOG_INDEX, 0);
    glFogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH);
    glFogfv(GL_FOG_COLOR, nothing.data());
}

// What the texture of name 0 keeps of its parameters; its images go with an empty one.
void reset_texture(GLenum target) {
    const std::array<GLfloat, 4> nothing{0, 0, 0, 0};
    glBindTexture(target, 0);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(target, GL_TEXTURE_WRAP_R, GL_REPEAT);
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, nothing.data());
    glTexParameterf(target, GL_TEXTURE_PRIORITY, 1);
    glTexParameteri(target, GL_GENERATE_MIPMAP, GL_FALSE);
    GLint largest = 1;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    for (GLint level = 0; largest >> level > 0; ++level) {
        GLint width = 0;
        glGetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &width);
        if (width == 0) continue;
        if (target == GL_TEXTURE_1D) {
            glTexImage1D(target, level, GL_RGBA, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        } else {
            glTexImage2D(target, level, GL_RGBA, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        }
    }
}

void reset_texture_units() {
    const std::array<GLfloat, 4> nothing{0, 0, 0, 0};
    GLint units = 1;
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
    for (GLint i = units - 1; i >= 0; --i) {  // unit 0 is the active one in the end
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        for (GLenum cap : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_GEN_S,
                           GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q})
            glDisable(cap);
        reset_texture(GL_TEXTURE_1D);
        reset_texture(GL_TEXTURE_2D);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, nothing.data());
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0);
        for (GLenum coord : {GL_S, GL_T, GL_R, GL_Q}) glTexGeni(coord, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
        glMultiTexCoord4f(GL_TEXTURE0 + static_cast<GLenum>(i), 0, 0, 0, 1);
        reset_stack(GL_TEXTURE, GL_TEXTURE_STACK_DEPTH);
    }
}

void reset_pixel_store() {
    for (GLenum name :
         {GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
          GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES, GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH,
          GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES})
        glPixelStorei(name, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelZoom(1, 1);
    for (GLenum name : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE})
        glPixelTransferf(name, 1);
    for (GLenum name : {GL_MAP_COLOR, GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET, GL_RED_BIAS, GL_GREEN_BIAS,
                        GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS})
        glPixelTransferi(name, 0);
    const std::array<GLfloat, 1> zero{0};
    for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_A_TO_A; ++map) glPixelMapfv(map, 1, zero.data());
}

void reset_arrays() {
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_INDEX_ARRAY, GL_EDGE_FLAG_ARRAY,
                         GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY})
        glDisableClientState(array);
    glVertexPointer(4, GL_FLOAT, 0, nullptr);
    glNormalPointer(GL_FLOAT, 0, nullptr);
    glColorPointer(4, GL_FLOAT, 0, nullptr);
    glEdgeFlagPointer(0, nullptr);
    GLint units = 1;
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
    for (GLint i = units - 1; i >= 0; --i) {
        glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(4, GL_FLOAT, 0, nullptr);
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
        glDisable(one);
        glDisable(two);
    }
}

void reset(int width, int height) {
    close_and_empty_stacks();
    reset_pixel_store();  // first: it says how the patterns below lie in memory
    for (GLenum cap : {GL_POINT_SMOOTH,
                       GL_LINE_SMOOTH,
                       GL_LINE_STIPPLE,
                       GL_POLYGON_SMOOTH,
                       GL_POLYGON_STIPPLE,
                       GL_CULL_FACE,
                       GL_POLYGON_OFFSET_POINT,
                       GL_POLYGON_OFFSET_LINE,
                       GL_POLYGON_OFFSET_FILL,
                       GL_FOG,
                       GL_COLOR_SUM,
                       GL_SCISSOR_TEST,
                       GL_ALPHA_TEST,
                       GL_STENCIL_TEST,
                       GL_DEPTH_TEST,
                       GL_BLEND,
                       GL_COLOR_LOGIC_OP,
                       GL_INDEX_LOGIC_OP,
                       GL_AUTO_NORMAL,
                       GL_SAMPLE_ALPHA_TO_COVERAGE,
                       GL_SAMPLE_ALPHA_TO_ONE,
                       GL_SAMPLE_COVERAGE,
                       GL_VERTEX_PROGRAM_POINT_SIZE,
                       GL_POINT_SPRITE,
                       GL_DEPTH_CLAMP})
        glDisable(cap);
    glEnable(GL_DITHER);
    glEnable(GL_MULTISAMPLE);
    glNormal3f(0, 0, 1);
    glEdgeFlag(GL_TRUE);
    glListBase(0);
    glSecondaryColor3f(0, 0, 0);
    glFogCoordf(0);
    reset_lighting();
    reset_raster(width, height);
    reset_fragments(width, height);
    reset_texture_units();
    reset_evaluators();  // where unit 0 is the active one
    reset_arrays();
    reset_stack(GL_PROJECTION, GL_PROJECTION_STACK_DEPTH);
    reset_stack(GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH);
}

}  // namespace

Enum draw_buffer() {
    GLint buffer = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER, &buffer);
    return static_cast<Enum>(buffer);
}

InitialState::InitialState(int width, int height) : width_(width), height_(height), draw_buffer_(draw_buffer()) {
    reset(width_, height_);
}

InitialState::~InitialState() {
    reset(width_, height_);
    glDrawBuffer(draw_buffer_);
}

}  // namespace twinlight::fixed
