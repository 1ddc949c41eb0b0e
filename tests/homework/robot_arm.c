/* Robot arm: shoulder, elbow, wrist and three fingers.
   Keys: s/S e/E w/W turn the joints, f/F closes the hand. */
#include <GL/glut.h>
#include <stdlib.h>

static int shoulder = 30, elbow = -45, wrist = 15;
static int finger = 20;

enum { STEP = 5, FINGERS = 3 };

static GLfloat arm_color[] = { 0.1, 0.5, 0.8, 1.0 };
static GLfloat joint_color[] = { 0.9, 0.6, 0.1, 1.0 };
static GLfloat shine = 60;

void material(const GLfloat *c)
{
	glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, c);
	glMaterialf(GL_FRONT, GL_SHININESS, shine);
}

void joint(double r)
{
	material(joint_color);
	glutSolidSphere(r, 16, 16);
}

void segment(double length, double thick)
{
	joint(thick * 0.7);
	material(arm_color);
	glTranslatef(length / 2, 0.0, 0.0);
	glPushMatrix();
	glScalef(length, thick, thick);
	glutSolidCube(1.0);
	glPopMatrix();
	glTranslatef(length / 2, 0.0, 0.0);
}

void hand(void)
{
	int i;
	for (i = 0; i < FINGERS; i++) {
		glPushMatrix();
		glRotatef((GLfloat) i * 360 / FINGERS, 1.0, 0.0, 0.0);
		glTranslatef(0.0, 0.2, 0.0);
		glRotatef((GLfloat) finger, 0.0, 0.0, 1.0);
		segment(0.4, 0.12);
		glRotatef(-2.0 * finger, 0.0, 0.0, 1.0);
		segment(0.35, 0.1);
		glPopMatrix();
	}
}

void display(void)
{
	glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	glPushMatrix();
		glTranslatef(-2.0, -0.5, 0.0);
		glRotatef((GLfloat) shoulder, 0.0, 0.0, 1.0);
		segment(2.0, 0.5);
		glRotatef((GLfloat) elbow, 0.0, 0.0, 1.0);
		segment(1.5, 0.4);
		glRotatef((GLfloat) wrist, 0.0, 0.0, 1.0);
		joint(0.25);
		hand();
	glPopMatrix();
	glutSwapBuffers();
}

void reshape(int w, int h)
{
	glViewport(0, 0, (GLsizei) w, (GLsizei) h);
	glMatrixMode(GL_PROJECTION);
	glLoadIdentity();
	gluPerspective(55.0, (GLfloat) w / (GLfloat) h, 1.0, 20.0);
	glMatrixMode(GL_MODELVIEW);
	glLoadIdentity();
	glTranslatef(0.0, 0.0, -6.0);
	glRotatef(20, 1, 0, 0);
}

void keyboard(unsigned char key, int x, int y)
{
	switch (key) {
	case 's': shoulder = (shoulder + STEP) % 360; break;
	case 'S': shoulder = (shoulder - STEP) % 360; break;
	case 'e': elbow = (elbow + STEP) % 360; break;
	case 'E': elbow = (elbow - STEP) % 360; break;
	case 'w': wrist = (wrist + STEP) % 360; break;
	case 'W': wrist = (wrist - STEP) % 360; break;
	case 'f': finger < 40 ? finger += STEP : 0; break;
	case 'F': finger > 0 ? finger -= STEP : 0; break;
	case 27: exit(0);
	default: return;
	}
	glutPostRedisplay();
}

static void init(void)
{
	GLfloat position[] = { 2.0, 4.0, 5.0, 1.0 };
	GLfloat specular[] = { 0.8, 0.8, 0.8, 1.0 };

	glClearColor(0.1, 0.1, 0.15, 0.0);
	glLightfv(GL_LIGHT0, GL_POSITION, position);
	glMaterialfv(GL_FRONT, GL_SPECULAR, specular);
	glEnable(GL_LIGHTING);
	glEnable(GL_LIGHT0);
	glEnable(GL_DEPTH_TEST);
	glEnable(GL_NORMALIZE);
}

int main(int argc, char **argv)
{
	glutInit(&argc, argv);
	glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
	glutInitWindowSize(600, 450);
	glutCreateWindow("robot arm");
	init();
	glutDisplayFunc(display);
	glutReshapeFunc(reshape);
	glutKeyboardFunc(keyboard);
	glutMainLoop();
	return 0;
}
