// Prints commands as C. The text compiles, and reading it gives the same commands.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <span>

#include "scene/command/memory.h"
#include "scene/command/named_matrix.h"
#include "scene/command/object_names.h"
#include "scene/command/print_parts.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

// The shortest decimal that reads back as the same value of its type.
std::string print_real(double value, bool is_float) {
    if (std::isnan(value)) return "NAN";
    if (std::isinf(value)) return value < 0 ? "-INFINITY" : "INFINITY";
    if (value == 0 && std::signbit(value)) return "-0.0";
    if (is_float) {
        // The shortest decimal of the float is read as a double and then rounded. That nearly always gives the same
        // float; if not, print the digits of the double.
        const std::string shortest = fmt::format("{}", static_cast<float>(value));
        if (static_cast<double>(static_cast<float>(std::strtod(shortest.c_str(), nullptr))) == value) return shortest;
    }
    return fmt::format("{}", value);
}

std::string print_number(double value, Kind kind) {
    switch (kind) {
        case Kind::kFloat: return print_real(value, true);
        case Kind::kDouble: return print_real(value, false);
        case Kind::kBitfield: return bit_names(static_cast<Enum>(value));
        case Kind::kWord: return std::string(word_name(static_cast<Word>(static_cast<Enum>(value))));
        case Kind::kQuadric: return fmt::format("quadric{}", value);
        default: return fmt::format("{}", static_cast<std::int64_t>(value));
    }
}

// Whether the values for this pname are GL names: glFogi(GL_FOG_MODE, GL_LINEAR).
bool takes_names(const Command& command) {
    const ParameterInfo* info = parameter_info(command);
    return info && info->meaning == Meaning::kEnum;
}

// The bits of glPushClientAttrib have the same values as some of glPushAttrib.
std::string client_bit_names(Enum mask) {
    if (mask == kGL_CLIENT_ALL_ATTRIB_BITS) return "GL_CLIENT_ALL_ATTRIB_BITS";
    if (mask == kGL_CLIENT_PIXEL_STORE_BIT) return "GL_CLIENT_PIXEL_STORE_BIT";
    if (mask == kGL_CLIENT_VERTEX_ARRAY_BIT) return "GL_CLIENT_VERTEX_ARRAY_BIT";
    return fmt::format("{:#x}", mask);
}

}  // namespace

std::string value_name(CommandId command, Enum value) {
    switch (command) {
        case CommandId::glBegin:
        case CommandId::glDrawArrays:
        case CommandId::glDrawElements:
        case CommandId::glDrawRangeElements: return primitive_name(value);
        case CommandId::glBlendFunc:
        case CommandId::glBlendFuncSeparate:
            if (value == kGL_ONE) return "GL_ONE";
            [[fallthrough]];
        case CommandId::glStencilOp:
        case CommandId::glStencilOpSeparate:
            if (value == kGL_ZERO) return "GL_ZERO";
            break;
        case CommandId::glDrawBuffer:
        case CommandId::glReadBuffer:
            if (value == kGL_NONE) return "GL_NONE";
            break;
        default: break;
    }
    return enum_name(value);
}

