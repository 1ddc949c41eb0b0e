// The GL contexts of a recording: how much each draws, and which share objects.
//
// A program has a context for each window, or several: for labels, panels, a picture that loads. Twinlight draws one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/command/command.h"
#include "scene/trace/functions.h"

namespace twinlight::trace {

// A GL context, identified by its handle in the window system.
using ContextName = double;

// More than programs have; a hostile dump may name any number.
inline constexpr std::size_t kMostContexts = 4096, kMostThreads = 4096;

struct ContextUse {
    ContextName name = 0;
    // What it sent to be drawn by the fixed function, through display lists too. Bitmaps and other pixels count as one vertex each.
    double vertices = 0;
    double by_shaders = 0;                // the same, drawn by shaders
    bool has_elements = false;            // it calls glArrayElement
    bool has_buffers = false;             // it binds buffer objects
    bool has_samples = false;             // it makes renderbuffers with several samples per pixel
    bool draws_to_window = false;         // into framebuffer 0
    bool draws_to_objects = false;        // into others
    std::set<double> ends_in{};           // framebuffer objects into which it drew last before a frame ended
    double program = 0, framebuffer = 0;  // the bound ones
    double drawn_into = 0;                // the object into which it drew last; 0 since a frame ended

    // The framebuffer objects that show what it draws, if nothing is drawn into the window itself.
    std::set<double> shown_objects() const { return draws_to_window ? std::set<double>{} : ends_in; }
};

// Counts what each context draws, in the order in which the contexts first became current. Commands before the first
// context, as in a dump without the calls of the window system, belong to no context.
class ContextCounts {
  public:
    void make_current(unsigned thread, ContextName context);
    // Whether count() needs the arguments of this function.
    static bool needs_arguments(const Function& function, std::string_view name);
    // Counts a call that is executed in this thread. `numbers`: its arguments, if needed.
    void count(unsigned thread, const Function& function, std::string_view name, std::span<const double> numbers);

    const std::vector<ContextUse>& contexts() const { return contexts_; }
    // The one that draws most by the fixed function, or by shaders if none does so, the first of several that draw as much; nullopt if
    // none draws, or if most is drawn in no context.
    std::optional<std::size_t> busiest() const;
    // Whether what this one draws may still go into objects that were not seen yet.
    bool busiest_draws_into_objects() const;
    bool any_draws() const { return all() > 0; }
    double all() const;  // what all contexts draw

  private:
    struct Use {
        std::optional<std::size_t> context;
        std::optional<double> list;  // that is being compiled
        bool executes = true;        // false while GL_COMPILE is on
    };

    void add(Use& use, double vertices);

    std::vector<ContextUse> contexts_;
    double without_context_ = 0;
    std::map<unsigned, Use> uses_;            // of each thread
    std::map<double, double> list_vertices_;  // of each display list
};

// The objects that other contexts make and share with the one that is followed.
class SharedObjects {
  public:
    // Another context calls a function; `numbers`: its arguments, if it names shared objects. Returns whether it makes or changes
    // such an object.
    bool makes(ContextName context, const Function& function, std::string_view name, std::span<const double> numbers);
    // The one that makes() found; nullopt if the recording does not show which.
    const std::optional<SharedObject>& made() const { return made_; }

  private:
    static std::optional<SharedObject> named_by(std::string_view function, std::span<const double> numbers);

    std::map<std::pair<ContextName, SharedObject::Kind>, std::uint32_t> bound_;  // in other contexts
    std::optional<SharedObject> made_;
};

// Which contexts share textures, display lists and buffer objects.
class ShareGroups {
  public:
    void create(ContextName context, ContextName share);  // share: 0 for none
    // True also where the recording does not show how one of them was made.
    bool may_share(ContextName a, ContextName b) const;

  private:
    std::map<ContextName, ContextName> group_of_;
};

// "context 1 draws 300 vertices, context 0 draws 12 with shaders": those that draw, the busiest first; nothing if none does.
std::string list_of_contexts(const std::vector<ContextUse>& contexts);

}  // namespace twinlight::trace
