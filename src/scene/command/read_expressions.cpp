// Reads expressions: numbers with C's types, and pointers into arrays.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "base/math/as_float.h"
#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

struct NamedType {
    std::string_view name;
    Kind kind;
};

constexpr NamedType kTypes[] = {
    {"float", Kind::kFloat},
    {"GLfloat", Kind::kFloat},
    {"GLclampf", Kind::kFloat},
    {"double", Kind::kDouble},
    {"GLdouble", Kind::kDouble},
    {"GLclampd", Kind::kDouble},
    {"int", Kind::kInt},
    {"GLint", Kind::kInt},
    {"GLsizei", Kind::kSizei},
    {"GLuint", Kind::kUint},
    {"GLenum", Kind::kEnum},
    {"GLbitfield", Kind::kBitfield},
    {"short", Kind::kShort},
    {"GLshort", Kind::kShort},
    {"GLushort", Kind::kUshort},
    {"GLbyte", Kind::kByte},
    {"GLubyte", Kind::kUbyte},
    {"GLboolean", Kind::kBoolean},
    {"unsigned", Kind::kUint},
    {"GLsizeiptr", Kind::kSizeiptr},
    {"GLintptr", Kind::kSizeiptr},
    {"GLUquadric", Kind::kQuadric},
    {"GLUquadricObj", Kind::kQuadric},
};

// Types that occur only behind pointers; their size is 1.
bool is_byte_type(const Token& token) {
    return token.is("void") || token.is("GLvoid") || token.is("char") || token.is("GLchar");
}

std::size_t product_of(std::span<const std::size_t> lengths) {
    return std::accumulate(lengths.begin(), lengths.end(), std::size_t{1}, std::multiplies<>());
}

}  // namespace

std::optional<Kind> find_type(std::string_view name) {
    for (const NamedType& type : kTypes)
        if (type.name == name) return type.kind;
    return std::nullopt;
}

Value integer(std::int64_t value) { return {.type = Value::Type::kInteger, .integer = value}; }
Value real(double value, bool is_float) {
    return is_float ? Value{.type = Value::Type::kFloat, .real = as_float(value)}
                    : Value{.type = Value::Type::kDouble, .real = value};
}

// ---- Types ----

bool Reader::at_type() const {
    if (token_.is("signed") || token_.is("unsigned") || find_type(token_.text).has_value()) return true;
    if (!program_ || token_.kind != TokenKind::kName) return false;
    return token_.is("char") || token_.is("long") || token_.is("bool") || token_.is("size_t") || token_.is("enum") ||
           program_->types.contains(token_.text);
}

bool Reader::at_byte_type() const { return is_byte_type(token_); }

Kind Reader::type_name() {
    type_lengths_.clear();
    while (accept("const")) {
    }
    if (program_) {
        if (token_.is("enum")) {
            enum_type();
            return Kind::kInt;
        }
        if (const auto known = program_->types.find(token_.text); known != program_->types.end()) {
            type_lengths_ = known->second.lengths;
            advance();
            while (accept("const")) {
            }
            return known->second.kind;
        }
    }
    const bool is_unsigned = token_.is("unsigned");
    if (is_unsigned || token_.is("signed")) {
        advance();
        if (accept("char")) return is_unsigned ? Kind::kUbyte : Kind::kByte;
        if (accept("short")) return is_unsigned ? Kind::kUshort : Kind::kShort;
        if (program_) accept("long");
        accept("int");
        return is_unsigned ? Kind::kUint : Kind::kInt;
    }
    std::optional<Kind> kind = find_type(token_.text);
    if (program_ && !kind) {
        if (token_.is("char")) kind = Kind::kByte;
        if (token_.is("bool")) kind = Kind::kBoolean;
        if (token_.is("long")) kind = ahead_.is("double") ? Kind::kDouble : Kind::kInt;
        if (token_.is("size_t")) kind = Kind::kSizeiptr;
        if (token_.is("long") && (ahead_.is("double") || ahead_.is("int") || ahead_.is("long"))) advance();
    }
    if (program_ && kind == Kind::kShort && ahead_.is("int")) advance();
    if (token_.kind != TokenKind::kName || !kind) {
        if (program_ && token_.kind == TokenKind::kName) unknown_type(token_);
        fail(token_.place, "expected a type such as GLfloat, found {}", shown(token_));
    }
    advance();
    while (accept("const")) {
    }
    return *kind;
}

