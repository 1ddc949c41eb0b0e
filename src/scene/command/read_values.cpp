// Reads the values that a declaration or a compound literal gives: numbers, rows of arrays, members of structs, texts.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

// An object while its values are read.
struct Reader::Filled {
    Object& object;
    std::size_t end = 0;          // of the bytes that have values
    std::optional<Value> next{};  // a value that was read to learn its type
};

// The value in a declaration, if it has one.
void Reader::initialise(Object& object, const Token& name) {
    if (object.type->is_array()) {
        if (accept("=")) return initialise_array(object, name.place, object.shown);
        if (object.type->length == 0)
            fail(name.place, "{} needs a length or values, as in GLfloat {}[4];", object.shown, name.text);
        return allocate(object, name.place);
    }
    allocate(object, name.place);
    if (!accept("=")) return;
    const Place place = token_.place;
    if (!object.type->is_number() || (program_ && token_.is("{"))) {
        Filled filled{object};
        fill_part(filled, object.type, 0, true);
        object.known = true;
        return;
    }
    if (!program_ && object.type->kind == Kind::kQuadric) return fill(object, quadric_value());
    if (!program_ && ahead_.is("(") && find_command_or_extension(token_.text))
        return assign_result({&object, 0, object.type});
    const Value value = number();
    fill(object, converted(value, object.type->kind, place, [&] { return tr("the value of {}", object.shown); }));
}

// An array without a length gets that of its values.
void Reader::initialise_array(Object& object, const Place& place, std::string_view shown) {
    const DataType* const element = object.type->of;
    const std::size_t length = object.type->length;
    allocate(object, place);
    Filled filled{object};
    if (at_text_for(object.type))
        fill_text(filled, object.type, 0);
    else
        fill_elements(filled, object.type, 0, true, true);
    const std::size_t given = (filled.end + element->size - 1) / element->size;
    // A scene may list no names: glDeleteTextures(0, (GLuint[]){});
    const bool may_be_empty = !program_ && object.is_literal;
    if (length == 0 && given == 0 && !may_be_empty)
        fail(place, "{} needs a length or values, as in GLfloat v[4];", shown);
    if (length != 0 && given > length) {
        const std::size_t size = element->leaf ? element->leaf_size() : element->size;
        fail(place, "{} has {} values, but its length is {}", shown, filled.end / size,
             length * (element->size / size));
    }
    if (length == 0) object.type = with_rows(element, {given}, place);
    writable(object).bytes.resize(object.type->size);
    object.known = true;
}

// The values after (GLfloat[]) or (struct point).
Reader::Lvalue Reader::compound_literal(const DataType* type, const Place& place) {
    Object& object = literals_.emplace_back(
        Object{.type = type, .shown = tr("this array"), .place = place, .is_literal = true, .known = true});
    if (type->is_array()) {
        initialise_array(object, place, tr("this array"));
    } else {
        allocate(object, place);
        Filled filled{object};
        fill_part(filled, type, 0, true);
    }
    return {&object, 0, object.type};
}

// Reads a number, a pointer, {...} for an array or a struct, or their first values without braces.
void Reader::fill_part(Filled& filled, const DataType* type, std::size_t offset, bool in_braces) {
    const Place place = token_.place;
    if (!filled.next && token_.is("{")) {
        if (type->is_array() || type->is_struct()) return fill_elements(filled, type, offset, true, false);
        if (!program_ && !in_braces)
            fail(place, "this row starts before the previous one is complete; put the previous row in braces too");
        if (!program_) fail(place, "these braces are one level too deep; expected a value");
        if (++program_->depth > kMaxProgramDepth) fail(place, "this program is nested too deeply");
        advance();
        fill_part(filled, type, offset, true);
        accept(",");
        --program_->depth;
        return expect("}", "after this value");
    }
    if (!filled.next && at_text_for(type)) return fill_text(filled, type, offset);
    if (type->is_struct() && !filled.next) filled.next = expression();
    if (type->is_array() || (type->is_struct() && !filled.next->is_struct()))
        return fill_elements(filled, type, offset, false, false);
    const Value value = filled.next         ? *std::exchange(filled.next, std::nullopt)
                        : type->is_number() ? number()
                                            : expression();
    grow(filled, offset + type->size, place);
    if (!type->is_number()) {
        assigned({&filled.object, offset, type}, value, place);
        return;
    }
    const double kept = converted(value, type->kind, place, [] { return tr("this value"); });
    store(std::span(writable(filled.object).bytes).subspan(offset), type->kind, kept);
}

