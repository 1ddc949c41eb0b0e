// Reads the C dialect: declarations of scalars and arrays, calls, pragmas. A recursive-descent parser over the tokens
// of Lexer. It evaluates expressions as it reads them, with C's types (so 4/3 is 1).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

constexpr std::size_t kMaxDimensions = 8;

}  // namespace

std::size_t Object::length() const {
    return std::accumulate(dimensions.begin(), dimensions.end(), std::size_t{1}, std::multiplies<>());
}

std::string shown(const Token& token) {
    return token.kind == TokenKind::kEnd ? std::string(token.text) : in_quotes(token.text);
}

Reader::Reader(std::string_view text, const std::string& file, const ImageLoader& load_image,
               const ReadOptions& options, std::size_t step)
    : lexer_(text, file), load_image_(load_image), load_mesh_(options.load_mesh), step_(step) {}

Reader::~Reader() = default;

std::vector<Command> Reader::read() {
    try {
        advance();
        while (token_.kind != TokenKind::kEnd && !program_read_) statement_or_error();
    } catch (const TooManyErrors&) {
    }
    return std::move(commands_);
}

// ---- Tokens ----

void Reader::advance() {
    if (program_) return step();
    line_before_ = token_.place.line;
    ++tokens_;
    token_ = std::move(ahead_);
    if (!primed_) {
        primed_ = true;
        token_ = next_token();
    }
    if (token_.kind == TokenKind::kEnd)
        ahead_ = token_;
    else
        ahead_ = next_token();
}

bool Reader::accept(std::string_view text) {
    if (!token_.is(text)) return false;
    advance();
    return true;
}

void Reader::fail_missing(std::string_view text, std::string_view where) {
    fail(token_.place, "expected '{}' {}, found {}", text, where, shown(token_));
}

// ---- Statements ----

void Reader::statement() {
    forget_literals();
    if (accept(";")) return;
    if (token_.kind == TokenKind::kPragma) return pragma();
    if (token_.kind != TokenKind::kName)
        fail(token_.place, "expected a statement such as glEnable(GL_LIGHTING); found {}", shown(token_));
    if (token_.is("void") || (token_.is("static") && ahead_.is("void"))) return program();
    for (std::string_view word : {"for", "while", "do", "if", "else", "switch", "return", "struct", "char"})
        if (token_.is(word)) fail(token_.place, "a scene cannot use '{}'; write out each call instead", word);
    if (token_.is("const") || token_.is("static") || at_type()) return declaration();
    if (token_.is("glutInitWindowSize")) return window_statement();
    if (ahead_.is("=") || ahead_.is("[")) return assignment();
    const std::string name(token_.text);
    call();
    expect(";", "after {}(...)", name);
}

void Reader::window_statement() {
    const Token name = token_;
    advance();
    window_ = window_size(name);
    expect(";", "after {}(...)", name.text);
}

// Reads a scene in a function: void display(void) { ... }. In a program from print_c_program the function is
// draw_scene; of the rest, which opens a window, only the window's size is read.
void Reader::program() {
    const Token first = token_;
    if (in_program_) fail(first.place, "a function cannot be inside another function; end the first one with }}");
    in_program_ = true;
    accept("static");
    advance();
    const Token name = token_;
    advance();
    expect("(", "after the function's name");
    accept("void");
    expect(")", "after {}(, because the function of a scene has no parameters", name.text);
    expect("{", "after {}(void)", name.text);
    while (!token_.is("}")) {
        if (token_.kind == TokenKind::kEnd) fail(first.place, "this function is never closed; end it with }}");
        statement_or_error();
    }
    program_read_ = name.is("draw_scene");
    if (program_read_) {
        while (token_.kind != TokenKind::kEnd && !token_.is("glutInitWindowSize")) advance();
        if (token_.kind != TokenKind::kEnd) window_statement();
        return;
    }
    advance();
    if (token_.kind == TokenKind::kEnd) return;
    fail(token_.place, "only the function {} is read; move the calls of other functions into it", in_quotes(name.text));
}

