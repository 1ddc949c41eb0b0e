// Reading the C dialect: declarations of scalars and arrays, calls, expressions, pragmas. A recursive-descent parser
// over Lexer's tokens; expressions are evaluated as they are read, with C's types (so 4/3 is 1).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include "command/lexer.h"
#include "command/text.h"

namespace twinlight {

namespace {

// ---- Types ----

struct NamedType {
    std::string_view name;
    Kind kind;
};

constexpr NamedType kTypes[] = {
    {"float", Kind::kFloat},   {"GLfloat", Kind::kFloat},       {"GLclampf", Kind::kFloat},
    {"double", Kind::kDouble}, {"GLdouble", Kind::kDouble},     {"GLclampd", Kind::kDouble},
    {"int", Kind::kInt},       {"GLint", Kind::kInt},           {"GLsizei", Kind::kSizei},
    {"GLuint", Kind::kUint},   {"GLenum", Kind::kEnum},         {"GLbitfield", Kind::kBitfield},
    {"short", Kind::kShort},   {"GLshort", Kind::kShort},       {"GLushort", Kind::kUshort},
    {"GLbyte", Kind::kByte},   {"GLubyte", Kind::kUbyte},       {"GLboolean", Kind::kBoolean},
    {"unsigned", Kind::kUint}, {"GLsizeiptr", Kind::kSizeiptr}, {"GLintptr", Kind::kSizeiptr},
};

std::optional<Kind> find_type(std::string_view name) {
    for (const NamedType& type : kTypes) {
        if (type.name == name) return type.kind;
    }
    return std::nullopt;
}

// Kinds that are the same C type.
Kind c_type(Kind kind) {
    if (kind == Kind::kSizei) return Kind::kInt;
    if (kind == Kind::kEnum || kind == Kind::kBitfield) return Kind::kUint;
    if (kind == Kind::kBoolean) return Kind::kUbyte;
    return kind;
}

struct Range {
    double smallest, largest;
};

// Of the types of whole numbers.
Range range_of(Kind kind) {
    switch (kind) {
        case Kind::kByte: return {-128, 127};
        case Kind::kShort: return {-32768, 32767};
        case Kind::kInt:
        case Kind::kSizei: return {-2147483648.0, 2147483647.0};
        case Kind::kUbyte:
        case Kind::kBoolean: return {0, 255};
        case Kind::kUshort: return {0, 65535};
        case Kind::kEnum:
        case Kind::kBitfield:
        case Kind::kUint:
        case Kind::kWord: return {0, 4294967295.0};
        case Kind::kSizeiptr: return {-9007199254740992.0, 9007199254740992.0};  // what a double holds exactly
        case Kind::kFloat:
        case Kind::kDouble: break;  // real numbers have no such range
    }
    return {0, 0};
}

// ---- Values ----

// A number with its C type: int (64 bits here, so that every GL type fits), float or double.
struct Number {
    enum class Type : std::uint8_t { kInteger, kFloat, kDouble };
    Type type = Type::kInteger;
    std::int64_t integer = 0;
    double real = 0;

    double value() const { return type == Type::kInteger ? static_cast<double>(integer) : real; }
};

Number integer(std::int64_t value) { return {Number::Type::kInteger, value, 0}; }
Number real(double value, bool is_float) {
    return is_float ? Number{Number::Type::kFloat, 0, static_cast<double>(static_cast<float>(value))}
                    : Number{Number::Type::kDouble, 0, value};
}

struct Variable {
    Kind kind{};
    bool is_array = false;
    std::vector<double> values;  // one for a scalar
    bool known = false;          // false: declared without a value, or written by a glGet*
    std::string unknown_because;
    Place place;
};

// An array as an argument: the elements from some offset on.
struct ArrayArgument {
    Kind kind{};
    std::vector<double> values;
    std::string shown;  // for messages: its name, or "this array"
    Variable* variable = nullptr;
};

// ---- The parser ----

class Reader {
  public:
    Reader(std::string_view text, const std::string& file) : lexer_(text, file) { advance(); }

