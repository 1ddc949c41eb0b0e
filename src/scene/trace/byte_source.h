// Bytes from somewhere, read once from the front to the back.
#pragma once

#include <cstddef>

namespace twinlight::trace {

class ByteSource {
  public:
    virtual ~ByteSource() = default;
    // Puts the next bytes at `to`: `size` of them at most, one at least; none at the end. Throws SceneError where they
    // cannot be read.
    virtual std::size_t read(char* to, std::size_t size) = 0;
};

}  // namespace twinlight::trace
