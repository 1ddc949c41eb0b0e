/* Sends 200,500 vertices a frame between glBegin and glEnd: a recording of it is large. */
#include <GL/glut.h>
#include <math.h>

static void send(double u, double v) {
    const float x = sin(u) * cos(v), y = cos(u), z = sin(u) * sin(v);
    glNormal3f(x, y, z);
    glVertex3f(x, y, z);
}

static void display(void) {
    static float angle = 0;
    const int bands = 250, columns = 400;
    const double pi = 3.14159265358979;
    int i, k;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0, 0, -3);
    glRotatef(angle += 1, 0, 1, 0);
    for (i = 0; i < bands; ++i) {
        glBegin(GL_TRIANGLE_STRIP);
        for (k = 0; k <= columns; ++k) {
            send(i * pi / bands, k * 2 * pi / columns);
            send((i + 1) * pi / bands, k * 2 * pi / columns);
        }
        glEnd();
    }
    glutSwapBuffers();
    glutPostRedisplay();
}

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(300, 300);
    glutCreateWindow("many vertices");
    glMatrixMode(GL_PROJECTION);
    gluPerspective(45, 1, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
