// Which contexts of a recording draw into windows with several samples per pixel (multisampling), from the calls of GLX and
// EGL that choose pixel formats. (apitrace's dumps lack those that only describe them, such as glXGetFBConfigAttrib.)
#pragma once

#include <optional>
#include <set>
#include <string_view>

#include "scene/command/command.h"
#include "scene/trace/arguments.h"

namespace twinlight::trace {

// The value of GLX_SAMPLES and the like; nullopt for attributes that decide nothing here.
std::optional<Enum> sample_attribute(std::string_view name);

class WindowFormats {
  public:
    // Whether take() needs the calls of this function.
    static bool is_needed(std::string_view function);
    void take(std::string_view function, const Arguments& arguments, const Arguments& result);

    // `context`: its handle in the window system.
    bool has_samples(double context) const { return contexts_.contains(context); }

  private:
    // Both with several samples. A format is identified by its handle, or by the number of its X visual.
    std::set<double> formats_, contexts_;
};

}  // namespace twinlight::trace
