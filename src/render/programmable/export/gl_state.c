// GL's old state as uniforms. gl_state.h says what each function does; the sections are those of the OpenGL 2.1 specification.
#include "gl_state.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- Uniforms: the state itself, under the names in the shaders ----

enum { PARAMETERS = 12, MATERIALS = 5, PLANES = 8, STACK = 32 };

// The members of LightSource[i] and of FrontMaterial and BackMaterial, with their floats.
struct member {
    const char* name;
    int floats;
    GLenum parameter;  // of glLight or glMaterial; 0: computed from others
};
enum {
    AMBIENT,
    DIFFUSE,
    SPECULAR,
    POSITION,
    HALF_VECTOR,
    SPOT_DIRECTION,
    SPOT_EXPONENT,
    SPOT_CUTOFF,
    COS_CUTOFF,
    CONSTANT,
    LINEAR,
    QUADRATIC
};
static const struct member light_members[PARAMETERS] = {{"ambient", 4, GL_AMBIENT},
                                                        {"diffuse", 4, GL_DIFFUSE},
                                                        {"specular", 4, GL_SPECULAR},
                                                        {"position", 4, GL_POSITION},
                                                        {"halfVector", 4, 0},
                                                        {"spotDirection", 3, GL_SPOT_DIRECTION},
                                                        {"spotExponent", 1, GL_SPOT_EXPONENT},
                                                        {"spotCutoff", 1, GL_SPOT_CUTOFF},
                                                        {"spotCosCutoff", 1, 0},
                                                        {"constantAttenuation", 1, GL_CONSTANT_ATTENUATION},
                                                        {"linearAttenuation", 1, GL_LINEAR_ATTENUATION},
                                                        {"quadraticAttenuation", 1, GL_QUADRATIC_ATTENUATION}};
enum { M_EMISSION, M_AMBIENT, M_DIFFUSE, M_SPECULAR, M_SHININESS };
static const struct member material_members[MATERIALS] = {{"emission", 4, GL_EMISSION},
                                                          {"ambient", 4, GL_AMBIENT},
                                                          {"diffuse", 4, GL_DIFFUSE},
                                                          {"specular", 4, GL_SPECULAR},
                                                          {"shininess", 1, GL_SHININESS}};

enum {
    MODEL_VIEW_PROJECTION,
    MODEL_VIEW,
    NORMAL_MATRIX,
    NORMAL_SCALE,
    TEXTURE_MATRIX,
    OBJECT_PLANE,
    EYE_PLANE = OBJECT_PLANE + 4,
    ENV_COLOR = EYE_PLANE + 4,
    SCENE_AMBIENT,
    FOG_COLOR,
    FOG_DENSITY,
    FOG_START,
    FOG_END,
    FOG_SCALE,
    ALPHA_REF,
    POINT_SIZE,
    CLIP_PLANE,
    MATERIAL = CLIP_PLANE + PLANES,  // of the front, then of the back
    LIGHT = MATERIAL + 2 * MATERIALS,
    UNIFORMS = LIGHT + FF_LIGHTS * PARAMETERS
};
static const struct member other_members[MATERIAL] = {{"ModelViewProjectionMatrix", 16, 0},
                                                      {"ModelViewMatrix", 16, 0},
                                                      {"NormalMatrix", 9, 0},
                                                      {"NormalScale", 1, 0},
                                                      {"TextureMatrix[0]", 16, 0},
                                                      {"ObjectPlaneS[0]", 4, 0},
                                                      {"ObjectPlaneT[0]", 4, 0},
                                                      {"ObjectPlaneR[0]", 4, 0},
                                                      {"ObjectPlaneQ[0]", 4, 0},
                                                      {"EyePlaneS[0]", 4, 0},
                                                      {"EyePlaneT[0]", 4, 0},
                                                      {"EyePlaneR[0]", 4, 0},
                                                      {"EyePlaneQ[0]", 4, 0},
                                                      {"TextureEnvColor[0]", 4, 0},
                                                      {"LightModel.ambient", 4, 0},
                                                      {"Fog.color", 4, 0},
                                                      {"Fog.density", 1, 0},
                                                      {"Fog.start", 1, 0},
                                                      {"Fog.end", 1, 0},
                                                      {"Fog.scale", 1, 0},
                                                      {"AlphaRef", 1, 0},
                                                      {"PointSize", 1, 0},
                                                      {"ClipPlane[0]", 4, 0},
                                                      {"ClipPlane[1]", 4, 0},
                                                      {"ClipPlane[2]", 4, 0},
                                                      {"ClipPlane[3]", 4, 0},
                                                      {"ClipPlane[4]", 4, 0},
                                                      {"ClipPlane[5]", 4, 0},
                                                      {"ClipPlane[6]", 4, 0},
                                                      {"ClipPlane[7]", 4, 0}};

static float uniforms[UNIFORMS][16];
static unsigned changed[UNIFORMS];  // the value of `changes` after the last change
static unsigned changes = 1;

static void set(int uniform, const float* values, int floats) {
    if (memcmp(uniforms[uniform], values, (size_t)floats * sizeof *values) == 0) return;
    memcpy(uniforms[uniform], values, (size_t)floats * sizeof *values);
    changed[uniform] = ++changes;
}
static void set_one(int uniform, float value) { set(uniform, &value, 1); }

static float* light_value(int light, int parameter) { return uniforms[LIGHT + light * PARAMETERS + parameter]; }
static float* material_value(int face, int property) { return uniforms[MATERIAL + face * MATERIALS + property]; }

// ---- The rest of the state, with GL's initial values ----

static const GLenum capabilities[] = {GL_LIGHTING,     GL_COLOR_MATERIAL, GL_NORMALIZE,     GL_RESCALE_NORMAL,
                                      GL_FOG,          GL_ALPHA_TEST,     GL_TEXTURE_1D,    GL_TEXTURE_2D,
                                      GL_TEXTURE_3D,   GL_TEXTURE_GEN_S,  GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R,
                                      GL_TEXTURE_GEN_Q};
enum { CAPABILITIES = sizeof capabilities / sizeof *capabilities };
static int is_on[CAPABILITIES], light_is_on[FF_LIGHTS], plane_is_on[PLANES];

static double matrices[3][STACK][16];  // GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE
static int depth[3], stack;
static int local_viewer, two_side, separate_specular;
static GLenum shade_model = GL_SMOOTH, fog_mode = GL_EXP, alpha_func = GL_ALWAYS, env_mode = GL_MODULATE;
static GLenum gen_mode[4] = {GL_EYE_LINEAR, GL_EYE_LINEAR, GL_EYE_LINEAR, GL_EYE_LINEAR};
static GLenum color_face = GL_FRONT_AND_BACK, color_mode = GL_AMBIENT_AND_DIFFUSE;

// ---- Vertices ----

enum { A_VERTEX, A_NORMAL, A_COLOR, A_TEX_COORD, NAMED_ARRAYS };
struct array {
    const char* name;
    int is_enabled;
    GLint size;
    GLenum type;
    GLsizei stride;
    const char* pointer;
    GLuint buffer;  // 0: the pointer is an address in memory
};
static struct array arrays[FF_ATTRIBUTES] = {{"Vertex", 0, 4, GL_FLOAT, 0, NULL, 0},
                                             {"Normal", 0, 3, GL_FLOAT, 0, NULL, 0},
                                             {"Color", 0, 4, GL_FLOAT, 0, NULL, 0},
                                             {"MultiTexCoord0", 0, 4, GL_FLOAT, 0, NULL, 0}};
static int array_count = NAMED_ARRAYS;
static float current[NAMED_ARRAYS][4] = {{0, 0, 0, 1}, {0, 0, 1, 0}, {1, 1, 1, 1}, {0, 0, 0, 1}};

