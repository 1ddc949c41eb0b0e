// Evaluates what only a whole program's expressions have: conditions, more operators, assignments.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

constexpr int kOr = 1, kAnd = 2;

// The rank of an operator between two operands; 0 for other tokens.
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
        case '+':
        case '-': return by_text({{"+", 9}, {"-", 9}});
        case '*':
        case '/':
        case '%': return text.size() == 1 ? 10 : 0;
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
    if (value.is_struct()) fail(place, "this is a struct, but a number is needed here; choose a member");
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

Value Reader::comma_expressions() {
    Value value = expression();
    while (accept(",")) value = expression();
    return value;
}

// An operand with what is done to it: x, x = 1, x += 1, x + 1, x ? 1 : 2.
Reader::Operand Reader::assignment_expression() {
    const Token start = token_;
    Operand first = operand();
    const Token op = token_;
    if (op.is("=")) {
        const Lvalue place = place_of(first, start, op);
        advance();
        return {.value = assigned(place, expression(), start.place)};
    }
    if (is_compound_assignment(op)) {
        const Lvalue place = place_of(first, start, op);
        advance();
        const Value right = expression();
        const Token by{TokenKind::kPunctuation, op.text.substr(0, op.text.size() - 1), op.place};
        return {.value = assigned(place, combined(by, value_of(place, start.place), right), start.place)};
    }
    if (rank(op) == 0 && !op.is("?")) return first;
    return {.value = conditional(binary(value_of(first, start.place), kOr))};
}

// a ? b : c. The operand that is not chosen is read for its type: of 1 and 0.5 C makes two doubles.
Value Reader::conditional(const Value& test) {
    if (!token_.is("?")) return test;
    advance();
    const bool outer = dry_;
    dry_ = outer || !is_true(test);
    const Value first = comma_expressions();
    dry_ = outer || is_true(test);
    expect(":", "after the first choice of ?");
    const Value second = expression();
    dry_ = outer;
    const Value& chosen = is_true(test) ? first : second;
    const auto is_number = [](const Value& value) { return !value.is_pointer() && !value.is_struct(); };
    if (!is_number(first) || !is_number(second) || (first.is_integer() && second.is_integer())) return chosen;
    return real(chosen.number(), first.type != Value::Type::kDouble && second.type != Value::Type::kDouble);
}

