// Layout: where the panel, the panes and the bars are in the window. In window coordinates: pixels, y down.
#pragma once

#include <array>
#include <vector>

#include "app/session/session.h"
#include "base/image/rectangle.h"

namespace twinlight::session {

// A cell of the picture area. Its header is above its picture, its footer below.
struct Cell {
    std::size_t pane = 0;  // or kDifferencePane
    Rectangle header, picture, footer;
};

struct Layout {
    Rectangle panel;   // empty if the panel is hidden
    Rectangle status;  // the line at the bottom
    std::vector<Cell> cells;
    Rectangle caption;   // above the cells: what the scene shows
    Rectangle code;      // below the tutor's cells: its calls
    Rectangle sides;     // below the slider's cell: what differs between its sides, in lines as high as a bar
    WindowSize picture;  // of every cell
};

// The layout of a window of this size. `scale` is that of the font: 1 for 96 dots per inch. Pictures keep the proportions
// of the scene's natural size.
Layout layout(const Session& session, int width, int height, double scale);

// Makes the panel end at this x, within limits.
void widen_panel(Session& session, int x, int width, double scale);

// The pane whose picture holds this point, and the pixel of its picture from the top left.
struct Hit {
    std::size_t pane = 0;
    int x = 0, y = 0;
};
std::optional<Hit> hit(const Layout& layout, int x, int y);

}  // namespace twinlight::session