struct vertex {
    float values[NAMED_ARRAYS][4];
};
static struct vertex* vertices;
static size_t vertex_count, vertex_room;
static GLenum begun;
static int is_begun;

// ---- Kinds of shaders ----

struct loaded {
    GLuint program;
    GLint locations[UNIFORMS];
    GLint attributes[FF_ATTRIBUTES];  // their locations
    unsigned uploaded;                // the value of `changes` then
};
static struct loaded* loaded;
static int wanted_kind;
static GLuint vertex_array, stream, index_stream;

static char* whole_file(const char* name) {
    FILE* file = fopen(name, "rb");
    char* text = NULL;
    if (file && fseek(file, 0, SEEK_END) == 0) {
        const long size = ftell(file);
        text = size < 0 ? NULL : (char*)calloc((size_t)size + 1, 1);
        rewind(file);
        if (text && fread(text, 1, (size_t)size, file) != (size_t)size) {
            free(text);
            text = NULL;
        }
    }
    if (file) fclose(file);
    if (!text) fprintf(stderr, "%s: cannot be read; ffInit() takes the folder of the exported shaders\n", name);
    return text;
}

static int attach(GLuint program, const char* folder, int kind, const char* ending) {
    char name[1024], log[4096] = "";
    snprintf(name, sizeof name, "%s/kind%d.%s", folder, kind, ending);
    char* text = whole_file(name);
    if (!text) return 0;
    const GLchar* source = text;
    const GLuint shader = glCreateShader(strcmp(ending, "vert") == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    GLint compiled = 0;
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    if (!compiled) fprintf(stderr, "%s: %s\n", name, log);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    free(text);
    return compiled;
}

static void find_locations(struct loaded* kind) {
    char name[64];
    for (int i = 0; i < MATERIAL; ++i) kind->locations[i] = glGetUniformLocation(kind->program, other_members[i].name);
    for (int i = 0; i < 2 * MATERIALS; ++i) {
        snprintf(name, sizeof name, "%sMaterial.%s", i < MATERIALS ? "Front" : "Back",
                 material_members[i % MATERIALS].name);
        kind->locations[MATERIAL + i] = glGetUniformLocation(kind->program, name);
    }
    for (int i = 0; i < FF_LIGHTS * PARAMETERS; ++i) {
        snprintf(name, sizeof name, "LightSource[%d].%s", i / PARAMETERS, light_members[i % PARAMETERS].name);
        kind->locations[LIGHT + i] = glGetUniformLocation(kind->program, name);
    }
}

static int load(const char* folder, int number) {
    struct loaded* kind = &loaded[number - 1];
    const char* const* attributes = ff_kinds[number - 1].attributes;
    char log[4096] = "";
    GLint linked = 0;
    kind->program = glCreateProgram();
    if (!attach(kind->program, folder, number, "vert") || !attach(kind->program, folder, number, "frag")) return 0;
    for (int i = 0; i < FF_ATTRIBUTES && attributes[i]; ++i)
        glBindAttribLocation(kind->program, (GLuint)i, attributes[i]);
    glLinkProgram(kind->program);
    glGetProgramiv(kind->program, GL_LINK_STATUS, &linked);
    glGetProgramInfoLog(kind->program, sizeof log, NULL, log);
    if (!linked) fprintf(stderr, "%s/kind%d.vert and .frag: %s\n", folder, number, log);
    for (int i = 0; i < FF_ATTRIBUTES && attributes[i]; ++i)
        kind->attributes[i] = glGetAttribLocation(kind->program, attributes[i]);
    find_locations(kind);
    return linked;
}

int ffInit(const char* folder) {
    static const float white[4] = {1, 1, 1, 1}, black[4] = {0, 0, 0, 1}, ambient[4] = {0.2f, 0.2f, 0.2f, 1},
                       diffuse[4] = {0.8f, 0.8f, 0.8f, 1};
    static const float toward_viewer[4] = {0, 0, 1, 0}, away[3] = {0, 0, -1};
    for (stack = 2; stack > 0; --stack) ffLoadIdentity();
    ffLoadIdentity();
    for (int light = 0; light < FF_LIGHTS; ++light) {
        const int first = LIGHT + light * PARAMETERS;
        set(first + AMBIENT, black, 4);
        set(first + DIFFUSE, light == 0 ? white : black, 4);
        set(first + SPECULAR, light == 0 ? white : black, 4);
        set(first + POSITION, toward_viewer, 4);
        set(first + HALF_VECTOR, toward_viewer, 4);
        set(first + SPOT_DIRECTION, away, 3);
        set_one(first + SPOT_CUTOFF, 180);
        set_one(first + COS_CUTOFF, -1);
        set_one(first + CONSTANT, 1);
    }
    for (int face = 0; face < 2; ++face) {
        const int first = MATERIAL + face * MATERIALS;
        set(first + M_EMISSION, black, 4);
        set(first + M_AMBIENT, ambient, 4);
        set(first + M_DIFFUSE, diffuse, 4);
        set(first + M_SPECULAR, black, 4);
    }
    set(SCENE_AMBIENT, ambient, 4);
    set_one(FOG_DENSITY, 1);
    set_one(FOG_END, 1);
    set_one(FOG_SCALE, 1);
    set_one(POINT_SIZE, 1);
    for (int i = 0; i < 2; ++i) {  // the initial planes of s and t (section 2.11.4)
        float plane[4] = {0, 0, 0, 0};
        plane[i] = 1;
        set(OBJECT_PLANE + i, plane, 4);
        set(EYE_PLANE + i, plane, 4);
    }

    glGenVertexArrays(1, &vertex_array);
    glGenBuffers(1, &stream);
    glGenBuffers(1, &index_stream);
    glBindVertexArray(vertex_array);
    loaded = (struct loaded*)calloc((size_t)ff_kind_count + 1, sizeof *loaded);
    if (!loaded) return 0;
    for (int number = 1; number <= ff_kind_count; ++number)
        if (!load(folder, number)) return 0;
    return 1;
}

void ffUseKind(int kind) { wanted_kind = kind; }
GLuint ffProgramOfKind(int kind) { return kind > 0 && kind <= ff_kind_count ? loaded[kind - 1].program : 0; }

// ---- Capabilities ----

// Where the capability is kept, or NULL if GL has it.
static int* capability_of(GLenum capability) {
    for (int i = 0; i < CAPABILITIES; ++i)
        if (capabilities[i] == capability) return &is_on[i];
    if (capability >= GL_LIGHT0 && capability < GL_LIGHT0 + FF_LIGHTS) return &light_is_on[capability - GL_LIGHT0];
    if (capability >= GL_CLIP_PLANE0 && capability < GL_CLIP_PLANE0 + PLANES)
        return &plane_is_on[capability - GL_CLIP_PLANE0];
    return NULL;
}
static int on(GLenum capability) { return *capability_of(capability); }

static void put(GLenum capability, int value) {
    int* kept = capability_of(capability);
    if (!kept) {
        if (value)
            glEnable(capability);
        else
            glDisable(capability);
        return;
    }
    if (*kept == value) return;
    *kept = value;
    ++changes;
    // The uniforms of a light or plane depend on whether it is on: see value_of().
    if (capability >= GL_LIGHT0 && capability < GL_LIGHT0 + FF_LIGHTS)
        for (int i = 0; i < PARAMETERS; ++i) changed[LIGHT + (int)(capability - GL_LIGHT0) * PARAMETERS + i] = changes;
    if (capability >= GL_CLIP_PLANE0 && capability < GL_CLIP_PLANE0 + PLANES)
        changed[CLIP_PLANE + (int)(capability - GL_CLIP_PLANE0)] = changes;
    if (capability == GL_COLOR_MATERIAL) ffColor4fv(current[A_COLOR]);
}
void ffEnable(GLenum capability) { put(capability, 1); }
void ffDisable(GLenum capability) { put(capability, 0); }
GLboolean ffIsEnabled(GLenum capability) {
    const int* kept = capability_of(capability);
    return kept ? (GLboolean)*kept : glIsEnabled(capability);
}

// ---- Matrices (section 2.11.2) ----

static double* top(int of) { return matrices[of][depth[of]]; }

static void multiply(double* result, const double* a, const double* b) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            result[4 * column + row] = 0;
            for (int i = 0; i < 4; ++i) result[4 * column + row] += a[4 * i + row] * b[4 * column + i];
        }
}

