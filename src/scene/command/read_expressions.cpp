// Reads expressions: numbers with C's types, and pointers into arrays.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

#include "base/math/as_float.h"
#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

std::optional<Kind> Value::kind() const { return of ? of->leaf : std::nullopt; }

std::size_t Value::step() const { return of ? of->size : 1; }

Value zero_of(const DataType* type) {
    if (type->is_pointer()) return {.type = Value::Type::kPointer, .of = type->of};
    if (type->is_struct()) return {.type = Value::Type::kStruct, .of = type};
    return type->is_number() && is_real(type->kind) ? real(0, type->kind == Kind::kFloat) : integer(0);
}

Value integer(std::int64_t value) { return {.type = Value::Type::kInteger, .integer = value}; }
Value real(double value, bool is_float) {
    return is_float ? Value{.type = Value::Type::kFloat, .real = as_float(value)}
                    : Value{.type = Value::Type::kDouble, .real = value};
}

// ---- Operators ----

Value Reader::arithmetic(const Token& op, const Value& a, const Value& b) const {
    const char o = op.text[0];
    if (a.is_integer() && b.is_integer()) {
        std::int64_t result = 0;
        bool overflow = false;
        switch (o) {
            case '+': overflow = __builtin_add_overflow(a.integer, b.integer, &result); break;
            case '-': overflow = __builtin_sub_overflow(a.integer, b.integer, &result); break;
            case '*': overflow = __builtin_mul_overflow(a.integer, b.integer, &result); break;
            case '|': result = a.integer | b.integer; break;
            default:
                if (b.integer == 0 && dry_) return integer(0);
                if (b.integer == 0) fail(op.place, "this divides a whole number by 0");
                overflow = a.integer == std::numeric_limits<std::int64_t>::min() && b.integer == -1;
                if (!overflow) result = o == '%' ? a.integer % b.integer : a.integer / b.integer;
        }
        if (overflow && dry_) return integer(0);
        if (overflow) fail(op.place, "this whole number is too large");
        return integer(result);
    }
    if (a.is_pointer() && b.is_integer() && (o == '+' || o == '-')) return moved(op, a, b);
    if (b.is_pointer() && a.is_integer() && o == '+') return moved(op, b, a);
    if (a.is_pointer() && b.is_pointer() && o == '-') return distance(op, a, b);
    if (a.is_struct() || b.is_struct()) fail(op.place, "'{}' cannot combine structs; combine their members", o);
    if (a.is_pointer() || b.is_pointer())
        fail(op.place, "'{}' cannot combine an array with this value; only a whole number can be added to an array", o);
    if (o == '%') fail(op.place, "'%' needs whole numbers; fmod(a, b) divides others");
    if (o == '|') fail(op.place, "'|' combines only whole numbers, as in GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT");
    const bool is_float = a.type != Value::Type::kDouble && b.type != Value::Type::kDouble;
    const double x = a.number(), y = b.number();
    return real(o == '+' ? x + y : o == '-' ? x - y : o == '*' ? x * y : x / y, is_float);
}

// The pointer moved by a number of elements.
Value Reader::moved(const Token& op, Value pointer, const Value& by) const {
    if (dry_) return pointer;
    const auto step = static_cast<std::int64_t>(pointer.step());
    std::int64_t bytes = 0;
    const bool overflow = __builtin_mul_overflow(by.integer, step, &bytes) ||
                          (op.text == "-" ? __builtin_sub_overflow(pointer.offset, bytes, &pointer.offset)
                                          : __builtin_add_overflow(pointer.offset, bytes, &pointer.offset));
    const auto last = pointer.object ? static_cast<std::int64_t>(pointer.object->bytes())
                                     : static_cast<std::int64_t>(whole_range(Kind::kSizeiptr).largest);
    if (!overflow && pointer.offset >= 0 && pointer.offset <= last) return pointer;
    if (!pointer.object) fail(op.place, "this offset is too large or negative");
    fail_outside(op.place, tr("this pointer"), pointer);
}

