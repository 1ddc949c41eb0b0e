// Driver: decides which commands may be sent, so that the driver never reads beyond the memory of a command.
//
// State follows GL 2.1, but drivers also have other rules: types, formats and targets of later versions that State
// refuses; limits that State does not know; and between glBegin and glEnd they ignore commands that arrays_ would
// follow. So a command that State refuses is not sent if it refers to memory; and before the driver reads arrays, it is
// asked whether its arrays are those of arrays_.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <vector>

#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/command/command_set.h"
#include "scene/state/lists.h"
#include "scene/state/pixel_unpacking.h"

namespace twinlight::fixed {

namespace {

bool names_memory(const Parameter& parameter) { return parameter.extent == Extent::kPointer; }

// The commands of VertexArrays: those on arrays, on buffers and on the client's attribute stack.
constexpr CommandSet kArrayCommands = CommandSet::of({"client_arrays"});

// Arrays that no pointer command of the table sets. Drivers also accept glEnable instead of glEnableClientState.
bool enables_unknown_array(const Command& c) {
    const bool enables = c.id == CommandId::glEnable;
    if (!enables && c.id != CommandId::glEnableClientState) return false;
    const Enum array = c.enumerant(0);
    if (array == GL_SECONDARY_COLOR_ARRAY || array == GL_FOG_COORD_ARRAY) return true;
    return enables ? array >= GL_VERTEX_ARRAY && array <= GL_EDGE_FLAG_ARRAY : array == GL_INDEX_ARRAY;
}

// The driver's answer, or `unanswered` if there is none.
GLint integer(GLenum name, GLint unanswered) {
    GLint value = unanswered;
    glGetIntegerv(name, &value);
    return value;
}

// Mesa (22.3) crashes where it copies colours without one.
bool has_read_buffer() { return integer(GL_READ_BUFFER, GL_FRONT) != GL_NONE; }

// Mesa (26.1) allocates the copy by its number of pixels in 32 bits, and writes beyond it if that is too small.
bool copies_few_pixels(const Command& copy) { return std::max(copy.number(2), copy.number(3)) <= kMaxTextureSize; }

}  // namespace

bool Driver::answers() { return integer(GL_CLIENT_ATTRIB_STACK_DEPTH, -1) >= 0; }

bool Driver::is_compiling() { return integer(GL_LIST_INDEX, 0) != 0; }

bool Driver::may_send(const Command& c) {
    if (enables_unknown_array(c)) return false;
    if (kArrayCommands.contains(c.id) || draws_arrays(c.id)) return may_send_arrays(c);
    switch (c.id) {
        case CommandId::glBegin:
            arrays_agree();  // checked now, for a glArrayElement that may follow
            return true;
        case CommandId::glCallList:
        case CommandId::glCallLists: return may_send_lists(c);
        case CommandId::glPolygonStipple: return may_send_stipple(c);
        case CommandId::glCopyTexImage1D:
        case CommandId::glCopyTexImage2D: return may_copy_pixels(c);
        case CommandId::glCopyTexSubImage1D:
        case CommandId::glCopyTexSubImage2D:
        case CommandId::glCopyTexSubImage3D: return has_read_buffer();
        case CommandId::glCopyPixels: return has_read_buffer() && copies_few_pixels(c);
        default: return std::ranges::none_of(c.sig().parameters, names_memory) || may_send_pixels(c);
    }
}

// ---- Vertex arrays and buffer objects ----

bool Driver::may_send_arrays(const Command& c) {
    // A draw with an error is not sent either: the driver may draw where State does not (GL_LINES_ADJACENCY).
    if (draws_arrays(c.id)) return arrays_agree() && !arrays_.check(c);
    const bool reads = std::ranges::any_of(c.sig().parameters, names_memory) || c.id == CommandId::glBindBuffer;
    if (!answers()) return !reads;
    arrays_may_differ_ = true;
    return !arrays_.apply(c) || !reads;
}

bool Driver::arrays_agree() {
    if (!arrays_may_differ_) return arrays_agreed_;
    if (!answers()) return false;
    arrays_may_differ_ = false;
    return arrays_agreed_ = holds_arrays();
}

bool Driver::holds_arrays() const {
    const ClientArrays& client = arrays_.client();
    const auto binding = [this](std::uint32_t name) { return static_cast<GLint>(name_of(ObjectType::kBuffer, name)); };
    bool agree = integer(GL_ELEMENT_ARRAY_BUFFER_BINDING, -1) == binding(client.element_buffer);
    for (const GLenum array : {GL_INDEX_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY}) {
        agree &= glIsEnabled(array) == GL_FALSE;
    }
    agree &= holds(client.vertex, GL_VERTEX_ARRAY) && holds(client.normal, GL_NORMAL_ARRAY) &&
             holds(client.color, GL_COLOR_ARRAY) && holds(client.edge_flag, GL_EDGE_FLAG_ARRAY);
    const GLint unit = integer(GL_CLIENT_ACTIVE_TEXTURE, GL_TEXTURE0);
    for (std::size_t i = 0; i < client.tex_coord.size(); ++i) {
        glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        agree &= holds(client.tex_coord[i], GL_TEXTURE_COORD_ARRAY);
    }
    glClientActiveTexture(static_cast<GLenum>(unit));
    return agree;
}

bool Driver::holds(const ArrayPointer& array, Enum name) const {
    struct Queries {
        Enum array, pointer, stride, buffer, type, size;  // 0: no such query
    };
    static constexpr Queries kArrayQueries[] = {
        {GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_POINTER, GL_VERTEX_ARRAY_STRIDE, GL_VERTEX_ARRAY_BUFFER_BINDING,
         GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_SIZE},
        {GL_NORMAL_ARRAY, GL_NORMAL_ARRAY_POINTER, GL_NORMAL_ARRAY_STRIDE, GL_NORMAL_ARRAY_BUFFER_BINDING,
         GL_NORMAL_ARRAY_TYPE, 0},
        {GL_COLOR_ARRAY, GL_COLOR_ARRAY_POINTER, GL_COLOR_ARRAY_STRIDE, GL_COLOR_ARRAY_BUFFER_BINDING,
         GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_SIZE},
        {GL_EDGE_FLAG_ARRAY, GL_EDGE_FLAG_ARRAY_POINTER, GL_EDGE_FLAG_ARRAY_STRIDE, GL_EDGE_FLAG_ARRAY_BUFFER_BINDING,
         0, 0},
        {GL_TEXTURE_COORD_ARRAY, GL_TEXTURE_COORD_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_STRIDE,
         GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, GL_TEXTURE_COORD_ARRAY_TYPE, GL_TEXTURE_COORD_ARRAY_SIZE},
    };
    const Queries& queries = *std::ranges::find(kArrayQueries, name, &Queries::array);
    if ((glIsEnabled(name) == GL_TRUE) != array.enabled) return false;
    if (!array.enabled) return true;
    const auto same = [](Enum query, double value) { return query == 0 || integer(query, -1) == value; };
    const auto offset = static_cast<std::ptrdiff_t>(array.offset);
    const void* const expected = array.memory ? static_cast<const void*>(array.memory->bytes.data() + offset)
                                              : reinterpret_cast<const void*>(offset);  // NOLINT: an offset, as given
    void* pointer = nullptr;
    glGetPointerv(queries.pointer, &pointer);
    return pointer == expected && same(queries.stride, array.stride) && same(queries.type, array.type) &&
           same(queries.size, array.size) && same(queries.buffer, name_of(ObjectType::kBuffer, array.buffer));
}

// ---- Lists ----

bool Driver::may_send_lists(const Command& c) {
    arrays_agree();                                              // a list may contain a glBegin
    if (c.id == CommandId::glCallList) return c.number(0) != 0;  // there is no list 0
    const double offset = c.number(2), count = c.number(0);
    const int size = list_name_bytes(c.enumerant(1));
    if (count <= 0 || size == 0) return true;
    if (!c.memory || offset < 0 || offset + count * size > static_cast<double>(c.memory->bytes.size())) return false;
    if (!is_compiling()) return true;
    const auto bytes = std::span(c.memory->bytes).subspan(static_cast<std::size_t>(offset));
    for (double i = 0; i < count; ++i) {
        if (list_name(bytes.subspan(static_cast<std::size_t>(i) * static_cast<std::size_t>(size)), c.enumerant(1)) ==
            0) {
            return false;
        }
    }
    return true;
}

// ---- Pixels ----

namespace {

PixelStore unpacking() {
    PixelStore store;
    store.unpack_row_length = integer(GL_UNPACK_ROW_LENGTH, 0);
    store.unpack_skip_rows = integer(GL_UNPACK_SKIP_ROWS, 0);
    store.unpack_skip_pixels = integer(GL_UNPACK_SKIP_PIXELS, 0);
    store.unpack_image_height = integer(GL_UNPACK_IMAGE_HEIGHT, 0);
    store.unpack_skip_images = integer(GL_UNPACK_SKIP_IMAGES, 0);
    store.unpack_alignment = std::max(1, integer(GL_UNPACK_ALIGNMENT, 4));
    return store;
}

// The size, the format and the type of the pixels that a command reads.
PixelSource pixels_of(const Command& c) {
    PixelSource source;
    const std::vector<Parameter>& parameters = c.sig().parameters;
    bool has_format = false;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].name == "width") source.width = static_cast<int>(c.number(i));
        if (parameters[i].name == "height") source.height = static_cast<int>(c.number(i));
        if (parameters[i].name == "depth") {
            source.depth = static_cast<int>(c.number(i));
            source.is_volume = true;
        }
        if (parameters[i].name == "format") source.format = c.enumerant(i);
        if (parameters[i].name == "type") source.type = c.enumerant(i);
        has_format |= parameters[i].name == "format";
    }
    if (c.id == CommandId::glBitmap) {
        source.type = kGL_BITMAP;
        return source;
    }
    if (c.id == CommandId::glCopyTexImage1D || c.id == CommandId::glCopyTexImage2D) return source;
    if (!has_format) throw std::logic_error(fmt::format("no rule says how much {} reads", c.name()));
    return source;
}

