#include "render/webgpu/scene_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/math/normal_matrix.h"
#include "render/programmable/export/core_elements.h"
#include "render/programmable/export/export_words.h"
#include "render/webgl/kept_values.h"
#include "render/webgpu/blocks.h"
#include "scene/frame/frame.h"

namespace twinlight::webgpu {
namespace {

// ---- GL's enumerants in WebGPU's words ----

std::string word_of(Enum value) {
    static const std::map<Enum, const char*> kWords = {
        {kGL_NEVER, "never"},
        {kGL_LESS, "less"},
        {kGL_EQUAL, "equal"},
        {kGL_LEQUAL, "less-equal"},
        {kGL_GREATER, "greater"},
        {kGL_NOTEQUAL, "not-equal"},
        {kGL_GEQUAL, "greater-equal"},
        {kGL_ALWAYS, "always"},
        {kGL_KEEP, "keep"},
        {kGL_REPLACE, "replace"},
        {kGL_INVERT, "invert"},
        {kGL_INCR, "increment-clamp"},
        {kGL_DECR, "decrement-clamp"},
        {kGL_INCR_WRAP, "increment-wrap"},
        {kGL_DECR_WRAP, "decrement-wrap"},
        {kGL_SRC_COLOR, "src"},
        {kGL_ONE_MINUS_SRC_COLOR, "one-minus-src"},
        {kGL_SRC_ALPHA, "src-alpha"},
        {kGL_ONE_MINUS_SRC_ALPHA, "one-minus-src-alpha"},
        {kGL_DST_COLOR, "dst"},
        {kGL_ONE_MINUS_DST_COLOR, "one-minus-dst"},
        {kGL_DST_ALPHA, "dst-alpha"},
        {kGL_ONE_MINUS_DST_ALPHA, "one-minus-dst-alpha"},
        {kGL_SRC_ALPHA_SATURATE, "src-alpha-saturated"},
        {kGL_CONSTANT_COLOR, "constant"},
        {kGL_ONE_MINUS_CONSTANT_COLOR, "one-minus-constant"},
        {kGL_FUNC_ADD, "add"},
        {kGL_FUNC_SUBTRACT, "subtract"},
        {kGL_FUNC_REVERSE_SUBTRACT, "reverse-subtract"},
        {kGL_MIN, "min"},
        {kGL_MAX, "max"},
        {kGL_FRONT, "front"},
        {kGL_BACK, "back"},
        {kGL_CCW, "ccw"},
        {kGL_CW, "cw"},
        {kGL_NEAREST, "nearest"},
        {kGL_LINEAR, "linear"},
        {kGL_REPEAT, "repeat"},
        {kGL_MIRRORED_REPEAT, "mirror-repeat"},
        {kGL_CLAMP_TO_EDGE, "clamp-to-edge"},
    };
    const auto found = kWords.find(value);
    if (found == kWords.end())
        throw std::runtime_error(fmt::format("a state that WebGPU lacks (enumerant {:#x})", value));
    return found->second;
}
// 0 and 1 are GL_ZERO and GL_ONE.
std::string factor_of(Enum value) { return value == 0 ? "zero" : value == 1 ? "one" : word_of(value); }
std::string operation_of(Enum value) { return value == 0 ? "zero" : word_of(value); }

// ---- Uniforms that others determine ----

glm::dmat4 matrix_of(const Json& list) {
    glm::dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = list[static_cast<std::size_t>(i)];
    return m;
}
Json short_numbers(const Json& list) {
    Json result = Json::array();
    for (const Json& one : list) result.push_back(webgl::short_number(one.get<double>()));
    return result;
}
template <class Matrix>
Json list_of_columns(const Matrix& m) {
    Json list = Json::array();
    for (int column = 0; column < Matrix::length(); ++column)
        for (int row = 0; row < Matrix::length(); ++row) list.push_back(webgl::short_number(m[column][row]));
    return list;
}

Json with_computed(const Json& given) {
    Json state = Json::object();
    for (const auto& [name, values] : given.items()) {
        if (name == "ModelViewMatrix") {
            const glm::dmat4 m = matrix_of(values);
            const glm::dmat3 normals = normal_matrix(glm::dmat3(m));
            const double third = glm::length(normals[2]);
            state["ModelViewProjectionMatrix"] = list_of_columns(matrix_of(given["ProjectionMatrix"]) * m);
            state["ModelViewMatrix"] = list_of_columns(m);
            state["NormalMatrix"] = list_of_columns(normals);
            state["NormalScale"] = {webgl::short_number(third > 0 ? 1 / third : 1)};
        } else if (name.ends_with(".position")) {
            const glm::dvec3 position(values[0], values[1], values[2]);
            const glm::dvec3 sum = position + glm::dvec3(0, 0, glm::length(position));
            const double size = glm::length(sum);
            const glm::dvec3 half = size > 0 ? sum / size : sum;
            state[name] = values;
            state[name.substr(0, name.size() - 8) + "halfVector"] = short_numbers({half.x, half.y, half.z, 0});
        } else if (name != "ProjectionMatrix") {
            state[name] = short_numbers(values);
        }
    }
    return state;
}

// ---- Primitives as lists, of which WebGPU has triangle-list, line-list and point-list ----

struct List {
    const char* topology;
    std::vector<std::uint32_t> indices;
};
// The last vertex of a primitive, whose colour counts in flat shading (section 2.14.7), comes first: there it counts in WebGPU and Vulkan.
List list_of(Enum mode, const std::uint32_t* first, std::size_t count) {
    auto [separate, indices] = programmable::separate_elements({mode, {first, first + count}});
    const std::ptrdiff_t size = separate == kGL_TRIANGLES ? 3 : separate == kGL_LINES ? 2 : 1;
    for (auto at = indices.begin(); at != indices.end(); at += size) std::rotate(at, at + size - 1, at + size);
    return {size == 3 ? "triangle-list" : size == 2 ? "line-list" : "point-list", std::move(indices)};
}

// ---- The scene ----

class Scene {
  public:
    Scene(const Json& header, const std::vector<std::uint32_t>& words, bool allows_formats)
        : header_(header),
          given_(words),
          allows_formats_(allows_formats),
          width_(header["width"]),
          height_(header["height"]) {}

