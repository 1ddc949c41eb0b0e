// The names that GL gives to new objects, where no driver is there to give them: while a C scene is read.
//
// GL says of the names that glGen* returns only that they were not in use (2.9, 3.8.12, 5.4). RULING: the lowest that no
// command has named before, from 1 on, for each type of object; so a scene gets the same names everywhere.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "scene/command/command.h"

namespace twinlight {

enum class ObjectType : std::uint8_t { kTexture, kBuffer, kList };

// The type of the objects that a parameter names (a GLuint "texture", "buffers", ...); nothing for other parameters.
std::optional<ObjectType> named_objects(const Parameter& parameter);

class ObjectNames {
  public:
    // The first of `count` names in a row that were never taken; 0 if there is no such row.
    std::uint32_t next(ObjectType type, std::uint32_t count) const;
    void take(ObjectType type, double first, double count);
    // The names that a command creates, or uses and by that creates, are taken.
    void follow(const Command& command);

  private:
    std::map<ObjectType, std::map<std::uint64_t, std::uint64_t>> taken_;  // rows of names: first, one past the last
    mutable std::map<ObjectType, std::map<std::uint32_t, std::uint64_t>> searched_;  // by count: where next() ended
};

}  // namespace twinlight
