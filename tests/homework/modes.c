// One program, several pictures: a switch chooses what is drawn.
#include <GL/glut.h>
#include <stdbool.h>
#include <stdlib.h>

enum { SPHERE, CUBE, CONE, TORUS, TEAPOT, ICO, LAST_MODE };
enum { FLAT = 1, WIRE = 2, SPIN = 4 };

int mode = TORUS;
int flags = FLAT | SPIN;
int lamps = 2;
bool with_fog = false;
float turn = 25;

void shape(int which, bool wire)
{
    switch (which) {
    case SPHERE:
        if (wire) glutWireSphere(1, 20, 20); else glutSolidSphere(1, 20, 20);
        break;
    case CUBE:
        glRotatef(20, 1, 1, 0);
        glutSolidCube(1.5);
        break;
    case CONE: {
        double height = 2;
        glTranslatef(0, 0, -height / 2);
        glutSolidCone(1, height, 20, 10);
        break;
    }
    case TORUS:
        if (!wire)
            glutSolidTorus(0.4, 0.9, 14, 24);
        else
            glutWireTorus(0.4, 0.9, 14, 24);
        break;
    case TEAPOT:
        glFrontFace(GL_CW);
        glutSolidTeapot(1);
        glFrontFace(GL_CCW);
        break;
    case ICO:
    default:
        glutSolidIcosahedron();
    }
}

void lights(int count)
{
    GLfloat position[][4] = {{3, 3, 4, 1}, {-3, 1, 2, 0}, {0, -4, 1, 0}};
    GLfloat color[3][4] = {{0.9f, 0.9f, 0.8f, 1}, {0.2f, 0.3f, 0.7f, 1}, {0.5f, 0.1f, 0.1f, 1}};
    int i = 0;
    do {
        glLightfv(GL_LIGHT0 + i, GL_POSITION, position[i]);
        glLightfv(GL_LIGHT0 + i, GL_DIFFUSE, color[i]);
        if (i < count)
            glEnable(GL_LIGHT0 + i);
        else
            glDisable(GL_LIGHT0 + i);
    } while (++i < 3);
}

void display(void)
{
    GLfloat clay[] = {0.8f, 0.5f, 0.35f, 1};
    int i;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0, 0, -9);
    lights(lamps);
    glShadeModel(flags & FLAT ? GL_FLAT : GL_SMOOTH);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, clay);
    if (with_fog && !(flags & WIRE)) glEnable(GL_FOG);

    // the chosen one is in the middle, the others stand around it
    for (i = 0; i < LAST_MODE; i++) {
        if (i == mode) continue;
        glPushMatrix();
        glRotatef(i * 360.f / LAST_MODE, 0, 0, 1);
        glTranslatef(2.6f, 0, 0);
        glScalef(0.6f, 0.6f, 0.6f);
        shape(i, false);
        glPopMatrix();
        if (i > 100) break;
    }
    glPushMatrix();
    if (flags & SPIN) glRotatef(turn, 1, 0.3f, 0);
    shape(mode, (flags & WIRE) != 0);
    glPopMatrix();
    glutSwapBuffers();
}

void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (float)w / h, 1, 20);
    glMatrixMode(GL_MODELVIEW);
}

void keys(unsigned char key, int x, int y)
{
    if (key >= '0' && key < '0' + LAST_MODE) mode = key - '0';
    else if (key == 'f') flags ^= FLAT;
    else if (key == 'w') flags ^= WIRE;
    else exit(0);
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(480, 480);
    glutCreateWindow("modes");
    glutKeyboardFunc(keys);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    glutMainLoop();
    return 0;
}
