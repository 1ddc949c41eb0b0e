#include "app/web/page_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "base/text/json.h"
#include "judge/compare/tolerance.h"
#include "judge/explain/explain.h"
#include "judge/lint/lint.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/export/shader_text.h"
#include "render/reference/copied_pixels.h"
#include "render/reference/framebuffer.h"
#include "render/reference/reference.h"
#include "render/webgl/exported_page.h"
#include "scene/command/text.h"
#include "scene/frame/picture_memory.h"
#include "scene/frame/resized.h"
#include "scene/scenes/caption.h"
#include "scene/scenes/images.h"
#include "scene/scenes/load.h"
#include "scene/scenes/meshes.h"
#include "scene/shape/written_out.h"
#include "scene/state/state.h"

namespace twinlight::web {

namespace {

Json errors_of(const SceneError& error) {
    Json errors = Json::array();
    for (const TextError& one : error.errors)
        errors.push_back({{"line", one.place.line}, {"column", one.place.column}, {"message", one.message}});
    if (errors.empty()) errors.push_back({{"line", 0}, {"column", 0}, {"message", error.what()}});
    return errors;
}

void check_fits(const Frame& frame) {
    const std::uint64_t bytes = bytes_of_pictures(frame, kPageBytesOfPixel) + bytes_of_scene(frame);
    if (bytes <= kPageMemory) return;
    throw SceneError(fmt::format(
        "pictures of {} x {} need {:.2g} GB of memory, and this page has {:.2g}; choose a smaller window, or "
        "use the program twinlight",
        frame.width, frame.height, static_cast<double>(bytes) / 1e9, static_cast<double>(kPageMemory) / 1e9));
}

}  // namespace

CommandList read_for_page(std::string_view text, const std::string& name, const std::string& step,
                          const FileFinder& find) {
    if (text.size() > kMaxPageBytes)
        throw SceneError(
            fmt::format("{}: is larger than {} MiB, the limit of this page; the program twinlight can draw it", name,
                        kMaxPageBytes >> 20));
    const auto needed = [&](const std::string& file) {
        if (!find(file)) throw std::runtime_error("the page does not have this file; drop it on the page");
    };
    const auto image = [&](const std::string& file) {
        needed(file);
        return images_in(find)(file);
    };
    const auto mesh = [&](const std::string& file) {
        needed(file);
        return meshes_in(find)(file);
    };
    return read_scene(text, name + ".gl", name, image, {.step = step, .load_mesh = mesh});
}

std::string built_in_scenes() {
    Json scenes = Json::array();
    for (const EmbeddedFile& file : kSceneFiles)
        scenes.push_back({{"name", built_in_name(file)}, {"text", file.text}, {"shows", caption_of(file.text).title}});
    return dumped({{"scenes", scenes}});
}

std::string PageScene::open(std::string_view text, const std::string& name, const std::string& step, WindowSize size) {
    scene_.reset();
    staged_.reset();
    const auto read = [this, name, step](std::string_view given) {
        return read_for_page(given, name, step, [this](std::string_view file) -> std::optional<std::string_view> {
            const auto kept = files_.find(file);
            if (kept != files_.end()) return kept->second;
            return built_in_file(file);
        });
    };
    StateOptions options;
    options.width = size.width;
    options.height = size.height;
    Json answer = {{"errors", Json::array()}, {"note", ""}};
    try {
        const auto list = std::make_shared<const CommandList>(read(text));
        answer["steps"] = list->steps;
        answer["step"] = list->step;
        if (list->window) {
            options.width = list->window->width;
            options.height = list->window->height;
        }
        options.memory = kPageMemory;
        scene_ = make_scene(list, options);
        check_fits(scene_->frame);
        for (const std::string& note : scene_->recording->notes())
            answer["note"] = answer["note"].get<std::string>() + (answer["note"] == "" ? "" : "; ") + note;
        if (controls_ && !controls_->shows(text, list->step)) controls_.reset();
        opened_ = {list, std::string(text), {options.width, options.height}, read};
        const Caption caption = caption_of(text);
        answer["caption"] = {caption.title, caption.notice};
        answer["width"] = scene_->frame.width;
        answer["height"] = scene_->frame.height;
    } catch (const SceneError& error) {
        const SceneError all = with_gl_errors(error, options);
        answer["errors"] = errors_of(all);
        answer["note"] = all.note;
    }
    return dumped(answer);
}

PageControls& PageScene::controls() {
    if (!is_open()) throw std::logic_error("no scene is open");
    if (!controls_) controls_.emplace(opened_.commands, opened_.text, opened_.size, opened_.read);
    return *controls_;
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
    return codes_of(std::span(image.pixels).subspan(image.index(0, y0), image.index(0, y1 - y0)));
}

std::span<const float> PageScene::reference_floats(int y0, int y1) const {
    const Image& image = staged_->image;
    return {image.pixels[image.index(0, y0)].data(), 4 * image.index(0, y1 - y0)};
}

std::span<const std::uint8_t> PageScene::coarse_reference(const reference::Options& options) {
    const Frame& frame = scene_->frame;
    return codes_of(
        reference::render(resized(frame, coarse_side(frame.width), coarse_side(frame.height)), options).pixels);
}

std::span<const std::uint8_t> PageScene::codes_of(std::span<const Rgba> pixels) {
    codes_.clear();
    for (const Rgba& pixel : pixels)
        for (const float channel : pixel) codes_.push_back(channel_code(channel));
    return codes_;
}

webgl::WebglFrame PageScene::webgl_frame(const Look& look) const {
    const DrawableFrame frame = reference::drawable(scene_->frame, {look});
    return webgl::webgl_frame(*frame, {look, /*budget=*/0});
}

std::string PageScene::judged(const Look& look, std::span<const std::uint8_t> shaders, std::span<const float> reference,
                              int subpixel_bits) const {
    const Frame& frame = scene_->frame;
    Image drawn(frame.width, frame.height), right = drawn;
    if (shaders.size() != 4 * drawn.pixels.size() || reference.size() != shaders.size())
        throw std::invalid_argument("a picture of another size");
    for (std::size_t i = 0; i < shaders.size(); ++i) {
        drawn.pixels[i / 4][i % 4] = static_cast<float>(shaders[i]) / 255;
        right.pixels[i / 4][i % 4] = reference[i];
    }
    reference::Options options{look};
    options.snap = std::max(options.snap, std::ldexp(0.5, -subpixel_bits));
    // How browsers' drivers round positions is not known well enough to check what their edges show: a border anywhere in a pixel makes
    // it an edge, and any colour is allowed there.
    constexpr double kHalfPixel = 0.5;
    options.border += kHalfPixel;
    AllowedDifference allowed = reference::allowed_difference(frame, options);
    allowed.ranges.clear();
    compare::allow_ties(allowed, right);
    compare::allow_rounded_positions(allowed, right, subpixel_bits);
    if (reference::has_quadrilaterals(frame))
        right = nearer_of(drawn, right, reference::render(frame, {look, reference::QuadCut::kSecondToFourth}),
                          allowed.channels());
    const ImageDifference found = difference(drawn, right, allowed);
    return dumped({{"within", compare::is_within(found, {})},
                   {"max", std::lround(255 * found.interior.max)},
                   {"at", {found.interior.worst_x, found.interior.worst_y}},
                   {"beyond", std::lround(255 * found.beyond_allowed.max)},
                   {"differing", found.beyond_allowed.differing},
                   {"interior", found.interior.pixels},
                   {"edge", found.edge.pixels}});
}

namespace {

programmable::Options shader_options(const Look& look) {
    programmable::Options options;
    static_cast<Look&>(options) = look;
    return options;
}

}  // namespace

std::string PageScene::forms(const Look& look) const {
    Json forms = {"c", "glsl"};
    if (look.shading != Shading::kExact && programmable::why_not_kept(scene_->frame).empty()) forms.push_back("html");
    return dumped(forms);
}

std::string PageScene::exported(const std::string& form, const Look& look) const {
    if (form == "c") return print_c_program(with_pragmas_written_out(*opened_.commands));
    if (form == "glsl") return programmable::shader_source(scene_->frame, shader_options(look));
    const Caption caption = caption_of(*opened_.commands);
    return webgl::exported_page({{&scene_->frame}}, look, {scene_->title(), caption.title, caption.notice});
}

std::string PageScene::explained(const Look& look, int x, int y) const {
    return explain::text_of(*scene_, explain::explain_pixel(scene_->frame, look, {x, y}), {});
}

}  // namespace twinlight::web
