// What a program says when a signal such as SIGSEGV ends it.
#pragma once

#include <string_view>

namespace twinlight {

// From now on, a crash writes one line to standard error: the signal, whose code it was in (the GL driver's, this program's, another
// library's), as far as the stack shows it, and what to do. The program then still ends by the signal.
void report_crashes(std::string_view program);

}  // namespace twinlight