static void set_matrix(int uniform, const double* m) {
    float values[16];
    for (int i = 0; i < 16; ++i) values[i] = (float)m[i];
    set(uniform, values, 16);
}

static void matrix_changed(void) {
    double product[16], normal[9], determinant = 0;
    float values[9];
    const double* m = top(0);
    if (stack == 2) {
        set_matrix(TEXTURE_MATRIX, top(2));
        return;
    }
    multiply(product, top(1), m);
    set_matrix(MODEL_VIEW_PROJECTION, product);
    if (stack == 1) return;
    set_matrix(MODEL_VIEW, m);
    // The transposed inverse: cross products of two columns, divided by the determinant. A singular matrix gives 0.
    for (int column = 0; column < 3; ++column) {
        const double *a = &m[4 * ((column + 1) % 3)], *b = &m[4 * ((column + 2) % 3)];
        for (int i = 0; i < 3; ++i)
            normal[3 * column + i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
    for (int i = 0; i < 3; ++i) determinant += m[i] * normal[i];
    for (int i = 0; i < 9; ++i) values[i] = determinant == 0 ? 0 : (float)(normal[i] / determinant);
    set(NORMAL_MATRIX, values, 9);

    const float length = sqrtf(values[6] * values[6] + values[7] * values[7] + values[8] * values[8]);
    set_one(NORMAL_SCALE, length > 0 ? 1 / length : 1);
}

void ffMatrixMode(GLenum mode) { stack = mode == GL_MODELVIEW ? 0 : mode == GL_PROJECTION ? 1 : 2; }
void ffPushMatrix(void) {
    if (depth[stack] == STACK - 1) return;
    memcpy(matrices[stack][depth[stack] + 1], top(stack), sizeof matrices[0][0]);
    ++depth[stack];
}
void ffPopMatrix(void) {
    if (depth[stack] == 0) return;
    --depth[stack];
    matrix_changed();
}
void ffLoadMatrixd(const GLdouble* m) {
    memcpy(top(stack), m, sizeof matrices[0][0]);
    matrix_changed();
}
void ffMultMatrixd(const GLdouble* m) {
    double product[16];
    multiply(product, top(stack), m);
    ffLoadMatrixd(product);
}
static void to_doubles(double* result, const GLfloat* m) {
    for (int i = 0; i < 16; ++i) result[i] = m[i];
}
void ffLoadMatrixf(const GLfloat* m) {
    double doubles[16];
    to_doubles(doubles, m);
    ffLoadMatrixd(doubles);
}
void ffMultMatrixf(const GLfloat* m) {
    double doubles[16];
    to_doubles(doubles, m);
    ffMultMatrixd(doubles);
}
void ffLoadIdentity(void) {
    const double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    ffLoadMatrixd(m);
}
void ffTranslated(GLdouble x, GLdouble y, GLdouble z) {
    const double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
    ffMultMatrixd(m);
}
void ffScaled(GLdouble x, GLdouble y, GLdouble z) {
    const double m[16] = {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1};
    ffMultMatrixd(m);
}

static const double radian = 3.14159265358979323846 / 180;

void ffRotated(GLdouble angle_deg, GLdouble x, GLdouble y, GLdouble z) {
    const double s = sin(angle_deg * radian), c = cos(angle_deg * radian), length = sqrt(x * x + y * y + z * z);
    if (length == 0) return;
    x /= length, y /= length, z /= length;
    const double m[16] = {x * x * (1 - c) + c,
                          y * x * (1 - c) + z * s,
                          x * z * (1 - c) - y * s,
                          0,
                          x * y * (1 - c) - z * s,
                          y * y * (1 - c) + c,
                          y * z * (1 - c) + x * s,
                          0,
                          x * z * (1 - c) + y * s,
                          y * z * (1 - c) - x * s,
                          z * z * (1 - c) + c,
                          0,
                          0,
                          0,
                          0,
                          1};
    ffMultMatrixd(m);
}
void ffFrustum(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top_y, GLdouble near_z, GLdouble far_z) {
    const double w = right - left, h = top_y - bottom, d = far_z - near_z;
    const double m[16] = {2 * near_z / w,
                          0,
                          0,
                          0,
                          0,
                          2 * near_z / h,
                          0,
                          0,
                          (right + left) / w,
                          (top_y + bottom) / h,
                          -(far_z + near_z) / d,
                          -1,
                          0,
                          0,
                          -2 * far_z * near_z / d,
                          0};
    ffMultMatrixd(m);
}
void ffOrtho(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top_y, GLdouble near_z, GLdouble far_z) {
    const double w = right - left, h = top_y - bottom, d = far_z - near_z;
    const double m[16] = {2 / w,
                          0,
                          0,
                          0,
                          0,
                          2 / h,
                          0,
                          0,
                          0,
                          0,
                          -2 / d,
                          0,
                          -(right + left) / w,
                          -(top_y + bottom) / h,
                          -(far_z + near_z) / d,
                          1};
    ffMultMatrixd(m);
}
void ffPerspective(GLdouble fovy_deg, GLdouble aspect, GLdouble near_z, GLdouble far_z) {
    const double f = 1 / tan(fovy_deg * radian / 2), d = near_z - far_z;
    const double m[16] = {f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far_z + near_z) / d, -1, 0, 0, 2 * far_z * near_z / d,
                          0};
    ffMultMatrixd(m);
}

static void cross(double* result, const double* a, const double* b) {
    for (int i = 0; i < 3; ++i) result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}
static void normalize(double* v) {
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; length > 0 && i < 3; ++i) v[i] /= length;
}
void ffLookAt(GLdouble eye_x, GLdouble eye_y, GLdouble eye_z, GLdouble center_x, GLdouble center_y, GLdouble center_z,
              GLdouble up_x, GLdouble up_y, GLdouble up_z) {
    double f[3] = {center_x - eye_x, center_y - eye_y, center_z - eye_z}, u[3] = {up_x, up_y, up_z}, s[3];
    normalize(f);
    cross(s, f, u);
    normalize(s);
    cross(u, s, f);
    const double m[16] = {s[0], u[0], -f[0], 0, s[1], u[1], -f[1], 0, s[2], u[2], -f[2], 0, 0, 0, 0, 1};
    ffMultMatrixd(m);
    ffTranslated(-eye_x, -eye_y, -eye_z);
}

// v in eye coordinates; `rows`: of the result.
static void to_eye(float* result, const GLfloat* v, int rows, float w) {
    const double* m = top(0);
    for (int row = 0; row < rows; ++row)
        result[row] = (float)(m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2] + m[12 + row] * w);
}

