// Pointers, structs and allocated memory of a whole program.
//
// A pointer in memory is an address: the number of the object that it points into in its upper half, the offset in bytes in its lower
// half. So copies of structs copy their pointers, and a pointer whose object has ended is found out.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

constexpr int kOffsetBits = 32;
static_assert(kMaxMemoryBytes < std::uint64_t{1} << kOffsetBits);
constexpr std::size_t kBytesOfAllocation = 256;  // that Twinlight itself needs for an object from malloc
constexpr std::size_t kBytesOfAStep = 64;        // of malloc, memset and memcpy, so that a loop of them ends

}  // namespace

std::uint64_t Reader::address(const Value& pointer) {
    const auto offset = static_cast<std::uint64_t>(pointer.is_pointer() ? pointer.offset : pointer.integer);
    if (!pointer.object) return offset;
    std::uint32_t& number = pointer.object->number;
    if (number == 0) {
        number = ++program_->last_number;
        program_->objects[number] = pointer.object;
    }
    return (std::uint64_t{number} << kOffsetBits) | offset;
}

// The pointer at this address. If its object has ended, it is neither NULL nor in an object.
Value Reader::pointer_from(std::uint64_t address, const DataType* of) const {
    Value pointer{.type = Value::Type::kPointer, .offset = static_cast<std::int64_t>(address), .of = of};
    const auto found = program_->objects.find(static_cast<std::uint32_t>(address >> kOffsetBits));
    const std::uint64_t offset = address & ((std::uint64_t{1} << kOffsetBits) - 1);
    if (found == program_->objects.end() || offset > found->second->bytes()) return pointer;
    pointer.object = found->second;
    pointer.offset = static_cast<std::int64_t>(offset);
    return pointer;
}

// What a pointer points at.
Reader::Lvalue Reader::behind(const Value& pointer, const Place& place) const {
    if (!pointer.is_pointer())
        fail(place, "this needs a pointer or an array, but it is {}",
             pointer.is_struct() ? tr("a struct") : tr("a number"));
    if (!pointer.of || pointer.of->is_void() || !pointer.of->is_complete)
        fail(place, "this pointer needs a type first, as in (float*)pointer");
    if (dry_) return {pointer.object, static_cast<std::size_t>(pointer.offset), pointer.of};
    if (pointer.is_null()) fail(place, "this pointer is NULL; let it point into an array first");
    if (!pointer.object || (!pointer.object->memory && pointer.object->function_name.empty()))
        fail(place,
             "what this pointer pointed at is not there any more: it was freed, or its block or function has ended");
    const auto offset = static_cast<std::size_t>(pointer.offset);
    if (pointer.offset < 0 || offset > pointer.object->bytes() || pointer.object->bytes() - offset < pointer.of->size)
        fail_outside(place, tr("this pointer"), pointer);
    return {pointer.object, offset, pointer.of};
}

// Reads [1] after an array or a pointer.
Reader::Operand Reader::element_of(const Operand& array, const Token& start) {
    if (array.place && array.place->type->is_array()) return {.place = element(*array.place)};
    const Value pointer = value_of(array, start.place);
    const Token bracket = token_;
    advance();
    const Place place = token_.place;
    const Value index = comma_expressions();
    expect("]", "after the index");
    if (!pointer.is_pointer())
        fail(start.place, "{} is neither an array nor a pointer, so it has no elements", shown(start));
    if (dry_) return {.place = behind(pointer, start.place)};
    if (pointer.is_null())
        fail(start.place, "the pointer {} is NULL here; let it point into an array first", shown(start));
    if (!index.is_integer()) fail(place, "an index must be a whole number");
    if (!pointer.object || !pointer.of || !pointer.object->memory) behind(pointer, start.place);  // throws
    Value moved = pointer;
    std::int64_t bytes = 0;
    const bool overflow = __builtin_mul_overflow(index.integer, static_cast<std::int64_t>(pointer.step()), &bytes) ||
                          __builtin_add_overflow(pointer.offset, bytes, &moved.offset);
    const auto size = static_cast<std::int64_t>(pointer.object->bytes());
    if (overflow || moved.offset < 0 || moved.offset > size - static_cast<std::int64_t>(pointer.step()))
        fail_outside(place, tr("this index"), pointer);
    return {.place = behind(moved, start.place)};
}

// Reads .x after a struct and ->x after a pointer to one.
Reader::Operand Reader::member_of(const Operand& whole, const Token& start) {
    const Token op = token_;
    advance();
    const Token name = token_;
    advance();
    std::optional<Lvalue> place = whole.place;
    if (op.is("->") || !place) {
        const Value value = value_of(whole, start.place);
        if (op.is("->"))
            place = behind(value, start.place);
        else if (value.is_struct())
            place = Lvalue{value.object, static_cast<std::size_t>(value.offset), value.of};
    }
    if (!place || !place->type->is_struct()) {
        if (place && place->type->is_pointer() && !op.is("->"))
            fail(op.place, "{} is not a struct but a pointer; write -> instead of '.', so it has no member {}",
                 shown(start), shown(name));
        fail(op.place, "{} is not a struct, so it has no member {}", shown(start), shown(name));
    }
    const std::optional<Member> member = find_member(*place->type, name.text);
    if (!member) {
        std::vector<std::string_view> names;
        for (const Member& known : place->type->members) names.push_back(known.name);
        const auto near = nearest(name.text, names);
        fail(name.place, "this struct has no member {}{}", shown(name), did_you_mean(near));
    }
    return {.place = Lvalue{place->object, place->offset + member->offset, member->type}};
}