    SceneData data() {
        Json textures = Json::array(), state = Json::array(), items = Json::array();
        for (const Json& texture : header_["textures"]) textures.push_back(texture_of(texture));
        for (const Json& group : header_["uniforms"]) state.push_back(with_computed(group));
        for (const Json& item : header_["items"]) {
            if (item.contains("accumulate")) throw std::runtime_error("the accumulation buffer (glAccum)");
            if (item.contains("clear"))
                items.push_back(clear_of(item));
            else
                for (Json& draw : draws_of(item)) items.push_back(std::move(draw));
        }
        Json json = {{"width", width_},
                     {"height", height_},
                     {"textures", std::move(textures)},
                     {"state", std::move(state)},
                     {"pipelines", std::move(pipelines_)},
                     {"items", std::move(items)}};
        return {std::move(json), std::move(words_.all)};
    }

  private:
    std::size_t copied(std::size_t first, std::size_t count) {
        const auto begin = given_.begin() + static_cast<std::ptrdiff_t>(first);
        return words_.place_of(std::vector<std::uint32_t>(begin, begin + static_cast<std::ptrdiff_t>(count))).first;
    }

    Json texture_of(const Json& texture) {
        const Enum target = texture["target"];
        const std::string format = texture["format"];
        if (format != "rgba8" && !allows_formats_)
            throw std::runtime_error("a depth texture, or one whose texels are not of 8 bits a channel");
        const bool is_cube = target == kGL_TEXTURE_CUBE_MAP;
        std::map<Enum, Json> parameters;
        for (const Json& row : texture["parameters"]) parameters[row[0].get<Enum>()] = row[1];
        const Enum min_filter = parameters[kGL_TEXTURE_MIN_FILTER];
        const bool has_mipmaps = min_filter != kGL_NEAREST && min_filter != kGL_LINEAR;
        const bool is_linear = min_filter == kGL_LINEAR || min_filter == kGL_LINEAR_MIPMAP_NEAREST ||
                               min_filter == kGL_LINEAR_MIPMAP_LINEAR;
        const bool between = min_filter == kGL_NEAREST_MIPMAP_LINEAR || min_filter == kGL_LINEAR_MIPMAP_LINEAR;
        Json sampler = {{"magFilter", word_of(parameters[kGL_TEXTURE_MAG_FILTER])},
                        {"minFilter", is_linear ? "linear" : "nearest"},
                        {"mipmapFilter", between ? "linear" : "nearest"},
                        {"addressModeU", word_of(parameters[kGL_TEXTURE_WRAP_S])},
                        {"addressModeV", word_of(parameters[kGL_TEXTURE_WRAP_T])},
                        {"addressModeW", word_of(parameters[kGL_TEXTURE_WRAP_R])}};
        // Above 0, so that the filter for smaller pictures is used, but below a half, so that the next level is not.
        if (!has_mipmaps) sampler["lodMaxClamp"] = 0.25;
        if (const auto found = parameters.find(kGL_TEXTURE_COMPARE_FUNC); found != parameters.end())
            sampler["compare"] = word_of(found->second);
        return {{"dimension", is_cube                    ? "cube"
                              : target == kGL_TEXTURE_3D ? "3d"
                                                         : "2d"},
                {"format", format},
                {"levels", levels_of(texture, has_mipmaps, is_cube)},
                {"sampler", std::move(sampler)}};
    }

