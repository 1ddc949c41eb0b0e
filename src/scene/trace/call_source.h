// The calls of a recording, one after the other in the order in which they returned: of the text of a dump (dump_calls.h) or of
// a .trace (trace_calls.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/trace/arguments.h"
#include "scene/trace/call_stacks.h"
#include "scene/trace/functions.h"

namespace twinlight::trace {

struct RecordedCall {
    int number = -1;  // among all calls of the program
    unsigned thread = 0;
    std::string_view name;
    const Function* function = nullptr;
    // These are known after CallSource::read().
    Arguments arguments, result;
    bool is_fake = false;  // inserted by the tracer
    bool has_stack = false;
    std::string stack{};  // for CallSource::frames(): the same for the same stack
};

class CallSource {
  public:
    virtual ~CallSource() = default;

    // The next call, valid until the one after it; null at the end. Throws SceneError.
    virtual const RecordedCall* next() = 0;
    // Reads the call's arguments, result and stack, once. Returns false if it was never finished. Throws SceneError.
    virtual bool read() = 0;
    // Reads only its stack.
    virtual void read_stack() = 0;
    // The text of a mark (Function::is_mark).
    virtual std::string mark() = 0;
    virtual std::vector<CallFrame> frames(std::string_view stack) const = 0;
    // Whether that was the last call. Ask it last: it may go on.
    virtual bool at_end() = 0;
    // At the end: why it is not the end of the recording, or "".
    virtual const std::string& cut_off() const = 0;
};

}  // namespace twinlight::trace
