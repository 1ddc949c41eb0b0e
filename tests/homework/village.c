/* A village: display lists, GLU's quadrics, a texture made by the program, fog and trees by recursion. */
#include <GL/glut.h>
#include <math.h>

#define TEX 64
#define HOUSES 5

GLubyte image[TEX][TEX][3];
GLuint texture, lists;
GLUquadricObj *quadric;

#define HOUSE (lists + 0)
#define TREE (lists + 1)

void make_texture(void)
{
    int i, j, c;
    for (i = 0; i < TEX; i++) {
        for (j = 0; j < TEX; j++) {
            /* bricks: every second row is shifted */
            int row = i / 8, shift = (row % 2) * 8;
            int mortar = i % 8 == 0 || (j + shift) % 16 == 0;
            c = mortar ? 200 : 120 + ((i * 7 + j * 13) & 0x1f);
            image[i][j][0] = (GLubyte)c;
            image[i][j][1] = (GLubyte)(mortar ? 195 : c / 2);
            image[i][j][2] = (GLubyte)(mortar ? 190 : c / 3);
        }
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, TEX, TEX, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

void color(float red, float green, float blue)
{
    GLfloat c[4];
    c[0] = red, c[1] = green, c[2] = blue, c[3] = 1;
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, c);
}

void house(void)
{
    static const GLfloat corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    int k;
    color(1, 1, 1);
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_QUADS);
    for (k = 0; k < 4; k++) {
        const GLfloat *a = corner[k];
        const GLfloat *b = corner[(k + 1) % 4];
        glNormal3f(a[0] + b[0] != 0 ? (a[0] + b[0]) / 2 : 0, a[1] + b[1] != 0 ? (a[1] + b[1]) / 2 : 0, 0);
        glTexCoord2f(0, 0); glVertex3f(a[0], a[1], 0);
        glTexCoord2f(2, 0); glVertex3f(b[0], b[1], 0);
        glTexCoord2f(2, 2); glVertex3f(b[0], b[1], 1.5f);
        glTexCoord2f(0, 2); glVertex3f(a[0], a[1], 1.5f);
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
    color(0.6f, 0.2f, 0.15f);
    glPushMatrix();
    glTranslatef(0, 0, 1.5f);
    glRotatef(45, 0, 0, 1);
    gluCylinder(quadric, 1.6, 0, 1, 4, 1);
    glPopMatrix();
}

void branch(int depth, double length)
{
    gluCylinder(quadric, length / 8, length / 12, length, 8, 1);
    glTranslated(0, 0, length);
    if (depth == 0) {
        color(0.15f, 0.5f, 0.1f);
        gluSphere(quadric, length * 0.8, 8, 6);
        color(0.4f, 0.25f, 0.1f);
        return;
    }
    for (int side = 0; side < 3; side++) {
        glPushMatrix();
        glRotated(120.0 * side, 0, 0, 1);
        glRotated(35, 1, 0, 0);
        branch(depth - 1, length * 0.65);
        glPopMatrix();
    }
}

void make_lists(void)
{
    lists = glGenLists(2);
    glNewList(HOUSE, GL_COMPILE);
    house();
    glEndList();
    glNewList(TREE, GL_COMPILE);
    color(0.4f, 0.25f, 0.1f);
    branch(2, 1.2);
    glEndList();
}

void init(void)
{
    GLfloat sky[] = {0.6f, 0.75f, 0.9f, 1};
    glClearColor(sky[0], sky[1], sky[2], sky[3]);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 8);
    glFogf(GL_FOG_END, 40);
    glFogfv(GL_FOG_COLOR, sky);
    quadric = gluNewQuadric();
    if (!quadric) return;
    gluQuadricNormals(quadric, GLU_SMOOTH);
    make_texture();
    make_lists();
}

void display(void)
{
    GLfloat sun[] = {3, -4, 5, 0};
    int i;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    gluLookAt(2, -13, 6, 0, 0, 1, 0, 0, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, sun);
    color(0.3f, 0.55f, 0.2f);
    glNormal3f(0, 0, 1);
    glBegin(GL_QUADS);
    glVertex2i(-20, -9); glVertex2i(20, -9); glVertex2i(20, 20); glVertex2i(-20, 20);
    glEnd();
    for (i = 0; i < HOUSES; i++) {
        double a = 2 * M_PI * i / HOUSES;
        glPushMatrix();
        glTranslatef(5 * cos(a), 5 * sin(a), 0);
        glRotatef(a * 180 / M_PI, 0, 0, 1);
        glCallList(i % 5 == 4 ? TREE : HOUSE);
        glPopMatrix();
    }
    glPushMatrix();
    glScalef(1.5, 1.5, 1.5);
    glCallList(TREE);
    glPopMatrix();
    glutSwapBuffers();
}

void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (double)w / h, 1, 60);
    glMatrixMode(GL_MODELVIEW);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(640, 480);
    glutCreateWindow("Village");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMainLoop();
    return 0;
}
