// Runs the statements of a whole program: blocks, conditions, loops, declarations and calls of its functions.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

// ---- The place in the text ----

void Reader::step() { jump(std::min(program_->at + 1, program_->tokens.size() - 1)); }

void Reader::jump(std::size_t at) {
    Program& p = *program_;
    if (++p.steps > p.options.most_steps)
        fail(p.loop != 0 ? p.tokens[p.loop].place : token_.place,
             "this program is stopped here after {} steps; does this loop ever end?", p.options.most_steps);
    p.at = at;
    token_ = p.tokens[at];
    ahead_ = p.tokens[std::min(at + 1, p.tokens.size() - 1)];
}

// Moves past a token; from an opening bracket, past the closing one.
void Reader::skip_token() {
    if (token_.is("(") || token_.is("[") || token_.is("{"))
        jump(program_->partners[program_->at] + 1);
    else
        advance();
}

// Moves to the ',', ';' or closing bracket that ends an expression.
void Reader::skip_expression() {
    const auto at_end = [&] {
        return token_.is(",") || token_.is(";") || token_.is(")") || token_.is("]") || token_.is("}");
    };
    while (token_.kind != TokenKind::kEnd && !at_end()) skip_token();
}

void Reader::skip_statement() {
    Program& p = *program_;
    if (++p.depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
    const auto skip_parentheses = [&] {
        advance();
        if (!token_.is("(")) fail_missing("(", tr("at the start of the condition"));
        jump(p.partners[p.at] + 1);
    };
    if (token_.is("{")) {
        jump(p.partners[p.at] + 1);
    } else if (token_.is("if")) {
        skip_parentheses();
        skip_statement();
        if (accept("else")) skip_statement();
    } else if (token_.is("for") || token_.is("while") || token_.is("switch")) {
        skip_parentheses();
        skip_statement();
    } else if (token_.is("do")) {
        advance();
        skip_statement();
        skip_parentheses();
        expect(";", "after do ... while (...)");
    } else {
        while (!token_.is(";")) {
            if (token_.is("}") || token_.kind == TokenKind::kEnd) fail_missing(";", tr("at the end of the statement"));
            skip_token();
        }
        advance();
    }
    --p.depth;
}

// ---- Statements ----

Flow Reader::run_statement() {
    Program& p = *program_;
    if (++p.depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
    forget_literals();
    Flow flow = Flow::kNext;
    if (token_.is("{")) {
        flow = run_block();
    } else if (accept(";")) {
    } else if (token_.kind == TokenKind::kPragma) {
        pragma();
    } else if (token_.is("if")) {
        flow = run_if();
    } else if (token_.is("for")) {
        flow = run_for();
    } else if (token_.is("while")) {
        flow = run_while();
    } else if (token_.is("do")) {
        flow = run_do();
    } else if (token_.is("switch")) {
        flow = run_switch();
    } else if (token_.is("return")) {
        flow = run_return();
    } else if (token_.is("break") || token_.is("continue")) {
        flow = token_.is("break") ? Flow::kBreak : Flow::kContinue;
        advance();
        expect(";", "after break or continue");
    } else if (token_.is("case") || token_.is("default")) {
        while (!token_.is(":") && token_.kind != TokenKind::kEnd) advance();
        advance();
    } else if (token_.is("goto") || (token_.kind == TokenKind::kName && ahead_.is("::"))) {
        out_of_reach(token_.place, in_quotes(token_.text));
    } else if (token_.is("typedef")) {
        typedef_declaration();
    } else if (token_.is("using") && ahead_.is("namespace")) {
        skip_statement();
    } else if (skip_extern()) {
    } else if (is_declaration()) {
        declaration();
    } else {
        if (token_.is("(") && ahead_.is("void") && p.partners[p.at] == p.at + 2) jump(p.at + 3);  // (void)printf(...)
        const bool is_command = token_.kind == TokenKind::kName && ahead_.is("(") &&
                                !p.functions.contains(token_.text) && find_command_or_extension(token_.text);
        if (is_command) call();  // its result is not needed
        if (!is_command || accept(",")) comma_expressions();
        expect(";", "at the end of the statement");
        if (p.reached_main_loop) flow = Flow::kReturn;
    }
    --p.depth;
    return flow;
}

Flow Reader::run_block() {
    const std::size_t outer = program_->locals.size();
    const std::size_t block = std::exchange(program_->block, outer);
    advance();
    Flow flow = Flow::kNext;
    while (flow == Flow::kNext && !token_.is("}")) flow = run_statement();
    forget_locals(outer);
    program_->block = block;
    if (flow == Flow::kNext) advance();
    return flow;
}

// What follows if (...), else, for (...), while (...) and do.
Flow Reader::run_body() {
    if (!token_.is("{") && is_declaration()) fail(token_.place, "a declaration here needs {{ and }} around it");
    return run_statement();
}

// Reads "(condition)".
bool Reader::condition() {
    expect("(", "at the start of the condition");
    const Value value = comma_expressions();
    expect(")", "after the condition");
    return is_true(value);
}

Flow Reader::run_if() {
    while (true) {  // a round for each else if
        advance();
        if (condition()) {
            const Flow flow = run_body();
            if (flow != Flow::kNext) return flow;
            while (accept("else")) {
                if (!token_.is("if")) {
                    skip_statement();
                    break;
                }
                advance();
                jump(program_->partners[program_->at] + 1);
                skip_statement();
            }
            return Flow::kNext;
        }
        skip_statement();
        if (!accept("else")) return Flow::kNext;
        if (!token_.is("if")) return run_body();
    }
}

Flow Reader::run_while() {
    const std::size_t loop = program_->at;
    advance();
    const std::size_t start = program_->at;
    const std::size_t outer = program_->locals.size();
    while (condition()) {
        program_->loop = loop;
        const Flow flow = run_body();
        forget_locals(outer);
        if (flow == Flow::kReturn) return flow;
        if (flow == Flow::kBreak) break;
        jump(start);
    }
    jump(program_->partners[start] + 1);
    skip_statement();
    return Flow::kNext;
}

Flow Reader::run_do() {
    const std::size_t loop = program_->at;
    advance();
    const std::size_t body = program_->at;
    const std::size_t outer = program_->locals.size();
    skip_statement();
    const std::size_t end = program_->at;
    bool again = true;
    Flow flow = Flow::kNext;
    while (again && flow != Flow::kBreak) {
        program_->loop = loop;
        jump(body);
        flow = run_body();
        forget_locals(outer);
        if (flow == Flow::kReturn) return flow;
        jump(end);
        expect("while", "after the body of do");
        if (flow == Flow::kBreak)
            jump(program_->partners[program_->at] + 1);
        else
            again = condition();
    }
    expect(";", "after do ... while (...)");
    return Flow::kNext;
}

Flow Reader::run_for() {
    Program& p = *program_;
    const std::size_t loop = p.at;
    const std::size_t outer = p.locals.size();
    const std::size_t block = std::exchange(p.block, outer);
    advance();
    if (!token_.is("(")) fail_missing("(", tr("after for"));
    const std::size_t close = p.partners[p.at];
    advance();
    if (is_declaration()) {
        declaration();
    } else {
        if (!token_.is(";")) comma_expressions();
        expect(";", "after the start of for (...)");
    }
    const std::size_t inner = p.locals.size();
    const std::size_t test = p.at;
    while (!token_.is(";") && p.at < close) skip_token();
    expect(";", "after the condition of for (...)");
    const std::size_t step = p.at;
    check_length_of_for(loop);
    while (true) {
        p.loop = loop;
        jump(test);
        bool holds = true;
        if (!token_.is(";")) {
            holds = is_true(comma_expressions());
        }
        if (!token_.is(";")) fail_missing(";", tr("after the condition of for (...)"));
        if (!holds) break;
        jump(close + 1);
        const Flow flow = run_body();
        forget_locals(inner);
        if (flow == Flow::kReturn) {
            forget_locals(outer);
            p.block = block;
            return flow;
        }
        if (flow == Flow::kBreak) break;
        jump(step);
        if (!token_.is(")")) comma_expressions();
        if (p.at != close) fail_missing(")", tr("after for (...; ...; ..."));
    }
    forget_locals(outer);
    p.block = block;
    jump(close + 1);
    skip_statement();
    return Flow::kNext;
}

Flow Reader::run_switch() {
    Program& p = *program_;
    advance();
    expect("(", "after switch");
    const Place place = token_.place;
    const Value chosen = number();
    if (!chosen.is_integer()) fail(place, "switch needs a whole number");
    expect(")", "after switch (...");
    if (!token_.is("{")) fail_missing("{", tr("after switch (...)"));
    const std::size_t end = p.partners[p.at];
    const std::size_t outer = p.locals.size();
    std::optional<std::size_t> start;
    advance();
    while (p.at < end) {
        if (accept("case")) {
            const bool same = number().integer == chosen.integer;
            if (!token_.is(":")) fail_missing(":", tr("after case"));
            if (same) {
                start = p.at + 1;
                break;
            }
        } else if (token_.is("default") && ahead_.is(":")) {
            start = p.at + 2;
        }
        skip_token();
    }
    Flow flow = Flow::kNext;
    if (start) {
        const std::size_t block = std::exchange(p.block, outer);
        jump(*start);
        while (flow == Flow::kNext && p.at < end) flow = run_statement();
        p.block = block;
    }
    forget_locals(outer);
    if (flow == Flow::kReturn || flow == Flow::kContinue) return flow;
    jump(end + 1);
    return Flow::kNext;
}

Flow Reader::run_return() {
    Program& p = *program_;
    const Place place = token_.place;
    advance();
    if (!token_.is(";")) {
        const Value value = comma_expressions();
        const DataType* const type = p.result;
        if (type && type->is_struct()) {
            if (!value.is_struct() || value.of != type) fail(place, "this function returns a struct of another type");
            const std::span<const std::byte> bytes = bytes_behind(value, type->size, false, place);
            hold(type->size, place);
            p.returned_struct = std::make_shared<Memory>(
                Memory{type->leaf.value_or(Kind::kUbyte),
                       std::vector<std::byte>(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type->size))});
        } else if (type && type->is_pointer()) {
            p.returned = integer(static_cast<std::int64_t>(address(converted_by_cast(value, type, place))));
        } else if (type && type->is_number()) {
            p.returned = in_kind(value, type->kind, place);
        }
    }
    expect(";", "after return");
    return Flow::kReturn;
}

// ---- Variables ----

bool Reader::is_declaration() const {
    if (token_.kind != TokenKind::kName) return false;
    for (std::string_view word : {"const", "static", "register", "extern", "volatile"})
        if (token_.is(word)) return true;
    return at_type();
}

Object& Reader::declare(const Token& name, Object object) {
    Program& p = *program_;
    if (p.locals.size() - p.frame >= kMaxProgramLocals)
        fail(name.place, "a function can have at most {} variables", kMaxProgramLocals);
    auto owned = std::make_unique<Object>(std::move(object));
    Object* const made = owned.get();
    p.locals.push_back({name.text, made, std::move(owned), p.block});
    return *made;
}

// Declares a static variable of a function, whose name was just read. Returns true if it already has its value.
bool Reader::declare_static(const Declarator& made) {
    Program& p = *program_;
    if (p.locals.size() - p.frame >= kMaxProgramLocals)
        fail(made.name.place, "a function can have at most {} variables", kMaxProgramLocals);
    const auto [found, is_new] = p.statics.emplace(made.at, Object{});
    p.locals.push_back({made.name.text, &found->second, nullptr, p.block});
    if (is_new) return false;
    skip_expression();
    return true;
}

void Reader::forget_locals(std::size_t count) {
    std::vector<Local>& locals = program_->locals;
    if (program_->reached_main_loop) return;  // main waits in it, and never ends
    for (; locals.size() > count; locals.pop_back())
        if (locals.back().owned) forget(*locals.back().owned);
}

// ---- Calls ----

Value Reader::run_function(const Function& function, const std::vector<Value>& given, const Place& place) {
    Program& p = *program_;
    const std::string name = in_quotes(function.name.text);
    if (function.refusal) throw SceneError(*function.refusal);
    const std::size_t wanted_count = function.parameters.size();
    if (given.size() < wanted_count || (given.size() > wanted_count && !function.takes_more))
        fail(place, "the function {} takes {} arguments, but {} are given", name,
             function.takes_more ? tr("at least {}", wanted_count) : fmt::format("{}", wanted_count), given.size());
    if (++p.depth > kMaxProgramDepth) fail(place, "the calls of {} are nested too deeply", name);

    const std::size_t first = p.locals.size();
    const std::size_t frame = std::exchange(p.frame, first);
    const std::size_t block = std::exchange(p.block, first);
    for (std::size_t i = 0; i < wanted_count; ++i) {
        const FormalParameter& parameter = function.parameters[i];
        const Token token{TokenKind::kName, parameter.name, place};
        const auto refuse = [&](std::string_view needed) {
            fail(place, "the parameter {} of {} needs {}", in_quotes(parameter.name), name, needed);
        };
        if (parameter.type->is_struct() && given[i].of != parameter.type) refuse(tr("a struct of its type"));
        if (parameter.type->is_pointer() && !given[i].is_pointer() && !given[i].is_null()) refuse(tr("an array"));
        if (parameter.type->is_number() && !given[i].is_null() && (given[i].is_pointer() || given[i].is_struct()))
            refuse(tr("a number"));
        const DataType* const wanted = parameter.type->of;
        const auto kind = given[i].kind();
        if (parameter.type->is_pointer() && given[i].object && wanted->is_number() && kind &&
            c_type(*kind) != c_type(wanted->kind))
            refuse(tr("an array of {}", c_type_name(c_type(wanted->kind))));
        Object& object =
            declare(token, {.type = parameter.type, .shown = in_quotes(parameter.name), .place = place, .known = true});
        allocate(object, place);
        assigned({&object, 0, object.type}, given[i], place);
    }

    // The caller's literals live on while the function runs.
    std::optional<std::deque<Object>> literals;
    if (!literals_.empty()) literals.emplace().swap(literals_);
    const std::size_t resume = p.at;
    const std::size_t nesting = std::exchange(nesting_, 0);
    const bool in_function = std::exchange(p.in_function, true);
    const DataType* const result = std::exchange(p.result, function.result);
    std::optional<std::vector<Value>> more;
    if (function.takes_more) more.emplace(given.begin() + static_cast<std::ptrdiff_t>(wanted_count), given.end());
    more.swap(p.more);
    p.returned = integer(0);
    p.returned_struct.reset();
    jump(function.body);
    run_block();
    forget_literals();
    forget_locals(first);
    if (literals) literals_.swap(*literals);
    nesting_ = nesting;
    p.in_function = in_function;
    p.more = std::move(more);
    p.frame = frame;
    p.block = block;
    --p.depth;
    jump(resume);
    p.result = result;
    return result_of(function, place);
}

// The value that a function has returned.
Value Reader::result_of(const Function& function, const Place& place) {
    Program& p = *program_;
    const DataType* const type = function.result;
    const Value returned = std::exchange(p.returned, integer(0));
    if (!type) return integer(0);
    if (type->is_pointer()) return pointer_from(static_cast<std::uint64_t>(returned.integer), type->of);
    if (!type->is_struct()) return returned;
    Object& object = literals_.emplace_back(
        Object{.type = type, .shown = tr("this struct"), .place = place, .is_literal = true, .known = true});
    object.memory = std::exchange(p.returned_struct, nullptr);
    if (!object.memory) fail(place, "the function {} has returned no struct", in_quotes(function.name.text));
    return {.type = Value::Type::kStruct, .object = &object, .of = type};
}

}  // namespace twinlight
