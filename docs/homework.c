/* A ball and a small ball beside it, under one lamp. Four mistakes that OpenGL accepts: build/twinlight lint docs/homework.c */
#include <GL/freeglut.h>

static const GLfloat lamp[] = {3, 4, 2, 1};
static const GLfloat white[] = {1, 1, 1, 1};
static const GLfloat orange[] = {1, 0.5, 0.1, 1};

static void init(void) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, lamp);
}

static void display(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(4, 3, 5, 0, 0, 0, 0, 1, 0);

    glMaterialfv(GL_FRONT, GL_DIFFUSE, orange);
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glutSolidSphere(1, 40, 40);

    glColor3f(0.2f, 0.4f, 1);
    glTranslatef(1.6f, 0, 0);
    glScalef(0.4f, 0.4f, 0.4f);
    glutSolidSphere(1, 40, 40);
    glutSwapBuffers();
}

static void reshape(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
}

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(640, 480);
    glutCreateWindow("Homework");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMainLoop();
    return 0;
}
