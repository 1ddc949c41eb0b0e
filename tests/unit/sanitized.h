// Whether the tests run under the address sanitizer, which takes memory as it likes and does not go with valgrind.
#pragma once

namespace twinlight {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace twinlight
