#include "render/programmable/text/bake.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "render/programmable/numbers/program_uniforms.h"

namespace twinlight::programmable {
namespace {

// A GLSL literal that reads back as the same float: "0.1", "1.0", "1e-18".
std::string literal(float x) {
    std::string text = fmt::format("{}", x);
    return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

// The parts of a line "uniform vec3 u_fog_color;  // ...". The name is empty for any other line.
struct Line {
    std::string_view type, name, rest;
};

Line parts_of(std::string_view line) {
    constexpr std::string_view kUniform = "uniform ";
    if (!line.starts_with(kUniform)) return {};
    line.remove_prefix(kUniform.size());
    const std::size_t space = line.find(' '), semicolon = line.find(';');
    return {line.substr(0, space), line.substr(space + 1, semicolon - space - 1), line.substr(semicolon)};
}

template <class Function>
void for_each_line(std::string_view source, const Function& function) {
    for (std::size_t end; !source.empty(); source.remove_prefix(std::min(end + 1, source.size()))) {
        end = std::min(source.find('\n'), source.size());
        function(source.substr(0, end));
    }
}

// The driver may multiply constants with each other first, and these with the others leave the floats.
bool stays_uniform(std::string_view name) { return name == declaration_of(DrawValue::kObjectScale).name; }

std::string with_constants(const std::string& source, const Uniforms& values) {
    std::string text;
    for_each_line(source, [&](std::string_view line) {
        const Line parts = parts_of(line);
        const auto place = parts.name.empty() || stays_uniform(parts.name) ? std::nullopt : values.find(parts.name);
        if (!place) {
            text += line;
        } else {
            std::vector<std::string> literals;
            for (const float x : values[*place].values) literals.push_back(literal(x));
            text += fmt::format("const {0} {1} = {0}({2}){3}", parts.type, parts.name, fmt::join(literals, ", "),
                                parts.rest);
        }
        text += '\n';
    });
    return text;
}

}  // namespace

ShaderSource with_constants(const ShaderSource& source, const Uniforms& values) {
    return {with_constants(source.vertex, values), with_constants(source.fragment, values)};
}

std::set<std::string, std::less<>> uniform_names(const ShaderSource& source) {
    std::set<std::string, std::less<>> names;
    for (const std::string* text : {&source.vertex, &source.fragment})
        for_each_line(*text, [&](std::string_view line) {
            if (const Line parts = parts_of(line); !parts.name.empty()) names.emplace(parts.name);
        });
    return names;
}

}  // namespace twinlight::programmable
