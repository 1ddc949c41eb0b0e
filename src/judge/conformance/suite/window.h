/* The one thing that differs between systems: a window, or a surface, with a context of GL. */
#ifndef WINDOW_H
#define WINDOW_H

/* Sides of the window in pixels. */
#define SIDE 64

/* Calls draw() with a new current context on a window: 8 bits a channel, depth, stencil. Repeats that with another context while
   draw() returns 1. Then ends the program with exit(status()). Ends it with not_run() if there is no window. */
void draw_in_windows(int* argc, char** argv, int (*draw)(void), int (*status)(void));

/* A function of GL by its name; 0 if there is none. */
void (*window_function(const char* name))(void);

/* In hard_case.c: prints why the cases could not be run, and ends the program with 77. */
void not_run(const char* why);

#endif
