/* A hard case of lighting: a scene, and the colours that OpenGL 2.1 requires. Each file in cases/ defines one. */
#ifndef HARD_CASE_H
#define HARD_CASE_H

#ifdef _WIN32
#include <windows.h>
#endif
#ifdef __APPLE__
#include <OpenGL/gl.h>
#include <OpenGL/glext.h>
#else
#include <GL/gl.h>
#include <GL/glext.h>
#endif
#include <math.h>
#include <stddef.h>

#include "functions.h"

/* What a place must show. Each channel may have either of two values: they differ where the formula jumps and rounding decides. */
struct expected {
    const char* place;         /* "vertex 0", "pixel 31,32" (from the top left) */
    double x, y;               /* in a window of 1 x 1 (a vertex) or of 64 x 64 pixels, from the lower left corner */
    double color[4], other[4]; /* of a vertex: before the clamp of section 2.14.6 */
    double shown[4], other_shown[4]; /* as a pixel shows it: primary plus secondary colour, clamped */
};

struct hard_case {
    const char *name, *what, *section;
    void (*draw)(void);
    enum { OF_VERTICES, OF_PIXELS } kind;
    int is_of_polygons; /* the last primitive is one; only for vertices */
    int is_open;        /* OpenGL leaves the answer open: `expected` is one of several */
    double tolerance;   /* relative to the larger of 1 and the value */
    GLenum error;       /* of glGetError afterwards */
    int count;
    const struct expected* expected;
    const char* no_pixel; /* why a pixel cannot show it; 0: it can */
};

extern const struct hard_case* const hard_cases[]; /* ends with 0 */

#ifdef ALL_CASES
#define HARD_CASE(name) static const struct hard_case name
#else
#define HARD_CASE(name)                                        \
    extern const struct hard_case name;                        \
    const struct hard_case* const hard_cases[] = {&(name), 0}; \
    const struct hard_case name
#endif

#endif
