#include "walls.h"

#include <GL/glut.h>

void draw_walls() {
    glScalef(0.5F, 0.5F, 0.5F);
    glutSolidCube(1);  // warning: scale-without-normalize
}
