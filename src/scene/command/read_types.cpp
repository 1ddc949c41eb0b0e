// Reads types: their words in any order, structs, enums and what stands around a name in a declaration.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

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
    {"GLsizeiptr", Kind::kSizeiptr},
    {"GLintptr", Kind::kSizeiptr},
    {"GLUquadric", Kind::kQuadric},
    {"GLUquadricObj", Kind::kQuadric},
    {"char", Kind::kByte},
    {"GLchar", Kind::kByte},
    {"unsigned", Kind::kUint},
    {"signed", Kind::kInt},
};

// Types that only programs use.
constexpr NamedType kTypesOfPrograms[] = {
    {"long", Kind::kInt},          {"bool", Kind::kBoolean},     {"_Bool", Kind::kBoolean},
    {"size_t", Kind::kSizeiptr},   {"ssize_t", Kind::kSizeiptr}, {"ptrdiff_t", Kind::kSizeiptr},
    {"time_t", Kind::kSizeiptr},   {"clock_t", Kind::kSizeiptr}, {"int8_t", Kind::kByte},
    {"uint8_t", Kind::kUbyte},     {"int16_t", Kind::kShort},    {"uint16_t", Kind::kUshort},
    {"int32_t", Kind::kInt},       {"uint32_t", Kind::kUint},    {"int64_t", Kind::kSizeiptr},
    {"uint64_t", Kind::kSizeiptr}, {"uint", Kind::kUint},        {"uchar", Kind::kUbyte},
    {"va_list", Kind::kInt},
};

std::optional<Kind> find_type(std::string_view name, std::span<const NamedType> types) {
    const auto found = std::ranges::find(types, name, &NamedType::name);
    return found == types.end() ? std::nullopt : std::optional(found->kind);
}

// The words of one type, in any order: short unsigned int.
struct TypeWords {
    bool is_unsigned = false, is_short = false, is_char = false, is_double = false, has_int = false, has_sign = false;
    int longs = 0;

    bool add(std::string_view word) {
        const auto once = [](bool& flag) { return !std::exchange(flag, true); };
        if (word == "unsigned") return once(has_sign) && once(is_unsigned);
        if (word == "signed") return once(has_sign);
        if (word == "short") return once(is_short);
        if (word == "char") return once(is_char);
        if (word == "double") return once(is_double);
        if (word == "int") return once(has_int);
        return word == "long" && ++longs <= 2;
    }
    Kind kind() const {
        if (is_double) return Kind::kDouble;
        if (is_char) return is_unsigned ? Kind::kUbyte : Kind::kByte;
        if (is_short) return is_unsigned ? Kind::kUshort : Kind::kShort;
        if (longs == 2) return Kind::kSizeiptr;
        return is_unsigned ? Kind::kUint : Kind::kInt;
    }
};

bool is_word_of_type(const Token& token) {
    constexpr std::string_view kAll[] = {"unsigned", "signed", "short", "char", "double", "int", "long"};
    return std::ranges::any_of(kAll, [&](std::string_view word) { return token.is(word); });
}

// Words that change nothing that is read.
bool is_qualifier(const Token& token) { return token.is("const") || token.is("volatile") || token.is("restrict"); }

}  // namespace

bool Reader::is_type(const Token& token) const {
    if (token.kind != TokenKind::kName) return false;
    if (!program_ && token.text.starts_with("gl")) return false;  // most words of a scene
    if (find_type(token.text, kTypes) || token.is("void") || token.is("GLvoid")) return true;
    if (!program_) return false;
    return find_type(token.text, kTypesOfPrograms) || token.is("enum") || token.is("struct") || token.is("union") ||
           token.is("FILE") || program_->types.contains(token.text);
}

// Reads the words of a type, such as const unsigned char.
const DataType* Reader::type_name() {
    while (is_qualifier(token_)) advance();
    const DataType* const type = type_of_words();
    while (is_qualifier(token_)) advance();
    return type;
}

