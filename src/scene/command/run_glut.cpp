// GLUT's functions in a whole program, and C's output: windows, callbacks, and what a program asks before its first picture.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

// What glutGet() returns: a screen of 1920 x 1080 pixels, and a window without a border and with 8 bits a colour. freeglut
// returns -1 for names that belong to glutDeviceGet().
constexpr std::pair<std::string_view, int> kAnswersOfGlut[] = {{"GLUT_SCREEN_WIDTH", 1920},
                                                               {"GLUT_SCREEN_HEIGHT", 1080},
                                                               {"GLUT_WINDOW_X", 0},
                                                               {"GLUT_WINDOW_Y", 0},
                                                               {"GLUT_WINDOW_BORDER_WIDTH", 0},
                                                               {"GLUT_WINDOW_HEADER_HEIGHT", 0},
                                                               {"GLUT_WINDOW_BUFFER_SIZE", 32},
                                                               {"GLUT_WINDOW_RED_SIZE", 8},
                                                               {"GLUT_WINDOW_GREEN_SIZE", 8},
                                                               {"GLUT_WINDOW_BLUE_SIZE", 8},
                                                               {"GLUT_WINDOW_ALPHA_SIZE", 8},
                                                               {"GLUT_WINDOW_DEPTH_SIZE", 24},
                                                               {"GLUT_WINDOW_STENCIL_SIZE", 8},
                                                               {"GLUT_WINDOW_NUM_SAMPLES", 0},
                                                               {"GLUT_WINDOW_RGBA", 1},
                                                               {"GLUT_WINDOW_DOUBLEBUFFER", 1},
                                                               {"GLUT_WINDOW_CURSOR", 0},
                                                               {"GLUT_DISPLAY_MODE_POSSIBLE", 1},
                                                               {"GLUT_HAS_JOYSTICK", -1},
                                                               {"GLUT_JOYSTICK_AXES", -1},
                                                               {"GLUT_JOYSTICK_BUTTONS", -1}};

