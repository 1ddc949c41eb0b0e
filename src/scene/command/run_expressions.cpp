// Evaluates what only a whole program's expressions have: assignments, conditions, calls of its functions, of C's
// mathematics and of GLUT.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

bool is_step(const Token& token) { return token.is("++") || token.is("--"); }

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
                fail(op.place, "pointers can be compared with NULL only");
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
    if (is_step(op) || op.is("*")) {
        advance();
        const Token name = token_;
        advance();
        std::optional<Lvalue> place = lvalue(name);
        if (!place) out_of_reach(op.place, fmt::format("'{}' before {}", op.text, shown(name)));
        if (op.is("*")) {
            if (place->dimensions.size() != 1 || place->dimensions[0] == 0)
                out_of_reach(op.place, fmt::format("'*' before {}", shown(name)));
            place->dimensions.clear();
            return variable(name, *place);
        }
        if (!place->dimensions.empty()) out_of_reach(op.place, "a pointer that moves");
        const Token sign{TokenKind::kPunctuation, op.text.substr(0, 1), op.place};
        return assigned(*place, arithmetic(sign, value_of(*place, name.place), integer(1)), name);
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
    if (!place.dimensions.empty()) out_of_reach(name.place, "a pointer that moves");
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

Value Reader::program_name(const Token& name) {
    if (token_.is("(")) return call_in_program(name);
    if (const std::optional<Lvalue> place = lvalue(name)) return variable(name, *place);
    const auto constant = program_->constants.find(name.text);
    if (constant != program_->constants.end()) return constant->second;
    if (name.is("true")) return integer(1);
    if (name.is("false")) return integer(0);
    if (program_->functions.contains(name.text)) out_of_reach(name.place, "a pointer to a function");
    return named_value(name);
}

// ---- Calls ----

std::vector<Value> Reader::values_in_parentheses() {
    std::vector<Value> values;
    expect("(", "after the function's name");
    while (!token_.is(")")) {
        values.push_back(expression());
        if (!accept(",")) break;
    }
    expect(")", "after the arguments");
    return values;
}

// The call of a function; its name was just read.
Value Reader::call_in_program(const Token& name) {
    Program& p = *program_;
    const auto function = p.functions.find(name.text);
    if (dry_) {
        jump(p.partners[p.at] + 1);
        if (function != p.functions.end() && function->second.result)
            return in_kind(integer(0), *function->second.result, name.place);
        if (name.text.starts_with("gl") || name.is("abs")) return integer(0);
        return real(0, name.text.ends_with('f'));
    }
    if (function != p.functions.end()) {
        const std::vector<Value> given = values_in_parentheses();
        return run_function(function->second, given, name.place);
    }
    if (find_command_or_extension(name.text)) {
        jump(p.at - 1);
        const Command& command = call();
        const Signature& sig = command.sig();
        if (sig.c_arguments() == sig.parameters.size()) return integer(0);
        const Parameter& result = sig.parameters.back();
        // Scenes with errors are refused, so glGetError returns GL_NO_ERROR.
        if (named_objects(result) || result.kind == Kind::kQuadric || command.id == CommandId::glGetError)
            return integer(static_cast<std::int64_t>(command.arguments.back()));
        out_of_reach(name.place, fmt::format("the result of {}", sig.name));
    }
    if (const std::optional<Value> result = call_of_mathematics(name)) return *result;
    if (const std::optional<Value> result = call_of_glut(name)) return *result;
    if (name.is("exit")) fail(name.place, "the program ends itself here, before its first picture is complete");
    constexpr std::string_view kOutOfReach[] = {
        "rand",    "random", "drand48", "time",   "clock",  "gettimeofday", "malloc", "calloc", "realloc", "free",
        "fopen",   "fclose", "fread",   "fscanf", "scanf",  "getchar",      "fgets",  "getenv", "atoi",    "atof",
        "sprintf", "strlen", "strcpy",  "strcmp", "memcpy", "memset",       "system", "usleep", "sleep",   "snprintf"};
    if (std::find(std::begin(kOutOfReach), std::end(kOutOfReach), name.text) != std::end(kOutOfReach))
        out_of_reach(name.place, fmt::format("the function {}", name.text));
    std::vector<std::string_view> names;
    for (const auto& [known, ignored] : p.functions) names.push_back(known);
    for (const Signature& sig : signatures())
        if (sig.family != Family::kPragma) names.push_back(sig.name);
    if (const auto near = nearest(name.text, names))
        fail(name.place, "unknown function {}; did you mean {}?", in_quotes(name.text), *near);
    out_of_reach(name.place, fmt::format("the function {}, which this file does not define", in_quotes(name.text)));
}

namespace {

struct OneArgument {
    std::string_view name;
    double (*of_double)(double);
    float (*of_float)(float);
};
#define ROW(name)                                                                          \
    {                                                                                      \
#name, [](double x) { return std::name(x); }, [](float x) { return std::name(x); } \
    }
constexpr OneArgument kOneArgument[] = {ROW(sin),  ROW(cos),  ROW(tan),  ROW(asin),  ROW(acos),  ROW(atan),  ROW(sinh),
                                        ROW(cosh), ROW(tanh), ROW(exp),  ROW(log),   ROW(log2),  ROW(log10), ROW(sqrt),
                                        ROW(cbrt), ROW(fabs), ROW(ceil), ROW(floor), ROW(round), ROW(trunc)};
#undef ROW

struct TwoArguments {
    std::string_view name;
    double (*of_double)(double, double);
    float (*of_float)(float, float);
};
#define ROW(name)                                                                                                   \
    {                                                                                                               \
#name, [](double x, double y) { return std::name(x, y); }, [](float x, float y) { return std::name(x, y); } \
    }
constexpr TwoArguments kTwoArguments[] = {ROW(pow), ROW(atan2), ROW(fmod), ROW(fmin), ROW(fmax), ROW(hypot)};
#undef ROW

}  // namespace

// sin(x), sinf(x), abs(i): nullopt if the name is none of them.
std::optional<Value> Reader::call_of_mathematics(const Token& name) {
    const auto given = [&](std::size_t count) {
        std::vector<Value> values = values_in_parentheses();
        for (const Value& value : values)
            if (value.is_pointer()) fail(name.place, "{} takes numbers", name.text);
        if (values.size() != count) fail(name.place, "{} takes {} argument{}", name.text, count, count == 1 ? "" : "s");
        return values;
    };
    if (name.is("abs") || name.is("labs"))
        return integer(std::abs(in_kind(given(1)[0], Kind::kInt, name.place).integer));
    const auto is_float_form = [&](std::string_view known) {
        return name.text.size() == known.size() + 1 && name.text.back() == 'f' && name.text.starts_with(known);
    };
    for (const OneArgument& row : kOneArgument) {
        if (name.text == row.name) return real(row.of_double(given(1)[0].number()), false);
        if (is_float_form(row.name)) {
            const auto x = static_cast<float>(given(1)[0].number());
            return real(static_cast<double>(row.of_float(x)), true);
        }
    }
    for (const TwoArguments& row : kTwoArguments) {
        const bool is_float = is_float_form(row.name);
        if (name.text != row.name && !is_float) continue;
        const std::vector<Value> values = given(2);
        const double x = values[0].number(), y = values[1].number();
        if (!is_float) return real(row.of_double(x, y), false);
        return real(static_cast<double>(row.of_float(static_cast<float>(x), static_cast<float>(y))), true);
    }
    return std::nullopt;
}

// GLUT's functions and C's output: nullopt if the name is none of them.
std::optional<Value> Reader::call_of_glut(const Token& name) {
    Program& p = *program_;
    const std::size_t after = p.partners[p.at] + 1;
    const bool is_display = name.is("glutDisplayFunc");
    if (is_display || name.is("glutReshapeFunc")) {
        advance();
        accept("&");
        if (token_.kind != TokenKind::kName || !ahead_.is(")"))
            out_of_reach(token_.place, fmt::format("the argument of {}", name.text));
        (is_display ? p.display : p.reshape) = token_;
        if (token_.is("NULL")) (is_display ? p.display : p.reshape).reset();
        jump(after);
        return integer(0);
    }
    if (name.is("glutInitWindowSize")) {
        const std::vector<Value> size = values_in_parentheses();
        if (size.size() != 2) fail(name.place, "glutInitWindowSize takes 2 arguments: width and height");
        const double width = size[0].number(), height = size[1].number();
        if (!(width >= 1 && width <= kMaxProgramWindow && height >= 1 && height <= kMaxProgramWindow))
            fail(name.place, "a window must be from 1 x 1 to {} x {} pixels", kMaxProgramWindow, kMaxProgramWindow);
        if (!p.options.window) p.window = {static_cast<int>(width), static_cast<int>(height)};
        return integer(0);
    }
    if (name.is("glutGet")) {
        advance();
        const Token asked = token_;
        jump(after);
        if (asked.is("GLUT_WINDOW_WIDTH")) return integer(p.window.width);
        if (asked.is("GLUT_WINDOW_HEIGHT")) return integer(p.window.height);
        out_of_reach(name.place, fmt::format("glutGet({})", asked.text));
    }
    if (name.is("glutMainLoop")) {
        p.reached_main_loop = true;
        jump(after);
        return integer(0);
    }
    // Functions that change no picture, and those whose callbacks come after the first picture.
    constexpr std::string_view kPassedOver[] = {"glutInit",
                                                "glutInitDisplayMode",
                                                "glutInitDisplayString",
                                                "glutInitWindowPosition",
                                                "glutCreateWindow",
                                                "glutDestroyWindow",
                                                "glutPostRedisplay",
                                                "glutSwapBuffers",
                                                "glutPositionWindow",
                                                "glutReshapeWindow",
                                                "glutFullScreen",
                                                "glutSetWindowTitle",
                                                "glutSetIconTitle",
                                                "glutSetCursor",
                                                "glutKeyboardFunc",
                                                "glutKeyboardUpFunc",
                                                "glutSpecialFunc",
                                                "glutSpecialUpFunc",
                                                "glutMouseFunc",
                                                "glutMouseWheelFunc",
                                                "glutMotionFunc",
                                                "glutPassiveMotionFunc",
                                                "glutEntryFunc",
                                                "glutVisibilityFunc",
                                                "glutWindowStatusFunc",
                                                "glutIdleFunc",
                                                "glutTimerFunc",
                                                "glutCloseFunc",
                                                "glutWMCloseFunc",
                                                "glutCreateMenu",
                                                "glutAddMenuEntry",
                                                "glutAddSubMenu",
                                                "glutAttachMenu",
                                                "glutSetMenu",
                                                "glutIgnoreKeyRepeat",
                                                "glutSetKeyRepeat",
                                                "glutSetOption",
                                                "glutShowWindow",
                                                "gluQuadricCallback",
                                                "printf",
                                                "fprintf",
                                                "puts",
                                                "fputs",
                                                "putchar",
                                                "fflush",
                                                "perror",
                                                "assert",
                                                "atexit",
                                                "srand",
                                                "srand48",
                                                "srandom",
                                                "setbuf"};
    if (std::find(std::begin(kPassedOver), std::end(kPassedOver), name.text) == std::end(kPassedOver))
        return std::nullopt;
    jump(after);
    return integer(name.is("glutCreateWindow") || name.is("glutCreateMenu") ? 1 : 0);
}

}  // namespace twinlight
