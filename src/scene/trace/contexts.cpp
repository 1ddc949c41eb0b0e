#include "scene/trace/contexts.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/text/translation.h"

namespace twinlight::trace {

namespace {

// A hostile dump may name any number.
constexpr std::size_t kMostLists = 1 << 20, kMostObjects = 1 << 16;
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

bool uses_program(std::string_view name) { return name.starts_with("glUseProgram"); }
bool binds_framebuffer(std::string_view name) { return name.starts_with("glBindFramebuffer"); }
bool is_binding(std::string_view name) { return uses_program(name) || binds_framebuffer(name); }
bool ends_picture(const Function& function, std::string_view name) {
    return function.role == Role::kFrameEnd || name == "glFlush" || name == "glFinish";
}
bool copies_framebuffer(std::string_view name) { return name.starts_with("glBlitFramebuffer"); }
// What decides which context draws most.
std::pair<double, double> drawn(const ContextUse& use) { return {use.vertices, use.by_shaders}; }
constexpr std::string_view kStorageWithSamples = "glRenderbufferStorageMultisample";

void end_picture(ContextUse& use) {
    if (use.drawn_into != 0 && use.ends_in.size() < kMostObjects) use.ends_in.insert(use.drawn_into);
    use.drawn_into = 0;
}

}  // namespace

bool ContextCounts::needs_arguments(const Function& function, std::string_view name) {
    return name == "glNewList" || name == "glCallList" || is_binding(name) || (function.draws && count_argument(name));
}

void ContextCounts::make_current(unsigned thread, ContextName context) {
    if (uses_.size() >= kMostThreads && !uses_.contains(thread)) return;
    const std::optional<std::size_t> before = uses_[thread].context;
    if (before && contexts_[*before].name != context) end_picture(contexts_[*before]);
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
    if (!use.executes) return;
    if (!use.context) {
        without_context_ += vertices;
        return;
    }
    ContextUse& context = contexts_[*use.context];
    (context.program == 0 ? context.vertices : context.by_shaders) += vertices;
    context.draws_to_window |= vertices > 0 && context.framebuffer == 0;
    context.draws_to_objects |= vertices > 0 && context.framebuffer != 0;
    if (vertices > 0) context.drawn_into = context.framebuffer;
}

void ContextCounts::count(unsigned thread, const Function& function, std::string_view name,
                          std::span<const double> numbers) {
    const bool is_list = name == "glNewList" || name == "glEndList", binds_buffer = name.starts_with("glBindBuffer");
    const bool has_samples = name.starts_with(kStorageWithSamples), ends = ends_picture(function, name);
    const bool is_state = binds_buffer || has_samples || ends || is_binding(name);
    if (!is_list && !is_state && !function.draws && !function.is_vertex) return;
    if (uses_.size() >= kMostThreads && !uses_.contains(thread)) return;
    Use& use = uses_[thread];
    if (use.context) {
        ContextUse& context = contexts_[*use.context];
        context.has_buffers |= binds_buffer;
        context.has_samples |= has_samples;
        context.has_elements |= name == "glArrayElement";
        if (ends) end_picture(context);
        if (uses_program(name)) context.program = number(numbers, 0).value_or(0);
        if (binds_framebuffer(name) && number(numbers, 0) != kGL_READ_FRAMEBUFFER)
            context.framebuffer = number(numbers, 1).value_or(0);
    }
    if (is_state || copies_framebuffer(name)) return;
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
    for (const ContextUse& use : contexts_) sum += use.vertices + use.by_shaders;
    return sum;
}

std::optional<std::size_t> ContextCounts::busiest() const {
    const auto most = std::ranges::max_element(contexts_, {}, drawn);
    if (most == contexts_.end() || drawn(*most) == drawn({}) || most->vertices < without_context_) return std::nullopt;
    return static_cast<std::size_t>(most - contexts_.begin());
}

bool ContextCounts::busiest_draws_into_objects() const {
    const std::optional<std::size_t> most = busiest();
    return most && !contexts_[*most].draws_to_window;
}

std::optional<SharedObject> SharedObjects::named_by(std::string_view function, std::span<const double> numbers) {
    using enum SharedObject::Kind;
    const bool is_list = function.ends_with("List");
    const std::optional<double> name = number(numbers, is_list ? 0 : 1);
    if (!name || !(*name >= 0 && *name <= std::numeric_limits<std::uint32_t>::max())) return std::nullopt;
    return SharedObject{is_list                           ? kList
                        : function.starts_with("glBindT") ? kTexture
                                                          : kBuffer,
                        static_cast<std::uint32_t>(*name)};
}

bool SharedObjects::makes(ContextName context, const Function& function, std::string_view name,
                          std::span<const double> numbers) {
    if (name == "glCallLists") return false;
    made_ = function.names_shared ? named_by(name, numbers) : std::nullopt;
    if (made_ && name != "glNewList") {
        if (bound_.size() < kMostObjects) bound_[{context, made_->kind}] = made_->name;
        return false;
    }
    if (!function.makes_objects) return false;
    if (made_) return true;
    const auto kind = name.starts_with("glBuffer") ? SharedObject::Kind::kBuffer : SharedObject::Kind::kTexture;
    const auto bound = bound_.find({context, kind});
    if (bound != bound_.end()) made_ = SharedObject{kind, bound->second};
    return true;
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
        if (drawn(contexts[i]) != drawn({})) order.push_back(i);
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return drawn(contexts[i]); });
    std::string text;
    for (std::size_t i = 0; i < std::min(order.size(), kMostShown); ++i) {
        const ContextUse& use = contexts[order[i]];
        const double count = use.vertices > 0 ? use.vertices : use.by_shaders;
        if (i > 0) text += tr(", ");
        text += tr("context {} draws {} {}", order[i], count, tr(count == 1 ? "vertex" : "vertices"));
        if (use.vertices == 0) text += tr(" with shaders");
    }
    if (order.size() > kMostShown) text += tr(", and {} others draw less", order.size() - kMostShown);
    return text;
}

}  // namespace twinlight::trace
