#include "app/web/page_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "judge/compare/tolerance.h"
#include "judge/explain/explain.h"
#include "judge/lint/lint.h"
#include "render/reference/copied_pixels.h"
#include "render/reference/framebuffer.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/scenes/images.h"
#include "scene/scenes/load.h"
#include "scene/scenes/meshes.h"
#include "scene/state/state.h"

namespace twinlight::web {

namespace {

using Json = nlohmann::ordered_json;

// A scene's text may hold any bytes, but JSON is UTF-8.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

CommandList read(std::string_view text, const std::string& name, const std::string& step) {
    if (text.size() > kMaxPageBytes)
        throw SceneError(
            fmt::format("{}: is larger than {} MiB, the limit of this page; the program twinlight can draw it", name,
                        kMaxPageBytes >> 20));
    return read_scene(text, name + ".gl", name, images_built_in, {.step = step, .load_mesh = meshes_built_in});
}

Json errors_of(const SceneError& error) {
    Json errors = Json::array();
    for (const TextError& one : error.errors)
        errors.push_back({{"line", one.place.line}, {"column", one.place.column}, {"message", one.message}});
    if (errors.empty()) errors.push_back({{"line", 0}, {"column", 0}, {"message", error.what()}});
    return errors;
}

}  // namespace

std::string built_in_scenes() {
    Json scenes = Json::array();
    for (const EmbeddedFile& file : kSceneFiles) {
        const CommandList list = read_built_in(file);
        scenes.push_back({{"name", list.name}, {"text", file.text}, {"steps", list.steps}});
    }
    return dumped({{"scenes", scenes}});
}

std::string PageScene::open(std::string_view text, const std::string& name, const std::string& step, WindowSize size) {
    scene_.reset();
    staged_.reset();
    right_.reset();
    StateOptions options;
    options.width = size.width;
    options.height = size.height;
    Json answer = {{"errors", Json::array()}, {"note", ""}};
    try {
        const auto list = std::make_shared<const CommandList>(read(text, name, step));
        answer["steps"] = list->steps;
        answer["step"] = list->step;
        if (list->window) {
            options.width = list->window->width;
            options.height = list->window->height;
        }
        scene_ = make_scene(list, options);
        answer["width"] = scene_->frame.width;
        answer["height"] = scene_->frame.height;
    } catch (const SceneError& error) {
        const SceneError all = with_gl_errors(error, options);
        answer["errors"] = errors_of(all);
        answer["note"] = all.note;
    }
    return dumped(answer);
}

std::string PageScene::warnings() const { return lint::json_text(scene_->name(), lint::lint(*scene_)); }

PageScene::Staged::Staged(const Frame& of, const reference::Options& with)
    : options(with),
      frame(reference::drawable(of, with)),
      stages(run_stages(*frame, with)),
      image(of.width, of.height) {}

std::span<const std::uint8_t> PageScene::reference(const reference::Options& options, int y0, int y1) {
    if (!staged_ || staged_->options != options) {
        staged_.reset();
        staged_ = std::make_unique<Staged>(scene_->frame, options);
    }
    Image& image = staged_->image;
    // A picture's rows count from the top, a window's from the bottom.
    draw_pixels(staged_->stages, options, {0, image.height - y1, image.width, image.height - y0}, image);
    codes_.clear();
    for (std::size_t i = image.index(0, y0); i < image.index(0, y1); ++i)
        for (const float channel : image.pixels[i]) codes_.push_back(channel_code(channel));
    return codes_;
}

WebglFrame PageScene::webgl(const Look& look) const {
    const DrawableFrame frame = reference::drawable(scene_->frame, {look});
    return webgl_frame(*frame, {look, /*budget=*/0});
}

std::string PageScene::judged(const Look& look, std::span<const std::uint8_t> shaders, int subpixel_bits) {
    const Frame& frame = scene_->frame;
    if (!right_ || right_->look != look || right_->subpixel_bits != subpixel_bits) {
        Right right{
            look, subpixel_bits, reference::render(frame, {look}), {}, reference::allowed_difference(frame, {look})};
        if (reference::has_quadrilaterals(frame))
            right.other_cut = reference::render(frame, {look, reference::QuadCut::kSecondToFourth});
        compare::allow_ties(right.allowed, right.image);
        compare::allow_rounded_positions(right.allowed, right.image, subpixel_bits);
        right_ = std::move(right);
    }
    Image drawn(frame.width, frame.height);
    if (shaders.size() != 4 * drawn.pixels.size()) throw std::invalid_argument("a picture of another size");
    for (std::size_t i = 0; i < shaders.size(); ++i) drawn.pixels[i / 4][i % 4] = static_cast<float>(shaders[i]) / 255;
    const Image nearer = right_->other_cut.pixels.empty()
                             ? right_->image
                             : nearer_of(drawn, right_->image, right_->other_cut, right_->allowed.channels);
    const ImageDifference found = difference(drawn, nearer, right_->allowed);
    return dumped({{"within", compare::is_within(found, {})},
                   {"max", std::lround(255 * found.interior.max)},
                   {"at", {found.interior.worst_x, found.interior.worst_y}},
                   {"beyond", std::lround(255 * found.beyond_allowed.max)},
                   {"differing", found.beyond_allowed.differing},
                   {"interior", found.interior.pixels},
                   {"edge", found.edge.pixels}});
}

std::string PageScene::explained(const Look& look, int x, int y) const {
    return explain::text_of(*scene_, explain::explain_pixel(scene_->frame, look, {x, y}), {});
}

}  // namespace twinlight::web
