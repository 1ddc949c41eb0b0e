#include "judge/fuzz/fuzzer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "judge/fuzz/floats.h"
#include "judge/fuzz/pictures.h"
#include "judge/fuzz/random_states.h"
#include "judge/fuzz/shrink.h"
#include "render/context/driver_name.h"
#include "scene/command/text.h"

namespace twinlight::fuzz {

namespace {

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) { return Random(a * 0xD1342543DE82EF95ULL + b).next(); }

std::shared_ptr<const CommandList> shared(CommandList scene) {
    return std::make_shared<const CommandList>(std::move(scene));
}

}  // namespace

bool is_picture(std::uint64_t state) { return state % kPictureEvery == kPictureEvery - 1; }

CommandList random_scene(const Options& options, std::uint64_t state) {
    const bool picture = is_picture(state);
    const std::uint64_t pictures_before = state / kPictureEvery;
    const std::uint64_t structure =
        picture ? 2 * (pictures_before / kPicturesPerStructure) + 1 : 2 * (state / kStatesPerStructure);
    const Seed seed{mixed(options.seed, structure), mixed(~options.seed, state), options.lifted};
    CommandList scene = picture ? fragment_state(seed) : lighting_state(seed);
    // A known bug often needs the very commands that a rewrite would replace.
    Random random(mixed(options.seed + 1, state));
    if (options.lifted.empty() && random.chance(0.6)) scene = disguised(scene, random);
    scene.name = fmt::format("fuzz-{}-{}", options.seed, state);
    return scene;
}

std::string failure_text(const Failure& failure, const Options& options) {
    const std::string pair(failure.pair < kPairs ? kPairNames.at(failure.pair) : "the scene is rejected");
    std::string text = fmt::format("// twinlight fuzz --seed {} --first {} --count 1{}\n", options.seed, failure.state,
                                   options.lifted.empty() ? "" : fmt::format(" --lift '{}'", options.lifted));
    text +=
        fmt::format("// {}, {}: {}\n", pair, failure.is_picture ? "in a picture" : "in vertex colours", failure.what);
    text += fmt::format("// on {}\n", failure.driver);
    return text + print_scene(failure.scene);
}

bool Summary::too_many_differ(std::size_t pair) const {
    return static_cast<double>(differing_pixels[pair]) >
           compare::Tolerance{}.differing_share * static_cast<double>(pixels[pair]);
}

bool Summary::fails() const {
    // With few pictures, one whose colours round either way would count too much.
    constexpr std::uint64_t kEnoughPictures = 100;
    bool too_many = false;
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
        too_many = too_many || (picture_states >= kEnoughPictures && too_many_differ(pair));
    }
    return too_many || !failures.empty();
}

namespace {

// Whether a smaller scene fails in the same way. A difference of a very different size has another cause.
bool is_same(const PairDifferences& before, const PairDifferences& now) {
    constexpr double kAlike = 8;
    return now.fails && now.only_one_draws == before.only_one_draws && now.worst < kAlike * before.worst &&
           before.worst < kAlike * now.worst;
}

class Run {
  public:
    Run(const Options& options, const Progress& progress) : options_(options), progress_(progress) {
        if (!options.lifted.empty()) lifted_.push_back(options.lifted);
        // Every bitmap that shows the one may show the other.
        if (options.lifted == "a bitmap with a texture")
            lifted_.push_back("the texture coordinates of a raster position");
    }

    Summary run() {
        for (std::uint64_t done = 0; done < options_.count && !stops();) {
            const std::uint64_t begin = options_.first + done;
            if (done % kStatesPerContext < kStatesPerStructure) renew_contexts();
            // At most to the end of the scenes that share a structure.
            const std::uint64_t end =
                std::min(options_.first + options_.count, (begin / kStatesPerStructure + 1) * kStatesPerStructure);
            if (floats_) compare_floats(begin, end);
            for (std::uint64_t state = begin; pictures_ && state < end && !stops(); ++state) {
                if (!is_picture(state)) continue;
                compare_picture(state);
                show(state - options_.first);
            }
            done = end - options_.first;
            show(done);
        }
        summary_.broken_off = stops();
        return std::move(summary_);
    }