// A plane is a row: it is multiplied by the inverse of the modelview matrix. A singular matrix gives 0.
static void plane_to_eye(float* result, const double* plane) {
    double rows[4][5];  // the transposed matrix, and the plane as the right side
    const double* m = top(0);
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) rows[i][j] = m[4 * i + j];
        rows[i][4] = plane[i];
    }
    for (int i = 0; i < 4; ++i) {
        int largest = i;
        for (int j = i + 1; j < 4; ++j)
            if (fabs(rows[j][i]) > fabs(rows[largest][i])) largest = j;
        double row[5];
        memcpy(row, rows[largest], sizeof row);
        memcpy(rows[largest], rows[i], sizeof row);
        memcpy(rows[i], row, sizeof row);
        for (int j = 0; j < 4; ++j) {
            const double factor = j == i || rows[i][i] == 0 ? 0 : rows[j][i] / rows[i][i];
            for (int column = i; factor != 0 && column < 5; ++column) rows[j][column] -= factor * rows[i][column];
        }
    }
    for (int i = 0; i < 4; ++i) result[i] = rows[i][i] == 0 ? 0 : (float)(rows[i][4] / rows[i][i]);
}

// ---- Lights and materials (section 2.14.2) ----

void ffLightfv(GLenum light, GLenum parameter, const GLfloat* values) {
    const int number = (int)(light - GL_LIGHT0);
    float eye[4];
    if (number < 0 || number >= FF_LIGHTS) return;
    const int first = LIGHT + number * PARAMETERS;
    if (parameter == GL_POSITION) {
        to_eye(eye, values, 4, values[3]);
        values = eye;
        // Halfway between the light's direction and the viewer at infinity, (0, 0, 1).
        const float size = sqrtf(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
        float half[4] = {eye[0], eye[1], eye[2] + size, 0};
        const float half_size = sqrtf(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
        for (int i = 0; half_size > 0 && i < 3; ++i) half[i] /= half_size;
        set(first + HALF_VECTOR, half, 4);
    } else if (parameter == GL_SPOT_DIRECTION) {
        to_eye(eye, values, 3, 0);
        values = eye;
    } else if (parameter == GL_SPOT_CUTOFF) {
        set_one(first + COS_CUTOFF, (float)cos(*values * radian));
        changed[first + SPOT_EXPONENT] = ++changes;  // see value_of()
    }
    for (int i = 0; i < PARAMETERS; ++i)
        if (light_members[i].parameter == parameter) set(first + i, values, light_members[i].floats);
}
void ffLightf(GLenum light, GLenum parameter, GLfloat value) {
    const GLfloat values[4] = {value, 0, 0, 0};
    ffLightfv(light, parameter, values);
}

void ffLightModelfv(GLenum parameter, const GLfloat* values) {
    const int value = (int)*values;
    if (parameter == GL_LIGHT_MODEL_AMBIENT) {
        set(SCENE_AMBIENT, values, 4);
        return;
    }
    ++changes;
    if (parameter == GL_LIGHT_MODEL_LOCAL_VIEWER) local_viewer = value != 0;
    if (parameter == GL_LIGHT_MODEL_TWO_SIDE) two_side = value != 0;
    if (parameter == GL_LIGHT_MODEL_COLOR_CONTROL) separate_specular = value == GL_SEPARATE_SPECULAR_COLOR;
}
void ffLightModelf(GLenum parameter, GLfloat value) {
    const GLfloat values[4] = {value, 0, 0, 0};
    ffLightModelfv(parameter, values);
}

static void set_material(GLenum face, GLenum parameter, const GLfloat* values) {
    for (int i = 0; i < 2 * MATERIALS; ++i) {
        const struct member* property = &material_members[i % MATERIALS];
        const int both = parameter == GL_AMBIENT_AND_DIFFUSE &&
                         (property->parameter == GL_AMBIENT || property->parameter == GL_DIFFUSE);
        if (face == (i < MATERIALS ? GL_BACK : GL_FRONT)) continue;
        if (both || property->parameter == parameter) set(MATERIAL + i, values, property->floats);
    }
}

static void warn_once(int* said, const char* what) {
    if (!*said) fprintf(stderr, "gl_state: %s\n", what);
    *said = 1;
}

void ffMaterialfv(GLenum face, GLenum parameter, const GLfloat* values) {
    static int said;
    if (is_begun && vertex_count > 0)
        warn_once(&said,
                  "glMaterial between glBegin and glEnd changes all of the primitive; use glColorMaterial and glColor "
                  "there, or one glBegin for "
                  "each material");
    set_material(face, parameter, values);
}
void ffMaterialf(GLenum face, GLenum parameter, GLfloat value) {
    const GLfloat values[4] = {value, 0, 0, 0};
    ffMaterialfv(face, parameter, values);
}
void ffColorMaterial(GLenum face, GLenum mode) {
    color_face = face;
    color_mode = mode;
    ++changes;
    ffColor4fv(current[A_COLOR]);
}
void ffShadeModel(GLenum mode) {
    shade_model = mode;
    ++changes;
}

// ---- Fog, clip planes, the alpha test, points ----

void ffFogfv(GLenum parameter, const GLfloat* values) {
    if (parameter == GL_FOG_COLOR) set(FOG_COLOR, values, 4);
    if (parameter == GL_FOG_DENSITY) set_one(FOG_DENSITY, *values);
    if (parameter == GL_FOG_START) set_one(FOG_START, *values);
    if (parameter == GL_FOG_END) set_one(FOG_END, *values);
    if (parameter == GL_FOG_MODE) fog_mode = (GLenum)*values;
    const float start = *uniforms[FOG_START], end = *uniforms[FOG_END];
    set_one(FOG_SCALE, end == start ? 1e30f : 1 / (end - start));
    ++changes;
}
void ffFogf(GLenum parameter, GLfloat value) {
    const GLfloat values[4] = {value, 0, 0, 0};
    ffFogfv(parameter, values);
}

void ffClipPlane(GLenum plane, const GLdouble* equation) {
    float eye[4];
    if (plane < GL_CLIP_PLANE0 || plane >= GL_CLIP_PLANE0 + PLANES) return;
    plane_to_eye(eye, equation);
    set(CLIP_PLANE + (int)(plane - GL_CLIP_PLANE0), eye, 4);
}
void ffAlphaFunc(GLenum function, GLfloat reference) {
    alpha_func = function;
    ++changes;
    set_one(ALPHA_REF, reference < 0 ? 0 : reference > 1 ? 1 : reference);
}
void ffPointSize(GLfloat size) {
    glPointSize(size);
    set_one(POINT_SIZE, size < 1 ? 1 : floorf(size + 0.5f));
}

// ---- Textures: their environment and coordinates (sections 3.8.13 and 2.11.4) ----

void ffTexEnvfv(GLenum target, GLenum parameter, const GLfloat* values) {
    if (target != GL_TEXTURE_ENV) return;
    if (parameter == GL_TEXTURE_ENV_COLOR) set(ENV_COLOR, values, 4);
    if (parameter == GL_TEXTURE_ENV_MODE) {
        env_mode = (GLenum)*values;
        ++changes;
    }
}
void ffTexEnvf(GLenum target, GLenum parameter, GLfloat value) {
    const GLfloat values[4] = {value, 0, 0, 0};
    ffTexEnvfv(target, parameter, values);
}

void ffTexGeni(GLenum coordinate, GLenum parameter, GLint value) {
    if (parameter != GL_TEXTURE_GEN_MODE || coordinate < GL_S || coordinate > GL_Q) return;
    gen_mode[coordinate - GL_S] = (GLenum)value;
    ++changes;
}
void ffTexGenfv(GLenum coordinate, GLenum parameter, const GLfloat* plane) {
    float eye[4];
    const double doubles[4] = {plane[0], plane[1], plane[2], plane[3]};
    if (coordinate < GL_S || coordinate > GL_Q) return;
    if (parameter == GL_OBJECT_PLANE) set(OBJECT_PLANE + (int)(coordinate - GL_S), plane, 4);
    if (parameter != GL_EYE_PLANE) return;
    plane_to_eye(eye, doubles);
    set(EYE_PLANE + (int)(coordinate - GL_S), eye, 4);
}

// ---- Which shaders fit the state ----

// What is known about the vertices of a draw.
struct drawn {
    GLenum mode;
    int colors_vary, has_w, has_q;
};

// What shaders may lack: one message for each.
enum {
    LACKS_LIGHTING,
    LACKS_SHADE_MODEL,
    LACKS_TWO_SIDE,
    LACKS_LOCAL_VIEWER,
    LACKS_SEPARATE,
    LACKS_NORMALIZE,
    LACKS_RESCALE,
    LACKS_SHININESS,
    LACKS_COLOR_MATERIAL,
    LACKS_W,
    LACKS_TEXTURE,
    LACKS_ENV_MODE,
    LACKS_TEXTURE_MATRIX,
    LACKS_Q,
    LACKS_GENERATED,
    LACKS_FOG,
    LACKS_ALPHA_TEST,
    LACKS_CLIP_PLANE,
    LACKS_ATTRIBUTE,
    LACKS_NUMBER,
    LACKS_LIGHT,
    LACKS = LACKS_LIGHT + 6 * FF_LIGHTS
};

struct judgement {
    int kind, says, misses;
    GLenum mode;
};

static void miss(struct judgement* j, int what, const char* message, int number) {
    static const char* const modes[] = {"GL_POINTS",     "GL_LINES",          "GL_LINE_LOOP",    "GL_LINE_STRIP",
                                        "GL_TRIANGLES",  "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN", "GL_QUADS",
                                        "GL_QUAD_STRIP", "GL_POLYGON"};
    static int said[LACKS];
    ++j->misses;
    if (!j->says || said[what]) return;
    said[what] = 1;
    if (what == LACKS_NUMBER) {
        fprintf(stderr,
                "gl_state: %s (%s) needs ffUseKind(%d), as scene.c has it: the state does not choose between these "
                "shaders and others\n",
                j->mode < 10 ? modes[j->mode] : "a draw", ff_kinds[j->kind].place, j->kind + 1);
        return;
    }
    char text[160];
    snprintf(text, sizeof text, message, number);
    fprintf(stderr,
            "gl_state: %s: no exported shaders do that, so %s draws with kind%d, of %s; let the program draw it so in "
            "the frame that you export\n",
            text, j->mode < 10 ? modes[j->mode] : "this", j->kind + 1, ff_kinds[j->kind].place);
}

static int is_whole(float x) { return x == floorf(x); }
// Whether the product is black in red, green and blue.
static int is_black(const float* light, const float* material) {
    return light[0] * material[0] == 0 && light[1] * material[1] == 0 && light[2] * material[2] == 0;
}
static int tracks(int face, int property) {
    const int named = color_face == GL_FRONT_AND_BACK || color_face == (face == 0 ? GL_FRONT : GL_BACK);
    const GLenum parameter = material_members[property].parameter;
    const int both = color_mode == GL_AMBIENT_AND_DIFFUSE && (property == M_AMBIENT || property == M_DIFFUSE);
    return on(GL_COLOR_MATERIAL) && named && (both || parameter == color_mode);
}

// The terms of a light that are not 0, on the faces that are lit.
static unsigned terms_of(int light, int faces, const struct drawn* d) {
    unsigned terms = 0;
    for (int i = AMBIENT; i <= SPECULAR; ++i)  // FF_AMBIENT, FF_DIFFUSE, FF_SPECULAR
        for (int face = 0; face < faces; ++face) {
            static const float white[3] = {1, 1, 1};
            const int property = M_AMBIENT + i - AMBIENT;
            const int varies = d->colors_vary && tracks(face, property);
            if (!is_black(light_value(light, i), varies ? white : material_value(face, property))) terms |= 1U << i;
        }
    return terms;
}

static void judge_light(struct judgement* j, int light, unsigned terms) {
    const unsigned has = ff_kinds[j->kind].lights[light];
    const float exponent = *light_value(light, SPOT_EXPONENT);
    const int what = LACKS_LIGHT + 6 * light, directional = light_value(light, POSITION)[3] == 0;
    if (!has) {
        miss(j, what, "GL_LIGHT%d shines", light);
        return;
    }
    if (terms & ~has) miss(j, what + 1, "a colour of GL_LIGHT%d times the material's is no longer black", light);
    if (directional != ((has & FF_DIRECTIONAL) != 0))
        miss(j, what + 2, directional ? "GL_LIGHT%d is directional" : "GL_LIGHT%d is positional", light);
    if (!directional && !(has & FF_ATTENUATED) &&
        (*light_value(light, CONSTANT) != 1 || *light_value(light, LINEAR) != 0 || *light_value(light, QUADRATIC) != 0))
        miss(j, what + 3, "GL_LIGHT%d has an attenuation", light);
    // A cone of 90 degrees without an exponent leaves nothing in the dark that faces the light.
    if (*light_value(light, SPOT_CUTOFF) == 180 || (*light_value(light, SPOT_CUTOFF) == 90 && exponent == 0)) return;
    if (!(has & FF_SPOT))
        miss(j, what + 4, "GL_LIGHT%d is a spotlight", light);
    else if ((exponent != 0 && !(has & FF_EXPONENT)) || (!is_whole(exponent) && !(has & FF_REAL_EXPONENT)))
        miss(j, what + 5, "GL_SPOT_EXPONENT of GL_LIGHT%d was 0 or a whole number, and no longer is", light);
}

static void judge_lighting(struct judgement* j, const struct drawn* d) {
    const struct ff_kind* kind = &ff_kinds[j->kind];
    const int is_polygon = d->mode >= GL_TRIANGLES;
    GLint culled = GL_BACK;
    if (glIsEnabled(GL_CULL_FACE)) glGetIntegerv(GL_CULL_FACE_MODE, &culled);
    const int shows_back = two_side && is_polygon && (!glIsEnabled(GL_CULL_FACE) || culled == GL_FRONT);
    const int faces = shows_back ? 2 : 1;
    unsigned all_terms = 0;
    if (shows_back != ((kind->features & FF_TWO_SIDE) != 0))
        miss(j, LACKS_TWO_SIDE,
             shows_back ? "GL_LIGHT_MODEL_TWO_SIDE is on" : "GL_LIGHT_MODEL_TWO_SIDE is off, or back faces are culled",
             0);
    for (int light = 0; light < FF_LIGHTS; ++light) {
        unsigned terms = light_is_on[light] ? terms_of(light, faces, d) : 0;
        if (kind->features & FF_LIGHTS_ALPHA) terms &= separate_specular ? (unsigned)FF_SPECULAR : 0;
        if (terms) judge_light(j, light, terms);
        all_terms |= terms;
    }
    if (all_terms & FF_SPECULAR) {
        int shines = 0, is_real = 0;
        for (int face = 0; face < faces; ++face) {
            shines |= *material_value(face, M_SHININESS) != 0;
            is_real |= !is_whole(*material_value(face, M_SHININESS));
        }
        if ((shines && !(kind->features & FF_SHININESS)) || (is_real && !(kind->features & FF_REAL_SHININESS)))
            miss(j, LACKS_SHININESS, "GL_SHININESS was 0 or a whole number, and no longer is", 0);
        if (shines && local_viewer != ((kind->features & FF_LOCAL_VIEWER) != 0))
            miss(j, LACKS_LOCAL_VIEWER,
                 local_viewer ? "GL_LIGHT_MODEL_LOCAL_VIEWER is on" : "GL_LIGHT_MODEL_LOCAL_VIEWER is off", 0);
        if (separate_specular != ((kind->features & FF_SEPARATE_SPECULAR) != 0))
            miss(j, LACKS_SEPARATE, "GL_LIGHT_MODEL_COLOR_CONTROL has another value", 0);
    }
    for (int face = 0; face < faces; ++face)
        for (int i = M_EMISSION; i <= M_SPECULAR; ++i) {
            const int has = kind->tracks >> (4 * face + i) & 1;
            const int is_used =
                i == M_EMISSION  ? !(kind->features & FF_LIGHTS_ALPHA)
                : i == M_AMBIENT ? !is_black(uniforms[SCENE_AMBIENT], uniforms[SCENE_AMBIENT]) || all_terms & FF_AMBIENT
                                 : i == M_DIFFUSE || all_terms & FF_SPECULAR;
            if (has ? !tracks(face, i) : d->colors_vary && tracks(face, i) && is_used)
                miss(j, LACKS_COLOR_MATERIAL, "glColorMaterial takes other colours of the material from the vertices",
                     0);
        }
}

static int keeps_w(const double* m) { return m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1; }

static void judge_texture(struct judgement* j, const struct drawn* d) {
    const struct ff_kind* kind = &ff_kinds[j->kind];
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const GLenum target = on(GL_TEXTURE_3D)   ? GL_TEXTURE_3D
                          : on(GL_TEXTURE_2D) ? GL_TEXTURE_2D
                          : on(GL_TEXTURE_1D) ? GL_TEXTURE_1D
                                              : 0;
    if (target != kind->texture) {
        miss(j, LACKS_TEXTURE, target ? "a texture of this target is on" : "no texture is on", 0);
        return;
    }
    if (!target) return;
    if (env_mode != kind->env_mode) miss(j, LACKS_ENV_MODE, "GL_TEXTURE_ENV_MODE has another value", 0);
    if (!(kind->features & FF_TEXTURE_MATRIX) && memcmp(top(2), identity, sizeof identity) != 0)
        miss(j, LACKS_TEXTURE_MATRIX, "the texture matrix is not the identity", 0);
    if ((d->has_q || !keeps_w(top(2))) && !(kind->features & FF_Q))
        miss(j, LACKS_Q, "a texture coordinate's q is not 1", 0);
    for (int i = 0; i < 4; ++i) {
        const GLenum mode = on(GL_TEXTURE_GEN_S + (GLenum)i) ? gen_mode[i] : 0;
        if (kind->generated[i] != 1 && mode != kind->generated[i])
            miss(j, LACKS_GENERATED, "glTexGen has another mode", 0);
    }
}

// How many things of the state the kind lacks. `says`: writes each to stderr, once.
static int judge(int number, const struct drawn* d, int says) {
    const struct ff_kind* kind = &ff_kinds[number];
    struct judgement j = {0, 0, 0, 0};
    const int has_w = d->has_w || !keeps_w(top(0));
    const GLenum fog = on(GL_FOG) && (fog_mode == GL_LINEAR || *uniforms[FOG_DENSITY] != 0) ? fog_mode : 0;
    const GLenum test = on(GL_ALPHA_TEST) ? alpha_func : GL_ALWAYS;
    j.kind = number;
    j.says = says;
    j.mode = d->mode;
    judge_texture(&j, d);
    if (!(kind->features & FF_ANY_COLOR)) {
        const int lit = (kind->features & FF_LIGHTING) != 0;
        if (on(GL_LIGHTING) != lit) miss(&j, LACKS_LIGHTING, lit ? "GL_LIGHTING is off" : "GL_LIGHTING is on", 0);
        if (on(GL_LIGHTING) && lit) judge_lighting(&j, d);
        const int flat = shade_model == GL_FLAT && d->mode != GL_POINTS;
        if (!(kind->features & FF_ANY_SHADE_MODEL) && flat != ((kind->features & FF_FLAT) != 0))
            miss(&j, LACKS_SHADE_MODEL, flat ? "glShadeModel is GL_FLAT" : "glShadeModel is GL_SMOOTH", 0);
    }
    if (!(kind->features & FF_ANY_NORMAL)) {
        const int rescales = on(GL_RESCALE_NORMAL) && !on(GL_NORMALIZE);
        if (on(GL_NORMALIZE) != ((kind->features & FF_NORMALIZE) != 0))
            miss(&j, LACKS_NORMALIZE, on(GL_NORMALIZE) ? "GL_NORMALIZE is on" : "GL_NORMALIZE is off", 0);
        if (rescales != ((kind->features & FF_RESCALE) != 0))
            miss(&j, LACKS_RESCALE, rescales ? "GL_RESCALE_NORMAL is on" : "GL_RESCALE_NORMAL is off", 0);
    }
    if (has_w && !(kind->features & (FF_W | FF_ANY_W))) miss(&j, LACKS_W, "a vertex's w is not 1", 0);
    if (fog != kind->fog) miss(&j, LACKS_FOG, fog ? "fog of this mode is on" : "fog is off", 0);
    if (test != kind->alpha_func) miss(&j, LACKS_ALPHA_TEST, "the alpha test has another function", 0);
    for (int i = 0; i < PLANES; ++i)
        if (plane_is_on[i] && !(kind->clip_planes >> i & 1)) miss(&j, LACKS_CLIP_PLANE, "GL_CLIP_PLANE%d is on", i);
    int taken = 0, given = 0;
    for (int i = 0; i < FF_ATTRIBUTES && kind->attributes[i]; ++i) {
        int known = -1;
        for (int a = 0; a < array_count; ++a)
            if (strcmp(arrays[a].name, kind->attributes[i]) == 0) known = a;
        taken += known < 0 || known >= NAMED_ARRAYS;
        given += known >= NAMED_ARRAYS && arrays[known].is_enabled;
    }
    for (int a = NAMED_ARRAYS; a < array_count; ++a) taken += arrays[a].is_enabled;
    if (taken != 2 * given) miss(&j, LACKS_ATTRIBUTE, "vertices have other materials of their own", 0);
    if (kind->features & FF_BY_NUMBER) miss(&j, LACKS_NUMBER, "", 0);
    return j.misses;
}

// The work of a kind's shaders, roughly.
static int size_of(int number) {
    int bits = 0;
    for (int light = 0; light < FF_LIGHTS; ++light)
        for (unsigned rest = ff_kinds[number].lights[light]; rest; rest >>= 1) bits += rest & 1;
    for (unsigned rest = ff_kinds[number].features; rest; rest >>= 1) bits += rest & 1;
    return bits;
}

// The smallest kind that fits, or else the one that lacks least.
static int choose(const struct drawn* d) {
    static struct drawn last;
    static unsigned chosen_at;
    static int chosen;
    if (wanted_kind > 0 && wanted_kind <= ff_kind_count) return wanted_kind - 1;
    // (The culled face is GL's own state, so its change goes unnoticed.)
    if (chosen_at == changes && !two_side && memcmp(&last, d, sizeof last) == 0) return chosen;
    int least = -1;
    for (int i = 0; i < ff_kind_count; ++i) {
        const int misses = judge(i, d, 0);
        if (least < 0 || misses < least || (misses == least && size_of(i) < size_of(chosen))) {
            least = misses;
            chosen = i;
        }
    }
    if (least > 0) judge(chosen, d, 1);
    last = *d;
    chosen_at = changes;
    return chosen;
}

// ---- Drawing ----

// A light that is off is black, and a plane that is off clips nothing. Without a cone, the exponent has no effect.
static const float* value_of(int uniform) {
    static const float zero[4] = {0, 0, 0, 0};
    const int light = (uniform - LIGHT) / PARAMETERS, parameter = (uniform - LIGHT) % PARAMETERS;
    if (uniform >= CLIP_PLANE && uniform < MATERIAL)
        return plane_is_on[uniform - CLIP_PLANE] ? uniforms[uniform] : zero;
    if (uniform < LIGHT) return uniforms[uniform];
    if (parameter <= SPECULAR && !light_is_on[light]) return zero;
    if (parameter == SPOT_EXPONENT && *light_value(light, SPOT_CUTOFF) == 180) return zero;
    return uniforms[uniform];
}

static int floats_of(int uniform) {
    if (uniform < MATERIAL) return other_members[uniform].floats;
    if (uniform < LIGHT) return material_members[(uniform - MATERIAL) % MATERIALS].floats;
    return light_members[(uniform - LIGHT) % PARAMETERS].floats;
}

static struct loaded* use(const struct drawn* d) {
    const int number = choose(d);
    struct loaded* kind = &loaded[number];
    glUseProgram(kind->program);
    for (int i = 0; i < UNIFORMS; ++i) {
        const GLint location = kind->locations[i];
        if (location < 0 || changed[i] <= kind->uploaded) continue;
        const float* value = value_of(i);
        switch (floats_of(i)) {
            case 1: glUniform1fv(location, 1, value); break;
            case 3: glUniform3fv(location, 1, value); break;
            case 4: glUniform4fv(location, 1, value); break;
            case 9: glUniformMatrix3fv(location, 1, GL_FALSE, value); break;
            default: glUniformMatrix4fv(location, 1, GL_FALSE, value); break;
        }
    }
    kind->uploaded = changes;
    // The shaders have one clip distance for each of their planes, without gaps.
    int planes = 0;
    for (unsigned rest = ff_kinds[number].clip_planes; rest; rest >>= 1) planes += rest & 1;
    for (int i = 0; i < PLANES; ++i) {
        if (i < planes)
            glEnable(GL_CLIP_DISTANCE0 + (GLenum)i);
        else
            glDisable(GL_CLIP_DISTANCE0 + (GLenum)i);
    }
    glBindVertexArray(vertex_array);
    return kind;
}

void ffUseProgram(void) {
    const struct drawn d = {GL_TRIANGLES, 0, 0, 0};
    use(&d);
}

// An offset in a buffer, as GL takes it.
static const char* offset_of(size_t bytes) { return (const char*)(uintptr_t)bytes; }

static void point_to(const struct loaded* kind, const struct array* from, int count) {
    const char* const* attributes = ff_kinds[kind - loaded].attributes;
    for (GLuint i = 0; i < FF_ATTRIBUTES; ++i) glDisableVertexAttribArray(i);
    for (int i = 0; i < FF_ATTRIBUTES && attributes[i]; ++i) {
        const GLint location = kind->attributes[i];
        if (location < 0) continue;
        for (int a = 0; a < count; ++a) {
            if (strcmp(from[a].name, attributes[i]) != 0) continue;
            if (!from[a].is_enabled) {
                if (a < NAMED_ARRAYS) glVertexAttrib4fv((GLuint)location, current[a]);
                continue;
            }
            glBindBuffer(GL_ARRAY_BUFFER, from[a].buffer);
            glEnableVertexAttribArray((GLuint)location);
            // Integers of colours and normals are fractions of their largest value (section 2.8).
            glVertexAttribPointer((GLuint)location, from[a].size, from[a].type, a == A_NORMAL || a == A_COLOR,
                                  from[a].stride, from[a].pointer);
        }
    }
}

// Core GL has no quadrilaterals and polygons. For flat shading the triangles keep GL's provoking vertex: a quadrilateral's last one, a
// polygon's first one (section 2.14.7). Returns how many indices it wrote.
static size_t triangles_of(GLenum mode, const GLuint* v, size_t count, GLuint* result) {
    size_t n = 0;
    static const int flat_quad[6] = {0, 1, 3, 1, 2, 3}, quad[6] = {0, 1, 2, 0, 2, 3}, strip[6] = {0, 1, 3, 2, 0, 3};
    const int* corners = mode == GL_QUAD_STRIP ? strip : shade_model == GL_FLAT ? flat_quad : quad;
    if (mode == GL_POLYGON) {
        for (size_t i = 1; i + 1 < count; ++i) {
            result[n++] = v[i];
            result[n++] = v[i + 1];
            result[n++] = v[0];
        }
    } else {
        for (size_t i = 0; i + 3 < count; i += mode == GL_QUADS ? 4 : 2)
            for (int corner = 0; corner < 6; ++corner) result[n++] = v[i + (size_t)corners[corner]];
    }
    return n;
}

static void draw_indices(GLenum mode, const GLuint* indices, size_t count) {
    GLuint* triangles = NULL;
    GLint buffer = 0;
    if (mode >= GL_QUADS) {
        triangles = (GLuint*)malloc((3 * count + 1) * sizeof *triangles);
        if (!triangles) return;
        count = triangles_of(mode, indices, count, triangles);
        mode = GL_TRIANGLES;
    }
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &buffer);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_stream);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof *indices), triangles ? triangles : indices,
                 GL_STREAM_DRAW);
    glDrawElements(mode, (GLsizei)count, GL_UNSIGNED_INT, NULL);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, (GLuint)buffer);
    free(triangles);
}

