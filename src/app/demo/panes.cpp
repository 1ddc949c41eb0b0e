// The panes: drawing, comparing, and the reference's pictures.
#include "app/demo/panes.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/text/reason.h"
#include "judge/study/measure.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/reference/reference.h"

namespace twinlight::demo {
namespace {

using session::Cell;
using session::kDifferencePane;
using session::kPanes;
using session::Session;

using Clock = std::chrono::steady_clock;

bool shows_difference(const Session& session) {
    return session.view == session::View::kGrid ||
           (session.view == session::View::kSingle && session.active == kDifferencePane);
}

// Whether the panel Probe shows the colours of all panes. The tutor has only one, which follows the pointer.
bool has_probe(const Session& session) { return session.probe && session.view != session::View::kTutor; }

// Whether the difference needs no picture of the reference, which comes later.
bool compares_live(const Session& session) {
    return session.panes[session.difference.a].renderer != Path::kReference &&
           session.panes[session.difference.b].renderer != Path::kReference;
}

}  // namespace

void FrameTimes::add(double ms) {
    const Clock::time_point now = Clock::now();
    times_.emplace_back(now, ms);
    // At least one stays, however old.
    while (times_.size() > 1 && now - times_.front().first > std::chrono::seconds(1)) times_.pop_front();
}

std::optional<double> FrameTimes::last_ms() const {
    if (times_.empty()) return {};
    return times_.back().second;
}

std::optional<double> FrameTimes::median_ms() const {
    if (times_.empty()) return {};
    std::vector<double> all;
    for (const auto& [when, ms] : times_) all.push_back(ms);
    return study::median(std::move(all));
}

Panes::Panes() : programmable_(std::make_unique<programmable::Renderer>()) {}

bool Panes::wants_image(const Session& session, std::size_t pane) const {
    const bool in_difference = pane == session.difference.a || pane == session.difference.b;
    return has_probe(session) || (in_difference && shows_difference(session));
}

void Panes::draw_pane(const Session& session, std::size_t number) {
    const session::Pane& pane = session.panes[number];
    Drawn& drawn = drawn_[number];
    const Look look = look_of(session, pane);
    const bool is_new = drawn.revision != session.revision || drawn.pane != pane || drawn.look != look ||
                        drawn.width != session.width || drawn.height != session.height;
    // While the scene changes in every frame, only pictures that are compared with each other at once are read back.
    const bool reads = wants_image(session, number) && (!is_new || compares_live(session));
    if (!is_new && !(reads && drawn.image.pixels.empty())) return;
    drawn.error.clear();
    // The first picture of a renderer includes compiling, so it is drawn twice and the second is timed.
    const bool compiles = drawn.pane != pane || drawn.look != look;
    double ms = 0;
    for (int times = compiles ? 2 : 1; times > 0 && drawn.error.empty(); --times) {
        glFinish();  // otherwise the copy of the pane before would be timed here
        const Clock::time_point start = Clock::now();
        try {
            if (pane.renderer == Path::kFixed) {
                fixed::draw(session.scene, {look.shading});
            } else {
                // For drawing frame after frame: numbers that do not change are baked into the shaders.
                programmable_->draw(session.scene.frame, {{look}, programmable::Tier::kAuto});
            }
        } catch (const std::exception& error) {
            drawn.error = reason_of(error);
        }
        glFinish();
        ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
    const fixed::InitialState initial(session.width, session.height);
    if (compiles) drawn.times = {};
    if (is_new) drawn.times.add(ms);
    drawn.image = reads ? read_pixels(session.width, session.height) : Image{};
    drawn.texture.copy_back_buffer(session.width, session.height);
    ++drawn.version;
    drawn.pane = pane;
    drawn.look = look;
    drawn.revision = session.revision;
    drawn.width = session.width;
    drawn.height = session.height;
    drawn.reference.reset();
}

void Panes::request_reference(const Session& session, const std::array<bool, kPanes>& shown) {
    session::ReferenceJob job;
    job.revision = session.revision;
    job.size = {session.width, session.height};
    for (std::size_t i = 0; i < kPanes; ++i) {
        const Look look = look_of(session, session.panes[i]);
        if (shown[i] && session.panes[i].renderer == Path::kReference &&
            std::ranges::find(job.looks, look) == job.looks.end())
            job.looks.push_back(look);
    }
    if (shows_difference(session)) job.allowed_of = common_look(session);
    // The verdict on two pictures of the driver needs the reference's, too.
    if (job.allowed_of && std::ranges::find(job.looks, *job.allowed_of) == job.looks.end())
        job.looks.push_back(*job.allowed_of);
    if (job.looks.empty()) return;
    job.commands = session.history.now();
    worker_.request(std::move(job));
}

void Panes::take_reference(const Session& session) {
    for (auto& picture : worker_.take_pictures()) {
        std::erase_if(references_, [&](const auto& old) { return old->look == picture->look; });
        references_.push_back(std::move(picture));
    }
    if (auto allowed = worker_.take_allowed()) allowed_ = std::move(allowed);
    for (std::size_t i = 0; i < kPanes; ++i) {
        const session::Pane& pane = session.panes[i];
        if (pane.renderer != Path::kReference) continue;
        Drawn& drawn = drawn_[i];
        const Look look = look_of(session, pane);
        const auto found =
            std::ranges::find_if(references_, [&](const auto& picture) { return picture->look == look; });
        if (found == references_.end() || drawn.reference == *found) continue;
        if ((*found)->revision != drawn.revision) drawn.since = Clock::now();
        drawn.reference = *found;
        drawn.pane = pane;
        drawn.look = look;
        drawn.revision = (*found)->revision;
        drawn.error.clear();
        if ((*found)->divisor == 1) drawn.times.add((*found)->ms);
        drawn.image = (*found)->divisor == 1 ? (*found)->image : Image{};
        drawn.texture.upload((*found)->image);
        drawn.texture.set_magnification((*found)->divisor > 1 ? GL_LINEAR : GL_NEAREST);
        ++drawn.version;
    }
    if (const std::string failure = worker_.take_failure(); !failure.empty())
        for (std::size_t i = 0; i < kPanes; ++i)
            if (session.panes[i].renderer == Path::kReference) drawn_[i].error = failure;
}

void Panes::update_difference(const Session& session) {
    const Drawn &a = drawn_[session.difference.a], &b = drawn_[session.difference.b];
    const bool has_both = !a.image.pixels.empty() && a.image.width == b.image.width &&
                          a.image.height == b.image.height && a.revision == b.revision;
    if (!has_both) return;
    const std::optional<Look> look = common_look(session);
    const auto is_right = [&](const auto& picture) {
        return picture->look == look && picture->revision == a.revision && picture->divisor == 1;
    };
    const auto right = std::ranges::find_if(references_, is_right);
    const bool has_allowed = right != references_.end() && allowed_ && allowed_->look == look &&
                             allowed_->revision == a.revision &&
                             allowed_->difference.edge.size() == a.image.pixels.size();
    const std::array<const void*, 2> images = {a.image.pixels.data(), b.image.pixels.data()};
    if (difference_.revision == a.revision && difference_.pair == session.difference && difference_.images == images &&
        difference_.has_allowed == has_allowed &&
        (session.amplification == 0 || session.amplification == difference_.amplification))
        return;
    AllowedDifference allowed(a.image.width, a.image.height);
    if (has_allowed) {
        compare::Render render{.path = Path::kReference, .name = {}, .meaning = {}, .image = (*right)->image};
        render.other_cut = (*right)->other_cut;
        allowed = allowed_of_pair(session, *look, allowed_->difference, render);
    }
    // Each picture is compared with the nearer of the reference's two cuts of quadrilaterals.
    const auto nearer = [&](const Drawn& reference, const Image& image) {
        if (!has_allowed || !(*right)->other_cut) return reference.image;
        return nearer_of(image, reference.image, *(*right)->other_cut, allowed.channels());
    };
    const Image first = a.reference ? nearer(a, b.image) : a.image;
    const Image second = b.reference ? nearer(b, a.image) : b.image;
    difference_.revision = a.revision;
    difference_.pair = session.difference;
    difference_.images = images;
    difference_.has_allowed = has_allowed;
    difference_.numbers = difference(first, second, allowed);
    difference_.verdict.reset();
    if (has_allowed) difference_.verdict = verdict_on_pair(session, difference_.numbers, allowed);
    if (!look) difference_.verdict = meant_to_differ(difference_.numbers);
    difference_.amplification =
        session.amplification != 0 ? session.amplification : amplification_for(difference_.numbers.interior.max);
    difference_.texture.upload(difference_picture(first, second, difference_.amplification));
}

bool Panes::lacks_images(const Session& session) const {
    for (std::size_t i = 0; i < kPanes; ++i)
        if (wants_image(session, i) && session.panes[i].renderer != Path::kReference &&
            drawn_[i].image.pixels.empty() && drawn_[i].error.empty())
            return true;
    return false;
}

void Panes::update(const Session& session, const session::Layout& layout) {
    std::array<bool, kPanes> shown{};
    for (const Cell& cell : layout.cells) {
        if (cell.pane < kPanes)
            shown[cell.pane] = true;
        else if (cell.pane == kDifferencePane)
            shown[session.difference.a] = shown[session.difference.b] = true;
    }
    if (session.view == session::View::kSlider) shown[session.slider.a] = shown[session.slider.b] = true;
    if (has_probe(session)) shown.fill(true);
    for (std::size_t i = 0; i < kPanes; ++i)
        if (shown[i] && session.panes[i].renderer != Path::kReference) draw_pane(session, i);
    request_reference(session, shown);
    take_reference(session);
    if (shows_difference(session)) update_difference(session);
    for (std::size_t i = 0; i < kPanes; ++i) {
        Drawn& drawn = drawn_[i];
        if (shown[i] && any(session.overlays) && drawn.revision == session.revision)
            drawn.overlaid.update(session, drawn.look, drawn.texture.name(), drawn.version);
    }
    if (session.view == session::View::kWorld || session.view == session::View::kTutor)
        world_.update(session, *programmable_);
}

std::array<std::optional<Rgba>, kPanes> Panes::colors_at(int x, int y) const {
    std::array<std::optional<Rgba>, kPanes> colors;
    for (std::size_t i = 0; i < kPanes; ++i) {
        const Image& image = drawn_[i].image;
        if (x >= 0 && y >= 0 && x < image.width && y < image.height) colors[i] = image.at(x, y);
    }
    return colors;
}

}  // namespace twinlight::demo
