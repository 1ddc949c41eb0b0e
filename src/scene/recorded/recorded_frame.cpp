#include "scene/recorded/recorded_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/recorded/draws_nothing.h"
#include "scene/recorded/earlier_frames.h"
#include "scene/state/not_finite.h"

namespace twinlight {

namespace {

constexpr int kDefaultWidth = 640, kDefaultHeight = 480;
constexpr int kLargestSide = 8192;  // every driver allows viewports of this size
constexpr std::size_t kCommandsBetweenProgress = 1 << 16;
// The most earlier frames that are drawn before a frame that shows them, and the most vertices that these have together.
constexpr int kMostEarlierFrames = 50;
constexpr std::size_t kMostEarlierVertices = 200'000;

const Command kEnd{CommandId::glEnd, {}, {}};

std::optional<Command> made_finite(const Step& step) {
    return step.kind == Step::Kind::kCommand ? twinlight::made_finite(step.command) : std::nullopt;
}

// The first steps of a recording, and the commands that end what these leave open. `frame_ends`: how many ends of frames it has; the
// frames after these are one picture.
class Beginning final : public Recording {
  public:
    Beginning(std::shared_ptr<const Recording> whole, const FrameChoice& choice, std::size_t steps, int frame_ends,
              std::vector<Command> endings)
        : Recording(tr("{}, frame {}", whole->name, choice.number.value_or(0))),
          whole_(std::move(whole)),
          choice_(choice),
          steps_(steps),
          frame_ends_(frame_ends),
          endings_(std::move(endings)) {}

    void for_each(const std::function<bool(const Step&)>& visit) const override {
        std::size_t left = steps_;
        int frame_ends_left = frame_ends_;
        bool go_on = true;
        if (left > 0) {
            whole_->for_each([&](const Step& step) {
                const std::optional<Command> finite = made_finite(step);
                if (step.kind != Step::Kind::kFrameEnd || frame_ends_left-- > 0)
                    go_on = finite ? visit({.command = *finite}) : visit(step);
                return --left > 0 && go_on;
            });
        }
        for (auto ending = endings_.begin(); go_on && ending != endings_.end(); ++ending)
            go_on = visit({.command = *ending});
    }
    std::vector<std::string> notes() const override { return whole_->notes(); }
    std::shared_ptr<const std::string> text_of(const Place& place) const override { return whole_->text_of(place); }
    // The frame that comes so many later, of the same size.
    RecordedFrame later(int frames, WindowSize size) const {
        FrameChoice choice = choice_;
        choice.number = *choice.number + frames;
        choice.width = size.width;
        choice.height = size.height;
        return make_recorded_frame(whole_, choice);
    }
    // How many of the next frames there are, but no more than `most`.
    int frames_left(int most) const {
        int ends = -*choice_.number;
        whole_->for_each([&](const Step& step) {
            ends += step.kind == Step::Kind::kFrameEnd;
            return ends <= most;
        });
        return ends - 1;
    }

  private:
    std::shared_ptr<const Recording> whole_;
    FrameChoice choice_;  // with its number
    std::size_t steps_;
    int frame_ends_;
    std::vector<Command> endings_;
};

// The command that ends a frame.
enum class FrameEnd : std::uint8_t { kSwap, kFlush };

class Player {
  public:
    // `keeps`: whether earlier frames are kept to their ends, for textures that copy their pixels. `first_shown`: the first frame
    // that stays after a swap of buffers.
    Player(const FrameChoice& choice, FrameEnd frame_end, bool keeps, int first_shown, int width, int height)
        : choice_(choice),
          frame_end_(frame_end),
          keeps_(keeps),
          first_shown_(first_shown),
          width_(width),
          height_(height),
          state_({.width = width, .height = height, .signed_rule = choice.signed_rule, .memory = choice.memory}) {}

    // Plays the recording up to the end of the chosen frame. Returns false if there is no such frame.
    bool play(const Recording& recording) {
        bool found = false;
        recording.for_each([&](const Step& step) {
            found = take(step);
            return !found;
        });
        return found || take_end();
    }

