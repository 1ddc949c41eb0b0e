/* Draws the cases, reads what GL shows, and compares: one line for each. Exit status: 0 right, 1 wrong, 77 could not run.

       PROGRAM [--pixel] [--after NAME] [NAME ...]

   Colours of vertices are read in feedback mode (section 5.3), without the clamp to [0, 1] if GL can; with --pixel, or where feedback
   does not work, from a pixel of 8 bits. */
#include "hard_case.h"

#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "window.h"

/* Half a step of an 8-bit channel: section 2.14.9 rounds to the nearest. */
#define HALF_CODE (0.5 / 255)
/* Pixels across a picture of vertices: small, so that those at (-0.75, -0.75) lie at a pixel's centre. */
#define VERTEX_SIDE 12

/* ---- What to draw, and how it went ---- */

static int first_name, argument_count; /* the names among the arguments */
static char** arguments;
static int wants_pixels, wants_after;
static const char* after;

static int number;                      /* of the next case */
static const struct hard_case* current; /* while it is drawn */
static int wrong_cases, cases_not_run, is_over, says_gl = 1;

static int result(void) { return wrong_cases ? 1 : cases_not_run ? 77 : 0; }

static int status(void) {
    is_over = 1;
    fflush(stdout);
    return result();
}

/* A library that ends the program (GLUT without a display, Xlib after an error) has found no bug. */
static void at_exit(void) {
    if (is_over) return;
    printf("%s: not run: a library ended the program\n", current ? current->name : "all");
    fflush(stdout);
    _Exit(77);
}

void not_run(const char* why) {
    printf("%s: not run: %s\n", current ? current->name : hard_cases[1] ? "all" : hard_cases[0]->name, why);
    is_over = 1;
    fflush(stdout);
    exit(77);
}

static int is_wanted(const struct hard_case* of) {
    int i;
    if (wants_after) {
        wants_after = strcmp(of->name, after) != 0;
        return 0;
    }
    for (i = first_name; i < argument_count; ++i)
        if (strcmp(arguments[i], of->name) == 0) return 1;
    return first_name == argument_count;
}

static const struct hard_case* next_case(void) {
    while (hard_cases[number])
        if (is_wanted(hard_cases[number++])) return hard_cases[number - 1];
    return 0;
}

/* ---- GL ---- */

/* 21 for 2.1; 0 for OpenGL ES and other names. */
static int gl_version(void) {
    const char* text = (const char*)glGetString(GL_VERSION);
    int major, minor;
    return text && sscanf(text, "%d.%d", &major, &minor) == 2 ? 10 * major + minor : 0;
}

static int has_extension(const char* name) {
    const char* extensions = (const char*)glGetString(GL_EXTENSIONS);
    const size_t length = strlen(name);
    const char* at = extensions;
    while (at && (at = strstr(at, name)) != 0) {
        if (at[length] == ' ' || at[length] == 0) return 1;
        at += length;
    }
    return 0;
}

/* Why the case that is drawn cannot be finished. */
static char refusal[100];
static jmp_buf unfinished;

void (*later_function(const char* name, int version, const char* extension))(void) {
    void (*found)(void) = 0;
    if (gl_version() >= version || (extension && has_extension(extension))) found = window_function(name);
    if (found) return found;
    sprintf(refusal, "this GL has no %s (OpenGL %d.%d)", name, version / 10, version % 10);
    longjmp(unfinished, 1);
}

static GLenum gl_error(void) {
    const GLenum first = glGetError();
    int i;
    for (i = 0; i < 100 && glGetError() != GL_NO_ERROR; ++i) {
    }
    return first;
}

static int near_to(double value, double right, double tolerance) { return fabs(value - right) <= tolerance; }

/* A point where most cases have theirs, without lighting. */
static void draw_plain_point(void) {
    glColor3f(0.2f, 0.4f, 0.6f);
    glBegin(GL_POINTS);
    glVertex3f(-0.75f, -0.75f, 0);
    glEnd();
    glColor4f(1, 1, 1, 1);
}

