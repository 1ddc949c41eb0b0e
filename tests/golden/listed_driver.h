// The driver on which golden/known_differences was measured.
#pragma once

namespace twinlight {

// Whether the current context's driver is that one. It must show every departure of the list; another driver may have
// mended some.
bool is_listed_driver();

}  // namespace twinlight
