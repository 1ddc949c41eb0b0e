// Materials from a table, one sphere each.
#ifdef __APPLE__
#include <GLUT/glut.h>
#else
#include <GL/glut.h>
#endif

#define ROWS 3
#define COLS 4
#define COUNT (ROWS * COLS)
#define VALUES 10 /* ambient, diffuse, specular, shininess */

static const float table[COUNT][VALUES] = {
    {.02, .17, .02,   .07, .61, .07,   .63, .72, .63,   .6},    /* emerald */
    {.13, .22, .15,   .54, .89, .63,   .31, .31, .31,   .1},    /* jade */
    {.05, .05, .06,   .18, .17, .22,   .33, .32, .34,   .3},    /* obsidian */
    {.25, .20, .20,   1.0, .82, .82,   .29, .29, .29,   .088},  /* pearl */
    {.17, .01, .01,   .61, .04, .04,   .72, .62, .62,   .6},    /* ruby */
    {.10, .18, .17,   .39, .74, .69,   .29, .30, .30,   .1},    /* turquoise */
    {.33, .22, .02,   .78, .56, .11,   .99, .94, .80,   .22},   /* brass */
    {.21, .12, .05,   .71, .42, .18,   .39, .27, .16,   .2},    /* bronze */
    {.25, .25, .25,   .40, .40, .40,   .77, .77, .77,   .6},    /* chrome */
    {.19, .07, .02,   .70, .27, .08,   .25, .13, .08,   .1},    /* copper */
    {.24, .19, .07,   .75, .60, .22,   .62, .55, .36,   .4},    /* gold */
    {.19, .19, .19,   .50, .50, .50,   .50, .50, .50,   .4},    /* silver */
};

static void use_material(int n)
{
    const float *m = table[n];
    float c[4];
    int k, part;
    const GLenum names[3] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR};
    c[3] = 1.0f;
    for (part = 0; part < 3; ++part) {
        for (k = 0; k < 3; ++k) c[k] = m[3 * part + k];
        glMaterialfv(GL_FRONT_AND_BACK, names[part], c);
    }
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, m[9] * 128);
}

static void draw(void)
{
    int row, col, n = 0;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    row = 0;
    while (row < ROWS) {
        for (col = 0; col < COLS; col++) {
            use_material(n++);
            glPushMatrix();
            glTranslated(2.4 * col - 3.6, 2.4 - 2.4 * row, 0);
            if ((row + col) % 2 == 0)
                glutSolidSphere(1, 32, 24);
            else
                glutSolidTorus(0.3, 0.7, 16, 32);
            glPopMatrix();
        }
        row++;
    }
    glutSwapBuffers();
}

static void resize(int w, int h)
{
    const float aspect = h ? (float)w / (float)h : 1;
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-aspect, aspect, -1, 1, 2, 30);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 0, 8.5, 0, 0, 0, 0, 1, 0);
}

int main(int argc, char *argv[])
{
    const float position[4] = {-4, 6, 8, 1}, dim[] = {0.3f, 0.3f, 0.3f, 1};
    glutInitWindowSize(600, 450);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH);
    glutCreateWindow("Materials");
    glutReshapeFunc(resize);
    glutDisplayFunc(draw);
    glClearColor(.2, .2, .25, 1);
    glLoadIdentity();
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, dim);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutMainLoop();
}
