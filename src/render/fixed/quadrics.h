// GLU's quadrics, literally: each number in a Command is a quadric object of the GLU library, which draws the shapes.
#pragma once

#include <map>
#include <memory>

#include "scene/command/command.h"
#include "scene/shape/quadric.h"

class GLUquadric;  // of <GL/glu.h>

namespace twinlight::fixed {

class Quadrics {
  public:
    // Executes a command of Family::kQuadric, or one that draws a quadric. Does nothing if the number is not (or no
    // longer) a quadric.
    void execute(const Command& command);

  private:
    struct Delete {
        void operator()(GLUquadric* object) const;
    };
    struct Entry {
        std::unique_ptr<GLUquadric, Delete> object;
        Quadric quadric;  // its settings, which GLU cannot return
    };

    static void set(Entry& entry, const Command& command);
    static void draw(const Entry& entry, const Command& command);

    std::map<double, Entry> entries_;
};

}  // namespace twinlight::fixed