    bool swaps() const { return swaps_; }
    // Whether a texture has copies of an earlier frame that was not kept.
    bool lacks_copies() const {
        return std::ranges::any_of(lost_, [](const auto& copy) { return copy.use_count() > 0; });
    }
    int frames() const { return frame_; }  // complete frames before the chosen one
    // The first of the frames before the chosen one that may show in it, as far as the limits allow; the chosen one if none does.
    int first_that_shows() const;
    // Whether the frames from first_shown on together are more than the memory allows. The recording was not played to the end.
    bool shows_too_much() const { return shows_too_much_; }
    // Why nothing is drawn.
    std::string why() const {
        return nothing_.why(frame_, state_.error_count()) + (notes_.empty() ? "" : tr("; ") + notes_.back());
    }
    RecordedFrame result(const std::shared_ptr<const Recording>& recording);

    // The smallest size that contains all viewports; nullopt if they are empty. Views that divide a window may reach a pixel beyond it;
    // the recorder, or the program, set the whole window first.
    std::optional<std::pair<int, int>> size() const {
        if (reach_x_ <= 0 || reach_y_ <= 0) return std::nullopt;
        constexpr std::int64_t kBeyond = 2;
        const auto side = [](std::int64_t reach, std::int64_t first) {
            const std::int64_t whole = reach > first && reach <= first + kBeyond ? first : reach;
            return static_cast<int>(std::min<std::int64_t>(whole, kLargestSide + 1));
        };
        return std::pair(side(reach_x_, first_.width), side(reach_y_, first_.height));
    }
    // Whether something was drawn in the initial viewport.
    bool draws_in_initial_viewport() const { return draws_in_initial_viewport_; }

  private:
    bool take(const Step& step);
    bool take_end();
    void end_begin();
    void command(const Command& command);
    bool end_frame();
    bool drops_frame() const {
        return choice_.number && frame_ < *choice_.number && frame_end_ == FrameEnd::kSwap && !keeps_ &&
               frame_ < first_shown_;
    }
    void reach(const Rectangle& viewport) {
        reach_x_ = std::max(reach_x_, std::int64_t{viewport.x} + viewport.width);
        reach_y_ = std::max(reach_y_, std::int64_t{viewport.y} + viewport.height);
    }
    static bool is_flush(const Step& step) {
        return step.kind == Step::Kind::kCommand &&
               (step.command.id == CommandId::glFlush || step.command.id == CommandId::glFinish);
    }

