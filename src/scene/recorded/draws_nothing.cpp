#include "scene/recorded/draws_nothing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/text/translation.h"

namespace twinlight {

namespace {

constexpr std::size_t kMostNames = 256;  // a hostile dump may contain any number

bool starts_with_one_of(std::string_view name, std::initializer_list<std::string_view> starts) {
    return std::ranges::any_of(starts, [name](std::string_view start) { return name.starts_with(start); });
}

bool draws(std::string_view name) {
    if (name.starts_with("glDrawBuffer")) return false;
    return starts_with_one_of(name, {"glBegin", "glDraw", "glMultiDraw", "glRect", "glCallList", "glBitmap",
                                     "glCopyPixels", "glEvalMesh", "glEvalPoint"});
}

bool is_of_shaders(std::string_view name) {
    return starts_with_one_of(name, {"glUseProgram", "glVertexAttrib", "glBindProgram", "glEnableVertexAttrib",
                                     "glDisableVertexAttrib", "glBindAttrib"});
}

void count(std::map<std::string, std::size_t, std::less<>>& names, std::string_view name) {
    if (const auto found = names.find(name); found != names.end())
        ++found->second;
    else if (names.size() < kMostNames)
        names.emplace(name, 1);
}

std::string times(std::size_t count) { return count == 1 ? tr("once") : tr("{} times", count); }

// "glBegin (3 times), glCallList (once)": the most frequent three.
template <class Names>
std::string list_of(const Names& names) {
    std::vector<std::pair<std::string_view, std::size_t>> most(names.begin(), names.end());
    std::ranges::stable_sort(most, std::greater(), &std::pair<std::string_view, std::size_t>::second);
    constexpr std::size_t kMostShown = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(most.size(), kMostShown); ++i)
        text += fmt::format("{}{} ({})", i > 0 ? tr(", ") : "", most[i].first, times(most[i].second));
    if (most.size() > kMostShown) text += tr(" and {} others", most.size() - kMostShown);
    return text;
}

template <class Names, class Belongs>
Names part_of(const Names& names, const Belongs& belongs) {
    Names part;
    for (const auto& [name, times] : names)
        if (belongs(name)) part.emplace(name, times);
    return part;
}

}  // namespace

void DrawsNothing::take(const Step& step) {
    if (step.kind == Step::Kind::kOutside) return count(outside_, step.text);
    if (step.kind != Step::Kind::kCommand) return;
    ++commands_;
    if (step.command.id == CommandId::glEndList) in_list_ = false;
    if (step.command.id == CommandId::glNewList) in_list_ = true;
    const std::string_view name = step.command.name();
    if (!draws(name)) return;
    if (in_list_)
        ++drawing_in_lists_;
    else
        count(drawing_, name);
}

std::string DrawsNothing::why(int frames, std::size_t errors) const {
    std::vector<std::string> causes;
    const auto shaders = part_of(outside_, is_of_shaders);
    const auto others = part_of(outside_, [](std::string_view name) { return !is_of_shaders(name); });
    if (!shaders.empty()) causes.push_back(tr("it draws with shaders: {}", list_of(shaders)));
    if (!others.empty()) causes.push_back(tr("it calls functions that Twinlight lacks: {}", list_of(others)));
    if (!drawing_.empty() && shaders.empty()) causes.push_back(tr("{}: no vertex that shows", list_of(drawing_)));
    if (drawing_in_lists_ > 0 && drawing_.empty())
        causes.push_back(
            tr("it draws only inside display lists that it never calls ({} in lists)", times(drawing_in_lists_)));
    if (errors > 0) causes.push_back(tr("{} of its commands cause GL errors", errors));
    if (drawing_.empty() && drawing_in_lists_ == 0) {
        causes.push_back(commands_ == 0 ? tr("it has no GL command")
                                        : tr("none of its {} {} draws: perhaps it ended or was cut before that",
                                             commands_, tr(commands_ == 1 ? "command" : "commands")));
    }
    std::string text = fmt::format("{} {}", frames, tr(frames == 1 ? "frame" : "frames"));
    for (const std::string& cause : causes) text += tr("; ") + cause;
    return text;
}

}  // namespace twinlight
