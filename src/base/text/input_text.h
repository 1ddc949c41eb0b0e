// Text to read with std::getline or >>. A std::istringstream hides that memory is short, and gives too little text.
#pragma once

#include <sstream>
#include <string>

namespace twinlight {

class InputText : public std::istringstream {
  public:
    explicit InputText(const std::string& text) : std::istringstream(text) { exceptions(std::ios::badbit); }
};

}  // namespace twinlight
