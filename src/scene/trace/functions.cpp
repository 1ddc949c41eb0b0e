#include "scene/trace/functions.h"

#include <algorithm>
#include <array>
#include <string>

#include "scene/trace/window_formats.h"

namespace twinlight::trace {

namespace {

bool starts_with_one_of(std::string_view name, std::initializer_list<std::string_view> starts) {
    return std::any_of(starts.begin(), starts.end(),
                       [name](std::string_view start) { return name.starts_with(start); });
}

// Queries change nothing, and the program has already used their results.
bool is_query(std::string_view name) {
    return starts_with_one_of(name, {"glGet", "glIs", "glQuery", "glAreTexturesResident", "glCheckFramebufferStatus",
                                     "glReadPixels", "glReadnPixels"});
}

// Functions that alone change no pixel: names of objects that Twinlight lacks, shaders and uniforms without
// glUseProgram, color index mode, hints about memory, marks for debuggers.
bool is_without_effect(std::string_view name) {
    return starts_with_one_of(name, {"glGen",
                                     "glDelete",
                                     "glCreate",
                                     "glCompileShader",
                                     "glShaderSource",
                                     "glAttach",
                                     "glDetach",
                                     "glLink",
                                     "glUniform",
                                     "glBindAttribLocation",
                                     "glBindFragDataLocation",
                                     "glValidateProgram",
                                     "glDisableVertexAttribArray",
                                     "glProgram",
                                     "glIndex",
                                     "glClearIndex",
                                     "glPrioritizeTextures",
                                     "glDebugMessage",
                                     "glPushDebugGroup",
                                     "glPopDebugGroup",
                                     "glObjectLabel",
                                     "glObjectPtrLabel",
                                     "glStringMarker",
                                     "glInsertEventMarker",
                                     "glPushGroupMarker",
                                     "glPopGroupMarker",
                                     "glFrameTerminator",
                                     "glLockArrays",
                                     "glUnlockArrays",
                                     "glFence",
                                     "glClientWaitSync",
                                     "glWaitSync",
                                     "glBeginQuery",
                                     "glEndQuery",
                                     "glReadBuffer",
                                     "glFeedbackBuffer",
                                     "glSelectBuffer",
                                     "glPassThrough",
                                     "glReleaseShaderCompiler",
                                     "glSampleMaski",
                                     "glTexBarrier",
                                     "glMemoryBarrier"});
}

bool is_of_window_system(std::string_view name) {
    return starts_with_one_of(name, {"glX", "wgl", "CGL", "egl", "glut"});
}

bool ends_frame(std::string_view name) {
    return starts_with_one_of(name, {"glXSwapBuffers", "eglSwapBuffers", "wglSwapBuffers", "wglSwapLayerBuffers",
                                     "CGLFlushDrawable", "glutSwapBuffers"}) ||
           name == "SwapBuffers";
}

bool makes_current(std::string_view name) {
    return starts_with_one_of(name, {"glXMakeCurrent", "glXMakeContextCurrent", "eglMakeCurrent", "wglMakeCurrent",
                                     "wglMakeContextCurrent", "CGLSetCurrentContext"});
}

// glVertex3f, glVertex2sv, but not glVertexPointer.
bool is_vertex(std::string_view name) {
    if (name == "glArrayElement" || name.starts_with("glEvalCoord") || name.starts_with("glEvalPoint")) return true;
    constexpr std::string_view kStart = "glVertex";
    return name.starts_with(kStart) && name.size() > kStart.size() && name[kStart.size()] >= '2' &&
           name[kStart.size()] <= '4';
}

bool draws_something(std::string_view name) {
    if (name.starts_with("glDrawBuffer")) return false;
    return name == "glBegin" || starts_with_one_of(name, {"glDraw", "glMultiDraw", "glRect", "glCallList", "glBitmap",
                                                          "glCopyPixels", "glEvalMesh", "glBlitFramebuffer"});
}

bool makes_objects(std::string_view name) {
    return name == "glNewList" ||
           starts_with_one_of(name, {"glTexImage", "glTexSubImage", "glCopyTex", "glBufferData"});
}

bool names_shared(std::string_view name) {
    return name == "glNewList" || starts_with_one_of(name, {"glBindTexture", "glBindBuffer", "glCallList"});
}

bool sets_units(std::string_view name) {
    return name == "glEnable" || name == "glDisable" ||
           starts_with_one_of(name, {"glActiveTexture", "glTexEnv", "glTexGen", "glBindTexture"});
}

Function classify(std::string_view name) {
    Function function{.draws = draws_something(name),
                      .is_vertex = is_vertex(name),
                      .makes_context = makes_context(name),
                      .names_format = WindowFormats::is_needed(name),
                      .makes_objects = makes_objects(name),
                      .names_shared = names_shared(name),
                      .is_mark = name == "glStringMarkerGREMEDY",
                      .sets_units = sets_units(name)};
    const std::optional<CommandId> command = find_command_or_extension(name);
    if (ends_frame(name)) {
        function.role = Role::kFrameEnd;
    } else if (makes_current(name)) {
        function.role = Role::kMakeCurrent;
    } else if (is_query(name) || is_of_window_system(name)) {
        function.role = Role::kIgnored;
    } else if (name.starts_with("glMapBuffer")) {  // later writes become glBufferSubData
        function.role = Role::kMapBuffer;
    } else if (name.starts_with("glUnmapBuffer")) {
        function.role = Role::kIgnored;
    } else if (command) {
        function.role = Role::kCommand;
        function.command = *command;
    } else if (name == "memcpy") {
        function.role = Role::kCopy;
    } else if (name.starts_with("glBlitFramebuffer")) {
        function.role = Role::kBlit;
    } else if (name.starts_with("glRenderbufferStorageMultisample")) {
        function.role = Role::kStorage;
    } else if (name == "glPolygonOffsetEXT") {
        function.role = Role::kDepthOffset;
    } else if (is_without_effect(name)) {
        function.role = Role::kIgnored;
    } else if (starts_with_one_of(name, {"glUseProgram", "glBind"})) {
        function.role = Role::kBinding;
    }
    return function;
}

struct LaterName {
    std::string_view name;
    Enum value;
};
constexpr std::array kLaterNames = {
    LaterName{"GL_CLIP_DISTANCE0", kGL_CLIP_PLANE0}, LaterName{"GL_CLIP_DISTANCE1", kGL_CLIP_PLANE1},
    LaterName{"GL_CLIP_DISTANCE2", kGL_CLIP_PLANE2}, LaterName{"GL_CLIP_DISTANCE3", kGL_CLIP_PLANE3},
    LaterName{"GL_CLIP_DISTANCE4", kGL_CLIP_PLANE4}, LaterName{"GL_CLIP_DISTANCE5", kGL_CLIP_PLANE5},
    LaterName{"GL_COMPARE_REF_TO_TEXTURE", 0x884E},  LaterName{"GL_PROGRAM_POINT_SIZE", 0x8642},
};

}  // namespace

bool makes_context(std::string_view name) {
    return name == "glXCreateContext" || name == "glXCreateNewContext" || name == "glXCreateContextAttribsARB" ||
           name == "eglCreateContext";
}

const Function& FunctionTable::find(std::string_view name) {
    constexpr std::size_t kMostNames = 4096;  // more than GL has; a hostile dump may contain any number
    if (const auto found = known_.find(name); found != known_.end()) return found->second;
    if (known_.size() < kMostNames) return known_.emplace(std::string(name), classify(name)).first->second;
    return other_ = classify(name);
}

std::optional<Enum> find_dumped_name(std::string_view name) {
    if (const auto value = find_gl_name(name)) return value;
    const auto later =
        std::find_if(kLaterNames.begin(), kLaterNames.end(), [name](const LaterName& row) { return row.name == name; });
    if (later != kLaterNames.end()) return later->value;
    return find_gl_name_or_extension(name);
}

}  // namespace twinlight::trace