const DataType* Reader::type_of_words() {
    const auto at_word = [&] { return is_word_of_type(token_) && (program_ || !token_.is("long")); };
    if (at_word()) {
        TypeWords words;
        for (; at_word() || is_qualifier(token_); advance())
            if (!is_qualifier(token_) && !words.add(token_.text))
                fail(token_.place, "this type cannot have the word {} here", shown(token_));
        return types_.number(words.kind());
    }
    if (accept("void") || accept("GLvoid")) return types_.nothing();
    if (program_) {
        if (token_.is("enum")) {
            enum_type();
            return types_.number(Kind::kInt);
        }
        if (token_.is("struct") || token_.is("union")) return struct_type();
        if (const auto known = program_->types.find(token_.text); known != program_->types.end()) {
            advance();
            return known->second;
        }
    }
    std::optional<Kind> kind = find_type(token_.text, kTypes);
    if (program_ && !kind) kind = find_type(token_.text, kTypesOfPrograms);
    const bool is_quadric = kind == Kind::kQuadric, is_file = program_ && token_.is("FILE");
    if (token_.kind != TokenKind::kName || (!kind && !is_file)) {
        if (program_ && token_.kind == TokenKind::kName) unknown_type(token_);
        fail(token_.place, "expected a type such as GLfloat, found {}", shown(token_));
    }
    advance();
    if (!is_quadric && !is_file) return types_.number(*kind);
    // Only pointers to them occur.
    const DataType*& opaque = opaque_[is_quadric ? "GLUquadric" : "FILE"];
    if (!opaque) opaque = types_.new_struct(is_quadric ? "GLUquadric" : "FILE");
    return opaque;
}

void Reader::unknown_type(const Token& name) const {
    std::vector<std::string_view> names;
    for (const NamedType& type : kTypes) names.push_back(type.name);
    for (const auto& [known, type] : program_->types) names.push_back(known);
    if (const auto near = nearest(name.text, names))
        fail(name.place, "expected a type such as GLfloat, found {}{}", shown(name), did_you_mean(near));
    out_of_reach(name.place, tr("the type {}", shown(name)));
}

// ---- Around a name ----

const DataType* Reader::pointers(const DataType* type) {
    for (; token_.is("*") || is_qualifier(token_); advance())
        if (token_.is("*")) type = types_.pointer_to(type);
    return type;
}

