// study.svg: error against time, both logarithmic; a dot a choice, the front drawn through.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/html.h"
#include "study/study.h"

namespace twinlight::study {

namespace {

constexpr double kWidth = 900, kHeight = 560;
constexpr double kLeft = 80, kRight = 240, kTop = 48, kBottom = 64;  // margins; the legend stands in the right one

// A logarithmic axis over whole powers of ten.
class Axis {
  public:
    Axis(double low, double high, double from, double to)
        : low_(std::floor(std::log10(low))), high_(std::ceil(std::log10(high))), from_(from), to_(to) {
        if (high_ <= low_) high_ = low_ + 1;
    }
    double at(double value) const { return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_); }
    int low() const { return static_cast<int>(low_); }
    int high() const { return static_cast<int>(high_); }

  private:
    double low_, high_, from_, to_;
};

// Colour-blind safe (Okabe and Ito, 2008), one a renderer; the shading is the mark.
const std::map<std::string, std::pair<const char*, const char*>> kRenderers = {
    {"fixed", {"#d55e00", "fixed function"}},
    {"programmable", {"#0072b2", "shaders, uniforms"}},
    {"baked", {"#56b4e9", "shaders, constants"}},
    {"reference", {"#009e73", "reference"}},
};

std::string colour_key(const Choice& choice) { return choice.tier == Tier::kBaked ? "baked" : choice.renderer; }

std::string mark(Shading shading, double x, double y, const char* colour, bool filled) {
    const std::string paint =
        filled ? fmt::format(R"(fill="{0}" stroke="{0}")", colour) : fmt::format(R"(fill="white" stroke="{}")", colour);
    switch (shading) {
        case Shading::kFlat:
            return fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="9" height="9" {}/>)", x - 4.5, y - 4.5, paint);
        case Shading::kGouraud: return fmt::format(R"(<path d="M{:.1f} {:.1f}l5.5 9.5h-11z" {}/>)", x, y - 6, paint);
        case Shading::kPhong: return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="5" {}/>)", x, y, paint);
        case Shading::kExact: return fmt::format(R"(<path d="M{:.1f} {:.1f}l6 6l-6 6l-6 -6z" {}/>)", x, y - 6, paint);
    }
    return {};
}

std::string text(double x, double y, std::string_view anchor, std::string_view words) {
    return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor, words) + "\n";
}

std::string power_of_ten(int exponent) {
    return fmt::format(R"(10<tspan dy="-5" font-size="10">{}</tspan>)", exponent);
}

std::string grid(const Axis& x, const Axis& y) {
    std::string svg = R"(<g stroke="#ddd">)";
    for (int e = x.low(); e <= x.high(); ++e)
        svg += fmt::format(R"(<path d="M{:.1f} {:.1f}V{:.1f}"/>)", x.at(std::pow(10, e)), kTop, kHeight - kBottom);
    for (int e = y.low(); e <= y.high(); ++e)
        svg += fmt::format(R"(<path d="M{:.1f} {:.1f}H{:.1f}"/>)", kLeft, y.at(std::pow(10, e)), kWidth - kRight);
    svg += "</g>\n";
    for (int e = x.low(); e <= x.high(); ++e)
        svg += text(x.at(std::pow(10, e)), kHeight - kBottom + 20, "middle", power_of_ten(e));
    for (int e = y.low(); e <= y.high(); ++e) svg += text(kLeft - 8, y.at(std::pow(10, e)) + 4, "end", power_of_ten(e));
    svg += text((kLeft + kWidth - kRight) / 2, kHeight - 16, "middle", "time of a frame, ms");
    return svg +
           fmt::format(
               R"svg(<text transform="translate(22 {:.1f}) rotate(-90)" text-anchor="middle">rms error of a channel, 0 to 1</text>)svg",
               (kTop + kHeight - kBottom) / 2) +
           "\n";
}

// "llvmpipe (LLVM 15.0.6, 256 bits)", without the versions that follow.
std::string renderer_of(const std::string& driver) {
    const std::size_t end = driver.find("), ");
    return report::escaped(end == std::string::npos ? driver : driver.substr(0, end + 1));
}

std::string legend() {
    std::string svg;
    double y = kTop + 10;
    const double x = kWidth - kRight + 30;
    for (const auto& [key, renderer] : kRenderers) {
        svg += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="12" height="12" fill="{}"/>)", x - 6, y - 6,
                           renderer.first);
        svg += text(x + 16, y + 4, "start", renderer.second);
        y += 22;
    }
    y += 10;
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud, Shading::kPhong, Shading::kExact}) {
        svg += mark(shading, x, y, "#444", true) + text(x + 16, y + 4, "start", name_of(shading));
        y += 22;
    }
    y += 10;
    svg += mark(Shading::kPhong, x, y, "#444", false) + text(x + 16, y + 4, "start", "with less simulated");
    y += 22;
    svg += fmt::format(R"(<path d="M{:.1f} {:.1f}h16" stroke="#000" stroke-dasharray="4 3"/>)", x - 8, y);
    return svg + text(x + 16, y + 4, "start", "no choice is both faster") +
           text(x + 16, y + 20, "start", "and more accurate");
}

}  // namespace

std::string study_svg(const Study& study) {
    std::vector<const Point*> points;
    for (const Point& point : study.points)
        if (!point.seconds.empty() && point.whole.rms > 0) points.push_back(&point);
    std::string svg = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" font-family="sans-serif" font-size="13">)",
        kWidth, kHeight);
    svg += R"(<rect width="100%" height="100%" fill="white"/>)";
    svg += text(kLeft, 28, "start",
                fmt::format("{}: what accuracy costs in time ({} x {}, {})", report::escaped(study.scene), study.width,
                            study.height, renderer_of(study.driver)));
    if (points.empty()) return svg + text(kWidth / 2, kHeight / 2, "middle", "nothing was timed") + "</svg>\n";
    const auto time = [](const Point* point) { return 1000 * point->median_seconds(); };
    const auto [fastest, slowest] = std::ranges::minmax(points, {}, time);
    const auto rms = [](const Point* point) { return point->whole.rms; };
    const auto [best, worst] = std::ranges::minmax(points, {}, rms);
    const Axis x(time(fastest), time(slowest), kLeft, kWidth - kRight),
        y(rms(best), rms(worst), kHeight - kBottom, kTop);
    svg += grid(x, y) + legend();
    std::ranges::stable_sort(points, {}, time);
    std::string front;
    for (const Point* point : points)
        if (point->on_front)
            front += fmt::format("{}{:.1f} {:.1f}", front.empty() ? "M" : "L", x.at(time(point)), y.at(rms(point)));
    if (!front.empty())
        svg += fmt::format(R"(<path d="{}" fill="none" stroke="#000" stroke-dasharray="4 3"/>)", front) + "\n";
    for (const Point* point : points) {
        const bool whole = point->choice.without == Without::kNothing && point->choice.budget == RenderOptions{}.budget;
        svg += fmt::format(R"(<g class="dot" data-point="{}"><title>{}: {:.3g} ms, rms {:.3g}</title>{}</g>)",
                           point - study.points.data(), point->choice.words(), time(point), rms(point),
                           mark(point->choice.shading, x.at(time(point)), y.at(rms(point)),
                                kRenderers.at(colour_key(point->choice)).first, whole)) +
               "\n";
    }
    return svg + "</svg>\n";
}

}  // namespace twinlight::study
