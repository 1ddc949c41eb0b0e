/* An animation: balls that bounce in a box. The first frame is the picture. */
#include <GL/glut.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define MAX_BALLS 12
#define GRAVITY -9.81f

float px[MAX_BALLS], py[MAX_BALLS], pz[MAX_BALLS];
float vx[MAX_BALLS], vy[MAX_BALLS], vz[MAX_BALLS];
float r[MAX_BALLS];
float cr[MAX_BALLS], cg[MAX_BALLS], cb[MAX_BALLS];
int balls = 9;
int paused = GL_FALSE;
float t = 0.0f, dt = 0.02f;

/* Our own random numbers, so that every run is the same. */
static unsigned int seed = 12345u;
float next_random(void)
{
    seed = seed * 1103515245u + 12345u;
    return (float)((seed >> 16) & 0x7fff) / 32768.0f;
}

void start(void)
{
    int i;
    for (i = 0; i < balls; i++) {
        px[i] = -2 + 4 * next_random();
        py[i] = 1 + 2 * next_random();
        pz[i] = -2 + 4 * next_random();
        vx[i] = next_random() - 0.5f;
        vy[i] = 0;
        vz[i] = next_random() - 0.5f;
        r[i] = 0.25f + 0.3f * next_random();
        cr[i] = 0.3f + 0.7f * next_random();
        cg[i] = 0.3f + 0.7f * next_random();
        cb[i] = 1.0f - cr[i] / 2;
    }
}

void advance(float step)
{
    int i;
    for (i = 0; i < balls; ++i) {
        vy[i] += GRAVITY * step;
        px[i] += vx[i] * step;
        py[i] += vy[i] * step;
        pz[i] += vz[i] * step;
        if (py[i] < r[i]) {
            py[i] = r[i];
            vy[i] = -0.8f * vy[i];
        }
        if (fabs(px[i]) > 3 - r[i]) vx[i] = -vx[i];
        if (fabs(pz[i]) > 3 - r[i]) vz[i] *= -1;
    }
    t += step;
}

void ball(int i)
{
    static int drawn = 0;
    GLfloat c[4] = {cr[i], cg[i], cb[i], 1};
    drawn++;
    glPushMatrix();
    glTranslatef(px[i], py[i], pz[i]);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, c);
    glutSolidSphere(r[i], 16 + drawn % 3 * 4, 16);
    glPopMatrix();
}

void box(void)
{
    GLfloat grey[] = {0.5f, 0.5f, 0.5f, 1};
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, grey);
    glBegin(GL_QUADS);
    glNormal3f(0, 1, 0);
    glVertex3f(-3, 0, 3); glVertex3f(3, 0, 3); glVertex3f(3, 0, -3); glVertex3f(-3, 0, -3);
    glNormal3f(0, 0, 1);
    glVertex3f(-3, 0, -3); glVertex3f(3, 0, -3); glVertex3f(3, 4, -3); glVertex3f(-3, 4, -3);
    glNormal3f(1, 0, 0);
    glVertex3f(-3, 0, 3); glVertex3f(-3, 0, -3); glVertex3f(-3, 4, -3); glVertex3f(-3, 4, 3);
    glEnd();
}

void display(void)
{
    GLfloat lamp[] = {2, 6, 5, 1};
    int i = balls;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(4, 4, 9, 0, 1.5, 0, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, lamp);
    box();
    while (i-- > 0) ball(i);
    glutSwapBuffers();
}

void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (float)w / (float)h, 1, 30);
    glMatrixMode(GL_MODELVIEW);
}

void timer(int value)
{
    if (!paused) advance(dt);
    glutPostRedisplay();
    glutTimerFunc(500, timer, value + 1);
}

void key(unsigned char k, int x, int y)
{
    if (k == ' ') paused = !paused;
    else if (k == 'r') start();
    else if (k == 27) exit(0);
    printf("t = %.2f\n", t);
}

int main(int argc, char **argv)
{
    int i;
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(640, 480);
    glutCreateWindow("Bouncing balls");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    start();
    for (i = 0; i < 40; i++) advance(dt);  /* not all at rest in the first frame */
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(key);
    glutTimerFunc(500, timer, 0);
    glutMainLoop();
    return 0;
}
