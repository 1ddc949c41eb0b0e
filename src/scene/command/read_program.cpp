// Reads a whole GLUT program: its functions and global variables, then its run in GLUT's order.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

Reader::Reader(std::vector<Token> tokens, const std::string& file, const ImageLoader& load_image,
               const ReadOptions& options)
    : lexer_("", file), program_(std::make_unique<Program>()), load_image_(load_image), load_mesh_(options.load_mesh) {
    program_->tokens = std::move(tokens);
    program_->options = options;
    match_brackets();
    jump(0);
}

void Reader::match_brackets() {
    Program& p = *program_;
    p.partners.resize(p.tokens.size());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < p.tokens.size(); ++i) {
        const Token& token = p.tokens[i];
        if (token.kind != TokenKind::kPunctuation || token.text.size() != 1) continue;
        const std::size_t opens = std::string_view("({[").find(token.text[0]);
        const std::size_t closes = std::string_view(")}]").find(token.text[0]);
        if (opens != std::string_view::npos) open.push_back(i);
        if (closes == std::string_view::npos) continue;
        if (open.empty()) fail(token.place, "this {} closes nothing", shown(token));
        const Token& partner = p.tokens[open.back()];
        if (std::string_view("({[").find(partner.text[0]) != closes)
            fail(token.place, "this {} does not close the {} at {}", shown(token), shown(partner), partner.place.str());
        p.partners[open.back()] = i;
        open.pop_back();
    }
    if (!open.empty()) fail(p.tokens[open.back()].place, "this {} is never closed", shown(p.tokens[open.back()]));
}

void Reader::out_of_reach(const Place& place, std::string_view construct) const {
    fail(place, "reading a program cannot follow {}; run and record it: twinlight record {}", construct,
         place.file ? *place.file : "PROGRAM.c");
}

CommandList Reader::run(const std::string& name) {
    Program& p = *program_;
    if (p.options.window) p.window = *p.options.window;
    read_functions();
    const auto main = p.functions.find("main");
    if (main == p.functions.end()) fail(token_.place, "this program has no function main");
    const Place& place = main->second.name.place;
    run_function(main->second, arguments_of_main(main->second), place);
    if (!std::exchange(p.reached_main_loop, false))
        fail(place, "main ends before it calls glutMainLoop, so nothing is drawn");
    p.kept_locals = p.locals.size();
    if (!p.display) fail(place, "this program has no display function; register it: glutDisplayFunc(display);");
    if (p.reshape) call_from_glut(*p.reshape, {integer(p.window.width), integer(p.window.height)});
    call_from_glut(*p.display, {});
    CommandList list{name, std::move(commands_)};
    list.is_program = true;
    list.window = p.window;
    if (std::vector<LaterPicture> later = later_pictures(); !later.empty())
        list.later = std::make_shared<const std::vector<LaterPicture>>(std::move(later));
    if (p.windows > 1)
        list.own_notes.push_back(
            fmt::format("this program has {} windows; the picture is that of the first", p.windows));
    if (p.asks_for_samples) list.own_notes.emplace_back(kOneSampleNote);
    return list;
}

// argc is 1: the program has its name, but no arguments.
std::vector<Value> Reader::arguments_of_main(const Function& main) {
    std::vector<Value> given(main.parameters.size());
    if (!given.empty()) given[0] = integer(1);
    if (given.size() < 2) return given;
    constexpr std::string_view kName = "program";
    Program& p = *program_;
    const DataType* const character = types_.number(Kind::kByte);
    const auto made = [&](const DataType* type) -> Object& {
        Object& object =
            p.heap.emplace_back(Object{.type = type, .shown = "argv", .place = main.name.place, .known = true});
        allocate(object, main.name.place);
        return object;
    };
    Object& name = made(types_.array_of(character, kName.size() + 1));
    std::memcpy(name.memory->bytes.data(), kName.data(), kName.size());
    Object& words = made(types_.array_of(types_.pointer_to(character), 2));
    assigned({&words, 0, words.type->of}, {.type = Value::Type::kPointer, .object = &name, .of = character},
             words.place);
    given[1] = {.type = Value::Type::kPointer, .object = &words, .of = words.type->of};
    return given;
}

// Ends all functions but main, after an error.
void Reader::leave_functions() {
    Program& p = *program_;
    forget_literals();
    forget_locals(p.kept_locals.value_or(0));
    p.frame = p.block = p.depth = 0;
    p.in_function = dry_ = false;
    nesting_ = 0;
}

// Calls a function of the program; false, and without its commands, where it uses what cannot be read.
bool Reader::calls_from_glut(const Callback& callback, const std::vector<Value>& given) {
    const std::size_t kept = commands_.size();
    try {
        call_from_glut(callback, given);
        return true;
    } catch (const SceneError&) {
        leave_functions();
        go_to_window(1);
        commands_.resize(kept);
        return false;
    }
}

