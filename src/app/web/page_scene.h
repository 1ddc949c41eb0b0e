// The scene of the page for browsers: the text in its editor, its errors and warnings, and the reference's pictures of it. Free of
// GL and of JavaScript; module.cpp exports it to the page.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/web/page_controls.h"
#include "base/image/image.h"
#include "render/look.h"
#include "render/reference/staged_frame.h"
#include "render/reference/vertices/reference_options.h"
#include "render/webgl/webgl_frame.h"
#include "scene/frame/copied_texels.h"
#include "scene/frame/scene.h"
#include "scene/scenes/beside.h"

namespace twinlight::web {

// A text this long is no scene that somebody types.
inline constexpr std::size_t kMaxPageBytes = 8u << 20;

// The memory that a picture may need: StateOptions::memory and the pixels. The module has 2 GiB at the most (web.mk), because each
// worker has its own. Measured: for a sphere with a million vertices, which
// counts as more than 1.4 GB, the module grows to 1.9 GiB.
inline constexpr std::size_t kPageMemory = 1'000'000'000;
// What the reference and the judge hold for each pixel: seven pictures of floats at the most.
inline constexpr std::size_t kPageBytesOfPixel = 112;

// Reads a text. Built-in pictures and meshes are its only files. Throws SceneError.
CommandList read_for_page(std::string_view text, const std::string& name, const std::string& step,
                          const FileFinder& find = built_in_file);

// JSON: {"scenes": [{"name", "text", "shows"}]}, the built-in scenes.
std::string built_in_scenes();

class PageScene {
  public:
    // Reads the text and carries out its commands. Returns JSON:
    //   {"errors": [{"line", "column", "message"}], "note", "steps": ["Diffuse only"], "step", "width", "height",
    //    "caption": [what the scene shows, what to notice]}
    // Errors without a place in the text have line 0. The first step has number 1; 0: the scene has no steps. If there are errors, no
    // scene is open. A program's own window size is used instead of `size`.
    std::string open(std::string_view text, const std::string& name, const std::string& step, WindowSize size);
    bool is_open() const { return scene_.has_value(); }
    // Keeps a picture, mesh or material file under this name. Texts that are opened from now on find it before a built-in one.
    void keep_file(const std::string& name, std::string bytes) { files_[name] = std::move(bytes); }
    const Scene& scene() const { return *scene_; }

    // The keys and the mouse. A scene must be open; the page opens the text that they answer with.
    PageControls& controls();

    // JSON: {"warnings": [...]} as `twinlight lint --json` prints them.
    std::string warnings() const;

    // The rows y0 to y1, counted from the top, of the reference's picture: red, green, blue and alpha of each pixel, a byte each.
    // What precedes the pixels is kept for further rows of the same picture.
    std::span<const std::uint8_t> reference(const reference::Options& options, int y0, int y1);
    // The same rows as floats, as reference() drew them last.
    std::span<const float> reference_floats(int y0, int y1) const;

    // The whole picture with sides divided by kCoarse, rounded up: there long before the rows are.
    static constexpr int kCoarse = 4;
    static constexpr int coarse_side(int side) { return (side + kCoarse - 1) / kCoarse; }
    std::span<const std::uint8_t> coarse_reference(const reference::Options& options);

    // The frame for WebGL, shaded as `look` says. Copied pixels are the reference's. webgl_frame.h describes it.
    webgl::WebglFrame webgl_frame(const Look& look) const;

    // Compares a picture by shaders, in the layout of reference(), with the whole of the reference's, as reference_floats()
    // returns it. Returns JSON:
    //   {"within", "max", "at": [x, y], "beyond", "differing", "interior", "edge"}
    // max: the largest difference away from edges in 255ths, and its place; beyond: the same beyond the allowed difference
    // (docs/edges.md); differing: how many pixels differ beyond it; then the numbers of pixels away from edges and at them.
    // subpixel_bits: of the browser's positions in the window (compare::allow_rounded_positions).
    std::string judged(const Look& look, std::span<const std::uint8_t> shaders, std::span<const float> reference,
                       int subpixel_bits) const;

    // The lighting of a pixel, counted from the upper left corner, as `twinlight explain --pixel` prints it.
    std::string explained(const Look& look, int x, int y) const;

    // JSON: the forms that the scene can be exported in: ["c", "glsl", "html"], or fewer.
    std::string forms(const Look& look) const;
    // What `twinlight export --as FORM` prints.
    std::string exported(const std::string& form, const Look& look) const;

  private:
    // What all rows of a reference picture share.
    struct Staged {
        Staged(const Frame& frame, const reference::Options& options);

        reference::Options options;
        DrawableFrame frame;
        reference::StagedFrame stages;
        Image image;
    };

    std::span<const std::uint8_t> codes_of(std::span<const Rgba> pixels);

    // What the controls begin with.
    struct Opened {
        std::shared_ptr<const CommandList> commands;
        std::string text;
        WindowSize size;
        PageControls::Read read;
    };

    std::optional<Scene> scene_;
    Opened opened_;
    std::map<std::string, std::string, std::less<>> files_;  // that were dropped on the page
    std::optional<PageControls> controls_;                   // made when they are first needed
    std::unique_ptr<Staged> staged_;
    std::vector<std::uint8_t> codes_;
};

}  // namespace twinlight::web
