/* Spotlights over a grid. The more quads, the better the cone. */
#include <GL/glut.h>
#include <math.h>

#define LIGHTS 3
#define GRID 48
#define X 0
#define Y 1
#define Z 2

float lights[LIGHTS][3] = {{-2, -1, 2.5f}, {0, 1.2f, 2}, {2, -0.5f, 3}};
float colors[LIGHTS][4] = {{1, 0.2f, 0.2f, 1}, {0.2f, 1, 0.2f, 1}, {0.3f, 0.3f, 1, 1}};
double angle = 40;
int moving = 1;

static void place_lights(void)
{
    static const GLfloat down[] = {0, 0, -1};
    GLfloat position[4];
    int i, k;
    for (i = 0; i < LIGHTS; i++) {
        GLenum light = GL_LIGHT0 + i;
        for (k = X; k <= Z; k++) position[k] = lights[i][k];
        position[3] = 1;
        position[X] += 0.5 * cos(angle * M_PI / 180 + i);
        position[Y] += 0.5 * sin(angle * M_PI / 180 + i);
        glLightfv(light, GL_POSITION, position);
        glLightfv(light, GL_DIFFUSE, colors[i]);
        glLightfv(light, GL_SPECULAR, colors[i]);
        glLightfv(light, GL_SPOT_DIRECTION, down);
        glLightf(light, GL_SPOT_CUTOFF, 25 + 3 * i);
        glLightf(light, GL_SPOT_EXPONENT, 10.0 / (i + 1));
        glLightf(light, GL_CONSTANT_ATTENUATION, 1);
        glLightf(light, GL_LINEAR_ATTENUATION, 0.05);
        glEnable(light);
    }
}

static void grid(int n, double size)
{
    int i, j;
    double d = size / n;
    glNormal3d(0, 0, 1);
    for (j = 0; j < n; j++) {
        double y = -size / 2 + j * d;
        glBegin(GL_TRIANGLE_STRIP);
        for (i = 0; i <= n; i++) {
            double x = -size / 2 + i * d;
            glVertex2d(x, y + d);
            glVertex2d(x, y);
        }
        glEnd();
    }
}

void display(void)
{
    GLfloat grey[] = {0.7f, 0.7f, 0.7f, 1}, shine[] = {0.4f, 0.4f, 0.4f, 1}, none[] = {0.05f, 0.05f, 0.05f, 1};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(0, -5, 7, 0, 0, 0, 0, 0, 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
    place_lights();
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, grey);
    glMaterialfv(GL_FRONT, GL_SPECULAR, shine);
    glMateriali(GL_FRONT, GL_SHININESS, 30);
    grid(GRID, 8);
    glTranslatef(0, 0, 0.6f);
    glutSolidCone(0.5, 1, 30, 10);
    glutSwapBuffers();
}

void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(50, w / (double)h, 1, 30);
    glMatrixMode(GL_MODELVIEW);
}

void tick(int unused)
{
    if (moving) angle += 2;
    glutPostRedisplay();
    glutTimerFunc(1000, tick, 0);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH);
    glutInitWindowSize(560, 420);
    glutCreateWindow("Spots");
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutTimerFunc(1000, tick, 0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glutMainLoop();
    return 0;
}
