// A whole program's window after GLUT has called the display function again, over the first picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "judge/lint/lint.h"

namespace twinlight::lint {

struct Redraw {
    enum class Buffer : std::uint8_t { kColor, kDepth };

    Place start;                     // the first statement of the display function
    glm::dvec4 clear_color{0};       // before the second call
    std::optional<Command> clear{};  // the last glClear of the second call
    Frame frame{};                   // both pictures
    std::size_t second = 0;          // frame.items from here on are those of the second picture

    // Whether the first picture changes the second, because this buffer still holds it.
    bool shows_first(Buffer buffer) const;
    bool clears_before_drawing(Buffer buffer) const;
};

// nullopt for a scene that is no whole program, and where the reader cannot follow the second call.
std::optional<Redraw> redraw_of(const CommandList& list, int width, int height);

// A warning that glClear lacks these bits, with the call that fixes it.
Warning not_cleared(const Redraw& redraw, Enum bits, std::string message);

}  // namespace twinlight::lint