namespace {

std::string print_value(const Command& command, const Parameter& parameter, double value) {
    if (parameter.kind == Kind::kEnum) return value_name(command.id, static_cast<Enum>(value));
    if (command.id == CommandId::glPushClientAttrib) return client_bit_names(static_cast<Enum>(value));
    const bool named = parameter.name.starts_with("param") && takes_names(command) && value > kGL_POLYGON &&
                       value == std::trunc(value) && value <= 0xFFFF;
    if (named) return enum_name(static_cast<Enum>(value));
    if (parameter.kind == Kind::kBoolean && (value == 0 || value == 1)) return value == 0 ? "GL_FALSE" : "GL_TRUE";
    return print_number(value, parameter.kind);
}

std::string print_array(const Command& command, std::size_t i) {
    const Parameter& parameter = command.sig().parameters[i];
    const std::string_view type = c_type_name(parameter.kind);
    if (parameter.extent == Extent::kOutput || parameter.extent == Extent::kOutputByPname) {
        constexpr int kLongestAnswer = 64;  // longer than the result for any name that is not in the table
        const std::optional<Enum> pname =
            parameter.is_by_pname() ? std::optional(command.enumerant(command.first(i) - 1)) : std::nullopt;
        return fmt::format("({}[{}]){{0}}", type, array_length(command.id, pname).value_or(kLongestAnswer));
    }
    if (parameter.extent == Extent::kOutputByCount) {
        return fmt::format("({}[{}]){{0}}", type, std::max<std::size_t>(1, command.counted(i)));
    }
    std::vector<std::string> values;
    for (double value : command.values(i)) values.push_back(print_value(command, parameter, value));
    const bool is_counted = parameter.extent == Extent::kArrayByCount || parameter.extent == Extent::kNewNames ||
                            parameter.extent == Extent::kControlPoints;
    if (is_counted && values.empty()) return fmt::format("({}[1]){{0}}", type);  // C has no empty arrays
    return fmt::format("({}[]){{{}}}", type, fmt::join(values, ", "));
}

// ---- Memory ----

// An array of this many bytes for a command to write to.
std::string print_written(double bytes) { return bytes == 0 ? "NULL" : fmt::format("(GLubyte[{}]){{0}}", bytes); }

// The values, separated by commas. If `indent` is not empty, they are broken into lines that start with it.
std::string print_values(const Memory& memory, Kind kind, std::string_view indent) {
    constexpr std::size_t kColumns = 110;
    std::string printed;
    std::size_t column = 0;
    const std::size_t size = size_of(kind);
    for (std::size_t at = 0; at < memory.bytes.size(); at += size) {
        const double value = load(std::span(memory.bytes).subspan(at), kind);
        const std::string text = is_real(kind) ? print_real(value, kind == Kind::kFloat)
                                               : fmt::format("{}", static_cast<std::int64_t>(value));
        if (at > 0) printed += ",";
        if (!indent.empty() && (at == 0 || column + text.size() > kColumns)) {
            printed.append("\n").append(indent);
            column = 0;
        } else if (at > 0) {
            printed += " ";
        }
        printed += text;
        column += text.size() + 2;
    }
    return printed;
}

// Whether reading the printed values gives the same bytes. A NaN may change, and a part of a value may be left over.
bool survives(const Memory& memory) {
    const std::size_t size = size_of(memory.kind);
    if (memory.bytes.size() % size != 0) return false;
    if (memory.kind == Kind::kSizeiptr) {  // a double has too few digits for large values
        for (std::size_t at = 0; at < memory.bytes.size(); at += size) {
            if (std::abs(load(std::span(memory.bytes).subspan(at), memory.kind)) >= 0x1p53) return false;
        }
    }
    if (!is_real(memory.kind)) return true;
    for (std::size_t at = 0; at < memory.bytes.size(); at += size) {
        if (std::isnan(load(std::span(memory.bytes).subspan(at), memory.kind))) return false;
    }
    return true;
}

// A Memory in C: the name of an array or a compound literal, and the kind of its values.
struct PrintedArray {
    std::string text;
    Kind kind = Kind::kUbyte;
};

PrintedArray print_literal(const Memory& memory) {
    const Kind kind = survives(memory) ? memory.kind : Kind::kUbyte;
    return {fmt::format("(const {}[]){{{}}}", c_type_name(kind), print_values(memory, kind, "")), kind};
}

// The arrays that a printed scene declares: each Memory once, even if several commands use it.
class MemoryNames {
  public:
    // Adds the declaration to `text` if the memory is new.
    PrintedArray name(const Memory& memory, std::string_view indent, std::string& text) {
        if (memory.bytes.empty()) return print_literal(memory);  // C has no empty arrays
        const auto [known, is_new] = names_.try_emplace(&memory);
        if (!is_new) return known->second;
        const std::string_view bytes(reinterpret_cast<const char*>(memory.bytes.data()), memory.bytes.size());
        PrintedArray& equal = equals_[{memory.kind, bytes}];  // equal bytes are declared once
        if (equal.text.empty()) {
            equal = {fmt::format("memory{}", equals_.size()), survives(memory) ? memory.kind : Kind::kUbyte};
            text += fmt::format("{}static const {} {}[] = {{{}}};\n", indent, c_type_name(equal.kind), equal.text,
                                print_values(memory, equal.kind, fmt::format("{}    ", indent)));
        }
        return known->second = equal;
    }

