// The old state of OpenGL for exported shaders, in a core profile: each function sets what the function of GL or GLU with the same name
// and arguments set, with ff (fixed function) in place of gl or glu. Compile gl_state.c and kinds.c with your program.
//
//   if (!ffInit("shaders")) return 1;   // once, with a context: loads kind1.vert, kind1.frag, ...
//   ffLightfv(GL_LIGHT0, GL_POSITION, position);
//   ffBegin(GL_QUADS); ... ffEnd();     // draws with the shaders that fit the state
//
// Where no shaders fit, a draw takes those that fit best, and a line on stderr says what they lack. A draw leaves its program, vertex array
// and array buffer bound. C99 or C++. With a loader of GL functions, say so: -DGL_STATE_HEADER='<glad/glad.h>'.
#ifndef GL_STATE_H
#define GL_STATE_H

#ifdef GL_STATE_HEADER
#include GL_STATE_HEADER
#else
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>
#endif

#ifdef __cplusplus
extern "C" {
#endif

// Loads the shaders from the folder. Returns 0 after an error, with a line on stderr.
int ffInit(const char* folder);

// Capabilities that core GL lacks are kept here; the others go to GL.
void ffEnable(GLenum capability);
void ffDisable(GLenum capability);
GLboolean ffIsEnabled(GLenum capability);

// Matrices: GL_MODELVIEW, GL_PROJECTION and GL_TEXTURE, column by column. Angles are in degrees.
void ffMatrixMode(GLenum mode);
void ffPushMatrix(void);
void ffPopMatrix(void);
void ffLoadIdentity(void);
void ffLoadMatrixf(const GLfloat* m);
void ffLoadMatrixd(const GLdouble* m);
void ffMultMatrixf(const GLfloat* m);
void ffMultMatrixd(const GLdouble* m);
void ffTranslated(GLdouble x, GLdouble y, GLdouble z);
void ffRotated(GLdouble angle_deg, GLdouble x, GLdouble y, GLdouble z);
void ffScaled(GLdouble x, GLdouble y, GLdouble z);
void ffFrustum(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble near_z, GLdouble far_z);
void ffOrtho(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble near_z, GLdouble far_z);
void ffPerspective(GLdouble fovy_deg, GLdouble aspect, GLdouble near_z, GLdouble far_z);
void ffLookAt(GLdouble eye_x, GLdouble eye_y, GLdouble eye_z, GLdouble center_x, GLdouble center_y, GLdouble center_z,
              GLdouble up_x, GLdouble up_y, GLdouble up_z);
#define ffTranslatef ffTranslated
#define ffRotatef ffRotated
#define ffScalef ffScaled
#define ffOrtho2D(left, right, bottom, top) ffOrtho(left, right, bottom, top, -1, 1)

// Lights, materials and the rest. The modelview matrix transforms positions, directions and planes, as in GL.
void ffLightfv(GLenum light, GLenum parameter, const GLfloat* values);
void ffLightf(GLenum light, GLenum parameter, GLfloat value);
void ffLightModelfv(GLenum parameter, const GLfloat* values);
void ffLightModelf(GLenum parameter, GLfloat value);
void ffMaterialfv(GLenum face, GLenum parameter, const GLfloat* values);  // not between ffBegin and ffEnd
void ffMaterialf(GLenum face, GLenum parameter, GLfloat value);
void ffColorMaterial(GLenum face, GLenum mode);
void ffShadeModel(GLenum mode);
void ffFogfv(GLenum parameter, const GLfloat* values);
void ffFogf(GLenum parameter, GLfloat value);
void ffClipPlane(GLenum plane, const GLdouble* equation);
void ffAlphaFunc(GLenum function, GLfloat reference);
void ffPointSize(GLfloat size);
void ffTexEnvfv(GLenum target, GLenum parameter, const GLfloat* values);
void ffTexEnvf(GLenum target, GLenum parameter, GLfloat value);
void ffTexGeni(GLenum coordinate, GLenum parameter, GLint value);
void ffTexGenfv(GLenum coordinate, GLenum parameter, const GLfloat* plane);
#define ffLighti(light, parameter, value) ffLightf(light, parameter, (GLfloat)(value))
#define ffLightModeli(parameter, value) ffLightModelf(parameter, (GLfloat)(value))
#define ffMateriali(face, parameter, value) ffMaterialf(face, parameter, (GLfloat)(value))
#define ffFogi(parameter, value) ffFogf(parameter, (GLfloat)(value))
#define ffTexEnvi(target, parameter, value) ffTexEnvf(target, parameter, (GLfloat)(value))

// Primitives, also GL_QUADS, GL_QUAD_STRIP and GL_POLYGON.
void ffBegin(GLenum mode);
void ffEnd(void);
void ffVertex4f(GLfloat x, GLfloat y, GLfloat z, GLfloat w);
void ffVertex3fv(const GLfloat* v);
void ffVertex3dv(const GLdouble* v);
void ffNormal3f(GLfloat x, GLfloat y, GLfloat z);
void ffNormal3fv(const GLfloat* v);
void ffNormal3dv(const GLdouble* v);
void ffColor4f(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
void ffColor3fv(const GLfloat* v);
void ffColor4fv(const GLfloat* v);
void ffColor4ub(GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha);
void ffTexCoord4f(GLfloat s, GLfloat t, GLfloat r, GLfloat q);
void ffTexCoord2fv(const GLfloat* v);
#define ffVertex2f(x, y) ffVertex4f((GLfloat)(x), (GLfloat)(y), 0, 1)
#define ffVertex3f(x, y, z) ffVertex4f((GLfloat)(x), (GLfloat)(y), (GLfloat)(z), 1)
#define ffColor3f(red, green, blue) ffColor4f((GLfloat)(red), (GLfloat)(green), (GLfloat)(blue), 1)
#define ffColor3ub(red, green, blue) ffColor4ub(red, green, blue, 255)
#define ffTexCoord1f(s) ffTexCoord4f((GLfloat)(s), 0, 0, 1)
#define ffTexCoord2f(s, t) ffTexCoord4f((GLfloat)(s), (GLfloat)(t), 0, 1)
#define ffTexCoord3f(s, t, r) ffTexCoord4f((GLfloat)(s), (GLfloat)(t), (GLfloat)(r), 1)
#define ffVertex2d ffVertex2f
#define ffVertex2i ffVertex2f
#define ffVertex3d ffVertex3f
#define ffVertex3i ffVertex3f
#define ffNormal3d ffNormal3f
#define ffColor3d ffColor3f
#define ffColor4d ffColor4f
#define ffTexCoord2d ffTexCoord2f
#define ffTexCoord2i ffTexCoord2f

// Arrays: in memory, or offsets into the buffer of GL_ARRAY_BUFFER.
void ffEnableClientState(GLenum array);
void ffDisableClientState(GLenum array);
void ffVertexPointer(GLint size, GLenum type, GLsizei stride, const void* pointer);
void ffNormalPointer(GLenum type, GLsizei stride, const void* pointer);
void ffColorPointer(GLint size, GLenum type, GLsizei stride, const void* pointer);
void ffTexCoordPointer(GLint size, GLenum type, GLsizei stride, const void* pointer);
void ffDrawArrays(GLenum mode, GLint first, GLsizei count);
void ffDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices);

// ---- Not in GL ----

// Floats for another attribute of the shaders, such as a material's colour at each vertex. Size 0: it has none.
void ffAttributePointer(const char* attribute, GLint size, GLsizei stride, const void* pointer);
// Before other code draws triangles, such as glutSolidTeapot: makes the program current and sets its uniforms. Vertex is attribute 0, Normal
// attribute 1.
void ffUseProgram(void);
// Draws with this kind's shaders, even if others fit; 0: with those that fit. Needed where textures of other formats need other shaders.
void ffUseKind(int kind);
GLuint ffProgramOfKind(int kind);  // 0: there is no such kind

// ---- kinds.c ----

#define FF_LIGHTS 16
#define FF_ATTRIBUTES 16

// Kinds of state that need different shaders. Whatever is not here is a uniform.
enum {
    FF_LIGHTING = 1,
    FF_ANY_COLOR = 2,     // a texture replaces the colours, so that lighting does not matter
    FF_LIGHTS_ALPHA = 4,  // a texture replaces red, green and blue
    FF_FLAT = 8,
    FF_ANY_SHADE_MODEL = 0x10,  // each fragment is lit
    FF_TWO_SIDE = 0x20,
    FF_LOCAL_VIEWER = 0x40,
    FF_SEPARATE_SPECULAR = 0x80,
    FF_NORMALIZE = 0x100,
    FF_RESCALE = 0x200,
    FF_ANY_NORMAL = 0x400,       // no light needs it
    FF_SHININESS = 0x800,        // may be other than 0
    FF_REAL_SHININESS = 0x1000,  // may be other than a whole number
    FF_W = 0x2000,               // w in eye coordinates may be other than 1
    FF_ANY_W = 0x4000,           // nothing depends on it
    FF_TEXTURE_MATRIX = 0x8000,
    FF_Q = 0x10000,         // a texture coordinate's q may be other than 1
    FF_BY_NUMBER = 0x20000  // GL's state does not say that these shaders are needed: only for ffUseKind()
};

// A light; 0 if the shaders lack it.
enum {
    FF_AMBIENT = 1,
    FF_DIFFUSE = 2,
    FF_SPECULAR = 4,
    FF_DIRECTIONAL = 8,
    FF_ATTENUATED = 0x10,
    FF_SPOT = 0x20,
    FF_EXPONENT = 0x40,      // may be other than 0
    FF_REAL_EXPONENT = 0x80  // may be other than a whole number
};

// Materials' colours that glColorMaterial takes from each vertex; those of the back face are shifted by 4.
enum { FF_TRACKS_EMISSION = 1, FF_TRACKS_AMBIENT = 2, FF_TRACKS_DIFFUSE = 4, FF_TRACKS_SPECULAR = 8 };

struct ff_kind {
    const char* place;  // of its first draw: "scene.gl:12:1"
    unsigned features;
    unsigned tracks;
    unsigned lights[FF_LIGHTS];
    GLenum fog;            // GL_FOG_MODE; 0: none
    GLenum alpha_func;     // GL_ALWAYS: none
    unsigned clip_planes;  // a bit each
    GLenum texture;        // GL_TEXTURE_1D, 2D or 3D; 0: none
    GLenum env_mode;
    GLenum generated[4];  // GL_TEXTURE_GEN_MODE of s, t, r, q; 0: not generated; 1: not used
    const char* attributes[FF_ATTRIBUTES];
};

extern const struct ff_kind ff_kinds[];
extern const int ff_kind_count;

#ifdef __cplusplus
}
#endif

