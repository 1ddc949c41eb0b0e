// The functions that the page calls, for Emscripten. Texts come and go as UTF-8 with a zero at the end; an answer stays until the
// next call. page/twinlight.js has the same functions for JavaScript.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "app/web/dropped_files.h"
#include "app/web/page_lessons.h"
#include "app/web/page_probe.h"
#include "app/web/page_scene.h"
#include "base/text/json.h"

namespace twinlight::web {
namespace {

PageScene scene;
webgl::WebglFrame frame;
DroppedFiles files;
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

template <class Work>
const std::uint8_t* drawn(const Work& work) {
    const std::uint8_t* pixels = nullptr;
    answered([&] {
        pixels = work().data();
        return std::string();
    });
    return pixels;
}

lesson::Language language_of(const char* name) {
    return lesson::find_language(name).value_or(lesson::Language::kEnglish);
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

// "recording", or "" for another file.
EXPORT const char* kind_of_file(const char* name, const char* front, int count) {
    return answered([&] { return is_recording({front, static_cast<std::size_t>(count)}, name) ? "recording" : ""; });
}
EXPORT const char* add_file(const char* name, const std::uint8_t* bytes, int count) {
    return answered([&] {
        files.add(name, {bytes, static_cast<std::size_t>(count)});
        return "";
    });
}
EXPORT const char* scene_of_recording(const char* name) {
    return answered([&] { return files.scene_of_recording(name); });
}

// A picture, mesh or material file for the scenes that are opened after this.
EXPORT const char* keep_file(const char* name, const char* bytes, int count) {
    return answered([&] {
        scene.keep_file(name, std::string(bytes, static_cast<std::size_t>(count)));
        return "";
    });
}

EXPORT const char* key_list() { return answered(page_keys); }
EXPORT const char* press_key(int code) {
    return answered([&] { return scene.controls().press(code); });
}
EXPORT void start_drag(int may_go_under) {
    if (scene.is_open()) scene.controls().start_drag(may_go_under != 0);
}
EXPORT const char* drag(int looks, int dx, int dy) {
    return answered([&] { return scene.controls().drag(looks != 0, dx, dy); });
}
EXPORT void end_drag() {
    if (scene.is_open()) scene.controls().end_drag();
}
EXPORT const char* zoom(int steps) {
    return answered([&] { return scene.controls().zoom(steps); });
}

EXPORT const char* number_list() {
    return answered([&] { return scene.controls().numbers(); });
}
EXPORT const char* set_argument(int command, int argument, double value) {
    return answered([&] {
        return scene.controls().set_argument(static_cast<std::size_t>(command), static_cast<std::size_t>(argument),
                                             value);
    });
}

EXPORT const char* tutor_list() { return answered(page_tutors); }
EXPORT const char* call_list() {
    return answered([&] { return scene.controls().calls(); });
}
// As webgl_header(), of the scene from outside.
EXPORT const char* world_header() {
    return answered([&] {
        frame = scene.controls().world();
        return twinlight::dumped(frame.header);
    });
}
EXPORT void press_world(int x, int y) {
    if (scene.is_open()) scene.controls().press_world(x, y);
}
EXPORT const char* drag_world(int dx, int dy) {
    return answered([&] { return scene.controls().drag_world(dx, dy); });
}
EXPORT const char* zoom_world(int steps) {
    return answered([&] { return scene.controls().zoom_world(steps); });
}

EXPORT const char* lesson_list(const char* language) {
    return answered([&] { return page_lessons(language_of(language)); });
}
EXPORT const char* read_own_lesson(const char* name, const char* language, const char* text) {
    return answered([&] { return own_lesson(name, language_of(language), text); });
}
EXPORT const char* check_answer(const char* name, const char* language, const char* answer_text, const char* own_text) {
    return answered([&] { return checked_answer(name, language_of(language), answer_text, own_text); });
}

EXPORT const char* forms(int shading) {
    return answered([&] { return scene.forms(look_of(shading)); });
}
EXPORT const char* export_scene(const char* form, int shading) {
    return answered([&] { return scene.exported(form, look_of(shading)); });
}

EXPORT const char* lint_scene() {
    return answered([] { return scene.warnings(); });
}

// Pictures as bytes; null after an exception.
EXPORT const std::uint8_t* reference_rows(int shading, int as_floats, int y0, int y1) {
    return drawn([&] { return scene.reference(reference_options(shading, as_floats != 0), y0, y1); });
}
EXPORT const std::uint8_t* coarse_reference(int shading, int as_floats) {
    return drawn([&] { return scene.coarse_reference(reference_options(shading, as_floats != 0)); });
}
EXPORT const float* reference_floats(int y0, int y1) { return scene.reference_floats(y0, y1).data(); }

// The frame's header; webgl_words() has its words until the next call.
EXPORT const char* webgl_header(int shading) {
    return answered([&] {
        frame = scene.webgl_frame(look_of(shading));
        return twinlight::dumped(frame.header);
    });
}
EXPORT const std::uint32_t* webgl_words() { return frame.words.data(); }
EXPORT int webgl_word_count() { return static_cast<int>(frame.words.size()); }

// `channels`: the number of bytes in `pixels`, and of floats in `reference`.
EXPORT const char* judge_picture(int shading, const std::uint8_t* pixels, const float* reference, int channels,
                                 int subpixel_bits) {
    const auto count = static_cast<std::size_t>(channels);
    return answered([&] { return scene.judged(look_of(shading), {pixels, count}, {reference, count}, subpixel_bits); });
}

EXPORT const char* probe_pixel(int shading, int x, int y) {
    return answered([&] { return probed(scene.scene(), look_of(shading), x, y); });
}
EXPORT const char* explain_pixel(int shading, int x, int y) {
    return answered([&] { return scene.explained(look_of(shading), x, y); });
}
