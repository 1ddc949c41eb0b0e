#include "app/session/layout.h"

#include <algorithm>
#include <cmath>

#include "app/session/sides.h"
#include "scene/scenes/caption.h"

namespace twinlight::session {
namespace {

// In pixels at scale 1.
constexpr double kPanelWidth = 420, kBar = 26, kGap = 6;
constexpr double kCaption = 44;         // the height of two lines
constexpr double kTutorCode = 252;      // the height of six large lines and what they mean
constexpr double kMostOfWindow = 0.45;  // of the window's width, for the panel; of its height, for the tutor's code
constexpr double kNarrowestPanel = 240, kMostDragged = 0.7;  // of the window's width, for a panel that was dragged

// The panes that the view shows, row by row.
std::vector<std::vector<std::size_t>> rows_of(const Session& session) {
    switch (session.view) {
        case View::kGrid: return {{0, 1}, {2, kDifferencePane}};
        case View::kSingle: return {{session.active}};
        case View::kTutor: return {{kWorldPane, std::min(session.active, kPanes - 1)}};
        case View::kSlider:
        case View::kWorld: break;
    }
    return {{session.slider.b}};
}

}  // namespace

Layout layout(const Session& session, int width, int height, double scale) {
    const auto pixels = [scale](double length) { return static_cast<int>(std::lround(length * scale)); };
    const int bar = pixels(kBar), gap = pixels(kGap);
    Layout result;
    result.status = {0, height - bar, width, bar};
    const bool is_tutor = session.view == View::kTutor;
    if (session.panel_shown && !is_tutor)
        result.panel = {0, 0,
                        std::min(pixels(session.panel_width.value_or(kPanelWidth)),
                                 static_cast<int>((session.panel_width ? kMostDragged : kMostOfWindow) * width)),
                        height - bar};

    const int code = is_tutor ? std::min(pixels(kTutorCode), static_cast<int>(kMostOfWindow * height)) : 0;
    result.code = {0, height - bar - code, width, code};
    const bool has_caption =
        !is_tutor && session.view != View::kWorld && !session.lesson && !caption_of(*session.opened).title.empty();
    const int caption = has_caption ? pixels(kCaption) : 0;
    result.caption = {result.panel.width, 0, width - result.panel.width, caption};
    const int sides = session.view == View::kSlider ? bar * static_cast<int>(side_row_count(session)) : 0;
    const Rectangle area{result.panel.width, caption, width - result.panel.width,
                         height - bar - sides - code - caption};
    const auto rows = rows_of(session);
    const int across = static_cast<int>(rows.front().size()), down = static_cast<int>(rows.size());
    const int room_x = std::max((area.width - gap * (across + 1)) / across, 1);
    const int room_y = std::max((area.height - gap * (down + 1)) / down - 2 * bar, 1);

    // The largest picture with the scene's proportions.
    const WindowSize natural = natural_size(commands(session));
    const double fit =
        std::min(static_cast<double>(room_x) / natural.width, static_cast<double>(room_y) / natural.height);
    result.picture = {std::clamp(static_cast<int>(std::lround(fit * natural.width)), 1, room_x),
                      std::clamp(static_cast<int>(std::lround(fit * natural.height)), 1, room_y)};

    // The cells are together in the middle of the area.
    const int cell_height = result.picture.height + 2 * bar;
    const int left = area.x + (area.width - across * result.picture.width - (across - 1) * gap) / 2;
    const int top = area.y + (area.height - down * cell_height - (down - 1) * gap) / 2;
    for (int row = 0; row < down; ++row) {
        for (int column = 0; column < across; ++column) {
            const int x = left + column * (result.picture.width + gap), y = top + row * (cell_height + gap);
            result.cells.push_back({rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)],
                                    {x, y, result.picture.width, bar},
                                    {x, y + bar, result.picture.width, result.picture.height},
                                    {x, y + bar + result.picture.height, result.picture.width, bar}});
        }
    }
    const Rectangle& footer = result.cells.front().footer;
    result.sides = {footer.x, footer.y + footer.height, footer.width, sides};
    return result;
}

void widen_panel(Session& session, int x, int width, double scale) {
    session.panel_width = std::max(std::min(static_cast<double>(x), kMostDragged * width) / scale, kNarrowestPanel);
}

std::optional<Hit> hit(const Layout& layout, int x, int y) {
    for (const Cell& cell : layout.cells)
        if (cell.picture.contains(x, y)) return Hit{cell.pane, x - cell.picture.x, y - cell.picture.y};
    return {};
}

}  // namespace twinlight::session
