#include "scene/command/preprocess.h"

#include <algorithm>
#include <map>
#include <span>

#include "scene/command/text.h"

namespace twinlight {

namespace {

constexpr int kMaxMacroDepth = 64;  // macros inside macros, parentheses in #if

struct Macro {
    bool has_parameters = false;
    std::vector<std::string_view> parameters{};
    std::vector<Token> body{};
    bool in_use = false;  // a macro does not replace its own name
};

class Preprocessor {
  public:
    Preprocessor(std::string_view text, const std::string& file) : lexer_(text, file, Lexer::Language::kProgram) {}

    std::vector<Token> run() {
        while (true) {
            Token token = lexer_.next();
            if (token.kind == TokenKind::kDirective) {
                replace_pending();
                directive(token);
                continue;
            }
            const bool is_end = token.kind == TokenKind::kEnd;
            add(pending_, std::move(token));
            if (is_end) break;
        }
        if (!groups_.empty()) fail(groups_.back().place, "this #if is never closed; end it with #endif");
        replace_pending();
        return std::move(result_);
    }

  private:
    // The lines between #if and #endif.
    struct Group {
        Place place;
        bool taken = false;  // whether one of its branches was read
        bool has_else = false;
    };

    void add(std::vector<Token>& tokens, Token token) {
        if (++work_ > 4 * kMaxProgramTokens || tokens.size() >= kMaxProgramTokens)
            fail(token.place, "a program can have at most {} words and signs after its macros are replaced",
                 kMaxProgramTokens);
        tokens.push_back(std::move(token));
    }

    std::vector<Token> rest_of_line() {
        std::vector<Token> line;
        while (true) {
            Token token = lexer_.next();
            if (token.kind == TokenKind::kLineEnd || token.kind == TokenKind::kEnd) return line;
            add(line, std::move(token));
        }
    }

    // Steps over the branches that are not read, up to the one that is, or to #endif.
    void directive(Token at) {
        while (true) {
            if (at.text == "define") return define(at, rest_of_line());
            if (at.text == "undef") {
                const std::vector<Token> line = rest_of_line();
                if (!line.empty()) macros_.erase(line[0].text);
                return;
            }
            bool taken = false;
            if (at.text == "if" || at.text == "ifdef" || at.text == "ifndef") {
                if (groups_.size() >= kMaxMacroDepth)
                    fail(at.place, "#if is nested more than {} levels deep", kMaxMacroDepth);
                groups_.push_back({at.place});
                taken = holds(at, rest_of_line());
            } else {
                if (groups_.empty()) fail(at.place, "#{} without #if", at.text);
                Group& group = groups_.back();
                const std::vector<Token> line = rest_of_line();
                if (at.text == "endif") {
                    groups_.pop_back();
                    return;
                }
                if (group.has_else) fail(at.place, "#{} after #else", at.text);
                group.has_else = at.text == "else";
                taken = !group.taken && (group.has_else || holds(at, line));
            }
            groups_.back().taken |= taken;
            if (taken) return;
            at = skip_branch();
        }
    }

    // The directive that ends the branch: #elif, #else or #endif of the innermost group.
    Token skip_branch() {
        std::size_t inner = 0;
        while (true) {
            lexer_.skip_to_directive();
            Token token = lexer_.next();
            if (token.kind == TokenKind::kEnd)
                fail(groups_.back().place, "this #if is never closed; end it with #endif");
            if (token.kind != TokenKind::kDirective) continue;
            if (inner == 0 && (token.text == "elif" || token.text == "else" || token.text == "endif")) return token;
            if (token.text == "endif") --inner;
            if (token.text.starts_with("if")) ++inner;
        }
    }

    void define(const Token& at, std::vector<Token> line) {
        if (line.empty() || line[0].kind != TokenKind::kName) fail(at.place, "#define needs a name");
        Macro macro;
        std::size_t body = 1;
        // Parameters follow the name without a space.
        const bool touches = line.size() > 1 && line[0].text.data() + line[0].text.size() == line[1].text.data();
        if (touches && line[1].is("(")) {
            macro.has_parameters = true;
            for (body = 2; body < line.size() && !line[body].is(")"); ++body) {
                if (line[body].kind == TokenKind::kName)
                    macro.parameters.push_back(line[body].text);
                else if (!line[body].is(","))
                    fail(line[body].place, "expected the name of a parameter of the macro {}", in_quotes(line[0].text));
            }
            if (body++ >= line.size()) fail(at.place, "expected ')' after the parameters of the macro");
        }
        const std::string_view name = line[0].text;
        for (; body < line.size(); ++body) macro.body.push_back(std::move(line[body]));
        macros_[name] = std::move(macro);
    }