void Reader::declaration() {
    bool is_static = false;
    while (token_.is("const") || token_.is("static") || (program_ && (token_.is("register") || token_.is("extern")))) {
        is_static |= token_.is("static");
        advance();
    }
    const bool is_text = program_ && at_byte_type();
    const bool is_char = !is_text || token_.is("char");
    if (!is_char) advance();  // void* and GLchar*
    const Kind kind = is_char ? type_name() : Kind::kByte;
    const Dimensions row = is_char ? type_lengths_ : Dimensions{};
    if (program_ && accept(";")) return;  // enum { A, B };
    do {
        if (kind == Kind::kQuadric) expect("*", "after GLUquadric, as in GLUquadric* name = gluNewQuadric();");
        const bool is_pointer = program_ && kind != Kind::kQuadric && accept("*");
        while (is_pointer && (accept("const") || (is_text && accept("*")))) {
        }
        const Token name = token_;
        if (program_ && name.is("*")) out_of_reach(name.place, "a pointer to a pointer");
        if (program_ && name.is("(")) out_of_reach(name.place, "a pointer to an array or a function");
        if (name.kind != TokenKind::kName) {
            fail(name.place, "expected a variable's name, found {}{}", shown(name),
                 name.is("*") ? "; declare an array instead: GLfloat name[] = {...};" : "");
        }
        advance();
        try {
            if (token_.is("(")) {
                fail(name.place,
                     "a scene cannot define the function {}; write its calls directly, or inside void display(void) "
                     "{{ ... }}",
                     in_quotes(name.text));
            }
            if (is_text && (is_pointer || token_.is("[")))
                declare_text(name);
            else if (is_pointer)
                declare_pointer(name, kind, row, is_static);
            else
                declare_object(name, kind, row, is_static);
        } catch (...) {
            misdeclared_.insert(name.text);
            throw;
        }
    } while (accept(","));
    expect(";", "after the declaration");
}

// The rest of the declaration of a number, an array or a quadric, after its name.
void Reader::declare_object(const Token& name, Kind kind, const Dimensions& row, bool is_static) {
    const bool is_local = program_ && program_->in_function;
    if (is_local && is_static && declare_static(name)) return;
    if (!is_local && variables_.contains(name.text))
        fail(name.place, "{} is already declared at {}; use another name", in_quotes(name.text),
             variables_.at(name.text).place.str());
    Object object{.kind = kind,
                  .dimensions = with_rows(dimensions_in_brackets(), row, name.place),
                  .shown = in_quotes(name.text),
                  .place = name.place,
                  .known = is_static || (program_ && !is_local),  // C sets these to 0
                  .unknown_because = "it was declared without a value"};
    initialise(object, name);
    if (is_local && is_static)
        *find_variable(name.text) = std::move(object);
    else if (is_local)
        declare(name, std::move(object));
    else
        variables_.emplace(name.text, std::move(object));
}

// The value in a declaration, if it has one.
void Reader::initialise(Object& object, const Token& name) {
    if (object.kind == Kind::kQuadric) return quadric_declaration(object);
    if (object.dimensions.empty()) {
        allocate(object, name.place);
        if (!accept("=")) return;
        if (!program_ && ahead_.is("(") && find_command_or_extension(token_.text))
            return assign_result({&object, 0, {}});
        const bool in_braces = program_ && accept("{");  // GLfloat shininess = {100};
        const Place place = token_.place;
        const double value = converted(number(), object.kind, place, fmt::format("the value of {}", object.shown));
        if (in_braces) accept(",");
        if (in_braces) expect("}", "after the value of {}", object.shown);
        return fill(object, {value});
    }
    std::vector<double> values;
    const bool has_values = accept("=");
    if (has_values) {
        arrays_values(object.kind, object.dimensions, values, 0, true);
        if (object.dimensions[0] == 0) {
            object.dimensions[0] = 1;
            const std::size_t row = object.length();
            object.dimensions[0] = (values.size() + row - 1) / row;
        }
        if (values.size() > object.length())
            fail(name.place, "{} has {} values, but its length is {}", object.shown, values.size(), object.length());
    }
    if (object.length() == 0)
        fail(name.place, "{} needs a length or values, as in GLfloat {}[4];", object.shown, name.text);
    allocate(object, name.place);
    if (has_values) fill(object, values);
}

