#include "base/image/named_file.h"

#include <filesystem>

#include "base/image/file.h"

namespace twinlight {

void write_folder_atomically(const std::string& folder, const std::vector<NamedFile>& files) {
    std::vector<FileToWrite> to_write;
    for (const NamedFile& file : files)
        to_write.push_back({(std::filesystem::path(folder) / file.name).string(), file.bytes});
    write_files_atomically(to_write, {}, MissingFolders::kMade);
}

}  // namespace twinlight
