// A plot as SVG: panels with logarithmic axes side by side, and a legend; or bars.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace twinlight::study {

enum class Mark : std::uint8_t { kNone, kSquare, kTriangle, kCircle, kDiamond };
enum class Line : std::uint8_t { kNone, kSolid, kDashed };

struct PlotSeries {
    std::vector<glm::dvec2> values{};
    Mark mark = Mark::kNone;
    Line line = Line::kNone;
    const char* color = "#000";
    bool filled = true;
    std::string words{};  // the tooltip of its marks; in the legend the text of the row
};

// A logarithmic axis. Values beyond its ends are drawn at the ends.
struct PlotAxis {
    double low, high;
    std::vector<double> ticks{};
    std::string words{};

    // 0 at `low`, 1 at `high`.
    double part(double value) const { return std::log(std::clamp(value, low, high) / low) / std::log(high / low); }
};
struct Panel {
    PlotAxis x, y;
    std::vector<PlotSeries> series{};
};

// Safe for colour blindness (Okabe and Ito, 2008); the list repeats.
const char* plot_color(std::size_t number);

// From the power of ten below `low` to the one above `high`, with a tick at each.
PlotAxis decades(double low, double high, std::string words);

// Panels of `panel_size` pixels side by side, and a legend; a row without words is a gap.
std::string plot_svg(std::string_view title, glm::dvec2 panel_size, const std::vector<Panel>& panels,
                     const std::vector<PlotSeries>& legend);

struct Bar {
    std::string words;
    double value = 0;  // 0 or more
};
// A bar for each row, from the top, with its value at its end.
std::string bars_svg(std::string_view title, const std::vector<Bar>& bars);

}  // namespace twinlight::study
