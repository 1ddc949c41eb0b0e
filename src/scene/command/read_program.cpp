// Reads a whole GLUT program: its functions and global variables, then its run in GLUT's order.
#include <fmt/format.h>

#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

Reader::Reader(std::vector<Token> tokens, const std::string& file, const ImageLoader& load_image,
               const ProgramOptions& options)
    : lexer_("", file), program_(std::make_unique<Program>()), load_image_(load_image) {
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
    run_function(main->second, {}, place);
    if (!std::exchange(p.reached_main_loop, false))
        fail(place, "main ends before it calls glutMainLoop, so nothing is drawn");
    if (!p.display) fail(place, "this program has no display function; register it: glutDisplayFunc(display);");
    if (p.reshape) call_from_glut(*p.reshape, {integer(p.window.width), integer(p.window.height)});
    call_from_glut(*p.display, {});
    CommandList list{name, std::move(commands_)};
    list.window = p.window;
    return list;
}

void Reader::call_from_glut(const Token& name, const std::vector<Value>& given) {
    const auto function = program_->functions.find(name.text);
    if (function == program_->functions.end()) fail(name.place, "the program has no function {}", in_quotes(name.text));
    run_function(function->second, given, name.place);
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
        for (std::string_view word : {"typedef", "struct", "union", "class", "template", "using", "namespace"})
            if (token_.is(word)) out_of_reach(token_.place, in_quotes(word));
        if (token_.is("enum")) {
            enumeration();
            continue;
        }
        while (token_.is("extern") || token_.is("inline") || token_.is("register")) advance();

        // A function has its parenthesis before anything else.
        std::size_t i = p.at;
        while (p.tokens[i].kind == TokenKind::kName || p.tokens[i].is("*")) ++i;
        if (!p.tokens[i].is("(") || i == p.at) {
            declaration();
            continue;
        }
        const std::size_t after = p.partners[i] + 1;
        if (!p.tokens[after].is("{")) {  // a prototype
            while (!token_.is(";") && token_.kind != TokenKind::kEnd) skip_token();
            expect(";", "after the function's parameters");
            continue;
        }
        while (token_.is("static") || token_.is("inline") || token_.is("const")) advance();
        std::optional<Kind> result;
        if (ahead_.is("("))  // main(), without a type
            result = Kind::kInt;
        else if (token_.is("void") || token_.is("GLvoid"))
            advance();
        else
            result = type_name();
        while (token_.kind == TokenKind::kName && ahead_.kind == TokenKind::kName) advance();  // CALLBACK
        function(result);
    }
}

// The rest of a function, from its name on.
void Reader::function(std::optional<Kind> result) {
    Program& p = *program_;
    const Token name = token_;
    if (name.is("*")) out_of_reach(name.place, "a function that returns a pointer");
    advance();
    Function made{.name = name, .result = result};
    const std::size_t close = p.partners[p.at];
    expect("(", "after the function's name");
    if (name.is("main") || (token_.is("void") && p.at + 1 == close)) jump(close);
    while (!token_.is(")")) {
        while (token_.is("const") || token_.is("register")) advance();
        FormalParameter parameter;
        const bool is_text = at_byte_type();
        if (token_.is("void") && ahead_.is("(")) out_of_reach(token_.place, "a pointer to a function");
        if (is_text && !token_.is("char"))
            advance();
        else
            parameter.kind = type_name();
        if (is_text) parameter.kind = Kind::kByte;
        parameter.is_array = accept("*") && parameter.kind != Kind::kQuadric;
        while (accept("const")) {
        }
        if (token_.is("*") || token_.is("(")) out_of_reach(token_.place, "a pointer to a pointer");
        parameter.name = token_.text;
        if (token_.kind == TokenKind::kName) advance();
        if (token_.is("[")) {
            const Dimensions lengths = dimensions_in_brackets();
            if (parameter.is_array) out_of_reach(token_.place, "a pointer to a pointer");
            parameter.is_array = true;
            parameter.row.assign(lengths.begin() + 1, lengths.end());
        }
        made.parameters.push_back(std::move(parameter));
        if (!accept(",")) break;
    }
    expect(")", "after the parameters of {}", name.text);
    made.body = p.at;
    const auto [found, is_new] = p.functions.emplace(name.text, std::move(made));
    if (!is_new)
        fail(name.place, "the function {} is already defined at {}", in_quotes(name.text),
             found->second.name.place.str());
    jump(p.partners[p.at] + 1);
}

// enum { kA, kB = 3 };
void Reader::enumeration() {
    const Place place = token_.place;
    advance();
    if (token_.kind == TokenKind::kName) advance();
    if (!token_.is("{")) out_of_reach(place, "variables of an enum type");
    advance();
    Value next = integer(0);
    while (!token_.is("}")) {
        const Token name = token_;
        if (name.kind != TokenKind::kName) fail(name.place, "expected a name in enum, found {}", shown(name));
        advance();
        if (accept("=")) next = number();
        if (!next.is_integer()) fail(name.place, "{} must be a whole number", in_quotes(name.text));
        program_->constants[name.text] = next;
        next = in_kind(integer(next.integer < 0x7fffffff ? next.integer + 1 : 0), Kind::kInt, name.place);
        if (!accept(",")) break;
    }
    expect("}", "after the names of the enum");
    if (!token_.is(";")) out_of_reach(place, "variables of an enum type");
    advance();
}

}  // namespace twinlight
