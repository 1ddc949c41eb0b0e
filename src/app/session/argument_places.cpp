#include "app/session/argument_places.h"

#include <vector>

#include "scene/command/command_set.h"

namespace twinlight::session {

std::string_view effect_of(const Command& command) { return kEffects[static_cast<std::size_t>(command.id)]; }

ArgumentPlace place_of(const Command& command, std::size_t argument) {
    const std::size_t parameters = command.sig().parameters.size();
    std::size_t first = 0;
    for (std::size_t i = 0; i < parameters; ++i) {
        const std::size_t count = command.count(i);
        if (argument < first + count) return {i, argument - first};
        first += count;
    }
    return {parameters == 0 ? 0 : parameters - 1, 0};
}

std::optional<std::size_t> pname_argument(const Command& command) {
    const std::vector<Parameter>& parameters = command.sig().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].name == "pname") return command.first(i);
    return std::nullopt;
}

std::optional<Owner> owner_of_command(const Command& command) {
    return command.id == CommandId::pragma_light ? Owner::kLight : owner_of(command.id);
}

const ParameterInfo* parameter_set(const Command& command) {
    const auto owner = owner_of_command(command);
    const auto pname = pname_argument(command);
    return owner && pname ? find_parameter(*owner, command.enumerant(*pname)) : nullptr;
}

bool is_parameter_value(const Command& command, std::size_t argument) {
    const auto pname = pname_argument(command);
    return owner_of_command(command) && pname && argument > *pname;
}

}  // namespace twinlight::session
