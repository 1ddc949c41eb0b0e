/* Nothing is wrong until the key s; the arrow to the left ends the program. */
#include <GL/glut.h>
#include <stdlib.h>
static int scaled = 0;
static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    if (scaled) glScalef(0.5f, 0.5f, 0.5f);
    glutSolidSphere(0.9, 16, 12); /* warning: scale-without-normalize */
    glutSwapBuffers();
}
static void key(unsigned char c, int x, int y) {
    (void)x;
    (void)y;
    if (c != 's') return;
    scaled = 1;
    glutPostRedisplay();
}
static void special(int c, int x, int y) {
    (void)x;
    (void)y;
    if (c == GLUT_KEY_LEFT && scaled) exit(0);
}
int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH);
    glutInitWindowSize(64, 48);
    glutCreateWindow("keys");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glutDisplayFunc(display);
    glutKeyboardFunc(key);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
