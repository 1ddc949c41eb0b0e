// Calls in a whole program: of its own functions, of GL, of C's mathematics and of GLUT.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "scene/command/memory.h"
#include "scene/command/program.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

// The names of GLUT and GLEW that can decide what main and its functions call.
std::optional<int> glut_constant(std::string_view name) {
    constexpr std::pair<std::string_view, int> kAll[] = {{"GLUT_RGB", 0},          {"GLUT_RGBA", 0},
                                                         {"GLUT_INDEX", 1},        {"GLUT_SINGLE", 0},
                                                         {"GLUT_DOUBLE", 2},       {"GLUT_ACCUM", 4},
                                                         {"GLUT_ALPHA", 8},        {"GLUT_DEPTH", 16},
                                                         {"GLUT_STENCIL", 32},     {"GLUT_MULTISAMPLE", 128},
                                                         {"GLUT_STEREO", 256},     {"GLUT_LUMINANCE", 512},
                                                         {"GLUT_LEFT_BUTTON", 0},  {"GLUT_MIDDLE_BUTTON", 1},
                                                         {"GLUT_RIGHT_BUTTON", 2}, {"GLUT_DOWN", 0},
                                                         {"GLUT_UP", 1},           {"GLEW_OK", 0}};
    for (const auto& [known, value] : kAll)
        if (name == known) return value;
    return std::nullopt;
}

std::vector<Value> Reader::values_in_parentheses(const Function* called) {
    std::vector<Value> values;
    expect("(", "after the function's name");
    while (!token_.is(")")) {
        const std::size_t i = values.size();
        if (called && i < called->parameters.size() && called->parameters[i].is_text) {
            skip_expression();
            values.emplace_back();
        } else {
            values.push_back(expression());
        }
        if (!accept(",")) break;
    }
    expect(")", "after the arguments");
    return values;
}

// The arguments of glutInitWindowSize, whose name was just read.
WindowSize Reader::window_size(const Token& name) {
    const std::vector<Value> size = values_in_parentheses();
    if (size.size() != 2) fail(name.place, "glutInitWindowSize takes 2 arguments: width and height");
    const double width = size[0].number(), height = size[1].number();
    if (!(width >= 1 && width <= kMaxWindow && height >= 1 && height <= kMaxWindow))
        fail(name.place, "a window must be from 1 x 1 to {} x {} pixels", kMaxWindow, kMaxWindow);
    return {static_cast<int>(width), static_cast<int>(height)};
}

// The call of a function; its name was just read.
Value Reader::call_in_program(const Token& name) {
    Program& p = *program_;
    const auto function = p.functions.find(name.text);
    if (dry_) {
        jump(p.partners[p.at] + 1);
        if (function != p.functions.end() && function->second.result)
            return in_kind(integer(0), *function->second.result, name.place);
        if (name.text.starts_with("gl") || name.is("abs")) return integer(0);
        return real(0, name.text.ends_with('f'));
    }
    if (function != p.functions.end()) {
        if (function->second.refusal) throw SceneError(*function->second.refusal);
        const std::vector<Value> given = values_in_parentheses(&function->second);
        return run_function(function->second, given, name.place);
    }
    if (find_command_or_extension(name.text)) {
        jump(p.at - 1);
        const Command& command = call();
        const Signature& sig = command.sig();
        if (sig.c_arguments() == sig.parameters.size()) return integer(0);
        const Parameter& result = sig.parameters.back();
        // Scenes with errors are refused, so glGetError returns GL_NO_ERROR.
        if (named_objects(result) || result.kind == Kind::kQuadric || command.id == CommandId::glGetError ||
            command.id == CommandId::glCheckFramebufferStatus)
            return integer(static_cast<std::int64_t>(command.arguments.back()));
        out_of_reach(name.place, fmt::format("the result of {}", sig.name));
    }
    if (const std::optional<Value> result = call_of_mathematics(name)) return *result;
    if (const std::optional<Value> result = call_of_glut(name)) return *result;
    if (name.is("exit")) fail(name.place, "the program ends itself here, before its first picture is complete");
    constexpr std::string_view kOutOfReach[] = {
        "rand",    "random", "drand48", "time",   "clock",  "gettimeofday", "malloc", "calloc", "realloc", "free",
        "fopen",   "fclose", "fread",   "fscanf", "scanf",  "getchar",      "fgets",  "getenv", "atoi",    "atof",
        "sprintf", "strlen", "strcpy",  "strcmp", "memcpy", "memset",       "system", "usleep", "sleep",   "snprintf"};
    // They write texts, which are not kept.
    const bool writes_text = name.is("sprintf") || name.is("snprintf") || name.is("strcpy") || name.is("strcat");
    const Object* const written = writes_text && ahead_.kind == TokenKind::kName ? find_variable(ahead_.text) : nullptr;
    if (written && written->is_text) {
        jump(p.partners[p.at] + 1);
        return integer(0);
    }
    if (std::find(std::begin(kOutOfReach), std::end(kOutOfReach), name.text) != std::end(kOutOfReach))
        out_of_reach(name.place, fmt::format("the function {}", name.text));
    std::vector<std::string_view> names;
    for (const auto& [known, ignored] : p.functions) names.push_back(known);
    for (const Signature& sig : signatures())
        if (sig.family != Family::kPragma) names.push_back(sig.name);
    if (const auto near = nearest(name.text, names))
        fail(name.place, "unknown function {}; did you mean {}? If another file defines it: twinlight record {}",
             in_quotes(name.text), *near, name.place.file ? *name.place.file : "PROGRAM.c");
    out_of_reach(name.place,
                 fmt::format("the function {}, which {}", in_quotes(name.text),
                             is_like_gl(name.text) ? "Twinlight does not know" : "this file does not define"));
}

