// The panes: drawing, comparing, and the reference's pictures.
#include "app/demo/panes.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "app/session/scenes.h"
#include "judge/study/measure.h"
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

// How long a frame waits for pictures. Later ones are shown when they are ready: the driver compiles, or the scene is large.
constexpr std::chrono::milliseconds kPatience{80};

// The numbers of jobs: panes have their own, then the world, the small pictures and the panes with overlays.
constexpr std::size_t kSmallJob = session::kWorldPane + 1, kFirstOverlaidJob = kSmallJob + 1;

// The image in which row 0 is at the top.
Image image_of(const std::vector<std::uint8_t>& rgba, int width, int height) {
    Image image(width, height);
    auto code = rgba.begin();
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            for (float& channel : image.at(x, y)) channel = static_cast<float>(*code++) / 255.0F;
    return image;
}

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

bool Panes::wants_image(const Session& session, std::size_t pane) const {
    const bool in_difference = pane == session.difference.a || pane == session.difference.b;
    return has_probe(session) || (in_difference && shows_difference(session));
}

void Panes::request_picture(const Session& session, std::size_t number) {
    Drawn& drawn = drawn_[number];
    const Wanted wanted{session.panes[number], look_of(session, session.panes[number]), session.revision, session.width,
                        session.height};
    if (drawn.wanted == wanted) return;
    if (!scene_ || scene_revision_ != session.revision) scene_ = std::make_shared<const Scene>(session.scene);
    scene_revision_ = session.revision;
    const bool is_first = !drawn.wanted || drawn.wanted->pane != wanted.pane || drawn.wanted->look != wanted.look;
    drawn.wanted = wanted;
    PaneJob job;
    job.pane = number;
    job.size = {session.width, session.height};
    job.is_first = is_first;
    job.renderer = wanted.pane.renderer;
    job.look = wanted.look;
    job.revision = wanted.revision;
    job.draw = [scene = scene_, renderer = job.renderer, look = job.look](Renderers& renderers) {
        if (renderer == Path::kFixed)
            fixed::draw(*scene, {look.shading});
        else  // For drawing frame after frame: numbers that do not change are baked into the shaders.
            renderers.panes.draw(scene->frame, {{look}, programmable::Tier::kAuto});
    };
    painter_.request(std::move(job));
}

// The pane's texture is in the window's context, so the worker gets the pixels.
void Panes::request_overlaid(const Session& session, std::size_t number) {
    Drawn& drawn = drawn_[number];
    if (drawn.revision != session.revision) return;
    std::function<void(Texture&)> upload;
    if (drawn.reference)
        upload = [reference = drawn.reference](Texture& texture) {
            texture.upload(reference->image);
            if (reference->divisor > 1) texture.set_magnification(GL_LINEAR);
        };
    else
        upload = [rgba = drawn.rgba, width = drawn.width, height = drawn.height](Texture& texture) {
            texture.upload(*rgba, width, height);
        };
    auto job = drawn.overlaid.next_job(session, drawn.look, drawn.version, std::move(upload));
    if (!job) return;
    job->pane = kFirstOverlaidJob + number;
    painter_.request(std::move(*job));
}

void Panes::take_pictures() {
    for (PanePicture& picture : painter_.take()) {
        const std::size_t number = picture.job.pane;
        if (number < kPanes)
            take_picture(picture);
        else if (number == session::kWorldPane)
            world_.take(picture);
        else if (number == kSmallJob)
            take_small_picture(picture);
        else
            drawn_[number - kFirstOverlaidJob].overlaid.take(picture);
    }
}