// Calls the idle or timer function; false if there is none, or it cannot be read, as where it uses the time.
bool Reader::tick() {
    const Program& p = *program_;
    if (p.idle) return calls_from_glut(*p.idle, {});
    return p.timer && calls_from_glut(*p.timer, {p.timer_value});
}

// The characters that a keyboard function compares its key with: 'a' in case 'a': or key == 'a'.
std::vector<std::string_view> Reader::keys_of(const Function& function) const {
    const std::vector<Token>& tokens = program_->tokens;
    std::vector<std::string_view> keys;
    for (std::size_t i = function.body; i < program_->partners[function.body]; ++i)
        if (tokens[i].kind == TokenKind::kNumber && tokens[i].text.starts_with("'") &&
            (tokens[i - 1].is("case") || tokens[i - 1].is("==")))
            keys.push_back(tokens[i].text);
    return keys;
}

// The picture after the first key that changes it; nullopt if none does. Keys that end the program, or that cannot be read, are left out.
std::optional<LaterPicture> Reader::picture_after_key() {
    Program& p = *program_;
    if (!p.keyboard) return std::nullopt;
    const auto function = p.functions.find(p.keyboard->function.text);
    if (function == p.functions.end()) return std::nullopt;
    const auto same = [](const Command& a, const Command& b) { return a.id == b.id && a.arguments == b.arguments; };
    commands_.clear();
    if (!calls_from_glut(*p.display, {})) return std::nullopt;
    const std::vector<Command> before = std::exchange(commands_, {});
    constexpr std::size_t kMostKeys = 10;
    std::vector<std::string_view> keys = keys_of(function->second);
    if (keys.size() > kMostKeys) keys.resize(kMostKeys);
    for (const std::string_view key : keys) {
        commands_.clear();
        std::vector<Value> given(function->second.parameters.size(), integer(0));
        if (!given.empty()) given[0] = integer(character_code(key));
        if (!calls_from_glut(*p.keyboard, given) || !calls_from_glut(*p.display, {})) continue;
        if (!std::ranges::equal(commands_, before, same))
            return LaterPicture{.when = fmt::format("after the key {}", key),
                                .commands = std::move(commands_),
                                .start = {},
                                .is_after_key = true};
    }
    return std::nullopt;
}

std::vector<LaterPicture> Reader::later_pictures() {
    constexpr std::size_t kMostCommands = 100'000;  // of a picture that is drawn more often
    constexpr int kPicturesOfASecond = 1000 / kFrameMs;
    Program& p = *program_;
    std::vector<LaterPicture> later;
    commands_.clear();
    p.elapsed_ms += kFrameMs;
    bool moves = tick();
    if (!calls_from_glut(*p.display, {})) return later;
    later.push_back({.when = "from the second picture on", .commands = std::exchange(commands_, {}), .start = {}});
    if (later.front().commands.size() <= kMostCommands) {
        p.elapsed_ms += 1000 - kFrameMs;
        for (int i = 1; i < kPicturesOfASecond && moves && commands_.size() <= kMostCommands; ++i) moves = tick();
        if (moves && calls_from_glut(*p.display, {}))
            later.push_back({.when = "after 1 s", .commands = std::exchange(commands_, {}), .start = {}});
        if (auto picture = picture_after_key()) later.push_back(std::move(*picture));
    }
    const auto function = p.functions.find(p.display->function.text);
    for (LaterPicture& picture : later) picture.start = p.tokens[function->second.body + 1].place;
    return later;
}

void Reader::call_from_glut(const Callback& callback, std::vector<Value> given) {
    const Token& name = callback.function;
    const auto function = program_->functions.find(name.text);
    if (function == program_->functions.end()) fail(name.place, "the program has no function {}", in_quotes(name.text));
    if (callback.data) given.push_back(pointer_from(*callback.data, nullptr));
    go_to_window(1);
    run_function(function->second, given, name.place);
    go_to_window(1);
}

