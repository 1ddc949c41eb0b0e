#include "scene/command/preprocess.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "scene/command/program.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

constexpr int kMaxMacroDepth = 64;  // macros inside macros, parentheses in #if
constexpr int kMaxIncludeDepth = 16;

struct Macro {
    bool has_parameters = false, takes_more = false;  // ... at the end takes all that are left
    std::vector<std::string_view> parameters{};
    std::vector<Token> body{};
    bool in_use = false;  // a macro does not replace its own name
};

class Preprocessor {
  public:
    Preprocessor(std::string_view text, const std::string& file, const TextLoader& load_text)
        : lexer_(text, file, Lexer::Language::kProgram),
          folder_(std::filesystem::path(file).parent_path()),
          load_text_(load_text) {}

    PreprocessedText run() {
        read_file();
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

    // Reads the text of lexer_ to its end. That of an included file has no kEnd.
    void read_file() {
        const std::size_t outer = groups_.size();
        while (true) {
            Token token = lexer_.next();
            if (token.kind == TokenKind::kDirective) {
                replace_pending();
                directive(token);
                continue;
            }
            const bool is_end = token.kind == TokenKind::kEnd;
            if (!is_end || included_in_ == 0) add(pending_, std::move(token));
            if (is_end) break;
        }
        if (groups_.size() > outer) fail(groups_.back().place, "this #if is never closed; end it with #endif");
    }

    // #include "jitter.h": reads the file if it is beside the program. Names of libraries change nothing that is read.
    void include(const Token& at, std::string_view line) {
        const std::size_t start = line.find('"'), end = line.find('"', start + 1);
        if (start != line.find_first_not_of(" \t") || end == std::string_view::npos) return;
        const std::string name(line.substr(start + 1, end - start - 1));
        const std::optional<std::string> text = load_text_ ? load_text_(name) : std::nullopt;
        if (!text) return;
        if (included_in_ >= kMaxIncludeDepth)
            fail(at.place, "#include is nested more than {} levels deep", kMaxIncludeDepth);
        included_bytes_ += text->size();
        if (included_bytes_ > kMaxSceneBytes) fail(at.place, "the included files are too large together");
        const bool is_once = text->find("#pragma once") != std::string::npos;
        const std::string file = (folder_ / name).string();
        if (is_once && result_.included.contains(file)) return;
        const std::string_view kept = result_.keep(*text);
        result_.included[file] = kept;
        Lexer outer = std::exchange(lexer_, Lexer(kept, file, Lexer::Language::kProgram));
        ++included_in_;
        read_file();
        --included_in_;
        replace_pending();
        lexer_ = std::move(outer);
    }

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
            if (at.text == "include") return include(at, lexer_.skip_line());
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
                else if (line[body].is(".") && !std::exchange(macro.takes_more, true))
                    macro.parameters.emplace_back("__VA_ARGS__");
                else if (!line[body].is(",") && !line[body].is("."))
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
        for (std::string_view known : {"M_PI", "M_PI_2", "M_PI_4", "M_SQRT2", "GL_VERSION_1_1", "GL_VERSION_1_2",
                                       "GL_VERSION_1_3", "GL_VERSION_1_4", "GL_VERSION_1_5", "GL_VERSION_2_0",
                                       "GL_VERSION_2_1", "GLU_VERSION_1_1", "GLU_VERSION_1_2", "GLU_VERSION_1_3",
                                       "GLUT_API_VERSION", "FREEGLUT", "__linux__", "__unix__", "__has_include"})
            if (name == known) return true;
        return macros_.contains(name) || find_gl_name(name) || constant_of_c(name);
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
        if (accept(rest, "__has_include")) {  // of libraries, programs have those of GLUT and C
            if (!accept(rest, "(")) fail(at.place, "expected '(' after __has_include");
            std::string name;
            for (; !rest.empty() && !rest[0].is(")"); rest = rest.subspan(1)) name += rest[0].text;
            if (!accept(rest, ")")) fail(at.place, "expected ')' in this condition");
            return static_cast<std::int64_t>(has_header(name));
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

    bool has_header(std::string_view name) const {
        if (name.starts_with('"') && load_text_ && load_text_(std::string(name.substr(1, name.size() - 2))))
            return true;
        constexpr std::string_view kKnown[] = {"GL/gl.h",  "GL/glu.h", "GL/glut.h", "GL/freeglut.h", "GL/glext.h",
                                               "math.h",   "stdio.h",  "stdlib.h",  "string.h",      "stdbool.h",
                                               "stdint.h", "time.h",   "unistd.h"};
        return name.size() > 2 && std::ranges::find(kKnown, name.substr(1, name.size() - 2)) != std::end(kKnown);
    }

    // ---- Macros ----

    void replace_pending() {
        replace(pending_, result_.tokens, nullptr, 0);
        pending_.clear();
    }

    // Appends the tokens with macros replaced. `place`, if any, is where the outermost macro is used.
    void replace(std::span<const Token> tokens, std::vector<Token>& out, const Place* place, int depth) {
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const Token& token = tokens[i];
            const Place& used_at = place ? *place : token.place;
            const auto found = token.kind == TokenKind::kName ? macros_.find(token.text) : macros_.end();
            if (token.is("__LINE__")) {
                add(out, {TokenKind::kNumber, result_.keep(std::to_string(used_at.line)), used_at});
                continue;
            }
            if (token.is("__FILE__")) {
                add(out, {TokenKind::kString, result_.keep(quoted(*used_at.file)), used_at});
                continue;
            }
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
            std::vector<std::span<const Token>> arguments;
            if (macro.has_parameters) {
                arguments = arguments_of(token, tokens, i, macro);
                if (arguments.size() != macro.parameters.size() &&
                    !(macro.parameters.empty() && arguments.size() == 1 && arguments[0].empty()))
                    fail(used_at, "the macro {} takes {} arguments, but {} are given", in_quotes(token.text),
                         macro.parameters.size(), arguments.size());
            }
            const std::vector<Token> body = body_of(macro, arguments, used_at, depth);
            macro.in_use = true;
            replace(body, out, &used_at, depth + 1);
            macro.in_use = false;
        }
    }

    // The body of a macro with its arguments: #x is the text of x in quotes, a ## b is one word.
    std::vector<Token> body_of(const Macro& macro, std::span<const std::span<const Token>> arguments,
                               const Place& used_at, int depth) {
        const std::vector<Token>& parts = macro.body;
        const auto argument = [&](std::size_t k) -> std::optional<std::size_t> {
            if (k >= parts.size() || parts[k].kind != TokenKind::kName) return {};
            const auto found = std::ranges::find(macro.parameters, parts[k].text);
            if (found == macro.parameters.end()) return {};
            return static_cast<std::size_t>(found - macro.parameters.begin());
        };
        const auto joins_at = [&](std::size_t k) {
            return k + 1 < parts.size() && parts[k].is("#") && parts[k + 1].is("#");
        };
        std::vector<Token> body;
        bool joins = false;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            if (joins_at(k)) {
                joins = !body.empty();
                ++k;
                continue;
            }
            const bool is_quoted = parts[k].is("#") && macro.has_parameters && argument(k + 1);
            if (is_quoted) ++k;
            const std::optional<std::size_t> given = argument(k);
            std::vector<Token> made;
            if (is_quoted)
                made.push_back({TokenKind::kString, result_.keep(quoted(words_of(arguments[*given]))), used_at});
            else if (!given || *given >= arguments.size())
                made.push_back(parts[k]);
            else if (joins || joins_at(k + 1))
                made.assign(arguments[*given].begin(), arguments[*given].end());
            else
                replace(arguments[*given], made, &used_at, depth + 1);
            for (Token& one : made) {
                if (std::exchange(joins, false)) {
                    body.back().text = result_.keep(std::string(body.back().text) + std::string(one.text));
                    work_ += body.back().text.size();
                } else {
                    add(body, std::move(one));
                }
            }
            joins = false;
        }
        return body;
    }