// llvmpipe (22.3) runs past the end of an array of levels if an image is larger than the limit.
bool is_too_large(const PixelSource& source) {
    const int largest =
        source.is_volume ? std::min(kMax3dTextureSize, integer(GL_MAX_3D_TEXTURE_SIZE, 0)) : kMaxTextureSize;
    return std::max({source.width, source.height, source.depth}) > largest + 2;
}

// The most bytes that a driver can read; exact for the formats of GL 2.1.
std::size_t most_bytes_read(PixelSource source, const PixelStore& store) {
    if (source.type == kGL_BITMAP) return bitmap_bytes(source.width, source.height, store);
    if (source.format == kGL_COLOR_INDEX || source.format == GL_STENCIL_INDEX || source.format == kGL_DEPTH_COMPONENT) {
        source.format = kGL_RED;  // also one component
    }
    // No format of a later version is larger than this.
    if (!pixel_bytes(source.format, source.type)) {
        source.format = kGL_RGBA;
        source.type = kGL_FLOAT;
    }
    return bytes_read(source, store);
}

}  // namespace

bool Driver::may_send_stipple(const Command& c) {
    constexpr int kSide = 32;
    if (integer(GL_PIXEL_UNPACK_BUFFER_BINDING, -1) != 0) return false;
    return bitmap_bytes(kSide, kSide, unpacking()) <= c.array().size();
}

