// The calls in the output of `apitrace dump`, which may be of any length.
//
//     // process.name = "/usr/bin/glxgears"
//     3 glViewport(x = 0, y = 0, width = 300, height = 300) // fake
//     9 @0 glLightfv(light = GL_LIGHT0, pname = GL_POSITION, params = {5, 5, 10, 0})
//     14 glGenLists(range = 1) = 1
//     37 glVertexPointer(size = 3, type = GL_FLOAT, stride = 0, pointer = blob("blob_call37.bin")) // fake
//
// The first number counts the program's calls, including those that apitrace leaves out. @ marks the number of a thread. The call
// stack of a call may follow it (call_stacks.h).
#pragma once

#include <memory>
#include <string>

#include "scene/trace/call_source.h"
#include "scene/trace/dump_lexer.h"

namespace twinlight::trace {

class DumpCalls final : public CallSource {
  public:
    // `name` is the name of the dump in errors.
    DumpCalls(std::unique_ptr<ByteSource> source, std::string name);

    const RecordedCall* next() override;
    bool read() override;
    void read_stack() override;
    std::string mark() override;
    std::vector<CallFrame> frames(std::string_view stack) const override { return frames_of(stack); }
    bool at_end() override;
    const std::string& cut_off() const override { return cut_off_; }

  private:
    void skip_rest();  // of the line
    bool read_end_of_call();
    void skip_stack();
    [[noreturn]] void fail_here(const std::string& message) const;  // with the line in the dump
    // If the dump ends inside this line, notes that and returns false. Otherwise fails with the message. A complete line has a line
    // end.
    bool cut_off_or(const std::string& message);

    std::unique_ptr<ByteSource> source_;
    std::string name_, cut_off_, function_name_;
    DumpLexer lexer_;
    FunctionTable functions_;
    RecordedCall call_;
    bool is_inside_ = false;  // a part of the call's line is not read yet
    bool has_call_numbers_ = false;
};

}  // namespace twinlight::trace