  private:
    // A context keeps all its programs, so it is replaced from time to time. In one with many, llvmpipe may crash: of 20 runs of 800
    // pictures 8 did with 128 pictures to a context.
    static constexpr std::uint64_t kStatesPerContext = kStatesPerStructure;
    void renew_contexts() {
        floats_.reset();
        pictures_.reset();
        if (options_.floats) floats_.emplace(lifted_);
        if (options_.pictures) pictures_.emplace(lifted_);
        summary_.driver = driver_name();
    }

    bool stops() const { return progress_.stop() || summary_.failures.size() >= options_.most_failures; }
    void show(std::uint64_t done, const char* doing = nullptr) {
        if (progress_.show) progress_.show(done, summary_, doing);
    }

    void compare_floats(std::uint64_t begin, std::uint64_t end) {
        std::vector<std::uint64_t> states;
        std::vector<std::shared_ptr<const CommandList>> scenes;
        for (std::uint64_t state = begin; state < end; ++state) {
            if (is_picture(state)) continue;
            states.push_back(state);
            scenes.push_back(shared(random_scene(options_, state)));
        }
        const std::vector<StateDifferences> found = floats_->compare(scenes);
        summary_.float_states += states.size();
        for (std::size_t i = 0; i < states.size() && !stops(); ++i) {
            count(found[i], states[i], summary_.vertices, summary_.worst_float, summary_.vertices_left_out);
            if (found[i].fails()) fail(states[i], scenes[i], found[i]);
        }
    }

    void compare_picture(std::uint64_t state) {
        const auto scene = shared(random_scene(options_, state));
        const StateDifferences found = pictures_->compare(scene);
        ++summary_.picture_states;
        count(found, state, summary_.pixels, summary_.worst_picture, summary_.pictures_left_out);
        for (std::size_t pair = 0; pair < kPairs; ++pair)
            summary_.differing_pixels[pair] += found.pairs[pair].differing;
        if (found.fails()) fail(state, scene, found);
    }

    static void count(const StateDifferences& found, std::uint64_t state, std::array<long, kPairs>& compared,
                      std::array<Worst, kPairs>& worst, LeftOutCounts& left_out) {
        for (std::size_t pair = 0; pair < kPairs; ++pair) {
            compared[pair] += found.pairs[pair].compared;
            if (found.pairs[pair].worst > worst[pair].value) worst[pair] = {found.pairs[pair].worst, state};
        }
        for (const auto& [departure, more] : found.left_out) {
            left_out[departure].cases += more.cases;
            left_out[departure].differing += more.differing;
        }
    }

    StateDifferences compare_one(bool picture, const std::shared_ptr<const CommandList>& scene) {
        return picture ? pictures_->compare(scene) : floats_->compare(std::span(&scene, 1)).front();
    }

    void fail(std::uint64_t state, const std::shared_ptr<const CommandList>& scene, const StateDifferences& found) {
        Failure failure;
        failure.state = state;
        failure.driver = summary_.driver;
        failure.is_picture = is_picture(state);
        failure.commands_before = scene->commands.size();
        if (!found.error.empty()) {
            failure.pair = kPairs;
            failure.what = found.error;
            failure.scene = *scene;
        } else {
            while (!found.pairs[failure.pair].fails) ++failure.pair;
            // A pair with the reference says more.
            if (found.pairs[1].fails && failure.pair == 0) failure.pair = 1;
            const PairDifferences& first = found.pairs[failure.pair];
            show(state - options_.first, "shrinking");
            failure.scene = !options_.shrinks_after(summary_.failures.size())
                                ? *scene
                                : shrink(*scene, [&](const CommandList& smaller) {
                                      const StateDifferences again = compare_one(failure.is_picture, shared(smaller));
                                      return again.error.empty() && is_same(first, again.pairs[failure.pair]);
                                  });
            const StateDifferences smallest = compare_one(failure.is_picture, shared(failure.scene));
            failure.what = smallest.pairs[failure.pair].what;
        }
        if (progress_.found) progress_.found(failure);
        summary_.failures.push_back(std::move(failure));
    }

    const Options& options_;
    const Progress& progress_;
    std::vector<std::string_view> lifted_;
    std::optional<Floats> floats_;
    std::optional<Pictures> pictures_;
    Summary summary_;
};

}  // namespace

Summary run(const Options& options, const Progress& progress) { return Run(options, progress).run(); }

}  // namespace twinlight::fuzz
