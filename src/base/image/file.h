// Whole files: read in one go, written whole or not at all; and those that travel inside the binary.
#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace twinlight {

// tools/embed.sh writes tables of them.
struct EmbeddedFile {
    std::string_view name;  // without its folder
    std::string_view text;
};

// what() is one line: "path: reason".
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The file's bytes, but no more than `max_bytes` of them. Throws FileError.
std::string read_file(const std::string& path, std::size_t max_bytes = std::numeric_limits<std::size_t>::max());
std::string read_standard_input(std::size_t max_bytes);

struct FileToWrite {
    std::string path;
    std::string_view bytes;
};

// Writes all of them aside, each in its own folder, then renames: another program sees the old file or the new
// one, and where one cannot be written, none is. Ctrl-C waits until the files stand. A link is followed; a
// device or a pipe (/dev/null) is written to in place. Throws FileError, and then leaves nothing behind.
void write_files_atomically(const std::vector<FileToWrite>& files);
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace twinlight