// The only assignment in scenes: name = the result of a call.
void Reader::assignment() {
    const Token name = token_;
    const auto refuse = [&] {
        if (!variables_.contains(name.text) && misdeclared_.contains(name.text)) throw FollowingError();
        fail(name.place, "a scene cannot assign to {}; give it its value in its declaration", in_quotes(name.text));
    };
    advance();
    const std::optional<Lvalue> target = lvalue(name);
    if (target && target->object->kind == Kind::kQuadric) return quadric_assignment(*target->object);
    if (!target || !accept("=") || !ahead_.is("(") || !find_command_or_extension(token_.text)) refuse();
    if (!target->dimensions.empty()) refuse();
    assign_result(*target);
    expect(";", "after the assignment");
}

void Reader::assign_result(const Lvalue& target) {
    const Token name = token_;
    const Command& command = call();
    const Signature& sig = command.sig();
    if (sig.c_arguments() == sig.parameters.size())
        fail(name.place, "{} returns no value; call it without =", sig.name);
    if (sig.parameters.back().kind == Kind::kQuadric)
        fail(name.place, "{} returns a quadric; declare {} as a GLUquadric*", sig.name, target.object->shown);
    const double value = converted(integer(static_cast<std::int64_t>(command.arguments.back())), target.object->kind,
                                   name.place, fmt::format("the result of {}", sig.name));
    const std::span<std::byte> bytes = writable(*target.object).bytes;
    store(bytes.subspan(target.offset), target.object->kind, value);
    target.object->known =
        named_objects(sig.parameters.back()).has_value() || command.id == CommandId::glCheckFramebufferStatus;
    target.object->unknown_because = fmt::format("the result of {} is known only when the program runs", sig.name);
}

const Command& Reader::call() {
    const Token name = token_;
    if (program_ && commands_.size() >= kMaxProgramCommands)
        fail(name.place, "a program can call at most {} commands before its first picture is complete",
             kMaxProgramCommands);
    const std::optional<CommandId> id = find_command_or_extension(name.text);
    if (!id) {
        std::vector<std::string_view> names;
        for (const Signature& sig : signatures())
            if (sig.family != Family::kPragma) names.push_back(sig.name);
        const auto near = nearest(name.text, names);
        fail(name.place, "unknown command {}{}", in_quotes(name.text),
             near ? fmt::format("; did you mean {}?", *near) : "; docs/scene-language.md lists the known commands");
    }
    advance();
    Command command{*id, {}, name.place};
    expect("(", "after {}", name.text);
    arguments(command, signature(*id));
    names_.follow(command);
    follow_viewport(command);
    commands_.push_back(std::move(command));
    return commands_.back();
}

void Reader::pragma() {
    const Place place = token_.place;
    advance();
    const Token name = token_;
    if (name.is("returns")) return returns_pragma();
    if (name.is("step")) return step_pragma();
    const std::optional<CommandId> id = name.kind == TokenKind::kName ? find_pragma(name.text) : std::nullopt;
    if (!id) {
        std::vector<std::string_view> names{"returns", "step"};
        for (const Signature& sig : signatures())
            if (sig.family == Family::kPragma) names.push_back(sig.name);
        const auto near = nearest(name.text, names);
        fail(name.place, "unknown pragma {}; {}", shown(name),
             near ? fmt::format("did you mean {}?", *near) : fmt::format("the pragmas are {}", fmt::join(names, ", ")));
    }
    advance();
    Command command{*id, {}, place};
    expect("(", "after #pragma twinlight {}", name.text);
    arguments(command, signature(*id));
    expect(";", "or the end of the line after {}(...)", name.text);
    commands_.push_back(std::move(command));
}

// #pragma twinlight returns(7): the result of the next glGenLists is 7.
void Reader::returns_pragma() {
    returns_place_ = token_.place;
    advance();
    expect("(", "after #pragma twinlight returns");
    const Place place = token_.place;
    returns_ = converted(number(), Kind::kUint, place, "the number in returns(...)");
    expect(")", "after the number");
    expect(";", "or the end of the line after returns(...)");
}

// ---- Objects ----

