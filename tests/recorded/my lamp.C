// C++ by its extension, and a name with a blank.
#include <GL/glut.h>
#include <cstdlib>
static void draw_lamp() {
    glScalef(0.5f, 0.5f, 0.5f);
    glutSolidSphere(1, 16, 12); // warning: scale-without-normalize
}
static void draw_room() { draw_lamp(); }
static void display() {
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