// ---- Functions ----

Object& Reader::function_object(const Token& name) {
    Program& p = *program_;
    const auto function = p.functions.find(name.text);
    const bool has_result = function != p.functions.end() && function->second.result;
    const auto [found, is_new] =
        p.function_objects.emplace(name.text, Object{.shown = in_quotes(name.text), .place = name.place});
    if (is_new) found->second.function_name = found->first;
    found->second.type = types_.function(has_result ? function->second.result : types_.nothing());
    return found->second;
}

const Function& Reader::function_behind(const Value& pointer, const Place& place) const {
    if (pointer.is_null() && pointer.is_pointer()) fail(place, "this pointer to a function is NULL");
    const auto found =
        pointer.object ? program_->functions.find(pointer.object->function_name) : program_->functions.end();
    if (found == program_->functions.end()) {
        if (pointer.object && !pointer.object->function_name.empty())
            out_of_reach(place, tr("the function {}, which this file does not define",
                                   in_quotes(pointer.object->function_name)));
        fail(place, "this is not a function");
    }
    return found->second;
}

// ---- Memory ----

// The bytes from a pointer or a struct on, of which there must be `count`.
std::span<std::byte> Reader::bytes_behind(const Value& value, std::size_t count, bool is_written, const Place& place) {
    if (value.is_null()) fail(place, "this pointer is NULL; let it point into an array first");
    if (!value.object || !value.object->memory) fail(place, "this is not the program's memory, or it was freed");
    Object& object = *value.object;
    if (is_written && object.is_constant) fail(place, "a text in quotes cannot be changed");
    const auto offset = static_cast<std::size_t>(value.offset);
    if (value.offset < 0 || offset > object.bytes() || object.bytes() - offset < count)
        fail(place, "{} has only {} bytes here, but {} are needed", object.shown,
             object.bytes() - std::min(offset, object.bytes()), count);
    if (!is_written) check_known(object, offset, count, place);
    program_->steps += count / kBytesOfAStep;
    if (is_written) set_known(object, offset, count);
    Memory& memory = is_written ? writable(object) : *object.memory;
    return std::span(memory.bytes).subspan(offset);
}

// malloc, calloc, realloc, free, memset, memcpy, memmove: nullopt for another name.
std::optional<Value> Reader::call_of_memory(const Token& name) {
    Program& p = *program_;
    constexpr std::pair<std::string_view, std::size_t> kAll[] = {
        {"malloc", 1}, {"calloc", 2}, {"realloc", 2}, {"free", 1}, {"memset", 3}, {"memcpy", 3}, {"memmove", 3}};
    const auto row = std::ranges::find(kAll, name.text, [](const auto& known) { return known.first; });
    if (row == std::end(kAll)) return std::nullopt;
    const std::vector<Value> given = values_in_parentheses();
    if (given.size() != row->second) fail(name.place, "{} takes {}", name.text, arguments_text(row->second));
    const auto size = [&](std::size_t i) {
        if (!given[i].is_integer() || given[i].integer < 0) fail(name.place, "{} needs a size of 0 or more", name.text);
        return static_cast<std::size_t>(given[i].integer);
    };
    const auto allocated = [&](std::size_t bytes, bool known) {
        hold(kBytesOfAllocation, name.place);
        hold(bytes, name.place);
        p.steps += bytes / kBytesOfAStep;
        Object& made = p.heap.emplace_back(Object{.type = types_.nothing(),
                                                  .shown = tr("this memory"),
                                                  .place = name.place,
                                                  .known = known,
                                                  .unknown_because = tr("{} gives it no values", name.text)});
        made.memory = std::make_shared<Memory>(Memory{Kind::kUbyte, std::vector<std::byte>(bytes)});
        made.is_allocated = true;
        return Value{.type = Value::Type::kPointer, .object = &made};
    };
    const auto end = [&](const Value& pointer) {
        if (pointer.is_null()) return;
        if (!pointer.object || !pointer.object->is_allocated || !pointer.object->memory || pointer.offset != 0)
            fail(name.place, "{} needs what malloc has given and nothing has freed", name.text);
        forget(*pointer.object);
    };
    if (name.is("malloc")) return allocated(size(0), false);
    if (name.is("calloc")) {
        if (size(1) != 0 && size(0) > kMaxMemoryBytes / size(1)) hold(kMaxMemoryBytes + 1, name.place);
        return allocated(size(0) * size(1), true);
    }
    if (name.is("free")) {
        end(given[0]);
        return integer(0);
    }
    if (name.is("realloc")) {
        const Value made = allocated(size(1), false);
        if (given[0].object && given[0].object->memory) {
            const std::size_t count = std::min(size(1), given[0].object->bytes());
            std::memcpy(made.object->memory->bytes.data(), given[0].object->memory->bytes.data(), count);
            made.object->known = given[0].object->known;
        }
        end(given[0]);
        return made;
    }
    const std::span<std::byte> to = bytes_behind(given[0], size(2), true, name.place);
    if (name.is("memset")) {
        const auto value = static_cast<std::byte>(in_kind(given[1], Kind::kUbyte, name.place).integer);
        std::fill_n(to.begin(), size(2), value);
    } else {
        std::memmove(to.data(), bytes_behind(given[1], size(2), false, name.place).data(), size(2));
    }
    return given[0];
}

}  // namespace twinlight
