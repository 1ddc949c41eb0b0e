#include "reference/visibility.h"

#include <iterator>
#include <thread>

namespace twinlight::reference {

Stages run_stages(const Frame& frame, QuadCut cut) {
    Stages stages;
    const auto add_clear = [&](const Clear& clear) {
        stages.clears.push_back(clear);
        stages.pieces_before_clear.push_back(stages.pieces.size());
        stages.steps.push_back({.clear = -static_cast<StepId>(stages.clears.size())});
    };
    add_clear({.color = true, .depth = true});
    for (const auto& item : frame.items) {
        if (const Clear* clear = std::get_if<Clear>(&item)) {
            add_clear(*clear);
            continue;
        }
        const Draw& draw = std::get<Draw>(item);
        stages.draws.push_back({&draw, vertex_stage(draw)});
        const std::size_t first = stages.pieces.size();
        std::vector<Piece> pieces =
            make_pieces(draw, static_cast<std::uint32_t>(stages.draws.size() - 1), stages.draws.back().vertices, cut);
        std::move(pieces.begin(), pieces.end(), std::back_inserter(stages.pieces));
        stages.steps.push_back({.first_piece = first, .end_piece = stages.pieces.size()});
    }
    return stages;
}

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

VisibleRows visible_rows(const Stages& stages, int width, int y0, int y1) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(y1 - y0);
    VisibleRows rows{width, y0, y1, std::vector<StepId>(count, -1), std::vector<double>(count, 1)};
    for (const Step& step : stages.steps) {
        if (step.clear < 0) {
            const Clear& clear = stages.clear(step.clear);
            if (clear.color) std::fill(rows.step.begin(), rows.step.end(), step.clear);
            if (clear.depth) std::fill(rows.depth.begin(), rows.depth.end(), clear.clear_depth);
            continue;
        }
        for (std::size_t i = step.first_piece; i < step.end_piece; ++i) {
            const Piece& piece = stages.pieces[i];
            const RasterState& raster = stages.draw_of(piece).raster;
            for_each_pixel(piece, {0, y0, width, y1}, [&](int x, int y) {
                const std::size_t at = rows.index(x, y);
                if (raster.depth_test) {  // 4.1.5: without the test the depth buffer stays as it is
                    const double depth = depth_at(piece, pixel_centre(x, y));
                    if (!depth_passes(raster.depth_func, depth, rows.depth[at])) return;
                    if (raster.depth_mask) rows.depth[at] = depth;
                }
                rows.step[at] = static_cast<StepId>(i);
            });
        }
    }
    return rows;
}

void for_each_band(int height, const std::function<void(int y0, int y1)>& band) {
    constexpr int kRowsPerBand = 16;
    const int bands = (height + kRowsPerBand - 1) / kRowsPerBand;
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int i = next++; i < bands; i = next++) band(i * kRowsPerBand, std::min(height, (i + 1) * kRowsPerBand));
    };
    std::vector<std::jthread> helpers;
    const int helper_count = std::min(bands, static_cast<int>(std::thread::hardware_concurrency())) - 1;
    helpers.reserve(static_cast<std::size_t>(std::max(helper_count, 0)));
    for (int i = 0; i < helper_count; ++i) helpers.emplace_back(work);
    work();
}

}  // namespace twinlight::reference
