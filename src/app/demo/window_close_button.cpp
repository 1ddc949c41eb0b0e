#include "app/demo/window_close_button.h"

#include "render/context/gl.h"

// GLX comes after render/context/gl.h, which declares GL.
#include <GL/glx.h>
#include <X11/Xlib.h>

// Xlib's hook for what it reads from the server. Its header, Xlibint.h, has macros min and max.
extern "C" {
using WireToEvent = Bool (*)(Display*, XEvent*, void* wire);
WireToEvent XESetWireToEvent(Display*, int event, WireToEvent);
}

namespace twinlight::demo {
namespace {

struct CloseButton {
    WireToEvent read = nullptr;  // Xlib's own
    Atom wm_delete_window = None;
    void (*pressed)(void*) = nullptr;
    void* data = nullptr;
};

// Xlib's hook has no pointer for the caller.
CloseButton& close_button() {
    static CloseButton button;
    return button;
}

extern "C" Bool read_client_message(Display* display, XEvent* event, void* wire) {
    const CloseButton& button = close_button();
    const Bool is_event = button.read(display, event, wire);
    if (static_cast<Atom>(event->xclient.data.l[0]) == button.wm_delete_window) {
        event->xclient.data.l[0] = None;  // freeglut ignores such a message
        button.pressed(button.data);
    }
    return is_event;
}

}  // namespace

void take_close_button(void (*pressed)(void* data), void* data) {
    Display* const display = glXGetCurrentDisplay();
    CloseButton& button = close_button();
    button.wm_delete_window = XInternAtom(display, "WM_DELETE_WINDOW", False);
    button.pressed = pressed;
    button.data = data;
    button.read = XESetWireToEvent(display, ClientMessage, read_client_message);
}

}  // namespace twinlight::demo