    // The texels of each level; the six faces of a cube map follow each other.
    Json levels_of(const Json& texture, bool has_mipmaps, bool is_cube) {
        const std::size_t words = texture["format"] == "rgba32f" ? 4 : 1;
        const std::size_t count = has_mipmaps ? texture["levels"].get<std::size_t>() : 1;
        Json levels = Json::array();
        for (std::size_t level = 0; level < count; ++level) {
            std::vector<std::uint32_t> texels;
            Json size;
            for (const Json& image : texture["images"]) {
                if (image[1].get<std::size_t>() != level) continue;
                const auto begin = given_.begin() + image[5].get<std::ptrdiff_t>();
                size = {image[2], image[3], image[4]};
                const std::size_t all =
                    words * size[0].get<std::size_t>() * size[1].get<std::size_t>() * size[2].get<std::size_t>();
                texels.insert(texels.end(), begin, begin + static_cast<std::ptrdiff_t>(all));
            }
            if (texels.empty()) break;
            levels.push_back({size[0], size[1], is_cube ? Json(6) : size[2], words_.place_of(texels).first});
        }
        return levels;
    }

    // From the upper left corner.
    Json box_of(const Json& box) const {
        return {box[0], height_ - box[1].get<int>() - box[3].get<int>(), box[2], box[3]};
    }
    // Within the picture.
    Json scissor_of(const Json& box) const {
        const int x0 = std::clamp(box[0].get<int>(), 0, width_), y0 = std::clamp(box[1].get<int>(), 0, height_);
        const int x1 = std::clamp(box[0].get<int>() + box[2].get<int>(), x0, width_);
        const int y1 = std::clamp(box[1].get<int>() + box[3].get<int>(), y0, height_);
        return {x0, height_ - y1, x1 - x0, y1 - y0};
    }

    Json clear_of(const Json& item) const {
        Json clear = Json::object();
        if (item.contains("color")) clear["clearColor"] = short_numbers(item["color"]);
        if (item.contains("depth")) clear["clearDepth"] = item["depth"];
        if (item.contains("stencil")) clear["clearStencil"] = item["stencil"][0];
        const Json whole = {0, 0, width_, height_},
                   box = item.contains("scissor") ? scissor_of(item["scissor"]) : whole;
        const bool all_stencil = !item.contains("stencil") || (item["stencil"][1].get<unsigned>() & 0xFFU) == 0xFFU;
        const int mask = mask_of(item["colorMask"]);
        if (box == whole && all_stencil && (mask == 15 || !item.contains("color"))) return clear;
        clear["scissor"] = box;  // WebGPU clears all or nothing: the page draws a rectangle
        clear["writeMask"] = mask;
        if (item.contains("stencil")) clear["stencilWriteMask"] = item["stencil"][1];
        return clear;
    }
    static int mask_of(const Json& channels) {
        int mask = 0;
        for (std::size_t i = 0; i < 4; ++i) mask |= channels[i].get<bool>() ? 1 << i : 0;
        return mask;
    }

    static Json stencil_face(const Json& face) {
        return {{"compare", word_of(face[0])},
                {"failOp", operation_of(face[3])},
                {"depthFailOp", operation_of(face[4])},
                {"passOp", operation_of(face[5])}};
    }