    std::vector<Command> read() {
        while (token_.kind != TokenKind::kEnd && !program_read_) statement();
        return std::move(commands_);
    }

  private:
    // -- tokens --
    void advance() {
        token_ = std::move(ahead_);
        if (!primed_) {
            primed_ = true;
            token_ = lexer_.next();
        }
        if (token_.kind == TokenKind::kEnd) {
            ahead_ = token_;
        } else {
            ahead_ = lexer_.next();
        }
    }
    bool accept(std::string_view text) {
        if (!token_.is(text)) return false;
        advance();
        return true;
    }
    void expect(std::string_view text, std::string_view where) {
        if (accept(text)) return;
        fail(token_.place, fmt::format("expected '{}' {}, found {}", text, where, shown(token_)));
    }
    static std::string shown(const Token& token) {
        return token.kind == TokenKind::kEnd ? std::string(token.text) : quoted(token.text);
    }

    // -- statements --
    void statement();
    void declaration();
    void program();
    void call();
    void pragma();
    void arguments(Command& command, const Signature& sig);
    void array_argument(Command& command, const Parameter& parameter);
    double word_argument(const Parameter& parameter);

    // -- expressions: bitwise or, sum, product, unary, primary; C's precedence --
    Number expression();
    Number sum();
    Number product();
    Number unary();
    Number primary();
    Number named_value(const Token& name);
    Number literal(const Token& token);
    static Number arithmetic(const Token& op, Number a, Number b);

    // -- arrays --
    std::vector<double> initialiser(Kind kind);
    ArrayArgument array();
    Kind type_name();
    std::size_t array_length_in_brackets(std::size_t if_empty);

    double converted(const Number& number, Kind kind, const Place& place, std::string_view what);
    std::vector<std::string_view> visible_names() const;