void Reader::unknown_type(const Token& name) const {
    std::vector<std::string_view> names;
    for (const NamedType& type : kTypes) names.push_back(type.name);
    for (const auto& [known, type] : program_->types) names.push_back(known);
    if (const auto near = nearest(name.text, names))
        fail(name.place, "expected a type such as GLfloat, found {}; did you mean {}?", shown(name), *near);
    const bool is_keyword = name.is("struct") || name.is("union") || name.is("class");
    out_of_reach(name.place, is_keyword ? shown(name) : fmt::format("the type {}", shown(name)));
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
    const auto step = static_cast<std::int64_t>(pointer.step);
    std::int64_t bytes = 0;
    const bool overflow = __builtin_mul_overflow(by.integer, step, &bytes) ||
                          (op.text == "-" ? __builtin_sub_overflow(pointer.offset, bytes, &pointer.offset)
                                          : __builtin_add_overflow(pointer.offset, bytes, &pointer.offset));
    const auto last = pointer.object ? static_cast<std::int64_t>(pointer.object->memory->bytes.size())
                                     : static_cast<std::int64_t>(whole_range(Kind::kSizeiptr).largest);
    if (!overflow && pointer.offset >= 0 && pointer.offset <= last) return pointer;
    if (!pointer.object) fail(op.place, "this offset is too large or negative");
    fail(op.place, "this pointer is outside {}, which has {} values", pointer.object->shown, pointer.object->length());
}

