#include "scene/trace/window_formats.h"

#include <algorithm>
#include <span>

#include "scene/trace/functions.h"

namespace twinlight::trace {

namespace {

using Form = Argument::Form;

constexpr std::size_t kMostFormats = 4096;  // more than there are; a hostile dump may name any number

constexpr Enum kGLX_SAMPLE_BUFFERS = 100000, kGLX_SAMPLES = 100001, kEGL_SAMPLES = 0x3031, kEGL_SAMPLE_BUFFERS = 0x3032;

// Whether the list of attributes asks for more than one sample.
bool asks_for_samples(std::span<const double> attributes) {
    for (std::size_t i = 0; i + 1 < attributes.size(); ++i) {
        const double attribute = attributes[i], value = attributes[i + 1];
        if ((attribute == kGLX_SAMPLES || attribute == kEGL_SAMPLES) && value > 1) return true;
        if ((attribute == kGLX_SAMPLE_BUFFERS || attribute == kEGL_SAMPLE_BUFFERS) && value > 0) return true;
    }
    return false;
}

// The values of an argument or a result.
std::span<const double> values(const Arguments& from, std::size_t i) {
    if (i >= from.list.size()) return {};
    const Argument& argument = from.list[i];
    if (argument.first > from.numbers.size()) return {};
    return std::span(from.numbers)
        .subspan(argument.first, std::min(argument.count, from.numbers.size() - argument.first));
}

// The format that an argument names: by a handle, or by an X visual, &{visual = 0x55d0, visualid = 992, ...}.
std::optional<double> format(const Arguments& from, std::size_t i) {
    const std::span<const double> all = values(from, i);
    const std::size_t at = i < from.list.size() && from.list[i].form == Form::kOther ? 1 : 0;
    return at < all.size() ? std::optional(all[at]) : std::nullopt;
}

}  // namespace

std::optional<Enum> sample_attribute(std::string_view name) {
    if (name == "GLX_SAMPLES") return kGLX_SAMPLES;
    if (name == "GLX_SAMPLE_BUFFERS") return kGLX_SAMPLE_BUFFERS;
    if (name == "EGL_SAMPLES") return kEGL_SAMPLES;
    if (name == "EGL_SAMPLE_BUFFERS") return kEGL_SAMPLE_BUFFERS;
    return std::nullopt;
}

bool WindowFormats::is_needed(std::string_view function) {
    return function == "glXChooseFBConfig" || function == "glXChooseVisual" || function == "eglChooseConfig" ||
           function == "glXGetVisualFromFBConfig" || makes_context(function);
}

void WindowFormats::take(std::string_view function, const Arguments& arguments, const Arguments& result) {
    const auto add = [](std::set<double>& to, std::optional<double> handle) {
        if (handle && to.size() < kMostFormats) to.insert(*handle);
    };
    const auto has_samples = [&](std::optional<double> handle) { return handle && formats_.contains(*handle); };
    if (function == "glXChooseFBConfig") {  // = {configs}
        if (asks_for_samples(arguments.numbers))
            for (const double config : values(result, 0)) add(formats_, config);
    } else if (function == "glXChooseVisual") {  // = visual
        if (asks_for_samples(arguments.numbers)) add(formats_, format(result, 0));
    } else if (function == "eglChooseConfig") {  // (display, attributes, configs, ...)
        if (asks_for_samples(values(arguments, 1)))
            for (const double config : values(arguments, 2)) add(formats_, config);
    } else if (function == "glXGetVisualFromFBConfig") {  // (display, config) = visual
        if (has_samples(format(arguments, 1))) add(formats_, format(result, 0));
    } else if (makes_context(function)) {  // (display, format, ...) = context
        if (has_samples(format(arguments, 1))) add(contexts_, format(result, 0));
    }
}

}  // namespace twinlight::trace
