// GLUT for one picture: EGL's surfaceless platform in place of a window. glutMainLoop() draws once, writes picture.ppm and ends.
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/freeglut.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int width = 300, height = 300, major = 1, minor = 0, profile;
static void (*draw)(void);

void glutInit(int* argc, char** argv) { (void)argc, (void)argv; }
void glutInitDisplayMode(unsigned mode) { (void)mode; }
void glutInitWindowSize(int w, int h) { width = w, height = h; }
void glutInitContextVersion(int a, int b) { major = a, minor = b; }
void glutInitContextProfile(int which) { profile = which; }
void glutDisplayFunc(void (*function)(void)) { draw = function; }
void glutSwapBuffers(void) {}

static void check(int holds, const char* what) {
    if (holds) return;
    fprintf(stderr, "glut_on_egl: %s failed: 0x%x\n", what, (unsigned)eglGetError());
    exit(1);
}

// A framebuffer with rows as a window has them: llvmpipe rounds interpolated values differently the other way up.
static void make_framebuffer(void) {
    GLuint framebuffer, buffers[2];
    GLint count = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenRenderbuffers(2, buffers);
    for (int i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, i == 0 ? GL_RGBA8 : GL_DEPTH24_STENCIL8, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_STENCIL_ATTACHMENT,
                                  GL_RENDERBUFFER, buffers[i]);
    }
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (int i = 0; i < count; ++i)
        if (strcmp((const char*)glGetStringi(GL_EXTENSIONS, (GLuint)i), "GL_MESA_framebuffer_flip_y") == 0)
            glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_FLIP_Y_MESA, GL_TRUE);
    glViewport(0, 0, width, height);
}

int glutCreateWindow(const char* title) {
    const EGLint context[] = {EGL_CONTEXT_MAJOR_VERSION,
                              major,
                              EGL_CONTEXT_MINOR_VERSION,
                              minor,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              profile == GLUT_CORE_PROFILE ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                                           : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                              EGL_NONE};
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    (void)title;
    check(display != EGL_NO_DISPLAY && eglInitialize(display, NULL, NULL) && eglBindAPI(EGL_OPENGL_API),
          "eglInitialize");
    const EGLContext made = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, context);
    check(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, made), "eglMakeCurrent");
    make_framebuffer();
    return 1;
}

void glutMainLoop(void) {
    unsigned char* pixels = malloc((size_t)width * (size_t)height * 3);
    FILE* file = fopen("picture.ppm", "wb");
    draw();
    check(pixels && file && glGetError() == GL_NO_ERROR, "the picture");
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    fprintf(file, "P6 %d %d 255\n", width, height);
    for (int y = height - 1; y >= 0; --y) fwrite(pixels + (size_t)y * (size_t)width * 3, 3, (size_t)width, file);
    check(fclose(file) == 0, "picture.ppm");
    exit(0);
}
