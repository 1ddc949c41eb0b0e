// Sends commands to the driver literally: each row of commands.def that GL or GLU has calls that function, with the
// arguments in its own types.
#include "render/fixed/execute.h"

#include <array>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "render/context/gl.h"
#include "render/fixed/draw_parts.h"
#include "scene/command/memory.h"
#include "scene/shape/shape.h"

namespace twinlight::fixed {

namespace {

// The function's result, which is not an argument.
template <class Returned>
struct Result {};

// A row's parameter as C declares it.
template <Kind kind, Extent extent>
auto declared() {
    using enum Extent;
    using Value = CType<kind>;
    if constexpr (extent == kValue)
        return Value{};
    else if constexpr (extent == kResult)
        return Result<Value>{};
    else if constexpr (extent == kPointer)
        return static_cast<const void*>(nullptr);
    else if constexpr (extent == kOutputMemory)
        return static_cast<void*>(nullptr);
    else if constexpr (extent == kArray || extent == kArrayByPname || extent == kArrayByCount ||
                       extent == kControlPoints)
        return static_cast<const Value*>(nullptr);
    else
        return static_cast<Value*>(nullptr);
}

// The longest fixed-length array that a command of the table reads or writes. Shorter arrays are padded with 0, so that
// the driver never reads past the end, whatever pname it gets.
constexpr std::size_t kLongestArray = 16;

// The conversion is safe: commands hold only numbers that their types can represent; a float may be infinite.
template <class T>
struct Argument {
    Argument(const Command& command, std::size_t i) : value(static_cast<T>(command.number(command.first(i)))) {}
    T get() { return value; }
    T value;
};

template <class Element>
struct Argument<Element*> {
    Argument(const Command& command, std::size_t i) {
        const auto elements = command.values(i);
        if (elements.size() > kLongestArray) many.resize(elements.size());
        for (std::size_t n = 0; n < elements.size(); ++n) {
            get()[n] = static_cast<std::remove_const_t<Element>>(elements[n]);
        }
    }
    auto get() { return many.empty() ? few.data() : many.data(); }
    std::array<std::remove_const_t<Element>, kLongestArray> few{};
    std::vector<std::remove_const_t<Element>> many;
};

// A pointer into the command's memory, or an offset into a buffer object.
template <>
struct Argument<const void*> {
    Argument(const Command& command, std::size_t i) {
        const auto offset = static_cast<std::ptrdiff_t>(command.number(command.first(i)));
        value = command.memory ? command.memory->bytes.data() + offset : nullptr;
        if (!command.memory) value = reinterpret_cast<const void*>(offset);  // NOLINT: GL's way to give an offset
    }
    const void* get() { return value; }
    const void* value = nullptr;
};

// Memory that a command would write. No such command gets here (see Driver).
template <>
struct Argument<void*> {
    Argument(const Command&, std::size_t) {}
    static void* get() { return nullptr; }
};

// `Declared`: the parameters in the table. If a row disagrees with the header, it does not compile.
template <class... Declared>
struct Call {
    template <std::size_t i>
    using At = std::tuple_element_t<i, std::tuple<Declared..., void>>;
    // The header declares glBitmap's memory as GLubyte.
    template <class D, class Actual>
    static constexpr bool kAgree = std::is_same_v<D, Actual> ||
                                   (std::is_same_v<D, const void*> && std::is_same_v<Actual, const GLubyte*>);

    template <class Returned, class... Actual, std::size_t... I>
    static void make(Returned (*function)(Actual...), const Command& command, std::index_sequence<I...>) {
        static_assert((kAgree<At<I>, Actual> && ...), "commands.def disagrees with GL's header");
        function(static_cast<Actual>(Argument<At<I>>(command, I).get())...);
    }
    template <class Returned, class... Actual>
    static void make(Returned (*function)(Actual...), const Command& command) {
        constexpr std::size_t kArguments = sizeof...(Actual);
        using Last = std::tuple_element_t<kArguments, std::tuple<Declared..., void>>;
        static_assert(sizeof...(Declared) == kArguments || std::is_same_v<Last, Result<Returned>>,
                      "commands.def disagrees with GL's header");
        make(function, command, std::index_sequence_for<Actual...>{});
    }
};

}  // namespace

Executor::Executor() : window_(draw_framebuffer()), color_buffer_(draw_buffer()) {}

void Executor::draw_shape(const Command& command) {
    if (draws_quadric(command)) return quadrics_.execute(command);
    draw_by_arrays(command);
}

// GL can execute only one pragma: drawing a shape.
void Executor::pragma(const Command& command) {
    if (command.id == CommandId::pragma_shape) draw_shape(command);
}

void Executor::execute(const Command& command) {
    // Offscreen there is only one colour buffer, with a different name than a window's.
    const bool draws_to_window = command.id == CommandId::glDrawBuffer && command.enumerant(0) != GL_NONE &&
                                 command.enumerant(0) < GL_COLOR_ATTACHMENT0 && draw_framebuffer() == window_;
    if (draws_to_window) return glDrawBuffer(color_buffer_);
    // Ignored for a window: its picture is read from the current buffer.
    if (command.id == CommandId::glReadBuffer && read_framebuffer() == window_) return;
    switch (command.id) {
// clang-format off
#define PARAMETER(name, kind, extent, count) decltype(declared<Kind::kind, Extent::extent>())
#define GL_COMMAND(name, effect, ...) \
    case CommandId::name: return Call<__VA_ARGS__>::make(&::name, command);
#define SHAPE_COMMAND(name, effect, ...) \
    case CommandId::name: return draw_shape(command);
#define QUADRIC_COMMAND(name, effect, ...) \
    case CommandId::name: return quadrics_.execute(command);
#define PRAGMA_COMMAND(name, effect, ...) \
    case CommandId::pragma_##name: return pragma(command);
// clang-format on
#include "scene/command/commands.def"
    }
}

}  // namespace twinlight::fixed
