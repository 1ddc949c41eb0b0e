// Pointers of a whole program: each is NULL or points into an array of numbers that outlives it.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

// What an expression of this type has where only its type matters.
Value zero_of(Kind kind) { return is_real(kind) ? real(0, kind == Kind::kFloat) : integer(0); }

}  // namespace

// The rest of GLfloat* name = array; after the name. Each element that the pointer can reach is an array of the lengths in
// `row`, or a number if there are none.
void Reader::declare_pointer(const Token& name, Kind kind, const Dimensions& row, bool is_static) {
    if (is_static && declare_static(name)) return;
    Object made{
        .kind = kind, .dimensions = {0}, .shown = in_quotes(name.text), .place = name.place, .is_pointer = true};
    made.dimensions.insert(made.dimensions.end(), row.begin(), row.end());
    if (token_.is("[")) return declare_pointers(name, made, is_static);
    Object& pointer = keep_pointer(name, std::move(made), is_static);
    if (accept("=")) point(pointer, expression(), name);
}

// Declares a pointer or an array of pointers.
Object& Reader::keep_pointer(const Token& name, Object made, bool is_static) {
    if (!program_->in_function)
        variables_.insert_or_assign(name.text, std::move(made));
    else if (is_static)
        *find_variable(name.text) = std::move(made);
    else
        declare(name, std::move(made));
    return *find_variable(name.text);
}

// The rest of GLfloat* name[] = {first, second}; after the name.
void Reader::declare_pointers(const Token& name, const Object& element, bool is_static) {
    const Dimensions length = dimensions_in_brackets();
    if (length.size() != 1) out_of_reach(name.place, "an array of arrays of pointers");
    std::size_t count = length[0];
    if (count > kMaxProgramLocals) out_of_reach(name.place, "an array of so many pointers");
    Object made{.kind = element.kind, .dimensions = {}, .shown = element.shown, .place = name.place};
    made.pointers.assign(count == 0 ? kMaxProgramLocals : count, element);
    Object& array = keep_pointer(name, std::move(made), is_static);
    for (Object& pointer : array.pointers) pointer.is_local = array.is_local;
    std::size_t given = 0;
    if (accept("=")) {
        expect("{", "before the pointers of {}", array.shown);
        while (!token_.is("}")) {
            if (given == array.pointers.size()) fail(token_.place, "{} has only {} pointers", array.shown, given);
            point(array.pointers[given++], expression(), name);
            if (!accept(",")) break;
        }
        expect("}", "after the pointers of {}", array.shown);
    }
    if (count == 0) count = given;
    if (count == 0) fail(name.place, "{} needs a length or values", array.shown);
    array.pointers.resize(count, element);
}

// Reads the [1] after the name of an array of pointers.
Object& Reader::element_of(Object& array, const Token& name) {
    if (!accept("[")) out_of_reach(name.place, fmt::format("the array of pointers {}", array.shown));
    const Place place = token_.place;
    const Value index = number();
    expect("]", "after the index");
    const std::size_t count = array.pointers.size();
    if (dry_) return array.pointers[0];
    if (!index.is_integer() || index.integer < 0 || index.integer >= static_cast<std::int64_t>(count))
        fail(place, "this index is outside {}, which has {} pointer{}; indices start at 0", array.shown, count,
             count == 1 ? "" : "s");
    return array.pointers[static_cast<std::size_t>(index.integer)];
}

// The rest of char name[] = "..."; after the name.
void Reader::declare_text(const Token& name) {
    Object text{.kind = Kind::kByte, .dimensions = {}, .shown = in_quotes(name.text), .place = name.place};
    text.is_text = true;
    if (program_->in_function)
        declare(name, std::move(text));
    else
        variables_.insert_or_assign(name.text, std::move(text));
    skip_expression();
}

// Whether the array is there as long as the pointer that is visible in the running function.
bool Reader::outlives(const Object& target, const Object& pointer) const {
    if (!target.is_local) return true;
    if (!pointer.is_local) return false;
    std::size_t block_of_target = 0, block_of_pointer = 0;  // 0 is that of a calling function
    for (std::size_t i = program_->frame; i < program_->locals.size(); ++i) {
        const Local& local = program_->locals[i];
        if (local.object == &target) block_of_target = local.block;
        const std::vector<Object>& elements = local.object->pointers;
        const bool is_element = !elements.empty() && &pointer >= elements.data() && &pointer <= &elements.back();
        if (local.object == &pointer || is_element) block_of_pointer = local.block;
    }
    return block_of_target <= block_of_pointer;
}

// Lets the pointer point into an array of its type, or nowhere.
void Reader::point(Object& pointer, const Value& value, const Token& name) const {
    if (dry_) return;
    const bool is_null = !value.object && (value.is_integer() ? value.integer : value.offset) == 0 &&
                         (value.is_integer() || value.is_pointer());
    const auto is_kind = [&](Kind kind) { return c_type(kind) == c_type(pointer.kind); };
    const bool can_point =
        value.object && value.kind && is_kind(*value.kind) && is_kind(value.object->kind) &&
        (value.object == pointer.target || (!value.object->is_literal && outlives(*value.object, pointer)));
    if (!is_null && !can_point) out_of_reach(name.place, fmt::format("the pointer {}", in_quotes(name.text)));
    pointer.target = value.object;
    pointer.offset = is_null ? 0 : static_cast<std::size_t>(value.offset);
    std::size_t row = size_of(pointer.kind);
    for (std::size_t i = 1; i < pointer.dimensions.size(); ++i) row *= pointer.dimensions[i];
    pointer.dimensions[0] = is_null ? 0 : (value.object->memory->bytes.size() - pointer.offset) / row;
}

