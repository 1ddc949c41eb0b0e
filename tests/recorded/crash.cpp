// Ends by a signal before it draws.
#include <GL/glut.h>

static int* nothing = nullptr;

static void draw_crash() { *static_cast<volatile int*>(nothing) = 1; }

static void display() {
    glClear(GL_COLOR_BUFFER_BIT);
    draw_crash();
}

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutCreateWindow("crash");
    glutDisplayFunc(display);
    glutMainLoop();
}
