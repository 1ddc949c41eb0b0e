/* Headers as on Windows and macOS, and as on systems where letters of names have no case. */
#include <windows.h>
#include <OpenGL/gl.h>
#include <GL/GLU.h>
#include <GLUT/glut.h>
#include <gl/glut.h>
#include <stdlib.h>
static void draw_lamp(void) {
    glScalef(0.5f, 0.5f, 0.5f);
    glutSolidSphere(1, 16, 12); /* warning: scale-without-normalize */
}
static void draw_room(void) { draw_lamp(); }
static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_room();
    glutSwapBuffers();
    exit(0);
}
int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH);
    glutInitWindowSize(64, 48);
    glutCreateWindow("lamp");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
