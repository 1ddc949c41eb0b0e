/* A checkered floor by loops, with things on it. */
#include <GL/glut.h>
#include <math.h>
#include <stdio.h>

#define SIZE 8            /* fields on a side */
#define FIELD 1.0f
#define CUTS 3            /* quads on a side of a field */

GLfloat white[] = {0.9f, 0.9f, 0.85f, 1.0f};
GLfloat black[] = {0.1f, 0.1f, 0.12f, 1.0f};
GLfloat red[4]  = {0.8f, 0.1f, 0.1f};

float eye_x = 3, eye_y = 4, eye_z = 7;
int wire = 0;

void field(float x0, float z0)
{
    int i, j;
    float s = FIELD / CUTS;
    for (i = 0; i < CUTS; i++)
    {
        glBegin(GL_QUAD_STRIP);
        for (j = 0; j <= CUTS; j++)
        {
            glVertex3f(x0 + i * s, 0.0f, z0 + j * s);
            glVertex3f(x0 + (i + 1) * s, 0.0f, z0 + j * s);
        }
        glEnd();
    }
}

void floor_of_fields(void)
{
    int i, j;
    glNormal3f(0.0f, 1.0f, 0.0f);
    for (i = 0; i < SIZE; i++)
        for (j = 0; j < SIZE; j++)
        {
            if ((i ^ j) & 1)
                glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, white);
            else
                glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, black);
            field((i - SIZE / 2) * FIELD, (j - SIZE / 2) * FIELD);
        }
}

/* A cone of triangles with the normals of its sides. */
void pawn(float x, float z, float r, float h)
{
    int n = 24, k;
    float slope = r / h;
    float length = sqrt(1 + slope * slope);
    glPushMatrix();
    glTranslatef(x, 0, z);
    glBegin(GL_TRIANGLES);
    for (k = 0; k < n; k++)
    {
        float a = 2 * M_PI * k / n, b = 2 * M_PI * (k + 1) / n, m = (a + b) / 2;
        glNormal3f(cosf(m) / length, slope / length, sinf(m) / length);
        glVertex3f(0, h, 0);
        glNormal3f(cosf(b) / length, slope / length, sinf(b) / length);
        glVertex3f(r * cosf(b), 0, r * sinf(b));
        glNormal3f(cosf(a) / length, slope / length, sinf(a) / length);
        glVertex3f(r * cosf(a), 0, r * sinf(a));
    }
    glEnd();
    glTranslatef(0, h, 0);
    glutSolidSphere(r * 0.6, 20, 16);
    glPopMatrix();
}

void display(void)
{
    GLfloat lamp[] = {-2.0f, 5.0f, 3.0f, 1.0f};
    int i;

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(eye_x, eye_y, eye_z, 0, 0, 0, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, lamp);
    glPolygonMode(GL_FRONT_AND_BACK, wire ? GL_LINE : GL_FILL);

    floor_of_fields();
    red[3] = 1.0f;
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, red);
    for (i = 0; i < 4; i++)
        pawn(-2.5f + 2 * i, -1.5f, 0.35f, 0.9f);
    for (i = 0; i < 4; i++)
        pawn(-1.5f + 2 * i, 1.5f, 0.3f, 0.7f + 0.1f * i);

    glutSwapBuffers();
}

void reshape(int width, int height)
{
    if (height == 0) height = 1;
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45.0, 1.0 * width / height, 0.5, 50.0);
}

void special(int key, int x, int y)
{
    if (key == GLUT_KEY_LEFT) eye_x -= 0.2f;
    if (key == GLUT_KEY_RIGHT) eye_x += 0.2f;
    if (key == GLUT_KEY_F1) wire = !wire;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    puts("arrow keys move the camera");
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH);
    glutInitWindowSize(640, 400);
    glutCreateWindow("Floor");
    glClearColor(0.5f, 0.7f, 0.9f, 1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
