#include "render/reference/framebuffer.h"

#include <limits>

#include "render/reference/fragment_operations.h"

namespace twinlight::reference {

namespace {

constexpr StepId kColor = std::numeric_limits<StepId>::min();

}  // namespace

bool depth_passes(Enum depth_func, double incoming, double stored) {
    switch (depth_func) {
        case kGL_NEVER: return false;
        case kGL_LESS: return incoming < stored;
        case kGL_EQUAL: return incoming == stored;
        case kGL_LEQUAL: return incoming <= stored;
        case kGL_GREATER: return incoming > stored;
        case kGL_NOTEQUAL: return incoming != stored;
        case kGL_GEQUAL: return incoming >= stored;
    }
    return true;  // GL_ALWAYS
}

Framebuffer::Framebuffer(const StagedFrame& stages, const std::vector<Shader>& shaders, int width, int y0, int y1)
    : stages_(stages), shaders_(shaders), width_(width), y0_(y0), y1_(y1) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(y1 - y0);
    step_.resize(count);
    depth_.resize(count);
    for (const Step& step : stages.steps) {
        if (step.clear < 0) clear(step.clear);
        for (std::size_t i = step.first_piece; i < step.end_piece; ++i) piece(static_cast<StepId>(i));
    }
}

// 4.2.3: a clear obeys scissor and colour mask.
void Framebuffer::clear(StepId id) {
    const Clear& clear = stages_.clear(id);
    FragmentState mask;
    mask.color_mask = clear.color_mask;
    const PixelRect rect = scissored(clear.scissor, window());
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x) {
            if (clear.depth) depth_[index(x, y)] = clear.clear_depth;
            if (!clear.color) continue;
            if (overwrites_color(mask))
                step_[index(x, y)] = id;
            else
                write(mask, clamped(clear.clear_color), x, y);
        }
}

void Framebuffer::piece(StepId id) {
    const Piece& piece = stages_.piece(id);
    const Draw& draw = stages_.draw_of(piece);
    const RasterState& raster = draw.raster;
    const FragmentState& state = draw.fragment;
    const bool color_waits = overwrites_color(state) && !state.alpha_test;
    const bool has_color = writes_color(state) || state.alpha_test;
    for_each_pixel(piece, scissored(state.scissor, window()), [&](int x, int y) {
        const std::size_t at = index(x, y);
        double depth = 0;
        if (raster.depth_test) {
            depth = depth_at(piece, pixel_centre(x, y));
            if (!depth_passes(raster.depth_func, depth, depth_[at])) return;
        }
        if (color_waits) {
            step_[at] = id;
        } else if (has_color) {
            // The alpha test comes before the depth test, but neither leaves anything unless both pass.
            const glm::dvec4 color = shaders_[piece.draw].color(piece, pixel_centre(x, y));
            if (state.alpha_test && !alpha_passes(state, color.a)) return;
            write(state, color, x, y);
        }
        // 4.1.5: without the test the depth buffer stays as it is.
        if (raster.depth_test && raster.depth_mask) depth_[at] = depth;
    });
}

std::optional<StepId> Framebuffer::step(int x, int y) const {
    const StepId id = step_[index(x, y)];
    return id == kColor ? std::nullopt : std::optional(id);
}

// Those that wait are lit Draw by Draw, all at once.
std::vector<glm::dvec4> Framebuffer::colors() const {
    std::vector<glm::dvec4> colors(step_.size());
    struct Waiting {
        std::vector<Fragment> fragments;
        std::vector<std::size_t> places;
    };
    std::vector<Waiting> by_draw(shaders_.size());
    for (int y = y0_; y < y1_; ++y)
        for (int x = 0; x < width_; ++x) {
            const std::size_t at = index(x, y);
            const StepId id = step_[at];
            if (id == kColor || id < 0) {
                colors[at] = color_at(x, y, at);
                continue;
            }
            const Piece& piece = stages_.piece(id);
            by_draw[piece.draw].fragments.push_back({&piece, pixel_centre(x, y)});
            by_draw[piece.draw].places.push_back(at);
        }
    for (std::size_t draw = 0; draw < by_draw.size(); ++draw) {
        const Waiting& waiting = by_draw[draw];
        const std::vector<glm::dvec4> lit = shaders_[draw].colors(waiting.fragments);
        for (std::size_t i = 0; i < lit.size(); ++i) colors[waiting.places[i]] = lit[i];
    }
    return colors;
}

glm::dvec4 Framebuffer::color_at(int x, int y, std::size_t at) const {
    const StepId id = step_[at];
    if (id == kColor) return colors_[at];
    if (id < 0) return clamped(stages_.clear(id).clear_color);
    const Piece& piece = stages_.piece(id);
    return shaders_[piece.draw].color(piece, pixel_centre(x, y));
}

void Framebuffer::write(const FragmentState& state, const glm::dvec4& source, int x, int y) {
    const std::size_t at = index(x, y);
    // What the fragment needs of what lies beneath is what the colour buffer holds of it.
    const glm::dvec4 beneath = overwrites_color(state) ? glm::dvec4(0) : quantised(color_at(x, y, at));
    if (colors_.empty()) colors_.resize(step_.size());
    const Channels<double> fragment = channels<double>(source), constant = channels<double>(clamped(state.blend_color));
    Channels<double> result = channels<double>(beneath);
    for (std::size_t i = 0; i < result.size(); ++i)
        if (state.color_mask[i])
            result[i] =
                state.blend ? clamp01(blended(state, i, fragment, channels<double>(beneath), constant)) : fragment[i];
    colors_[at] = color_of(result);
    step_[at] = kColor;
}

}  // namespace twinlight::reference
