// What is drawn at the current raster position: glBitmap (3.7), glDrawPixels (3.6) and glCopyPixels (4.3.3) of colours, depths
// and stencil values. With glPixelZoom, glPixelTransfer and glPixelMap (3.6.3 to 3.6.5).
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

#include "scene/frame/pixel_image.h"
#include "scene/state/pixel_unpacking.h"
#include "scene/state/state.h"

namespace twinlight {

namespace {

// Mesa adds 0.0001 to the place of a bitmap, so that places just below a whole number belong to it.
constexpr double kLeastDoubt = 2e-4;

// Whether a driver may find a place on the other side of a border between pixels. `distance`: to the border.
bool is_doubtful(const RasterPosition& position, double distance) {
    const bool is_exact = position.doubt == 0 && distance == 0;
    return !is_exact && std::abs(distance) <= std::max(position.doubt, kLeastDoubt);
}

// The columns, or rows, of pixels where a bitmap's first column may be; the first one is where 3.7 has it.
std::vector<int> first_columns(const RasterPosition& position, double at) {
    const double first = std::floor(at), border = std::round(at);
    if (std::abs(at) > kMostWindowPixels) return {};
    std::vector<int> columns{static_cast<int>(first)};
    if (is_doubtful(position, at - border)) columns.push_back(static_cast<int>(first < border ? border : border - 1));
    return columns;
}

// A column, or row, of pixels that a column of groups covers (3.6.4).
struct Covered {
    int pixel = 0, group = 0;
    bool is_doubtful = false;
    bool is_inside = true;  // false: no group covers it, unless a driver finds the border elsewhere
};

std::vector<Covered> covered(const RasterPosition& position, double start, double zoom, int groups) {
    const double end = start + zoom * groups;
    std::vector<Covered> result;
    if (zoom == 0 || !(std::abs(start) + std::abs(end) < 1e12)) return result;
    const int first = std::max(0, static_cast<int>(std::clamp(std::min(start, end), 0.0, 1e5)) - 1);
    const int last = static_cast<int>(std::clamp(std::max(start, end) + 1, 0.0, 1.0 * kMostWindowPixels - 1));
    for (int pixel = first; pixel <= last; ++pixel) {
        // The left and the lower border of a group's rectangle belong to it.
        const double at = (pixel + 0.5 - start) / zoom, group = zoom > 0 ? std::floor(at) : std::ceil(at) - 1;
        const double border = std::round(at);
        const bool near_border =
            border >= 0 && border <= groups && is_doubtful(position, (at - border) * std::abs(zoom));
        const bool is_inside = group >= 0 && group < groups;
        if (is_inside || near_border)
            result.push_back({pixel, static_cast<int>(std::clamp(group, 0.0, groups - 1.0)), near_border, is_inside});
    }
    return result;
}

// Nobody needs more than a window of 1920 x 1080; a call without sense may cover any number.
constexpr int kMostCopiedPixels = 1 << 21;

// Adds the pixels that groups cover. Calls take(group) for each of `places`; its x and y count columns and rows.
template <class Take>
void place_groups(const std::vector<Covered>& columns, const std::vector<Covered>& rows, WindowPixels& pixels,
                  const Take& take) {
    for (const Covered& y : rows)
        for (const Covered& x : columns) {
            if (x.is_doubtful || y.is_doubtful) pixels.doubtful.emplace_back(x.pixel, y.pixel);
            if (!x.is_inside || !y.is_inside) continue;
            pixels.places.emplace_back(x.pixel, y.pixel);
            take(glm::ivec2(x.group, y.group));
        }
}

// NaN becomes 0.
glm::dvec4 inside(glm::dvec4 color) {
    for (int i = 0; i < 4; ++i) color[i] = color[i] > 0 ? std::min(color[i], 1.0) : 0;
    return color;
}

// 4.3.1: stencil values pass only the scissor test and the stencil mask.
void write_only_stencil(Draw& draw, std::uint32_t write_mask) {
    const StencilFace face{.depth_pass = kGL_REPLACE, .write_mask = write_mask};
    draw.fragment = {.scissor = draw.fragment.scissor,
                     .stencil = StencilTest{face, face},
                     .color_mask = {false, false, false, false}};
    draw.raster.depth_test = false;
    draw.lighting = {};
    draw.texture = {};
    draw.further_units.clear();
    draw.columns.clear();
    draw.fog = {};
}

// GL 3.0, 4.3.1: so do depths that are copied together with stencil values. The depth mask applies.
void write_only_depth(Draw& draw) {
    draw.fragment = {.scissor = draw.fragment.scissor, .color_mask = {false, false, false, false}};
    draw.raster.depth_test = true;
    draw.raster.depth_func = kGL_ALWAYS;
}

}  // namespace

// ---- Drawing ----

void State::draw_at_raster_position(const Command& c, WindowPixels pixels, const std::vector<glm::dvec4>& colors) {
    const RasterPosition& position = a_.raster_position;
    const RasterVertex& raster = *position.vertex;
    if (position.is_doubtful) {
        pixels.doubtful.insert(pixels.doubtful.end(), pixels.places.begin(), pixels.places.end());
        if (!position.is_valid) pixels.places.clear();
    }
    if (pixels.places.empty() && pixels.doubtful.empty()) return;
    // A Draw has a vertex, even if all its pixels are in doubt.
    if (pixels.places.empty()) pixels.places.emplace_back(-1, -1);
    const double depth = std::clamp(position.position_window.z, 0.0, 1.0);
    if (pixels.depths.empty())
        pixels.depths = {depth};
    else
        pixels.depths.resize(pixels.places.size(), depth);
    if (pixels.has_stencils) pixels.stencils.resize(pixels.places.size());
    if (!has_room(c, bytes_of_draw() + vertex_bytes(kGL_POINTS, pixels.places.size() + pixels.doubtful.size()))) return;
    Draw draw = new_draw(kGL_POINTS, c.place);
    draw.state_number = 0;  // it has a state of its own
    draw.raster.viewport = kWindowOfPixels;
    draw.raster.depth_near = 0;
    draw.raster.depth_far = 1;
    draw.raster.point_size = 1;
    draw.raster.point_smooth = draw.raster.point_sprite = false;
    draw.raster.point_parameters = {};
    draw.raster.clip_planes_eye.fill(std::nullopt);
    draw.eye_from_object = raster.eye_from_object;
    draw.clip_from_eye = raster.clip_from_eye;
    draw.vertices = std::vector<Vertex>(pixels.places.size(), raster.vertex);
    const auto take = [&](TextureUnit& unit, const RasterVertex::Unit& values) {
        unit.coord_replace = false;
        unit.texture_matrix = values.texture_matrix;
        unit.generated = unit.texture ? values.generated : std::vector<GeneratedCoordinate>();
    };
    take(draw.texture, raster.units[0]);
    for (FurtherUnit& further : draw.further_units) take(further.unit, raster.units[further.number]);
    draw.fog.by_coordinates = raster.fog_by_coordinates;
    // 3.9: the secondary colour is added if lighting or GL_COLOR_SUM is enabled now.
    const bool adds_secondary = draw.lighting.enabled || draw.fragment.color_sum;
    draw.lighting = raster.lighting;
    draw.columns = columns_of(draw, colors.empty() && !draw.lighting.enabled && adds_secondary);
    fill_columns(draw, raster.vertex);
    if (!colors.empty()) {
        // RULING (3.6.4 does not say): colours of glDrawPixels have no secondary colour.
        draw.lighting = LightingState();
        std::vector<Vertex>& vertices = draw.vertices.edit();
        for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].color = colors[i];
        if (!pixels.copied) pixels.image = image_of_pixels(pixels.places, vertices);
    } else if (draw.lighting.enabled && !adds_secondary &&
               draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR) {
        note_unsupported("glDisable(GL_LIGHTING) between glRasterPos and glBitmap, with separate specular colours",
                         c.place);
    }
    if (pixels.has_stencils) write_only_stencil(draw, a_.stencil_test.front.write_mask);
    if (c.id == CommandId::glCopyPixels && c.enumerant(4) == kGL_DEPTH_STENCIL && !pixels.has_stencils)
        write_only_depth(draw);
    draw.pixels = std::make_shared<const WindowPixels>(std::move(pixels));
    show(std::move(draw));
}

