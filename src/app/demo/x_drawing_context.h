// A GL context without a window, on a connection to X of its own, so that a thread can draw beside the window.
#pragma once

#include <memory>

namespace twinlight::demo {

class DrawingContext {
  public:
    // Like the window's: eight bits for each colour and alpha, depth and stencil. Throws std::runtime_error if X gives none.
    DrawingContext();
    ~DrawingContext();
    DrawingContext(const DrawingContext&) = delete;
    DrawingContext& operator=(const DrawingContext&) = delete;

    // To be called before the program's first call of X.
    static void allow_threads();

    // Makes it current in this thread, with buffers of this size.
    void make_current(int width, int height);

  private:
    struct X;
    std::unique_ptr<X> x_;
};

}  // namespace twinlight::demo
