// The types of C: what a declaration in a scene or a program says of its variable. Used only by read*.cpp and run*.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "scene/command/command.h"

namespace twinlight {

struct DataType;

inline constexpr std::size_t kPointerBytes = 8, kMaxDimensions = 8;

struct Member {
    std::string_view name;
    const DataType* type = nullptr;
    std::size_t offset = 0;  // in bytes
};

// A pointer to GLUquadric is a number: that of the quadric.
struct DataType {
    enum class Form : std::uint8_t { kVoid, kNumber, kPointer, kArray, kStruct, kFunction };
    Form form = Form::kVoid;
    std::size_t size = 1, alignment = 1;  // in bytes; void has 1, so that a pointer to it can move
    Kind kind = Kind::kUbyte;             // of a number
    const DataType* of = nullptr;         // what a pointer points at, an array's elements, a function's result
    std::size_t length = 0;               // of an array; 0 if its values give it
    std::optional<Kind> leaf{};           // the kind of all numbers in it, if it has only those and all are alike
    // Of a struct or a union.
    std::string_view name{};
    std::vector<Member> members{};
    bool is_complete = true, is_union = false;

    bool is_number() const { return form == Form::kNumber; }
    bool is_pointer() const { return form == Form::kPointer; }
    bool is_array() const { return form == Form::kArray; }
    bool is_struct() const { return form == Form::kStruct; }
    bool is_function() const { return form == Form::kFunction; }
    bool is_void() const { return form == Form::kVoid; }
    bool is_character() const { return is_number() && size == 1; }
    std::size_t dimensions() const { return is_array() ? 1 + of->dimensions() : 0; }
    std::size_t values() const { return leaf && size != 0 ? size / leaf_size() : 1; }  // numbers in it
    std::size_t leaf_size() const;
};

// The member of a struct, also of a struct without a name in it; its offset is that in the whole.
std::optional<Member> find_member(const DataType& type, std::string_view name);

// All types of a text. Each exists once, so that equal types have the same address; but each struct is a type of its own.
class DataTypes {
  public:
    const DataType* nothing() const { return &void_; }
    const DataType* number(Kind kind);
    const DataType* pointer_to(const DataType* type);
    const DataType* array_of(const DataType* element, std::size_t length);
    const DataType* function(const DataType* result);
    DataType* new_struct(std::string_view name);
    std::size_t count() const { return all_.size(); }

  private:
    const DataType* derived(const DataType& type);

    const DataType void_{};
    std::deque<DataType> all_;
    std::map<std::tuple<DataType::Form, const DataType*, std::size_t>, const DataType*> known_;
};

}  // namespace twinlight
