#include "study/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "image/difference.h"

namespace twinlight::study {

namespace {

constexpr int kLeastRounds = 3;

// One for each number of slices: the scene, and which pixels are silhouettes.
struct Mesh {
    Frame frame;
    std::vector<char> is_silhouette;
};

// Where another shape is seen than in truth, or where one begins within a pixel, in either picture.
std::vector<char> silhouettes(const std::vector<int>& a, const std::vector<int>& b, int width, int height) {
    std::vector<char> mask(a.size());
    const auto at = [&](int x, int y) {
        const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int here = b[at(x, y)];
            bool is_border = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    is_border |= a[at(x + dx, y + dy)] != here || b[at(x + dx, y + dy)] != here;
            mask[at(x, y)] = is_border ? 1 : 0;
        }
    return mask;
}

class Sum {
  public:
    void add(double difference) {
        max_ = std::max(max_, difference);
        squares_ += difference * difference;
    }
    void add_pixel() { ++pixels_; }
    Error error() const {
        return {pixels_, max_, pixels_ == 0 ? 0 : std::sqrt(squares_ / (3.0 * static_cast<double>(pixels_)))};
    }

  private:
    std::size_t pixels_ = 0;
    double max_ = 0, squares_ = 0;
};

void set_errors(Point& point, const Image& truth, const std::vector<char>& is_silhouette) {
    Sum whole, interior, silhouette;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        Sum& part = is_silhouette[i] ? silhouette : interior;
        whole.add_pixel();
        part.add_pixel();
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = std::abs(static_cast<double>(point.picture.pixels[i][c]) - truth.pixels[i][c]);
            whole.add(difference);
            part.add(difference);
        }
    }
    point.whole = whole.error();
    point.interior = interior.error();
    point.silhouette = silhouette.error();
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double quantile(std::vector<double> values, double q) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const double place = q * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

const Prepare& renderer_of(const Renderers& renderers, const Choice& choice) {
    if (choice.renderer == "fixed") return renderers.fixed;
    return choice.renderer == "reference" ? renderers.reference : renderers.programmable;
}

}  // namespace

double Error::psnr_db() const { return -20 * std::log10(rms); }

double Point::median_seconds() const { return quantile(seconds, 0.5); }
std::array<double, 2> Point::quartiles_seconds() const { return {quantile(seconds, 0.25), quantile(seconds, 0.75)}; }

Study run(const std::function<Frame(int slices)>& frame_of, bool has_slices, const Renderers& renderers,
          const Settings& settings) {
    Study study;
    const Frame scene = frame_of(0);
    study.width = scene.width;
    study.height = scene.height;
    const RenderOptions exact{.shading = Shading::kExact};
    study.truth = renderers.reference(scene, exact).picture();
    const std::vector<int> seen = renderers.seen(scene, exact);

    // The pictures, and so the errors; each choice stays ready for its turns.
    const std::vector<Choice> all = choices(scene, has_slices, settings.extent);
    std::map<std::pair<int, bool>, Mesh> meshes;  // by slices, and whether it is the surfaces themselves
    const auto mesh_of = [&](const Choice& choice) -> const Mesh& {
        const bool is_exact = choice.shading == Shading::kExact;
        const auto [found, is_new] = meshes.try_emplace({choice.slices, is_exact});
        if (is_new) {
            found->second.frame = is_exact ? scene : frame_of(choice.slices);
            const RenderOptions lit_by_pixel{.shading = is_exact ? Shading::kExact : Shading::kPhong};
            found->second.is_silhouette =
                silhouettes(seen, renderers.seen(found->second.frame, lit_by_pixel), study.width, study.height);
        }
        return found->second;
    };
    std::vector<Prepared> prepared;
    for (const Choice& choice : all) {
        if (settings.progress &&
            !settings.progress(static_cast<int>(prepared.size()), static_cast<int>(all.size()), choice.words()))
            break;
        const Mesh& mesh = mesh_of(choice);
        const Frame frame = simplified(mesh.frame, choice.without);
        prepared.push_back(renderer_of(renderers, choice)(frame, choice.options()));
        Point point;
        point.choice = choice;
        point.picture = prepared.back().picture();
        set_errors(point, study.truth, mesh.is_silhouette);
        point.difference_factor = amplification_for(point.whole.max);
        point.difference = difference_picture(point.picture, study.truth, point.difference_factor);
        study.points.push_back(std::move(point));
    }

    // The times: round by round, so that a machine which is slow for a while is slow for all.
    const auto start = std::chrono::steady_clock::now();
    for (study.rounds = 0; study.rounds < kLeastRounds || seconds_since(start) < settings.seconds; ++study.rounds) {
        const double share = seconds_since(start) / settings.seconds;
        constexpr int kParts = 100;
        if (settings.progress && !settings.progress(std::min(kParts, static_cast<int>(share * kParts)), kParts,
                                                    "timing, round " + std::to_string(study.rounds + 1)))
            break;
        for (std::size_t i = 0; i < prepared.size(); ++i) {
            // A frame of a film: the one before it was drawn in the same way. (llvmpipe keeps 64 variants of its triangle setup,
            // and takes more than it needs: what other choices have put there in between is not this one's cost.)
            if (study.points[i].choice.renderer != "reference") prepared[i].draw();
            const auto before = std::chrono::steady_clock::now();
            prepared[i].draw();
            study.points[i].seconds.push_back(seconds_since(before));
        }
    }
    find_front(study.points);
    study.findings = findings(study.points);
    return study;
}

}  // namespace twinlight::study