void Reader::fail_outside(const Place& place, std::string_view what, const Value& pointer) {
    const std::size_t count = pointer.object->bytes() / std::max<std::size_t>(1, pointer.step());
    fail(place, "{} is outside {}, which has {}; indices start at 0", what, pointer.object->shown, values_text(count));
}

// How many elements lie between two pointers into one array.
Value Reader::distance(const Token& op, const Value& a, const Value& b) const {
    if (dry_) return integer(0);
    if (a.object != b.object || a.step() == 0) fail(op.place, "only pointers into the same array can be subtracted");
    return integer((a.offset - b.offset) / static_cast<std::int64_t>(a.step()));
}

Value Reader::expression() {
    if (++nesting_ > kMaxNesting) fail(token_.place, "this expression is nested more than {} levels deep", kMaxNesting);
    if (program_) {
        if (++program_->depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
        Value value = value_of(assignment_expression(), token_.place);
        --program_->depth;
        --nesting_;
        return value;
    }
    Value value = sum();
    while (token_.is("|")) {
        const Token op = token_;
        advance();
        value = arithmetic(op, value, sum());
    }
    --nesting_;
    return value;
}

Value Reader::number() {
    const Token start = token_;
    const Value value = expression();
    if (value.is_struct()) fail(start.place, "this is a struct, but a number is needed here; choose a member");
    if (!value.is_pointer()) return value;
    if (!value.object) fail(start.place, "this is a pointer, but a number is needed here");
    fail(start.place, "{} is an array, but a single number is needed here; choose an element{}", value.object->shown,
         value.object->is_literal ? "" : tr(", such as {}[0]", start.text));
}

Value Reader::sum() {
    Value value = product();
    while (token_.is("+") || token_.is("-")) {
        const Token op = token_;
        advance();
        value = arithmetic(op, value, product());
    }
    return value;
}

Value Reader::product() {
    Value value = unary();
    while (token_.is("*") || token_.is("/")) {
        const Token op = token_;
        advance();
        value = arithmetic(op, value, unary());
    }
    return value;
}

Value Reader::unary() {
    const Token start = token_;
    bool negative = false, has_sign = false;
    while (token_.is("-") || token_.is("+")) {
        has_sign = true;
        negative ^= token_.is("-");
        advance();
    }
    Value value = primary();
    if (has_sign && value.is_pointer()) fail(start.place, "an array cannot have a sign");
    if (!negative) return value;
    if (value.integer == std::numeric_limits<std::int64_t>::min()) fail(token_.place, "this whole number is too large");
    value.integer = -value.integer;
    value.real = -value.real;
    return value;
}

// ---- Primary expressions ----

Value Reader::primary() {
    const Token token = token_;
    if (token.is("(")) return parenthesis();
    advance();
    if (token.is("&")) {
        const Token name = token_;
        if (name.kind != TokenKind::kName)
            fail(name.place, "'&' must be followed by the name of an array or a variable");
        advance();
        const std::optional<Lvalue> place = lvalue(name);
        if (!place) unknown_name(name);
        if (place->type->is_number() && place->type->kind == Kind::kQuadric)
            fail(name.place, "a scene cannot take the address of a GLUquadric*");
        return address_of(*place);
    }
    if (token.kind == TokenKind::kNumber) return literal(token);
    if (token.is("sizeof")) return size_of_operand();
    if (token.kind == TokenKind::kName) return named_value(token);
    fail_no_value(token);
}

void Reader::fail_no_value(const Token& token) {
    if (token.is("{")) {
        fail(token.place,
             "C does not allow {{...}} here; where an array is needed, write its type in front, as in "
             "(GLfloat[]){{1, 0, 0, 1}}");
    }
    fail(token.place, "expected a number or a GL name, found {}", shown(token));
}

// (1 + 2), (GLfloat)1, (const void*)12, (GLfloat[]){1, 0, 0, 1}
Value Reader::parenthesis() {
    if (++nesting_ > kMaxNesting) fail(token_.place, "this expression is nested more than {} levels deep", kMaxNesting);
    const Place place = token_.place;
    advance();
    Value value;
    if (token_.is("const") || at_type()) {
        const DataType* const type = abstract_type();
        expect(")", "after the type");
        value =
            type->is_array() ? value_of(compound_literal(type, place), place) : converted_by_cast(unary(), type, place);
    } else {
        value = expression();
        expect(")", "to close the parenthesis");
    }
    --nesting_;
    return value;
}

// The value that a cast to the type gives.
Value Reader::converted_by_cast(Value value, const DataType* type, const Place& place) const {
    if (type->is_void()) return integer(0);
    if (type->is_array()) fail(place, "a cast cannot give an array; a pointer to its elements, such as (float*), can");
    if (type->is_struct()) {
        if (value.is_struct() && value.of == type) return value;
        fail(place, "a cast cannot give a struct");
    }
    if (!type->is_pointer()) {
        if (value.is_struct() || (value.is_pointer() && !(program_ && value.is_null())))
            fail(place, "this cast does not give a number");
        if (program_) return in_kind(value, type->kind, place);
        if (is_real(type->kind)) return real(value.number(), type->kind == Kind::kFloat);
        const double whole = std::trunc(value.number());
        if (!(std::abs(whole) <= 0x1p53)) fail(place, "this number is too large for the cast");
        return integer(static_cast<std::int64_t>(converted(integer(static_cast<std::int64_t>(whole)), type->kind, place,
                                                           [] { return tr("the number in this cast"); })));
    }
    if (!value.is_pointer()) {
        if (!value.is_integer() || value.integer < 0)
            fail(place, "a pointer must be an array, NULL or an offset of 0 or more");
        value = {.type = Value::Type::kPointer, .offset = value.integer};
    }
    value.of = type->of;
    return value;
}

Value Reader::literal(const Token& token) {
    std::string_view digits = token.text;
    if (digits[0] == '\'') return integer(character_code(digits));
    const bool hex = digits.starts_with("0x") || digits.starts_with("0X");
    const bool has_point = !hex && digits.find_first_of(".eE") != std::string_view::npos;
    const auto bad = [&] { fail(token.place, "{} is not a number", in_quotes(token.text)); };
    if (has_point) {
        const bool is_float = digits.ends_with('f') || digits.ends_with('F');
        if (is_float || digits.ends_with('l') || digits.ends_with('L')) digits.remove_suffix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (end != digits.data() + digits.size() || error == std::errc::invalid_argument) bad();
        if (error == std::errc::result_out_of_range) {
            // A too small number becomes 0 or a denormal, as in C; a too large one is an error.
            value = std::strtod(std::string(digits).c_str(), nullptr);
            if (std::isinf(value)) fail(token.place, "{} is too large for a double", in_quotes(token.text));
        }
        return real(value, is_float);
    }
    std::int64_t value = 0;
    const std::errc error = read_whole(digits, value);
    if (error == std::errc::result_out_of_range)
        fail(token.place, "{} is too large for a whole number; write it with a decimal point", in_quotes(token.text));
    if (error != std::errc()) bad();
    return integer(value);
}

// sizeof(GLfloat), sizeof(GLfloat[3]), sizeof(void*), sizeof(name), sizeof name[0]
Value Reader::size_of_operand() {
    const bool in_parentheses = token_.is("(");
    const DataType* type = nullptr;
    if (in_parentheses && (ahead_.is("const") || is_type(ahead_))) {
        advance();
        type = abstract_type();
        expect(")", "after sizeof");
    } else if (program_) {
        type = type_of_operand();
    } else {
        accept("(");
        const Token name = token_;
        if (name.kind != TokenKind::kName) fail(name.place, "sizeof takes a type, an array or a variable");
        advance();
        const std::optional<Lvalue> operand = lvalue(name);
        if (!operand) unknown_name(name);
        type = operand->type;
        if (in_parentheses) expect(")", "after sizeof");
    }
    return integer(static_cast<std::int64_t>(type->size));
}

// ---- Names ----

// Reads the subscripts after a variable's name. Returns nullopt if `name` is not a variable.
std::optional<Reader::Lvalue> Reader::lvalue(const Token& name) {
    Object* found = name.kind == TokenKind::kName ? find_variable(name.text) : nullptr;
    if (!found) return std::nullopt;
    Lvalue result{found, 0, found->type};
    while (result.type->is_array() && token_.is("[")) result = element(result);
    return result;
}

// Reads [1] after an array.
Reader::Lvalue Reader::element(const Lvalue& array) {
    advance();
    const Place place = token_.place;
    const Value index = program_ ? comma_expressions() : number();
    expect("]", "after the index");
    const DataType* const type = array.type->of;
    if (dry_) return {array.object, array.offset, type};
    const std::size_t length = array.type->length;
    if (!index.is_integer() || index.integer < 0 || index.integer >= static_cast<std::int64_t>(length)) {
        const std::string elements = !type->is_array() ? values_text(length)
                                     : length == 1     ? tr("1 row")
                                                       : tr("{} rows", length);
        fail(place, "this index is outside {}, which has {}; indices start at 0", array.object->shown, elements);
    }
    return {array.object, array.offset + static_cast<std::size_t>(index.integer) * type->size, type};
}

// The value of a place: a number, a pointer or a struct; for an array a pointer to its first element.
Value Reader::value_of(const Lvalue& lvalue, const Place& place) {
    const DataType* const type = lvalue.type;
    if (type->is_array()) {
        return {.type = Value::Type::kPointer,
                .object = lvalue.object,
                .offset = static_cast<std::int64_t>(lvalue.offset),
                .of = type->of};
    }
    if (dry_) return zero_of(type);
    const Object& object = *lvalue.object;
    if (type->is_number() && type->kind == Kind::kQuadric && !program_)
        fail(place, "{} is a quadric, but a number is needed here", object.shown);
    if (!object.memory || lvalue.offset + type->size > object.bytes()) fail(place, "this memory was freed");
    check_known(object, lvalue.offset, type->size, place);
    if (type->is_struct())
        return {.type = Value::Type::kStruct,
                .object = lvalue.object,
                .offset = static_cast<std::int64_t>(lvalue.offset),
                .of = type};
    const std::span<const std::byte> bytes = std::span(object.memory->bytes).subspan(lvalue.offset);
    if (type->is_pointer()) {
        std::uint64_t address = 0;
        std::memcpy(&address, bytes.data(), sizeof address);
        return pointer_from(address, type->of);
    }
    const double value = load(bytes, type->kind);
    if (is_real(type->kind)) return real(value, type->kind == Kind::kFloat);
    return integer(static_cast<std::int64_t>(value));
}

void Reader::check_known(const Object& object, std::size_t offset, std::size_t bytes, const Place& place) const {
    if (!object.known && offset < object.unknown_to && offset + bytes > object.unknown_from)
        fail_unknown(object, place);
}

// After a change of a part of what was not known, all of it counts as known.
void Reader::set_known(Object& object, std::size_t offset, std::size_t bytes) {
    if (offset < object.unknown_to && offset + bytes > object.unknown_from) object.known = true;
}

void Reader::fail_unknown(const Object& object, const Place& place) const {
    if (program_) out_of_reach(place, tr("the value of {} ({})", object.shown, object.unknown_because));
    fail(place, "{} has no value here: {}", object.shown, object.unknown_because);
}

Value Reader::address_of(const Lvalue& lvalue) {
    return {.type = Value::Type::kPointer,
            .object = lvalue.object,
            .offset = static_cast<std::int64_t>(lvalue.offset),
            .of = lvalue.type};
}

Value Reader::named_value(const Token& name) {
    if (name.text == "M_PI") return real(M_PI, false);
    if (name.text == "M_PI_2") return real(M_PI_2, false);
    if (name.text == "M_PI_4") return real(M_PI_4, false);
    if (name.text == "M_SQRT2") return real(M_SQRT2, false);
    if (name.text == "INFINITY") return real(std::numeric_limits<double>::infinity(), true);
    if (name.text == "NAN") return real(std::numeric_limits<double>::quiet_NaN(), true);
    if (name.text == "NULL") return {.type = Value::Type::kPointer};
    if (const std::optional<Enum> value = find_gl_name_or_extension(name.text)) return integer(*value);
    const std::optional<Lvalue> found = lvalue(name);
    if (!found) unknown_name(name);
    return value_of(*found, name.place);
}

Object* Reader::find_variable(std::string_view name) {
    if (program_) {
        const std::vector<Local>& locals = program_->locals;
        for (std::size_t i = locals.size(); i > program_->frame; --i)
            if (locals[i - 1].name == name) return locals[i - 1].object;
    }
    const auto found = variables_.find(name);
    return found == variables_.end() ? nullptr : &found->second;
}

void Reader::unknown_name(const Token& name) {
    if (misdeclared_.contains(name.text)) throw FollowingError();
    std::vector<std::string_view> names = visible_names();
    for (const NamedValue& row : gl_names()) names.push_back(row.name);
    // The nearest name to GL_LIGHT8 is another light, which is not what the scene means.
    constexpr std::string_view kLight = "GL_LIGHT";
    const bool is_light = name.text.starts_with(kLight) && name.text.size() > kLight.size() &&
                          name.text.find_first_not_of("0123456789", kLight.size()) == std::string_view::npos;
    if (is_light)
        fail(name.place, "unknown name {}; GL has GL_LIGHT0 to GL_LIGHT7, others need #pragma twinlight light(8, ...)",
             in_quotes(name.text));
    if (name.is("GL_PHONG"))
        fail(name.place,
             "unknown name 'GL_PHONG'; GL has no Phong shading, only GL_FLAT and GL_SMOOTH; to draw with Phong "
             "shading, run 'twinlight render --shading phong'");
    const auto near = nearest(name.text, names);
    if (program_ && !near && is_like_gl(name.text))
        out_of_reach(name.place, tr("the name {}, which Twinlight does not know", in_quotes(name.text)));
    if (program_ && !near)
        fail(name.place, "unknown name {}; if another file defines it, run and record the program: twinlight record {}",
             in_quotes(name.text), name.place.file ? *name.place.file : "PROGRAM.c");
    fail(name.place, "unknown name {}{}", in_quotes(name.text),
         near             ? did_you_mean(near)
         : token_.is("(") ? tr("; a call cannot be part of an expression")
                          : "");
}

std::vector<std::string_view> Reader::visible_names() const {
    std::vector<std::string_view> names;
    for (const auto& [name, object] : variables_) names.push_back(name);
    if (!program_) return names;
    for (std::size_t i = program_->frame; i < program_->locals.size(); ++i) names.push_back(program_->locals[i].name);
    for (const auto& [name, function] : program_->functions) names.push_back(name);
    return names;
}

// ---- Conversion ----

// The value converted to the C type of `kind`. `what` names it in messages.
double Reader::converted(const Value& number, Kind kind, const Place& place,
                         const std::function<std::string()>& what) const {
    if (program_) return in_kind(number, kind, place).number();
    const double value = number.number();
    if (is_real(kind)) {
        if (!std::isfinite(value) || kind == Kind::kDouble) return value;
        const auto rounded = static_cast<float>(value);
        if (std::isinf(rounded)) fail(place, "{} is {}, which does not fit into a GLfloat", what(), value);
        return static_cast<double>(rounded);
    }
    if (kind == Kind::kEnum && !number.is_integer())
        fail(place, "{} must be a GL name such as GL_LIGHT0, not the number {}", what(), value);
    if (!(value == std::trunc(value))) fail(place, "{} must be a whole number, not {}", what(), value);
    const WholeRange range = whole_range(kind);
    if (value < range.smallest || value > range.largest)
        fail(place, "{} is {}; it must be from {} to {}", what(), value, range.smallest, range.largest);
    return value;
}

}  // namespace twinlight
