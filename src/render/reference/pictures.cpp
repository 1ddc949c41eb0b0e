#include "render/reference/pictures.h"

#include <algorithm>
#include <utility>

#include "render/reference/allowed_difference.h"
#include "render/reference/copied_pixels.h"
#include "render/reference/framebuffer.h"
#include "scene/frame/lecture_variants.h"

namespace twinlight::reference {

namespace {

// How the Draw's colours are interpolated. Without lighting, phong shading interpolates the vertices' colours, too.
Shading shading_in(const Draw& draw, const Look& look) {
    const Shading own = draw.lighting.shade_model == kGL_FLAT ? Shading::kFlat : Shading::kGouraud;
    const Shading shading = look.shading.value_or(own);
    return shading == Shading::kPhong && !draw.lighting.enabled ? Shading::kGouraud : shading;
}

// Whether a cut of quadrilaterals may show: an exact surface has none.
bool has_cut(const Draw& draw, const Options& options) {
    return is_quadrilaterals(draw) && !(options.shading == Shading::kExact && draw.has_exact_surfaces());
}

// Whether the Draw may look different with other options, which differ only in the look and the cut.
bool depends_on(const Draw& draw, const Options& a, const Options& b) {
    if (a.quad_cut != b.quad_cut && is_quadrilaterals(draw)) return true;
    return shading_in(draw, a) != shading_in(draw, b) ||
           (a.lecture_variants != b.lecture_variants && has_variants(draw));
}

bool differ_in_look_or_cut_only(Options a, const Options& b) {
    static_cast<Look&>(a) = b;
    a.quad_cut = b.quad_cut;
    return a == b && a.shading != Shading::kExact && b.shading != Shading::kExact;
}

PixelRect whole_window(const Frame& frame) { return {0, 0, frame.width, frame.height}; }

PixelRect common(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// The smallest rectangle that contains both.
PixelRect joined(const PixelRect& a, const PixelRect& b) {
    if (a.is_empty() || b.is_empty()) return a.is_empty() ? b : a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

// The smallest rectangle around the pixels that Draws with this property may reach.
template <class Property>
PixelRect reach_of(const StagedFrame& stages, const PixelRect& window, const Property& has_property) {
    std::vector<char> reaches;
    for (const StagedDraw& staged : stages.draws) reaches.push_back(has_property(*staged.draw) ? 1 : 0);
    PixelRect reach;
    for (const Piece& piece : stages.pieces)
        if (reaches[piece.draw] != 0) reach = joined(reach, reach_of(piece, window));
    return reach;
}

std::size_t size_of(const PixelRect& rect) { return rect.is_empty() ? 0 : rect.count(); }

}  // namespace

Image Pictures::render(const Options& options) {
    if (frame_->copies_pixels) return reference::render(*frame_, options);  // the copies depend on the options
    const Frame& frame = *frame_;
    const PixelRect window = whole_window(frame);
    StagedFrame stages = run_stages(frame, options);
    // Quadrilaterals that are not flat, or are clipped, may reach other pixels if they are cut the other way.
    const auto has_cut = [&](const Draw& draw) { return reference::has_cut(draw, options); };
    const PixelRect of_quadrilaterals = reach_of(stages, window, has_cut);
    Image image(frame.width, frame.height);
    PixelRect within = window;
    for (const Drawn& drawn : drawn_) {
        if (!differ_in_look_or_cut_only(drawn.options, options)) continue;
        PixelRect changed =
            reach_of(stages, window, [&](const Draw& draw) { return depends_on(draw, drawn.options, options); });
        if (drawn.options.quad_cut != options.quad_cut) changed = joined(changed, drawn.of_quadrilaterals);
        if (size_of(changed) >= size_of(within)) continue;
        within = changed;
        image = drawn.image;
    }
    draw_pixels(std::move(stages), options, within, image);
    std::erase_if(drawn_, [&](const Drawn& drawn) { return drawn.options.quad_cut == options.quad_cut; });
    drawn_.push_back({options, image, of_quadrilaterals});
    return image;
}

AllowedDifference Pictures::allowed_difference(const Options& given) {
    if (frame_->copies_pixels) {
        CopyRanges ranges;
        const DrawableFrame whole = drawable_with_ranges(*frame_, given, ranges);
        return Pictures(*whole, ranges).allowed_difference(given);
    }
    const Frame& frame = *frame_;
    if (!std::exchange(has_generated_, true)) add_generated_levels(frame, ranges_);
    const PixelRect window = whole_window(frame);
    Options options = given;
    options.in_clip_plane = InClipPlane::kPerhaps;
    options.quad_cut = QuadCut::kFirstToThird;
    StagedFrame stages = run_stages(frame, options, &ranges_);
    const auto has_cut = [&](const Draw& draw) { return reference::has_cut(draw, given); };
    PixelRect within = window;
    const bool is_first = !found_ || !differ_in_look_or_cut_only(found_->options, options);
    if (is_first) {
        found_ = Found{options, OpenDifference(frame.width, frame.height), reach_of(stages, window, has_cut)};
    } else {
        bool of_quadrilaterals = false;
        within = reach_of(stages, window, [&](const Draw& draw) {
            const bool depends = depends_on(draw, found_->options, options);
            of_quadrilaterals = of_quadrilaterals || (depends && is_quadrilaterals(draw));
            return depends;
        });
        if (of_quadrilaterals) within = joined(within, found_->of_quadrilaterals);
        found_->options = options;
    }
    find_differences(std::move(stages), options, within, found_->difference, Joining::kReplaces);
    options.quad_cut = QuadCut::kSecondToFourth;
    if (is_first && std::ranges::any_of(frame.draws(), [&](const Draw* draw) { return has_cut(*draw); })) {
        stages = run_stages(frame, options, &ranges_);
        found_->of_quadrilaterals = joined(found_->of_quadrilaterals, reach_of(stages, window, has_cut));
        find_differences(std::move(stages), options, found_->of_quadrilaterals, found_->difference, Joining::kAdds);
    } else if (const PixelRect again = common(within, found_->of_quadrilaterals); !again.is_empty()) {
        find_differences(run_stages(frame, options, &ranges_), options, again, found_->difference, Joining::kAdds);
    }
    const OpenDifference& found = found_->difference;
    AllowedDifference result(frame.width, frame.height);
    result.edge.assign(found.edge.begin(), found.edge.end());
    result.drawn.assign(found.drawn.begin(), found.drawn.end());
    if (std::ranges::any_of(found.undefined, [](char is) { return is != 0; }))
        result.undefined.assign(found.undefined.begin(), found.undefined.end());
    result.open = found.open;
    result.ranges = found.ranges;
    for (std::size_t i = 0; i < found.why.size(); ++i)
        if (found.channels.pixels[i] != Rgba{}) result.part(found.why[i]).pixels[i] = found.channels.pixels[i];
    return result;
}

}  // namespace twinlight::reference
