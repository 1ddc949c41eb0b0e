#include "scene/trace/dump_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "scene/command/lexer.h"
#include "scene/command/text.h"
#include "scene/trace/convert.h"

namespace twinlight::trace {

namespace {

using Form = Argument::Form;

constexpr std::size_t kMostMappings = 1024, kLongestStack = 1 << 16, kMostWaiting = 256;
// Enough to see which context draws most.
constexpr int kMostCallsCounted = 300'000, kMostFramesCounted = 8;

// With an enumerant that GL 2.1 lacks, these change no pixel: an unknown capability is already off.
bool is_harmless_with_unknown_name(std::string_view function) {
    return function == "glDisable" || function == "glDisableClientState" || function == "glHint";
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

DumpReader::DumpReader(ByteSource& source, const std::string& name, BlobLoader blobs)
    : lexer_(source), blobs_(std::move(blobs)), name_(std::make_shared<const std::string>(name)) {}

void DumpReader::follow(ContextName context, std::set<double> shown_objects) {
    followed_ = context;
    framebuffers_.show(std::move(shown_objects));
    choose_context();
}

void DumpReader::choose_context() {
    const auto current = current_.find(thread_);
    in_followed_ = !followed_ || (current != current_.end() && current->second == *followed_);
}

bool DumpReader::for_each(const std::function<bool(const Step&)>& visit) {
    visit_ = &visit;
    go_on_ = true;
    while (go_on_ && next_call()) carry_out(functions_.find(function_name_));
    visit_waiting({});
    return go_on_;
}

void DumpReader::visit_waiting(const Place& place) {
    for (Command& command : waiting_) {
        if (place.calls) command.place = place;
        if (go_on_) go_on_ = (*visit_)({.command = command});
    }
    waiting_.clear();
}

void DumpReader::step(const Step& step) {
    visit_waiting(step.command.place);
    if (go_on_) go_on_ = (*visit_)(step);
}

void DumpReader::count_contexts(bool whole, ContextCounts& counts) {
    static const std::function<bool(const Step&)> kNothing = [](const Step&) { return true; };
    visit_ = &kNothing;
    int calls = 0, frames = 0;  // since the first that draws
    const auto goes_on = [&] {
        return calls < kMostCallsCounted && (frames < kMostFramesCounted || counts.busiest_draws_into_objects());
    };
    while ((whole || goes_on()) && next_call()) {
        const Function& function = functions_.find(function_name_);
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
        if (ContextCounts::needs_arguments(function, function_name_)) {
            if (!read_call()) continue;
        } else {
            lexer_.skip_line();
        }
        counts.count(thread_, function, function_name_, arguments_.numbers);
        if (counts.any_draws()) ++calls;
        if (calls > 0 && function.role == Role::kFrameEnd) ++frames;
    }
}

void DumpReader::fail_here(const std::string& message) const { fail({name_, lexer_.line(), 1}, "{}", message); }

bool DumpReader::cut_off_or(const std::string& message) {
    const Place here{name_, lexer_.line(), 1};
    if (lexer_.skip_line()) fail(here, "{}", message);
    const std::string text = fmt::format("the recording ends inside call {}", call_);
    step({Step::Kind::kCutOff, command_, text});
    return false;
}

bool DumpReader::next_call() {
    while (!lexer_.at_end()) {
        const char c = lexer_.peek();
        if (c == '\n' || c == '/') {
            if (c == '/' && !lexer_.accept("//")) break;
            lexer_.skip_line();
        } else if (c == ' ' || c == '\r') {
            lexer_.skip();
        } else if (c == 'B' && lexer_.accept("Backtrace:")) {
            skip_stack();
        } else {
            break;
        }
    }
    if (lexer_.at_end()) return false;

    double number = 0;
    if (lexer_.number(number)) {
        call_ = static_cast<int>(std::clamp(number, 0.0, 2147483647.0));
        has_call_numbers_ = true;
        lexer_.skip_blanks();
    } else if (call_ < std::numeric_limits<int>::max()) {
        ++call_;  // a dump made with --call-nos=no
    }
    command_.place = {name_, call_, Place::kCallNumber};
    is_fake_ = false;
    if (lexer_.accept('@')) {
        const std::string_view digits = lexer_.word();
        unsigned thread = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), thread, 16);
        lexer_.skip_blanks();
        if (thread != thread_) {
            thread_ = thread;
            choose_context();
        }
    }
    function_name_ = lexer_.word();
    if (!function_name_.empty() && lexer_.accept('(')) return true;
    const char c = lexer_.peek();
    if (c == '\x1b') fail_here("this dump contains colour codes; create it with 'apitrace dump --color=never'");
    return cut_off_or(
        fmt::format("expected a call as apitrace prints it, such as '9 glEnable(cap = GL_LIGHT0)', found {}",
                    in_quotes(function_name_.empty() ? std::string(1, c) : function_name_)));
}

bool DumpReader::read_call() {
    arguments_.clear();
    result_.clear();
    if (const std::string wrong = read_arguments(lexer_, arguments_); !wrong.empty()) return cut_off_or(wrong);
    return read_end_of_call();
}

// Reads " = 1 // fake" and the line end.
bool DumpReader::read_end_of_call() {
    bool complete = true;
    if (!lexer_.accept('\n')) {
        lexer_.skip_blanks();
        if (lexer_.accept('=')) {
            lexer_.skip_blanks();
            if (const std::string wrong = read_value(lexer_, result_); !wrong.empty()) return cut_off_or(wrong);
            lexer_.skip_blanks();
        }
        if (lexer_.accept("//")) {
            lexer_.skip_blanks();
            for (std::string_view word = lexer_.word(); !word.empty(); word = lexer_.word()) {
                complete &= word != "incomplete";
                is_fake_ |= word == "fake";
                lexer_.skip_blanks();
            }
        }
        lexer_.accept('\r');
        if (!lexer_.accept('\n') && !lexer_.at_end()) return cut_off_or("expected the end of the line after this call");
        // At the end of the text, a number may lack its last digits.
        if (lexer_.at_end() && !result_.list.empty()) return cut_off_or("");
    }
    lexer_.count_line();
    read_stack();
    const auto missing = [](const Argument& argument) { return argument.form == Form::kMissing; };
    return complete && std::none_of(arguments_.list.begin(), arguments_.list.end(), missing);
}

void DumpReader::skip_call() {
    lexer_.skip_line();
    read_stack();
}

// Reads the call stack of the call, if one follows, and sets the command's place. A call inside glBegin may be recorded without
// one (record.cpp), and has the place of the call before it.
void DumpReader::read_stack() {
    const bool has_stack = lexer_.accept("Backtrace:");
    if (has_stack) skip_stack();
    has_stacks_ |= has_stack;
    if (!has_stacks_ || is_fake_) return;
    const auto mark = marks_.find(thread_);
    if (mark != marks_.end()) stack_ = mark->second;
    if (has_stack || mark != marks_.end()) {
        if (const Place& place = stacks_.place(stack_, function_name_); place.file) command_.place = place;
        place_before_ = command_.place;
    } else if (place_before_.calls) {
        command_.place = place_before_;
    }
}

// glStringMarkerGREMEDY(len = 29, string = "python: display: lamp.py:12"): the stack of the calls that follow (python_lines.py).
void DumpReader::read_mark() {
    while (!lexer_.at_end() && lexer_.peek() != '"' && lexer_.peek() != '\n') lexer_.skip();
    if (lexer_.peek() == '"') {
        const std::string_view text = lexer_.string(kLongestStack);
        if (text.starts_with("python: ") && (marks_.size() < kMostThreads || marks_.contains(thread_)))
            marks_[thread_] = text;
    }
    lexer_.skip_line();
}

// Its lines start with the name of a program or a library, and calls with a number.
void DumpReader::skip_stack() {
    stack_.clear();
    do {
        lexer_.rest_of_line(stack_, kLongestStack);
        stack_ += '\n';
        const char c = lexer_.peek();
        const bool is_call = has_call_numbers_ ? c >= '0' && c <= '9' : c >= 'a' && c <= 'z';
        if (is_call || c == '\n' || c == '\r') return;
    } while (!lexer_.at_end());
}

void DumpReader::carry_out(const Function& function) {
    switch (function.role) {
        case Role::kMakeCurrent: return make_current();
        case Role::kIgnored:
            if (function.makes_context) return create_context();
            if (function_name_ == "glStringMarkerGREMEDY") return read_mark();
            lexer_.skip_line();
            return;
        case Role::kFrameEnd:
            lexer_.skip_line();
            if (in_followed_) end_frame();
            return;
        default: break;
    }
    if (!in_followed_) {
        if (!function.names_shared) {
            lexer_.skip_line();
            arguments_.clear();
        } else if (!read_call()) {
            return;
        }
        const auto current = current_.find(thread_);
        if (current == current_.end() || !groups_.may_share(current->second, *followed_)) return;
        const auto number = std::ranges::find(contexts_, current->second) - contexts_.begin();
        const std::string report = shared_.of_other(current->second, static_cast<std::size_t>(number), function,
                                                    function_name_, arguments_.numbers);
        if (!report.empty()) outside(report);
        return;
    }
    has_drawn_ |= function.draws || function.is_vertex;
    switch (function.role) {
        case Role::kCommand: return carry_out_command(function);
        case Role::kMapBuffer: return map_buffer();
        case Role::kCopy: return copy_memory();
        case Role::kBlit: return blit();
        case Role::kBinding: {
            if (!read_call()) return;
            const bool of_gl = !arguments_.numbers.empty() && arguments_.numbers.back() == 0;
            if (!of_gl) outside(function_name_);
            return;
        }
        case Role::kStorage: return storage_with_samples();
        default: skip_call(); return outside(function_name_);
    }
}

void DumpReader::carry_out_command(const Function& function) {
    if (!read_call()) return;
    // The recording ended before this call returned.
    if (function.command == CommandId::glGenLists && result_.list.empty() && lexer_.at_end()) {
        cut_off_or("");
        return;
    }
    if (function.sets_units && is_of_units_for_shaders()) return;
    if (!arguments_.unknown_name.empty()) {
        if (is_harmless_with_unknown_name(function_name_)) return;
        return outside(fmt::format("{}({})", function_name_, arguments_.unknown_name));
    }
    command_.id = function.command;
    convert(arguments_, result_, blobs_, command_);
    command_.id = client_state(command_);
    if (followed_ && function.names_shared) {
        const std::string report = shared_.of_followed(function_name_, arguments_.numbers);
        if (!report.empty()) outside(report);
    }
    if (!framebuffers_.follow(command_)) return;
    // A glVertexPointer whose arrays are recorded when the program draws.
    if (is_fake_ && has_stacks_ && waiting_.size() < kMostWaiting)
        waiting_.push_back(command_);
    else
        step({Step::Kind::kCommand, command_});
}

// Shaders have more texture units than the fixed function, and some programs reset them all. A dump may call such a unit by another
// name of the same number: GL_TEXTURE0 + 34 is GL_MAX_TEXTURE_UNITS.
bool DumpReader::is_of_units_for_shaders() {
    constexpr double kMostUnits = 192;  // GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS of llvmpipe
    if (function_name_.starts_with("glActiveTexture")) {
        const double unit = arguments_.numbers.empty() ? 0 : arguments_.numbers[0] - kGL_TEXTURE0;
        const bool is_unit = unit >= 0 && unit < kMostUnits;
        is_unit_for_shaders_ =
            !arguments_.unknown_name.empty() || (is_unit && !find_gl_name(fmt::format("GL_TEXTURE{:.0f}", unit)));
        return is_unit_for_shaders_;
    }
    if (!is_unit_for_shaders_) return false;
    constexpr std::array kEnabled = {kGL_TEXTURE_1D,    kGL_TEXTURE_2D,    kGL_TEXTURE_3D,    kGL_TEXTURE_CUBE_MAP,
                                     kGL_TEXTURE_GEN_S, kGL_TEXTURE_GEN_T, kGL_TEXTURE_GEN_R, kGL_TEXTURE_GEN_Q};
    const bool enables = function_name_ == "glEnable" || function_name_ == "glDisable";
    return !enables || (!arguments_.numbers.empty() && std::ranges::count(kEnabled, arguments_.numbers[0]) > 0);
}

void DumpReader::end_frame() {
    step({Step::Kind::kFrameEnd, command_});
    has_drawn_ = false;
}

// glRenderbufferStorageMultisample: read as with one sample per pixel.
void DumpReader::storage_with_samples() {
    if (!read_call() || arguments_.numbers.size() != 5) return outside(function_name_);
    const std::vector<double>& given = arguments_.numbers;
    const Command storage{.id = CommandId::glRenderbufferStorage,
                          .arguments = {given[0], given[2], given[3], given[4]},
                          .place = command_.place};
    step({Step::Kind::kCommand, storage});
}

void DumpReader::blit() {
    if (!read_call()) return;
    const auto commands = framebuffers_.blit(arguments_.numbers, command_.place);
    if (!commands) return outside(function_name_);
    for (const Command& command : *commands)
        if (go_on_) step({Step::Kind::kCommand, command});
}

void DumpReader::make_current() {
    if (!read_call() || arguments_.list.empty()) return;
    const Argument& context = arguments_.list.back();
    if (current_.size() >= kMostThreads && !current_.contains(thread_)) return;
    const ContextName name = context.form == Form::kNumber ? arguments_.numbers[context.first] : 0;
    current_[thread_] = name;
    if (name != 0 && contexts_.size() < kMostContexts && std::ranges::find(contexts_, name) == contexts_.end())
        contexts_.push_back(name);
    const bool was_followed = in_followed_;
    choose_context();
    // A widget's picture is complete when another context shows it.
    if (was_followed && !in_followed_ && framebuffers_.any_shown() && has_drawn_) end_frame();
}

// glXCreateContext(dpy, vis, shareList, direct) = context, and its later forms.
void DumpReader::create_context() {
    const std::size_t share = function_name_ == "glXCreateNewContext" ? 3 : 2;
    if (!read_call() || share >= arguments_.list.size() || result_.list.empty()) return;
    const auto handle = [](const Arguments& from, std::size_t i) {
        return from.list[i].form == Form::kNumber ? from.numbers[from.list[i].first] : 0;
    };
    groups_.create(handle(result_, 0), handle(arguments_, share));
}

// A call of the window system that cannot be read is passed over, as without this.
void DumpReader::note_format() {
    try {
        if (read_call()) formats_.take(function_name_, arguments_, result_);
    } catch (const SceneError&) {
    }
}

// glMapBuffer(target, access) = address, or glMapBufferRange(target, offset, length, access) = address.
void DumpReader::map_buffer() {
    if (!read_call()) return;
    const bool has_address = !result_.list.empty() && result_.list[0].form == Form::kNumber;
    if (!has_address || arguments_.numbers.size() < 2) return;
    const double target = arguments_.numbers[0];
    if (!(target >= 0 && target <= std::numeric_limits<Enum>::max())) return;
    const double offset = arguments_.numbers.size() >= 4 ? arguments_.numbers[1] : 0;
    const Mapping mapping{result_.numbers[0], offset, static_cast<Enum>(target)};
    std::erase_if(mappings_, [&](const Mapping& old) { return old.address == mapping.address; });
    if (mappings_.size() >= kMostMappings) mappings_.erase(mappings_.begin());
    mappings_.push_back(mapping);
}

// memcpy(dest, src, n): the program's writes to a mapped buffer object; converted to glBufferSubData. The tracer
// records them when the mapping ends or just before a draw, while the buffer object is still bound.
void DumpReader::copy_memory() {
    if (!read_call()) return;
    const bool is_copy = arguments_.list.size() == 3 && arguments_.list[0].form == Form::kNumber &&
                         (arguments_.list[1].form == Form::kBlob || arguments_.list[1].form == Form::kBlobSize);
    if (!is_copy) return outside(function_name_);
    const double to = arguments_.numbers[0];
    const Mapping* found = nullptr;
    for (const Mapping& mapping : mappings_)
        if (mapping.address <= to && (!found || mapping.address > found->address)) found = &mapping;
    if (!found) return outside("memcpy to a mapped buffer");
    Arguments call;
    call.numbers = {static_cast<double>(found->target), found->offset + to - found->address, arguments_.numbers.back()};
    for (std::size_t i = 0; i < call.numbers.size(); ++i) call.list.push_back({Form::kNumber, i, 1});
    call.list.push_back(arguments_.list[1]);
    call.blobs = arguments_.blobs;
    command_.id = CommandId::glBufferSubData;
    convert(call, {}, blobs_, command_);
    step({Step::Kind::kCommand, command_});
}

}  // namespace twinlight::trace