  private:
    std::map<const Memory*, PrintedArray> names_;
    std::map<std::pair<Kind, std::string_view>, PrintedArray> equals_;
};

// `array` is the command's memory, if it has any.
std::string print_pointer(const Command& command, std::size_t i, const PrintedArray& array) {
    const auto offset = static_cast<std::int64_t>(command.number(command.first(i)));
    if (!command.memory) return offset == 0 ? "NULL" : fmt::format("(const void*){}", offset);
    const auto size = static_cast<std::int64_t>(size_of(array.kind));
    if (offset == 0) return array.text;
    return offset % size == 0 ? fmt::format("{} + {}", array.text, offset / size)
                              : fmt::format("(const char*){} + {}", array.text, offset);
}

// As text_argument() reads it: the format of printf that gives this text.
std::string print_text(std::string_view text) {
    std::string printed = "\"";
    for (const char c : text) printed += c == '%' ? std::string("%%") : std::string(1, c);
    return printed + "\"";
}

std::string print(const Command& command, const PrintedArray& array) {
    const Signature& sig = command.sig();
    if (command.id == CommandId::gluNewQuadric) {
        return fmt::format("GLUquadric* {} = gluNewQuadric();", print_number(command.number(0), Kind::kQuadric));
    }
    std::vector<std::string> arguments;
    for (std::size_t i = 0; i < sig.parameters.size(); ++i) {
        const Parameter& parameter = sig.parameters[i];
        if (parameter.is_array()) {
            arguments.push_back(print_array(command, i));
        } else if (parameter.extent == Extent::kValue) {
            arguments.push_back(print_value(command, parameter, command.number(command.first(i))));
        } else if (parameter.extent == Extent::kPointer) {
            arguments.push_back(print_pointer(command, i, array));
        } else if (parameter.extent == Extent::kOutputMemory) {
            arguments.push_back(print_written(command.number(command.first(i))));
        } else if (parameter.extent == Extent::kImage || parameter.extent == Extent::kMesh) {
            arguments.push_back(fmt::format("\"{}\"", command.memory->file));
        } else if (parameter.extent == Extent::kText) {
            arguments.push_back(print_text(command.text()));
        } else if (parameter.extent == Extent::kRest) {
            for (double value : command.values(i)) arguments.push_back(print_number(value, parameter.kind));
        }
    }
    if (sig.family == Family::kPragma) {
        return fmt::format("#pragma twinlight {}({})", sig.name, fmt::join(arguments, ", "));
    }
    return fmt::format("{}({});", sig.name, fmt::join(arguments, ", "));
}

// One line per command, indented by `indent`; pragmas are not indented.
std::string print_lines(const CommandList& scene, std::string_view indent) {
    std::string text;
    MemoryNames memories;
    ObjectNames names;
    for (std::size_t i = 0; i < scene.commands.size(); ++i) {
        const Command& command = scene.commands[i];
        if (const std::string name = named_matrix(std::span(scene.commands).subspan(i)); !name.empty())
            text += fmt::format("{}// the matrix of {}\n", indent, name);
        const bool has_array = command.memory && command.sig().family != Family::kPragma;
        const PrintedArray array = has_array ? memories.name(*command.memory, indent, text) : PrintedArray{};
        // The result of a call, if it differs from the one that the reader would choose.
        const Signature& sig = command.sig();
        const bool has_result = sig.c_arguments() < sig.parameters.size();
        const auto type = has_result ? named_objects(sig.parameters.back()) : std::nullopt;
        if (type) {
            const auto range = static_cast<std::uint32_t>(std::max(0.0, command.number(0)));
            const double expected = range == 0 ? 0 : names.next(*type, range);
            if (command.arguments.back() != expected) {
                text += fmt::format("#pragma twinlight returns({})\n", command.arguments.back());
            }
        }
        names.follow(command);
        if (sig.family != Family::kPragma) text += indent;
        text += print(command, array) + "\n";
    }
    return text;
}

}  // namespace

std::vector<PrintedPart> print_parts(const Command& command, std::size_t longest_array) {
    const Signature& sig = command.sig();
    if (command.id == CommandId::gluNewQuadric) return {{print_command(command)}};
    const bool is_pragma = sig.family == Family::kPragma;
    std::vector<PrintedPart> parts{{fmt::format("{}{}(", is_pragma ? "#pragma twinlight " : "", sig.name)}};
    const auto add = [&](std::string text, std::optional<std::size_t> argument = std::nullopt) {
        if (!argument && !parts.back().argument)
            parts.back().text += text;
        else
            parts.push_back({std::move(text), argument});
    };
    const auto add_values = [&](std::size_t i) {
        const std::size_t first = command.first(i);
        for (std::size_t k = 0; k < command.values(i).size(); ++k) {
            if (k > 0) add(", ");
            const double value = command.values(i)[k];
            add(sig.parameters[i].is_array() ? print_value(command, sig.parameters[i], value)
                                             : print_number(value, sig.parameters[i].kind),
                first + k);
        }
    };
    for (std::size_t i = 0; i < sig.c_arguments(); ++i) {
        const Parameter& parameter = sig.parameters[i];
        const std::size_t count = command.values(i).size();
        if (i > 0 && (parameter.extent != Extent::kRest || count > 0)) add(", ");
        if (parameter.is_array() && !parameter.is_output() && count > 0) {
            const std::string_view type = c_type_name(parameter.kind);
            if (count > longest_array) {
                add(fmt::format("({}[{}]){{...}}", type, count));
                continue;
            }
            add(fmt::format("({}[]){{", type));
            add_values(i);
            add("}");
        } else if (parameter.is_array()) {
            add(print_array(command, i));
        } else if (parameter.extent == Extent::kValue) {
            add(print_value(command, parameter, command.number(command.first(i))), command.first(i));
        } else if (parameter.extent == Extent::kPointer && command.memory) {
            add(fmt::format("({} bytes)", command.memory->bytes.size()));
        } else if (parameter.extent == Extent::kPointer) {
            add(print_pointer(command, i, {}));
        } else if (parameter.extent == Extent::kOutputMemory) {
            add(print_written(command.number(command.first(i))));
        } else if (parameter.extent == Extent::kImage || parameter.extent == Extent::kMesh) {
            add(fmt::format("\"{}\"", command.memory->file));
        } else if (parameter.extent == Extent::kText) {
            add(print_text(command.text()));
        } else if (parameter.extent == Extent::kRest) {
            add_values(i);
        }
    }
    add(is_pragma ? ")" : ");");
    return parts;
}