// Reads *name, name[3], name(int) or (*name)(int); the name may be missing. The first brackets of a parameter make a pointer.
Declarator Reader::declarator(const DataType* type, bool is_parameter) {
    Program& p = *program_;
    if (++p.depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
    type = pointers(type);
    Declarator made;
    // (*name), (name[3]), (APIENTRY *name)
    const bool is_nested = token_.is("(") && !ahead_.is(")") && !is_type(ahead_) && !is_qualifier(ahead_);
    if (is_nested) {
        const bool has_convention = ahead_.kind == TokenKind::kName && p.tokens[p.at + 2].is("*");
        const std::size_t inner = p.at + (has_convention ? 2 : 1), close = p.partners[p.at];
        jump(close + 1);
        type = after_declarator(type, false);
        const std::size_t end = p.at;
        jump(inner);
        made = declarator(type, is_parameter);
        if (p.at != close) fail_missing(")", tr("in this declaration"));
        jump(end);
    } else {
        made.name = {TokenKind::kPunctuation, "", token_.place};
        if (token_.kind == TokenKind::kName) {
            made.name = token_;
            made.at = p.at;
            advance();
        }
        made.type = after_declarator(type, is_parameter);
    }
    --p.depth;
    return made;
}

// What follows the name. What a function takes is not needed to point at it.
const DataType* Reader::after_declarator(const DataType* type, bool is_parameter) {
    const Place place = token_.place;
    if (program_ && token_.is("(")) {
        jump(program_->partners[program_->at] + 1);
        return types_.function(type);
    }
    if (!token_.is("[")) return type;
    if (!is_parameter) return with_rows(type, dimensions_in_brackets(), place);
    jump(program_->partners[program_->at] + 1);
    return types_.pointer_to(with_rows(type, dimensions_in_brackets(), place));
}

// The type of an array with these lengths, the outermost first.
const DataType* Reader::with_rows(const DataType* element, const Dimensions& lengths, const Place& place) {
    if (lengths.empty()) return element;
    if (element->is_function() || !element->is_complete || element->is_void())
        fail(place, "an array cannot have elements of this type");
    if (element->dimensions() + lengths.size() > kMaxDimensions)
        fail(place, "an array can have at most {} dimensions", kMaxDimensions);
    const std::size_t types = types_.count();
    std::size_t values = element->values();
    for (std::size_t i = lengths.size(); i > 0; --i) {
        const std::size_t length = lengths[i - 1];
        if (element->size == 0) fail(place, "an array cannot have elements without a length");
        if (length > kMaxArrayLength / values || length > kMaxMemoryBytes / element->size)
            fail(place, "an array can have at most {} values", kMaxArrayLength);
        values *= std::max<std::size_t>(length, 1);
        element = types_.array_of(element, length);
    }
    if (types_.count() > types) hold((types_.count() - types) * sizeof(DataType), place);
    return element;
}

// A type without a name, as in a cast.
const DataType* Reader::abstract_type() {
    const DataType* const type = type_name();
    return program_ ? declarator(type).type : after_declarator(pointers(type), false);
}

// ---- Structs, enums and typedef ----

// struct point { float x, y; }, struct point, or the same with union
const DataType* Reader::struct_type() {
    Program& p = *program_;
    const Token word = token_;
    advance();
    const Token name = token_;
    const bool has_name = name.kind == TokenKind::kName;
    if (has_name) advance();
    if (!token_.is("{")) {
        if (!has_name) fail(word.place, "expected the name or the members of a {}", word.text);
        DataType*& known = p.structs[name.text];
        if (!known) known = types_.new_struct(name.text);
        return known;
    }
    // The text of a function is read each time that it runs.
    DataType*& made = p.structs_at[p.at];
    if (made && made->is_complete) {
        jump(p.partners[p.at] + 1);
    } else {
        DataType* const declared = has_name ? p.structs[name.text] : nullptr;
        made = declared && !declared->is_complete ? declared : types_.new_struct(has_name ? name.text : "");
        if (has_name) p.structs[name.text] = made;
        members_of(*made, word.is("union"));
    }
    if (has_name) p.structs[name.text] = made;
    return made;
}

void Reader::members_of(DataType& made, bool is_union) {
    if (++program_->depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
    std::size_t size = 0, used = 0;
    const auto add = [&](std::string_view name, const DataType* type, const Place& place) {
        if (!type->is_complete || type->is_void() || type->is_function() || type->size == 0)
            fail(place, "the member {} needs a type of a known size", in_quotes(name));
        const auto aligned = [&](std::size_t offset) {
            return (offset + type->alignment - 1) / type->alignment * type->alignment;
        };
        const std::size_t offset = is_union ? 0 : aligned(size);
        size = std::max(size, offset + type->size);
        if (size > kMaxMemoryBytes) fail(place, "this struct is too large");
        used += type->size;
        made.alignment = std::max(made.alignment, type->alignment);
        if (made.members.empty()) made.leaf = type->leaf;
        if (made.leaf != type->leaf) made.leaf.reset();
        made.members.push_back({name, type, offset});
        return offset;
    };
    advance();
    while (!token_.is("}")) {
        const Place place = token_.place;
        const DataType* const type = type_name();
        if (accept(";")) {  // a struct without a name: its members are those of this one
            const bool is_here = program_->tokens[program_->at - 2].is("}");
            if (!is_here || !type->is_struct() || !type->is_complete) fail(place, "expected the name of a member");
            add("", type, place);
            continue;
        }
        do {
            const Declarator member = declarator(type);
            if (member.type->is_function()) out_of_reach(member.name.place, tr("a function in a struct"));
            if (member.name.text.empty()) fail(token_.place, "expected the name of a member, found {}", shown(token_));
            add(member.name.text, member.type, member.name.place);
            if (accept(":")) number();  // a bit field has its whole type here
        } while (accept(","));
        expect(";", "after the members of a struct");
    }
    advance();
    made.size = (size + made.alignment - 1) / made.alignment * made.alignment;
    if (is_union || used != made.size) made.leaf.reset();
    made.is_union = is_union;
    made.is_complete = true;
    --program_->depth;
}

// typedef GLfloat point[3]; typedef struct { float x; } ball; typedef enum { RED, GREEN } colour;
void Reader::typedef_declaration() {
    advance();
    const DataType* const type = type_name();
    do {
        const Declarator made = declarator(type);
        if (made.name.text.empty()) fail(token_.place, "expected a name in typedef, found {}", shown(token_));
        if (made.type->is_array() && made.type->length == 0)
            fail(made.name.place, "the type {} needs a length, as in typedef GLfloat point[3];",
                 in_quotes(made.name.text));
        program_->types.insert_or_assign(made.name.text, made.type);
    } while (accept(","));
    expect(";", "after typedef");
}

// enum { kA, kB = 3 }, enum mode { ... } or enum mode
void Reader::enum_type() {
    advance();
    if (token_.kind == TokenKind::kName) advance();
    if (!accept("{")) return;
    Value next = integer(0);
    while (!token_.is("}")) {
        const Token name = token_;
        if (name.kind != TokenKind::kName) fail(name.place, "expected a name in enum, found {}", shown(name));
        advance();
        if (accept("=")) next = number();
        if (!next.is_integer()) fail(name.place, "{} must be a whole number", in_quotes(name.text));
        program_->constants[name.text] = next;
        next = in_kind(integer(next.integer < 0x7fffffff ? next.integer + 1 : 0), Kind::kInt, name.place);
        if (!accept(",")) break;
    }
    expect("}", "after the names of the enum");
}

}  // namespace twinlight
