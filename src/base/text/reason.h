// Why something failed, for people.
#pragma once

#include <exception>
#include <new>
#include <string>

#include "base/text/translation.h"

namespace twinlight {

// The exception's text; "out of memory" for std::bad_alloc, whose own text is its name.
inline std::string reason_of(const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? tr("out of memory") : error.what();
}

}  // namespace twinlight
