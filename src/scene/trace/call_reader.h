// Makes the steps of a Recording from the calls of a program.
//
// The tracer inserts "fake" calls (the first viewport of a window, the memory of vertex arrays). They are executed like others.
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
#include "scene/trace/call_source.h"
#include "scene/trace/call_stacks.h"
#include "scene/trace/contexts.h"
#include "scene/trace/framebuffers.h"
#include "scene/trace/functions.h"
#include "scene/trace/window_formats.h"

namespace twinlight::trace {

class CallReader {
  public:
    // `name` is the name of the recording in places.
    CallReader(CallSource& source, const std::string& name, BlobLoader blobs);

    // Reports only the commands of this context. Objects that another context makes and shares with it are reported as
    // kElsewhere. Without this call all commands count as one context. `shown_objects`: framebuffer objects that are
    // read as the window.
    void follow(ContextName context, std::set<double> shown_objects);

    // Calls `visit` for the next steps until it returns false. Returns true if the recording ended. Throws SceneError.
    bool for_each(const std::function<bool(const Step&)>& visit);

    // Reads what the contexts draw: the first frames that draw, or with `whole` the whole recording.
    void count_contexts(bool whole, ContextCounts& counts);
    // Whether a context that count_contexts() has seen draws into a window with several samples per pixel.
    bool has_samples(ContextName context) const { return formats_.has_samples(context); }
    // Whether that was all. Ask it last.
    bool at_end() { return source_.at_end(); }
    // The number of the last call that was read.
    int call_number() const { return number_; }

  private:
    struct Mapping {
        double address = 0;
        double offset = 0;  // in the buffer object
        Enum target = 0;
    };

    bool next_call();
    void read_mark();  // of a line of Python
    void carry_out(const Function& function);
    void carry_out_command(const Function& function);
    bool read_call();   // and its place; false if the call was never finished
    void find_place();  // of a call whose stack is read
    void make_current();
    void create_context();
    void note_format();
    void storage_with_samples();
    void offset_by_depth();
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

    CallSource& source_;
    const RecordedCall* call_ = nullptr;
    BlobLoader blobs_;
    Command command_;
    int number_ = -1;  // of the last call
    bool has_stacks_ = false;
    std::vector<Command> waiting_;             // inserted by the tracer, before the call whose place they get
    std::shared_ptr<const std::string> name_;  // of the recording
    CallStacks stacks_;
    Place place_before_{};                   // of the last call with a stack
    std::map<unsigned, std::string> marks_;  // the call stack in Python of each thread
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
