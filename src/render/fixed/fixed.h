// The control group: the driver's own fixed function executes the commands, literally, in the current context.
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
#include "scene/command/command.h"
#include "scene/command/object_names.h"
#include "scene/state/arrays.h"
#include "scene/state/scene.h"

namespace twinlight::fixed {

// Keeps what commands change to itself: sets GL's initial state, for a window of this size, when it begins and when it
// ends. Objects stay.
class InitialState {
  public:
    InitialState(int width, int height);
    ~InitialState();
    InitialState(const InitialState&) = delete;
    InitialState& operator=(const InitialState&) = delete;

  private:
    int width_, height_;
    Enum draw_buffer_;
};

// The driver, for the commands of one scene: it starts in GL's initial state, for a window of this size, and has it again
// at the end, without the objects that the scene made.
//
// The context holds objects of others too, so the scene's names of textures and buffers stand for names that the driver
// gave; those of display lists, which nobody else has here, are the driver's own. The driver never reads beyond the
// memory that a command is given, whatever the command: one that might is not sent. State refuses such commands, or says
// that they are unsupported.
class Driver {
  public:
    Driver(int width, int height);
    ~Driver();
    Driver(const Driver&) = delete;
    Driver& operator=(const Driver&) = delete;

    // One command. Pragmas that GL has no command for do nothing, but shape(...) draws.
    void execute(const Command& command);

    // Makes empty lists of these names, which do what no lists do; and so do those that are deleted. Mesa (22.3) crashes where
    // a list calls another that is not there when it is compiled.
    void make_empty_lists(const std::vector<std::uint32_t>& names);

    // The driver's name for an object of the scene; 0 for one that it does not have.
    std::uint32_t name_of(ObjectType type, std::uint32_t name) const;

  private:
    struct Names {
        std::map<std::uint32_t, std::uint32_t> driver_from_scene;
        std::set<std::uint32_t> all;  // that the driver gave
    };

    void generate(const Command& command);
    void selection_buffer(int size);
    void feedback_buffer(int size, Enum type);
    Command translated(const Command& command);
    std::uint32_t new_name(ObjectType type);
    void delete_lists(const Command& command);
    void empty_lists();

    bool may_see(const Command& command);
    bool may_see_arrays(const Command& command);
    bool may_see_lists(const Command& command);
    bool may_see_pixels(const Command& command);
    static bool may_see_stipple(const Command& command);
    static bool may_copy_pixels(const Command& command);
    // Whether the driver answers queries: between glBegin and glEnd it does not, and carries out few commands.
    static bool answers();
    static bool is_compiling();  // a display list
    // Whether arrays_ is what the driver has, as far as it answers.
    bool arrays_agree();
    bool holds_arrays() const;
    bool holds(const ArrayPointer& array, Enum name) const;

    std::optional<InitialState> initial_;
    Executor executor_;
    std::map<ObjectType, Names> names_;
    std::set<std::uint32_t> lists_;                       // that the scene compiled
    std::set<std::uint32_t> kept_lists_, emptied_lists_;  // those that are there always; to be emptied after glEndList
    VertexArrays arrays_;                                 // as the driver should have them
    bool arrays_may_differ_ = false;                      // since the driver was asked
    bool arrays_agreed_ = true;                           // when it was asked
    std::vector<std::uint32_t> selection_;                // where the driver writes what glRenderMode asks for
    std::vector<float> feedback_;
    bool selects_ = false;  // the scene has set them, or the mode
};

struct Options {
    std::optional<Shading> shading{};  // instead of every glShadeModel: kFlat or kGouraud
};

// Throws std::invalid_argument for what the fixed function cannot do: Shading::kPhong and Shading::kExact.
void check_shading(const std::optional<Shading>& shading);

// Clears to black and depth 1, executes the scene's commands, reads the picture. Throws as check_shading() does.
Image render(const Scene& scene, const Options& options = {});
// The same without reading back: leaves the picture in the current colour buffer.
void draw(const Scene& scene, const Options& options = {});

}  // namespace twinlight::fixed
