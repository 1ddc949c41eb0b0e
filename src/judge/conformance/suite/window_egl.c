/* A surface by EGL, without a window system: Mesa's surfaceless platform, a device, or the default display. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdlib.h>
#include <string.h>

#include "window.h"

static int has_word(const char* words, const char* word) {
    const size_t length = strlen(word);
    const char* at = words;
    while (at && (at = strstr(at, word)) != 0) {
        if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0)) return 1;
        at += length;
    }
    return 0;
}

static EGLDisplay initialised(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, 0, 0) && eglBindAPI(EGL_OPENGL_API) ? display
                                                                                                   : EGL_NO_DISPLAY;
}

static EGLDisplay open_display(void) {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const PFNEGLGETPLATFORMDISPLAYEXTPROC get_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    const PFNEGLQUERYDEVICESEXTPROC query_devices = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
    EGLDisplay display = EGL_NO_DISPLAY;
    if (get_display && has_word(extensions, "EGL_MESA_platform_surfaceless"))
        display = initialised(get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, 0));
    if (display == EGL_NO_DISPLAY && get_display && query_devices && has_word(extensions, "EGL_EXT_platform_device")) {
        EGLDeviceEXT devices[16];
        EGLint count = 0, i;
        query_devices(16, devices, &count);
        for (i = 0; i < count && display == EGL_NO_DISPLAY; ++i)
            display = initialised(get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], 0));
    }
    return display == EGL_NO_DISPLAY ? initialised(eglGetDisplay(EGL_DEFAULT_DISPLAY)) : display;
}

void draw_in_windows(int* argc, char** argv, int (*draw)(void), int (*status)(void)) {
    static const EGLint wanted[] = {EGL_SURFACE_TYPE,
                                    EGL_PBUFFER_BIT,
                                    EGL_RENDERABLE_TYPE,
                                    EGL_OPENGL_BIT,
                                    EGL_RED_SIZE,
                                    8,
                                    EGL_GREEN_SIZE,
                                    8,
                                    EGL_BLUE_SIZE,
                                    8,
                                    EGL_ALPHA_SIZE,
                                    8,
                                    EGL_DEPTH_SIZE,
                                    24,
                                    EGL_STENCIL_SIZE,
                                    8,
                                    EGL_NONE};
    static const EGLint size[] = {EGL_WIDTH, SIDE, EGL_HEIGHT, SIDE, EGL_NONE};
    const EGLDisplay display = open_display();
    EGLConfig config;
    EGLint count = 0;
    int more = 1;
    (void)argc;
    (void)argv;
    if (display == EGL_NO_DISPLAY) not_run("EGL has no display with OpenGL");
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0)
        not_run("EGL has no surface of 8 bits a channel with depth and stencil");
    while (more) {
        const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, 0);
        if (surface == EGL_NO_SURFACE || context == EGL_NO_CONTEXT ||
            !eglMakeCurrent(display, surface, surface, context))
            not_run("EGL creates no context of OpenGL");
        more = draw();
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
        eglDestroySurface(display, surface);
    }
    exit(status());
}

void (*window_function(const char* name))(void) { return (void (*)(void))eglGetProcAddress(name); }
