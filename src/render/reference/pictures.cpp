#include "render/reference/pictures.h"

#include <algorithm>
#include <utility>

#include "render/reference/allowed_difference.h"
#include "render/reference/copied_pixels.h"
#include "render/reference/framebuffer.h"
#include "scene/state/lecture_variants.h"

namespace twinlight::reference {

namespace {

// How the Draw's colours are interpolated. Without lighting, phong shading interpolates the vertices' colours, too.
Shading shading_in(const Draw& draw, const Look& look) {
    const Shading own = draw.lighting.shade_model == kGL_FLAT ? Shading::kFlat : Shading::kGouraud;
    const Shading shading = look.shading.value_or(own);
    return shading == Shading::kPhong && !draw.lighting.enabled ? Shading::kGouraud : shading;
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

// The smallest rectangle around the pixels that Draws with this property may reach.
template <class Property>
PixelRect reach_of(const StagedFrame& stages, const PixelRect& window, const Property& has_property) {
    std::vector<char> reaches;
    for (const StagedDraw& staged : stages.draws) reaches.push_back(has_property(*staged.draw) ? 1 : 0);
    PixelRect reach{window.x1, window.y1, window.x0, window.y0};
    for (const Piece& piece : stages.pieces) {
        if (reaches[piece.draw] == 0) continue;
        const PixelRect one = reach_of(piece, window);
        if (one.is_empty()) continue;
        reach = {std::min(reach.x0, one.x0), std::min(reach.y0, one.y0), std::max(reach.x1, one.x1),
                 std::max(reach.y1, one.y1)};
    }
    return reach;
}

std::size_t size_of(const PixelRect& rect) { return rect.is_empty() ? 0 : rect.count(); }

}  // namespace

Image Pictures::render(const Options& options) {
    if (frame_->copies_pixels) return reference::render(*frame_, options);  // the copies depend on the options
    const Frame& frame = *frame_;
    StagedFrame stages = run_stages(frame, options);
    Image image(frame.width, frame.height);
    PixelRect within = whole_window(frame);
    for (const Drawn& drawn : drawn_) {
        if (!differ_in_look_or_cut_only(drawn.options, options)) continue;
        const PixelRect changed = reach_of(stages, whole_window(frame),
                                           [&](const Draw& draw) { return depends_on(draw, drawn.options, options); });
        if (size_of(changed) >= size_of(within)) continue;
        within = changed;
        image = drawn.image;
    }
    draw_pixels(std::move(stages), options, within, image);
    std::erase_if(drawn_, [&](const Drawn& drawn) { return drawn.options.quad_cut == options.quad_cut; });
    drawn_.push_back({options, image});
    return image;
}

AllowedDifference Pictures::allowed_difference(const Options& given) {
    if (given.shading == Shading::kExact) return reference::allowed_difference(*frame_, given);
    if (frame_->copies_pixels) {
        const DrawableFrame whole = drawable_with_ranges(*frame_, given);
        return Pictures(*whole).allowed_difference(given);
    }
    const Frame& frame = *frame_;
    Options options = given;
    options.in_clip_plane = InClipPlane::kPerhaps;
    options.quad_cut = QuadCut::kFirstToThird;
    StagedFrame stages = run_stages(frame, options);
    PixelRect within = whole_window(frame);
    if (found_ && differ_in_look_or_cut_only(found_->options, options)) {
        within = reach_of(stages, within, [&](const Draw& draw) { return depends_on(draw, found_->options, options); });
        found_->options = options;
    } else {
        found_ = Found{options, {std::vector<char>(size_of(within)), Image(frame.width, frame.height)}};
    }
    const PixelRect of_quadrilaterals = common(within, reach_of(stages, whole_window(frame), is_quadrilaterals));
    find_differences(std::move(stages), options, within, found_->difference, Joining::kReplaces);
    if (!of_quadrilaterals.is_empty()) {
        options.quad_cut = QuadCut::kSecondToFourth;
        find_differences(run_stages(frame, options), options, of_quadrilaterals, found_->difference, Joining::kAdds);
    }
    AllowedDifference result{.edge = {}, .channels = found_->difference.channels};
    result.edge.assign(found_->difference.edge.begin(), found_->difference.edge.end());
    return result;
}

}  // namespace twinlight::reference
