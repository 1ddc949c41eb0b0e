// The three standard streams, which may be closed, full, or pipes that nobody reads.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace twinlight {

// Called first in main(). Afterwards no file that the program opens takes the place of a closed stream, and writing to a pipe
// without a reader, or beyond the largest size of a file (ulimit -f), is an error, not the end of the program.
void prepare_streams();

// Writes to standard error. If it cannot be written, nothing else changes, because nobody would read of that either.
void write_message(std::string_view text);
template <class... T>
void print_message(fmt::format_string<T...> format, T&&... values) {
    write_message(fmt::format(format, std::forward<T>(values)...));
}

// Writes all of `bytes` to standard output. Throws FileError.
void write_result(std::string_view bytes);

}  // namespace twinlight
