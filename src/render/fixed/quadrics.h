// GLU's quadrics, literally: the numbers of Commands are quadric objects of the GLU library, which sends their shapes.
#pragma once

#include <map>
#include <memory>

#include "scene/command/command.h"
#include "scene/shape/quadric.h"

class GLUquadric;  // of <GL/glu.h>

namespace twinlight::fixed {

class Quadrics {
  public:
    // A command of Family::kQuadric, or one that draws a quadric. Does nothing for a number that is no quadric (any more).
    void execute(const Command& command);

  private:
    struct Delete {
        void operator()(GLUquadric* object) const;
    };
    struct Entry {
        std::unique_ptr<GLUquadric, Delete> object;
        Quadric quadric;  // what it has been told: GLU does not tell it back
    };

    static void set(Entry& entry, const Command& command);
    static void draw(const Entry& entry, const Command& command);

    std::map<double, Entry> entries_;
};

}  // namespace twinlight::fixed
