/* Assignment 3: a surface z = f(x, y), its normals from cross products. */
#include <GL/glut.h>
#include <math.h>

#define N 40
#define RANGE 3.0

double height_of[N + 1][N + 1];
GLfloat normal[N + 1][N + 1][3];

double f(double x, double y)
{
    double r = sqrt(x * x + y * y);
    if (r < 1e-6)
        return 1.0;
    return sin(3 * r) / (3 * r) + 0.1 * cos(2 * x);
}

double coordinate(int i) { return -RANGE + 2 * RANGE * i / N; }

void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

void normalize(double v[3])
{
    double len = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (len > 0.0) {
        v[0] /= len;
        v[1] /= len;
        v[2] /= len;
    }
}

int clamp(int i) { return i < 0 ? 0 : i > N ? N : i; }

void compute(void)
{
    int i, j, k;
    for (i = 0; i <= N; i++)
        for (j = 0; j <= N; j++)
            height_of[i][j] = f(coordinate(i), coordinate(j));
    for (i = 0; i <= N; i++) {
        for (j = 0; j <= N; j++) {
            int i0 = clamp(i - 1), i1 = clamp(i + 1), j0 = clamp(j - 1), j1 = clamp(j + 1);
            double dx[3], dy[3], n[3];
            dx[0] = coordinate(i1) - coordinate(i0);
            dx[1] = 0;
            dx[2] = height_of[i1][j] - height_of[i0][j];
            dy[0] = 0;
            dy[1] = coordinate(j1) - coordinate(j0);
            dy[2] = height_of[i][j1] - height_of[i][j0];
            cross(dx, dy, n);
            normalize(n);
            for (k = 0; k < 3; k++)
                normal[i][j][k] = (GLfloat)n[k];
        }
    }
}

void point(int i, int j)
{
    glNormal3fv(normal[i][j]);
    glVertex3d(coordinate(i), coordinate(j), height_of[i][j]);
}

void display(void)
{
    int i, j;
    GLfloat position[] = {2, -3, 5, 1};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(4, -6, 5, 0, 0, 0, 0, 0, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    for (i = 0; i < N; i++) {
        glBegin(GL_QUAD_STRIP);
        for (j = 0; j <= N; j++) {
            point(i, j);
            point(i + 1, j);
        }
        glEnd();
    }
    glutSwapBuffers();
}

void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (GLdouble)w / (GLdouble)h, 1, 50);
}

int main(int argc, char **argv)
{
    GLfloat front[] = {0.2f, 0.6f, 0.3f, 1}, back[] = {0.6f, 0.3f, 0.2f, 1}, white[] = {1, 1, 1, 1};
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(600, 400);
    glutCreateWindow("surface");
    compute();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMainLoop();
    return 0;
}
