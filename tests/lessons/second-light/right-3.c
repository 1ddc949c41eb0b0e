// Right: a whole program; the colour is set for GL_LIGHT1.
#include <GL/glut.h>

static const GLfloat blue[] = {0.2, 0.4, 1, 1};

static void display(void) {
    glClearColor(0.35, 0.42, 0.5, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, 4.0 / 3.0, 1, 50);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 0, 6,  0, 0, 0,  0, 1, 0);

    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){-4, 1, 2, 1});
    glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){4, 1, 2, 1});
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHT1);
    glLightfv(GL_LIGHT1, GL_DIFFUSE, blue);

    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0.9, 0.9, 0.9, 1});
    glutSolidSphere(1.7, 96, 48);
    glutSwapBuffers();
}

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH);
    glutInitWindowSize(640, 480);
    glutCreateWindow("two lamps");
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
