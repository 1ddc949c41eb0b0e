// GL's declarations: the only place that includes them. The functions come from the library that the program loads (entry_points.h),
// or links, as the window does; the Makefile sets GL_GLEXT_PROTOTYPES.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glu.h>
