// Writes the commands of a random scene.
#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "judge/fuzz/random_states.h"

namespace twinlight::fuzz {

// What the scene is about; empty: nothing.
std::string_view departure_of(const Seed& seed, Random& structure);

using Id = CommandId;

class Writer {
  public:
    explicit Writer(const Seed& seed)
        : structure_(seed.structure), values_(seed.values), departure_(departure_of(seed, structure_)) {}

  protected:
    void add(Id id, std::vector<double> arguments = {}) {
        // Numbers are rounded to what the driver is given: floats.
        const std::vector<Parameter>& parameters = signature(id).parameters;
        if (!parameters.empty() && parameters.back().kind == Kind::kFloat) {
            for (double& value : arguments) value = static_cast<double>(static_cast<float>(value));
        }
        list_.commands.push_back({id, std::move(arguments), {}});
    }
    bool shows(std::string_view departure) const { return departure_ == departure; }

    // ---- Values ----
    double uniform(double low, double high) { return values_.uniform(low, high); }
    double coordinate() { return uniform(0.05, 1) * (values_.chance(0.5) ? 1 : -1); }
    glm::dvec3 direction() { return glm::normalize(glm::dvec3(coordinate(), coordinate(), coordinate())); }

    // ---- Structure ----
    bool chance(double probability) { return structure_.chance(probability); }
    Enum one_of(std::initializer_list<Enum> choices) {
        return choices.begin()[structure_.below(static_cast<int>(choices.size()))];
    }

    Random structure_, values_;
    std::string_view departure_;
    CommandList list_;
};

}  // namespace twinlight::fuzz
