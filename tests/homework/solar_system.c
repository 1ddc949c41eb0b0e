// A sun, planets and moons. Lab 4, hierarchies with push and pop.
#include <GL/glut.h>
#include <math.h>

#define PLANETS 4
#define DEG2RAD(a) ((a) * M_PI / 180.0)

static float day = 20.0f;
static float year = 75.0f;

const float distance[PLANETS] = {1.6f, 2.5f, 3.6f, 5.0f};
const float radius[PLANETS] = {0.18f, 0.25f, 0.35f, 0.3f};
const float speed[PLANETS] = {4.1f, 1.6f, 1.0f, 0.5f};
const int moons[PLANETS] = {0, 1, 2, 3};
GLfloat color[PLANETS][4] = {
    {0.7f, 0.5f, 0.4f, 1.0f},
    {0.2f, 0.4f, 0.9f, 1.0f},
    {0.9f, 0.3f, 0.1f, 1.0f},
    {0.8f, 0.7f, 0.5f, 1.0f},
};

void sun(void) {
    GLfloat glow[] = {1.0f, 0.85f, 0.2f, 1.0f};
    GLfloat none[] = {0, 0, 0, 1}, dim[] = {0.2f, 0.2f, 0.2f, 1};
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, dim);
    glMaterialfv(GL_FRONT, GL_EMISSION, glow);
    glutSolidSphere(0.8, 30, 30);
    glMaterialfv(GL_FRONT, GL_EMISSION, none);
}

void moon(int number, int of) {
    GLfloat grey[] = {0.6f, 0.6f, 0.6f, 1.0f};
    glPushMatrix();
    glRotatef(day * 3 + number * 360.0 / of, 0.1f, 1, 0);
    glTranslatef(0.55f, 0, 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, grey);
    glutSolidSphere(0.08, 12, 10);
    glPopMatrix();
}

void planet(int i) {
    int m;
    glPushMatrix();
    glRotatef(year * speed[i], 0, 1, 0);
    glTranslatef(distance[i], 0, 0);
    glPushMatrix();
    glRotatef(day, 0, 1, 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color[i]);
    glutSolidSphere(radius[i], 20, 16);
    glPopMatrix();
    for (m = 0; m < moons[i]; ++m)
        moon(m, moons[i]);
    glPopMatrix();
}

// The path of a planet, as a loop of lines without light.
void orbit(float r) {
    glDisable(GL_LIGHTING);
    glColor3f(0.3, 0.3, 0.35);
    glBegin(GL_LINE_LOOP);
    for (int a = 0; a < 360; a += 6)
        glVertex3f(r * cos(DEG2RAD(a)), 0, r * sin(DEG2RAD(a)));
    glEnd();
    glEnable(GL_LIGHTING);
}

void display(void) {
    GLfloat at[] = {0, 0, 0, 1};
    int i;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(0, 5, 9, 0, 0, 0, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, at);
    sun();
    for (i = 0; i < PLANETS; i++) {
        orbit(distance[i]);
        planet(i);
    }
    glutSwapBuffers();
}

void reshape(int w, int h) {
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(50.0, (double)w / h, 1.0, 40.0);
    glMatrixMode(GL_MODELVIEW);
}

void idle(void) {
    day += 1.0f;
    if (day > 360) day -= 360;
    year = fmod(year + 0.2, 360.0);
    glutPostRedisplay();
}

void visible(int state) {
    if (state == GLUT_VISIBLE)
        glutIdleFunc(idle);
    else
        glutIdleFunc(NULL);
}

int main(int argc, char *argv[]) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(640, 480);
    glutCreateWindow("Solar system");
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutVisibilityFunc(visible);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glutMainLoop();
    return 0;
}