// Vertices `first` to first + count - 1, in order.
static void draw_in_order(GLenum mode, GLint first, GLsizei count) {
    if (mode < GL_QUADS) {
        glDrawArrays(mode, first, count);
        return;
    }
    GLuint* indices = (GLuint*)malloc((size_t)count * sizeof *indices);
    for (GLsizei i = 0; indices && i < count; ++i) indices[i] = (GLuint)(first + i);
    if (indices) draw_indices(mode, indices, (size_t)count);
    free(indices);
}

void ffBegin(GLenum mode) {
    begun = mode;
    is_begun = 1;
    vertex_count = 0;
}

void ffVertex4f(GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    if (vertex_count == vertex_room) {
        vertex_room = vertex_room ? 2 * vertex_room : 256;
        struct vertex* more = (struct vertex*)realloc(vertices, vertex_room * sizeof *vertices);
        if (!more) exit(EXIT_FAILURE);
        vertices = more;
    }
    struct vertex* vertex = &vertices[vertex_count++];
    memcpy(vertex->values, current, sizeof current);
    vertex->values[A_VERTEX][0] = x;
    vertex->values[A_VERTEX][1] = y;
    vertex->values[A_VERTEX][2] = z;
    vertex->values[A_VERTEX][3] = w;
}
void ffVertex3fv(const GLfloat* v) { ffVertex4f(v[0], v[1], v[2], 1); }
void ffVertex3dv(const GLdouble* v) { ffVertex4f((GLfloat)v[0], (GLfloat)v[1], (GLfloat)v[2], 1); }
void ffNormal3f(GLfloat x, GLfloat y, GLfloat z) {
    current[A_NORMAL][0] = x;
    current[A_NORMAL][1] = y;
    current[A_NORMAL][2] = z;
}
void ffNormal3fv(const GLfloat* v) { ffNormal3f(v[0], v[1], v[2]); }
void ffNormal3dv(const GLdouble* v) { ffNormal3f((GLfloat)v[0], (GLfloat)v[1], (GLfloat)v[2]); }
void ffColor4f(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    const float color[4] = {red, green, blue, alpha};
    memcpy(current[A_COLOR], color, sizeof color);
    if (on(GL_COLOR_MATERIAL)) set_material(color_face, color_mode, color);
}
void ffColor3fv(const GLfloat* v) { ffColor4f(v[0], v[1], v[2], 1); }
void ffColor4fv(const GLfloat* v) { ffColor4f(v[0], v[1], v[2], v[3]); }
void ffColor4ub(GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha) {
    ffColor4f((GLfloat)red / 255, (GLfloat)green / 255, (GLfloat)blue / 255, (GLfloat)alpha / 255);
}
void ffTexCoord4f(GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
    const float coord[4] = {s, t, r, q};
    memcpy(current[A_TEX_COORD], coord, sizeof coord);
}
void ffTexCoord2fv(const GLfloat* v) { ffTexCoord4f(v[0], v[1], 0, 1); }

