// A shared library that is loaded while the program runs.
#pragma once

#include <string>

namespace twinlight {

// It stays loaded to the end of the process, because drivers do not bear to be unloaded.
class Library {
  public:
    // A file, or a name that the system looks for (LD_LIBRARY_PATH, ld.so.conf). Throws std::runtime_error with the system's reason.
    explicit Library(const std::string& file);

    // nullptr if it has no such function.
    void* address(const char* name) const;
    bool has(const char* name) const { return address(name) != nullptr; }
    // Throws std::runtime_error if it has no such function.
    template <class F>
    void find(const char* name, F*& function) const {
        function = reinterpret_cast<F*>(needed(name));
    }
    // The file that the system took for it: "/usr/lib/x86_64-linux-gnu/libOSMesa.so.8".
    const std::string& path() const { return path_; }

  private:
    void* needed(const char* name) const;

    void* handle_;
    std::string path_;
};

}  // namespace twinlight