// Reads "[8][3]", "[][3]" or nothing. An omitted length is 0.
Dimensions Reader::dimensions_in_brackets() {
    Dimensions dimensions;
    std::size_t total = 1;
    while (token_.is("[")) {
        const Place place = token_.place;
        advance();
        if (dimensions.size() == kMaxDimensions) fail(place, "an array can have at most {} dimensions", kMaxDimensions);
        if (dimensions.empty() && accept("]")) {
            dimensions.push_back(0);
            continue;
        }
        const Place length_place = token_.place;
        const Value length = number();
        expect("]", "after the array's length");
        if (!length.is_integer() || length.integer < 1 ||
            length.integer > static_cast<std::int64_t>(kMaxArrayLength / total))
            fail(length_place, "an array's length must be a whole number from 1 to {}", kMaxArrayLength);
        dimensions.push_back(static_cast<std::size_t>(length.integer));
        total *= dimensions.back();
    }
    return dimensions;
}

// The lengths of an array whose elements are rows: point corners[8] after typedef GLfloat point[3] has {8, 3}.
Dimensions Reader::with_rows(Dimensions outer, const Dimensions& row, const Place& place) {
    if (row.empty()) return outer;
    outer.insert(outer.end(), row.begin(), row.end());
    if (outer.size() > kMaxDimensions) fail(place, "an array can have at most {} dimensions", kMaxDimensions);
    std::size_t total = 1;
    for (const std::size_t length : outer) {
        if (length > kMaxArrayLength / total) fail(place, "an array can have at most {} values", kMaxArrayLength);
        total *= std::max<std::size_t>(length, 1);
    }
    return outer;
}

// Reads {1, 2, 3} or {{1, 2}, {3, 4}} into values[start...]. As in C, rows need no braces. Only the outermost array
// (is_open) may become longer than its dimensions; the caller checks that.
void Reader::arrays_values(Kind kind, std::span<const std::size_t> dimensions, std::vector<double>& values,
                           std::size_t start, bool is_open) {
    const std::size_t row =
        std::accumulate(dimensions.begin() + 1, dimensions.end(), std::size_t{1}, std::multiplies<>());
    const std::size_t end = is_open ? kMaxArrayLength : start + row * dimensions[0];
    std::size_t position = start;
    expect("{", "at the start of the array's values");
    while (!token_.is("}")) {
        const Place place = token_.place;
        if (position >= end && is_open) fail(place, "an array can have at most {} values", kMaxArrayLength);
        if (position >= end) fail(place, "this row has more than {} values", end - start);
        if (token_.is("{")) {
            if (dimensions.size() == 1) fail(place, "these braces are one level too deep; expected a value");
            if ((position - start) % row != 0)
                fail(place, "this row starts before the previous one is complete; put the previous row in braces too");
            arrays_values(kind, dimensions.subspan(1), values, position, false);
            position += row;
        } else {
            const double value = converted(number(), kind, place, "this value");
            values.resize(std::max(values.size(), position + 1));
            values[position++] = value;
        }
        if (!accept(",")) break;
    }
    values.resize(std::max(values.size(), position));
    expect("}", "after the array's values");
}

void Reader::hold(std::size_t bytes, const Place& place) {
    if (bytes > kMaxMemoryBytes - bytes_)
        fail(place, "all arrays and pictures of a scene together can have at most {} MiB", kMaxMemoryBytes >> 20);
    bytes_ += bytes;
}

void Reader::allocate(Object& object, const Place& place) {
    const std::size_t bytes = object.length() * size_of(object.kind);
    hold(bytes, place);
    object.memory = std::make_shared<Memory>(Memory{object.kind, std::vector<std::byte>(bytes)});
}

// Missing values become 0, as in C.
void Reader::fill(Object& object, const std::vector<double>& values) {
    const std::size_t size = size_of(object.kind);
    const std::span<std::byte> bytes = object.memory->bytes;
    for (std::size_t i = 0; i < values.size(); ++i) store(bytes.subspan(i * size), object.kind, values[i]);
    object.known = true;
}

Memory& Reader::writable(Object& object) {
    if (object.memory.use_count() > 1) {
        hold(object.memory->bytes.size(), object.place);
        object.memory = std::make_shared<Memory>(*object.memory);
    }
    return *object.memory;
}

// A compound literal lives to the end of its statement, or as long as a command that points into it.
void Reader::forget_literals() {
    for (const Object& literal : literals_)
        if (literal.memory.use_count() == 1) bytes_ -= literal.memory->bytes.size();
    literals_.clear();
}

}  // namespace twinlight