    static Json blend_of(const Json& blend, bool is_alpha) {
        const std::size_t first = is_alpha ? 2 : 0;
        const Enum equation = blend["equations"][is_alpha ? 1 : 0];
        const bool is_extreme =
            equation == kGL_MIN || equation == kGL_MAX;  // WebGPU wants factors of 1 then; neither has an effect
        const auto factor = [&](std::size_t i) { return is_extreme ? "one" : factor_of(blend["factors"][i]); };
        return {{"operation", word_of(equation)}, {"srcFactor", factor(first)}, {"dstFactor", factor(first + 1)}};
    }

    // The number of the pipeline.
    std::size_t number_of(const Json& pipeline) {
        const auto found = std::ranges::find(pipelines_, pipeline);
        const auto number = static_cast<std::size_t>(found - pipelines_.begin());
        if (found == pipelines_.end()) pipelines_.push_back(pipeline);
        return number;
    }
    Json pipeline_of(const Json& item, const char* topology) const {
        Json depth = {{"depthCompare", item.contains("depthFunc") ? word_of(item["depthFunc"]) : "always"},
                      {"depthWriteEnabled", item.contains("depthFunc") && item["depthMask"].get<bool>()}};
        const bool draws_triangles = topology[0] == 't';
        if (item.contains("offset") && draws_triangles) {
            depth["depthBias"] = std::lround(item["offset"][1].get<double>());
            depth["depthBiasSlopeScale"] = item["offset"][0];
        }
        if (item.contains("stencil")) {
            const Json &front = item["stencil"][0], &back = item["stencil"][1];
            depth["stencilFront"] = stencil_face(front);
            depth["stencilBack"] = stencil_face(back);
            depth["stencilReadMask"] = front[2];
            depth["stencilWriteMask"] = front[6];
        }
        Json target = {{"writeMask", mask_of(item["colorMask"])}};
        if (item.contains("blend"))
            target["blend"] = {{"color", blend_of(item["blend"], false)}, {"alpha", blend_of(item["blend"], true)}};
        Json primitive = {{"topology", topology}, {"frontFace", word_of(item["frontFace"])}};
        if (item.contains("cull")) {
            if (item["cull"] == Enum{kGL_FRONT_AND_BACK}) return {};
            primitive["cullMode"] = word_of(item["cull"]);
        }
        return {{"kind", item["program"].get<int>() + 1},
                {"primitive", std::move(primitive)},
                {"depthStencil", std::move(depth)},
                {"target", std::move(target)}};
    }

    std::vector<Json> draws_of(const Json& item) {
        if (item.contains("framebuffer")) throw std::runtime_error("glLogicOp");
        if (item.value("sides", false)) throw std::runtime_error("stencil tests with other masks for back faces");
        std::vector<Json> draws;
        const std::size_t vertices = item["vertices"][0], floats = item["vertices"][1];
        for (const Json& part : item["parts"]) {
            const List list = list_of(part[0], given_.data() + part[1].get<std::size_t>(), part[2]);
            if (list.indices.empty()) continue;
            const Json pipeline = pipeline_of(item, list.topology);
            if (pipeline.is_null()) continue;  // all is culled
            Json draw = {{"pipeline", number_of(pipeline)},      {"state", item["passes"][0]},
                         {"vertices", copied(vertices, floats)}, {"indices", words_.place_of(list.indices)},
                         {"viewport", box_of(item["viewport"])}, {"depthRange", item["depthRange"]}};
            for (const Json& texture : item["textures"])
                draw["textures"].push_back({kTextureBinding + 2 * texture[0].get<int>(), texture[2]});
            if (item.contains("scissor")) draw["scissor"] = scissor_of(item["scissor"]);
            if (item.contains("stencil")) draw["stencilReference"] = item["stencil"][0][1];
            if (item.contains("blend")) draw["blendConstant"] = short_numbers(item["blend"]["color"]);
            draws.push_back(std::move(draw));
        }
        return draws;
    }

    const Json& header_;
    const std::vector<std::uint32_t>& given_;
    const bool allows_formats_;
    int width_, height_;
    Json pipelines_ = Json::array();
    programmable::ExportWords words_;
};

}  // namespace

SceneData scene_data(const Json& header, const std::vector<std::uint32_t>& words, bool allows_formats) {
    return Scene(header, words, allows_formats).data();
}

}  // namespace twinlight::webgpu
