// Chooses the names (numbers) of new GL objects while a C scene is read, when no driver can choose them.
//
// GL requires only that the names from glGen* were unused (2.9, 3.8.12, 5.4). RULING: each type of object gets the
// lowest numbers, from 1 on, that no earlier command has used. So a scene gets the same names everywhere.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "scene/command/command.h"

namespace twinlight {

enum class ObjectType : std::uint8_t { kTexture, kBuffer, kList, kFramebuffer, kRenderbuffer };

// The type of object that a parameter names ("texture", "buffers", "list", ...); nullopt for other parameters.
std::optional<ObjectType> named_objects(const Parameter& parameter);

class ObjectNames {
  public:
    // The first of `count` consecutive unused names; 0 if there are not so many.
    std::uint32_t next(ObjectType type, std::uint32_t count) const;
    void take(ObjectType type, double first, double count);
    // Takes the names that a command creates, including those that it creates by using them.
    void follow(const Command& command);

  private:
    std::map<ObjectType, std::map<std::uint64_t, std::uint64_t>> taken_;  // ranges of names: first, one past the last
    mutable std::map<ObjectType, std::map<std::uint32_t, std::uint64_t>> searched_;  // by count: where next() stopped
};

}  // namespace twinlight
