#include "render/webgpu/ported_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "render/programmable/export/c_text.h"
#include "render/programmable/export/core_elements.h"
#include "render/programmable/export/kept_code.h"
#include "render/webgl/exported_page.h"
#include "render/webgl/webgl_frame.h"
#include "render/webgpu/blocks.h"
#include "render/webgpu/scene_data.h"
#include "render/webgpu/vulkan_text.h"
#include "render/webgpu/wgsl_text.h"

namespace twinlight::webgpu {
namespace {

bool has_pixels(const FrameItem& item) {
    const Draw* draw = std::get_if<Draw>(&item);
    return draw && draw->pixels;
}

// The frame without what these APIs lack and shaders do not replace: lines have one pixel, points are squares, in WebGPU of one pixel. Notes
// what changes.
Frame with_thin_lines(const Frame& given, Target target, std::set<std::string>& notes) {
    Frame frame = given;
    if (target == Target::kWgsl && std::erase_if(frame.items, has_pixels) > 0)
        notes.insert("glBitmap and glDrawPixels draw nothing; use a texture");
    for (Draw* draw : frame.editable_draws()) {
        RasterState& raster = draw->raster;
        if ((draw->draws_lines() || draw->draws_borders()) &&
            (raster.line_width > 1 || raster.line_smooth || raster.line_stipple))
            notes.insert("lines have a width of one pixel, without glLineWidth, GL_LINE_SMOOTH and glLineStipple");
        raster.line_width = 1;
        raster.line_smooth = false;
        raster.line_stipple.reset();
        if (draw->draws_points() && raster.point_smooth) notes.insert("points are squares, without GL_POINT_SMOOTH");
        raster.point_smooth = false;
        if (target == Target::kWgsl && draw->draws_points() && programmable::point_size(*draw) > 1)
            notes.insert("points have one pixel, without glPointSize");
    }
    return frame;
}

std::vector<Kind> kinds_of(const Json& programs) {
    std::vector<Kind> kinds;
    for (const Json& program : programs)
        kinds.push_back({read_shader(program["vertex"].get<std::string>()),
                         read_shader(program["fragment"].get<std::string>()),
                         program["attributes"].get<std::vector<int>>()});
    return kinds;
}

// What a pipeline needs to know of a kind.
Json kind_json(const Kind& kind, const Blocks& blocks, std::vector<std::string> files) {
    Json attributes = Json::array(), bindings = Json::array(), textures = Json::array();
    int offset = 0;
    for (std::size_t i = 0; i < kind.vertex.inputs.size(); ++i) {
        const Variable& input = kind.vertex.inputs[i];
        const std::string size = input.type == "float" ? "" : "x" + input.type.substr(3);
        attributes.push_back({{"name", input.name},
                              {"shaderLocation", input.location},
                              {"offset", offset},
                              {"format", "float32" + size}});
        offset += 4 * kind.attribute_floats.at(i);
    }
    for (const Block* block : blocks.of(uniforms_of(kind))) bindings.push_back(block->binding);
    for (const Variable& uniform : kind.fragment.uniforms)
        if (is_sampler(uniform)) textures.push_back(binding_of_texture(uniform));
    return {{"files", std::move(files)},
            {"arrayStride", offset},
            {"attributes", std::move(attributes)},
            {"blocks", std::move(bindings)},
            {"textures", std::move(textures)}};
}

// JSON with a line for each element of these lists, and of the lists in them.
std::string in_lines(const Json& json, const std::string& indent = "") {
    const bool is_long = json.is_structured() && !json.empty() && dumped(json).size() > 120 &&
                         std::ranges::any_of(json, [](const Json& one) { return one.is_structured(); });
    if (!is_long) return dumped(json);
    const std::string inner = indent + "  ";
    std::string text;
    for (const auto& [key, value] : json.items()) {
        text += (text.empty() ? "" : ",\n") + inner;
        if (json.is_object()) text += dumped(key) + ": ";
        text += in_lines(value, inner);
    }
    return (json.is_object() ? "{\n" : "[\n") + text + "\n" + indent + (json.is_object() ? "}" : "]");
}

std::string missing_text(const std::set<std::string>& missing) {
    if (missing.empty()) return "";
    std::string text = "\nThe picture differs from OpenGL's:\n\n";
    for (const std::string& one : missing) text += fmt::format("- {}\n", one);
    return text;
}

std::string readme(const std::string& name, Target target, const std::set<std::string>& missing) {
    const bool wgsl = target == Target::kWgsl;
    const std::string how =
        wgsl ? "    python3 -m http.server    # then open http://localhost:8000 in a browser with WebGPU\n\n"
             : "    glslangValidator -V kind1.vert -o kind1.vert.spv    # the same for each file: SPIR-V\n\n";
    const std::string files =
        wgsl
            ? "- `kindN.wgsl`: a module for each kind of material and set of lights, with `vertex_main` and "
              "`fragment_main`."
            : "- `kindN.vert`, `kindN.frag`: GLSL 4.50 for Vulkan, a pair for each kind of material and set of lights.";
    const std::string clip =
        wgsl ? "- The projection matrix is GL's: the last lines of `vertex_main` bring z from [-w, w] to [0, w]."
             : "- The projection matrix is GL's: the last lines of the vertex shaders turn y down and bring z from "
               "[-w, w] to [0, w]. "
               "Without the first of these lines, give the viewport a negative height.";
    return fmt::format(
        "# Shaders of {}\n\n{}{} They stay right when objects, lights and the camera move.\n"
        "- `layout.json`: for each buffer its binding (group or set 0) and size, and for each member its offset, its "
        "type "
        "and the state of GL that it holds. All kinds have the same buffers. Then for each kind its files, vertex "
        "attributes and bindings{}.\n"
        "- `scene.json`, `scene.bin`: this picture. The state has the names of `layout.json`; places are counted in 4 "
        "bytes of `scene.bin`. Pipelines are in WebGPU's words. Viewports and scissors count from the top.\n"
        "{}\n"
        "- In flat shading the first vertex of a primitive gives the colour; `scene.bin` has GL's last one first.\n"
        "{}{}",
        programmable::printable(name), how, files, wgsl ? "; a texture's sampler has the next binding" : "", clip,
        wgsl ? "- `index.html`: draws the scene.\n" : "", missing_text(missing));
}

std::string text_of_page() {
    return std::string(std::ranges::find(kWebglFiles, "webgpu.html", &EmbeddedFile::name)->text);
}

}  // namespace

std::vector<NamedFile> ported_files(const Frame& frame, const Look& look, Target target, const std::string& name) {
    if (const std::string why = programmable::why_not_kept(frame); !why.empty()) throw std::runtime_error(why);
    PlanOptions options{look};
    options.for_any_pose = true;
    std::set<std::string> missing;
    programmable::ExportWords words;
    const Json header = webgl::webgl_header(with_thin_lines(frame, target, missing), options, words, true);
    for (const Json& one : header["missing"])
        missing.insert(fmt::format("{} (line {})", one["message"].get<std::string>(), one["line"].get<int>()));
    std::vector<Kind> kinds = kinds_of(header["programs"]);
    if (target == Target::kWgsl)
        for (Kind& kind : kinds) remove_point_size(kind.vertex);
    for (const Kind& kind : kinds)
        if (const std::string why = target == Target::kWgsl ? why_not_in_wgsl(kind) : why_not_in_vulkan(kind);
            !why.empty())
            throw std::runtime_error("it has " + why);
    const Blocks blocks(kinds);
    const SceneData scene = scene_data(header, words.all, target == Target::kVulkan);

    std::vector<NamedFile> files;
    Json layout = {{"blocks", Json::array()}, {"kinds", Json::array()}};
    for (const Block& block : blocks.all()) layout["blocks"].push_back(blocks.json(block));
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const std::string kind = fmt::format("kind{}", i + 1);
        const std::size_t first = files.size();
        if (target == Target::kWgsl) {
            files.push_back({kind + ".wgsl", wgsl_module(kinds[i], blocks)});
        } else {
            files.push_back({kind + ".vert", vulkan_vertex_shader(kinds[i], blocks)});
            files.push_back({kind + ".frag", vulkan_fragment_shader(kinds[i], blocks)});
        }
        std::vector<std::string> names;
        for (std::size_t j = first; j < files.size(); ++j) names.push_back(files[j].name);
        layout["kinds"].push_back(kind_json(kinds[i], blocks, std::move(names)));
    }
    files.push_back({"layout.json", in_lines(layout) + "\n"});
    files.push_back({"scene.json", in_lines(scene.json) + "\n"});
    files.push_back(
        {"scene.bin", {reinterpret_cast<const char*>(scene.words.data()), 4 * scene.words.size()}});  // NOLINT
    if (target == Target::kWgsl) files.push_back({"index.html", text_of_page()});
    files.push_back({"README.md", readme(name, target, missing)});
    return files;
}

}  // namespace twinlight::webgpu
