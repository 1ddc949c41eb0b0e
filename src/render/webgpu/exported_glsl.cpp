#include "render/webgpu/exported_glsl.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace twinlight::webgpu {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \n");
    if (begin == text.npos) return "";
    return std::string(text.substr(begin, text.find_last_not_of(" \n") - begin + 1));
}

int number_in(std::string_view text) {
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

// "flat out vec4 name[2]" without its semicolon.
Variable variable_of(std::string_view text) {
    Variable result{.type = {}, .name = {}};
    std::vector<std::string> words;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t begin = std::min(rest.find_first_not_of(' '), rest.size());
        rest.remove_prefix(begin);
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (end > 0) words.emplace_back(rest.substr(0, end));
        rest.remove_prefix(end);
    }
    if (words.size() < 2) throw std::logic_error("exported GLSL: no variable: " + std::string(text));
    result.is_flat = words.front() == "flat";
    result.type = words[words.size() - 2];
    result.name = words.back();
    if (const std::size_t bracket = result.name.find('['); bracket != std::string::npos) {
        result.length = number_in(std::string_view(result.name).substr(bracket + 1));
        if (result.length == 0) result.length = 1;  // LIGHT_COUNT, in kept_uniforms.glsl
        result.name.resize(bracket);
    }
    return result;
}

// "    vec4 ambient;  // a_cm"
Variable declared(std::string_view line) {
    const std::size_t semicolon = line.find(';'), slashes = line.find("//");
    Variable result = variable_of(line.substr(0, semicolon));
    if (slashes != line.npos) result.comment = trimmed(line.substr(slashes + 2));
    return result;
}

class Reader {
  public:
    explicit Reader(std::string_view text) : rest_(text) {}

    Shader shader() {
        while (!rest_.empty()) read(next());
        return std::move(shader_);
    }

  private:
    std::string_view next() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return line;
    }

    void read(std::string_view line) {
        if (line.starts_with("//")) {
            above_ += std::string(line) + "\n";
        } else if (line.empty()) {
            if (shader_.heading.empty()) shader_.heading = above_;
            above_.clear();
        } else if (line.starts_with("struct ")) {
            read_struct(line);
        } else if (line.starts_with("uniform ")) {
            shader_.uniforms.push_back(declared(line));
            above_.clear();
        } else if (line.starts_with("layout(location = ")) {
            Variable input = declared(line.substr(line.find(')') + 1));
            input.location = number_in(line.substr(18));
            shader_.inputs.push_back(std::move(input));
        } else if (line.starts_with("in ") || line.starts_with("flat in ")) {
            shader_.inputs.push_back(declared(line));
        } else if (line.starts_with("out ") || line.starts_with("flat out ")) {
            shader_.outputs.push_back(declared(line));
        } else if (line.ends_with("{")) {
            read_function(line);
        } else if (!line.starts_with("#version") && !line.starts_with("precision ") &&
                   !line.starts_with("invariant ")) {
            throw std::logic_error("exported GLSL has a line that is not known: " + std::string(line));
        }
    }

    void read_struct(std::string_view first) {
        Struct result{.name = trimmed(first.substr(7, first.find('{') - 7)), .above = std::exchange(above_, {})};
        std::string_view line;
        while (!(line = next()).starts_with("}")) result.members.push_back(declared(line));
        // A uniform has it if the next line is one.
        if (rest_.starts_with("uniform "))
            shader_.uniform_structs.push_back(std::move(result));
        else
            shader_.definitions.push_back({.is_struct = true, .structure = std::move(result)});
    }

    void read_function(std::string_view first) {
        const std::size_t open = first.find('('), close = first.rfind(')');
        const Variable named = variable_of(first.substr(0, open));
        Function result{.type = named.type, .name = named.name, .above = std::exchange(above_, {})};
        for (std::string_view list = first.substr(open + 1, close - open - 1); !list.empty();) {
            const std::size_t comma = std::min(list.find(','), list.size());
            result.parameters.push_back(variable_of(list.substr(0, comma)));
            list.remove_prefix(std::min(comma + 1, list.size()));
        }
        result.text = std::string(first) + "\n";
        std::string_view line;
        while ((line = next()) != "}") {
            result.body += std::string(line) + "\n";
            if (rest_.empty()) throw std::logic_error("exported GLSL: a function does not end: " + result.name);
        }
        result.text += result.body + "}\n";
        shader_.definitions.push_back({.is_struct = false, .function = std::move(result)});
    }

    std::string_view rest_;
    std::string above_;
    Shader shader_;
};

}  // namespace

Shader read_shader(std::string_view text) { return Reader(text).shader(); }

std::vector<Variable> uniforms_of(const Kind& kind) {
    std::vector<Variable> uniforms = kind.vertex.uniforms;
    for (const Variable& uniform : kind.fragment.uniforms)
        if (std::ranges::find(uniforms, uniform.name, &Variable::name) == uniforms.end()) uniforms.push_back(uniform);
    return uniforms;
}

std::string comment_behind(const Variable& one) { return one.comment.empty() ? "" : "  // " + one.comment; }

bool mentions(std::string_view text, std::string_view identifier) {
    for (std::size_t at = text.find(identifier); at != text.npos; at = text.find(identifier, at + 1)) {
        const std::size_t end = at + identifier.size();
        if ((at > 0 && is_word(text[at - 1])) || (end < text.size() && is_word(text[end]))) continue;
        const std::size_t line = text.rfind('\n', at) == text.npos ? 0 : text.rfind('\n', at) + 1;
        const std::size_t comment = text.substr(line).find("//");
        if (comment == text.npos || line + comment > at) return true;
    }
    return false;
}

void remove_point_size(Shader& vertex_shader) {
    std::string& body = vertex_shader.definitions.back().function.body;
    const std::size_t begin = body.find("    gl_PointSize = ");
    if (begin == body.npos) return;
    body.erase(begin, body.find('\n', begin) + 1 - begin);
    const auto is_used = [&](const std::string& name) {
        return name == "main" || std::ranges::any_of(vertex_shader.definitions, [&](const Definition& one) {
                   return !one.is_struct && one.function.name != name && mentions(one.function.body, name);
               });
    };
    std::erase_if(vertex_shader.definitions,
                  [&](const Definition& one) { return !one.is_struct && !is_used(one.function.name); });
    std::erase_if(vertex_shader.uniforms, [&](const Variable& one) { return !is_used(one.name); });
}

}  // namespace twinlight::webgpu
