#include "render/context/library.h"

#include <dlfcn.h>
#include <link.h>

#include <stdexcept>

#include "base/text/translation.h"

namespace twinlight {

Library::Library(const std::string& file) : handle_(::dlopen(file.c_str(), RTLD_NOW)) {
    if (!handle_) throw std::runtime_error(::dlerror());
    ::link_map* map = nullptr;
    path_ = ::dlinfo(handle_, RTLD_DI_LINKMAP, &map) == 0 ? map->l_name : file;
}

void* Library::address(const char* name) const { return ::dlsym(handle_, name); }

void* Library::needed(const char* name) const {
    void* const found = address(name);
    if (!found) throw std::runtime_error(tr("{} has no function {}", path_, name));
    return found;
}

}  // namespace twinlight