Value Reader::expression() {
    if (++nesting_ > kMaxNesting) fail(token_.place, "this expression is nested more than {} levels deep", kMaxNesting);
    if (program_) {
        if (++program_->depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
        Value value = conditional();
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
    if (!value.is_pointer()) return value;
    if (!value.object) fail(start.place, "this is a pointer, but a number is needed here");
    fail(start.place, "{} is an array, but a single number is needed here; choose an element{}", value.object->shown,
         value.object->is_literal ? "" : fmt::format(", such as {}[0]", start.text));
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
    while (token_.is("*") || token_.is("/") || (program_ && token_.is("%"))) {
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
    Value value = program_ ? prefix() : primary();
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
    if (token.is("(")) {
        if (const std::optional<Token> name = program_ ? name_in_parentheses() : std::nullopt)
            return program_name(*name);
        if (program_ && ahead_.is("*"))
            if (const std::optional<Value> value = dereferenced_in_parentheses()) return *value;
        const Value value = parenthesis();
        return program_ && value.is_pointer() && token_.is("[") ? subscripted(value, token) : value;
    }
    advance();
    if (token.is("&")) {
        const Token name = token_;
        if (name.kind != TokenKind::kName)
            fail(name.place, "'&' must be followed by the name of an array or a variable");
        advance();
        const std::optional<Lvalue> place = lvalue(name);
        if (!place) unknown_name(name);
        if (place->pointer) out_of_reach(token.place, "a pointer to a pointer");
        if (place->object->kind == Kind::kQuadric) fail(name.place, "a scene cannot take the address of a GLUquadric*");
        return address_of(*place);
    }
    if (token.kind == TokenKind::kNumber) return literal(token);
    if (token.is("sizeof")) return size_of_operand();
    if (program_ && token.kind == TokenKind::kName) return program_name(token);
    if (token.kind == TokenKind::kName) return named_value(token);
    if (program_ && token.kind == TokenKind::kString) out_of_reach(token.place, "a text that is not passed over");
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
    if (token_.is("const") || at_type() || is_byte_type(token_)) {
        value = cast(place);
    } else {
        value = expression();
        expect(")", "to close the parenthesis");
    }
    --nesting_;
    return value;
}

// The rest of a cast or compound literal after "(".
Value Reader::cast(const Place& place) {
    while (accept("const")) {
    }
    std::optional<Kind> kind;
    std::size_t row = 1;
    if (is_byte_type(token_)) {
        advance();
        while (accept("const")) {
        }
    } else {
        kind = type_name();
        row = product_of(type_lengths_);
        if (row != 1 && !token_.is("*")) out_of_reach(place, "a cast to an array");
    }
    if (program_ && !kind && !token_.is("*")) kind = Kind::kByte;  // (char)
    if (kind && token_.is("[")) return compound_literal(*kind, place);
    int stars = 0;
    while (token_.is("*") || token_.is("const")) {
        stars += token_.is("*") ? 1 : 0;
        advance();
    }
    expect(")", "after the type");
    Value value = unary();
    if (stars == 0) {
        if (value.is_pointer() || !kind) fail(place, "this cast does not give a number");
        if (program_) return in_kind(value, *kind, place);
        if (is_real(*kind)) return real(value.number(), *kind == Kind::kFloat);
        const double whole = std::trunc(value.number());
        if (!(std::abs(whole) <= 0x1p53)) fail(place, "this number is too large for the cast");
        return integer(static_cast<std::int64_t>(
            converted(integer(static_cast<std::int64_t>(whole)), *kind, place, "the number in this cast")));
    }
    if (!value.is_pointer()) {
        if (!value.is_integer() || value.integer < 0)
            fail(place, "a pointer must be an array, NULL or an offset of 0 or more");
        value = {.type = Value::Type::kPointer, .offset = value.integer};
    }
    value.kind = kind;
    value.step = stars > 1 ? sizeof(void*) : kind ? size_of(*kind) * row : 1;
    return value;
}

Value Reader::compound_literal(Kind kind, const Place& place) {
    Object& object = literals_.emplace_back(Object{.kind = kind,
                                                   .dimensions = dimensions_in_brackets(),
                                                   .shown = "this array",
                                                   .place = place,
                                                   .is_literal = true});
    expect(")", "after the array's type");
    std::vector<double> values;
    arrays_values(kind, object.dimensions, values, 0, true);
    if (object.dimensions[0] == 0) {
        const std::size_t row = product_of(std::span(object.dimensions).subspan(1));
        object.dimensions[0] = (values.size() + row - 1) / row;
    }
    if (values.size() > object.length())
        fail(place, "this array has {} values, but its length is {}", values.size(), object.length());
    allocate(object, place);
    fill(object, values);
    return value_of({&object, 0, object.dimensions}, place);
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
    const bool in_parentheses = accept("(");
    std::size_t size = 0;
    if (in_parentheses && (token_.is("const") || at_type() || is_byte_type(token_))) {
        while (accept("const")) {
        }
        const bool is_byte = is_byte_type(token_);
        if (is_byte) advance();
        size = is_byte ? 1 : size_of(type_name()) * product_of(type_lengths_);
        while (token_.is("*") || token_.is("const")) {
            if (token_.is("*")) size = sizeof(void*);
            advance();
        }
        size *= product_of(dimensions_in_brackets());
    } else {
        const Token name = token_;
        if (name.kind != TokenKind::kName) fail(name.place, "sizeof takes a type, an array or a variable");
        advance();
        const Object* const whole = find_variable(name.text);
        if (whole && !whole->pointers.empty() && !token_.is("[")) {
            size = whole->pointers.size() * sizeof(void*);
        } else {
            const std::optional<Lvalue> operand = lvalue(name);
            if (!operand) unknown_name(name);
            size = operand->pointer ? sizeof(void*) : size_of(operand->object->kind) * product_of(operand->dimensions);
        }
    }
    if (in_parentheses) expect(")", "after sizeof");
    return integer(static_cast<std::int64_t>(size));
}

// ---- Names ----

// Reads the subscripts after a variable's name. Returns nullopt if `name` is not a variable.
std::optional<Reader::Lvalue> Reader::lvalue(const Token& name) {
    Object* found = name.kind == TokenKind::kName ? find_variable(name.text) : nullptr;
    if (!found) return std::nullopt;
    if (!found->pointers.empty()) found = &element_of(*found, name);
    if (found->is_text) out_of_reach(name.place, fmt::format("the text {}", in_quotes(name.text)));
    Object& object = found->target ? *found->target : *found;
    Lvalue result{&object, found->offset, found->dimensions, found->is_pointer ? found : nullptr};
    subscripts(result, name);
    return result;
}

// Reads [1][2] after a place, which then is that element. `name` is for messages.
void Reader::subscripts(Lvalue& result, const Token& name) {
    const Object& object = *result.object;
    while (!result.dimensions.empty() && accept("[")) {
        const Place place = token_.place;
        const Object* const pointer = std::exchange(result.pointer, nullptr);
        if (pointer && !pointer->target && !dry_)
            fail(name.place, "the pointer {} is NULL here; let it point into an array first", pointer->shown);
        const Value index = number();
        expect("]", "after the index");
        const std::size_t length = result.dimensions.front();
        if (dry_) {
            result.dimensions.erase(result.dimensions.begin());
            continue;
        }
        if (!index.is_integer() || index.integer < 0 || index.integer >= static_cast<std::int64_t>(length)) {
            fail(place, "this index is outside {}, which has {} {}{}; indices start at 0", object.shown, length,
                 result.dimensions.size() > 1 ? "row" : "value", length == 1 ? "" : "s");
        }
        result.dimensions.erase(result.dimensions.begin());
        result.offset += static_cast<std::size_t>(index.integer) * product_of(result.dimensions) * size_of(object.kind);
    }
}

// The value of an lvalue: a number, or for an array a pointer to its first element.
Value Reader::value_of(const Lvalue& lvalue, const Place& place) const {
    Object& object = *lvalue.object;
    if (lvalue.pointer && !lvalue.pointer->target) return {.type = Value::Type::kPointer, .kind = object.kind};  // NULL
    if (!lvalue.dimensions.empty()) {
        return {.type = Value::Type::kPointer,
                .object = &object,
                .offset = static_cast<std::int64_t>(lvalue.offset),
                .kind = object.kind,
                .step = size_of(object.kind) * product_of(std::span(lvalue.dimensions).subspan(1))};
    }
    if (dry_) return is_real(object.kind) ? real(0, object.kind == Kind::kFloat) : integer(0);
    if (object.kind == Kind::kQuadric && !program_)
        fail(place, "{} is a quadric, but a number is needed here", object.shown);
    if (!object.known) fail_unknown(object, place);
    const double value = load(std::span(object.memory->bytes).subspan(lvalue.offset), object.kind);
    if (is_real(object.kind)) return real(value, object.kind == Kind::kFloat);
    return integer(static_cast<std::int64_t>(value));
}

void Reader::fail_unknown(const Object& object, const Place& place) const {
    if (program_) out_of_reach(place, fmt::format("the value of {} ({})", object.shown, object.unknown_because));
    fail(place, "{} has no value here: {}", object.shown, object.unknown_because);
}

Value Reader::address_of(const Lvalue& lvalue) {
    return {.type = Value::Type::kPointer,
            .object = lvalue.object,
            .offset = static_cast<std::int64_t>(lvalue.offset),
            .kind = lvalue.object->kind,
            .step = size_of(lvalue.object->kind) * product_of(lvalue.dimensions)};
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
        out_of_reach(name.place, fmt::format("the name {}, which Twinlight does not know", in_quotes(name.text)));
    if (program_ && !near)
        fail(name.place, "unknown name {}; if another file defines it, run and record the program: twinlight record {}",
             in_quotes(name.text), name.place.file ? *name.place.file : "PROGRAM.c");
    fail(name.place, "unknown name {}{}", in_quotes(name.text),
         near             ? fmt::format("; did you mean {}?", *near)
         : token_.is("(") ? "; a call cannot be part of an expression"
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
double Reader::converted(const Value& number, Kind kind, const Place& place, std::string_view what) const {
    if (program_) return in_kind(number, kind, place).number();
    const double value = number.number();
    if (is_real(kind)) {
        if (!std::isfinite(value) || kind == Kind::kDouble) return value;
        const auto rounded = static_cast<float>(value);
        if (std::isinf(rounded)) fail(place, "{} is {}, which does not fit into a GLfloat", what, value);
        return static_cast<double>(rounded);
    }
    if (kind == Kind::kEnum && !number.is_integer())
        fail(place, "{} must be a GL name such as GL_LIGHT0, not the number {}", what, value);
    if (!(value == std::trunc(value))) fail(place, "{} must be a whole number, not {}", what, value);
    const WholeRange range = whole_range(kind);
    if (value < range.smallest || value > range.largest)
        fail(place, "{} is {}; it must be from {} to {}", what, value, range.smallest, range.largest);
    return value;
}

}  // namespace twinlight