// 3.7. A bitmap without pixels only moves the raster position.
void State::bitmap(const Command& c) {
    const int width = static_cast<int>(c.number(0)), height = static_cast<int>(c.number(1));
    if (width < 0 || height < 0)
        return raise(kGL_INVALID_VALUE, c, "glBitmap is given the size {} x {}; it cannot be negative", width, height);
    const auto memory = pixel_memory(c, bitmap_bytes(width, height, pixel_store_));
    RasterPosition& position = a_.raster_position;
    if (!memory || (!position.is_valid && !position.is_doubtful)) return;
    if (!has_time(c, static_cast<double>(width) * height)) return;
    const glm::dvec4 window = position.position_window;
    const std::vector<int> columns = first_columns(position, window.x - c.number(2)),
                           rows = first_columns(position, window.y - c.number(3));
    WindowPixels pixels;
    if (!columns.empty() && !rows.empty() && width > 0 && height > 0) {
        const std::vector<bool> bits = bitmap_bits(width, height, *memory, pixel_store_);
        const auto add = [&](int x0, int y0, std::vector<glm::ivec2>& places) {
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (bits[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(x)] &&
                        kWindowOfPixels.contains(x0 + x, y0 + y))
                        places.emplace_back(x0 + x, y0 + y);
        };
        add(columns.front(), rows.front(), pixels.places);
        if (columns.size() > 1 || rows.size() > 1)
            for (const int x : columns)
                for (const int y : rows) add(x, y, pixels.doubtful);
    }
    draw_at_raster_position(c, std::move(pixels), {});
    position.position_window += glm::dvec4(c.number(4), c.number(5), 0, 0);
}

