// What makes contexts, and where GL's functions come from: one of three kinds of library.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "render/context/context.h"
#include "render/context/library.h"

namespace twinlight {

struct Provider {
    std::string_view name;  // context_provider()
    // As make_offscreen_context().
    std::function<std::unique_ptr<OffscreenContext>(int width, int height, ColorBuffer)> make_context;
    // A function of GL that the library has but does not export; nullptr if it does not know the name.
    std::function<void*(const char* name)> address;
};

// Which of EGL's devices draw. Those of GPUs are tried first.
enum class EglDevices { kAll, kSoftware };

// Whether a library has the functions of such a provider.
bool is_osmesa(const Library& library);
bool is_egl(const Library& library);
bool is_glx(const Library& library);

// They throw std::runtime_error if the library lacks a function. What they return uses the library.
Provider osmesa_provider(const Library& library);
Provider egl_provider(const Library& library, EglDevices devices);
Provider glx_provider(const Library& library);

}  // namespace twinlight
