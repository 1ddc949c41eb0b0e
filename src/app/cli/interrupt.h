// Ctrl-C sets a flag, which long work checks between its pieces.
#pragma once

#include <csignal>

namespace twinlight::cli {

// While an Interrupt exists, the first Ctrl-C sets the flag; a second one ends the program.
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
    inline static volatile std::sig_atomic_t came_ = 0;  // the only type that a signal handler may write to
    struct sigaction before_ {};
};

}  // namespace twinlight::cli
