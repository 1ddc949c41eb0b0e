// Texts over a lit torus, in bitmap and stroke fonts.
#include <GL/glut.h>
#include <stdio.h>
#include <string.h>

#define WIDTH 400
#define HEIGHT 300

static const char *help[] = {"F1: help", "q: quit", "arrows: move the light", NULL};
static void *fonts[] = {GLUT_BITMAP_9_BY_15, GLUT_BITMAP_TIMES_ROMAN_10, GLUT_BITMAP_TIMES_ROMAN_24};
static int frames, last_time;
static double fps;

static void bitmap_text(float x, float y, void *font, const char *text)
{
    int i, n = (int)strlen(text);
    glRasterPos2f(x + 0.5f, y + 0.5f);
    for (i = 0; i < n; i++) glutBitmapCharacter(font, text[i]);
}

static void centred(float y, void *font, char *text)
{
    int width = glutBitmapLength(font, (const unsigned char *)text);
    bitmap_text((WIDTH - width) / 2, y, font, text);
}

static void stroke_text(float x, float y, float size, const char *text)
{
    glPushMatrix();
    glTranslatef(x, y, 0);
    glScalef(size, size, size);
    while (*text) glutStrokeCharacter(GLUT_STROKE_ROMAN, *text++);
    glPopMatrix();
}

static void overlay(void)
{
    const char **line;
    char text[64];
    int i;
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    gluOrtho2D(0, WIDTH, 0, HEIGHT);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();
    glPushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT);
    glDisable(GL_LIGHTING);
    glDisable(GL_DEPTH_TEST);
    glColor3ub(255, 255, 0);
    for (line = help, i = 0; *line; line++, i++) bitmap_text(10, HEIGHT - 25 - 20 * i, fonts[i], *line);
    snprintf(text, sizeof text, "%d frame%s, %4.1f per second", frames, frames == 1 ? "" : "s", fps);
    centred(10, GLUT_BITMAP_HELVETICA_18, text);
    stroke_text(20, 40, 0.1f, "Twin" "light");
    glPopAttrib();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glPopMatrix();
}

static void display(void)
{
    int time = glutGet(GLUT_ELAPSED_TIME);
    frames++;
    if (time - last_time > 1000000) {
        fps = frames * 1000.0 / (time - last_time);
        last_time = time;
        frames = 0;
    }
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glutSolidTorus(0.2, 0.5, 12, 24);
    overlay();
    glutSwapBuffers();
}

static void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(WIDTH, HEIGHT);
    glutCreateWindow("Texts");
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMainLoop();
    return 0;
}
