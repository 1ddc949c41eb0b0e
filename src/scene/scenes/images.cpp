#include "scene/scenes/images.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "base/image/file.h"
#include "base/image/png.h"
#include "scene/scenes/load.h"

namespace twinlight {

namespace {

namespace fs = std::filesystem;

// The path of the picture, with links followed.
fs::path place_of(const fs::path& folder, const std::string& name) {
    const bool is_bare = !name.empty() && name.find_first_of("/\\") == std::string::npos && name != "." && name != "..";
    if (!is_bare) {
        throw std::runtime_error(
            "a picture must be in the folder of the scene; give only its file name, such as \"brick.png\"");
    }
    std::error_code error;
    const fs::path home = fs::canonical(folder.empty() ? "." : folder, error);
    const fs::path file = error ? fs::path() : fs::canonical(home / name, error);
    if (error) throw std::runtime_error(error.message() + "; the picture must be in the folder of the scene");
    if (file.parent_path() != home) {
        throw std::runtime_error("this link points outside the folder of the scene; copy the picture into that folder");
    }
    if (!fs::is_regular_file(file, error)) throw std::runtime_error("this is not a file; give the name of a PNG file");
    return file;
}

ImageFile image_of(std::string_view bytes) {
    const PngPixels pixels = decode_png_pixels(bytes, kMaxImageSide);
    // The first row of a PNG is the top one, the first row of a GL image the bottom one.
    ImageFile image{pixels.width, pixels.height, std::vector<std::byte>(pixels.rgba.size())};
    const std::size_t row = static_cast<std::size_t>(pixels.width) * 4, rows = static_cast<std::size_t>(pixels.height);
    for (std::size_t y = 0; y < rows; ++y) {
        std::memcpy(image.rgba.data() + (rows - 1 - y) * row, pixels.rgba.data() + y * row, row);
    }
    return image;
}

ImageFile read_image(const fs::path& file) {
    const std::string bytes = read_file(file.string(), kMaxImageFileBytes + 1);
    if (bytes.size() > kMaxImageFileBytes) {
        throw std::runtime_error("the file has more than " + std::to_string(kMaxImageFileBytes >> 20) +
                                 " MiB; make the picture smaller");
    }
    return image_of(bytes);
}

bool is_built_in(const std::string& name) {
    return std::ranges::find(kSceneAssets, name, &EmbeddedFile::name) != kSceneAssets.end();
}

}  // namespace

ImageLoader images_beside(const fs::path& scene) {
    return [folder = scene.parent_path()](const std::string& name) {
        std::error_code ignored;
        if (is_built_in(name) && !fs::exists(folder / name, ignored)) return images_built_in(name);
        return read_image(place_of(folder, name));
    };
}

ImageFile images_built_in(const std::string& name) {
    if (!is_built_in(name)) return no_images(name);
    return image_of(std::ranges::find(kSceneAssets, name, &EmbeddedFile::name)->text);
}

}  // namespace twinlight
