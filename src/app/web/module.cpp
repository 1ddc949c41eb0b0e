// The functions that the page calls, for Emscripten. Texts come and go as UTF-8 with a zero at the end; an answer stays until the
// next call. page/twinlight.js has the same functions for JavaScript.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "app/web/page_scene.h"

namespace twinlight::web {
namespace {

PageScene scene;
WebglFrame frame;
std::string answer, failure;

// Returns the answer, or null after an exception; then failure() says why.
template <class Work>
const char* answered(const Work& work) {
    failure.clear();
    try {
        answer = work();
        return answer.c_str();
    } catch (const std::bad_alloc&) {
        failure = "this scene needs more memory than a page gets; make it smaller, or use the program twinlight";
    } catch (const std::exception& error) {
        failure = error.what();
    }
    return nullptr;
}

// shading: a number of Shading, or -1 for the scene's own.
Look look_of(int shading) {
    Look look;
    if (shading >= 0) look.shading = static_cast<Shading>(shading);
    return look;
}

reference::Options reference_options(int shading, bool as_floats) {
    reference::Options options{look_of(shading)};
    if (as_floats) {
        options.arithmetic.number = Number::kFloat;
        options.lecture_variants = false;  // as GL computes
    }
    return options;
}

}  // namespace
}  // namespace twinlight::web

using namespace twinlight::web;  // NOLINT: the exports have no namespace

#define EXPORT extern "C" __attribute__((used, visibility("default")))

EXPORT void* allocate(std::size_t bytes) { return std::malloc(bytes); }
EXPORT void release(void* memory) { std::free(memory); }
EXPORT const char* failure_text() { return failure.c_str(); }

EXPORT const char* built_in() { return answered(built_in_scenes); }

EXPORT const char* open_scene(const char* text, const char* name, const char* step, int width, int height) {
    return answered([&] { return scene.open(text, name, step, {width, height}); });
}

EXPORT const char* lint_scene() {
    return answered([] { return scene.warnings(); });
}

EXPORT const std::uint8_t* reference_rows(int shading, int as_floats, int y0, int y1) {
    const std::uint8_t* pixels = nullptr;
    answered([&] {
        pixels = scene.reference(reference_options(shading, as_floats != 0), y0, y1).data();
        return std::string();
    });
    return pixels;
}

// The frame's header; webgl_words() has its words until the next call.
EXPORT const char* webgl_header(int shading) {
    return answered([&] {
        frame = scene.webgl(look_of(shading));
        return std::move(frame.header);
    });
}
EXPORT const std::uint32_t* webgl_words() { return frame.words.data(); }
EXPORT int webgl_word_count() { return static_cast<int>(frame.words.size()); }

EXPORT const char* judge_picture(int shading, const std::uint8_t* pixels, int bytes, int subpixel_bits) {
    return answered([&] {
        return scene.judged(look_of(shading), {pixels, static_cast<std::size_t>(bytes)}, subpixel_bits);
    });
}

EXPORT const char* explain_pixel(int shading, int x, int y) {
    return answered([&] { return scene.explained(look_of(shading), x, y); });
}
