// The calls of a .trace that was recorded by a version of apitrace from 5 to 13.
#pragma once

#include <string>

#include "scene/trace/trace_reader.h"

namespace twinlight::trace {

class TraceCalls final : public CallSource {
  public:
    // `name` is the name of the file in errors.
    TraceCalls(TraceFile file, std::string name, Blobs blobs)
        : name_(std::move(name)), file_(std::move(file)), reader_(file_, blobs) {}

    // Whether this can read the file, though it may be damaged. Otherwise `apitrace dump` may.
    static bool can_read(TraceFile file);

    const RecordedCall* next() override;
    bool read() override { return call_->arguments.are_complete(); }
    void read_stack() override {}
    std::string mark() override { return call_->text; }
    std::vector<CallFrame> frames(std::string_view stack) const override { return reader_.frames(stack); }
    bool at_end() override { return !next(); }
    const std::string& cut_off() const override { return cut_off_; }

  private:
    std::string name_, cut_off_;
    TraceFile file_;
    TraceReader reader_;
    const TraceReader::Call* call_ = nullptr;
    bool is_cut_ = false;
};

}  // namespace twinlight::trace