std::string print_command(const Command& command) {
    const bool has_array = command.memory && command.sig().family != Family::kPragma;
    return print(command, has_array ? print_literal(*command.memory) : PrintedArray{});
}

namespace {

std::string print_window_size(const WindowSize& window) {
    return fmt::format("glutInitWindowSize({}, {});\n", window.width, window.height);
}

}  // namespace

std::string print_scene(const CommandList& scene) {
    const WindowSize window = scene.window.value_or(WindowSize{});
    return (window == WindowSize{} ? "" : print_window_size(window)) + print_lines(scene, "");
}

std::string print_c_function(const CommandList& scene, std::string_view name) {
    return fmt::format("static void {}(void) {{\n", name) + print_lines(scene, "    ") + "}\n";
}

namespace {

// What a window needs for the scene: the bits of glClear, and GLUT's names.
struct Buffers {
    std::string bits = "GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT", modes = "GLUT_DEPTH";
    bool is_single = false;
};

Buffers buffers_of(const CommandList& scene) {
    const auto uses = [&scene](const auto& is_use) { return std::ranges::any_of(scene.commands, is_use); };
    Buffers buffers;
    if (uses([](const Command& c) { return c.id == CommandId::glEnable && c.enumerant(0) == kGL_STENCIL_TEST; })) {
        buffers.bits += " | GL_STENCIL_BUFFER_BIT";
        buffers.modes += " | GLUT_STENCIL";
    }
    if (uses([](const Command& c) { return c.id == CommandId::glAccum; })) {
        buffers.bits += " | GL_ACCUM_BUFFER_BIT";
        buffers.modes += " | GLUT_ACCUM";
    }
    // A program with GLUT_SINGLE: its scene draws to the front buffer alone.
    const auto draws_to = [&](std::initializer_list<Enum> names) {
        return uses([&](const Command& c) {
            return c.id == CommandId::glDrawBuffer && std::ranges::find(names, c.enumerant(0)) != names.end();
        });
    };
    buffers.is_single = draws_to({kGL_FRONT, kGL_FRONT_LEFT}) && !draws_to({kGL_BACK, kGL_BACK_LEFT});
    return buffers;
}

}  // namespace

std::string print_c_program(const CommandList& scene) {
    const Buffers buffers = buffers_of(scene);
    const WindowSize window = scene.window.value_or(WindowSize{});
    std::string title;  // without '*', so that the name cannot end the comment
    for (char c : scene.name) title += (c >= 0x20 && c < 0x7F && c != '*') ? c : '_';
    std::string text = fmt::format(
        "/* {}{}\n"
        "   Build it with: cc -std=c99 FILE.c -lglut -lGLU -lGL -lm */\n"
        "#define GL_GLEXT_PROTOTYPES\n"
        "#include <GL/freeglut.h>\n#include <math.h>\n\n",
        title, kPrintedProgram);
    text += print_c_function(scene, "draw_scene");
    text +=
        "\n"
        "static void display(void) {\n"
        "    /* The scene sets all its state itself, so each picture starts from GL's initial state. */\n"
        "    glPushAttrib(GL_ALL_ATTRIB_BITS);\n"
        "    glClear(" +
        buffers.bits +
        ");\n"
        "    glMatrixMode(GL_PROJECTION);\n    glLoadIdentity();\n"
        "    glMatrixMode(GL_MODELVIEW);\n    glLoadIdentity();\n"
        "    draw_scene();\n"
        "    glPopAttrib();\n"
        "    " +
        (buffers.is_single ? "glFlush" : "glutSwapBuffers") +
        "();\n"
        "}\n\n"
        "int main(int argc, char** argv) {\n"
        "    glutInit(&argc, argv);\n"
        "    glutInitDisplayMode(GLUT_RGBA | " +
        (buffers.is_single ? "GLUT_SINGLE | " : "GLUT_DOUBLE | ") + buffers.modes +
        ");\n"
        "    " +
        print_window_size(window) +
        "    glutCreateWindow(argv[0]);\n"
        "    glutDisplayFunc(display);\n"
        "    glutMainLoop();\n"
        "    return 0;\n"
        "}\n";
    return text;
}

}  // namespace twinlight
