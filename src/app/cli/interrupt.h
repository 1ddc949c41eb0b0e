// Ctrl-C as a question that long work asks between its pieces.
#pragma once

#include <csignal>

namespace twinlight::cli {

// While it lives, Ctrl-C is noted, once; a second one ends the program.
class Interrupt {
  public:
    Interrupt() {
        came_ = 0;
        struct sigaction action {};
        action.sa_handler = [](int) { came_ = 1; };
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(SIGINT, &action, &before_);
    }
    ~Interrupt() { sigaction(SIGINT, &before_, nullptr); }
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    static bool came() { return came_ != 0; }

  private:
    inline static volatile std::sig_atomic_t came_ = 0;  // the one kind of thing that a handler may write to
    struct sigaction before_ {};
};

}  // namespace twinlight::cli
