#include "scene/trace/trace_calls.h"

#include "base/text/translation.h"
#include "scene/command/text.h"

namespace twinlight::trace {

bool TraceCalls::can_read(TraceFile file) {
    TraceReader reader(file, Blobs::kAreLeftOut);
    reader.next();
    return !reader.is_foreign();
}

const RecordedCall* TraceCalls::next() {
    call_ = reader_.next();
    if (!call_ && !is_cut_ && reader_.read_cut_chunk()) {
        is_cut_ = true;
        call_ = reader_.next();
    }
    if (!call_ && !reader_.failure().empty()) {
        cut_off_ = tr("{}; record it again", reader_.failure());
        if (reader_.calls() == 0) throw SceneError(name_ + ": " + cut_off_);
        return nullptr;
    }
    if (!call_) call_ = reader_.next_unfinished();
    if (!call_ && is_cut_) cut_off_ = tr("the recording ends inside call {}", reader_.calls());
    return call_;
}

}  // namespace twinlight::trace
