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

// The extension of a file's name in small letters: ".png" of "Lamp.PNG".
std::string extension_of(const std::string& path);

// Throws FileError for a named pipe, which may have no writer, so that reading it would never end, and for a socket or a device in
// a folder of files. Names such as /dev/stdin and /dev/fd/3 are taken.
void refuse_special_file(const std::string& path);

// The file's first bytes, at most `max_bytes`. Throws FileError, also for special files.
std::string read_file(const std::string& path, std::size_t max_bytes = std::numeric_limits<std::size_t>::max());
std::string read_standard_input(std::size_t max_bytes);

struct FileToWrite {
    std::string path;
    std::string_view bytes;
};

enum class MissingFolders { kRefused, kMade };

// Writes all files without names, then gives them theirs. Another program sees either the old file or the new one.
// Several files are one result: old and new ones never lie side by side, even if the process is killed. As long as the
// last one exists, the result is whole, old or new. `stale`: files of the old result that the new one lacks; they are
// removed. If a file cannot be written, none is, and no folder is made. Ctrl-C waits until all files are in place. A
// link is followed; a device or a pipe (/dev/null) is written to directly. Throws FileError, and then leaves nothing.
void write_files_atomically(const std::vector<FileToWrite>& files, const std::vector<std::string>& stale = {},
                            MissingFolders missing = MissingFolders::kRefused);
void write_file_atomically(const std::string& path, std::string_view bytes);

// Throws FileError if nothing could be written into this folder, or if it could not be made. Makes nothing.
void try_folder(const std::string& path);

// Makes a folder, with those that it lies in. Returns false if it exists. Throws FileError.
bool make_folder(const std::string& path);

}  // namespace twinlight
