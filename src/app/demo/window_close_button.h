// The window's close button. freeglut destroys a window whose button was pressed, without a question; this asks instead.
#pragma once

namespace twinlight::demo {

// From now on, `pressed` is called when the button was pressed, and the window stays. It is called while Xlib reads an event, so it may only
// set a flag. Needs the window.
void take_close_button(void (*pressed)(void* data), void* data);

}  // namespace twinlight::demo