// ---- Names that headers for the core profile lack ----

#ifndef GL_LIGHTING
#define GL_QUADS 0x0007
#define GL_QUAD_STRIP 0x0008
#define GL_POLYGON 0x0009
#define GL_ADD 0x0104
#define GL_EXP 0x0800
#define GL_EXP2 0x0801
#define GL_LIGHTING 0x0B50
#define GL_LIGHT_MODEL_LOCAL_VIEWER 0x0B51
#define GL_LIGHT_MODEL_TWO_SIDE 0x0B52
#define GL_LIGHT_MODEL_AMBIENT 0x0B53
#define GL_COLOR_MATERIAL 0x0B57
#define GL_FOG 0x0B60
#define GL_FOG_DENSITY 0x0B62
#define GL_FOG_START 0x0B63
#define GL_FOG_END 0x0B64
#define GL_FOG_MODE 0x0B65
#define GL_FOG_COLOR 0x0B66
#define GL_NORMALIZE 0x0BA1
#define GL_ALPHA_TEST 0x0BC0
#define GL_TEXTURE_GEN_S 0x0C60
#define GL_TEXTURE_GEN_T 0x0C61
#define GL_TEXTURE_GEN_R 0x0C62
#define GL_TEXTURE_GEN_Q 0x0C63
#define GL_AMBIENT 0x1200
#define GL_DIFFUSE 0x1201
#define GL_SPECULAR 0x1202
#define GL_POSITION 0x1203
#define GL_SPOT_DIRECTION 0x1204
#define GL_SPOT_EXPONENT 0x1205
#define GL_SPOT_CUTOFF 0x1206
#define GL_CONSTANT_ATTENUATION 0x1207
#define GL_LINEAR_ATTENUATION 0x1208
#define GL_QUADRATIC_ATTENUATION 0x1209
#define GL_EMISSION 0x1600
#define GL_SHININESS 0x1601
#define GL_AMBIENT_AND_DIFFUSE 0x1602
#define GL_MODELVIEW 0x1700
#define GL_PROJECTION 0x1701
#define GL_FLAT 0x1D00
#define GL_SMOOTH 0x1D01
#define GL_S 0x2000
#define GL_T 0x2001
#define GL_R 0x2002
#define GL_Q 0x2003
#define GL_MODULATE 0x2100
#define GL_DECAL 0x2101
#define GL_TEXTURE_ENV_MODE 0x2200
#define GL_TEXTURE_ENV_COLOR 0x2201
#define GL_TEXTURE_ENV 0x2300
#define GL_EYE_LINEAR 0x2400
#define GL_OBJECT_LINEAR 0x2401
#define GL_SPHERE_MAP 0x2402
#define GL_TEXTURE_GEN_MODE 0x2500
#define GL_OBJECT_PLANE 0x2501
#define GL_EYE_PLANE 0x2502
#define GL_CLIP_PLANE0 0x3000
#define GL_CLIP_PLANE1 0x3001
#define GL_CLIP_PLANE2 0x3002
#define GL_CLIP_PLANE3 0x3003
#define GL_CLIP_PLANE4 0x3004
#define GL_CLIP_PLANE5 0x3005
#define GL_LIGHT0 0x4000
#define GL_LIGHT1 0x4001
#define GL_LIGHT2 0x4002
#define GL_LIGHT3 0x4003
#define GL_LIGHT4 0x4004
#define GL_LIGHT5 0x4005
#define GL_LIGHT6 0x4006
#define GL_LIGHT7 0x4007
#define GL_RESCALE_NORMAL 0x803A
#define GL_VERTEX_ARRAY 0x8074
#define GL_NORMAL_ARRAY 0x8075
#define GL_COLOR_ARRAY 0x8076
#define GL_TEXTURE_COORD_ARRAY 0x8078
#define GL_LIGHT_MODEL_COLOR_CONTROL 0x81F8
#define GL_SINGLE_COLOR 0x81F9
#define GL_SEPARATE_SPECULAR_COLOR 0x81FA
#define GL_NORMAL_MAP 0x8511
#define GL_REFLECTION_MAP 0x8512
#endif

#endif