// A picture of an earlier revision is shown until the next one is there.
void Panes::take_picture(PanePicture& picture) {
    const PaneJob& job = picture.job;
    Drawn& drawn = drawn_[job.pane];
    if (!drawn.wanted || drawn.wanted->pane.renderer != job.renderer || drawn.wanted->look != job.look) return;
    drawn.error = picture.error;
    if (job.is_first) drawn.times = {};
    drawn.times.add(picture.ms);
    drawn.image = {};
    drawn.is_new = true;
    drawn.rgba = std::make_shared<const std::vector<std::uint8_t>>(std::move(picture.rgba));
    drawn.width = job.size.width;
    drawn.height = job.size.height;
    drawn.texture.upload(*drawn.rgba, drawn.width, drawn.height);
    drawn.texture.set_magnification(GL_NEAREST);
    ++drawn.version;
    drawn.pane = drawn.wanted->pane;
    drawn.look = job.look;
    drawn.revision = job.revision;
    drawn.reference.reset();
}

// One at a time, so that a pane's picture never waits for more than one.
unsigned Panes::small_picture(const std::string& scene) {
    if (const auto found = small_.find(scene); found != small_.end()) return found->second->name();
    if (small_wanted_) return 0;
    small_wanted_ = scene;
    PaneJob job;
    job.pane = kSmallJob;
    job.size = kSmallPicture;
    job.is_small = true;
    job.draw = [scene](Renderers&) { fixed::draw(*session::small_scene(scene, kSmallPicture)); };
    painter_.request(std::move(job));
    return 0;
}

void Panes::take_small_picture(const PanePicture& picture) {
    auto texture = std::make_unique<Texture>(GL_LINEAR);
    texture->upload(picture.rgba, kSmallPicture.width, kSmallPicture.height);
    small_[*std::exchange(small_wanted_, std::nullopt)] = std::move(texture);
}

// While the scene changes in every frame, only pictures that are compared with each other at once are needed as images.
void Panes::make_images(const Session& session) {
    for (std::size_t i = 0; i < kPanes; ++i) {
        Drawn& drawn = drawn_[i];
        const bool is_new = std::exchange(drawn.is_new, false);
        if (!drawn.rgba || !drawn.image.pixels.empty() || !wants_image(session, i)) continue;
        if (!is_new || compares_live(session)) drawn.image = image_of(*drawn.rgba, drawn.width, drawn.height);
    }
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
    if (shows_difference(session)) {
        job.allowed_of = common_look(session);
        drivers_precision();  // starts its thread
    }
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
        drawn.wanted.reset();
        drawn.rgba.reset();
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
    const bool has_allowed = drivers_precision() && right != references_.end() && allowed_ && allowed_->look == look &&
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

bool Panes::is_busy(const Session& session) const {
    return is_late_ || worker_.is_busy() || lacks_images(session) || small_wanted_ ||
           (shows_difference(session) && !drivers_precision());
}

void Panes::wait(const Session& session) const {
    painter_.wait_until_idle();
    worker_.wait();
    if (shows_difference(session)) wait_for_drivers_precision();
}

bool Panes::is_behind(const Drawn& drawn) const {
    return drawn.wanted && (drawn.pane != drawn.wanted->pane || drawn.look != drawn.wanted->look ||
                            drawn.revision != drawn.wanted->revision);
}

void Panes::update(const Session& session, const session::Layout& layout, bool waits) {
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
        if (shown[i] && session.panes[i].renderer != Path::kReference) request_picture(session, i);
    if (session.view == session::View::kWorld || session.view == session::View::kTutor)
        if (auto job = world_.next_job(session)) painter_.request(std::move(*job));
    const Clock::time_point end = Clock::now() + (is_late_ ? Clock::duration::zero() : kPatience);
    const auto take = [&] {
        painter_.wait(waits ? std::nullopt : std::optional(end));
        take_pictures();
    };
    take();
    make_images(session);
    request_reference(session, shown);
    take_reference(session);
    if (shows_difference(session)) update_difference(session);
    for (std::size_t i = 0; i < kPanes; ++i) {
        if (!any(session.overlays))
            drawn_[i].overlaid.forget();
        else if (shown[i])
            request_overlaid(session, i);
    }
    take();
    is_late_ = painter_.is_drawing();
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
