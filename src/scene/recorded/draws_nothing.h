// Why a recorded program draws nothing.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "scene/command/command.h"

namespace twinlight {

// Counts the calls of a recording that draw nothing although their program meant to draw, or that draw in a way that
// Twinlight lacks.
class DrawsNothing {
  public:
    void take(const Step& step);
    // "glEvalMesh2 (12 times) is not drawn by Twinlight; ..." `frames`: the complete frames; `errors`: GL errors.
    std::string why(int frames, std::size_t errors) const;

  private:
    std::size_t commands_ = 0;
    std::map<std::string, std::size_t, std::less<>> drawing_;  // drawing commands, by name
    std::map<std::string, std::size_t, std::less<>> outside_;  // functions that are not commands
    bool in_list_ = false;
    std::size_t drawing_in_lists_ = 0;
};

}  // namespace twinlight
