// Framebuffer objects in a dump: those that are shown in the window, and copies between them.
//
// Some toolkits (Qt's QOpenGLWidget, GTK's GtkGLArea) let a program draw into an object, which they show in the window later, by
// another context; some programs draw into an object and copy it to the window. Such an object is read as if it were the window.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "scene/command/command.h"

namespace twinlight::trace {

class Framebuffers {
  public:
    // From now on these objects are the window.
    void show(std::set<double> names) { shown_ = std::move(names); }
    bool any_shown() const { return !shown_.empty(); }

    // Follows a command, and names the window in place of an object that is shown. Returns false if the command only concerns
    // such an object, so that nothing of it is left.
    bool follow(Command& command);

    // glBlitFramebuffer (EXT_framebuffer_blit; OpenGL 3.0, section 4.3.3) in commands of OpenGL 2.1: none if it only shows an
    // object that is shown anyway; nullopt if it cannot be said so. `numbers`: its arguments.
    std::optional<std::vector<Command>> blit(std::span<const double> numbers, const Place& place) const;

  private:
    double name_of(double name) const { return shown_.contains(name) ? 0 : name; }

    std::set<double> shown_;
    double draw_ = 0, read_ = 0;           // the bound objects, as the program names them
    std::map<double, double> textures_{};  // of each object: the texture that is its colours
};

}  // namespace twinlight::trace