namespace {

struct OneArgument {
    std::string_view name;
    double (*of_double)(double);
    float (*of_float)(float);
};
#define ROW(name)                                                                          \
    {                                                                                      \
#name, [](double x) { return std::name(x); }, [](float x) { return std::name(x); } \
    }
constexpr OneArgument kOneArgument[] = {ROW(sin),  ROW(cos),  ROW(tan),  ROW(asin),  ROW(acos),  ROW(atan),  ROW(sinh),
                                        ROW(cosh), ROW(tanh), ROW(exp),  ROW(log),   ROW(log2),  ROW(log10), ROW(sqrt),
                                        ROW(cbrt), ROW(fabs), ROW(ceil), ROW(floor), ROW(round), ROW(trunc)};
#undef ROW

struct TwoArguments {
    std::string_view name;
    double (*of_double)(double, double);
    float (*of_float)(float, float);
};
#define ROW(name)                                                                                                   \
    {                                                                                                               \
#name, [](double x, double y) { return std::name(x, y); }, [](float x, float y) { return std::name(x, y); } \
    }
constexpr TwoArguments kTwoArguments[] = {ROW(pow), ROW(atan2), ROW(fmod), ROW(fmin), ROW(fmax), ROW(hypot)};
#undef ROW

}  // namespace

// sin(x), sinf(x), abs(i): nullopt for another name.
std::optional<Value> Reader::call_of_mathematics(const Token& name) {
    const auto given = [&](std::size_t count) {
        std::vector<Value> values = values_in_parentheses();
        for (const Value& value : values)
            if (value.is_pointer()) fail(name.place, "{} takes numbers", name.text);
        if (values.size() != count) fail(name.place, "{} takes {} argument{}", name.text, count, count == 1 ? "" : "s");
        return values;
    };
    if (name.is("abs") || name.is("labs"))
        return integer(std::abs(in_kind(given(1)[0], Kind::kInt, name.place).integer));
    const auto is_float_form = [&](std::string_view known) {
        return name.text.size() == known.size() + 1 && name.text.back() == 'f' && name.text.starts_with(known);
    };
    for (const OneArgument& row : kOneArgument) {
        if (name.text == row.name) return real(row.of_double(given(1)[0].number()), false);
        if (is_float_form(row.name)) {
            const auto x = static_cast<float>(given(1)[0].number());
            return real(static_cast<double>(row.of_float(x)), true);
        }
    }
    for (const TwoArguments& row : kTwoArguments) {
        const bool is_float = is_float_form(row.name);
        if (name.text != row.name && !is_float) continue;
        const std::vector<Value> values = given(2);
        const double x = values[0].number(), y = values[1].number();
        if (!is_float) return real(row.of_double(x, y), false);
        return real(static_cast<double>(row.of_float(static_cast<float>(x), static_cast<float>(y))), true);
    }
    return std::nullopt;
}

