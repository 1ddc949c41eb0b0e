#include "scene/record/trace_follower.h"

#include <fcntl.h>

namespace twinlight::trace {

void TraceFollower::read_on(int most_chunks) {
    if (!descriptor_.valid()) descriptor_ = Descriptor(::open(file_.c_str(), O_RDONLY | O_CLOEXEC));
    if (!descriptor_.valid()) return;
    if (!reader_) reader_.emplace(chunks_.emplace(descriptor_.get()), Blobs::kAreLeftOut);
    const std::size_t before = chunks_->chunks();
    while (chunks_->chunks() - before < static_cast<std::size_t>(most_chunks)) {
        const TraceReader::Call* const call = reader_->next();
        if (!call) return;
        const Function& function = *call->function;
        if (function.role == Role::kFrameEnd) frame_ends_.push_back(reader_->position());
        if (call->name == "glNewList" || call->name == "glEndList") in_list_ = call->name == "glNewList";
        if ((function.draws || function.is_vertex) && !in_list_ && !has_drawn()) first_drawn_ = frames();
    }
}

void TraceFollower::copy_frames(int count, const std::string& to) const {
    const bool has_more = count < frames() && failure().empty();
    chunks_->copy(to, has_more ? std::optional(frame_ends_[static_cast<std::size_t>(count) - 1]) : std::nullopt);
}

}  // namespace twinlight::trace
