/* teapot_row.c: rows of teapots, each of its own material, from a display list */
#include <GL/glut.h>
#include <stdlib.h>

GLuint teapot;

void init(void)
{
    GLfloat ambient[] = {0.0, 0.0, 0.0, 1.0};
    GLfloat diffuse[] = {1.0, 1.0, 1.0, 1.0};
    GLfloat position[] = {0.0, 3.0, 3.0, 0.0};
    GLfloat lmodel_ambient[] = {0.2, 0.2, 0.2, 1.0};
    GLfloat local_view[] = {0.0};

    glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, lmodel_ambient);
    glLightModelfv(GL_LIGHT_MODEL_LOCAL_VIEWER, local_view);

    glFrontFace(GL_CW);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_AUTO_NORMAL);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);

    teapot = glGenLists(1);
    glNewList(teapot, GL_COMPILE);
    glutSolidTeapot(1.0);
    glEndList();
}

/* Colours first, then the shine as a part of 128. */
void one_teapot(GLfloat x, GLfloat y, GLfloat ambr, GLfloat ambg, GLfloat ambb,
                GLfloat difr, GLfloat difg, GLfloat difb,
                GLfloat specr, GLfloat specg, GLfloat specb, GLfloat shine)
{
    GLfloat mat[4];

    glPushMatrix();
    glTranslatef(x, y, 0.0);
    mat[0] = ambr; mat[1] = ambg; mat[2] = ambb; mat[3] = 1.0;
    glMaterialfv(GL_FRONT, GL_AMBIENT, mat);
    mat[0] = difr; mat[1] = difg; mat[2] = difb;
    glMaterialfv(GL_FRONT, GL_DIFFUSE, mat);
    mat[0] = specr; mat[1] = specg; mat[2] = specb;
    glMaterialfv(GL_FRONT, GL_SPECULAR, mat);
    glMaterialf(GL_FRONT, GL_SHININESS, shine * 128.0);
    glCallList(teapot);
    glPopMatrix();
}

void display(void)
{
    int i;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    one_teapot(2.0, 11.0, 0.02, 0.17, 0.02, 0.08, 0.6, 0.1, 0.6, 0.7, 0.6, 0.6);
    one_teapot(6.0, 11.0, 0.1, 0.2, 0.15, 0.5, 0.9, 0.6, 0.3, 0.3, 0.3, 0.1);
    one_teapot(10.0, 11.0, 0.05, 0.05, 0.06, 0.2, 0.17, 0.2, 0.3, 0.3, 0.35, 0.3);
    one_teapot(14.0, 11.0, 0.3, 0.2, 0.2, 1.0, 0.8, 0.8, 0.3, 0.3, 0.3, 0.09);
    for (i = 0; i < 4; i++) {
        float part = i / 3.0;
        one_teapot(2.0 + 4 * i, 7.0, 0.25, 0.2 * part, 0.05, 0.7, 0.6 * part, 0.1, 0.6, 0.5, 0.3, 0.4);
        one_teapot(2.0 + 4 * i, 3.0, 0, 0, 0, 0.1 + part / 2, 0.1, 0.5 - part / 3, 0.7, 0.6, 0.6, part / 2 + 0.1);
    }
    glFlush();
}

void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (w <= h)
        glOrtho(0.0, 16.0, 0.0, 16.0 * (GLfloat)h / (GLfloat)w, -10.0, 10.0);
    else
        glOrtho(0.0, 16.0 * (GLfloat)w / (GLfloat)h, 0.0, 16.0, -10.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
}

void keyboard(unsigned char key, int x, int y)
{
    if (key == 27) exit(0);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(520, 500);
    glutCreateWindow(argv[0]);
    init();
    glutReshapeFunc(reshape);
    glutDisplayFunc(display);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
