// Files that belong together, as texts before they are written.
#pragma once

#include <string>
#include <vector>

namespace twinlight {

struct NamedFile {
    std::string name;  // in its folder: "kind1.vert", "cases/vertex-w-2.c"
    std::string bytes;
};

// All of them, or none if the disk is full; the folder is created if it does not exist. Throws FileError.
void write_folder_atomically(const std::string& folder, const std::vector<NamedFile>& files);

}  // namespace twinlight
