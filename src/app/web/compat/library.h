// Included before each file: what the C++ libraries of Emscripten 3.1 lack of C++20. Debian 12 has Emscripten 3.1.6 (libc++ 13),
// Debian 13 has 3.1.69 (libc++ 19).
#pragma once

#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>
#include <version>

#if _LIBCPP_VERSION < 15000
#include <cstring>

#include "app/web/compat/ranges.h"

namespace std {

template <class To, class From>
To bit_cast(const From& from) {
    static_assert(sizeof(To) == sizeof(From));
    To to;
    memcpy(&to, &from, sizeof to);
    return to;
}

}  // namespace std
#endif

// (13000 is libc++ 13, but 190000 is libc++ 19.)
#if _LIBCPP_VERSION < 200000
namespace std {

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
    const string_view text(first, static_cast<size_t>(last - first));
    const string number(text.substr(0, text.find_first_not_of("-.0123456789eE+")));
    char* end = nullptr;
    const double read = strtod(number.c_str(), &end);  // musl's rounds correctly
    if (end == number.c_str()) return {first, errc::invalid_argument};
    // Too large, or too small but not written as 0.
    const bool is_zero = number.find_first_of("123456789") >= number.find_first_of("eE");
    const errc error = read - read != 0 || (read == 0 && !is_zero) ? errc::result_out_of_range : errc{};
    if (error == errc{}) value = read;
    return {first + (end - number.c_str()), error};
}

}  // namespace std
#endif

#if !defined(__cpp_lib_jthread)
namespace std {

// The module has one thread: the page's own workers run it side by side.
class jthread {
  public:
    template <class Function>
    explicit jthread(Function function) {
        function();
    }
};

}  // namespace std
#endif