    // ---- Conditions ----

    bool is_defined(std::string_view name) const {
        for (std::string_view known :
             {"M_PI", "M_PI_2", "M_PI_4", "M_SQRT2", "GL_VERSION_1_1", "GL_VERSION_1_2", "GL_VERSION_1_3",
              "GL_VERSION_1_4", "GL_VERSION_1_5", "GL_VERSION_2_0", "GL_VERSION_2_1", "GLU_VERSION_1_1",
              "GLU_VERSION_1_2", "GLU_VERSION_1_3", "GLUT_API_VERSION", "FREEGLUT", "__linux__", "__unix__"})
            if (name == known) return true;
        return macros_.contains(name) || find_gl_name(name).has_value();
    }

    bool holds(const Token& at, const std::vector<Token>& line) {
        if (line.empty()) fail(at.place, "#{} needs a condition", at.text);
        if (at.text == "ifdef") return is_defined(line[0].text);
        if (at.text == "ifndef") return !is_defined(line[0].text);
        std::span<const Token> rest = line;
        const std::int64_t value = any_of(at, rest, 0);
        if (!rest.empty()) refuse(rest[0]);
        return value != 0;
    }

    [[noreturn]] static void refuse(const Token& token) {
        fail(token.place, "a program's #if can use numbers, names, defined(...), !, &&, || and comparisons only");
    }

    static bool accept(std::span<const Token>& rest, std::string_view text) {
        if (rest.empty() || !rest[0].is(text)) return false;
        rest = rest.subspan(1);
        return true;
    }

    std::int64_t any_of(const Token& at, std::span<const Token>& rest, int depth) {
        std::int64_t value = all_of(at, rest, depth);
        while (accept(rest, "||")) value = static_cast<std::int64_t>((all_of(at, rest, depth) != 0) | (value != 0));
        return value;
    }

    std::int64_t all_of(const Token& at, std::span<const Token>& rest, int depth) {
        std::int64_t value = compared(at, rest, depth);
        while (accept(rest, "&&")) value = static_cast<std::int64_t>((compared(at, rest, depth) != 0) & (value != 0));
        return value;
    }

    std::int64_t compared(const Token& at, std::span<const Token>& rest, int depth) {
        const std::int64_t a = term(at, rest, depth);
        const auto other = [&] { return term(at, rest, depth); };
        if (accept(rest, "==")) return static_cast<std::int64_t>(a == other());
        if (accept(rest, "!=")) return static_cast<std::int64_t>(a != other());
        if (accept(rest, "<=")) return static_cast<std::int64_t>(a <= other());
        if (accept(rest, ">=")) return static_cast<std::int64_t>(a >= other());
        if (accept(rest, "<")) return static_cast<std::int64_t>(a < other());
        if (accept(rest, ">")) return static_cast<std::int64_t>(a > other());
        return a;
    }

    std::int64_t term(const Token& at, std::span<const Token>& rest, int depth) {
        if (depth > kMaxMacroDepth) fail(at.place, "this condition is nested more than {} levels deep", kMaxMacroDepth);
        if (accept(rest, "!")) return static_cast<std::int64_t>(term(at, rest, depth + 1) == 0);
        if (accept(rest, "(")) {
            const std::int64_t value = any_of(at, rest, depth + 1);
            if (!accept(rest, ")")) fail(at.place, "expected ')' in this condition");
            return value;
        }
        if (accept(rest, "defined")) {
            const bool in_parentheses = accept(rest, "(");
            if (rest.empty()) fail(at.place, "expected a name after defined");
            const bool value = is_defined(rest[0].text);
            rest = rest.subspan(1);
            if (in_parentheses && !accept(rest, ")")) fail(at.place, "expected ')' in this condition");
            return static_cast<std::int64_t>(value);
        }
        if (rest.empty()) fail(at.place, "expected a number or a name in this condition");
        const Token token = rest[0];
        rest = rest.subspan(1);
        if (const auto found = macros_.find(token.text); found != macros_.end()) {
            std::span<const Token> body = found->second.body;
            const std::int64_t value = body.empty() ? 0 : term(at, body, depth + 1);
            if (!body.empty()) refuse(body[0]);
            return value;
        }
        if (token.kind != TokenKind::kNumber) return 0;  // C takes unknown names as 0
        const std::optional<std::int64_t> value = whole_number(token.text);
        if (!value) fail(token.place, "{} is not a whole number", in_quotes(token.text));
        return *value;
    }

