// Calls in a whole program: of its own functions, of GL and of C's mathematics.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

// Numbers of C's headers.
std::optional<Value> constant_of_c(std::string_view name) {
    constexpr std::pair<std::string_view, std::int64_t> kWhole[] = {
        {"RAND_MAX", 2147483647}, {"INT_MAX", 2147483647}, {"INT_MIN", -2147483648},
        {"EXIT_SUCCESS", 0},      {"EXIT_FAILURE", 1},     {"CLOCKS_PER_SEC", 1000000},
        {"UCHAR_MAX", 255},       {"USHRT_MAX", 65535},    {"GLUT_API_VERSION", 4}};
    constexpr std::pair<std::string_view, double> kReal[] = {{"FLT_MAX", 0x1.fffffep127},
                                                             {"FLT_MIN", 0x1p-126},
                                                             {"FLT_EPSILON", 0x1p-23},
                                                             {"DBL_MAX", 0x1.fffffffffffffp1023},
                                                             {"DBL_EPSILON", 0x1p-52},
                                                             {"M_E", 2.7182818284590452354},
                                                             {"M_1_PI", 0.31830988618379067154},
                                                             {"M_2_PI", 0.63661977236758134308},
                                                             {"M_SQRT1_2", 0.70710678118654752440}};
    for (const auto& [known, value] : kWhole)
        if (name == known) return integer(value);
    for (const auto& [known, value] : kReal)
        if (name == known) return real(value, name.starts_with("FLT"));
    return std::nullopt;
}

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
        if (function != p.functions.end())
            return function->second.result ? zero_of(function->second.result) : integer(0);
        if (name.text.starts_with("gl") || name.is("abs")) return integer(0);
        return real(0, name.text.ends_with('f'));
    }
    if (function != p.functions.end()) {
        if (function->second.refusal) throw SceneError(*function->second.refusal);
        const std::vector<Value> given = values_in_parentheses();
        return run_function(function->second, given, name.place);
    }
    if (find_command_or_extension(name.text)) {
        jump(p.at - 1);
        const Command& command = call();
        const Signature& sig = command.sig();
        if (command.id == CommandId::glGetString) return answer_of_get_string(command);
        if (sig.c_arguments() == sig.parameters.size()) return integer(0);
        const Parameter& result = sig.parameters.back();
        // Scenes with errors are refused, so glGetError returns GL_NO_ERROR.
        if (named_objects(result) || result.kind == Kind::kQuadric || command.id == CommandId::glGetError ||
            command.id == CommandId::glCheckFramebufferStatus)
            return integer(static_cast<std::int64_t>(command.arguments.back()));
        out_of_reach(name.place, tr("the result of {}", sig.name));
    }
    if (const std::optional<Value> result = call_of_mathematics(name)) return *result;
    if (const std::optional<Value> result = call_of_fonts(name)) return *result;
    if (const std::optional<Value> result = call_of_glut(name)) return *result;
    if (const std::optional<Value> result = call_of_chance_and_time(name)) return *result;
    if (const std::optional<Value> result = call_of_memory(name)) return *result;
    if (const std::optional<Value> result = call_of_texts(name)) return *result;
    if (name.is("exit") || name.is("abort"))
        fail(name.place, "the program ends itself here, before its first picture is complete");
    // The program's input is empty, so waiting for Enter ends at once.
    if (name.is("getchar") || (name.is("fgets") && p.tokens[p.partners[p.at] - 1].is("stdin"))) {
        jump(p.partners[p.at] + 1);
        return integer(name.is("fgets") ? 0 : -1);
    }
    constexpr std::string_view kOutOfReach[] = {"gettimeofday", "fopen",  "va_arg",    "va_copy", "fclose",
                                                "fread",        "fscanf", "sscanf",    "scanf",   "fgets",
                                                "getenv",       "system", "localtime", "qsort"};
    if (std::ranges::find(kOutOfReach, name.text) != std::end(kOutOfReach))
        out_of_reach(name.place, tr("the function {}", name.text));
    std::vector<std::string_view> names;
    for (const auto& [known, ignored] : p.functions) names.push_back(known);
    for (const Signature& sig : signatures())
        if (sig.family != Family::kPragma) names.push_back(sig.name);
    if (const auto near = nearest(name.text, names))
        fail(name.place, "unknown function {}; did you mean {}? If another file defines it: twinlight record {}",
             in_quotes(name.text), *near, name.place.file ? *name.place.file : "PROGRAM.c");
    const std::string shown_name = in_quotes(name.text);
    out_of_reach(name.place, is_like_gl(name.text)
                                 ? tr("the function {}, which Twinlight does not know", shown_name)
                                 : tr("the function {}, which this file does not define", shown_name));
}

