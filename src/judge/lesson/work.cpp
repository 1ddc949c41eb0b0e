// Work: makes the pictures of an answer when a check needs them.
#include "judge/lesson/work.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/reference/reference.h"
#include "scene/frame/resized.h"
#include "scene/state/state.h"

namespace twinlight::lesson {

namespace {

// The scene at the size that it is written for, then all window coordinates scaled.
Frame frame_of_size(const CommandList& commands, int width, int height) {
    const WindowSize size = commands.window.value_or(WindowSize{});
    return resized(make_frame(commands, {.width = size.width, .height = size.height}), width, height);
}

reference::Options options(std::optional<Shading> shading = std::nullopt) {
    reference::Options chosen;
    chosen.shading = shading;
    chosen.lecture_variants = false;
    return chosen;
}

// How far the camera is moved: in radians about the y axis, and up by this share of its distance.
constexpr double kTurn = 1.3, kRise = 0.5;

}  // namespace

Work::Work(std::shared_ptr<const CommandList> commands, const Work* start)
    : commands_(std::move(commands)), start_(start), frame_(frame_of_size(*commands_, kWidth, kHeight)) {}

const Image& Work::picture(std::optional<Shading> shading) const {
    auto found = pictures_.find(shading);
    if (found == pictures_.end()) found = pictures_.emplace(shading, reference::render(frame_, options(shading))).first;
    return found->second;
}

Image Work::picture_of_size(int width, int height) const {
    return reference::render(frame_of_size(*commands_, width, height), options());
}

const Image& Work::matte() const {
    if (!matte_) {
        Frame dull = frame_;
        const auto darken = [](Material& material) { material.specular = {0, 0, 0, 1}; };
        for (Draw* draw : dull.editable_draws()) {
            darken(draw->lighting.front);
            darken(draw->lighting.back);
            for (Materials& materials : draw->materials) {
                darken(materials.front);
                darken(materials.back);
            }
            if (draw->lighting.color_material.mode == kGL_SPECULAR) draw->lighting.color_material.enabled = false;
        }
        matte_ = reference::render(dull, options());
    }
    return *matte_;
}

const std::vector<double>& Work::highlight() const {
    if (!highlight_) {
        const Image &with = picture(), &without = matte();
        highlight_.emplace(with.pixels.size());
        for (std::size_t i = 0; i < with.pixels.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                (*highlight_)[i] =
                    std::max((*highlight_)[i], static_cast<double>(with.pixels[i][c]) - without.pixels[i][c]);
    }
    return *highlight_;
}

const std::vector<int>& Work::shapes() const {
    if (!shapes_) shapes_ = reference::seen_shapes(frame_, options());
    return *shapes_;
}

int Work::number_of(int shape) const {
    if (unmoved_) return unmoved_->number_of(shape);
    if (!start_) return shape;
    // The shape that most pixels of the start's shape show now.
    std::map<int, int> votes;
    const std::vector<int>& before = start_->shapes();
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i] == shape && shapes()[i] >= 0) ++votes[shapes()[i]];
    const auto most = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; });
    return most == votes.end() ? shape : most->first;
}

std::vector<const Draw*> Work::shape(int number) const {
    const int chosen = number_of(number);
    std::vector<const Draw*> found;
    int at = -1;
    const Draw* last = nullptr;
    for (const Draw* draw : frame_.draws()) {
        if (!last || !are_one_shape(*last, *draw)) ++at;
        last = draw;
        if (at == chosen) found.push_back(draw);
    }
    return found;
}

const Work* Work::moved() const {
    if (!moved_) {
        auto list = std::make_shared<CommandList>(*commands_);
        bool has_camera = false;
        for (Command& command : list->commands) {
            if (command.id != CommandId::gluLookAt) continue;
            has_camera = true;
            std::vector<double>& at = command.arguments;  // eye, centre, up
            const double x = at[0] - at[3], z = at[2] - at[5];
            at[0] = at[3] + std::cos(kTurn) * x + std::sin(kTurn) * z;
            at[1] += kRise * std::hypot(x, z);
            at[2] = at[5] - std::sin(kTurn) * x + std::cos(kTurn) * z;
        }
        moved_ = has_camera ? std::make_unique<Work>(std::move(list), start_) : nullptr;
        if (*moved_) (*moved_)->unmoved_ = this;
    }
    return moved_->get();
}

}  // namespace twinlight::lesson
