// Reads the output of `apitrace dump` one call at a time, so the dump may be of any length.
//
//     // process.name = "/usr/bin/glxgears"
//     3 glViewport(x = 0, y = 0, width = 300, height = 300) // fake
//     9 @0 glLightfv(light = GL_LIGHT0, pname = GL_POSITION, params = {5, 5, 10, 0})
//     14 glGenLists(range = 1) = 1
//     37 glVertexPointer(size = 3, type = GL_FLOAT, stride = 0, pointer = blob("blob_call37.bin")) // fake
//
// The tracer inserts "fake" calls (the first viewport of a window, the memory of vertex arrays). They are executed like
// others. The first number counts the program's calls, including those that apitrace leaves out. @ marks the number of
// a thread. The call stack of a call may follow it (call_stacks.h).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/command/command.h"
#include "scene/trace/arguments.h"
#include "scene/trace/blobs.h"
#include "scene/trace/call_stacks.h"
#include "scene/trace/contexts.h"
#include "scene/trace/dump_lexer.h"
#include "scene/trace/framebuffers.h"
#include "scene/trace/functions.h"
#include "scene/trace/window_formats.h"

namespace twinlight::trace {

class DumpReader {
  public:
    // `name` is the name of the dump in places.
    DumpReader(ByteSource& source, const std::string& name, BlobLoader blobs);

    // Reports only the commands of this context. Objects that another context creates and shares with it are reported as
    // kOutside if it uses them. Without this call all commands count as one context. `shown_objects`: framebuffer objects that are
    // read as the window.
    void follow(ContextName context, std::set<double> shown_objects);

    // Calls `visit` for the next steps until it returns false. Returns true if the dump ended. Throws SceneError.
    bool for_each(const std::function<bool(const Step&)>& visit);

    // Reads what the contexts draw: the first frames that draw, or with `whole` the whole dump.
    void count_contexts(bool whole, ContextCounts& counts);
    // Whether a context that count_contexts() has seen draws into a window with several samples per pixel.
    bool has_samples(ContextName context) const { return formats_.has_samples(context); }
    bool at_end() { return lexer_.at_end(); }
    // The number of the last call that was read.
    int call_number() const { return call_; }

  private:
    struct Mapping {
        double address = 0;
        double offset = 0;  // in the buffer object
        Enum target = 0;
    };

    bool next_call();  // reads number, thread, name and the opening parenthesis; false at the end
    void skip_call();
    void read_stack();
    void skip_stack();
    void read_mark();  // of a line of Python
    void carry_out(const Function& function);
    void carry_out_command(const Function& function);
    // Reads the arguments, the result and the rest of the line. Returns false if the call was never finished.
    bool read_call();
    bool read_end_of_call();
    void make_current();
    void create_context();
    void note_format();
    void storage_with_samples();
    void blit();
    // Whether the command only sets the state of a texture unit that the fixed function lacks.
    bool is_of_units_for_shaders();
    void end_frame();
    void map_buffer();
    void copy_memory();
    void choose_context();  // updates whether the current thread uses the followed context
    void outside(std::string_view text) { step({Step::Kind::kOutside, command_, text}); }
    void step(const Step& step);
    void visit_waiting(const Place& place);
    [[noreturn]] void fail_here(const std::string& message) const;  // with the line in the dump
    // If the dump ends inside this line, reports kCutOff and returns false. Otherwise fails with the message. A
    // complete line has a line end.
    bool cut_off_or(const std::string& message);

    DumpLexer lexer_;
    BlobLoader blobs_;
    FunctionTable functions_;
    Command command_;
    int call_ = -1;  // its number
    bool has_call_numbers_ = false, has_stacks_ = false;
    bool is_fake_ = false;                     // the call was inserted by the tracer
    std::vector<Command> waiting_;             // inserted by the tracer, before the call whose place they get
    std::shared_ptr<const std::string> name_;  // of the dump
    CallStacks stacks_;
    Place place_before_{};  // of the last call with a stack
    std::string stack_, function_name_;
    std::map<unsigned, std::string> marks_;  // the call stack in Python of each thread
    Arguments arguments_, result_;
    unsigned thread_ = 0;
    std::map<unsigned, ContextName> current_;  // the current context of each thread
    std::vector<ContextName> contexts_;        // in the order in which they became current
    ShareGroups groups_;
    SharedObjects shared_;
    Framebuffers framebuffers_;
    bool has_drawn_ = false;            // the followed context, since the frame began
    bool is_unit_for_shaders_ = false;  // glActiveTexture has chosen one
    WindowFormats formats_;
    std::optional<ContextName> followed_;
    bool in_followed_ = true;
    std::vector<Mapping> mappings_;
    const std::function<bool(const Step&)>* visit_ = nullptr;
    bool go_on_ = true;
};

}  // namespace twinlight::trace
