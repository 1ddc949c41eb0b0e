// Draws scene.c with the shaders beside it, in a core profile. README.md has the command that compiles it.
//
//   ./scene                      a window: drag to turn, 1 to 8 switch lights
//   ./scene -o picture.ppm       writes the picture instead
//   ./scene --turn DEGREES       turns the camera around the scene's middle
//   ./scene --light N X Y Z      moves light N, in the eye coordinates of the scene's own camera
#include "loader.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_ATTRIBUTES 16
#define MOST_LIGHTS 16

struct kind {
    GLuint program;
    int attribute_count;
    struct attribute attributes[MOST_ATTRIBUTES];
};

static struct kind *kinds, *kind;
static GLuint* textures;
static char* data;  // scene.bin
static double camera[16];
static double turn_deg, tilt_deg;
static float light_shift[MOST_LIGHTS][3];
static int light_is_off[MOST_LIGHTS];
static const char* picture_file;

static void fail(const char* what, const char* why) {
    fprintf(stderr, "%s: %s\n", what, why);
    exit(1);
}

static char* read_whole(const char* name, size_t* size) {
    FILE* file = fopen(name, "rb");
    if (!file) fail(name, "cannot be opened; start the program in its own folder");
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char* text = calloc(*size + 1, 1);
    if (!text || fread(text, 1, *size, file) != *size) fail(name, "cannot be read");
    fclose(file);
    return text;
}

// ---- Programs and textures ----

static void attach(GLuint program, GLenum type, int number, const char* ending) {
    char name[64];
    size_t size;
    snprintf(name, sizeof name, "kind%d.%s", number, ending);
    char* text = read_whole(name, &size);
    const GLuint shader = glCreateShader(type);
    glShaderSource(shader, 1, (const char* const*)&text, NULL);
    glCompileShader(shader);
    GLint compiled;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    char log[4096] = "";
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    if (!compiled) fail(name, log);
    glAttachShader(program, shader);
    free(text);
}

void load_kind(int number, int attribute_count, const struct attribute* attributes) {
    struct kind* loaded = &kinds[number];
    loaded->program = glCreateProgram();
    loaded->attribute_count = attribute_count;
    memcpy(loaded->attributes, attributes, (size_t)attribute_count * sizeof *attributes);
    attach(loaded->program, GL_VERTEX_SHADER, number, "vert");
    attach(loaded->program, GL_FRAGMENT_SHADER, number, "frag");
    for (int i = 0; i < attribute_count; ++i) glBindAttribLocation(loaded->program, (GLuint)i, attributes[i].name);
    glLinkProgram(loaded->program);
    GLint linked;
    glGetProgramiv(loaded->program, GL_LINK_STATUS, &linked);
    char log[4096] = "";
    glGetProgramInfoLog(loaded->program, sizeof log, NULL, log);
    if (!linked) fail("a program", log);
}

void load_texture(int number, struct texture t) {
    glGenTextures(1, &textures[number]);
    glBindTexture(t.target, textures[number]);
    glTexParameteri(t.target, GL_TEXTURE_MIN_FILTER, (GLint)t.min_filter);
    glTexParameteri(t.target, GL_TEXTURE_MAG_FILTER, (GLint)t.mag_filter);
    glTexParameteri(t.target, GL_TEXTURE_WRAP_S, (GLint)t.wrap_s);
    glTexParameteri(t.target, GL_TEXTURE_WRAP_T, (GLint)t.wrap_t);
    glTexParameteri(t.target, GL_TEXTURE_WRAP_R, (GLint)t.wrap_r);
    glTexParameteri(t.target, GL_TEXTURE_MAX_LEVEL, t.level_count - 1);
    glTexParameterfv(t.target, GL_TEXTURE_BORDER_COLOR, t.border_color);
    if (t.compare_func) {
        glTexParameteri(t.target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
        glTexParameteri(t.target, GL_TEXTURE_COMPARE_FUNC, (GLint)t.compare_func);
    }
    const GLint format = t.has_depths ? GL_DEPTH_COMPONENT24 : GL_RGBA8;
    const GLenum texel = t.has_depths ? GL_DEPTH_COMPONENT : GL_RGBA,
                 type = t.has_depths ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE;
    for (int i = 0; i < t.level_count; ++i) {
        const struct image level = t.levels[i];
        const char* texels = data + 4L * level.first_texel;
        if (t.target == GL_TEXTURE_1D)
            glTexImage1D(t.target, i, format, level.width, 0, texel, type, texels);
        else if (t.target == GL_TEXTURE_3D)
            glTexImage3D(t.target, i, GL_RGBA8, level.width, level.height, level.depth, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texels);
        else
            glTexImage2D(t.target, i, format, level.width, level.height, 0, texel, type, texels);
    }
}

// ---- Matrices, column by column ----

static void multiply(double* result, const double* a, const double* b) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            result[4 * column + row] = 0;
            for (int i = 0; i < 4; ++i) result[4 * column + row] += a[4 * i + row] * b[4 * column + i];
        }
}

