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

std::string shown(const Token& token) { return token.kind == TokenKind::kEnd ? tr(token.text) : in_quotes(token.text); }

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
    const auto is_storage = [&] {
        return token_.is("const") || token_.is("static") ||
               (program_ &&
                (token_.is("register") || token_.is("extern") || token_.is("volatile") || token_.is("inline")));
    };
    for (; is_storage(); advance()) is_static |= token_.is("static");
    const DataType* const type = type_name();
    if (program_ && accept(";")) return;  // enum { A, B }; struct point { float x; };
    do {
        const Declarator made = program_ ? declarator(type) : scene_declarator(type);
        if (made.type->is_function()) {
            program_->prototypes.emplace(made.name.text, made.name);
            continue;
        }
        try {
            declare_object(made, is_static);
        } catch (...) {
            misdeclared_.insert(made.name.text);
            throw;
        }
    } while (accept(","));
    expect(";", "after the declaration");
}

// A name with the lengths of an array; a quadric has a '*' before its name.
Declarator Reader::scene_declarator(const DataType* type) {
    if (type->is_struct()) {
        expect("*", "after GLUquadric, as in GLUquadric* name = gluNewQuadric();");
        type = types_.pointer_to(type);
    }
    const Token name = token_;
    if (name.kind != TokenKind::kName) {
        fail(name.place, "expected a variable's name, found {}{}", shown(name),
             name.is("*") ? tr("; declare an array instead: GLfloat name[] = {...};") : "");
    }
    advance();
    if (token_.is("(")) {
        misdeclared_.insert(name.text);
        fail(name.place,
             "a scene cannot define the function {}; write its calls directly, or inside void display(void) {{ ... }}",
             in_quotes(name.text));
    }
    if (type->is_number() && type->kind == Kind::kQuadric && token_.is("["))
        fail(name.place, "a scene cannot use arrays of quadrics; declare each quadric");
    try {
        return {name, with_rows(type, dimensions_in_brackets(), name.place)};
    } catch (...) {
        misdeclared_.insert(name.text);
        throw;
    }
}

// The rest of the declaration of a variable, after its name and type.
void Reader::declare_object(const Declarator& made, bool is_static) {
    const Token& name = made.name;
    const bool is_local = program_ && program_->in_function;
    if (name.text.empty()) fail(token_.place, "expected a variable's name, found {}", shown(token_));
    if (made.type->is_void() || !made.type->is_complete)
        out_of_reach(name.place, tr("the variable {}, whose type has no size", in_quotes(name.text)));
    if (is_local && is_static && declare_static(made)) return;
    if (!is_local && variables_.contains(name.text))
        fail(name.place, "{} is already declared at {}; use another name", in_quotes(name.text),
             variables_.at(name.text).place.str());
    // C sets static and global variables to 0. A pointer without a value is NULL here.
    Object object{.type = made.type,
                  .shown = in_quotes(name.text),
                  .place = name.place,
                  .known = is_static || (program_ && !is_local) || made.type->is_pointer(),
                  .unknown_because = tr("it was declared without a value")};
    Object* declared = nullptr;
    if (is_local && is_static)
        *(declared = find_variable(name.text)) = std::move(object);
    else if (is_local)
        declared = &declare(name, std::move(object));
    else
        declared = &variables_.emplace(name.text, std::move(object)).first->second;
    try {
        initialise(*declared, name);
    } catch (...) {
        if (!program_) variables_.erase(name.text);
        throw;
    }
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
    const bool is_number = target && target->type->is_number();
    if (is_number && target->type->kind == Kind::kQuadric) return quadric_assignment(*target->object);
    if (!target || !accept("=") || !ahead_.is("(") || !find_command_or_extension(token_.text)) refuse();
    if (!is_number) refuse();
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
    const double value = converted(integer(static_cast<std::int64_t>(command.arguments.back())), target.type->kind,
                                   name.place, [&] { return tr("the result of {}", sig.name); });
    const std::span<std::byte> bytes = writable(*target.object).bytes;
    store(bytes.subspan(target.offset), target.type->kind, value);
    target.object->known =
        named_objects(sig.parameters.back()).has_value() || command.id == CommandId::glCheckFramebufferStatus;
    target.object->unknown_because = tr("the result of {} is known only when the program runs", sig.name);
}

const Command& Reader::call() {
    const Token name = token_;
    check_room_for_command(name.place);
    const std::optional<CommandId> id = find_command_or_extension(name.text);
    if (!id) {
        std::vector<std::string_view> names;
        for (const Signature& sig : signatures())
            if (sig.family != Family::kPragma) names.push_back(sig.name);
        const auto near = nearest(name.text, names);
        fail(name.place, "unknown command {}{}", in_quotes(name.text),
             near ? did_you_mean(near) : tr("; docs/scene-language.md lists the known commands"));
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

void Reader::check_room_for_command(const Place& place) const {
    if (program_ && commands_.size() >= kMaxProgramCommands)
        fail(place, "a program can call at most {} commands before its first picture is complete", kMaxProgramCommands);
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
        fail(name.place, "unknown pragma {}{}", shown(name),
             near ? did_you_mean(near) : tr("; the pragmas are {}", fmt::join(names, ", ")));
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
    returns_ = converted(number(), Kind::kUint, place, [] { return tr("the number in returns(...)"); });
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

void Reader::hold(std::size_t bytes, const Place& place) {
    if (bytes > kMaxMemoryBytes - bytes_)
        fail(place, "all arrays and pictures of a scene together can have at most {} MiB", kMaxMemoryBytes >> 20);
    bytes_ += bytes;
}

void Reader::allocate(Object& object, const Place& place) {
    constexpr std::size_t kBytesOfAStep = 256;  // so that a loop of large arrays ends
    const std::size_t bytes = object.type->size;
    hold(bytes, place);
    if (program_) program_->steps += bytes / kBytesOfAStep;
    object.memory =
        std::make_shared<Memory>(Memory{object.type->leaf.value_or(Kind::kUbyte), std::vector<std::byte>(bytes)});
}

void Reader::fill(Object& object, double value) {
    store(object.memory->bytes, object.type->kind, value);
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
    for (Object& literal : literals_) forget(literal);
    literals_.clear();
}

// Gives the memory of an object back, and ends the pointers to it.
void Reader::forget(Object& object) {
    if (object.memory && object.memory.use_count() == 1) bytes_ -= object.memory->bytes.size();
    object.memory.reset();
    if (object.number != 0) program_->objects.erase(object.number);
}

}  // namespace twinlight
