// The contexts of programs without a window: of the GL that the user chooses.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "render/context/context.h"
#include "render/context/entry_points.h"
#include "render/context/library.h"
#include "render/context/provider.h"

namespace twinlight {

namespace {

constexpr const char* kOsmesa = "libOSMesa.so.8";
constexpr const char* kEgl = "libEGL.so.1";

struct Loaded {
    Library library;
    Provider provider;
};

std::string& choice() {
    static std::string name;
    return name;
}

std::string chosen() {
    const char* variable = std::getenv("TWINLIGHT_GL");
    return !choice().empty() || !variable ? choice() : variable;
}

std::optional<Library> if_there(const char* file) {
    try {
        return Library(file);
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

// The same pictures on each machine: no GPU's driver.
Loaded load_default() {
    if (const auto library = if_there(kOsmesa)) return {*library, osmesa_provider(*library)};
    if (const auto library = if_there(kEgl)) return {*library, egl_provider(*library, EglDevices::kSoftware)};
    throw std::runtime_error(
        fmt::format("this system has neither {} nor {}; install OSMesa (libosmesa6) or EGL (libegl1 and libegl-mesa0)",
                    kOsmesa, kEgl));
}

Loaded load_file(const std::string& file) {
    const Library library(file);
    if (is_osmesa(library)) return {library, osmesa_provider(library)};
    if (is_egl(library)) return {library, egl_provider(library, EglDevices::kAll)};
    if (is_glx(library)) return {library, glx_provider(library)};
    throw std::runtime_error(library.path() + " has no functions that make a context");
}

Loaded load(const std::string& name) {
    if (name.empty()) return load_default();
    try {
        return load_file(name == "osmesa" ? kOsmesa : name == "egl" ? kEgl : name);
    } catch (const std::runtime_error& error) {
        std::error_code ignored;
        const bool is_here = name.find('/') == std::string::npos && std::filesystem::is_regular_file(name, ignored);
        throw std::runtime_error(fmt::format("the GL '{}' cannot be used: {}; {}", name, error.what(),
                                             is_here
                                                 ? fmt::format("did you mean ./{}?", name)
                                                 : "give osmesa, egl, or the file of a libOSMesa, libEGL or libGL"));
    }
}

// Loads it at the first call; tries again if that failed.
const Loaded& loaded() {
    static const Loaded gl = [] {
        Loaded now = load(chosen());
        for (std::size_t i = 0; i < kEntryPoints; ++i) {
            void* const exported = now.library.address(entry_points[i].name);
            entry_points[i].address = exported ? exported : now.provider.address(entry_points[i].name);
        }
        return now;
    }();
    return gl;
}

}  // namespace

void throw_missing_function(const EntryPoint& function) {
    throw std::runtime_error(fmt::format("{} has no function {}", gl_library(), function.name));
}

void choose_gl(const std::string& name) { choice() = name; }

const std::string& gl_library() { return loaded().library.path(); }

std::string_view context_provider() { return loaded().provider.name; }

std::unique_ptr<OffscreenContext> make_offscreen_context(int width, int height, ColorBuffer color_buffer) {
    return loaded().provider.make_context(width, height, color_buffer);
}

}  // namespace twinlight
