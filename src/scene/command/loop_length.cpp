// Counts what a loop of a program will call before it runs.
#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include "scene/command/lexer.h"
#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

// The rounds of for (int i = 0; i < 1000; ++i): nullopt for loops of another form. `test` is the index of the condition, `close` that of
// the ")". The name is the loop's variable.
std::optional<std::size_t> rounds_of(const std::vector<Token>& tokens, std::size_t test, std::size_t close) {
    if (test < 4 || close != test + 6 || !tokens[test - 1].is(";") || !tokens[test - 3].is("=")) return std::nullopt;
    const std::string_view name = tokens[test].text;
    const auto start = whole_number(tokens[test - 2].text), end = whole_number(tokens[test + 2].text);
    const bool is_equal_too = tokens[test + 1].is("<=");
    const Token &a = tokens[test + 4], &b = tokens[test + 5];
    const bool steps = (a.text == name && b.is("++")) || (a.is("++") && b.text == name);
    if (!start || !end || tokens[test - 4].text != name || !(is_equal_too || tokens[test + 1].is("<")) ||
        !tokens[test + 3].is(";") || !steps || *end <= *start)
        return std::nullopt;
    return static_cast<std::size_t>(*end - *start) + (is_equal_too ? 1 : 0);
}

}  // namespace

// Refuses a loop that would send more vertices than fit, or call more commands than a program can. Follows only loops whose body runs
// from its start to its end in each round; others are counted while they run.
void Reader::check_length_of_for(std::size_t loop, std::size_t test, std::size_t close) {
    Program& p = *program_;
    const std::vector<Token>& tokens = p.tokens;
    const std::optional<std::size_t> rounds = rounds_of(tokens, test, close);
    if (!rounds || close + 1 >= tokens.size()) return;
    const bool is_block = tokens[close + 1].is("{");
    const std::size_t end = is_block ? p.partners[close + 1] : tokens.size();
    std::size_t commands = 0, vertices = 0;
    for (std::size_t i = close + 1; i < end && (is_block || !tokens[i].is(";")); ++i) {
        const Token& token = tokens[i];
        constexpr std::string_view kElsewhere[] = {"for",      "while",  "do",   "if", "else", "switch", "break",
                                                   "continue", "return", "goto", "?",  "&&",   "||"};
        if (std::ranges::find(kElsewhere, token.text) != std::end(kElsewhere)) return;
        if (token.kind == TokenKind::kPragma || token.kind == TokenKind::kEnd) return;
        if (token.text == tokens[test].text) {
            const bool changes = tokens[i + 1].is("=") || is_step(tokens[i + 1]) || is_step(tokens[i - 1]) ||
                                 tokens[i - 1].is("&") ||
                                 (tokens[i + 1].text.size() == 2 && tokens[i + 1].text[1] == '=');
            if (changes) return;
        }
        if (token.kind != TokenKind::kName || !tokens[i + 1].is("(")) continue;
        if (p.functions.contains(token.text) || token.text.starts_with("glut")) return;
        if (!token.text.starts_with("gl")) continue;
        ++commands;
        if (token.text.starts_with("glVertex") && !token.text.starts_with("glVertexP")) ++vertices;
        if (token.is("glBegin") || token.is("glEnd")) return;
    }
    if (commands > 0 && *rounds > (kMaxProgramCommands - std::min(commands_.size(), kMaxProgramCommands)) / commands)
        fail(tokens[loop].place,
             "this loop would call {} commands; a program can call at most {} commands before its first picture is "
             "complete",
             *rounds * commands, kMaxProgramCommands);
    const auto opened = std::find_if(commands_.rbegin(), commands_.rend(), [](const Command& c) {
        return c.id == CommandId::glBegin || c.id == CommandId::glEnd || c.id == CommandId::glNewList;
    });
    const bool in_list = std::ranges::any_of(commands_, [](const Command& c) { return c.id == CommandId::glNewList; });
    if (vertices == 0 || !p.options.fits || opened == commands_.rend() || opened->id != CommandId::glBegin || in_list)
        return;
    if (!p.options.fits(opened->enumerant(0), *rounds * vertices))
        fail(tokens[loop].place,
             "this loop sends {} vertices, which need more memory than is allowed; draw fewer vertices, or run "
             "twinlight with a larger --memory",
             *rounds * vertices);
}

}  // namespace twinlight
