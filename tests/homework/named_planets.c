// Planets in a table of structs, each with its name beside it, and random stars behind them.
#include <GL/glut.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define STARS 40

typedef struct { float d, r; } Moon;

typedef struct planet {
    const char *name;
    float distance, radius, angle;
    GLfloat color[4];
    int moons;
    Moon moon[2];
} Planet;

typedef struct { GLfloat x, y, z, brightness; } Star;

static Planet planets[] = {
    {"Venus", 1.4f, 0.25f, 40, {0.9f, 0.8f, 0.4f, 1}},
    {"Earth", 2.2f, 0.3f, 100, {0.2f, 0.4f, 1, 1}, 1, {{0.5f, 0.08f}}},
    {.name = "Mars", .distance = 3, .radius = 0.2f, .angle = 200, .color = {1, 0.3f, 0.2f, 1},
     .moons = 2, .moon = {{0.3f, 0.05f}, {.r = 0.04f, .d = 0.45f}}},
};
enum { PLANETS = sizeof planets / sizeof planets[0] };
static Star *stars;

static float from_0_to_1(void)
{
    return (float)rand() / (float)RAND_MAX;
}

static Star *make_stars(int n)
{
    Star *made = (Star *)malloc(n * sizeof(Star)), *s;
    if (made == NULL) exit(1);
    for (s = made; s < made + n; s++) {
        s->x = from_0_to_1() * 8 - 4;
        s->y = from_0_to_1() * 6 - 3;
        s->z = -3;
        s->brightness = 0.5f + 0.5f * from_0_to_1();
    }
    return made;
}

static void write_at(float x, float y, float z, void *font, const char *text)
{
    const char *c;
    glRasterPos3f(x, y, z);
    for (c = text; *c != '\0'; c++) glutBitmapCharacter(font, *c);
}

static void draw_planet(const Planet *p)
{
    int i;
    char label[32];
    glPushMatrix();
    glRotatef(p->angle, 0, 1, 0);
    glTranslatef(p->distance, 0, 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, p->color);
    glutSolidSphere(p->radius, 16, 16);
    for (i = 0; i < p->moons; i++) {
        glPushMatrix();
        glRotatef(p->angle * (i + 2), 0, 1, 0);
        glTranslatef(p->moon[i].d, 0, 0);
        glutSolidSphere(p->moon[i].r, 8, 8);
        glPopMatrix();
    }
    glDisable(GL_LIGHTING);
    glColor3f(1, 1, 1);
    sprintf(label, "%s %.1f", p->name, p->distance);
    write_at(0, p->radius + 0.1f, 0, GLUT_BITMAP_HELVETICA_12, label);
    glEnable(GL_LIGHTING);
    glPopMatrix();
}

static void display(void)
{
    int i;
    GLfloat sun[4] = {0, 0, 0, 1}, glow[4] = {1, 1, 0, 1}, none[4] = {0, 0, 0, 1};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(0, 3, 7, 0, 0, 0, 0, 1, 0);

    glDisable(GL_LIGHTING);
    glBegin(GL_POINTS);
    for (i = 0; i < STARS; i++) {
        glColor3f(stars[i].brightness, stars[i].brightness, stars[i].brightness);
        glVertex3fv(&stars[i].x);
    }
    glEnd();
    glEnable(GL_LIGHTING);

    glLightfv(GL_LIGHT0, GL_POSITION, sun);
    glMaterialfv(GL_FRONT, GL_EMISSION, glow);
    glutSolidSphere(0.7, 20, 20);
    glMaterialfv(GL_FRONT, GL_EMISSION, none);
    for (i = 0; i < PLANETS; i++) draw_planet(&planets[i]);
    glutSwapBuffers();
}

static void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (double)w / h, 0.1, 100);
    glMatrixMode(GL_MODELVIEW);
}

static void timer(int value)
{
    Planet *p = planets;
    while (p < planets + PLANETS) p++->angle += 2;
    glutPostRedisplay();
    glutTimerFunc(33, timer, value);
}

int main(int argc, char **argv)
{
    srand(42);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(480, 360);
    glutCreateWindow(argv[0]);
    stars = make_stars(STARS);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutTimerFunc(33, timer, 0);
    glutMainLoop();
    free(stars);
    return EXIT_SUCCESS;
}
