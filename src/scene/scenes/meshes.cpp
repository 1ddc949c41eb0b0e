#include "scene/scenes/meshes.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/text/translation.h"
#include "scene/mesh/obj.h"
#include "scene/scenes/beside.h"
#include "scene/scenes/images.h"

namespace twinlight {

MeshLoader meshes_beside(const std::filesystem::path& scene) {
    return [scene](const std::string& name) {
        const auto material = [folder = scene.parent_path()](const std::string& file) {
            return read_beside(folder, file, tr("material file"), "bunny.mtl", kMaxMtlBytes);
        };
        return read_obj(read_beside(scene.parent_path(), name, tr("mesh"), "bunny.obj", kMaxObjBytes),
                        {.text = material, .image = images_beside(scene)});
    };
}

MeshLoader meshes_in(FileFinder find) {
    return [find = std::move(find)](const std::string& name) {
        const auto text_of = [&find](const std::string& file) {
            const auto text = find(file);
            if (!text) throw std::runtime_error(tr("there is no file of this name"));
            return std::string(*text);
        };
        if (!find(name)) return no_meshes(name);
        return read_obj(text_of(name), {.text = text_of, .image = images_in(find)});
    };
}

std::shared_ptr<const Mesh> meshes_built_in(const std::string& name) { return meshes_in(built_in_file)(name); }

}  // namespace twinlight
