// GLUT's menu of the keys, which a click with the right button opens.
#pragma once

namespace twinlight::demo {

class WindowMenu {
  public:
    // GLUT calls `press` with the code of the chosen key and `data`. Needs the window.
    void make(void (*press)(int code, void* data), void* data);
    // Where the right button was clicked, in the window.
    void open(int x, int y) const;

  private:
    int menu_ = 0;
};

}  // namespace twinlight::demo