// 3.6. The driver alone draws colour indices.
void State::draw_pixels(const Command& c) {
    const PixelSource source{.width = static_cast<int>(c.number(0)),
                             .height = static_cast<int>(c.number(1)),
                             .format = c.enumerant(2),
                             .type = c.enumerant(3)};
    if (source.width < 0 || source.height < 0)
        return raise(kGL_INVALID_VALUE, c, "glDrawPixels is given the size {} x {}; it cannot be negative",
                     source.width, source.height);
    if (!check_pixel_type(c, source)) return;
    const bool are_depths = source.format == kGL_DEPTH_COMPONENT;
    if (are_depths && !has_buffer(c, CopiedBuffer::kDepths)) return;
    if (source.format == kGL_STENCIL_INDEX) return draw_stencils(c, source);
    if (source.width == 0 || source.height == 0) return;
    if (!pixel_memory(c, bytes_read(source, pixel_store_))) return;
    const RasterPosition& position = a_.raster_position;
    if (!position.is_valid && !position.is_doubtful) return;
    const auto image = pixels(c, source);
    const std::vector<Covered> columns = covered(position, position.position_window.x, a_.pixel_zoom.x, source.width);
    const std::vector<Covered> rows = covered(position, position.position_window.y, a_.pixel_zoom.y, source.height);
    if (!image || !has_time(c, static_cast<double>(columns.size()) * static_cast<double>(rows.size()) +
                                   static_cast<double>(source.width) * source.height))
        return;
    if (!has_room(c, columns.size() * rows.size() * (sizeof(glm::dvec4) + sizeof(glm::vec4)))) return;
    WindowPixels drawn;
    std::vector<glm::dvec4> colors, row;
    int unpacked = -1;
    place_groups(columns, rows, drawn, [&](const glm::ivec2& group) {
        if (group.y != std::exchange(unpacked, group.y)) image->unpack(group.y, row);
        const glm::dvec4 color = inside(row[static_cast<std::size_t>(group.x)]);
        if (are_depths)
            drawn.depths.push_back(color.r);
        else
            colors.push_back(color);
    });
    if (colors.empty() && !are_depths) colors.emplace_back(0);
    draw_at_raster_position(c, std::move(drawn), colors);
}

// 4.3.1: glDrawPixels of stencil values.
void State::draw_stencils(const Command& c, const PixelSource& given) {
    if (!has_buffer(c, CopiedBuffer::kStencil)) return;
    PixelSource source = given;
    source.format = kGL_RED;  // also one value
    if (source.width == 0 || source.height == 0) return;
    const auto memory = pixel_memory(c, bytes_read(source, pixel_store_));
    const RasterPosition& position = a_.raster_position;
    if (!memory || (!position.is_valid && !position.is_doubtful)) return;
    const std::vector<Covered> columns = covered(position, position.position_window.x, a_.pixel_zoom.x, source.width);
    const std::vector<Covered> rows = covered(position, position.position_window.y, a_.pixel_zoom.y, source.height);
    const double count = static_cast<double>(source.width) * source.height;
    if (!has_time(c, static_cast<double>(columns.size()) * static_cast<double>(rows.size()) + count)) return;
    if (!has_room(c, static_cast<std::size_t>(count) * sizeof(std::int64_t))) return;
    const std::vector<std::int64_t> values = stencil_values(source, pixel_store_, *memory);
    WindowPixels drawn{.has_stencils = true};
    place_groups(columns, rows, drawn, [&](const glm::ivec2& group) {
        const auto row = static_cast<std::size_t>(group.y) * static_cast<std::size_t>(source.width);
        drawn.stencils.push_back(transferred_stencil(values[row + static_cast<std::size_t>(group.x)]));
    });
    draw_at_raster_position(c, std::move(drawn), {});
}

