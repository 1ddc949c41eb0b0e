// Particles in a linked list: allocated, moved, and freed below the floor. Each has a function that draws it.
#include <GL/glut.h>
#include <stdlib.h>

typedef unsigned short int count_t;

typedef struct { float x, y, z; } vec3;

typedef struct particle {
    vec3 at, speed;
    void (*draw)(float size);
    struct particle *next;
} particle;

typedef struct {
    particle *first;
    count_t count;
} list;

static list all = {NULL, 0u};

static void ball(float size) { glutSolidSphere(size, 8, 8); }
static void box(float size) { glutSolidCube(size); }
static void (*const shapes[])(float) = {ball, &box};

static vec3 add(vec3 a, vec3 b)
{
    vec3 sum = {a.x + b.x, a.y + b.y, a.z + b.z};
    return sum;
}

static vec3 times(double s, const vec3 *v) { return (vec3){s * v->x, s * v->y, s * v->z}; }

static double between(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

static particle *push(list *l)
{
    particle *p = malloc(sizeof *p);
    if (!p) exit(EXIT_FAILURE);
    *p = (particle){.draw = shapes[l->count % 2]};
    p->at.x = between(-1, 1);
    p->speed.y = between(-0.5, 0.5);
    p->next = l->first;
    ++l->count;
    return l->first = p;
}

static void step(list *l, float dt)
{
    particle **link = &l->first;
    while (*link) {
        particle *p = *link;
        p->at = add(p->at, times(dt, &p->speed));
        if (p->at.y < -0.2f) {
            *link = p->next;
            free(p);
            l->count--;
        } else
            link = &p->next;
    }
}

static void display(void)
{
    particle *p;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    step(&all, 0.5f);
    for (p = all.first; p != NULL; p = p->next) {
        glPushMatrix();
        glTranslatef(p->at.x, p->at.y, p->at.z);
        p->draw(0.1f);
        glPopMatrix();
    }
    glutSwapBuffers();
}

static void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
}

int main(int argc, char **argv)
{
    int n = 16;
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutCreateWindow("Particles");
    while (n-- > 0) push(&all);
    glEnable(GL_DEPTH_TEST), glEnable(GL_LIGHTING), glEnable(GL_LIGHT0);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMainLoop();
    return 0;
}