namespace {

// Whether all renderers have this extension, given in quotes: the versions up to 2.1 took it over, or it is that of framebuffer
// objects.
bool is_known_extension(std::string_view quoted) {
    constexpr std::string_view kAll[] = {"GL_ARB_depth_texture",
                                         "GL_ARB_multisample",
                                         "GL_ARB_multitexture",
                                         "GL_ARB_point_parameters",
                                         "GL_ARB_shadow",
                                         "GL_ARB_texture_border_clamp",
                                         "GL_ARB_texture_compression",
                                         "GL_ARB_texture_cube_map",
                                         "GL_ARB_texture_env_add",
                                         "GL_ARB_texture_env_combine",
                                         "GL_ARB_texture_env_crossbar",
                                         "GL_ARB_texture_env_dot3",
                                         "GL_ARB_texture_mirrored_repeat",
                                         "GL_ARB_texture_non_power_of_two",
                                         "GL_ARB_transpose_matrix",
                                         "GL_ARB_vertex_buffer_object",
                                         "GL_ARB_window_pos",
                                         "GL_EXT_bgra",
                                         "GL_EXT_blend_color",
                                         "GL_EXT_blend_equation_separate",
                                         "GL_EXT_blend_func_separate",
                                         "GL_EXT_blend_minmax",
                                         "GL_EXT_blend_subtract",
                                         "GL_EXT_draw_range_elements",
                                         "GL_EXT_fog_coord",
                                         "GL_EXT_framebuffer_object",
                                         "GL_EXT_multi_draw_arrays",
                                         "GL_EXT_packed_pixels",
                                         "GL_EXT_polygon_offset",
                                         "GL_EXT_rescale_normal",
                                         "GL_EXT_secondary_color",
                                         "GL_EXT_separate_specular_color",
                                         "GL_EXT_shadow_funcs",
                                         "GL_EXT_stencil_wrap",
                                         "GL_EXT_subtexture",
                                         "GL_EXT_texture",
                                         "GL_EXT_texture3D",
                                         "GL_EXT_texture_edge_clamp",
                                         "GL_EXT_texture_env_add",
                                         "GL_EXT_texture_lod_bias",
                                         "GL_EXT_texture_object",
                                         "GL_EXT_vertex_array",
                                         "GL_SGIS_generate_mipmap",
                                         "GL_SGIS_texture_edge_clamp",
                                         "GL_SGIS_texture_lod"};
    if (quoted.size() < 2) return false;
    const std::string_view name = quoted.substr(1, quoted.size() - 2);
    return std::find(std::begin(kAll), std::end(kAll), name) != std::end(kAll);
}

}  // namespace

// glutIdleFunc(f) or glutTimerFunc(milliseconds, f, value): what runs before the next picture. Other forms are passed over.
void Reader::later_function(const Token& name) {
    Program& p = *program_;
    const std::size_t last = p.partners[p.at];
    std::optional<Token>& function = name.is("glutIdleFunc") ? p.idle : p.timer;
    function.reset();
    const std::vector<Token>& tokens = p.tokens;
    for (std::size_t i = p.at + 1; i < last; ++i) {
        if (tokens[i].is("(")) i = p.partners[i];
        const bool is_argument = (tokens[i - 1].is("(") || tokens[i - 1].is(",") || tokens[i - 1].is("&")) &&
                                 (tokens[i + 1].is(")") || tokens[i + 1].is(","));
        if (!is_argument || !p.functions.contains(tokens[i].text)) continue;
        function = tokens[i];
        if (name.is("glutIdleFunc")) return;
        const bool has_value = i + 3 == last && tokens[i + 2].kind == TokenKind::kNumber;
        p.timer_value = has_value ? literal(tokens[i + 2]) : integer(0);
        return;
    }
}

