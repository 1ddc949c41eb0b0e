// Printing commands as C. What is printed compiles, and reads back as the same commands.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "command/text.h"

namespace twinlight {

namespace {

std::string_view c_type_name(Kind kind) {
    switch (kind) {
        case Kind::kEnum: return "GLenum";
        case Kind::kBitfield: return "GLbitfield";
        case Kind::kBoolean: return "GLboolean";
        case Kind::kByte: return "GLbyte";
        case Kind::kShort: return "GLshort";
        case Kind::kInt: return "GLint";
        case Kind::kSizei: return "GLsizei";
        case Kind::kUbyte: return "GLubyte";
        case Kind::kUshort: return "GLushort";
        case Kind::kUint: return "GLuint";
        case Kind::kFloat: return "GLfloat";
        case Kind::kDouble: return "GLdouble";
        case Kind::kSizeiptr: return "GLsizeiptr";
        case Kind::kWord: break;  // words stand in pragmas only, never in arrays
    }
    return "";
}

// The shortest decimal that reads back as the same value of its type.
std::string print_real(double value, bool is_float) {
    if (std::isnan(value)) return "NAN";
    if (std::isinf(value)) return value < 0 ? "-INFINITY" : "INFINITY";
    if (value == 0 && std::signbit(value)) return "-0.0";
    if (is_float) {
        // A decimal that is shortest for the float is read as a double first and rounded again: it nearly always comes
        // back the same; where it does not, the double's own digits do.
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
        default: return fmt::format("{}", static_cast<std::int64_t>(value));
    }
}

// Whether the values that a pname asks for are names: glFogi(GL_FOG_MODE, GL_LINEAR).
bool takes_names(const Command& command) {
    const ParameterInfo* info = parameter_info(command);
    return info && info->meaning == Meaning::kEnum;
}

std::string print_value(const Command& command, const Parameter& parameter, double value) {
    if (parameter.kind == Kind::kEnum) {
        const Enum e = static_cast<Enum>(value);
        return command.id == CommandId::glBegin ? primitive_name(e) : enum_name(e);
    }
    const bool named = parameter.name.starts_with("param") && takes_names(command) && value > kGL_POLYGON &&
                       value == std::trunc(value) && value <= 0xFFFF;
    if (named) return enum_name(static_cast<Enum>(value));
    if (parameter.kind == Kind::kBoolean && (value == 0 || value == 1)) return value == 0 ? "GL_FALSE" : "GL_TRUE";
    return print_number(value, parameter.kind);
}

std::string print_array(const Command& command, const Parameter& parameter) {
    const std::string_view type = c_type_name(parameter.kind);
    if (parameter.extent == Extent::kOutput) {
        constexpr int kLongestAnswer = 4;
        const Enum pname = command.enumerant(command.sig().scalars() - 1);
        return fmt::format("({}[{}]){{0}}", type, array_length(command.id, pname).value_or(kLongestAnswer));
    }
    std::vector<std::string> values;
    for (double value : command.array()) values.push_back(print_value(command, parameter, value));
    return fmt::format("({}[]){{{}}}", type, fmt::join(values, ", "));
}

}  // namespace

std::string print_command(const Command& command) {
    const Signature& sig = command.sig();
    std::vector<std::string> arguments;
    for (std::size_t i = 0; i < sig.parameters.size(); ++i) {
        const Parameter& parameter = sig.parameters[i];
        if (parameter.extent == Extent::kValue) {
            arguments.push_back(print_value(command, parameter, command.number(i)));
        } else if (parameter.extent == Extent::kRest) {
            for (double value : command.array()) arguments.push_back(print_number(value, parameter.kind));
        } else {
            arguments.push_back(print_array(command, parameter));
        }
    }
    if (sig.family == Family::kPragma) {
        return fmt::format("#pragma twinlight {}({})", sig.name, fmt::join(arguments, ", "));
    }
    return fmt::format("{}({});", sig.name, fmt::join(arguments, ", "));
}

std::string print_scene(const CommandList& scene) {
    std::string text;
    for (const Command& command : scene.commands) text += print_command(command) + "\n";
    return text;
}

std::string print_c_program(const CommandList& scene) {
    std::string title;  // a name must not end the comment
    for (char c : scene.name) title += (c >= 0x20 && c < 0x7F && c != '*') ? c : '_';
    std::string text = fmt::format(
        "/* {}: a scene of Twinlight as a C program.\n"
        "   Build it with: cc -std=c99 FILE.c -lglut -lGLU -lGL -lm */\n"
        "#include <GL/freeglut.h>\n#include <math.h>\n\n"
        "static void draw_scene(void) {{\n",
        title);
    for (const Command& command : scene.commands) {
        text += (command.sig().family == Family::kPragma ? "" : "    ") + print_command(command) + "\n";
    }
    text +=
        "}\n\n"
        "static void display(void) {\n"
        "    /* The scene sets all its state itself, so start each picture from GL's own. */\n"
        "    glPushAttrib(GL_ALL_ATTRIB_BITS);\n"
        "    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
        "    glMatrixMode(GL_PROJECTION);\n    glLoadIdentity();\n"
        "    glMatrixMode(GL_MODELVIEW);\n    glLoadIdentity();\n"
        "    draw_scene();\n"
        "    glPopAttrib();\n"
        "    glutSwapBuffers();\n"
        "}\n\n"
        "int main(int argc, char** argv) {\n"
        "    glutInit(&argc, argv);\n"
        "    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH);\n"
        "    glutInitWindowSize(640, 480);\n"
        "    glutCreateWindow(argv[0]);\n"
        "    glutDisplayFunc(display);\n"
        "    glutMainLoop();\n"
        "    return 0;\n"
        "}\n";
    return text;
}

}  // namespace twinlight