/* ---- Colours of vertices: feedback ---- */

#ifdef NO_FEEDBACK /* for a GL that cannot be linked with it */
static int feedback_works(void) { return 0; }
static int feedback_of(const struct hard_case* of, float* buffer) { return (void)of, (void)buffer, 0; }
static int is_unclamped;
#else
#define MOST_FLOATS 512
static int is_unclamped; /* the colours of vertices in feedback */

static int feedback_works(void) {
    static float buffer[MOST_FLOATS];
    glViewport(0, 0, SIDE, SIDE);
    glFeedbackBuffer(MOST_FLOATS, GL_3D_COLOR, buffer);
    glRenderMode(GL_FEEDBACK);
    draw_plain_point();
    return glRenderMode(GL_RENDER) == 8 && buffer[0] == GL_POINT_TOKEN && near_to(buffer[1], 0.125 * SIDE, 0.5) &&
           near_to(buffer[2], 0.125 * SIDE, 0.5) && near_to(buffer[4], 0.2, 1e-5) && near_to(buffer[5], 0.4, 1e-5) &&
           near_to(buffer[6], 0.6, 1e-5) && gl_error() == GL_NO_ERROR;
}

/* The number of floats, or -1. */
static int feedback_of(const struct hard_case* of, float* buffer) {
    if (has_extension("GL_ARB_color_buffer_float")) {
        void (*const clamp)(void) = window_function("glClampColorARB");
        if (clamp) ((void(APIENTRY*)(GLenum, GLenum))clamp)(GL_CLAMP_VERTEX_COLOR_ARB, GL_FALSE);
        is_unclamped = clamp && gl_error() == GL_NO_ERROR;
    }
    glViewport(0, 0, SIDE, SIDE); /* a window manager may make the window larger */
    glFeedbackBuffer(MOST_FLOATS, GL_3D_COLOR, buffer);
    glRenderMode(GL_FEEDBACK);
    of->draw();
    return glRenderMode(GL_RENDER);
}
#endif

/* The colour of the last vertex at a place in the window; 0 if there is none. */
static const float* vertex_at(const float* buffer, int count, double x, double y) {
    const float* found = 0;
    int i = 0;
    while (i < count) {
        const int token = (int)buffer[i++];
        int vertices = token == GL_POINT_TOKEN ? 1 : 2;
        if (token == GL_POLYGON_TOKEN) vertices = (int)buffer[i++];
        for (; vertices > 0; --vertices, i += 7) /* GL_3D_COLOR */
            if (near_to(buffer[i], x, 0.5) && near_to(buffer[i + 1], y, 0.5)) found = buffer + i + 3;
    }
    return found;
}

/* ---- Pixels ---- */