    // The words with the spaces between them.
    static std::string words_of(std::span<const Token> words) {
        std::string text;
        for (std::size_t i = 0; i < words.size(); ++i) {
            const bool touches = i > 0 && words[i - 1].text.data() + words[i - 1].text.size() == words[i].text.data();
            if (i > 0 && !touches) text += ' ';
            text += words[i].text;
        }
        return text;
    }

    static std::string quoted(std::string_view text) {
        std::string made = "\"";
        for (const char c : text) {
            if (c == '"' || c == '\\') made += '\\';
            made += c;
        }
        return made + '"';
    }

    // The arguments of a macro's use at tokens[i]. Moves i to the closing parenthesis.
    static std::vector<std::span<const Token>> arguments_of(const Token& name, std::span<const Token> tokens,
                                                            std::size_t& i, const Macro& macro) {
        std::vector<std::span<const Token>> arguments;
        std::size_t open = 0;
        std::size_t start = i + 2;
        for (std::size_t k = i + 1; k < tokens.size(); ++k) {
            if (tokens[k].is("(")) ++open;
            const bool closes = tokens[k].is(")") && --open == 0;
            const bool is_last = macro.takes_more && arguments.size() + 1 == macro.parameters.size();
            if (!closes && (is_last || open != 1 || !tokens[k].is(","))) continue;
            arguments.push_back(tokens.subspan(start, k - start));
            start = k + 1;
            if (!closes) continue;
            i = k;
            return arguments;
        }
        fail(name.place, "expected ')' after the arguments of the macro {}", in_quotes(name.text));
    }

    Lexer lexer_;
    std::filesystem::path folder_;  // of the program
    const TextLoader& load_text_;
    int included_in_ = 0;  // files
    std::size_t included_bytes_ = 0;
    std::map<std::string_view, Macro> macros_;
    std::vector<Group> groups_;
    std::vector<Token> pending_;  // read, but macros are not replaced yet
    PreprocessedText result_;
    std::size_t work_ = 0;
};

}  // namespace

PreprocessedText preprocess(std::string_view text, const std::string& file, const TextLoader& load_text) {
    return Preprocessor(text, file, load_text).run();
}

}  // namespace twinlight