// The operators after `left` that bind at least as much as `lowest`.
Value Reader::binary(Value left, int lowest) {
    while (true) {
        const int found = rank(token_);
        if (found == 0 || found < lowest) return left;
        const Token op = token_;
        advance();
        const auto right = [&] {
            const Place place = token_.place;
            return binary(value_of(operand(), place), found + 1);
        };
        if (found > kAnd) {
            left = combined(op, left, right());
            continue;
        }
        const bool value = is_true(left);
        const bool is_decided = dry_ || value == (found == kOr);
        if (is_decided) skip_operand(found);
        left = integer(static_cast<std::int64_t>(is_decided ? value : is_true(right())));
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

Value Reader::compared(const Token& op, const Value& a, const Value& b) {
    const auto holds = [&](const auto& x, const auto& y) {
        const std::string_view text = op.text;
        return text == "=="   ? x == y
               : text == "!=" ? x != y
               : text == "<"  ? x < y
               : text == "<=" ? x <= y
               : text == ">"  ? x > y
                              : x >= y;
    };
    if (a.is_struct() || b.is_struct()) fail(op.place, "structs cannot be compared; compare their members");
    if (!a.is_pointer() && !b.is_pointer())  // floats and whole numbers of up to 53 bits are doubles exactly
        return integer(static_cast<std::int64_t>(holds(a.number(), b.number())));
    const bool is_equality = op.is("==") || op.is("!=");
    if (!is_equality && a.object != b.object) fail(op.place, "only pointers into the same array can be compared");
    const auto offset = [](const Value& value) { return value.is_pointer() ? value.offset : value.integer; };
    return integer(static_cast<std::int64_t>(holds(std::pair(a.object, offset(a)), std::pair(b.object, offset(b)))));
}

Value Reader::combined(const Token& op, const Value& a, const Value& b) const {
    const std::string_view text = op.text;
    const bool is_comparison = text == "==" || text == "!=" || text[0] == '<' || text[0] == '>';
    if (is_comparison && text != "<<" && text != ">>") return dry_ ? integer(0) : compared(op, a, b);
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

// An operand with the operators before and after it: !a, -a, *a, &a, ++a, (float)a, a[1], a.x, a->x, a++.
Reader::Operand Reader::operand() {
    Program& p = *program_;
    const Token op = token_;
    constexpr std::string_view kPrefixes[] = {"*", "&", "++", "--", "!", "~", "-", "+"};
    const bool is_prefix = std::ranges::any_of(kPrefixes, [&](std::string_view text) { return op.is(text); });
    const bool is_cast = op.is("(") && (is_type(ahead_) || ahead_.is("const"));
    if (!is_prefix && !is_cast) return postfix(primary_operand(), op);
    if (++p.depth > kMaxProgramDepth) fail(op.place, "this program is nested too deeply");
    advance();
    Operand result;
    if (is_prefix) {
        result = operand_after(op);
    } else {
        const DataType* const type = abstract_type();
        expect(")", "after the type");
        if (token_.is("{") || type->is_array())
            result = postfix({.place = compound_literal(type, op.place)}, op);
        else
            result = {.value = converted_by_cast(value_of(operand(), op.place), type, op.place)};
    }
    --p.depth;
    return result;
}

// What an operator does to the operand after it.
Reader::Operand Reader::operand_after(const Token& op) {
    const Token start = token_;
    const Operand after = operand();
    if (is_step(op)) return stepped(after, op, start, false);
    const bool is_function = !after.place && after.value.of && after.value.of->is_function();
    if (op.is("&")) {
        if (is_function) return after;
        return {.value = address_of(place_of(after, start, op))};
    }
    const Value value = value_of(after, start.place);
    if (op.is("*")) {
        if (value.of && value.of->is_function()) return {.value = value};
        return {.place = behind(value, op.place)};
    }
    if (op.is("!")) return {.value = integer(static_cast<std::int64_t>(!is_true(value)))};
    if (value.is_pointer()) fail(op.place, "an array cannot have a sign");
    if (op.is("+")) return {.value = value};
    if (!op.is("-")) {
        if (!value.is_integer()) fail(op.place, "'~' needs a whole number");
        return {.value = integer(~value.integer)};
    }
    if (value.is_integer()) return {.value = arithmetic(op, integer(0), value)};
    return {.value = real(-value.number(), value.type == Value::Type::kFloat)};
}

// The operators after an operand.
Reader::Operand Reader::postfix(Operand result, const Token& start) {
    while (token_.kind == TokenKind::kPunctuation) {
        if (token_.is("[")) {
            result = element_of(result, start);
        } else if (token_.is(".") || token_.is("->")) {
            result = member_of(result, start);
        } else if (is_step(token_)) {
            const Token op = token_;
            advance();
            result = stepped(result, op, start, true);
        } else if (token_.is("(")) {
            const Value called = value_of(result, start.place);
            if (dry_ && called.of && called.of->is_function()) {
                skip_token();
                result = {.value = zero_of(called.of->of)};
                continue;
            }
            const Function& function = function_behind(called, start.place);
            const std::vector<Value> given = values_in_parentheses();
            result = {.value = run_function(function, given, start.place)};
        } else {
            break;
        }
    }
    return result;
}

// ++ or -- before or after an operand.
Reader::Operand Reader::stepped(const Operand& operand, const Token& op, const Token& start, bool gives_before) {
    const Lvalue place = place_of(operand, start, op);
    const Token by{TokenKind::kPunctuation, op.text.substr(0, 1), op.place};
    const Value before = value_of(place, start.place);
    const Value after = assigned(place, arithmetic(by, before, integer(1)), start.place);
    return {.value = gives_before ? before : after};
}

Reader::Operand Reader::primary_operand() {
    const Token token = token_;
    if (token.is("(")) {
        if (++nesting_ > kMaxNesting)
            fail(token_.place, "this expression is nested more than {} levels deep", kMaxNesting);
        if (++program_->depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
        advance();
        Operand inner = assignment_expression();
        while (accept(",")) inner = assignment_expression();
        expect(")", "to close the parenthesis");
        --nesting_;
        --program_->depth;
        return inner;
    }
    if (token.kind == TokenKind::kString) {
        const Value text = text_in_quotes();
        return {.place = Lvalue{text.object, 0, text.object->type}};
    }
    advance();
    if (token.kind == TokenKind::kNumber) return {.value = literal(token)};
    if (token.is("sizeof")) return {.value = size_of_operand()};
    if (token.kind == TokenKind::kName) return program_name(token);
    fail_no_value(token);
}

// The type of what follows sizeof, which is not evaluated.
const DataType* Reader::type_of_operand() {
    if (++program_->depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
    const bool outer = std::exchange(dry_, true);
    const Operand read = operand();
    dry_ = outer;
    --program_->depth;
    if (read.place) return read.place->type;
    const Value& value = read.value;
    if (value.is_struct()) return value.of;
    if (value.is_pointer()) return types_.pointer_to(value.of ? value.of : types_.nothing());
    return types_.number(value.is_integer()                  ? Kind::kInt
                         : value.type == Value::Type::kFloat ? Kind::kFloat
                                                             : Kind::kDouble);
}

// ---- Variables ----

Value Reader::value_of(const Operand& operand, const Place& place) {
    return operand.place ? value_of(*operand.place, place) : operand.value;
}

// What an operator changes or takes the address of.
Reader::Lvalue Reader::place_of(const Operand& operand, const Token& start, const Token& op) const {
    if (operand.place) return *operand.place;
    if (operand.value.is_struct() && operand.value.object)
        return {operand.value.object, static_cast<std::size_t>(operand.value.offset), operand.value.of};
    fail(op.place, "'{}' needs a variable, not {}", op.text, shown(start));
}

// Stores the value as C converts it. Returns what the place has then.
Value Reader::assigned(const Lvalue& place, const Value& value, const Place& where) {
    const DataType* const type = place.type;
    if (type->is_array()) fail(where, "this is an array; only its elements can be changed");
    Value kept = type->is_number() ? in_kind(value, type->kind, where) : value;
    if (type->is_pointer()) kept = converted_by_cast(value, type, where);
    if (type->is_struct() && (!value.is_struct() || value.of != type))
        fail(where, "a struct can only be given another of the same type");
    if (dry_) return kept;
    Object& object = *place.object;
    if (object.is_constant)
        fail(where, "a text in quotes cannot be changed; copy it into an array: char text[] = \"...\";");
    if (!object.memory || place.offset + type->size > object.bytes()) fail(where, "this memory was freed");
    const std::span<std::byte> bytes = std::span(writable(object).bytes).subspan(place.offset, type->size);
    if (type->is_number()) {
        store(bytes, type->kind, kept.number());
    } else if (type->is_pointer()) {
        const std::uint64_t stored = address(kept);
        std::memcpy(bytes.data(), &stored, sizeof stored);
    } else {
        const std::span<const std::byte> from = bytes_behind(value, type->size, false, where).subspan(0, type->size);
        std::memmove(bytes.data(), from.data(), type->size);
    }
    set_known(object, place.offset, type->size);
    return kept;
}

Reader::Operand Reader::program_name(const Token& name) {
    if (Object* const found = find_variable(name.text)) return {.place = Lvalue{found, 0, found->type}};
    if (token_.is("(")) return {.value = call_in_program(name)};
    const auto constant = program_->constants.find(name.text);
    if (constant != program_->constants.end()) return {.value = constant->second};
    if (name.is("true") || name.is("false")) return {.value = integer(name.is("true") ? 1 : 0)};
    if (const std::optional<int> value = glut_constant(name.text)) return {.value = integer(*value)};
    if (const std::optional<Value> value = constant_of_c(name.text)) return {.value = *value};
    if (const std::optional<Value> font = font_named(name.text)) return {.value = *font};
    if (program_->functions.contains(name.text) || program_->prototypes.contains(name.text)) {
        Object& function = function_object(name);
        return {.value = {.type = Value::Type::kPointer, .object = &function, .of = function.type}};
    }
    return {.value = named_value(name)};
}

}  // namespace twinlight
