// A window, in a core profile, that shows scene.c with the shaders beside it. README.md has the command that compiles it.
//
//   ./scene                      a window: drag to turn, 1 to 8 switch lights; several frames play, and space stops them
//   ./scene -o picture.ppm       writes the picture instead
//   ./scene --frame N            stops at this frame of the recording
//   ./scene --turn DEGREES       turns the camera around the scene's middle
//   ./scene --light N X Y Z      moves light N, in the eye coordinates of the scene's own camera
#define GL_GLEXT_PROTOTYPES
#include <GL/freeglut.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gl_state.h"
#include "scene.h"

static GLuint* textures;
static char* data;  // scene.bin
static GLuint buffer;
static double turn_deg, tilt_deg;
static float light_shift[FF_LIGHTS][3];
static int light_is_off[FF_LIGHTS];
static const char* picture_file;
static int frame, is_playing = 1;
const float* frame_values;
int frame_index;

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

// ---- Textures ----

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

void use_texture(GLenum target, int texture, float lod_bias) {
    glBindTexture(target, textures[texture]);
    glTexParameterf(target, GL_TEXTURE_LOD_BIAS, lod_bias);
}

// ---- The camera and the lights ----

// Turns around the scene's middle: first by turn_deg around the vertical axis, then by tilt_deg around the horizontal
// one.
void camera(void) {
    ffLoadIdentity();
    if (turn_deg == 0 && tilt_deg == 0) return;
    ffTranslatef(scene_middle[0], scene_middle[1], scene_middle[2]);
    ffRotatef(tilt_deg, 1, 0, 0);
    ffRotatef(turn_deg, 0, 1, 0);
    ffTranslatef(-scene_middle[0], -scene_middle[1], -scene_middle[2]);
}

void place_light(GLenum light, float x, float y, float z, float w) {
    const float* shift = light_shift[light - GL_LIGHT0];
    const float position[4] = {x + shift[0], y + shift[1], z + shift[2], w};
    ffLightfv(light, GL_POSITION, position);
}

void switch_light(GLenum light, int is_on) {
    if (is_on && !light_is_off[light - GL_LIGHT0])
        ffEnable(light);
    else
        ffDisable(light);
}

void set_uniform(int kind, const char* uniform, float value) {
    const GLuint program = ffProgramOfKind(kind);
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, uniform), value);
}

// ---- Draws ----

static const char* data_offset(long bytes) { return (const char*)(intptr_t)bytes; }

static void point_to(const struct attribute* one, int size, int stride, const void* pointer) {
    const GLenum names[] = {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY};
    const char* const attributes[] = {"Vertex", "Normal", "Color", "MultiTexCoord0"};
    int i = 0;
    while (i < 4 && strcmp(one->name, attributes[i]) != 0) ++i;
    if (i < 4 && size > 0)
        ffEnableClientState(names[i]);
    else if (i < 4)
        ffDisableClientState(names[i]);
    if (i == 4)
        ffAttributePointer(one->name, size, stride, pointer);
    else if (size == 0)
        return;
    else if (i == 0)
        ffVertexPointer(size, GL_FLOAT, stride, pointer);
    else if (i == 1)
        ffNormalPointer(GL_FLOAT, stride, pointer);
    else if (i == 2)
        ffColorPointer(size, GL_FLOAT, stride, pointer);
    else
        ffTexCoordPointer(size, GL_FLOAT, stride, pointer);
}

void draw(struct mesh mesh) {
    const struct attribute* layout = mesh.layout;
    int stride = 0, offset = 0;
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    for (int i = 0; layout[i].name; ++i) stride += 4 * layout[i].room;
    for (int i = 0; layout[i].name; ++i) {
        point_to(&layout[i], layout[i].floats, stride, data_offset(4L * mesh.first_vertex + offset));
        offset += 4 * layout[i].room;
    }
    ffDrawElements(mesh.mode, mesh.index_count, GL_UNSIGNED_INT, data_offset(4L * mesh.first_index));
    for (int i = 0; layout[i].name; ++i) point_to(&layout[i], 0, 0, NULL);
}

// ---- The window ----

static void draw_frame(void) {
    frame_values = (const float*)(const void*)(data + 4L * scene_frames[frame].first_value);
    frame_index = scene_frames[frame].index;
    scene_frames[frame].draw();
}

static void display(void) {
    draw_frame();
    if (picture_file) draw_frame();  // as in a window, where each picture begins with the state that the last one left
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
    if (c == ' ') is_playing = !is_playing;
    if (c == 27) exit(0);
    glutPostRedisplay();
}

static void next_frame(int milliseconds) {
    if (is_playing) {
        frame = (frame + 1) % scene_frame_count;
        glutPostRedisplay();
    }
    glutTimerFunc((unsigned)milliseconds, next_frame, milliseconds);
}

static void stop_at(int number) {
    for (frame = 0; frame < scene_frame_count; ++frame)
        if (scene_frames[frame].number == number) break;
    if (frame == scene_frame_count) fail("--frame", "there is no such frame");
    is_playing = 0;
}

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        if (i + 1 < argc && strcmp(argv[i], "-o") == 0) {
            picture_file = argv[++i];
        } else if (i + 1 < argc && strcmp(argv[i], "--frame") == 0) {
            stop_at(atoi(argv[++i]));
        } else if (i + 1 < argc && strcmp(argv[i], "--turn") == 0) {
            turn_deg = atof(argv[++i]);
        } else if (i + 4 < argc && strcmp(argv[i], "--light") == 0) {
            const int light_number = atoi(argv[++i]);
            if (light_number < 0 || light_number >= FF_LIGHTS) fail("--light", "there is no such light");
            for (int row = 0; row < 3; ++row) light_shift[light_number][row] = (float)atof(argv[++i]);
        } else {
            fail(argv[i], "unknown; the options are -o FILE, --frame N, --turn DEGREES, --light N X Y Z");
        }
    }
    glutInitContextVersion(scene_gl_version[0], scene_gl_version[1]);
    if (scene_has_core_profile) glutInitContextProfile(GLUT_CORE_PROFILE);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL);
    glutInitWindowSize(scene_width, scene_height);
    glutCreateWindow("scene");

    textures = calloc((size_t)scene_texture_count + 1, sizeof *textures);
    if (!textures) fail("scene", "there is not enough memory");
    if (!ffInit(".")) return 1;
    size_t size;
    data = read_whole("scene.bin", &size);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, data, GL_STATIC_DRAW);
    glDisable(GL_DITHER);
    load_scene();

    glutDisplayFunc(display);
    glutMouseFunc(press);
    glutMotionFunc(drag);
    glutKeyboardFunc(key);
    if (scene_frame_count > 1 && !picture_file) glutTimerFunc(40, next_frame, 40);
    glutMainLoop();
}