void Reader::read_functions() {
    const Program& p = *program_;
    while (token_.kind != TokenKind::kEnd) {
        forget_literals();
        if (accept(";")) continue;
        if (token_.kind == TokenKind::kPragma) {
            pragma();
            continue;
        }
        if (token_.kind != TokenKind::kName)
            fail(token_.place, "expected a function or a variable of the program, found {}", shown(token_));
        if (token_.is("using") && ahead_.is("namespace")) {  // using namespace std; changes nothing that is read
            skip_statement();
            continue;
        }
        for (std::string_view word : {"class", "template", "using", "namespace"})
            if (token_.is(word)) out_of_reach(token_.place, in_quotes(word));
        if (token_.is("typedef")) {
            typedef_declaration();
            continue;
        }
        if (skip_extern()) continue;
        while (token_.is("extern") || token_.is("inline") || token_.is("register")) advance();

        // A function has its parenthesis before anything else, but for the members of a struct.
        std::size_t i = p.at;
        while (p.tokens[i].kind == TokenKind::kName || p.tokens[i].is("*")) ++i;
        if (!p.tokens[i].is("(") || i == p.at || p.tokens[i - 1].is("*") || p.tokens[i + 1].is("*")) {
            declaration();
            continue;
        }
        const std::size_t after = p.partners[i] + 1;
        if (!p.tokens[after].is("{") && p.tokens[after].kind != TokenKind::kName) {  // a prototype
            program_->prototypes.emplace(p.tokens[i - 1].text, p.tokens[i - 1]);
            while (!token_.is(";") && token_.kind != TokenKind::kEnd) skip_token();
            expect(";", "after the function's parameters");
            continue;
        }
        function(i - 1);
    }
}

// Skips extern int x; whose definition, if this file has it, comes later.
bool Reader::skip_extern() {
    if (!token_.is("extern")) return false;
    const Program& p = *program_;
    std::size_t end = p.at;
    while (end + 1 < p.tokens.size() && !p.tokens[end].is(";") && !p.tokens[end].is("=") && !p.tokens[end].is("{"))
        ++end;
    if (!p.tokens[end].is(";")) return false;
    jump(end + 1);
    return true;
}

// A function; `at` is the index of its name. What cannot be read of its result and its parameters matters only if it is
// called, for a keyboard function may use anything.
void Reader::function(std::size_t at) {
    Program& p = *program_;
    Function made{.name = p.tokens[at]};
    const Token& name = made.name;
    made.body = p.partners[at + 1] + 1;
    while (!p.tokens[made.body].is("{")) {
        if (p.tokens[made.body].kind == TokenKind::kEnd) fail(name.place, "the function {} has no body", name.text);
        ++made.body;
    }
    const std::size_t nesting = nesting_, depth = p.depth;
    try {
        while (token_.is("static") || token_.is("inline") || token_.is("const")) advance();
        // main() needs no type.
        const DataType* const result = p.at == at ? types_.number(Kind::kInt) : pointers(type_name());
        if (!result->is_void()) made.result = result;
        if (p.at != at) out_of_reach(name.place, tr("the type of this function"));
        jump(at + 1);
        parameters_of(made);
    } catch (const SceneError& error) {
        made.refusal = error;
        made.parameters.clear();
        nesting_ = nesting;
        p.depth = depth;
    }
    jump(p.partners[made.body] + 1);
    const Place place = name.place;
    const auto [found, is_new] = p.functions.emplace(name.text, std::move(made));
    if (!is_new)
        fail(place, "the function {} is already defined at {}", in_quotes(found->second.name.text),
             found->second.name.place.str());
}

// From "(" to the "{" of the body. In the oldest form of C the types follow: f(a, b) int a; float b[3]; {
void Reader::parameters_of(Function& function) {
    const Program& p = *program_;
    const std::size_t close = p.partners[p.at];
    const std::string_view name = function.name.text;
    expect("(", "after the function's name");
    if (token_.is("void") && p.at + 1 == close) advance();
    if (close + 1 == function.body) {
        while (!token_.is(")")) {
            while (accept("register")) {
            }
            if (token_.is(".")) {  // the ... of printf
                while (accept(".")) {
                }
                function.takes_more = true;
                break;
            }
            function.parameters.push_back(parameter(type_name()));
            if (!accept(",")) break;
        }
        return expect(")", "after the parameters of {}", name);
    }
    while (!token_.is(")")) {
        function.parameters.push_back({.name = token_.text, .type = types_.number(Kind::kInt)});
        advance();
        if (!accept(",")) break;
    }
    expect(")", "after the parameters of {}", name);
    while (!token_.is("{")) {
        while (accept("register")) {
        }
        const DataType* const type = type_name();
        do {
            const FormalParameter typed = parameter(type);
            for (FormalParameter& parameter : function.parameters)
                if (parameter.name == typed.name) parameter = typed;
        } while (accept(","));
        expect(";", "after the types of {}'s parameters", name);
    }
}

// The rest of a parameter: *name, name[4], name[][3] or name(int). Arrays and functions come as pointers.
FormalParameter Reader::parameter(const DataType* type) {
    const Declarator made = declarator(type, true);
    if (made.type->is_void() || !made.type->is_complete)
        out_of_reach(made.name.place, tr("the parameter {}", in_quotes(made.name.text)));
    const bool is_behind_pointer = made.type->is_array() || made.type->is_function();
    const DataType* const behind = made.type->is_array() ? made.type->of : made.type;
    return {made.name.text, is_behind_pointer ? types_.pointer_to(behind) : made.type};
}

}  // namespace twinlight
