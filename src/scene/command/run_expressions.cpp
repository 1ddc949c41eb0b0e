// Evaluates what only a whole program's expressions have: conditions, more operators, assignments.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

constexpr int kOr = 1, kAnd = 2;

// The rank of an operator between two operands that binds less than '+'; 0 for other tokens.
int rank(const Token& token) {
    if (token.kind != TokenKind::kPunctuation) return 0;
    const std::string_view text = token.text;
    const auto by_text = [&](std::initializer_list<std::pair<std::string_view, int>> rows) {
        for (const auto& [known, value] : rows)
            if (text == known) return value;
        return 0;
    };
    switch (text[0]) {
        case '|': return by_text({{"||", kOr}, {"|", 3}});
        case '&': return by_text({{"&&", kAnd}, {"&", 5}});
        case '^': return by_text({{"^", 4}});
        case '=': return by_text({{"==", 6}});
        case '!': return by_text({{"!=", 6}});
        case '<': return by_text({{"<", 7}, {"<=", 7}, {"<<", 8}});
        case '>': return by_text({{">", 7}, {">=", 7}, {">>", 8}});
        default: return 0;
    }
}

bool is_compound_assignment(const Token& token) {
    constexpr std::string_view kAll[] = {"+=", "-=", "*=", "/=", "%=", "|=", "&=", "^=", "<<=", ">>="};
    return token.kind == TokenKind::kPunctuation && token.text.size() > 1 && token.text.back() == '=' &&
           std::find(std::begin(kAll), std::end(kAll), token.text) != std::end(kAll);
}

}  // namespace

bool Reader::is_true(const Value& value) {
    if (value.is_pointer()) return value.object != nullptr || value.offset != 0;
    return value.number() != 0;
}

// The value as C converts it: real numbers lose their fraction, whole ones wrap around.
Value Reader::in_kind(const Value& value, Kind kind, const Place& place) const {
    if (value.is_pointer()) {
        if (kind == Kind::kQuadric && !value.object) return integer(0);  // NULL
        fail(place, "this is an array or a pointer, but a number is needed here");
    }
    if (is_real(kind)) return real(value.number(), kind == Kind::kFloat);
    constexpr double kLargest = 0x1p53;  // doubles hold these whole numbers exactly
    const double whole = std::trunc(value.number());
    const bool wraps = value.is_integer() && size_of(kind) < sizeof(value.integer);
    if (!wraps && !(std::abs(whole) <= kLargest)) {
        if (dry_) return integer(0);
        fail(place, "{} is too large for a whole number", value.number());
    }
    const std::int64_t exact = value.is_integer() ? value.integer : static_cast<std::int64_t>(whole);
    switch (size_of(kind)) {
        case 1:
            if (kind == Kind::kByte) return integer(static_cast<std::int8_t>(exact));
            return integer(static_cast<std::uint8_t>(exact));
        case 2:
            if (kind == Kind::kShort) return integer(static_cast<std::int16_t>(exact));
            return integer(static_cast<std::uint16_t>(exact));
        case 4:
            if (c_type(kind) == Kind::kInt) return integer(static_cast<std::int32_t>(exact));
            return integer(static_cast<std::uint32_t>(exact));
        default: return integer(exact);
    }
}

// ---- Operators ----

// a ? b : c. The operand that is not chosen is read for its type: of 1 and 0.5 C makes two doubles.
Value Reader::conditional() {
    const Value test = binary(kOr);
    if (!token_.is("?")) return test;
    advance();
    const bool outer = dry_;
    dry_ = outer || !is_true(test);
    const Value first = expression();
    dry_ = outer || is_true(test);
    expect(":", "after the first choice of ?");
    const Value second = expression();
    dry_ = outer;
    const Value& chosen = is_true(test) ? first : second;
    if (first.is_pointer() || second.is_pointer() || (first.is_integer() && second.is_integer())) return chosen;
    return real(chosen.number(), first.type != Value::Type::kDouble && second.type != Value::Type::kDouble);
}

Value Reader::binary(int lowest) {
    Value left = sum();
    while (true) {
        const int found = rank(token_);
        if (found == 0 || found < lowest) return left;
        const Token op = token_;
        advance();
        if (found <= kAnd) {
            const bool value = is_true(left);
            const bool is_decided = dry_ || value == (found == kOr);
            if (is_decided)
                skip_operand(found);
            else
                left = binary(found + 1);
            left = integer(static_cast<std::int64_t>(is_decided ? value : is_true(left)));
        } else {
            const Value right = binary(found + 1);
            left = combined(op, left, right);
        }
    }
}

// Skips the right side of an operator, up to one that binds as much or less.
void Reader::skip_operand(int lowest) {
    while (token_.kind != TokenKind::kEnd) {
        const int found = rank(token_);
        if (found != 0 && found < lowest) return;
        if (token_.kind == TokenKind::kPunctuation &&
            std::string_view(")]},;?:").find(token_.text) != std::string::npos)
            return;
        skip_token();
    }
}