static void start_picture(int side) {
    glViewport(0, 0, side, side);
    glDisable(GL_DITHER);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

static void read_pixel(int x, int y, float* color) {
    unsigned char bytes[4] = {0, 0, 0, 0};
    int i;
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    for (i = 0; i < 4; ++i) color[i] = (float)bytes[i] / 255;
}

static int bits_of(GLenum name) {
    GLint bits = 8;
    glGetIntegerv(name, &bits);
    return gl_error() == GL_NO_ERROR ? bits : 8;
}

static int is_black(int x, int y) {
    float color[4];
    read_pixel(x, y, color);
    return color[0] + color[1] + color[2] == 0;
}

/* 0, or why pixels cannot be read. */
static const char* why_no_pixels(const struct hard_case* of) {
    float color[4];
    if (of->no_pixel) return of->no_pixel;
    if (bits_of(GL_RED_BITS) < 8 || bits_of(GL_GREEN_BITS) < 8 || bits_of(GL_BLUE_BITS) < 8)
        return "the window has less than 8 bits a channel";
    start_picture(VERTEX_SIDE);
    draw_plain_point();
    read_pixel(1, 1, color);
    if (!near_to(color[0], 0.2, HALF_CODE) || !near_to(color[1], 0.4, HALF_CODE) || !near_to(color[2], 0.6, HALF_CODE))
        return "a point without lighting does not show its colour";
    if (of->is_of_polygons) {
        glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        start_picture(VERTEX_SIDE);
        glBegin(GL_TRIANGLES);
        glVertex2f(-0.75f, -0.75f);
        glVertex2f(0.75f, -0.75f);
        glVertex2f(-0.75f, 0.75f);
        glEnd();
        if (is_black(1, 1) || is_black(10, 1) || !is_black(4, 4))
            return "glPolygonMode(..., GL_POINT) does not draw vertices";
    }
    return gl_error() == GL_NO_ERROR ? 0 : "a point without lighting raises an error";
}

/* ---- The comparison ---- */

static int agree(double value, double right, double tolerance) {
    if (value == right || (isnan(value) && isnan(right))) return 1; /* infinite ones too */
    return fabs(value - right) <= tolerance * fmax(1, fabs(right));
}

static double clamped(double value) { return value < 0 ? 0 : value > 1 ? 1 : value; }

/* The text of one case: what is wrong, place by place. */
static char findings[4000];

static void add_finding(const char* text) {
    if (strlen(findings) + strlen(text) + 3 >= sizeof findings) return;
    if (findings[0]) strcat(findings, "; ");
    strcat(findings, text);
}

static void compare_color(const struct expected* expected, const float* value, const double* right, const double* other,
                          int channels, double tolerance) {
    char text[400];
    double shown[4];
    int differs = value == 0, i;
    for (i = 0; i < channels && !differs; ++i)
        differs = !agree(value[i], right[i], tolerance) && !agree(value[i], other[i], tolerance);
    if (!differs) return;
    for (i = 0; i < 4; ++i) shown[i] = !value ? 0 : isnan(value[i]) ? NAN : value[i]; /* not "-nan" */
    i = sprintf(text, "%s: expected (%.7g, %.7g, %.7g, %.7g), this GL ", expected->place, right[0], right[1], right[2],
                right[3]);
    if (!value)
        sprintf(text + i, "draws nothing");
    else if (channels == 4)
        sprintf(text + i, "gives (%.7g, %.7g, %.7g, %.7g)", shown[0], shown[1], shown[2], shown[3]);
    else
        sprintf(text + i, "gives (%.7g, %.7g, %.7g)", shown[0], shown[1], shown[2]);
    add_finding(text);
}

static void compare_vertices(const struct hard_case* of) {
    static float buffer[512];
    const int count = feedback_of(of, buffer);
    int i, channel;
    for (i = 0; i < of->count; ++i) {
        const struct expected* expected = &of->expected[i];
        double right[4], other[4];
        for (channel = 0; channel < 4; ++channel) {
            right[channel] = is_unclamped ? expected->color[channel] : clamped(expected->color[channel]);
            other[channel] = is_unclamped ? expected->other[channel] : clamped(expected->other[channel]);
        }
        compare_color(expected, vertex_at(buffer, count, expected->x * SIDE, expected->y * SIDE), right, other, 4,
                      of->tolerance);
    }
}

static void compare_pixels(const struct hard_case* of) {
    const int side = of->kind == OF_VERTICES ? VERTEX_SIDE : SIDE;
    const double scale = of->kind == OF_VERTICES ? VERTEX_SIDE : 1;
    const int bits = bits_of(GL_RED_BITS);
    const double rounding =
        HALF_CODE + (bits > 8 ? 0.5 / (pow(2, bits) - 1) : 0); /* of the window, and of glReadPixels */
    const int channels = bits_of(GL_ALPHA_BITS) < 8 ? 3 : 4;   /* a window need not have alpha */
    int i;
    start_picture(side);
    of->draw();
    for (i = 0; i < of->count; ++i) {
        const struct expected* expected = &of->expected[i];
        float color[4];
        read_pixel((int)(expected->x * scale), (int)(expected->y * scale), color);
        compare_color(expected, color, expected->shown, expected->other_shown, channels, rounding + of->tolerance);
    }
}

static void say_gl(void) {
    const char* vendor = (const char*)glGetString(GL_VENDOR);
    const char* renderer = (const char*)glGetString(GL_RENDERER);
    const char* version = (const char*)glGetString(GL_VERSION);
    if (says_gl) printf("GL: %s; %s; %s\n", vendor ? vendor : "", renderer ? renderer : "", version ? version : "");
    says_gl = 0;
}

/* Draws the current case and fills `findings`. Returns 0, or why the case cannot be run; `reading` is how its colours were read. */
static const char* compare(const char** reading) {
    const struct hard_case* const of = current;
    const char* why = 0;
    GLenum error;
    char text[100];
    gl_error(); /* from opening the window */
    findings[0] = 0;
    *reading = "";
    if (setjmp(unfinished)) return refusal;
    if (of->count == 0) {
        of->draw();
    } else if (of->kind == OF_VERTICES && !wants_pixels && feedback_works()) {
        *reading = " (feedback)";
        compare_vertices(of);
    } else {
        *reading = " (pixel)";
        why = why_no_pixels(of);
        if (why) return why;
        compare_pixels(of);
    }
    error = gl_error();
    if (error == of->error) return 0;
    if (of->error == GL_NO_ERROR && gl_version() < 21) {
        sprintf(refusal, "this GL, older than 2.1, refuses a call (error 0x%04X)", (unsigned)error);
        return refusal;
    }
    sprintf(text, "glGetError: expected 0x%04X, this GL gives 0x%04X", (unsigned)of->error, (unsigned)error);
    add_finding(text);
    return 0;
}

/* One case in a new context. Returns whether there is another one. */
static int draw(void) {
    const char* reading;
    const char* why;
    say_gl();
    why = compare(&reading);
    if (why) {
        ++cases_not_run;
        printf("%s: not run: %s\n", current->name, why);
    } else if (!findings[0]) {
        printf("%s: right%s\n", current->name, reading);
    } else if (current->is_open) {
        printf("%s: open%s: %s; OpenGL leaves this open\n", current->name, reading, findings);
    } else {
        ++wrong_cases;
        printf("%s: wrong%s: %s; %s\n", current->name, reading, findings, current->section);
    }
    fflush(stdout);
    current = next_case();
    return current != 0;
}

/* The rest of the cases can still be drawn, with --after. What a driver does after the last one, with memory that it has corrupted, changes no
   result. */
static void at_crash(int signal_number) {
    if (is_over) _Exit(result());
    printf("%s: crashed: signal %d\n", current ? current->name : "all", signal_number);
    fflush(stdout);
    _Exit(77);
}

int main(int argc, char** argv) {
    first_name = 1;
    while (first_name < argc && argv[first_name][0] == '-') {
        if (strcmp(argv[first_name], "--pixel") == 0) {
            wants_pixels = 1;
        } else if (strcmp(argv[first_name], "--after") == 0 && first_name + 1 < argc) {
            wants_after = 1;
            after = argv[++first_name];
        } else {
            fprintf(stderr, "usage: %s [--pixel] [--after NAME] [NAME ...]\n", argv[0]);
            return 2;
        }
        ++first_name;
    }
    argument_count = argc;
    arguments = argv;
    current = next_case();
    if (!current) {
        fprintf(stderr, "%s: there is no such case\n", argv[0]);
        return 2;
    }
    atexit(at_exit);
    signal(SIGSEGV, at_crash);
    signal(SIGABRT, at_crash);
    signal(SIGFPE, at_crash);
    signal(SIGILL, at_crash);
    argc = 1; /* GLUT takes no arguments of ours */
    draw_in_windows(&argc, argv, draw, status);
    return 77;
}
