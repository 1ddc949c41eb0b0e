#include <algorithm>
#include <chrono>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

#include "base/image/difference.h"
#include "base/image/png.h"
#include "base/text/translation.h"
#include "judge/study/study.h"

namespace twinlight::study {

namespace {

constexpr std::size_t kLeastRounds = 3;

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// The scene with one number of slices, and the mask of its pixels at outlines.
struct Mesh {
    Frame frame;
    std::vector<char> is_silhouette;
};

// A study while it runs. All choices stay prepared, because they are timed in turns.
class Run {
  public:
    Run(const std::function<Frame(int slices)>& frame_of, bool has_slices, const ChoiceRenderers& renderers,
        const Settings& settings)
        : frame_of_(frame_of),
          renderers_(renderers),
          settings_(settings),
          scene_(frame_of(0)),
          truth_(renderers
                     .prepare(scene_,
                              {.method = Method::kReference, .shading = Shading::kExact, .samples = settings.coverage})
                     .picture()) {
        study_.width = scene_.width;
        study_.height = scene_.height;
        study_.extent = settings.extent;
        study_.coverage = settings.coverage;
        study_.series.resize(1);
        study_.truth_png = encode_png(truth_.image());
        seen_ = renderers.seen(scene_, {{.shading = Shading::kExact}});
        all_ = settings.choices.empty() ? select_choices(scene_, has_slices, settings.extent, settings.coverage)
                                        : settings.choices;
    }

    Study study() {
        draw_all();
        keep_earlier();
        take_times();
        find_fronts(study_);
        write_findings(study_);
        return std::move(study_);
    }

  private:
    bool goes_on(int done, int total, const std::string& next, double seconds_left) const {
        return !settings_.progress || settings_.progress({done, total, next, seconds_left});
    }

    const Mesh& mesh_of(const Choice& choice) {
        const bool is_exact = choice.shading == Shading::kExact;
        const auto [found, is_new] = meshes_.try_emplace({choice.slices, is_exact});
        if (is_new) {
            found->second.frame = is_exact ? scene_ : frame_of_(choice.slices);
            const reference::Options lit_by_pixel{{.shading = is_exact ? Shading::kExact : Shading::kPhong}};
            found->second.is_silhouette =
                silhouettes(renderers_.seen(found->second.frame, lit_by_pixel), seen_, study_.width, study_.height);
        }
        return found->second;
    }

    // Draws all choices and measures their errors.
    void draw_all() {
        const auto start = Clock::now();
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const double each = i == 0 ? 0 : seconds_since(start) / static_cast<double>(i);
            const double left = each * static_cast<double>(all_.size() - i) + settings_.seconds;
            if (!goes_on(static_cast<int>(i), static_cast<int>(all_.size()), all_[i].words(), left)) return;
            try {
                draw(all_[i]);
            } catch (const Refused&) {
                // This choice is left out.
            } catch (const std::runtime_error& error) {
                if (settings_.failed) settings_.failed(all_[i], error.what());
            }
        }
    }

    const Point* earlier(const Choice& choice) const {
        if (!settings_.earlier) return nullptr;
        const auto same = std::ranges::find(settings_.earlier->points, choice, &Point::choice);
        return same == settings_.earlier->points.end() ? nullptr : &*same;
    }

    // Adds the points of an earlier study that this run did not reach.
    void keep_earlier() {
        for (const Choice& choice : all_) {
            const Point* point = earlier(choice);
            if (point && std::ranges::find(study_.points, choice, &Point::choice) == study_.points.end())
                study_.points.push_back(*point);
        }
    }

    void draw(const Choice& choice) {
        const Mesh& mesh = mesh_of(choice);
        Prepared prepared = renderers_.prepare(with_lighting_change(mesh.frame, choice.lighting_change), choice);
        const Image picture = prepared.picture();
        Point point;
        point.choice = choice;
        point.errors = truth_.errors_of(picture, mesh.is_silhouette);
        point.picture_png = encode_png(picture);
        point.difference_factor = amplification_for(point.errors.whole.max);
        point.difference_png = encode_png(difference_picture(picture, truth_.image(), point.difference_factor));
        if (const Point* before = earlier(choice)) point.seconds = before->seconds;
        study_.points.push_back(std::move(point));
        prepared_.push_back(std::move(prepared));
    }

    // Times all choices once per round, so that a slow phase of the machine affects all of them.
    void take_times() {
        if (settings_.earlier) study_.series[0].rounds = settings_.earlier->series.at(0).rounds;
        const auto start = Clock::now();
        const auto lacks_rounds = [&] {
            return std::ranges::any_of(std::span(study_.points).first(prepared_.size()),
                                       [](const Point& point) { return point.seconds.size() < kLeastRounds; });
        };
        const double all = static_cast<double>(prepared_.size());
        for (int round = 0; !prepared_.empty() && (lacks_rounds() || seconds_since(start) < settings_.seconds);
             ++round) {
            for (std::size_t i = 0; i < prepared_.size(); ++i) {
                const double gone = seconds_since(start), rounds = round + static_cast<double>(i) / all;
                const double least = static_cast<double>(kLeastRounds);
                const double whole = std::max(settings_.seconds, rounds > 0 ? gone / rounds * least : 0);
                constexpr int kParts = 100;
                const int part = whole > 0 ? std::min(kParts, static_cast<int>(kParts * gone / whole)) : 0;
                const std::string next = tr("timing, round {}", study_.series[0].rounds + 1);
                if (!goes_on(part, kParts, next, std::max(0.0, whole - gone))) return;
                study_.points[i].seconds.push_back(time_of(i));
            }
            ++study_.series[0].rounds;
        }
    }

    double time_of(std::size_t i) const {
        // Draws once before timing, as if the previous frame was drawn in the same way. (llvmpipe caches only 64
        // variants of its triangle setup, and other choices may have replaced this choice's variants.)
        if (study_.points[i].choice.method != Method::kReference) prepared_[i].draw();
        const auto before = Clock::now();
        prepared_[i].draw();
        return seconds_since(before);
    }

    const std::function<Frame(int slices)>& frame_of_;
    const ChoiceRenderers& renderers_;
    const Settings& settings_;
    Frame scene_;
    Truth truth_;
    Study study_;
    std::vector<int> seen_;
    std::vector<Choice> all_;
    std::map<std::pair<int, bool>, Mesh> meshes_;  // by slices, and whether surfaces are exact
    std::vector<Prepared> prepared_;               // belongs to the first points of study_.points, in order
};

}  // namespace

double Point::median_seconds() const { return median(seconds); }

std::array<double, 2> Point::quartiles_seconds() const { return {quantile(seconds, 0.25), quantile(seconds, 0.75)}; }

Study run(const std::function<Frame(int slices)>& frame_of, bool has_slices, const ChoiceRenderers& renderers,
          const Settings& settings) {
    return Run(frame_of, has_slices, renderers, settings).study();
}

}  // namespace twinlight::study
