// The reader's errors: it reports several in one run, so after each it looks for the start of the next statement.
#include "scene/command/reader.h"

namespace twinlight {

bool is_like_gl(std::string_view name) {
    const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
    for (const std::string_view start : {"glut", "glu", "gl"})  // a capital follows
        if (name.starts_with(start) && name.size() > start.size() && is_upper(name[start.size()])) return true;
    return name.starts_with("GLUT_") || name.starts_with("GLU") || name.starts_with("GL_");
}

// The lexer's next token; reports the lexer's errors.
Token Reader::next_token() {
    while (true) {
        try {
            return lexer_.next();
        } catch (const SceneError& error) {
            lexical_error_line_ = error.errors.front().place.line;
            report(error);
            if (lexer_.at_end()) throw TooManyErrors();
        }
    }
}

void Reader::report(const SceneError& error) {
    errors_.insert(errors_.end(), error.errors.begin(), error.errors.end());
    if (errors_.size() >= kMaxErrorsShown) throw TooManyErrors();
}

// Reads a statement. If it has an error, reports that and skips the rest of the statement.
void Reader::statement_or_error() {
    const std::size_t tokens_at_start = tokens_;
    const int first_line = token_.place.line;
    const bool was_in_program = in_program_;
    try {
        return statement();
    } catch (const SceneError& error) {
        // The rest of a statement with a wrong character often has an error too.
        const bool follows =
            lexical_error_line_ >= first_line && error.errors.front().place.line >= lexical_error_line_;
        if (!follows) report(error);
    } catch (const FollowingError&) {
    }
    // The errors of its statements are already reported, so this is one of the function around them.
    if (in_program_ && !was_in_program) throw TooManyErrors();
    skip_rest_of_statement(tokens_at_start);
}

void Reader::skip_rest_of_statement(std::size_t tokens_at_start) {
    nesting_ = 0;
    returns_.reset();
    if (tokens_ == tokens_at_start) advance();
    while (token_.kind != TokenKind::kEnd && !at_new_statement()) {
        if (accept(";")) return;
        const bool ends_values = ahead_.is(";") || ahead_.is(",") || ahead_.is(")") || ahead_.is("}");
        if (token_.is("}") && !ends_values) {
            if (!in_program_) advance();
            return;
        }
        advance();
    }
}

// Whether a line starts here, with what looks like a statement.
bool Reader::at_new_statement() const {
    if (token_.kind == TokenKind::kPragma) return true;
    if (token_.kind != TokenKind::kName || token_.place.line == line_before_) return false;
    if (token_.is("const") || token_.is("static") || at_type()) return true;
    return ahead_.is("(") && find_command_or_extension(token_.text).has_value();
}

}  // namespace twinlight