// Turns around the scene's middle: first by turn_deg around the vertical axis, then by tilt_deg around the horizontal
// one.
static void set_camera(void) {
    const double radian = 3.14159265358979323846 / 180;
    const double s = sin(turn_deg * radian), c = cos(turn_deg * radian);
    const double sx = sin(tilt_deg * radian), cx = cos(tilt_deg * radian);
    const double turned[16] = {c, sx * s, -cx * s, 0, 0, cx, sx, 0, s, -sx * c, cx * c, 0, 0, 0, 0, 1};
    memcpy(camera, turned, sizeof turned);
    for (int row = 0; row < 3; ++row) {
        camera[12 + row] = scene_middle[row];
        for (int i = 0; i < 3; ++i) camera[12 + row] -= turned[4 * i + row] * scene_middle[i];
    }
}

// ---- Uniforms of the kind in use ----

static GLint at(const char* name) { return glGetUniformLocation(kind->program, name); }

static void set_matrix(const char* name, const double* m) {
    float values[16];
    for (int i = 0; i < 16; ++i) values[i] = (float)m[i];
    glUniformMatrix4fv(at(name), 1, GL_FALSE, values);
}

void use_kind(int number) {
    kind = &kinds[number];
    glUseProgram(kind->program);
}

void number(const char* uniform, float value) { glUniform1f(at(uniform), value); }