void ffEnd(void) {
    struct drawn d = {GL_POINTS, 0, 0, 0};
    struct array from[NAMED_ARRAYS];
    is_begun = 0;
    d.mode = begun;
    if (vertex_count == 0) return;
    for (size_t i = 0; i < vertex_count; ++i) {
        float* color = vertices[i].values[A_COLOR];
        d.colors_vary |= memcmp(color, vertices[0].values[A_COLOR], sizeof vertices[0].values[A_COLOR]) != 0;
        d.has_w |= vertices[i].values[A_VERTEX][3] != 1;
        d.has_q |= vertices[i].values[A_TEX_COORD][3] != 1;
    }
    // Without lighting, colours are clamped here (section 2.14.6).
    for (size_t i = 0; !on(GL_LIGHTING) && i < vertex_count; ++i)
        for (int c = 0; c < 4; ++c) {
            float* channel = &vertices[i].values[A_COLOR][c];
            *channel = *channel < 0 ? 0 : *channel > 1 ? 1 : *channel;
        }
    for (int a = 0; a < NAMED_ARRAYS; ++a) {
        from[a] = arrays[a];
        from[a].is_enabled = 1;
        from[a].size = a == A_NORMAL ? 3 : 4;
        from[a].type = GL_FLOAT;
        from[a].stride = sizeof *vertices;
        from[a].pointer = offset_of((size_t)a * sizeof *current);
        from[a].buffer = stream;
    }
    const struct loaded* kind = use(&d);
    glBindBuffer(GL_ARRAY_BUFFER, stream);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(vertex_count * sizeof *vertices), vertices, GL_STREAM_DRAW);
    point_to(kind, from, NAMED_ARRAYS);
    draw_in_order(begun, 0, (GLsizei)vertex_count);
}