// What glGetString returns: the version is that of which Twinlight has all commands; the list of extensions is empty.
Value Reader::answer_of_get_string(const Command& command) {
    const std::string_view text = command.enumerant(0) == kGL_VERSION      ? "2.1"
                                  : command.enumerant(0) == kGL_EXTENSIONS ? ""
                                                                           : "Twinlight";
    Object& object =
        program_->heap.emplace_back(Object{.type = types_.array_of(types_.number(Kind::kByte), text.size() + 1),
                                           .shown = tr("this text"),
                                           .place = command.place,
                                           .known = true,
                                           .is_constant = true});
    hold(sizeof(Object), command.place);
    allocate(object, command.place);
    std::memcpy(object.memory->bytes.data(), text.data(), text.size());
    return {.type = Value::Type::kPointer, .object = &object, .of = types_.number(Kind::kUbyte)};
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

// rand and time: nullopt for another name. The clock of a program stands at 0.
std::optional<Value> Reader::call_of_chance_and_time(const Token& name) {
    Program& p = *program_;
    const bool seeds = name.is("srand") || name.is("srandom") || name.is("srand48");
    constexpr std::string_view kNumbers[] = {"rand", "random", "drand48", "lrand48", "time", "clock"};
    if (!seeds && std::ranges::find(kNumbers, name.text) == std::end(kNumbers)) return std::nullopt;
    const std::vector<Value> given = values_in_parentheses();
    if (seeds) {
        if (given.size() != 1) fail(name.place, "{} takes {}", name.text, arguments_text(1));
        const auto seed = static_cast<std::uint32_t>(in_kind(given[0], Kind::kUint, name.place).integer);
        if (name.is("srand48"))
            p.random_48 = (std::uint64_t{seed} << 16) + 0x330e;
        else
            p.random.seed(seed);
        return integer(0);
    }
    if (!given.empty() && !name.is("time")) fail(name.place, "{} takes no arguments", name.text);
    if (name.is("rand") || name.is("random")) return integer(p.random.next());
    if (name.is("drand48") || name.is("lrand48")) {
        p.random_48 = (p.random_48 * 0x5deece66d + 0xb) & 0xffffffffffff;
        if (name.is("lrand48")) return integer(static_cast<std::int64_t>(p.random_48 >> 17));
        return real(static_cast<double>(p.random_48) * 0x1p-48, false);
    }
    const bool is_stored = name.is("time") && !given.empty() && given[0].object;
    if (is_stored) assigned(behind(given[0], name.place), integer(0), name.place);
    return integer(0);
}

// sin(x), sinf(x), abs(i): nullopt for another name.
std::optional<Value> Reader::call_of_mathematics(const Token& name) {
    const auto given = [&](std::size_t count) {
        std::vector<Value> values = values_in_parentheses();
        for (const Value& value : values)
            if (value.is_pointer() || value.is_struct()) fail(name.place, "{} takes numbers", name.text);
        if (values.size() != count) fail(name.place, "{} takes {}", name.text, arguments_text(count));
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

}  // namespace twinlight
