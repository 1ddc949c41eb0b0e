#include "scene/trace/contexts.h"

#include <fmt/format.h>

#include <algorithm>

namespace twinlight::trace {

namespace {

constexpr std::size_t kMostLists = 1 << 20;
constexpr std::size_t kMostShown = 8;

// The argument with the number of vertices.
std::optional<std::size_t> count_argument(std::string_view name) {
    if (name == "glDrawArrays") return 2;
    if (name == "glDrawElements") return 1;
    if (name == "glDrawRangeElements") return 3;
    return std::nullopt;
}

std::optional<double> number(std::span<const double> numbers, std::size_t i) {
    return i < numbers.size() ? std::optional(numbers[i]) : std::nullopt;
}

}  // namespace

bool ContextCounts::needs_arguments(const Function& function, std::string_view name) {
    return name == "glNewList" || name == "glCallList" || (function.draws && count_argument(name));
}

void ContextCounts::make_current(unsigned thread, ContextName context) {
    if (uses_.size() >= kMostThreads && !uses_.contains(thread)) return;
    Use& use = uses_[thread] = {};
    if (context == 0) return;
    const auto found = std::ranges::find(contexts_, context, &ContextUse::name);
    if (found == contexts_.end() && contexts_.size() >= kMostContexts) return;
    use.context = static_cast<std::size_t>(found - contexts_.begin());
    if (found == contexts_.end()) contexts_.push_back({context});
}

void ContextCounts::add(Use& use, double vertices) {
    if (use.list) {
        if (list_vertices_.size() < kMostLists || list_vertices_.contains(*use.list))
            list_vertices_[*use.list] += vertices;
    }
    if (use.executes) (use.context ? contexts_[*use.context].vertices : without_context_) += vertices;
}

void ContextCounts::count(unsigned thread, const Function& function, std::string_view name,
                          std::span<const double> numbers) {
    const bool is_list = name == "glNewList" || name == "glEndList", binds_buffer = name.starts_with("glBindBuffer");
    if (!is_list && !binds_buffer && !function.draws && !function.is_vertex) return;
    if (uses_.size() >= kMostThreads && !uses_.contains(thread)) return;
    Use& use = uses_[thread];
    if (use.context) {
        contexts_[*use.context].has_buffers |= binds_buffer;
        contexts_[*use.context].has_elements |= name == "glArrayElement";
    }
    if (binds_buffer) return;
    if (name == "glNewList") {
        use.list = number(numbers, 0).value_or(0);
        use.executes = number(numbers, 1) == kGL_COMPILE_AND_EXECUTE;
        list_vertices_.erase(*use.list);
    } else if (name == "glEndList") {
        use.list.reset();
        use.executes = true;
    } else if (function.is_vertex) {
        add(use, 1);
    } else if (name == "glCallList") {
        const auto list = list_vertices_.find(number(numbers, 0).value_or(0));
        if (list != list_vertices_.end()) add(use, list->second);
    } else if (const auto i = count_argument(name)) {
        add(use, std::max(0.0, number(numbers, *i).value_or(1)));
    } else if (name != "glBegin") {
        add(use, 1);
    }
}

double ContextCounts::all() const {
    double sum = without_context_;
    for (const ContextUse& use : contexts_) sum += use.vertices;
    return sum;
}

std::optional<std::size_t> ContextCounts::busiest() const {
    const auto most = std::ranges::max_element(contexts_, {}, &ContextUse::vertices);
    if (most == contexts_.end() || most->vertices == 0 || most->vertices < without_context_) return std::nullopt;
    return static_cast<std::size_t>(most - contexts_.begin());
}

void ShareGroups::create(ContextName context, ContextName share) {
    if (context == 0 || (group_of_.size() >= kMostContexts && !group_of_.contains(context))) return;
    const auto shared = group_of_.find(share);
    if (share != 0 && shared == group_of_.end())
        group_of_.erase(context);  // its group is unknown
    else
        group_of_[context] = share == 0 ? context : ContextName{shared->second};
}

bool ShareGroups::may_share(ContextName a, ContextName b) const {
    const auto of_a = group_of_.find(a), of_b = group_of_.find(b);
    return of_a == group_of_.end() || of_b == group_of_.end() || of_a->second == of_b->second;
}

std::string list_of_contexts(const std::vector<ContextUse>& contexts) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < contexts.size(); ++i)
        if (contexts[i].vertices > 0) order.push_back(i);
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return contexts[i].vertices; });
    std::string text;
    for (std::size_t i = 0; i < std::min(order.size(), kMostShown); ++i)
        text += fmt::format("{}context {} draws {} vert{}", i > 0 ? ", " : "", order[i], contexts[order[i]].vertices,
                            contexts[order[i]].vertices == 1 ? "ex" : "ices");
    if (order.size() > kMostShown) text += fmt::format(", and {} others draw less", order.size() - kMostShown);
    return text;
}

}  // namespace twinlight::trace
