#include "render/programmable/text/shader_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "render/programmable/text/shader_assembly.h"

namespace twinlight::programmable {
namespace {

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
    std::vector<std::string_view> parts;
    for (std::size_t end; (end = text.find(separator)) != text.npos; text.remove_prefix(end + separator.size()))
        parts.push_back(text.substr(0, end));
    if (!text.empty()) parts.push_back(text);
    return parts;
}

// Without the comments.
template <class Visit>
void for_each_line_of_code(std::string_view text, const Visit& visit) {
    for (const std::string_view line : split(text, "\n")) visit(line.substr(0, line.find("//")));
}

// ---- Directives ----

// "A && !B || C" over the scope's switches.
bool holds(std::string_view condition, const Scope& scope) {
    const auto term = [&](std::string_view text) {
        text = trimmed(text);
        const bool negated = text.starts_with('!');
        const auto found = scope.switches.find(text.substr(negated));
        if (found == scope.switches.end())
            throw std::logic_error(fmt::format("unknown effect in a shader file: {}", text));
        return found->second != negated;
    };
    return std::ranges::any_of(split(condition, "||"), [&](std::string_view product) {
        return std::ranges::all_of(split(product, "&&"), term);
    });
}

struct Branch {
    bool outer = true;   // the lines around the #if are kept
    bool taken = false;  // this branch's lines are kept
    bool done = false;   // a branch of this #if has been taken

    void take(bool condition) {
        taken = outer && !done && condition;
        done |= taken;
    }
};

}  // namespace

std::string_view file_text(std::string_view name) {
    for (const EmbeddedFile& file : kShaderFiles)
        if (file.name == name) return file.text;
    throw std::logic_error(fmt::format("there is no shader file {}", name));
}

std::string with_words(std::string_view text, const Words& words) {
    std::string result;
    for_each_token(text, [&](std::string_view token, bool is_identifier) {
        const auto word = is_identifier ? words.find(token) : words.end();
        result += word == words.end() ? token : word->second;
    });
    return result;
}

std::string with_variable(std::string_view text, std::string_view variable, std::string_view replacement) {
    std::string result;
    for_each_token(text, [&](std::string_view token, bool is_identifier) {
        const bool is_it = is_identifier && token == variable && !result.ends_with('.');
        result += is_it ? replacement : token;
    });
    return result;
}

std::string preprocessed(std::string_view file, const Scope& scope) {
    std::string text;
    std::vector<Branch> branches;
    const auto passes = [&] { return branches.empty() || branches.back().taken; };
    for (const std::string_view line : split(file_text(file), "\n")) {
        const std::size_t space = line.find(' ');
        const std::string_view directive = line.starts_with('#') ? line.substr(0, space) : "";
        const std::string_view argument = directive.empty() || space == line.npos ? "" : trimmed(line.substr(space));
        if (directive == "#if") {
            branches.push_back({.outer = passes()});
            branches.back().take(holds(argument, scope));
        } else if (directive == "#elif") {
            branches.back().take(holds(argument, scope));
        } else if (directive == "#else") {
            branches.back().take(true);
        } else if (directive == "#endif") {
            branches.pop_back();
        } else if (!passes()) {
            continue;
        } else if (directive == "#include") {
            text += preprocessed(argument.substr(1, argument.size() - 2), scope);
        } else if (directive == "#insert") {
            const auto insert = scope.inserts.find(argument);
            if (insert == scope.inserts.end())
                throw std::logic_error(fmt::format("{} inserts {}, but there is no text of that name", file, argument));
            text += insert->second;
        } else {
            text += with_words(line, scope.words) + "\n";
        }
    }
    if (!branches.empty()) throw std::logic_error(fmt::format("{}: an #if has no #endif", file));
    return text;
}

std::vector<Definition> definitions(std::string_view file, const Words& words) {
    std::vector<Definition> result;
    std::string text;
    for (const std::string_view line : split(file_text(file), "\n")) {
        if (line.empty()) {
            text.clear();  // a comment on the whole file
            continue;
        }
        text += with_words(line, words) + "\n";
        const bool is_uniform = line.starts_with("uniform ") || line == "};";
        if (!is_uniform && line != "}") continue;
        // The last identifier before a bracket or a semicolon, in the first line of code.
        std::string_view code = text;
        while (code.starts_with("//")) code.remove_prefix(code.find('\n') + 1);
        code = trimmed(code.substr(0, code.find_first_of("({[;")));
        result.push_back({std::string(code.substr(code.rfind(' ') + 1)), std::move(text), is_uniform});
        text.clear();
    }
    return result;
}

std::vector<Definition> used_definitions(const std::vector<Definition>& library, std::string_view text) {
    std::set<std::string, std::less<>> named;
    const auto add = [&](std::string_view of) {
        for_each_line_of_code(of, [&](std::string_view line) {
            for_each_token(line, [&](std::string_view token, bool is_identifier) {
                if (is_identifier) named.emplace(token);
            });
        });
    };
    add(text);
    std::vector<Definition> result;
    for (auto definition = library.rbegin(); definition != library.rend(); ++definition) {
        if (!named.contains(definition->name)) continue;
        add(definition->text);
        result.push_back(*definition);
    }
    std::ranges::reverse(result);
    return result;
}

std::string with_used_members(const Definition& definition, std::string_view text) {
    constexpr std::string_view kEnding = "Parameters";
    if (!definition.name.ends_with(kEnding)) return definition.text;
    const std::string_view variable =
        std::string_view(definition.name).substr(0, definition.name.size() - kEnding.size());
    std::set<std::string_view> used;
    for (std::size_t at = 0; (at = text.find(variable, at)) != text.npos;) {
        at += variable.size();
        std::string_view rest = text.substr(at);
        if (rest.starts_with('[')) rest.remove_prefix(std::min(rest.find(']') + 1, rest.size()));
        if (!rest.starts_with('.')) continue;
        rest.remove_prefix(1);
        used.insert(rest.substr(0, rest.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")));
    }
    std::string result;
    for (const std::string_view line : split(definition.text, "\n")) {
        const std::string_view code = line.substr(0, line.find(';'));
        if (line.starts_with("    ") && !used.contains(code.substr(code.rfind(' ') + 1))) continue;
        result += std::string(line) + "\n";
    }
    return result;
}

void check_uniforms_are_declared(std::string_view shader) {
    std::set<std::string_view> declared, used;
    for_each_line_of_code(shader, [&](std::string_view line) {
        for_each_token(line, [&](std::string_view token, bool is_identifier) {
            if (is_identifier && token.starts_with("u_"))
                (line.starts_with("uniform ") ? declared : used).insert(token);
        });
    });
    for (const std::string_view name : used)
        if (!declared.contains(name))
            throw std::logic_error(fmt::format(
                "a shader uses {}, but its effects and form do not list it; see program_uniforms.cpp", name));
}

}  // namespace twinlight::programmable
