/* A window by GLUT. */
#ifdef __APPLE__
#include <GLUT/glut.h>
#include <dlfcn.h>
#elif defined __EMSCRIPTEN__
#include <GL/glut.h>
#include <emscripten/html5.h>
#else
#include <GL/freeglut.h>
#endif
#include <stdlib.h>

#include "window.h"

static int (*draw_case)(void);
static int (*status_of_all)(void);
static const char* title;
static int window;

static void display(void);

static void open_window(void) {
    glutInitDisplayMode(GLUT_RGBA | GLUT_ALPHA | GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL);
    glutInitWindowSize(SIDE, SIDE);
    window = glutCreateWindow(title);
    glutDisplayFunc(display);
}

static void display(void) {
    const int done = window;
    if (!draw_case()) exit(status_of_all());
    open_window();
    glutDestroyWindow(done);
}

void draw_in_windows(int* argc, char** argv, int (*draw)(void), int (*status)(void)) {
    draw_case = draw;
    status_of_all = status;
    title = argv[0];
    glutInit(argc, argv);
    open_window();
    glutMainLoop();
}

void (*window_function(const char* name))(void) {
#ifdef __APPLE__
    return (void (*)(void))dlsym(RTLD_DEFAULT, name);
#elif defined __EMSCRIPTEN__
    return (void (*)(void))emscripten_webgl_get_proc_address(name);
#else
    return (void (*)(void))glutGetProcAddress(name);
#endif
}