    const FrameChoice& choice_;
    FrameEnd frame_end_;
    bool keeps_;
    int first_shown_;
    int width_, height_;
    State state_;
    std::vector<std::weak_ptr<const CopiedPixels>> lost_;  // of earlier frames
    std::size_t steps_ = 0;
    int frame_ = 0;
    // What this frame shows of earlier ones, and what each frame before did.
    EarlierFrames earlier_;
    struct ShownBefore {
        bool shows_earlier = false;
        std::size_t vertices = 0;
    };
    std::size_t vertices_ = 0;  // of this frame
    std::vector<ShownBefore> before_;
    bool shows_too_much_ = false;
    bool swaps_ = false;
    bool changed_ = false;  // something was drawn or cleared since the end of the last frame
    bool drawn_ = false;    // something was drawn
    bool ever_drawn_ = false;
    std::vector<Command> endings_;
    DrawsNothing nothing_;
    bool draws_in_initial_viewport_ = false;
    bool is_viewport_of_window_ = true;  // the newest glViewport is not of selection or feedback
    std::int64_t reach_x_ = 0, reach_y_ = 0;
    Rectangle first_;  // the first that starts in the corner
    // Why the first frame is too large, if it is. Where nothing is ever swapped, it ends at a glFlush, and may be smaller.
    std::optional<std::string> exhausted_;
    std::vector<std::string> notes_;
    int not_finite_ = 0;  // commands with NaN or infinity
    std::string first_not_finite_;
};

// Returns true when the frame is complete.
bool Player::take(const Step& step) {
    if (exhausted_) {
        if (step.kind == Step::Kind::kFrameEnd) throw SceneError(*exhausted_);
        return false;
    }
    if (step.kind == Step::Kind::kFrameEnd && frame_end_ == FrameEnd::kSwap) {
        swaps_ = true;
        if (end_frame()) return true;
        if (frame_ <= first_shown_) state_.drop_picture();
    }
    ++steps_;
    if (!ever_drawn_) nothing_.take(step);
    if (choice_.progress && steps_ % kCommandsBetweenProgress == 0) choice_.progress(frame_, steps_);
    switch (step.kind) {
        case Step::Kind::kCommand:
            if (const auto finite = made_finite(step)) {
                if (not_finite_++ == 0)
                    first_not_finite_ = fmt::format("{} ({})", step.command.place.str(), finite->name());
                command(*finite);
            } else {
                command(step.command);
            }
            break;
        case Step::Kind::kOutside: state_.outside(step.text, step.command.place); break;
        case Step::Kind::kElsewhere: state_.made_elsewhere(step.object, step.text, step.command.place); break;
        case Step::Kind::kCutOff: notes_.emplace_back(step.text); break;
        case Step::Kind::kFrameEnd: break;
    }
    if (shows_too_much_) return true;
    return frame_end_ == FrameEnd::kFlush && is_flush(step) && changed_ && !state_.inside_begin() && end_frame();
}

// Handles the commands after the end of the last frame. Returns true if they complete the chosen frame.
bool Player::take_end() {
    if (exhausted_) return false;
    const bool is_cut = state_.inside_begin() || state_.unfinished() || swaps_;
    end_begin();
    if (!changed_ || !end_frame()) return false;
    if (is_cut) notes_.emplace_back(tr("the recording ends inside this frame, so its picture may be incomplete"));
    return true;
}

void Player::end_begin() {
    if (!state_.inside_begin()) return;
    endings_.push_back(kEnd);
    command(kEnd);
}

void Player::command(const Command& command) {
    const std::size_t before = state_.items().size();
    state_.apply(command);
    if (const auto& error = state_.exhausted()) {
        shows_too_much_ = frame_ > first_shown_;
        if (shows_too_much_) return;
        exhausted_ = tr("{}: {}; this recording cannot be drawn", error->place.str(), error->message);
        if (frame_end_ == FrameEnd::kFlush || swaps_) throw SceneError(*exhausted_);
        return;
    }
    // Programs with framebuffer objects also set the viewport for those, and selection and feedback (5.2, 5.3) may use any viewport.
    if (command.id == CommandId::glViewport) is_viewport_of_window_ = state_.render_mode() == kGL_RENDER;
    if (command.id == CommandId::glViewport && is_viewport_of_window_ && state_.framebuffers().named.empty()) {
        const Rectangle& viewport = state_.raster().viewport;
        if (first_ == Rectangle{} && viewport.x == 0 && viewport.y == 0) first_ = viewport;
        reach(viewport);
    }
    if (state_.items().size() == before) return;
    for (auto item = state_.items().begin() + static_cast<std::ptrdiff_t>(before); item != state_.items().end();
         ++item) {
        earlier_.take(*item);
        if (const TakePixels* copy = std::get_if<TakePixels>(&*item)) {
            if (drops_frame()) lost_.emplace_back(copy->pixels);
            continue;
        }
        changed_ = true;
        const Draw* draw = std::get_if<Draw>(&*item);
        if (!draw) continue;
        const Rectangle& viewport = draw->raster.viewport;
        vertices_ += draw->vertices.size();
        drawn_ = ever_drawn_ = true;
        if (draw->pixels) continue;  // its viewport is not the program's
        draws_in_initial_viewport_ |=
            viewport.x == 0 && viewport.y == 0 && viewport.width == width_ && viewport.height == height_;
        reach(viewport);
    }
    // Delete what no later picture shows.
    if (drops_frame())
        state_.drop_picture();
    else
        state_.drop_hidden();
}

// Whether the frame that ends here is the chosen one.
bool Player::end_frame() {
    earlier_.end();
    if (choice_.number ? frame_ == *choice_.number : drawn_) return true;
    before_.push_back({earlier_.show(), vertices_});
    earlier_ = {};
    vertices_ = 0;
    ++frame_;
    changed_ = drawn_ = false;
    return false;
}

int Player::first_that_shows() const {
    if (frame_ == 0 || frame_end_ != FrameEnd::kSwap || !earlier_.show()) return frame_;
    int first = frame_;
    std::size_t vertices = 0;
    do {
        const ShownBefore& one = before_[static_cast<std::size_t>(first) - 1];
        vertices += one.vertices;
        if (vertices > kMostEarlierVertices) break;
        --first;
    } while (first > 0 && frame_ - first < kMostEarlierFrames &&
             before_[static_cast<std::size_t>(first)].shows_earlier);
    return first;
}

RecordedFrame Player::result(const std::shared_ptr<const Recording>& recording) {
    if (!drawn_ && !choice_.may_be_empty) {
        throw SceneError(tr("{}: frame {} draws nothing; leave out --frame to get the first frame that does",
                            recording->name, frame_));
    }
    end_begin();
    // Scenes must end what they begin, but a frame may leave it to the next.
    for (Command& ending : state_.endings()) {
        state_.apply(ending);
        endings_.push_back(std::move(ending));
    }
    if (state_.framebuffers().draw == 0 && is_viewport_of_window_) reach(state_.raster().viewport);
    RecordedFrame result;
    result.number = frame_;
    result.error_count = state_.error_count();
    if (!state_.errors().empty()) result.first_error = state_.errors().front();
    result.notes = std::move(notes_);
    if (not_finite_ > 0)
        result.notes.push_back(
            tr("{} of the program's commands up to this frame {} NaN or infinity; the first: {}. GL leaves open what "
               "that does (section 2.1.1). All renderers draw 0 for NaN, and 2^32 for infinity.",
               not_finite_, tr(not_finite_ == 1 ? "has" : "have"), first_not_finite_));
    if (frame_end_ == FrameEnd::kSwap && earlier_.show() && frame_ > 0) {
        const int shown = frame_ - std::min(first_shown_, frame_);
        const bool are_all = shown == frame_ || !before_[static_cast<std::size_t>(frame_ - shown)].shows_earlier;
        const std::string before = shown == 1 ? tr("the one before is") : tr("the {} before are", shown);
        const char* const left_out = are_all ? "" : tr(", and those before them left out");
        result.notes.push_back(
            tr("this frame shows what earlier frames left in {}; {}", earlier_.words(),
               shown == 0 ? tr("they are too large to draw them first")
                          : tr("{} drawn first{}, as for a window that keeps its picture", before, left_out)));
    }
    FrameChoice choice = choice_;
    choice.number = frame_;
    result.scene = {std::make_shared<const Beginning>(recording, choice, steps_, std::min(first_shown_, frame_),
                                                      std::move(endings_)),
                    state_.take_frame()};
    return result;
}

}  // namespace

RecordedFrame make_recorded_frame(const std::shared_ptr<const Recording>& recording, const FrameChoice& choice) {
    int width = choice.width.value_or(kDefaultWidth), height = choice.height.value_or(kDefaultHeight);
    FrameEnd frame_end = FrameEnd::kSwap;
    bool keeps = false;
    // Nothing stays until a frame is found that shows what earlier frames left.
    constexpr int kNone = std::numeric_limits<int>::max();
    int first_shown = kNone;
    bool knows_shown = false;
    while (true) {
        Player player(choice, frame_end, keeps, first_shown, width, height);
        const bool found = player.play(*recording);
        if (player.shows_too_much()) {
            first_shown = kNone;
            continue;
        }
        if (player.lacks_copies()) {
            keeps = true;
            continue;
        }
        if (!player.swaps() && frame_end == FrameEnd::kSwap) {
            frame_end = FrameEnd::kFlush;
            continue;
        }
        if (!found) {
            const int frames = player.frames();
            if (!choice.number || frames == 0) {
                std::string why = player.why();
                for (const std::string& note : recording->notes()) why += tr("; ") + note;
                throw SceneError(tr("{}: this recording draws nothing: {}", recording->name, why));
            }
            throw SceneError(tr("{}: the recording has no frame {}; {}", recording->name, *choice.number,
                                frames == 1 ? tr("its only frame is 0") : tr("its frames are 0 to {}", frames - 1)));
        }
        if (!knows_shown) {
            knows_shown = true;
            if (const int first = player.first_that_shows(); first < player.frames()) {
                first_shown = first;
                continue;
            }
        }
        RecordedFrame result = player.result(recording);
        if (choice.width && choice.height) return result;
        const auto [reach_x, reach_y] = player.size().value_or(std::pair(width, height));
        if (std::max(reach_x, reach_y) > kLargestSide) {
            throw SceneError(tr("{}: a viewport is larger than {} pixels; set the picture's size with --size",
                                recording->name, kLargestSide));
        }
        const bool same = reach_x == width && reach_y == height;
        if (!same &&
            player.draws_in_initial_viewport()) {  // the initial viewport follows the picture's size: play it again
            width = reach_x;
            height = reach_y;
            continue;
        }
        result.scene.frame.width = reach_x;
        result.scene.frame.height = reach_y;
        return result;
    }
}

RecordedFrame later_frame(const Scene& scene, int frames) {
    return dynamic_cast<const Beginning&>(*scene.recording).later(frames, {scene.frame.width, scene.frame.height});
}

std::vector<RecordedFrame> later_frames(const Scene& scene) {
    std::vector<RecordedFrame> frames;
    const auto* const shown = dynamic_cast<const Beginning*>(scene.recording.get());
    if (!shown) return frames;
    constexpr int kLast = 50;
    const WindowSize size{scene.frame.width, scene.frame.height};
    const int left = shown->frames_left(kLast);
    try {
        if (left > 0) frames.push_back(shown->later(1, size));
        if (left > 1) frames.push_back(shown->later(left, size));
    } catch (const SceneError&) {  // it draws nothing
    }
    return frames;
}

RecordedFrame frame_to_see(const std::shared_ptr<const Recording>& recording, const FrameChoice& choice,
                           const std::function<std::optional<float>(const Scene&)>& contrast) {
    constexpr float kLowContrast = 16 / 255.0F;
    constexpr int kTries = 10;
    RecordedFrame first = make_recorded_frame(recording, choice);
    if (choice.number) return first;
    const auto note = [&](std::string text) { first.notes.push_back(std::move(text)); };
    const std::optional<float> first_contrast = contrast(first.scene);
    if (!first_contrast || *first_contrast >= kLowContrast) return first;
    for (int i = 0, next = 1; i < kTries; ++i, next *= 2) {
        FrameChoice later = choice;
        later.number = first.number + next;
        try {
            RecordedFrame frame = make_recorded_frame(recording, later);
            if (contrast(frame.scene).value_or(0) < kLowContrast) continue;
            frame.notes.push_back(tr("frame {} is almost of one colour; this is frame {}", first.number, frame.number));
            return frame;
        } catch (const SceneError&) {  // it draws nothing, or there is no such frame
        }
    }
    note(tr(*first_contrast == 0 ? "the picture is of one colour; --frame chooses another frame"
                                 : "the picture is almost of one colour; --frame chooses another frame"));
    return first;
}

std::string note_of_errors(const RecordedFrame& recorded) {
    if (!recorded.first_error) return "";
    const GlError& first = *recorded.first_error;
    return tr("up to this frame, {} of the program's commands {} a GL error; the first: {}: {} ({})",
              recorded.error_count, tr(recorded.error_count == 1 ? "causes" : "cause"), one_line(first.place.str()),
              one_line(first.message), enum_name(first.code));
}

CommandList commands_to_print(const Scene& scene) {
    // C compilers fail on functions that are much larger.
    constexpr std::size_t kMost = 1'000'000;
    CommandList commands(scene.name(), {});
    commands.window = {scene.frame.width, scene.frame.height};
    // Loading has checked the memory.
    State state(
        {.width = scene.frame.width, .height = scene.frame.height, .memory = std::numeric_limits<std::size_t>::max()});
    scene.recording->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kFrameEnd) state.drop_picture();
        if (step.kind != Step::Kind::kCommand) return true;
        const std::size_t errors = state.error_count();
        state.apply(step.command);
        // Of the commands of a display list, only some may have errors.
        const bool calls = step.command.id == CommandId::glCallList || step.command.id == CommandId::glCallLists;
        if (state.error_count() == errors || calls) commands.commands.push_back(step.command);
        if (commands.commands.size() <= kMost) return true;
        throw SceneError(tr("{}: this frame needs more than {} commands, too many to print; choose an earlier --frame",
                            scene.name(), kMost));
    });
    return commands;
}

namespace {

// What the text lacks of the recording.
std::vector<std::string> notes_of(const RecordedFrame& recorded) {
    std::vector<std::string> notes = recorded.scene.recording->notes();
    notes.insert(notes.end(), recorded.notes.begin(), recorded.notes.end());
    if (recorded.first_error) notes.push_back(tr("{}; they are left out", note_of_errors(recorded)));
    for (const Unsupported& one : recorded.scene.frame.unsupported) {
        if (one.missing_from != MissingFrom::kEverything) continue;
        notes.push_back(tr("{} is left out, because Twinlight lacks it: {} {}, first at {}", one_line(one.name),
                           one.count, tr(one.count == 1 ? "call" : "calls"), one_line(one.first.str())));
    }
    return notes;
}

}  // namespace

std::string printed_frame(const RecordedFrame& recorded, std::string_view comment) {
    std::string text = fmt::format("// {}\n", comment);
    for (const std::string& note : notes_of(recorded)) text += tr("// Note: {}.\n", one_line(note));
    return text + print_scene(commands_to_print(recorded.scene));
}

}  // namespace twinlight
