// Reads what `apitrace dump` prints, one call at a time: however long the dump is, the reader holds one call of it.
//
//     // process.name = "/usr/bin/glxgears"
//     3 glViewport(x = 0, y = 0, width = 300, height = 300) // fake
//     9 @0 glLightfv(light = GL_LIGHT0, pname = GL_POSITION, params = {5, 5, 10, 0})
//     14 glGenLists(range = 1) = 1
//     37 glVertexPointer(size = 3, type = GL_FLOAT, stride = 0, pointer = blob("blob_call37.bin")) // fake
//
// A "fake" call is one that the tracer put in (the window's first viewport, the memory of vertex arrays): it counts.
// The numbers count the calls of the program; the ones that apitrace leaves out are missing. An @ is a thread's number.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/command/command.h"
#include "scene/trace/arguments.h"
#include "scene/trace/blobs.h"
#include "scene/trace/dump_lexer.h"
#include "scene/trace/functions.h"

namespace twinlight::trace {

// A context is known by what the program's window system calls it.
using ContextName = double;

class DumpReader {
  public:
    // `name` is how places call the dump.
    DumpReader(ByteSource& source, const std::string& name, BlobFolder blobs);

    // Only what happens in this context is handed out; draws in others, and objects that others make, as outside. Without
    // it, all is of one context.
    void follow(ContextName context);

    // Hands the next steps to `visit`, until that answers false or the dump ends: then true. Throws SceneError.
    bool for_each(const std::function<bool(const Step&)>& visit);

    // The context of the first draw: for follow(). Reads up to there.
    std::optional<ContextName> first_to_draw();

  private:
    struct Mapping {
        double address = 0;
        double offset = 0;  // in the buffer object
        Enum target = 0;
    };

    bool next_call();  // its number, thread and name, and the opening parenthesis; false at the end
    void carry_out(const Function& function);
    void carry_out_command(const Function& function);
    // The arguments, the result and the rest of the line; false where the call was never finished.
    bool read_call();
    bool read_end_of_call();
    void make_current();
    void map_buffer();
    void copy_memory();
    void choose_context();  // whether what comes now is in the context that is followed
    void outside(std::string_view text) { step({Step::Kind::kOutside, command_, text}); }
    void step(const Step& step) { go_on_ = (*visit_)(step); }
    [[noreturn]] void fail_here(const std::string& message) const;  // with the line in the dump
    // Where the dump ends inside this line, whose end every whole one has, this tells it, and that is all there is to
    // read; otherwise it fails.
    bool cut_off_or(const std::string& message);

    DumpLexer lexer_;
    BlobFolder blobs_;
    FunctionTable functions_;
    Command command_;
    std::string function_name_;
    Arguments arguments_, result_;
    unsigned thread_ = 0;
    std::map<unsigned, ContextName> current_;  // of each thread that made one current
    std::optional<ContextName> followed_;
    bool in_followed_ = true;
    std::vector<Mapping> mappings_;
    std::optional<CommandId> buffer_sub_data_;
    const std::function<bool(const Step&)>* visit_ = nullptr;
    bool go_on_ = true;
};

}  // namespace twinlight::trace
