// Reads and writes whole files. A file is written completely or not at all.
#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace twinlight {

// what() is one line: "path: reason".
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The file's first bytes, at most `max_bytes`. Throws FileError.
std::string read_file(const std::string& path, std::size_t max_bytes = std::numeric_limits<std::size_t>::max());
std::string read_standard_input(std::size_t max_bytes);

struct FileToWrite {
    std::string path;
    std::string_view bytes;
};

// Writes all files under temporary names, each in its own folder, then renames them. Another program sees either the
// old file or the new one. Several files are one result: old and new ones never lie side by side, even if the process is
// killed. As long as the last one exists, the result is whole, old or new. `stale`: files of the old result that the new
// one lacks; they are removed. If a file cannot be written, none is. Ctrl-C waits until all files are in place. A link
// is followed; a device or a pipe (/dev/null) is written to directly. Throws FileError, and then leaves no temporary
// file behind.
void write_files_atomically(const std::vector<FileToWrite>& files, const std::vector<std::string>& stale = {});
void write_file_atomically(const std::string& path, std::string_view bytes);

// Makes a folder, with those that it lies in. Returns false if it exists. Throws FileError.
bool make_folder(const std::string& path);

}  // namespace twinlight
