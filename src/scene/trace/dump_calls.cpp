#include "scene/trace/dump_calls.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/lexer.h"
#include "scene/command/text.h"

namespace twinlight::trace {

DumpCalls::DumpCalls(std::unique_ptr<ByteSource> source, std::string name)
    : source_(std::move(source)), name_(std::move(name)), lexer_(*source_) {}

void DumpCalls::fail_here(const std::string& message) const {
    fail({std::make_shared<const std::string>(name_), lexer_.line(), 1}, "{}", message);
}

bool DumpCalls::cut_off_or(const std::string& message) {
    const Place here{std::make_shared<const std::string>(name_), lexer_.line(), 1};
    is_inside_ = false;
    if (lexer_.skip_line()) fail(here, "{}", message);
    cut_off_ = tr("the recording ends inside call {}", call_.number);
    return false;
}

void DumpCalls::skip_rest() {
    if (std::exchange(is_inside_, false)) lexer_.skip_line();
}

bool DumpCalls::at_end() {
    skip_rest();
    return lexer_.at_end();
}

const RecordedCall* DumpCalls::next() {
    skip_rest();
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
    if (lexer_.at_end()) return nullptr;

    double number = 0;
    if (lexer_.number(number)) {
        call_.number = static_cast<int>(std::clamp(number, 0.0, 2147483647.0));
        has_call_numbers_ = true;
        lexer_.skip_blanks();
    } else if (call_.number < std::numeric_limits<int>::max()) {
        ++call_.number;  // a dump made with --call-nos=no
    }
    call_.is_fake = call_.has_stack = false;
    if (lexer_.accept('@')) {
        const std::string_view digits = lexer_.word();
        call_.thread = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), call_.thread, 16);
        lexer_.skip_blanks();
    }
    function_name_ = lexer_.word();
    if (!function_name_.empty() && lexer_.accept('(')) {
        call_.name = function_name_;
        call_.function = &functions_.find(function_name_);
        is_inside_ = true;
        return &call_;
    }
    const char c = lexer_.peek();
    if (c == '\x1b') fail_here(tr("this dump contains colour codes; create it with 'apitrace dump --color=never'"));
    cut_off_or(tr("expected a call as apitrace prints it, such as '9 glEnable(cap = GL_LIGHT0)', found {}",
                  in_quotes(function_name_.empty() ? std::string(1, c) : function_name_)));
    return nullptr;
}

bool DumpCalls::read() {
    call_.arguments.clear();
    call_.result.clear();
    if (const std::string wrong = read_arguments(lexer_, call_.arguments); !wrong.empty()) return cut_off_or(wrong);
    if (!read_end_of_call()) return false;
    // The recording ended before this call returned.
    const bool makes_lists = call_.function->role == Role::kCommand && call_.function->command == CommandId::glGenLists;
    if (makes_lists && call_.result.list.empty() && lexer_.at_end()) return cut_off_or("");
    return true;
}

// Reads " = 1 // fake" and the line end.
bool DumpCalls::read_end_of_call() {
    bool complete = true;
    if (!lexer_.accept('\n')) {
        lexer_.skip_blanks();
        if (lexer_.accept('=')) {
            lexer_.skip_blanks();
            if (const std::string wrong = read_value(lexer_, call_.result); !wrong.empty()) return cut_off_or(wrong);
            lexer_.skip_blanks();
        }
        if (lexer_.accept("//")) {
            lexer_.skip_blanks();
            for (std::string_view word = lexer_.word(); !word.empty(); word = lexer_.word()) {
                complete &= word != "incomplete";
                call_.is_fake |= word == "fake";
                lexer_.skip_blanks();
            }
        }
        lexer_.accept('\r');
        if (!lexer_.accept('\n') && !lexer_.at_end())
            return cut_off_or(tr("expected the end of the line after this call"));
        // At the end of the text, a number may lack its last digits.
        if (lexer_.at_end() && !call_.result.list.empty()) return cut_off_or("");
    }
    lexer_.count_line();
    is_inside_ = false;
    read_stack();
    return complete && call_.arguments.are_complete();
}

void DumpCalls::read_stack() {
    skip_rest();
    call_.has_stack = lexer_.accept("Backtrace:");
    if (call_.has_stack) skip_stack();
}

// Its lines start with the name of a program or a library, and calls with a number.
void DumpCalls::skip_stack() {
    call_.stack.clear();
    do {
        lexer_.rest_of_line(call_.stack, kLongestStack);
        call_.stack += '\n';
        const char c = lexer_.peek();
        const bool is_call = has_call_numbers_ ? c >= '0' && c <= '9' : c >= 'a' && c <= 'z';
        if (is_call || c == '\n' || c == '\r') return;
    } while (!lexer_.at_end());
}

std::string DumpCalls::mark() {
    while (!lexer_.at_end() && lexer_.peek() != '"' && lexer_.peek() != '\n') lexer_.skip();
    return lexer_.peek() == '"' ? std::string(lexer_.string(kLongestStack)) : "";
}

}  // namespace twinlight::trace
