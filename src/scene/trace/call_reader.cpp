#include "scene/trace/call_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "base/text/translation.h"
#include "scene/command/lexer.h"
#include "scene/command/text.h"
#include "scene/trace/convert.h"

namespace twinlight::trace {

namespace {

using Form = Argument::Form;

constexpr std::size_t kMostMappings = 1024, kMostWaiting = 256;
// Enough to see which context draws most.
constexpr int kMostCallsCounted = 300'000, kMostFramesCounted = 8;

// With an enumerant that GL 2.1 lacks, these change no pixel: an unknown capability is already off, GL refuses any other shade model, and
// messages are for debuggers.
bool is_harmless_with_unknown_name(std::string_view function, std::string_view unknown_name) {
    return function == "glDisable" || function == "glDisableClientState" || function == "glHint" ||
           function == "glShadeModel" || (function == "glEnable" && unknown_name.starts_with("GL_DEBUG_OUTPUT"));
}

// EXT_vertex_array: arrays are enabled by glEnable, as drivers still allow. Returns the command of GL 2.1.
CommandId client_state(const Command& command) {
    const bool enables = command.id == CommandId::glEnable;
    if (!enables && command.id != CommandId::glDisable) return command.id;
    const Enum cap = command.enumerant(0);
    if (cap < kGL_VERTEX_ARRAY || cap > kGL_EDGE_FLAG_ARRAY) return command.id;
    return enables ? CommandId::glEnableClientState : CommandId::glDisableClientState;
}

}  // namespace

CallReader::CallReader(CallSource& source, const std::string& name, BlobLoader blobs)
    : source_(source), blobs_(std::move(blobs)), name_(std::make_shared<const std::string>(name)) {}

void CallReader::follow(ContextName context, std::set<double> shown_objects) {
    followed_ = context;
    framebuffers_.show(std::move(shown_objects));
    choose_context();
}

void CallReader::choose_context() {
    const auto current = current_.find(thread_);
    in_followed_ = !followed_ || (current != current_.end() && current->second == *followed_);
}

bool CallReader::for_each(const std::function<bool(const Step&)>& visit) {
    visit_ = &visit;
    go_on_ = true;
    while (go_on_ && next_call()) carry_out(*call_->function);
    if (go_on_ && !source_.cut_off().empty()) step({Step::Kind::kCutOff, command_, source_.cut_off()});
    visit_waiting({});
    return go_on_;
}

void CallReader::visit_waiting(const Place& place) {
    for (Command& command : waiting_) {
        if (place.calls) command.place = place;
        if (go_on_) go_on_ = (*visit_)({.command = command});
    }
    waiting_.clear();
}

void CallReader::step(const Step& step) {
    visit_waiting(step.command.place);
    if (go_on_) go_on_ = (*visit_)(step);
}

void CallReader::count_contexts(bool whole, ContextCounts& counts) {
    static const std::function<bool(const Step&)> kNothing = [](const Step&) { return true; };
    visit_ = &kNothing;
    int calls = 0, frames = 0;  // since the first that draws
    const auto goes_on = [&] {
        return calls < kMostCallsCounted && (frames < kMostFramesCounted || counts.busiest_draws_into_objects());
    };
    while ((whole || goes_on()) && next_call()) {
        const Function& function = *call_->function;
        if (function.role == Role::kMakeCurrent) {
            make_current();
            const auto current = current_.find(thread_);
            counts.make_current(thread_, current == current_.end() ? 0 : current->second);
            continue;
        }
        if (function.names_format) {
            note_format();
            continue;
        }
        if (ContextCounts::needs_arguments(function, call_->name) && !read_call()) continue;
        counts.count(thread_, function, call_->name, call_->arguments.numbers);
        if (counts.any_draws()) ++calls;
        if (calls > 0 && function.role == Role::kFrameEnd) ++frames;
    }
}

bool CallReader::next_call() {
    call_ = source_.next();
    if (!call_) return false;
    number_ = call_->number;
    command_.place = {name_, number_, Place::kCallNumber};
    if (call_->thread != thread_) {
        thread_ = call_->thread;
        choose_context();
    }
    return true;
}

bool CallReader::read_call() {
    const bool is_complete = source_.read();
    if (source_.cut_off().empty()) find_place();
    return is_complete;
}

// A call inside glBegin may be recorded without a stack (record.cpp), and has the place of the call before it.
void CallReader::find_place() {
    has_stacks_ |= call_->has_stack;
    if (!has_stacks_ || call_->is_fake) return;
    const auto mark = marks_.find(thread_);
    if (!call_->has_stack && mark == marks_.end()) {
        if (place_before_.calls) command_.place = place_before_;
        return;
    }
    const Place& place = mark != marks_.end()
                             ? stacks_.place(mark->second, call_->name)
                             : stacks_.place(call_->stack, call_->name,
                                             [this](std::string_view stack) { return source_.frames(stack); });
    if (place.file) command_.place = place;
    place_before_ = command_.place;
}

// glStringMarkerGREMEDY(len = 29, string = "python: display: lamp.py:12"): the stack of the calls that follow (python_lines.py).
void CallReader::read_mark() {
    std::string text = source_.mark();
    if (text.starts_with("python: ") && (marks_.size() < kMostThreads || marks_.contains(thread_)))
        marks_[thread_] = std::move(text);
}

void CallReader::carry_out(const Function& function) {
    switch (function.role) {
        case Role::kMakeCurrent: return make_current();
        case Role::kIgnored:
            if (function.makes_context) return create_context();
            if (function.is_mark) read_mark();
            return;
        case Role::kFrameEnd:
            if (in_followed_) end_frame();
            return;
        default: break;
    }
    if (!in_followed_) {
        if (function.names_shared && !read_call()) return;
        const auto current = current_.find(thread_);
        if (current == current_.end() || !groups_.may_share(current->second, *followed_)) return;
        if (!shared_.makes(current->second, function, call_->name, call_->arguments.numbers)) return;
        const auto number = std::ranges::find(contexts_, current->second) - contexts_.begin();
        const std::string text = tr("{} in context {}", call_->name, number);
        if (const auto& object = shared_.made()) return step({Step::Kind::kElsewhere, command_, text, *object});
        return outside(text);
    }
    has_drawn_ |= function.draws || function.is_vertex;
    switch (function.role) {
        case Role::kCommand: return carry_out_command(function);
        case Role::kMapBuffer: return map_buffer();
        case Role::kCopy: return copy_memory();
        case Role::kBlit: return blit();
        case Role::kBinding: {
            if (!read_call()) return;
            const bool of_gl = !call_->arguments.numbers.empty() && call_->arguments.numbers.back() == 0;
            if (!of_gl) outside(call_->name);
            return;
        }
        case Role::kStorage: return storage_with_samples();
        case Role::kDepthOffset: return offset_by_depth();
        default:
            source_.read_stack();
            find_place();
            return outside(call_->name);
    }
}

void CallReader::carry_out_command(const Function& function) {
    if (!read_call()) return;
    if (function.sets_units && is_of_units_for_shaders()) return;
    if (!call_->arguments.unknown_name.empty()) {
        if (is_harmless_with_unknown_name(call_->name, call_->arguments.unknown_name)) return;
        return outside(fmt::format("{}({})", call_->name, call_->arguments.unknown_name));
    }
    command_.id = function.command;
    convert(call_->arguments, call_->result, blobs_, command_);
    command_.id = client_state(command_);
    if (!framebuffers_.follow(command_)) return;
    // A glVertexPointer whose arrays are recorded when the program draws.
    if (call_->is_fake && has_stacks_ && waiting_.size() < kMostWaiting)
        waiting_.push_back(command_);
    else
        step({Step::Kind::kCommand, command_});
}

// Shaders have more texture units than the fixed function, and some programs reset them all. A dump may call such a unit by another
// name of the same number: GL_TEXTURE0 + 34 is GL_MAX_TEXTURE_UNITS.
bool CallReader::is_of_units_for_shaders() {
    constexpr double kMostUnits = 192;  // GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS of llvmpipe
    if (call_->name.starts_with("glActiveTexture")) {
        const double unit = call_->arguments.numbers.empty() ? 0 : call_->arguments.numbers[0] - kGL_TEXTURE0;
        const bool is_unit = unit >= 0 && unit < kMostUnits;
        is_unit_for_shaders_ =
            !call_->arguments.unknown_name.empty() || (is_unit && !find_gl_name(fmt::format("GL_TEXTURE{:.0f}", unit)));
        return is_unit_for_shaders_;
    }
    if (!is_unit_for_shaders_) return false;
    constexpr std::array kEnabled = {kGL_TEXTURE_1D,    kGL_TEXTURE_2D,    kGL_TEXTURE_3D,    kGL_TEXTURE_CUBE_MAP,
                                     kGL_TEXTURE_GEN_S, kGL_TEXTURE_GEN_T, kGL_TEXTURE_GEN_R, kGL_TEXTURE_GEN_Q};
    const bool enables = call_->name == "glEnable" || call_->name == "glDisable";
    return !enables ||
           (!call_->arguments.numbers.empty() && std::ranges::count(kEnabled, call_->arguments.numbers[0]) > 0);
}

void CallReader::end_frame() {
    step({Step::Kind::kFrameEnd, command_});
    has_drawn_ = false;
}

// glRenderbufferStorageMultisample: read as with one sample per pixel.
void CallReader::storage_with_samples() {
    if (!read_call() || call_->arguments.numbers.size() != 5) return outside(call_->name);
    const std::vector<double>& given = call_->arguments.numbers;
    const Command storage{.id = CommandId::glRenderbufferStorage,
                          .arguments = {given[0], given[2], given[3], given[4]},
                          .place = command_.place};
    step({Step::Kind::kCommand, storage});
}

// EXT_polygon_offset: its bias is a depth, which glPolygonOffset counts in the steps of a depth buffer of 24 bits.
void CallReader::offset_by_depth() {
    if (!read_call() || call_->arguments.numbers.size() != 2) return outside(call_->name);
    constexpr double kSteps = (1 << 24) - 1;
    step({Step::Kind::kCommand,
          {.id = CommandId::glPolygonOffset,
           .arguments = {call_->arguments.numbers[0], call_->arguments.numbers[1] * kSteps},
           .place = command_.place}});
}

void CallReader::blit() {
    if (!read_call()) return;
    const auto commands = framebuffers_.blit(call_->arguments.numbers, command_.place);
    if (!commands) return outside(call_->name);
    for (const Command& command : *commands)
        if (go_on_) step({Step::Kind::kCommand, command});
}

void CallReader::make_current() {
    if (!read_call() || call_->arguments.list.empty()) return;
    const Argument& context = call_->arguments.list.back();
    if (current_.size() >= kMostThreads && !current_.contains(thread_)) return;
    const ContextName name = context.form == Form::kNumber ? call_->arguments.numbers[context.first] : 0;
    current_[thread_] = name;
    if (name != 0 && contexts_.size() < kMostContexts && std::ranges::find(contexts_, name) == contexts_.end())
        contexts_.push_back(name);
    const bool was_followed = in_followed_;
    choose_context();
    // A widget's picture is complete when another context shows it.
    if (was_followed && !in_followed_ && framebuffers_.any_shown() && has_drawn_) end_frame();
}

// glXCreateContext(dpy, vis, shareList, direct) = context, and its later forms.
void CallReader::create_context() {
    const std::size_t share = call_->name == "glXCreateNewContext" ? 3 : 2;
    if (!read_call() || share >= call_->arguments.list.size() || call_->result.list.empty()) return;
    const auto handle = [](const Arguments& from, std::size_t i) {
        return from.list[i].form == Form::kNumber ? from.numbers[from.list[i].first] : 0;
    };
    groups_.create(handle(call_->result, 0), handle(call_->arguments, share));
}

// A call of the window system that cannot be read is passed over, as without this.
void CallReader::note_format() {
    try {
        if (read_call()) formats_.take(call_->name, call_->arguments, call_->result);
    } catch (const SceneError&) {
    }
}

// glMapBuffer(target, access) = address, or glMapBufferRange(target, offset, length, access) = address.
void CallReader::map_buffer() {
    if (!read_call()) return;
    const bool has_address = !call_->result.list.empty() && call_->result.list[0].form == Form::kNumber;
    if (!has_address || call_->arguments.numbers.size() < 2) return;
    const double target = call_->arguments.numbers[0];
    if (!(target >= 0 && target <= std::numeric_limits<Enum>::max())) return;
    const double offset = call_->arguments.numbers.size() >= 4 ? call_->arguments.numbers[1] : 0;
    const Mapping mapping{call_->result.numbers[0], offset, static_cast<Enum>(target)};
    std::erase_if(mappings_, [&](const Mapping& old) { return old.address == mapping.address; });
    if (mappings_.size() >= kMostMappings) mappings_.erase(mappings_.begin());
    mappings_.push_back(mapping);
}

// memcpy(dest, src, n): the program's writes to a mapped buffer object; converted to glBufferSubData. The tracer
// records them when the mapping ends or just before a draw, while the buffer object is still bound.
void CallReader::copy_memory() {
    if (!read_call()) return;
    const bool is_copy =
        call_->arguments.list.size() == 3 && call_->arguments.list[0].form == Form::kNumber &&
        (call_->arguments.list[1].form == Form::kBlob || call_->arguments.list[1].form == Form::kBlobSize);
    if (!is_copy) return outside(call_->name);
    const double to = call_->arguments.numbers[0];
    const Mapping* found = nullptr;
    for (const Mapping& mapping : mappings_)
        if (mapping.address <= to && (!found || mapping.address > found->address)) found = &mapping;
    if (!found) return outside(tr("memcpy to a mapped buffer"));
    Arguments call;
    call.numbers = {static_cast<double>(found->target), found->offset + to - found->address,
                    call_->arguments.numbers.back()};
    for (std::size_t i = 0; i < call.numbers.size(); ++i) call.list.push_back({Form::kNumber, i, 1});
    call.list.push_back(call_->arguments.list[1]);
    call.blobs = call_->arguments.blobs;
    command_.id = CommandId::glBufferSubData;
    convert(call, {}, blobs_, command_);
    step({Step::Kind::kCommand, command_});
}

}  // namespace twinlight::trace