    Lexer lexer_;
    Token token_, ahead_;
    bool primed_ = false;
    std::size_t nesting_ = 0;
    bool program_read_ = false;
    std::map<std::string_view, Variable> variables_;
    std::vector<Command> commands_;
};

void Reader::statement() {
    if (accept(";")) return;
    if (token_.kind == TokenKind::kPragma) return pragma();
    if (token_.kind != TokenKind::kName) {
        fail(token_.place, fmt::format("expected a statement such as glEnable(GL_LIGHTING); found {}", shown(token_)));
    }
    if (token_.is("static") && ahead_.is("void")) return program();
    for (std::string_view word : {"for", "while", "do", "if", "else", "switch", "return", "void", "struct", "char"}) {
        if (token_.is(word)) {
            fail(token_.place,
                 fmt::format("'{}' is not part of a scene: write the calls out one after the other", word));
        }
    }
    const bool declares = token_.is("const") || token_.is("static") || token_.is("signed") || token_.is("unsigned") ||
                          find_type(token_.text).has_value();
    if (declares) return declaration();
    if (ahead_.is("=") || ahead_.is("[")) {
        fail(token_.place, fmt::format("assignments are not part of a scene: give {} its value where it is declared",
                                       quoted(token_.text)));
    }
    call();
}

Kind Reader::type_name() {
    while (accept("const") || accept("static")) {
    }
    const bool is_unsigned = token_.is("unsigned");
    if (is_unsigned || token_.is("signed")) {
        const Token first = token_;
        advance();
        if (accept("char")) return is_unsigned ? Kind::kUbyte : Kind::kByte;
        if (accept("short")) return is_unsigned ? Kind::kUshort : Kind::kShort;
        accept("int");
        return is_unsigned ? Kind::kUint : Kind::kInt;
    }
    const std::optional<Kind> kind = find_type(token_.text);
    if (token_.kind != TokenKind::kName || !kind) {
        fail(token_.place, fmt::format("expected a type such as GLfloat, found {}", shown(token_)));
    }
    advance();
    while (accept("const")) {
    }
    return *kind;
}

// The rest of "[4]" or "[]" after the opening bracket.
std::size_t Reader::array_length_in_brackets(std::size_t if_empty) {
    if (accept("]")) return if_empty;
    const Place place = token_.place;
    const Number length = expression();
    expect("]", "after the array's length");
    if (length.type != Number::Type::kInteger || length.integer < 1 ||
        length.integer > static_cast<std::int64_t>(kMaxArrayLength)) {
        fail(place, fmt::format("an array's length is a whole number from 1 to {}", kMaxArrayLength));
    }
    return static_cast<std::size_t>(length.integer);
}

std::vector<double> Reader::initialiser(Kind kind) {
    std::vector<double> values;
    expect("{", "at the start of the array's values");
    while (!token_.is("}")) {
        const Place place = token_.place;
        if (token_.is("{")) fail(place, "arrays of arrays are not part of a scene: declare one array a row");
        if (values.size() >= kMaxArrayLength) {
            fail(place, fmt::format("an array has at most {} values", kMaxArrayLength));
        }
        values.push_back(converted(expression(), kind, place, "this value"));
        if (!accept(",")) break;
    }
    expect("}", "after the array's values");
    return values;
}

// A C program as print_c_program writes it: the scene is the body of its first function, draw_scene; what follows only
// opens a window, and is not read.
void Reader::program() {
    const Token first = token_;
    advance();
    advance();
    if (!token_.is("draw_scene")) {
        fail(first.place,
             fmt::format("functions are not part of a scene, but for draw_scene of an exported program: write "
                         "what {} calls one after the other",
                         quoted(token_.text)));
    }
    advance();
    expect("(", "after draw_scene");
    expect("void", "in draw_scene(void)");
    expect(")", "after draw_scene(void");
    if (!token_.is("{"))
        fail(token_.place, fmt::format("expected '{{' after draw_scene(void), found {}", shown(token_)));
    advance();
    while (!token_.is("}")) {
        if (token_.kind == TokenKind::kEnd) fail(first.place, "this function is never closed; end it with }");
        statement();
    }
    program_read_ = true;
}

void Reader::declaration() {
    const Kind kind = type_name();
    do {
        const Token name = token_;
        if (name.kind != TokenKind::kName) {
            fail(name.place, fmt::format("expected a variable's name, found {}{}", shown(name),
                                         name.is("*") ? "; declare an array instead: GLfloat name[] = {...};" : ""));
        }
        advance();
        if (token_.is("(")) {
            fail(name.place, fmt::format("functions are not part of a scene: write what {} calls one after the other",
                                         quoted(name.text)));
        }
        if (variables_.contains(name.text)) {
            fail(name.place,
                 fmt::format("{} is declared already, at {}", quoted(name.text), variables_.at(name.text).place.str()));
        }
        Variable variable{kind, false, {0.0}, false, "it was declared without a value", name.place};
        if (accept("[")) {
            variable.is_array = true;
            const std::size_t length = array_length_in_brackets(0);
            if (token_.is("[")) fail(token_.place, "arrays of arrays are not part of a scene: declare one array a row");
            variable.values.assign(length, 0.0);
            if (accept("=")) {
                const std::vector<double> values = initialiser(kind);
                if (length > 0 && values.size() > length) {
                    fail(name.place, fmt::format("{} has {} values, but its length is {}", quoted(name.text),
                                                 values.size(), length));
                }
                if (length == 0) variable.values.resize(values.size());
                std::copy(values.begin(), values.end(), variable.values.begin());  // C sets the rest to 0
                variable.known = true;
            }
            if (variable.values.empty()) {
                fail(name.place,
                     fmt::format("{} needs a length or values: GLfloat {}[4];", quoted(name.text), name.text));
            }
        } else if (accept("=")) {
            const Place place = token_.place;
            variable.values[0] =
                converted(expression(), kind, place, fmt::format("the value of {}", quoted(name.text)));
            variable.known = true;
        }
        variables_.emplace(name.text, std::move(variable));
    } while (accept(","));
    expect(";", "after the declaration");
}

void Reader::call() {
    const Token name = token_;
    const std::optional<CommandId> id = find_command(name.text);
    if (!id) {
        std::vector<std::string_view> names;
        for (const Signature& sig : signatures()) {
            if (sig.family != Family::kPragma) names.push_back(sig.name);
        }
        const auto near = nearest(name.text, names);
        fail(name.place, fmt::format("unknown command {}{}", quoted(name.text),
                                     near ? fmt::format("; did you mean {}?", *near)
                                          : "; docs/scene-language.md lists the commands of a scene"));
    }
    advance();
    Command command{*id, {}, name.place};
    expect("(", fmt::format("after {}", name.text));
    arguments(command, signature(*id));
    expect(";", fmt::format("after {}(...)", name.text));
    commands_.push_back(std::move(command));
}

void Reader::pragma() {
    const Place place = token_.place;
    advance();
    const Token name = token_;
    const std::optional<CommandId> id = name.kind == TokenKind::kName ? find_pragma(name.text) : std::nullopt;
    if (!id) {
        std::vector<std::string_view> names;
        for (const Signature& sig : signatures()) {
            if (sig.family == Family::kPragma) names.push_back(sig.name);
        }
        const auto near = nearest(name.text, names);
        fail(name.place, fmt::format("unknown pragma {}; {}", shown(name),
                                     near ? fmt::format("did you mean {}?", *near)
                                          : fmt::format("Twinlight knows {}", fmt::join(names, ", "))));
    }
    advance();
    Command command{*id, {}, place};
    expect("(", fmt::format("after #pragma twinlight {}", name.text));
    arguments(command, signature(*id));
    expect(";", fmt::format("or the line's end after {}(...)", name.text));
    commands_.push_back(std::move(command));
}

// The arguments after "(", and the ")".
void Reader::arguments(Command& command, const Signature& sig) {
    const auto wrong_count = [&](const Place& place, std::string_view found) {
        fail(place, fmt::format("{} takes {} argument{}: {}; {}", sig.name, sig.parameters.size(),
                                sig.parameters.size() == 1 ? "" : "s", sig.usage(), found));
    };
    std::size_t given = 0;
    for (const Parameter& parameter : sig.parameters) {
        if (parameter.extent == Extent::kRest) {
            while (given > 0 ? accept(",") : !token_.is(")")) {
                const Place place = token_.place;
                command.arguments.push_back(converted(expression(), parameter.kind, place,
                                                      fmt::format("the argument {} of {}", parameter.name, sig.name)));
                ++given;
                if (given > kMaxArrayLength) fail(place, "too many arguments");
            }
            break;
        }
        if (token_.is(")")) wrong_count(token_.place, fmt::format("only {} given", given));
        if (given > 0) expect(",", fmt::format("between the arguments of {}", sig.name));
        if (token_.is(")")) wrong_count(token_.place, fmt::format("only {} given", given));
        if (parameter.extent != Extent::kValue) {
            array_argument(command, parameter);
        } else if (parameter.kind == Kind::kWord) {
            command.arguments.push_back(word_argument(parameter));
        } else {
            const Place place = token_.place;
            command.arguments.push_back(converted(expression(), parameter.kind, place,
                                                  fmt::format("the argument {} of {}", parameter.name, sig.name)));
        }
        ++given;
    }
    if (token_.is(",")) wrong_count(token_.place, "more are given");
    expect(")", fmt::format("after the arguments of {}", sig.name));
}

double Reader::word_argument(const Parameter& parameter) {
    const std::optional<Enum> word = token_.kind == TokenKind::kName ? find_word(token_.text) : std::nullopt;
    if (!word) {
        std::vector<std::string_view> names;
        for (const NamedValue& known : words()) names.push_back(known.name);
        const auto near = nearest(token_.text, names);
        fail(token_.place, fmt::format("expected a word for {}, found {}{}", parameter.name, shown(token_),
                                       near ? fmt::format("; did you mean {}?", *near) : ""));
    }
    advance();
    return *word;
}

void Reader::array_argument(Command& command, const Parameter& parameter) {
    const Place place = token_.place;
    ArrayArgument given = array();
    const std::string_view name = command.name();
    if (c_type(given.kind) != c_type(parameter.kind)) {
        const auto type = [](Kind kind) {
            for (const NamedType& row : kTypes) {
                if (row.kind == kind && row.name.starts_with("GL")) return row.name;
            }
            return std::string_view("?");
        };
        fail(place, fmt::format("{} takes an array of {}, but {} is one of {}", name, type(parameter.kind), given.shown,
                                type(given.kind)));
    }
    const bool by_pname = parameter.extent == Extent::kByPname || parameter.extent == Extent::kOutput;
    const std::optional<Enum> pname =
        by_pname ? std::optional(command.enumerant(signature(command.id).scalars() - 1)) : std::nullopt;
    const std::optional<int> length = array_length(command.id, pname);
    if (length && given.values.size() < static_cast<std::size_t>(*length)) {
        std::string what(name);
        for (const NamedValue& row : gl_names()) {
            if (pname && row.value == *pname) what = fmt::format("{} with {}", name, row.name);
        }
        fail(place, fmt::format("{} {} {} value{}, but {} has {}", what,
                                parameter.extent == Extent::kOutput ? "writes" : "reads", *length,
                                *length == 1 ? "" : "s", given.shown, given.values.size()));
    }
    if (parameter.extent == Extent::kOutput) {
        if (given.variable) {
            given.variable->known = false;
            given.variable->unknown_because =
                fmt::format("{} at {} writes to it, and a scene cannot use the answer", name, command.place.str());
        }
        return;
    }
    if (given.variable && !given.variable->known) {
        fail(place, fmt::format("{} has no value here: {}", given.shown, given.variable->unknown_because));
    }
    if (length) given.values.resize(static_cast<std::size_t>(*length));
    command.arguments.insert(command.arguments.end(), given.values.begin(), given.values.end());
}

// name, name + n, &name[n], (GLfloat[]){...}
ArrayArgument Reader::array() {
    const Place place = token_.place;
    if (accept("(")) {
        const Kind kind = type_name();
        expect("[", "in an array such as (GLfloat[]){1, 0, 0, 1}");
        const std::size_t length = array_length_in_brackets(0);
        expect(")", "after the array's type");
        std::vector<double> values = initialiser(kind);
        if (length > 0 && values.size() > length) {
            fail(place, fmt::format("this array has {} values, but its length is {}", values.size(), length));
        }
        if (length > 0) values.resize(length, 0.0);
        return {kind, std::move(values), "this array", nullptr};
    }
    const bool address = accept("&");
    const Token name = token_;
    const auto found = variables_.find(name.text);
    if (name.kind != TokenKind::kName || found == variables_.end() || !(found->second.is_array || address)) {
        const auto near = nearest(name.text, visible_names());
        fail(name.place,
             fmt::format("expected an array such as (GLfloat[]){{1, 0, 0, 1}} or the name of one, found {}{}",
                         shown(name),
                         near && found == variables_.end() ? fmt::format("; did you mean {}?", *near) : ""));
    }
    advance();
    Variable& variable = found->second;
    std::int64_t offset = 0;
    const Place offset_place = token_.place;
    if (address && accept("[")) {
        const Number n = expression();
        expect("]", "after the index");
        offset = n.type == Number::Type::kInteger ? n.integer : -1;
    } else if (!address && accept("+")) {
        const Number n = product();
        offset = n.type == Number::Type::kInteger ? n.integer : -1;
    }
    if (offset < 0 || offset >= static_cast<std::int64_t>(variable.values.size())) {
        fail(offset_place,
             fmt::format("this index lies outside {}, which has {} values", quoted(name.text), variable.values.size()));
    }
    return {variable.kind, {variable.values.begin() + offset, variable.values.end()}, quoted(name.text), &variable};
}

std::vector<std::string_view> Reader::visible_names() const {
    std::vector<std::string_view> names;
    for (const auto& [name, variable] : variables_) names.push_back(name);
    return names;
}

// ---- Expressions ----

Number Reader::arithmetic(const Token& op, Number a, Number b) {
    const char o = op.text[0];
    if (a.type == Number::Type::kInteger && b.type == Number::Type::kInteger) {
        std::int64_t result = 0;
        bool overflow = false;
        switch (o) {
            case '+': overflow = __builtin_add_overflow(a.integer, b.integer, &result); break;
            case '-': overflow = __builtin_sub_overflow(a.integer, b.integer, &result); break;
            case '*': overflow = __builtin_mul_overflow(a.integer, b.integer, &result); break;
            case '|': result = a.integer | b.integer; break;
            default:
                if (b.integer == 0) fail(op.place, "division of whole numbers by 0");
                overflow = a.integer == std::numeric_limits<std::int64_t>::min() && b.integer == -1;
                if (!overflow) result = a.integer / b.integer;
        }
        if (overflow) fail(op.place, "this whole number is too large");
        return integer(result);
    }
    if (o == '|') fail(op.place, "'|' joins whole numbers, such as GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT");
    const bool is_float = a.type != Number::Type::kDouble && b.type != Number::Type::kDouble;
    const double x = a.value(), y = b.value();
    return real(o == '+' ? x + y : o == '-' ? x - y : o == '*' ? x * y : x / y, is_float);
}

Number Reader::expression() {
    if (++nesting_ > kMaxNesting) {
        fail(token_.place, fmt::format("this expression is nested deeper than {}", kMaxNesting));
    }
    Number value = sum();
    while (token_.is("|")) {
        const Token op = token_;
        advance();
        value = arithmetic(op, value, sum());
    }
    --nesting_;
    return value;
}

Number Reader::sum() {
    Number value = product();
    while (token_.is("+") || token_.is("-")) {
        const Token op = token_;
        advance();
        value = arithmetic(op, value, product());
    }
    return value;
}

Number Reader::product() {
    Number value = unary();
    while (token_.is("*") || token_.is("/")) {
        const Token op = token_;
        advance();
        value = arithmetic(op, value, unary());
    }
    return value;
}

Number Reader::unary() {
    bool negative = false;
    while (token_.is("-") || token_.is("+")) {
        negative ^= token_.is("-");
        advance();
    }
    Number value = primary();
    if (!negative) return value;
    if (value.integer == std::numeric_limits<std::int64_t>::min()) fail(token_.place, "this whole number is too large");
    value.integer = -value.integer;
    value.real = -value.real;
    return value;
}

Number Reader::primary() {
    const Token token = token_;
    if (accept("(")) {
        Number value = expression();
        expect(")", "to close the parenthesis");
        return value;
    }
    advance();
    if (token.kind == TokenKind::kNumber) return literal(token);
    if (token.kind == TokenKind::kName) return named_value(token);
    fail(token.place, fmt::format("expected a number or a GL name, found {}", shown(token)));
}

Number Reader::literal(const Token& token) {
    std::string_view digits = token.text;
    const bool hex = digits.starts_with("0x") || digits.starts_with("0X");
    const auto is_suffix = [](char c) { return std::string_view("uUlL").find(c) != std::string_view::npos; };
    const bool has_point = !hex && digits.find_first_of(".eE") != std::string_view::npos;
    const auto bad = [&] { fail(token.place, fmt::format("{} is not a number", quoted(token.text))); };
    if (has_point) {
        const bool is_float = digits.ends_with('f') || digits.ends_with('F');
        if (is_float || digits.ends_with('l') || digits.ends_with('L')) digits.remove_suffix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (end != digits.data() + digits.size() || error == std::errc::invalid_argument) bad();
        if (error == std::errc::result_out_of_range) {
            // Too small is 0 or a denormal, as in C; too large is an error.
            value = std::strtod(std::string(digits).c_str(), nullptr);
            if (std::isinf(value)) fail(token.place, fmt::format("{} is too large for a double", quoted(token.text)));
        }
        return real(value, is_float);
    }
    while (!digits.empty() && is_suffix(digits.back())) digits.remove_suffix(1);
    const bool octal = !hex && digits.size() > 1 && digits[0] == '0';
    const std::string_view significant = digits.substr(hex ? 2 : 0);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(significant.data(), significant.data() + significant.size(), value,
                                              hex     ? 16
                                              : octal ? 8
                                                      : 10);
    if (error == std::errc::result_out_of_range) {
        fail(token.place, fmt::format("{} is too large; write it with a point for a double", quoted(token.text)));
    }
    if (significant.empty() || end != significant.data() + significant.size()) bad();
    return integer(value);
}

Number Reader::named_value(const Token& name) {
    if (name.text == "M_PI") return real(M_PI, false);
    if (name.text == "M_PI_2") return real(M_PI_2, false);
    if (name.text == "M_PI_4") return real(M_PI_4, false);
    if (name.text == "M_SQRT2") return real(M_SQRT2, false);
    if (name.text == "INFINITY") return real(std::numeric_limits<double>::infinity(), true);
    if (name.text == "NAN") return real(std::numeric_limits<double>::quiet_NaN(), true);
    if (const std::optional<Enum> value = find_gl_name(name.text)) return integer(*value);

    const auto found = variables_.find(name.text);
    if (found == variables_.end()) {
        std::vector<std::string_view> names = visible_names();
        for (const NamedValue& row : gl_names()) names.push_back(row.name);
        const auto near = nearest(name.text, names);
        fail(name.place, fmt::format("unknown name {}{}", quoted(name.text),
                                     near             ? fmt::format("; did you mean {}?", *near)
                                     : token_.is("(") ? "; a call cannot stand inside an expression"
                                                      : ""));
    }
    const Variable& variable = found->second;
    std::size_t index = 0;
    if (variable.is_array) {
        if (!token_.is("[")) {
            fail(name.place, fmt::format("{} is an array, and a single number is needed here; choose an element: {}[0]",
                                         quoted(name.text), name.text));
        }
        advance();
        const Place place = token_.place;
        const Number n = expression();
        expect("]", "after the index");
        if (n.type != Number::Type::kInteger || n.integer < 0 ||
            n.integer >= static_cast<std::int64_t>(variable.values.size())) {
            fail(place, fmt::format("this index lies outside {}, which has {} values", quoted(name.text),
                                    variable.values.size()));
        }
        index = static_cast<std::size_t>(n.integer);
    }
    if (!variable.known) {
        fail(name.place, fmt::format("{} has no value here: {}", quoted(name.text), variable.unknown_because));
    }
    const double value = variable.values[index];
    if (variable.kind == Kind::kFloat || variable.kind == Kind::kDouble) {
        return real(value, variable.kind == Kind::kFloat);
    }
    return integer(static_cast<std::int64_t>(value));
}

// The value as the C type of `kind` holds it.
double Reader::converted(const Number& number, Kind kind, const Place& place, std::string_view what) {
    const double value = number.value();
    if (kind == Kind::kFloat || kind == Kind::kDouble) {
        if (!std::isfinite(value) || kind == Kind::kDouble) return value;
        const auto rounded = static_cast<float>(value);
        if (std::isinf(rounded)) {
            fail(place, fmt::format("{} is {}, which does not fit into a GLfloat", what, value));
        }
        return static_cast<double>(rounded);
    }
    if (kind == Kind::kEnum && number.type != Number::Type::kInteger) {
        fail(place, fmt::format("{} must be a GL name such as GL_LIGHT0, not the number {}", what, value));
    }
    if (!(value == std::trunc(value))) {
        fail(place, fmt::format("{} must be a whole number, not {}", what, value));
    }
    const Range range = range_of(kind);
    if (value < range.smallest || value > range.largest) {
        fail(place, fmt::format("{} is {}; it must be from {} to {}", what, value, range.smallest, range.largest));
    }
    return value;
}

}  // namespace

CommandList read_scene(std::string_view text, const std::string& file, const std::string& name) {
    if (text.size() > kMaxSceneBytes) {
        throw SceneError(
            fmt::format("{}: this scene has {} bytes; at most {} are read", file, text.size(), kMaxSceneBytes));
    }
    return {name, Reader(text, file).read()};
}

}  // namespace twinlight
