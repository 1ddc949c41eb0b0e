#include "scene/scenes/images.h"

#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "base/image/png.h"
#include "base/text/translation.h"
#include "scene/scenes/beside.h"

namespace twinlight {

namespace {

namespace fs = std::filesystem;

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

}  // namespace

ImageLoader images_beside(const fs::path& scene) {
    return [folder = scene.parent_path()](const std::string& name) {
        return image_of(read_beside(folder, name, tr("picture"), "brick.png", kMaxImageFileBytes));
    };
}

ImageLoader images_in(FileFinder find) {
    return [find = std::move(find)](const std::string& name) {
        const auto file = find(name);
        return file ? image_of(*file) : no_images(name);
    };
}

ImageFile images_built_in(const std::string& name) { return images_in(built_in_file)(name); }

}  // namespace twinlight
