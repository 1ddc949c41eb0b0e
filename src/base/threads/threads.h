// Work on several threads. The system may give none, or too little memory for one: then the caller's thread does the work.
#pragma once

#include <functional>
#include <thread>

namespace twinlight {

// Calls piece(0) to piece(count - 1), each once and in any order, on all processors. If one throws, the pieces that have not begun are
// left out, and the first exception leaves this call when all threads have ended.
void for_each_on_threads(int count, const std::function<void(int)>& piece);

// Starts a thread. If the system gives none, the result is not joinable. `work` must not throw: that would end the program.
std::thread try_start_thread(std::function<void()> work);

}  // namespace twinlight