// ---- Arrays (section 2.8) ----

static struct array* array_of(GLenum name) {
    switch (name) {
        case GL_VERTEX_ARRAY: return &arrays[A_VERTEX];
        case GL_NORMAL_ARRAY: return &arrays[A_NORMAL];
        case GL_COLOR_ARRAY: return &arrays[A_COLOR];
        case GL_TEXTURE_COORD_ARRAY: return &arrays[A_TEX_COORD];
        default: return NULL;
    }
}
static void enable_array(GLenum name, int value) {
    struct array* array = array_of(name);
    if (!array || array->is_enabled == value) return;
    array->is_enabled = value;
    ++changes;
}
void ffEnableClientState(GLenum array) { enable_array(array, 1); }
void ffDisableClientState(GLenum array) { enable_array(array, 0); }

static GLsizei bytes_of(GLenum type) {
    return type == GL_DOUBLE                               ? 8
           : type == GL_SHORT || type == GL_UNSIGNED_SHORT ? 2
           : type == GL_BYTE || type == GL_UNSIGNED_BYTE   ? 1
                                                           : 4;
}
static void set_array(struct array* array, GLint size, GLenum type, GLsizei stride, const void* pointer) {
    GLint buffer = 0;
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &buffer);
    array->size = size;
    array->type = type;
    array->stride = stride ? stride : size * bytes_of(type);
    array->pointer = (const char*)pointer;
    array->buffer = (GLuint)buffer;
}
void ffVertexPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    set_array(&arrays[A_VERTEX], size, type, stride, pointer);
}
void ffNormalPointer(GLenum type, GLsizei stride, const void* pointer) {
    set_array(&arrays[A_NORMAL], 3, type, stride, pointer);
}
void ffColorPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    set_array(&arrays[A_COLOR], size, type, stride, pointer);
}
void ffTexCoordPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    set_array(&arrays[A_TEX_COORD], size, type, stride, pointer);
}
void ffAttributePointer(const char* attribute, GLint size, GLsizei stride, const void* pointer) {
    int a = 0;
    while (a < array_count && strcmp(arrays[a].name, attribute) != 0) ++a;
    if (a == FF_ATTRIBUTES) return;
    if (a == array_count) {
        ++array_count;
        arrays[a].name = attribute;
    }
    if (arrays[a].is_enabled != (size > 0)) ++changes;
    arrays[a].is_enabled = size > 0;
    set_array(&arrays[a], size, GL_FLOAT, stride, pointer);
}

