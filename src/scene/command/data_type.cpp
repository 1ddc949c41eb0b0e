#include "scene/command/data_type.h"

#include "scene/command/memory.h"

namespace twinlight {

std::size_t DataType::leaf_size() const { return size_of(*leaf); }

std::optional<Member> find_member(const DataType& type, std::string_view name) {
    for (const Member& member : type.members) {
        if (member.name == name) return member;
        if (!member.name.empty() || !member.type->is_struct()) continue;
        if (std::optional<Member> inner = find_member(*member.type, name)) {
            inner->offset += member.offset;
            return inner;
        }
    }
    return std::nullopt;
}

// Numbers are told apart by their kind, arrays by their length.
const DataType* DataTypes::derived(const DataType& type) {
    const std::size_t number = type.is_number() ? static_cast<std::size_t>(type.kind) : type.length;
    const DataType*& known = known_[{type.form, type.of, number}];
    if (!known) known = &all_.emplace_back(type);
    return known;
}

const DataType* DataTypes::number(Kind kind) {
    const std::size_t size = size_of(kind);
    return derived(
        {.form = DataType::Form::kNumber, .size = size, .alignment = size, .kind = kind, .leaf = std::optional(kind)});
}

const DataType* DataTypes::pointer_to(const DataType* type) {
    if (type->is_struct() && type->name == "GLUquadric") return number(Kind::kQuadric);
    return derived({.form = DataType::Form::kPointer, .size = kPointerBytes, .alignment = kPointerBytes, .of = type});
}

const DataType* DataTypes::array_of(const DataType* element, std::size_t length) {
    return derived({.form = DataType::Form::kArray,
                    .size = length * element->size,
                    .alignment = element->alignment,
                    .of = element,
                    .length = length,
                    .leaf = element->leaf});
}

const DataType* DataTypes::function(const DataType* result) {
    return derived({.form = DataType::Form::kFunction, .of = result});
}

DataType* DataTypes::new_struct(std::string_view name) {
    return &all_.emplace_back(DataType{.form = DataType::Form::kStruct, .size = 0, .name = name, .is_complete = false});
}

}  // namespace twinlight