// Reads the elements of an array or the members of a struct. Without braces of its own it takes as many as it needs. Only the
// outermost array (is_open) may become longer than its type says; the caller checks that.
void Reader::fill_elements(Filled& filled, const DataType* type, std::size_t offset, bool in_braces, bool is_open) {
    if (program_ && ++program_->depth > kMaxProgramDepth) fail(token_.place, "this program is nested too deeply");
    if (!type->is_complete) fail(token_.place, "a struct without members cannot have values");
    const std::size_t members = type->is_union ? 1 : type->members.size();
    const std::size_t count = is_open ? kMaxArrayLength : type->is_array() ? type->length : members;
    const auto at_designator = [&] { return program_ && !filled.next && (token_.is(".") || token_.is("[")); };
    if (in_braces) expect("{", "at the start of the array's values");
    std::size_t index = 0;
    while (filled.next || !token_.is("}")) {
        if (at_designator()) {
            if (!in_braces) break;
            index = designated(filled, type, offset, is_open);
        } else {
            if (index >= count && is_open) fail(token_.place, "an array can have at most {} values", kMaxArrayLength);
            if (index >= count)
                fail(token_.place, "{} has more than {} values", type->is_array() ? tr("this row") : tr("this struct"),
                     type->is_array() ? type->values() : count);
            const bool is_array = type->is_array();
            fill_part(filled, is_array ? type->of : type->members[index].type,
                      offset + (is_array ? index * type->of->size : type->members[index].offset), in_braces);
        }
        ++index;
        if (!in_braces && index >= count) break;
        if (!accept(",") && !at_designator()) break;
    }
    if (in_braces) {
        if (!is_open) grow(filled, offset + type->size, token_.place);
        expect("}", "after the array's values");
    }
    if (program_) --program_->depth;
}

// Reads .position = 1, [2] = 1 or [2].position[0] = 1. Returns the index of the first.
std::size_t Reader::designated(Filled& filled, const DataType* type, std::size_t offset, bool is_open) {
    std::optional<std::size_t> first;
    while (token_.is(".") || token_.is("[")) {
        const Token sign = token_;
        advance();
        std::size_t index = 0;
        if (sign.is(".")) {
            const auto found = std::ranges::find(type->members, token_.text, &Member::name);
            if (!type->is_struct() || found == type->members.end())
                fail(token_.place, "there is no member {} here", shown(token_));
            advance();
            index = static_cast<std::size_t>(found - type->members.begin());
            offset += found->offset;
            type = found->type;
        } else {
            const Value given = number();
            const std::size_t length = is_open && !first ? kMaxArrayLength : type->length;
            if (!type->is_array() || !given.is_integer() || given.integer < 0 ||
                given.integer >= static_cast<std::int64_t>(length))
                fail(sign.place, "this index is outside the array");
            expect("]", "after the index");
            index = static_cast<std::size_t>(given.integer);
            offset += index * type->of->size;
            type = type->of;
        }
        if (!first) first = index;
    }
    expect("=", "before the value of a member or an element");
    fill_part(filled, type, offset, true);
    return *first;
}

// Makes sure that the object has the bytes up to `end`.
void Reader::grow(Filled& filled, std::size_t end, const Place& place) {
    filled.end = std::max(filled.end, end);
    const std::size_t size = filled.object.bytes();
    if (end <= size) return;
    hold(end - size, place);
    writable(filled.object).bytes.resize(end);
}

bool Reader::at_text_for(const DataType* type) const {
    return program_ && token_.kind == TokenKind::kString && type->is_array() && type->of->is_character();
}

// char name[] = "text": the text with the 0 after it, if there is room for that.
void Reader::fill_text(Filled& filled, const DataType* type, std::size_t offset) {
    const Place place = token_.place;
    const Object& quoted = *text_in_quotes().object;
    const std::string_view text(reinterpret_cast<const char*>(quoted.memory->bytes.data()), quoted.bytes() - 1);
    const std::size_t length = type->length == 0 ? text.size() + 1 : type->length;
    if (text.size() > length) fail(place, "this text has {} characters, but there is room for {}", text.size(), length);
    grow(filled, offset + length, place);
    std::memcpy(writable(filled.object).bytes.data() + offset, text.data(), text.size());
}

}  // namespace twinlight