void matrices(const float* model_view, const float* projection) {
    double m[16], p[16], moved[16], product[16];
    for (int i = 0; i < 16; ++i) {
        m[i] = model_view[i];
        p[i] = projection[i];
    }
    multiply(moved, camera, m);
    multiply(product, p, moved);
    set_matrix("ModelViewMatrix", moved);
    set_matrix("ModelViewProjectionMatrix", product);

    // The transposed inverse: cross products of two columns, divided by the determinant. A singular matrix gives 0.
    double normal[9], determinant = 0;
    for (int column = 0; column < 3; ++column) {
        const double *a = &moved[4 * ((column + 1) % 3)], *b = &moved[4 * ((column + 2) % 3)];
        for (int i = 0; i < 3; ++i)
            normal[3 * column + i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
    for (int i = 0; i < 3; ++i) determinant += moved[i] * normal[i];
    float values[9];
    for (int i = 0; i < 9; ++i) values[i] = determinant == 0 ? 0 : (float)(normal[i] / determinant);
    glUniformMatrix3fv(at("NormalMatrix"), 1, GL_FALSE, values);
    const float length = sqrtf(values[6] * values[6] + values[7] * values[7] + values[8] * values[8]);
    number("NormalScale", length > 0 ? 1 / length : 1);
}

static GLint member(const char* structure, const char* name) {
    char whole[64];
    snprintf(whole, sizeof whole, "%s.%s", structure, name);
    return at(whole);
}

static void set_material(const char* face, const struct material* m) {
    glUniform4fv(member(face, "emission"), 1, m->emission);
    glUniform4fv(member(face, "ambient"), 1, m->ambient);
    glUniform4fv(member(face, "diffuse"), 1, m->diffuse);
    glUniform4fv(member(face, "specular"), 1, m->specular);
    glUniform1f(member(face, "shininess"), m->shininess);
}
void front_material(struct material material) { set_material("FrontMaterial", &material); }
void back_material(struct material material) { set_material("BackMaterial", &material); }

void light_model_ambient(const float* color) { glUniform4fv(at("LightModel.ambient"), 1, color); }

void light(int number, struct light l) {
    char source[32];
    snprintf(source, sizeof source, "LightSource[%d]", number);
    if (light_is_off[number]) memset(&l, 0, 12 * sizeof(float));  // its three colours
    float position[4] = {0, 0, 0, l.position[3]}, spot[3] = {0, 0, 0};
    for (int row = 0; row < 3; ++row) {
        for (int i = 0; i < 3; ++i) {
            position[row] += (float)(camera[4 * i + row] * (l.position[i] + light_shift[number][i]));
            spot[row] += (float)(camera[4 * i + row] * l.spot_direction[i]);
        }
        position[row] += (float)(camera[12 + row] * l.position[3]);
    }
    glUniform4fv(member(source, "ambient"), 1, l.ambient);
    glUniform4fv(member(source, "diffuse"), 1, l.diffuse);
    glUniform4fv(member(source, "specular"), 1, l.specular);
    glUniform4fv(member(source, "position"), 1, position);
    glUniform3fv(member(source, "spotDirection"), 1, spot);
    glUniform1f(member(source, "spotExponent"), l.spot_exponent);
    glUniform1f(member(source, "spotCutoff"), l.spot_cutoff);
    glUniform1f(member(source, "spotCosCutoff"), (float)cos(l.spot_cutoff * 3.14159265358979323846 / 180));
    glUniform1f(member(source, "constantAttenuation"), l.attenuation[0]);
    glUniform1f(member(source, "linearAttenuation"), l.attenuation[1]);
    glUniform1f(member(source, "quadraticAttenuation"), l.attenuation[2]);

    // Halfway between the light's direction and the viewer at infinity, (0, 0, 1).
    const float size = sqrtf(position[0] * position[0] + position[1] * position[1] + position[2] * position[2]);
    float half[4] = {position[0], position[1], position[2] + size, 0};
    const float half_size = sqrtf(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
    for (int i = 0; half_size > 0 && i < 3; ++i) half[i] /= half_size;
    glUniform4fv(member(source, "halfVector"), 1, half);
}

void fog(const float* color, float density, float start, float end) {
    glUniform4fv(at("Fog.color"), 1, color);
    number("Fog.density", density);
    number("Fog.start", start);
    number("Fog.end", end);
    number("Fog.scale", end == start ? 1e30f : 1 / (end - start));
}

// A plane is a row: it is multiplied by the inverse of the camera's matrix, which only turns and moves.
static void set_moved_plane(const char* name, const float* plane) {
    float moved[4] = {0, 0, 0, plane[3]};
    for (int row = 0; row < 3; ++row) {
        for (int i = 0; i < 3; ++i) moved[row] += (float)(camera[4 * i + row] * plane[i]);
        moved[3] -= moved[row] * (float)camera[12 + row];
    }
    glUniform4fv(at(name), 1, moved);
}
void clip_plane(int number, const float* plane) {
    char name[32];
    snprintf(name, sizeof name, "ClipPlane[%d]", number);
    set_moved_plane(name, plane);
}

void use_texture(GLenum target, int texture, float lod_bias) {
    glBindTexture(target, textures[texture]);
    glTexParameterf(target, GL_TEXTURE_LOD_BIAS, lod_bias);
}
void texture_matrix(const float* matrix) { glUniformMatrix4fv(at("TextureMatrix[0]"), 1, GL_FALSE, matrix); }
void texture_env_color(const float* color) { glUniform4fv(at("TextureEnvColor[0]"), 1, color); }
void object_plane(const char* uniform, const float* plane) { glUniform4fv(at(uniform), 1, plane); }
void eye_plane(const char* uniform, const float* plane) { set_moved_plane(uniform, plane); }

void draw(GLenum mode, int first_vertex, int first_index, int index_count) {
    int stride = 0, offset = 0;
    for (int i = 0; i < kind->attribute_count; ++i) stride += 4 * kind->attributes[i].floats;
    for (int i = 0; i < kind->attribute_count; ++i) {
        const char* place = (const char*)NULL + 4L * first_vertex + offset;
        glEnableVertexAttribArray((GLuint)i);
        glVertexAttribPointer((GLuint)i, kind->attributes[i].floats, GL_FLOAT, GL_FALSE, stride, place);
        offset += 4 * kind->attributes[i].floats;
    }
    for (int i = kind->attribute_count; i < MOST_ATTRIBUTES; ++i) glDisableVertexAttribArray((GLuint)i);
    glDrawElements(mode, index_count, GL_UNSIGNED_INT, (const char*)NULL + 4L * first_index);
}

// ---- The window ----

static void display(void) {
    set_camera();
    draw_scene();
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) fprintf(stderr, "GL error 0x%x\n", (unsigned)error);
    if (!picture_file) {
        glutSwapBuffers();
        return;
    }
    char* pixels = malloc((size_t)scene_width * (size_t)scene_height * 3);
    FILE* file = fopen(picture_file, "wb");
    if (!pixels || !file) fail(picture_file, "cannot be written");
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, scene_width, scene_height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    fprintf(file, "P6 %d %d 255\n", scene_width, scene_height);
    for (int y = scene_height - 1; y >= 0; --y)
        fwrite(pixels + (size_t)y * (size_t)scene_width * 3, 3, (size_t)scene_width, file);
    if (fclose(file) != 0) fail(picture_file, "cannot be written");
    exit(error == GL_NO_ERROR ? 0 : 1);
}

static int drag_x, drag_y;
static void press(int button, int state, int x, int y) {
    (void)button, (void)state;
    drag_x = x;
    drag_y = y;
}
static void drag(int x, int y) {
    turn_deg += 0.5 * (x - drag_x);
    tilt_deg += 0.5 * (y - drag_y);
    press(0, 0, x, y);
    glutPostRedisplay();
}
static void key(unsigned char c, int x, int y) {
    (void)x, (void)y;
    if (c >= '1' && c <= '8') light_is_off[c - '1'] = !light_is_off[c - '1'];
    if (c == 27) exit(0);
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        if (i + 1 < argc && strcmp(argv[i], "-o") == 0) {
            picture_file = argv[++i];
        } else if (i + 1 < argc && strcmp(argv[i], "--turn") == 0) {
            turn_deg = atof(argv[++i]);
        } else if (i + 4 < argc && strcmp(argv[i], "--light") == 0) {
            const int light_number = atoi(argv[++i]);
            if (light_number < 0 || light_number >= MOST_LIGHTS) fail("--light", "there is no such light");
            for (int row = 0; row < 3; ++row) light_shift[light_number][row] = (float)atof(argv[++i]);
        } else {
            fail(argv[i], "unknown; the options are -o FILE, --turn DEGREES, --light N X Y Z");
        }
    }
    glutInitContextVersion(scene_gl_version[0], scene_gl_version[1]);
    if (scene_has_core_profile) glutInitContextProfile(GLUT_CORE_PROFILE);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL);
    glutInitWindowSize(scene_width, scene_height);
    glutCreateWindow("scene");

    kinds = calloc((size_t)scene_kind_count + 1, sizeof *kinds);
    textures = calloc((size_t)scene_texture_count + 1, sizeof *textures);
    if (!kinds || !textures) fail("scene", "there is not enough memory");
    size_t size;
    data = read_whole("scene.bin", &size);
    GLuint array, buffer;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, data, GL_STATIC_DRAW);
    glDisable(GL_DITHER);
    load_scene();

    glutDisplayFunc(display);
    glutMouseFunc(press);
    glutMotionFunc(drag);
    glutKeyboardFunc(key);
    glutMainLoop();
}
