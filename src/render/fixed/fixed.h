// The fixed renderer: the driver's own fixed function executes the commands, literally, in the current context.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "base/image/image.h"
#include "render/fixed/execute.h"
#include "render/look.h"
#include "render/stages/accumulation_buffer.h"
#include "scene/command/command.h"
#include "scene/command/object_names.h"
#include "scene/frame/scene.h"
#include "scene/state/arrays.h"

namespace twinlight::fixed {

// Confines the changes of commands: sets GL's initial state, for a window of this size, on construction and
// destruction. Objects stay.
class InitialState {
  public:
    InitialState(int width, int height);
    ~InitialState();
    InitialState(const InitialState&) = delete;
    InitialState& operator=(const InitialState&) = delete;

  private:
    int width_, height_;
    std::uint32_t framebuffer_;  // the window's
    Enum draw_buffer_;
};

// The driver, for the commands of one scene. It starts in GL's initial state, for a window of this size, and returns to
// it at the end, without the objects that the scene made.
//
// The context also holds other objects, so the scene's texture and buffer names are mapped to names that the driver
// gave. Display lists have the scene's own names, because nobody else uses lists here. The driver never reads beyond
// the memory of a command: a command that might do so is not sent. State refuses such commands or lists them as
// unsupported.
class Driver {
  public:
    Driver(int width, int height);
    ~Driver();
    Driver(const Driver&) = delete;
    Driver& operator=(const Driver&) = delete;

    // Executes one command. Ignores pragmas without a GL command, except shape(...), which draws.
    void execute(const Command& command);

    // Creates empty lists with these names, and keeps them when they are deleted. An empty list does what a missing one
    // does, but Mesa (22.3) crashes if a list that is being compiled calls a missing one.
    void make_empty_lists(const std::vector<std::uint32_t>& names);

    // Ends a picture of a recording: what was accumulated is lost.
    void drop_accumulated() { accumulated_.reset(); }

    // Returns the driver's name for an object of the scene, or 0 if the driver has no such object. Framebuffer 0 is the window.
    std::uint32_t name_of(ObjectType type, std::uint32_t name) const;

  private:
    struct Names {
        std::map<std::uint32_t, std::uint32_t> driver_from_scene;
        std::set<std::uint32_t> all;  // all names that the driver gave
    };

    void generate(const Command& command);
    void selection_buffer(int size);
    void feedback_buffer(int size, Enum type);
    Command translated(const Command& command);
    std::uint32_t new_name(ObjectType type);
    void delete_lists(const Command& command);
    void empty_lists();
    void end_bitmaps(const Command& command);

    bool accumulate(const Command& command);

    bool may_send(const Command& command);
    bool may_send_arrays(const Command& command);
    bool may_send_lists(const Command& command);
    bool may_send_pixels(const Command& command);
    static bool may_send_stipple(const Command& command);
    static bool may_copy_pixels(const Command& command);
    // Whether the driver answers queries. Between glBegin and glEnd it does not, and it executes few commands.
    static bool answers();
    static bool is_compiling();  // a display list
    // Whether the driver's arrays are those of arrays_, as far as it can be asked.
    bool arrays_agree();
    bool holds_arrays() const;
    bool holds(const ArrayPointer& array, Enum name) const;

    const std::uint32_t window_;  // its framebuffer, in which the driver starts
    std::optional<InitialState> initial_;
    Executor executor_;
    std::map<ObjectType, Names> names_;
    std::set<std::uint32_t> lists_;                       // compiled by the scene
    std::set<std::uint32_t> kept_lists_, emptied_lists_;  // lists that always exist; lists to empty after glEndList
    VertexArrays arrays_;                                 // the arrays that the driver should have
    bool arrays_may_differ_ = false;                      // since the last check
    bool arrays_agreed_ = true;                           // at the last check
    std::vector<std::uint32_t> selection_;                // the driver's output under glRenderMode
    std::vector<float> feedback_;
    int width_, height_;
    std::optional<AccumulationBuffer> accumulated_;  // in place of the buffer that the driver lacks here
    bool draws_bitmaps_ = false;                     // or a list may
    bool selects_ = false;                           // the scene has set these buffers or the render mode
};

struct Options {
    std::optional<Shading> shading{};  // instead of every glShadeModel: kFlat or kGouraud
};

// Throws std::invalid_argument for shadings that the fixed function lacks: Shading::kPhong and Shading::kExact.
void check_shading(const std::optional<Shading>& shading);

// Clears to black and depth 1, executes the scene's commands and reads the picture. Throws as check_shading() does.
Image render(const Scene& scene, const Options& options = {});
// The same without reading back: leaves the picture in the current colour buffer.
void draw(const Scene& scene, const Options& options = {});

}  // namespace twinlight::fixed