bool Driver::may_copy_pixels(const Command& c) {
    const std::optional<InternalFormat> format = internal_format(c.number(2));
    const bool are_depths = format && format->base_format == GL_DEPTH_COMPONENT;
    return !is_too_large(pixels_of(c)) && (are_depths || has_read_buffer());
}

bool Driver::may_send_pixels(const Command& c) {
    const GLint buffer = integer(GL_PIXEL_UNPACK_BUFFER_BINDING, -1);
    if (buffer < 0) return false;  // between glBegin and glEnd
    const bool is_glu = c.sig().name.starts_with("glu");
    const double offset = c.arguments.back();
    const PixelSource source = pixels_of(c);
    const bool is_drawn = c.id == CommandId::glDrawPixels || c.id == CommandId::glBitmap;
    if (!is_drawn && is_too_large(source)) return false;
    // Mesa (22.3) takes a number from its stack for the type.
    if (c.id == CommandId::glDrawPixels && source.format == GL_STENCIL_INDEX && source.type == GL_BITMAP) return false;
    if (buffer > 0) return !c.memory && !is_glu;  // GL checks the buffer's size itself; GLU has no buffers
    const bool is_empty = source.width <= 0 || source.height <= 0 || source.depth <= 0;
    if (!c.memory) return offset == 0 && (is_empty || (!is_glu && !is_drawn));
    const auto size = static_cast<double>(c.memory->bytes.size());
    return offset >= 0 && offset + static_cast<double>(most_bytes_read(source, unpacking())) <= size;
}

}  // namespace twinlight::fixed