Value Reader::combined(const Token& op, const Value& a, const Value& b) const {
    const std::string_view text = op.text;
    const bool is_comparison = text == "==" || text == "!=" || text[0] == '<' || text[0] == '>';
    if (is_comparison && text != "<<" && text != ">>") {
        if (a.is_pointer() || b.is_pointer()) {
            const bool same = !is_true(a) && !is_true(b);
            if ((is_true(a) && is_true(b)) || (text != "==" && text != "!="))
                out_of_reach(op.place, "a comparison of two pointers");
            return integer(static_cast<std::int64_t>((text == "==") == same));
        }
        // Floats and whole numbers of up to 53 bits are doubles exactly.
        const double x = a.number(), y = b.number();
        const bool holds = text == "=="   ? x == y
                           : text == "!=" ? x != y
                           : text == "<"  ? x < y
                           : text == "<=" ? x <= y
                           : text == ">"  ? x > y
                                          : x >= y;
        return integer(static_cast<std::int64_t>(holds));
    }
    if (text.size() == 1 && std::string_view("+-*/%|").find(text[0]) != text.npos) return arithmetic(op, a, b);
    if (!a.is_integer() || !b.is_integer()) fail(op.place, "{} needs whole numbers", in_quotes(text));
    if (text == "&") return integer(a.integer & b.integer);
    if (text == "^") return integer(a.integer ^ b.integer);
    if (b.integer < 0 || b.integer > 31) {
        if (dry_) return integer(0);
        fail(op.place, "a shift must be from 0 to 31");
    }
    if (text == "<<")
        return in_kind(integer(static_cast<std::int32_t>(a.integer) * (std::int64_t{1} << b.integer)),
                       a.integer > 0x7fffffff ? Kind::kUint : Kind::kInt, op.place);
    return integer(a.integer >> b.integer);
}

// An operand with the operators before it: !a, ~a, ++a, --a, *a.
Value Reader::prefix() {
    const Token op = token_;
    if (op.kind != TokenKind::kPunctuation || op.is("(") || op.is("&")) return primary();
    if (op.is("*")) return dereferenced();
    if (is_step(op)) {
        advance();
        if (token_.is("*") || (token_.is("(") && ahead_.is("*"))) return stepped_behind_star(op);
        const Token name = token_;
        advance();
        const std::optional<Lvalue> place = lvalue(name);
        if (!place || (!place->dimensions.empty() && !place->pointer))
            out_of_reach(op.place, fmt::format("'{}' before {}", op.text, shown(name)));
        const Token sign{TokenKind::kPunctuation, op.text.substr(0, 1), op.place};
        const Value changed = arithmetic(sign, value_of(*place, name.place), integer(1));
        if (!place->pointer) return assigned(*place, changed, name);
        point(*place->pointer, changed, name);
        return changed;
    }
    if (!op.is("!") && !op.is("~")) return primary();
    if (++program_->depth > kMaxProgramDepth) fail(op.place, "this program is nested too deeply");
    advance();
    const Value value = unary();
    --program_->depth;
    if (op.is("!")) return integer(static_cast<std::int64_t>(!is_true(value)));
    if (!value.is_integer()) fail(op.place, "'~' needs a whole number");
    return integer(~value.integer);
}

// ---- Variables ----

// A variable and what is done to it: x, x = 1, x += 1, x++.
Value Reader::variable(const Token& name, Lvalue place) {
    const Token op = token_;
    const bool is_changed = op.is("=") || is_compound_assignment(op) || is_step(op);
    if (op.is(".") || op.is("->")) out_of_reach(op.place, "a struct");
    if (!is_changed) return value_of(place, name.place);
    if (place.pointer) return changed_pointer(name, place);
    if (!place.dimensions.empty()) fail(name.place, "{} is an array; only its elements can be changed", shown(name));
    advance();
    if (op.is("=")) return assigned(place, expression(), name);
    const Token by{TokenKind::kPunctuation, op.text.substr(0, op.text.size() - 1), op.place};
    if (!is_step(op)) {
        const Value right = expression();
        return assigned(place, combined(by, value_of(place, name.place), right), name);
    }
    const Value before = value_of(place, name.place);
    assigned(place, arithmetic(by, before, integer(1)), name);
    return before;
}

Value Reader::assigned(const Lvalue& place, const Value& value, const Token& name) {
    Object& object = *place.object;
    const Value kept = in_kind(value, object.kind, name.place);
    if (dry_) return kept;
    store(std::span<std::byte>(writable(object).bytes).subspan(place.offset), object.kind, kept.number());
    object.known = true;
    return kept;
}

// Moves past (name) or ((name)), as macros write their parameters: (v)[0] = 1;
std::optional<Token> Reader::name_in_parentheses() {
    const Program& p = *program_;
    std::size_t at = p.at;
    while (p.tokens[at].is("(")) ++at;
    const Token name = p.tokens[at];
    const std::size_t outer = p.partners[p.at];
    if (name.kind != TokenKind::kName || outer - at != at - p.at) return std::nullopt;
    for (std::size_t i = at + 1; i <= outer; ++i)
        if (!p.tokens[i].is(")")) return std::nullopt;
    const bool is_type = name.is("void") || name.is("GLvoid") || name.is("char") || name.is("GLchar") ||
                         name.is("signed") || name.is("unsigned") || name.is("long") || name.is("bool") ||
                         name.is("size_t") || find_type(name.text) || p.types.contains(name.text);
    if (is_type) return std::nullopt;
    jump(outer + 1);
    return name;
}

Value Reader::program_name(const Token& name) {
    if (token_.is("(")) return call_in_program(name);
    if (const std::optional<Lvalue> place = lvalue(name)) return variable(name, *place);
    const auto constant = program_->constants.find(name.text);
    if (constant != program_->constants.end()) return constant->second;
    if (name.is("true")) return integer(1);
    if (name.is("false")) return integer(0);
    if (const std::optional<int> value = glut_constant(name.text)) return integer(*value);
    if (program_->functions.contains(name.text)) out_of_reach(name.place, "a pointer to a function");
    return named_value(name);
}

}  // namespace twinlight
