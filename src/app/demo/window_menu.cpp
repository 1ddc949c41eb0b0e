#include "app/demo/window_menu.h"

#include <fmt/format.h>

#include <string>

#include "app/session/keys.h"
#include "render/context/gl.h"
#include "scene/command/names.h"

// freeglut's headers come after render/context/gl.h, which declares GL.
#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>
#include <GL/glx.h>
#include <X11/Xlib.h>

namespace twinlight::demo {

void WindowMenu::make(void (*press)(int code, void* data), void* data) {
    const int lights = glutCreateMenuUcall(press, data);
    for (int i = 0; i < kMaxLights; ++i)
        glutAddMenuEntry(fmt::format("{}    {}", i + 1, light_name(i)).c_str(), '1' + i);
    menu_ = glutCreateMenuUcall(press, data);
    for (const session::Key& row : session::keys()) {
        if (row.label.empty() || !row.in_menu) continue;
        const std::string line = fmt::format("{}    {}", row.label, row.what);
        if (row.first == '1')
            glutAddSubMenu(line.c_str(), lights);
        else
            glutAddMenuEntry(line.c_str(), row.first);
    }
}

// GLUT opens its menu when the button goes down, which would take the drag. So the menu is attached when a click turns out not
// to be a drag, and the click is sent again.
void WindowMenu::open(int x, int y) const {
    glutSetMenu(menu_);
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    Display* display = glXGetCurrentDisplay();
    XButtonEvent press{};
    press.type = ButtonPress;
    press.display = display;
    press.window = glXGetCurrentDrawable();
    press.root = DefaultRootWindow(display);
    press.same_screen = True;
    press.button = Button3;
    press.x = x;
    press.y = y;
    ::Window child = 0;
    XTranslateCoordinates(display, press.window, press.root, x, y, &press.x_root, &press.y_root, &child);
    XSendEvent(display, press.window, True, ButtonPressMask, reinterpret_cast<XEvent*>(&press));
    XFlush(display);
}

}  // namespace twinlight::demo