// GLUT's functions and C's output: nullopt for another name.
std::optional<Value> Reader::call_of_glut(const Token& name) {
    Program& p = *program_;
    const std::size_t after = p.partners[p.at] + 1;
    const bool is_display = name.is("glutDisplayFunc");
    if (is_display || name.is("glutReshapeFunc")) {
        advance();
        accept("&");
        if (token_.kind != TokenKind::kName || !ahead_.is(")"))
            out_of_reach(token_.place, fmt::format("the argument of {}", name.text));
        (is_display ? p.display : p.reshape) = token_;
        if (token_.is("NULL")) (is_display ? p.display : p.reshape).reset();
        jump(after);
        return integer(0);
    }
    if (name.is("glutIdleFunc") || name.is("glutTimerFunc")) {
        later_function(name);
        jump(after);
        return integer(0);
    }
    if (name.is("glutInitWindowSize")) {
        const WindowSize size = window_size(name);
        if (!p.options.window) p.window = size;
        return integer(0);
    }
    if (name.is("glutExtensionSupported")) {
        advance();
        const Token extension = token_;
        jump(after);
        if (is_known_extension(extension.text)) return integer(1);
        out_of_reach(name.place, fmt::format("glutExtensionSupported({})", extension.text));
    }
    if (name.is("glutGet")) {
        advance();
        const Token asked = token_;
        jump(after);
        if (asked.is("GLUT_WINDOW_WIDTH")) return integer(p.window.width);
        if (asked.is("GLUT_WINDOW_HEIGHT")) return integer(p.window.height);
        out_of_reach(name.place, fmt::format("glutGet({})", asked.text));
    }
    if (name.is("glutInitDisplayMode")) {
        for (const Value& mode : values_in_parentheses()) {
            const auto has = [&](std::string_view bit) {
                return mode.is_integer() && (mode.integer & *glut_constant(bit)) != 0;
            };
            if (has("GLUT_INDEX")) out_of_reach(name.place, "a window with colour indices");
            p.asks_for_samples = has("GLUT_MULTISAMPLE");
        }
        return integer(0);
    }
    if (name.is("glutCreateWindow")) {
        if (std::exchange(p.has_window, true)) out_of_reach(name.place, "a second window");
        viewport_ = {0, 0, static_cast<double>(p.window.width), static_cast<double>(p.window.height)};
    }
    if (name.is("glutMainLoop")) {
        p.reached_main_loop = true;
        jump(after);
        return integer(0);
    }
    // Functions that change no picture, and those whose callbacks come after the first picture.
    constexpr std::string_view kPassedOver[] = {"glutInit",
                                                "glutInitDisplayString",
                                                "glutInitWindowPosition",
                                                "glutCreateWindow",
                                                "glutDestroyWindow",
                                                "glutPostRedisplay",
                                                "glutSwapBuffers",
                                                "glutPositionWindow",
                                                "glutReshapeWindow",
                                                "glutFullScreen",
                                                "glutSetWindowTitle",
                                                "glutSetIconTitle",
                                                "glutSetCursor",
                                                "glutKeyboardFunc",
                                                "glutKeyboardUpFunc",
                                                "glutSpecialFunc",
                                                "glutSpecialUpFunc",
                                                "glutMouseFunc",
                                                "glutMouseWheelFunc",
                                                "glutMotionFunc",
                                                "glutPassiveMotionFunc",
                                                "glutEntryFunc",
                                                "glutVisibilityFunc",
                                                "glutWindowStatusFunc",
                                                "glutCloseFunc",
                                                "glutWMCloseFunc",
                                                "glutCreateMenu",
                                                "glutAddMenuEntry",
                                                "glutAddSubMenu",
                                                "glutAttachMenu",
                                                "glutSetMenu",
                                                "glutIgnoreKeyRepeat",
                                                "glutSetKeyRepeat",
                                                "glutSetOption",
                                                "glutInitContextVersion",
                                                "glutInitContextProfile",
                                                "glutIconifyWindow",
                                                "glutPopWindow",
                                                "glutWarpPointer",
                                                "glutJoystickFunc",
                                                "glutMenuStateFunc",
                                                "glutMenuStatusFunc",
                                                "glutDetachMenu",
                                                "glutChangeToMenuEntry",
                                                "glutReportErrors",
                                                "glutSpaceballMotionFunc",
                                                "glutSpaceballRotateFunc",
                                                "glutSpaceballButtonFunc",
                                                "glewInit",
                                                "gladLoadGL",
                                                "glutShowWindow",
                                                "gluQuadricCallback",
                                                "printf",
                                                "fprintf",
                                                "puts",
                                                "fputs",
                                                "putchar",
                                                "fflush",
                                                "perror",
                                                "assert",
                                                "atexit",
                                                "srand",
                                                "srand48",
                                                "srandom",
                                                "setbuf"};
    if (std::find(std::begin(kPassedOver), std::end(kPassedOver), name.text) == std::end(kPassedOver))
        return std::nullopt;
    jump(after);
    return integer(name.is("glutCreateWindow") || name.is("glutCreateMenu") || name.is("gladLoadGL") ? 1 : 0);
}

}  // namespace twinlight
