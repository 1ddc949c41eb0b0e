// GL's declarations, in the one place that includes them: functions come from whichever library the program links
// (OSMesa, libGL); GL_GLEXT_PROTOTYPES is set by the Makefile.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glu.h>
