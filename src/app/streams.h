// The three standard streams, which may be closed, full, or pipes that nobody reads.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace twinlight {

// Called first in main(). Afterwards no file that the program opens takes the place of a closed stream, and writing to a pipe
// without a reader, or beyond the largest size of a file (ulimit -f), is an error, not the end of the program.
void prepare_streams();

// Writes to standard error. Where that fails the message is lost, and the program goes on.
inline void write_message(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }
template <class... T>
void print_message(fmt::format_string<T...> format, T&&... values) {
    write_message(fmt::format(format, std::forward<T>(values)...));
}

// Writes all of `bytes` to standard output. Throws FileError.
void write_result(std::string_view bytes);

}  // namespace twinlight