// 4.3.3: the same for pixels of the picture. They replace the colours of the Draw's vertices, the depths or the stencil values.
void State::copy_pixels(const Command& c) {
    const Enum type = c.enumerant(4);
    if (c.number(2) < 0 || c.number(3) < 0)
        return raise(kGL_INVALID_VALUE, c, "glCopyPixels is given the size {} x {}; it cannot be negative", c.number(2),
                     c.number(3));
    if (!known(c, type, {kGL_COLOR, kGL_DEPTH, kGL_STENCIL, kGL_DEPTH_STENCIL})) return;
    const bool has_depths = type == kGL_DEPTH || type == kGL_DEPTH_STENCIL,
               has_stencils = type == kGL_STENCIL || type == kGL_DEPTH_STENCIL;
    if ((has_depths && !has_buffer(c, CopiedBuffer::kDepths)) ||
        (has_stencils && !has_buffer(c, CopiedBuffer::kStencil)))
        return;
    const RasterPosition& position = a_.raster_position;
    if ((!position.is_valid && !position.is_doubtful) || c.number(2) == 0 || c.number(3) == 0) return;
    if (type == kGL_COLOR) copy_buffer(c, CopiedBuffer::kColors);
    if (has_depths) copy_buffer(c, CopiedBuffer::kDepths);
    if (has_stencils) copy_buffer(c, CopiedBuffer::kStencil);
}

void State::copy_buffer(const Command& c, CopiedBuffer buffer) {
    const Rectangle from{static_cast<int>(c.number(0)), static_cast<int>(c.number(1)), static_cast<int>(c.number(2)),
                         static_cast<int>(c.number(3))};
    const RasterPosition& position = a_.raster_position;
    const std::vector<Covered> columns = covered(position, position.position_window.x, a_.pixel_zoom.x, from.width);
    const std::vector<Covered> rows = covered(position, position.position_window.y, a_.pixel_zoom.y, from.height);
    const double count = static_cast<double>(columns.size()) * static_cast<double>(rows.size());
    if (count > kMostCopiedPixels)
        return note_unsupported(fmt::format("glCopyPixels of more than {} pixels", kMostCopiedPixels), c.place);
    if (framebuffers_.draw != 0 && framebuffers_.read == 0)
        return note_lasting("glCopyPixels from the window into a framebuffer object", c.place);
    CopiedGroups groups{.source = {.pixels = copied_pixels(c, buffer, from, count), .from = from},
                        .places = {},
                        .depth_scale = a_.pixel_transfer.depth_scale,
                        .depth_bias = a_.pixel_transfer.depth_bias};
    if (!groups.source.pixels) return;
    WindowPixels drawn{.has_stencils = buffer == CopiedBuffer::kStencil};
    place_groups(columns, rows, drawn, [&](const glm::ivec2& group) { groups.places.push_back(group); });
    if (groups.places.empty()) groups.places.emplace_back(0);
    for (std::size_t code = 0; code < 256; ++code) {
        const glm::dvec4 color =
            inside(transferred(glm::dvec4(static_cast<double>(code) / 255.0), a_.pixel_transfer, &pixel_maps_));
        for (int i = 0; i < 4; ++i) groups.colors[static_cast<std::size_t>(i)][code] = color[i];
        groups.stencils[code] = transferred_stencil(static_cast<std::int64_t>(code));
    }
    std::vector<glm::dvec4> colors;
    if (buffer == CopiedBuffer::kColors) colors.assign(groups.places.size(), glm::dvec4(0));
    drawn.copied = std::make_shared<const CopiedGroups>(std::move(groups));
    draw_at_raster_position(c, std::move(drawn), colors);
}

// 3.6.5, "Arithmetic on components" of indices and "Stencil index lookup"; 4.3.1: the buffer has 8 bits.
std::uint8_t State::transferred_stencil(std::int64_t value) const {
    const StencilTransfer& transfer = a_.stencil_transfer;
    value = transfer.shift < 0 ? value >> std::min(-transfer.shift, 63)
                               : value * (std::int64_t{1} << std::min(transfer.shift, 8));  // 8 leave none of the bits
    value = (value & kMaxStencil) + transfer.offset;
    if (transfer.map) value = stencil_map_[static_cast<std::size_t>(value) & (stencil_map_.size() - 1)];
    return static_cast<std::uint8_t>(value & kMaxStencil);
}

