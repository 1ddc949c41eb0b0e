// Counts what a loop of a program will call before it runs.
#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/command/lexer.h"
#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

// What a statement calls. (Numbers of rounds have no limit, so products may be beyond whole numbers.)
struct Calls {
    double commands = 0, vertices = 0;
};

// Follows only loops of the form for (int i = 0; i < 1000; ++i) whose body runs from its start to its end in each round; others are
// counted while they run.
class LoopCounter {
  public:
    explicit LoopCounter(const Program& program) : tokens_(program.tokens), program_(program) {}

    // Counts the loop that begins at tokens_[at], which is "for", and moves `at` to its last token.
    std::optional<Calls> of_loop(std::size_t& at) {
        if (!tokens_[at + 1].is("(")) return std::nullopt;
        const std::size_t close = program_.partners[at + 1];
        std::size_t test = at + 2;
        while (test < close && !tokens_[test].is(";")) ++test;
        const std::optional<double> rounds = rounds_of(++test, close);
        if (!rounds || is_variable(tokens_[test].text)) return std::nullopt;
        variables_.push_back(tokens_[test].text);
        at = close + 1;
        std::optional<Calls> calls = of_statement(at);
        variables_.pop_back();
        if (!calls) return std::nullopt;
        return Calls{*rounds * calls->commands, *rounds * calls->vertices};
    }

  private:
    bool is_variable(std::string_view name) const { return std::ranges::find(variables_, name) != variables_.end(); }

    // `test` is the index of the condition, `close` that of the ")".
    std::optional<double> rounds_of(std::size_t test, std::size_t close) const {
        if (close != test + 6 || !tokens_[test - 1].is(";") || !tokens_[test - 3].is("=")) return std::nullopt;
        const std::string_view name = tokens_[test].text;
        const auto start = whole_number(tokens_[test - 2].text), end = whole_number(tokens_[test + 2].text);
        const bool is_equal_too = tokens_[test + 1].is("<=");
        const Token &a = tokens_[test + 4], &b = tokens_[test + 5];
        const bool steps = (a.text == name && b.is("++")) || (a.is("++") && b.text == name);
        if (!start || !end || tokens_[test - 4].text != name || !(is_equal_too || tokens_[test + 1].is("<")) ||
            !tokens_[test + 3].is(";") || !steps || *end <= *start)
            return std::nullopt;
        return static_cast<double>(*end) - static_cast<double>(*start) + (is_equal_too ? 1 : 0);
    }

    // Counts the statement that begins at tokens_[at], and moves `at` to its last token.
    std::optional<Calls> of_statement(std::size_t& at) {
        const bool is_block = tokens_[at].is("{");
        const std::size_t end = is_block ? program_.partners[at] : tokens_.size();
        Calls calls;
        for (; at < end && (is_block || !tokens_[at].is(";")); ++at) {
            if (!tokens_[at].is("for")) {
                if (!count_token(at, calls)) return std::nullopt;
                continue;
            }
            const std::optional<Calls> inner = of_loop(at);
            if (!inner) return std::nullopt;
            calls.commands += inner->commands;
            calls.vertices += inner->vertices;
            if (!is_block) break;
        }
        return calls;
    }

    // False if what is called does not follow from the token.
    bool count_token(std::size_t at, Calls& calls) const {
        constexpr std::string_view kElsewhere[] = {"while",    "do",     "if",   "else", "switch", "break",
                                                   "continue", "return", "goto", "?",    "&&",     "||"};
        const Token& token = tokens_[at];
        if (std::ranges::find(kElsewhere, token.text) != std::end(kElsewhere)) return false;
        if (token.kind == TokenKind::kPragma || token.kind == TokenKind::kEnd) return false;
        if (is_variable(token.text)) {
            const std::string_view after = tokens_[at + 1].text;
            const bool changes = tokens_[at + 1].is("=") || is_step(tokens_[at + 1]) || is_step(tokens_[at - 1]) ||
                                 tokens_[at - 1].is("&") || (after.size() == 2 && after[1] == '=');
            if (changes) return false;
        }
        if (token.kind != TokenKind::kName || !tokens_[at + 1].is("(")) return true;
        if (program_.functions.contains(token.text) || token.text.starts_with("glut")) return false;
        if (!token.text.starts_with("gl")) return true;
        ++calls.commands;
        if (token.text.starts_with("glVertex") && !token.text.starts_with("glVertexP")) ++calls.vertices;
        return !token.is("glBegin") && !token.is("glEnd");
    }

    const std::vector<Token>& tokens_;
    const Program& program_;
    std::vector<std::string_view> variables_;  // of the loops that are being counted
};

}  // namespace

// Refuses a loop that would send more vertices than fit, or call more commands than a program can.
void Reader::check_length_of_for(std::size_t loop) {
    Program& p = *program_;
    const Place& place = p.tokens[loop].place;
    std::size_t end = loop;
    const std::optional<Calls> calls = LoopCounter(p).of_loop(end);
    // What adds little is counted while it runs: counting first would take longer.
    const auto before = static_cast<double>(commands_.size());
    if (!calls || calls->commands < before / 2) return;
    if (before + calls->commands > static_cast<double>(kMaxProgramCommands))
        fail(place,
             "this loop would call {:.0f} commands; a program can call at most {} commands before its first picture "
             "is complete",
             calls->commands, kMaxProgramCommands);
    const auto opened = std::find_if(commands_.rbegin(), commands_.rend(), [](const Command& c) {
        return c.id == CommandId::glBegin || c.id == CommandId::glEnd || c.id == CommandId::glNewList;
    });
    const bool in_list = std::ranges::any_of(commands_, [](const Command& c) { return c.id == CommandId::glNewList; });
    if (calls->vertices == 0 || !p.options.fits || opened == commands_.rend() || opened->id != CommandId::glBegin ||
        in_list)
        return;
    if (!p.options.fits(opened->enumerant(0), static_cast<std::size_t>(calls->vertices)))
        fail(place,
             "this loop sends {:.0f} vertices, which need more memory than is allowed; draw fewer vertices, or run "
             "twinlight with a larger --memory",
             calls->vertices);
}

}  // namespace twinlight
