// Meshes: any text is an OBJ file whose triangles are inside its arrays, or one clear line. What follows a form feed is its MTL
// file.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "scene/mesh/obj.h"

using namespace twinlight;

namespace {

ImageFile image(const std::string&) { return {1, 1, std::vector<std::byte>(4)}; }

void check(const Mesh& mesh) {
    const std::size_t vertices = mesh.vertex_count();
    const std::size_t floats = vertices * (mesh.has_tex_coords ? 8 : 6);
    if (mesh.triangle_count() == 0 || mesh.vertices->bytes.size() != floats * sizeof(float)) std::abort();
    for (std::size_t i = 0; i < floats; ++i) {
        float value = 0;
        std::memcpy(&value, mesh.vertices->bytes.data() + i * sizeof value, sizeof value);
        if (!std::isfinite(value)) std::abort();
    }
    for (const MeshPart& part : mesh.parts) {
        for (std::size_t at = 0; at < part.indices->bytes.size(); at += sizeof(std::uint32_t)) {
            std::uint32_t index = 0;
            std::memcpy(&index, part.indices->bytes.data() + at, sizeof index);
            if (index >= vertices) std::abort();
        }
        if (part.material && !(part.material->shininess >= 0 && part.material->shininess <= 128)) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::size_t end = std::min(text.find('\f'), text.size());
    const std::string materials(text.substr(std::min(end + 1, text.size())));
    try {
        check(*read_obj(text.substr(0, end), {.text = [&](const std::string&) { return materials; }, .image = image}));
    } catch (const std::runtime_error& error) {
        for (const char c : std::string_view(error.what()))
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) std::abort();
    }
    return 0;
}