// ---- State ----

void State::pixel_zoom(const Command& c) { a_.pixel_zoom = {c.number(0), c.number(1)}; }

void State::pixel_transfer(const Command& c) {
    const Enum pname = c.enumerant(0);
    constexpr Enum kScales[] = {kGL_RED_SCALE, kGL_GREEN_SCALE, kGL_BLUE_SCALE, kGL_ALPHA_SCALE};
    constexpr Enum kBiases[] = {kGL_RED_BIAS, kGL_GREEN_BIAS, kGL_BLUE_BIAS, kGL_ALPHA_BIAS};
    if (!known(c, pname,
               {kGL_MAP_COLOR, kGL_MAP_STENCIL, kGL_INDEX_SHIFT, kGL_INDEX_OFFSET, kGL_RED_SCALE, kGL_GREEN_SCALE,
                kGL_BLUE_SCALE, kGL_ALPHA_SCALE, kGL_DEPTH_SCALE, kGL_RED_BIAS, kGL_GREEN_BIAS, kGL_BLUE_BIAS,
                kGL_ALPHA_BIAS, kGL_DEPTH_BIAS}))
        return;
    PixelTransfer& transfer = a_.pixel_transfer;
    if (pname == kGL_MAP_COLOR) transfer.map_color = c.number(1) != 0;
    if (pname == kGL_DEPTH_SCALE) transfer.depth_scale = c.number(1);
    if (pname == kGL_DEPTH_BIAS) transfer.depth_bias = c.number(1);
    const auto whole = [&] { return static_cast<int>(std::clamp(c.number(1), -0x1p31, 0x1p31 - 1)); };
    if (pname == kGL_INDEX_SHIFT) a_.stencil_transfer.shift = whole();
    if (pname == kGL_INDEX_OFFSET) a_.stencil_transfer.offset = whole();
    if (pname == kGL_MAP_STENCIL) a_.stencil_transfer.map = c.number(1) != 0;
    for (int i = 0; i < 4; ++i) {
        if (pname == kScales[i]) transfer.scale[i] = c.number(1);
        if (pname == kBiases[i]) transfer.bias[i] = c.number(1);
    }
}

// 3.6.3. The tables for colour indices are not kept.
void State::pixel_map(const Command& c) {
    const Enum map = c.enumerant(0);
    const double size = c.number(1);
    if (!known(c, map,
               {kGL_PIXEL_MAP_I_TO_I, kGL_PIXEL_MAP_S_TO_S, kGL_PIXEL_MAP_I_TO_R, kGL_PIXEL_MAP_I_TO_G,
                kGL_PIXEL_MAP_I_TO_B, kGL_PIXEL_MAP_I_TO_A, kGL_PIXEL_MAP_R_TO_R, kGL_PIXEL_MAP_G_TO_G,
                kGL_PIXEL_MAP_B_TO_B, kGL_PIXEL_MAP_A_TO_A}))
        return;
    if (size < 1 || size > kMaxPixelMap)
        return raise(kGL_INVALID_VALUE, c, "{} is given {} values; it takes 1 to {}", c.name(), size, kMaxPixelMap);
    if (map < kGL_PIXEL_MAP_R_TO_R && !std::has_single_bit(static_cast<unsigned>(size)))
        return raise(kGL_INVALID_VALUE, c, "{} is given {} values; the number of those for indices is a power of 2",
                     c.name(), size);
    if (map == kGL_PIXEL_MAP_S_TO_S) {
        stencil_map_.clear();
        for (const double value : c.values(2))
            stencil_map_.push_back(static_cast<int>(std::fmod(std::round(value), 256)));
    }
    if (map < kGL_PIXEL_MAP_R_TO_R) return;
    const Kind kind = c.sig().parameters[2].kind;
    const double largest = kind == Kind::kUint ? 4294967295.0 : kind == Kind::kUshort ? 65535 : 1;
    std::vector<double>& kept = pixel_maps_.at(map - kGL_PIXEL_MAP_R_TO_R);
    kept.clear();
    for (const double value : c.values(2)) kept.push_back(std::clamp(value / largest, 0.0, 1.0));
}

}  // namespace twinlight