    // ---- Macros ----

    void replace_pending() {
        replace(pending_, result_, nullptr, 0);
        pending_.clear();
    }

    // Appends the tokens with macros replaced. `place`, if any, is where the outermost macro is used.
    void replace(std::span<const Token> tokens, std::vector<Token>& out, const Place* place, int depth) {
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const Token& token = tokens[i];
            const Place& used_at = place ? *place : token.place;
            const auto found = token.kind == TokenKind::kName ? macros_.find(token.text) : macros_.end();
            const bool is_call = i + 1 < tokens.size() && tokens[i + 1].is("(");
            if (found == macros_.end() || found->second.in_use || (found->second.has_parameters && !is_call)) {
                add(out, {token.kind, token.text, used_at});
                continue;
            }
            if (depth >= kMaxMacroDepth) fail(used_at, "macros are nested more than {} levels deep", kMaxMacroDepth);
            if (++work_ > 4 * kMaxProgramTokens)
                fail(used_at, "macros make this program too long; it can have at most {} words and signs",
                     kMaxProgramTokens);
            Macro& macro = found->second;
            if (std::any_of(macro.body.begin(), macro.body.end(), [](const Token& part) { return part.is("#"); }))
                fail(used_at,
                     "reading a program cannot follow '#' in the macro {}; run and record it: twinlight record {}",
                     in_quotes(token.text), used_at.file ? *used_at.file : "PROGRAM.c");
            std::vector<Token> body;
            if (macro.has_parameters) {
                const auto arguments = arguments_of(token, tokens, i);
                if (arguments.size() != macro.parameters.size() &&
                    !(macro.parameters.empty() && arguments.size() == 1 && arguments[0].empty()))
                    fail(used_at, "the macro {} takes {} arguments, but {} are given", in_quotes(token.text),
                         macro.parameters.size(), arguments.size());
                std::vector<std::vector<Token>> replaced(macro.parameters.size());
                for (std::size_t a = 0; a < replaced.size(); ++a)
                    replace(arguments[a], replaced[a], &used_at, depth + 1);
                for (const Token& part : macro.body) {
                    const auto parameter = std::find(macro.parameters.begin(), macro.parameters.end(), part.text);
                    if (part.kind != TokenKind::kName || parameter == macro.parameters.end())
                        add(body, part);
                    else
                        for (const Token& given :
                             replaced[static_cast<std::size_t>(parameter - macro.parameters.begin())])
                            add(body, given);
                }
            }
            macro.in_use = true;
            replace(macro.has_parameters ? body : macro.body, out, &used_at, depth + 1);
            macro.in_use = false;
        }
    }

    // The arguments of a macro's use at tokens[i]. Moves i to the closing parenthesis.
    static std::vector<std::span<const Token>> arguments_of(const Token& name, std::span<const Token> tokens,
                                                            std::size_t& i) {
        std::vector<std::span<const Token>> arguments;
        std::size_t open = 0;
        std::size_t start = i + 2;
        for (std::size_t k = i + 1; k < tokens.size(); ++k) {
            if (tokens[k].is("(")) ++open;
            const bool closes = tokens[k].is(")") && --open == 0;
            if (!closes && !(open == 1 && tokens[k].is(","))) continue;
            arguments.push_back(tokens.subspan(start, k - start));
            start = k + 1;
            if (!closes) continue;
            i = k;
            return arguments;
        }
        fail(name.place, "expected ')' after the arguments of the macro {}", in_quotes(name.text));
    }

    Lexer lexer_;
    std::map<std::string_view, Macro> macros_;
    std::vector<Group> groups_;
    std::vector<Token> pending_;  // read, but macros are not replaced yet
    std::vector<Token> result_;
    std::size_t work_ = 0;
};

}  // namespace

std::vector<Token> preprocess(std::string_view text, const std::string& file) { return Preprocessor(text, file).run(); }

}  // namespace twinlight