// The array that starts behind a pointer: of numbers, or of the rows of an array of arrays. `shown` is for messages.
Reader::Lvalue Reader::behind(const Value& pointer, const Dimensions& row, const Place& place,
                              std::string_view shown) const {
    const auto refuse = [&] { out_of_reach(place, fmt::format("'*' before {}", shown)); };
    if (!pointer.is_pointer() || !pointer.kind) refuse();
    if (!pointer.object) fail(place, "this pointer is NULL; let it point into an array first");
    const Object& object = *pointer.object;
    std::size_t size = size_of(object.kind);
    for (const std::size_t length : row) size *= length;
    if (pointer.step != size || c_type(*pointer.kind) != c_type(object.kind)) refuse();
    const auto offset = static_cast<std::size_t>(pointer.offset);
    // Without a memory it is a pointer that is read for its type only.
    Lvalue result{pointer.object, offset, {object.memory ? (object.memory->bytes.size() - offset) / size : 0}};
    result.dimensions.insert(result.dimensions.end(), row.begin(), row.end());
    return result;
}

// The row that a pointer moves by, if it moves by more than a number.
Dimensions Reader::row_of(const Value& pointer) {
    const Dimensions* const whole = pointer.object ? &pointer.object->dimensions : nullptr;
    if (whole && whole->size() == 2 && pointer.step == (*whole)[1] * size_of(pointer.object->kind))
        return {(*whole)[1]};
    return {};
}

// (v + 1)[2]; the value of the parenthesis was just read.
Value Reader::subscripted(const Value& pointer, const Token& start) {
    if (dry_ && !pointer.object) out_of_reach(start.place, "an element of this pointer");
    Lvalue place = behind(pointer, row_of(pointer), start.place, "this");
    subscripts(place, start);
    return variable(start, place);
}

// *p, *p++, *(v + 1). What is behind a pointer to rows is a row.
Value Reader::dereferenced() {
    const Dereferenced found = behind_star();
    return found.place ? variable(found.name, *found.place) : zero_of(found.kind);
}

// ++*p and ++(*p); the "++" was just read.
Value Reader::stepped_behind_star(const Token& op) {
    const bool in_parentheses = accept("(");
    const auto [name, kind, place] = behind_star();
    if (in_parentheses) expect(")", "to close the parenthesis");
    if (!place) return zero_of(kind);
    if (!place->dimensions.empty()) out_of_reach(op.place, fmt::format("'{}' before a row", op.text));
    const Token sign{TokenKind::kPunctuation, op.text.substr(0, 1), op.place};
    return assigned(*place, arithmetic(sign, value_of(*place, name.place), integer(1)), name);
}

// Reads from "*" on.
Reader::Dereferenced Reader::behind_star() {
    const Token star = token_;
    if (++program_->depth > kMaxProgramDepth) fail(star.place, "this program is nested too deeply");
    advance();
    const Token name = token_;
    Value pointer;
    Dimensions row;
    if (name.kind == TokenKind::kName && !ahead_.is("(")) {
        advance();
        const std::optional<Lvalue> place = lvalue(name);
        if (!place || place->dimensions.empty()) out_of_reach(star.place, fmt::format("'*' before {}", shown(name)));
        const bool is_moved = place->pointer && is_step(token_);
        pointer = is_moved ? changed_pointer(name, *place) : value_of(*place, name.place);
        row.assign(place->dimensions.begin() + 1, place->dimensions.end());
    } else {
        pointer = prefix();
        row = row_of(pointer);
    }
    --program_->depth;
    if (dry_ && pointer.is_pointer() && pointer.kind && !pointer.object) return {name, *pointer.kind};
    Lvalue place = behind(pointer, row, star.place, shown(name));
    if (!dry_ && place.dimensions[0] == 0)
        fail(star.place, "this pointer is outside {}, which has {} values", place.object->shown,
             place.object->length());
    place.dimensions.erase(place.dimensions.begin());
    return {name, place.object->kind, place};
}

// (*p)++, (*p) = 1 and (*rows)[2]; nullopt for other expressions in parentheses.
std::optional<Value> Reader::dereferenced_in_parentheses() {
    const Program& p = *program_;
    const Token star = ahead_, name = p.tokens[std::min(p.at + 2, p.tokens.size() - 1)];
    if (name.kind != TokenKind::kName || p.partners[p.at] != p.at + 3) return std::nullopt;
    jump(p.at + 3);
    std::optional<Lvalue> place = lvalue(name);
    if (!place || place->dimensions.empty()) out_of_reach(star.place, fmt::format("'*' before {}", shown(name)));
    const Object* const pointer = std::exchange(place->pointer, nullptr);
    const bool is_null = pointer && !pointer->target;
    if (!dry_ && (is_null || place->dimensions[0] == 0))
        fail(star.place, "this pointer is {}", is_null ? "NULL; let it point into an array first" : "behind its array");
    place->dimensions.erase(place->dimensions.begin());
    expect(")", "to close the parenthesis");
    subscripts(*place, name);
    return variable(name, *place);
}

// p = array, p += 3, p++. Returns the pointer's new value, for p++ and p-- the one before.
Value Reader::changed_pointer(const Token& name, const Lvalue& place) {
    const Token op = token_;
    advance();
    const Value before = value_of(place, name.place);
    const Token by{TokenKind::kPunctuation, op.text.substr(0, is_step(op) ? 1 : op.text.size() - 1), op.place};
    const Value right = is_step(op) ? integer(1) : expression();
    const Value after = op.is("=") ? right : combined(by, before, right);
    point(*place.pointer, after, name);
    return is_step(op) ? before : after;
}

}  // namespace twinlight