// The arguments of glutInitWindowSize, whose name was just read.
WindowSize Reader::window_size(const Token& name) {
    const std::vector<Value> size = values_in_parentheses();
    if (size.size() != 2) fail(name.place, "glutInitWindowSize takes 2 arguments: width and height");
    const double width = size[0].number(), height = size[1].number();
    if (!(width >= 1 && width <= kMaxWindow && height >= 1 && height <= kMaxWindow))
        fail(name.place, "a window must be from 1 x 1 to {} x {} pixels", kMaxWindow, kMaxWindow);
    return {static_cast<int>(width), static_cast<int>(height)};
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

// What GLUT is given: a function, and in freeglut's forms with user data (glutDisplayFuncUcall) a pointer. nullopt for NULL.
std::optional<Callback> Reader::callback_argument(const Token& name) {
    const bool has_data = name.text.ends_with("Ucall");
    const Place place = ahead_.place;
    const std::vector<Value> given = values_in_parentheses();
    const std::size_t wanted = has_data ? 2 : 1;
    if (given.size() != wanted) fail(name.place, "{} takes {}", name.text, arguments_text(wanted));
    if (given[0].is_null()) return std::nullopt;
    Callback made{.function = function_behind(given[0], place).name};
    made.function.place = place;
    if (has_data) made.data = address(given[1]);
    return made;
}

// glutIdleFunc(f), glutKeyboardFunc(f) or glutTimerFunc(milliseconds, f, value): what runs before later pictures. Other forms
// are passed over.
void Reader::later_function(const Token& name) {
    Program& p = *program_;
    const std::size_t last = p.partners[p.at];
    std::optional<Callback>& callback = name.is("glutIdleFunc")       ? p.idle
                                        : name.is("glutKeyboardFunc") ? p.keyboard
                                                                      : p.timer;
    callback.reset();
    const std::vector<Token>& tokens = p.tokens;
    for (std::size_t i = p.at + 1; i < last; ++i) {
        if (tokens[i].is("(")) i = p.partners[i];
        const bool is_argument = (tokens[i - 1].is("(") || tokens[i - 1].is(",") || tokens[i - 1].is("&")) &&
                                 (tokens[i + 1].is(")") || tokens[i + 1].is(","));
        if (!is_argument || !p.functions.contains(tokens[i].text)) continue;
        callback = Callback{.function = tokens[i]};
        if (!name.is("glutTimerFunc")) return;
        const bool has_value = i + 3 == last && tokens[i + 2].kind == TokenKind::kNumber;
        p.timer_value = has_value ? literal(tokens[i + 2]) : integer(0);
        return;
    }
}

// Makes a window current. The picture is that of the first window, so what is drawn in another one is dropped.
void Reader::go_to_window(int window) {
    Program& p = *program_;
    const bool was_elsewhere = p.is_in_other_window();
    p.current_window = window;
    if (p.is_in_other_window() == was_elsewhere) return;
    if (was_elsewhere) {
        commands_.resize(p.commands_of_picture);
        viewport_ = p.viewport_of_picture;
    } else {
        p.commands_of_picture = commands_.size();
        p.viewport_of_picture = viewport_;
    }
}

// GLUT's functions and C's output: nullopt for another name.
std::optional<Value> Reader::call_of_glut(const Token& name) {
    Program& p = *program_;
    const std::size_t after = p.partners[p.at] + 1;
    const bool is_display = name.is("glutDisplayFunc") || name.is("glutDisplayFuncUcall");
    if (is_display || name.is("glutReshapeFunc") || name.is("glutReshapeFuncUcall")) {
        const std::optional<Callback> callback = callback_argument(name);
        if (!p.is_in_other_window()) (is_display ? p.display : p.reshape) = callback;
        return integer(0);
    }
    if (name.is("glutIdleFunc") || name.is("glutTimerFunc") || name.is("glutKeyboardFunc")) {
        if (!p.is_in_other_window() || !name.is("glutKeyboardFunc")) later_function(name);
        jump(after);
        return integer(0);
    }
    if (name.is("glutInitWindowSize")) {
        const WindowSize size = window_size(name);
        if (!p.options.window && p.windows == 0) p.window = size;
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
        if (asked.is("GLUT_ELAPSED_TIME")) return integer(p.elapsed_ms);
        for (const auto& [known, value] : kAnswersOfGlut)
            if (asked.text == known) return integer(value);
        out_of_reach(name.place, fmt::format("glutGet({})", asked.text));
    }
    if (name.is("glutInitDisplayMode")) {
        for (const Value& mode : values_in_parentheses()) {
            const auto has = [&](std::string_view bit) {
                return mode.is_integer() && (mode.integer & *glut_constant(bit)) != 0;
            };
            if (has("GLUT_INDEX")) out_of_reach(name.place, tr("a window with colour indices"));
            p.asks_for_samples = has("GLUT_MULTISAMPLE");
        }
        return integer(0);
    }
    if (name.is("glutCreateWindow") || name.is("glutCreateSubWindow") || name.is("glutEnterGameMode")) {
        jump(after);
        if (p.windows == 0)
            viewport_ = {0, 0, static_cast<double>(p.window.width), static_cast<double>(p.window.height)};
        go_to_window(++p.windows);
        return integer(p.windows);
    }
    if (name.is("glutSetWindow")) {
        const std::vector<Value> given = values_in_parentheses();
        if (given.size() != 1) fail(name.place, "{} takes {}", name.text, arguments_text(1));
        const std::int64_t window = in_kind(given[0], Kind::kInt, name.place).integer;
        if (window >= 1 && window <= p.windows) go_to_window(static_cast<int>(window));  // GLUT only warns
        return integer(0);
    }
    if (name.is("glutGetWindow")) {
        jump(after);
        return integer(p.current_window);
    }
    if (name.is("glutMainLoop") || name.is("glutMainLoopEvent")) {
        p.reached_main_loop = !p.kept_locals;
        jump(after);
        return integer(0);
    }
    // Functions that change no picture, and those whose callbacks come after the first picture (with user data, also those of
    // later_function).
    constexpr std::string_view kPassedOver[] = {"glutInit",
                                                "glutIdleFunc",
                                                "glutKeyboardFunc",
                                                "glutTimerFunc",
                                                "glutInitDisplayString",
                                                "glutInitWindowPosition",
                                                "glutDestroyWindow",
                                                "glutGetModifiers",
                                                "glutInitErrorFunc",
                                                "glutInitWarningFunc",
                                                "glutRemoveMenuItem",
                                                "glutDestroyMenu",
                                                "glutHideWindow",
                                                "glutPostRedisplay",
                                                "glutSwapBuffers",
                                                "glutPositionWindow",
                                                "glutReshapeWindow",
                                                "glutFullScreen",
                                                "glutSetWindowTitle",
                                                "glutSetIconTitle",
                                                "glutSetCursor",
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
                                                "glutGetMenu",
                                                "glutSetMenuFont",
                                                "glutDeviceGet",
                                                "glutGameModeGet",
                                                "glutGameModeString",
                                                "glutLeaveGameMode",
                                                "glutLeaveMainLoop",
                                                "glutPostWindowRedisplay",
                                                "glutLayerGet",
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
                                                "glutPositionFunc",
                                                "glutMultiEntryFunc",
                                                "glutMultiButtonFunc",
                                                "glutMultiMotionFunc",
                                                "glutMultiPassiveFunc",
                                                "glutMenuDestroyFunc",
                                                "glutAppStatusFunc",
                                                "glutButtonBoxFunc",
                                                "glutDialsFunc",
                                                "glutTabletMotionFunc",
                                                "glutTabletButtonFunc",
                                                "glutForceJoystickFunc",
                                                "glutPushWindow",
                                                "glutOverlayDisplayFunc",
                                                "glewInit",
                                                "gladLoadGL",
                                                "glutShowWindow",
                                                "gluQuadricCallback",
                                                "printf",
                                                "fprintf",
                                                "va_start",
                                                "va_end",
                                                "vprintf",
                                                "vfprintf",
                                                "puts",
                                                "fputs",
                                                "putchar",
                                                "sleep",
                                                "usleep",
                                                "fflush",
                                                "perror",
                                                "assert",
                                                "atexit",
                                                "setbuf"};
    // freeglut's forms with user data end so.
    constexpr std::string_view kUserData = "Ucall";
    std::string_view known = name.text;
    if (known.starts_with("glut") && known.ends_with(kUserData)) known.remove_suffix(kUserData.size());
    if (std::find(std::begin(kPassedOver), std::end(kPassedOver), known) == std::end(kPassedOver)) return std::nullopt;
    jump(after);
    return integer(known == "glutCreateMenu" || name.is("glutGetMenu") || name.is("gladLoadGL") ? 1 : 0);
}

}  // namespace twinlight