// Arrays in memory go to a buffer, one after the other; `end`: the number of vertices.
static void upload(struct array* from, size_t end) {
    size_t size = 0;
    for (int pass = 0; pass < 2; ++pass) {
        if (pass == 1) {
            if (size == 0) return;
            glBindBuffer(GL_ARRAY_BUFFER, stream);
            glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, NULL, GL_STREAM_DRAW);
            size = 0;
        }
        for (int a = 0; a < array_count; ++a) {
            if (!from[a].is_enabled || arrays[a].buffer) continue;
            const size_t bytes = (end - 1) * (size_t)from[a].stride + (size_t)(from[a].size * bytes_of(from[a].type));
            if (pass == 1) {
                glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)size, (GLsizeiptr)bytes, from[a].pointer);
                from[a].pointer = offset_of(size);
                from[a].buffer = stream;
            }
            size += (bytes + 7) / 8 * 8;
        }
    }
}

// `end`: one more than the largest index.
static void use_arrays(GLenum mode, size_t end) {
    struct array from[FF_ATTRIBUTES];
    struct drawn d = {GL_POINTS, 0, 0, 0};
    d.mode = mode;
    d.colors_vary = arrays[A_COLOR].is_enabled;
    d.has_w = arrays[A_VERTEX].size == 4;
    d.has_q = arrays[A_TEX_COORD].is_enabled && arrays[A_TEX_COORD].size == 4;
    const struct loaded* kind = use(&d);
    memcpy(from, arrays, sizeof from);
    upload(from, end);
    point_to(kind, from, array_count);
}

void ffDrawArrays(GLenum mode, GLint first, GLsizei count) {
    if (count <= 0) return;
    use_arrays(mode, (size_t)(first + count));
    draw_in_order(mode, first, count);
}

void ffDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    const size_t size = (size_t)bytes_of(type);
    size_t end = 0;
    GLint buffer = 0;
    int is_in_memory = mode >= GL_QUADS;
    if (count <= 0) return;
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &buffer);
    for (int a = 0; a < array_count; ++a) is_in_memory |= arrays[a].is_enabled && arrays[a].buffer == 0;
    if (buffer && !is_in_memory) {
        use_arrays(mode, 1);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, (GLuint)buffer);
        glDrawElements(mode, count, type, indices);
        return;
    }
    GLuint* whole = (GLuint*)malloc((size_t)count * sizeof *whole);
    char* copy = (char*)malloc((size_t)count * size);
    if (whole && copy) {
        if (buffer)
            glGetBufferSubData(GL_ELEMENT_ARRAY_BUFFER, (GLintptr)(uintptr_t)indices,
                               (GLsizeiptr)((size_t)count * size), copy);
        else
            memcpy(copy, indices, (size_t)count * size);
        for (GLsizei i = 0; i < count; ++i) {
            GLushort two = 0;
            memcpy(size == 4 ? (void*)&whole[i] : (void*)&two, copy + (size_t)i * size, size);
            if (size < 4) whole[i] = size == 1 ? (GLubyte)copy[i] : two;
            if (whole[i] >= end) end = (size_t)whole[i] + 1;
        }
        use_arrays(mode, end);
        if (buffer) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, (GLuint)buffer);
        draw_indices(mode, whole, (size_t)count);
    }
    free(whole);
    free(copy);
}
