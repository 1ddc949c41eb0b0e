/* glColorMaterial: the current colour sets a property of the material.
   The mouse buttons change red, green and blue. */
#include <GL/glut.h>
#include <stdlib.h>

GLfloat diffuseMaterial[4] = { 0.5, 0.5, 0.5, 1.0 };

void cube(GLfloat size)
{
   GLfloat s = size / 2;
   int side;

   for (side = 0; side < 4; side++) {
      glPushMatrix();
      glRotatef(90.0 * side, 0, 1, 0);
      glBegin(GL_QUADS);
      glNormal3f(0, 0, 1);
      glColor3f(1, 0, side / 3.0f); glVertex3f(-s, -s, s);
      glColor3f(0, 1, side / 3.0f); glVertex3f(s, -s, s);
      glColor3ub(255, 255, side * 80); glVertex3f(s, s, s);
      glColor4f(0.2f, 0.2f, 1, 1); glVertex3f(-s, s, s);
      glEnd();
      glPopMatrix();
   }
   /* top and bottom */
   glBegin(GL_QUADS);
   for (side = -1; side <= 1; side += 2) {
      glNormal3f(0, side, 0);
      glColor3f(0.9, 0.9, 0.9);
      glVertex3f(-s, side * s, side * s);
      glVertex3f(s, side * s, side * s);
      glVertex3f(s, side * s, -side * s);
      glVertex3f(-s, side * s, -side * s);
   }
   glEnd();
}

void init(void)
{
   GLfloat mat_specular[] = { 1.0, 1.0, 1.0, 1.0 };
   GLfloat light_position[] = { 1.0, 1.0, 1.0, 0.0 };

   glClearColor(0.0, 0.0, 0.0, 0.0);
   glShadeModel(GL_SMOOTH);
   glEnable(GL_DEPTH_TEST);
   glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuseMaterial);
   glMaterialfv(GL_FRONT, GL_SPECULAR, mat_specular);
   glMaterialf(GL_FRONT, GL_SHININESS, 25.0);
   glLightfv(GL_LIGHT0, GL_POSITION, light_position);
   glEnable(GL_LIGHTING);
   glEnable(GL_LIGHT0);

   glColorMaterial(GL_FRONT, GL_DIFFUSE);
   glEnable(GL_COLOR_MATERIAL);
}

void display(void)
{
   glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
   glColor4fv(diffuseMaterial);
   glPushMatrix();
   glTranslatef(-1.2, 0.0, 0.0);
   glutSolidSphere(1.0, 24, 20);
   glPopMatrix();

   glPushMatrix();
   glTranslatef(1.2, 0.0, 0.0);
   glRotatef(30.0, 1.0, 0.0, 0.0);
   glRotatef(-40.0, 0.0, 1.0, 0.0);
   glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
   cube(1.4);
   glColorMaterial(GL_FRONT, GL_DIFFUSE);
   glPopMatrix();
   glFlush();
}

void reshape(int w, int h)
{
   glViewport(0, 0, (GLsizei) w, (GLsizei) h);
   glMatrixMode(GL_PROJECTION);
   glLoadIdentity();
   glOrtho(-2.5 * w / h, 2.5 * w / h, -2.5, 2.5, -10.0, 10.0);
   glMatrixMode(GL_MODELVIEW);
   glLoadIdentity();
}

void mouse(int button, int state, int x, int y)
{
   switch (button) {
      case GLUT_LEFT_BUTTON:
         if (state == GLUT_DOWN) {
            diffuseMaterial[0] += 0.1;
            if (diffuseMaterial[0] > 1.0)
               diffuseMaterial[0] = 0.0;
            glColor4fv(diffuseMaterial);
            glutPostRedisplay();
         }
         break;
      default:
         break;
   }
}

int main(int argc, char** argv)
{
   glutInit(&argc, argv);
   glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
   glutInitWindowSize(500, 500);
   glutCreateWindow(argv[0]);
   init();
   glutDisplayFunc(display);
   glutReshapeFunc(reshape);
   glutMouseFunc(mouse);
   glutMainLoop();
   return 0;
}
