/* A window of Windows, by WGL. */
#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include "window.h"

void draw_in_windows(int* argc, char** argv, int (*draw)(void), int (*status)(void)) {
    WNDCLASSA window_class;
    PIXELFORMATDESCRIPTOR format;
    RECT outer = {0, 0, SIDE, SIDE};
    HWND window;
    HDC device;
    int number, more = 1;
    (void)argc;
    (void)argv;
    memset(&window_class, 0, sizeof window_class);
    window_class.style = CS_OWNDC;
    window_class.lpfnWndProc = DefWindowProcA;
    window_class.hInstance = GetModuleHandleA(0);
    window_class.lpszClassName = "hard case";
    RegisterClassA(&window_class);
    memset(&format, 0, sizeof format);
    format.nSize = sizeof format;
    format.nVersion = 1;
    format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER;
    format.iPixelType = PFD_TYPE_RGBA;
    format.cColorBits = 32;
    format.cAlphaBits = 8;
    format.cDepthBits = 24;
    format.cStencilBits = 8;
    AdjustWindowRect(&outer, WS_OVERLAPPEDWINDOW, FALSE);
    window = CreateWindowA("hard case", "hard case", WS_OVERLAPPEDWINDOW | WS_VISIBLE, 0, 0, outer.right - outer.left,
                           outer.bottom - outer.top, 0, 0, window_class.hInstance, 0);
    device = window ? GetDC(window) : 0;
    if (!device) not_run("Windows opens no window");
    number = ChoosePixelFormat(device, &format);
    if (!number || !SetPixelFormat(device, number, &format)) not_run("Windows has no pixel format for OpenGL");
    while (more) {
        const HGLRC context = wglCreateContext(device);
        if (!context || !wglMakeCurrent(device, context)) not_run("WGL creates no context");
        more = draw();
        wglMakeCurrent(0, 0);
        wglDeleteContext(context);
    }
    exit(status());
}

void (*window_function(const char* name))(void) { return (void (*)(void))wglGetProcAddress(name); }
