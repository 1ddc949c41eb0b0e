#include "scene/record/compile.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>

#include "base/image/file.h"
#include "base/text/translation.h"
#include "scene/command/cpp_words.h"
#include "scene/command/text.h"
#include "scene/trace/process.h"
#include "scene/trace/temporary_folder.h"

namespace twinlight::trace {

namespace {

namespace fs = std::filesystem;

bool is_c(const std::string& file) { return extension_of(file) == ".c" && !has_cpp_name(file); }

// Headers of Windows, of macOS, of old C++, and of systems where letters of names have no case: one line each.
void write_headers(const fs::path& folder) {
    const std::vector<std::string> folders = {"GL", "gl", "Gl", "GLUT", "glut", "Glut", "OpenGL", "opengl", ""};
    const auto write = [&](const std::vector<std::string>& names, const std::string& line) {
        for (const std::string& in : folders)
            for (const std::string& name : names) {
                if (in == "GL" && line.find("GL/" + name + ">") != line.npos) continue;  // it would include itself
                fs::create_directories(folder / in);
                write_file_atomically((folder / in / name).string(), line + "\n");
            }
    };
    write({"glut.h", "Glut.h", "GLUT.h", "GLUT.H"}, "#include <GL/glut.h>");
    write({"freeglut.h", "Freeglut.h", "FreeGlut.h"}, "#include <GL/freeglut.h>");
    write({"gl.h", "Gl.h", "GL.h", "GL.H"}, "#include <GL/gl.h>");
    write({"glu.h", "Glu.h", "GLu.h", "GLU.h", "GLU.H"}, "#include <GL/glu.h>");
    // Of C++ before 1998.
    for (const std::string name : {"iostream", "fstream", "iomanip"})
        write_file_atomically((folder / (name + ".h")).string(), "#include <" + name + ">\nusing namespace std;\n");
    for (const char* name : {"windows.h", "Windows.h", "WINDOWS.H"})
        write_file_atomically((folder / name).string(), "// Only Windows needs it.\n");
}

struct Attempt {
    bool made = false;
    std::string messages;
};

Attempt attempt(const Build& build, const std::string& headers, const std::string& program) {
    const bool all_c = std::ranges::all_of(build.sources, is_c);
    const std::string compiler = all_c ? "cc" : "c++";
    // Its messages are read here, so they are in English.
    std::vector<std::string> arguments = {"env",    "-u", "LANGUAGE",   "LC_ALL=C.UTF-8",
                                          compiler, "-g", "-idirafter", headers};
    for (const std::string& option : build.options)
        if (!option.starts_with("-l")) arguments.push_back(option);
    for (const std::string& source : build.sources)
        // A name that starts with - is no option.
        arguments.insert(arguments.end(),
                         {"-x", is_c(source) ? "c" : "c++", source.starts_with('-') ? "./" + source : source});
    arguments.insert(arguments.end(), {"-x", "none", "-o", program});
    for (const std::string& option : build.options)
        if (option.starts_with("-l")) arguments.push_back(option);
    for (const char* library : {"-lglut", "-lGLU", "-lGL", "-lm"}) arguments.emplace_back(library);
    need(compiler, all_c ? "gcc" : "g++", tr("compiling a program"));
    const Descriptor messages = nameless_file();
    const pid_t process = start({arguments, -1, messages.get(), messages.get(), "."});
    if (process <= 0) throw SceneError("env: " + std::string(tr(std::strerror(errno))));
    const int status = wait_for(process);
    return {WIFEXITED(status) && WEXITSTATUS(status) == 0, written_to(messages)};
}

std::set<std::string> missing_functions(const std::string& messages) {
    constexpr std::string_view kStart = "undefined reference to ";
    std::set<std::string> names;
    for (std::size_t at = messages.find(kStart); at != messages.npos; at = messages.find(kStart, at + 1)) {
        const std::size_t name = at + kStart.size() + 1;  // after ` or ' or "
        const std::size_t end = messages.find_first_of("'\"(", name);
        if (name < messages.size() && end != name) names.insert(messages.substr(name, end - name));
    }
    return names;
}

// The header that the compiler did not find; "" if that is not the error.
std::string missing_header(const std::string& messages) {
    constexpr std::string_view kStart = "fatal error: ", kEnd = ": No such file";
    for (std::size_t at = messages.find(kStart); at != messages.npos; at = messages.find(kStart, at + 1)) {
        const std::size_t name = at + kStart.size(), end = messages.find(':', name);
        if (end != messages.npos && messages.compare(end, kEnd.size(), kEnd) == 0)
            return messages.substr(name, end - name);
    }
    return "";
}

// The sources in the folders of these that are not among them and have no main().
std::vector<std::string> other_sources(const std::vector<std::string>& sources) {
    constexpr std::size_t kMostFiles = 50, kMostText = 4u << 20;
    std::set<fs::path> folders, given;
    for (const std::string& source : sources) {
        const fs::path folder = fs::path(source).parent_path();
        folders.insert(folder.empty() ? "." : folder);
        given.insert(fs::absolute(source).lexically_normal());
    }
    std::vector<std::string> found;
    for (const fs::path& folder : folders) {
        std::error_code error;
        for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
            const std::string file = at->path().lexically_normal().string();
            if (!is_source(file) || given.contains(fs::absolute(file).lexically_normal())) continue;
            if (!at->is_regular_file(error) || at->file_size(error) > kMostText) continue;
            if (!has_main(read_file(file))) found.push_back(file);
        }
    }
    std::ranges::sort(found);
    if (found.size() > kMostFiles) found.clear();  // no folder of one program
    return found;
}

// Why the program cannot be compiled with the other files of its folder.
std::string with_others(const std::string& messages) {
    const std::string error = first_error(messages);
    return error.empty() ? "" : tr(" (with the other files of its folder: {})", error);
}

bool is_of_gl(const std::string& function) {
    return function.starts_with("gl") && function.size() > 2 &&
           (std::isupper(static_cast<unsigned char>(function[2])) != 0 || function.starts_with("glu"));
}

}  // namespace

bool is_source(const std::string& file) { return is_c(file) || has_cpp_name(file); }

bool is_python(const std::string& file) { return extension_of(file) == ".py"; }

bool has_main(std::string_view source) {
    constexpr std::string_view kMain = "main";
    const auto is_of_name = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
    for (std::size_t at = source.find(kMain); at != source.npos; at = source.find(kMain, at + 1)) {
        if (at > 0 && is_of_name(source[at - 1])) continue;
        const std::size_t next = source.find_first_not_of(" \t\n\v\f\r", at + kMain.size());
        if (next != source.npos && source[next] == '(') return true;
    }
    return false;
}

std::string first_error(const std::string& messages) {
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);) {
        if (line.find(": error: ") == line.npos && line.find(": fatal error: ") == line.npos) continue;
        return line.find("ld returned") == line.npos ? one_line(line) : "";
    }
    return "";
}

Compiled compile(const Build& build, const std::string& program) {
    const std::string& name = build.sources.front();
    const TemporaryFolder headers;
    write_headers(headers.path());
    const Attempt first = attempt(build, headers.path(), program);
    if (first.made) return {};
    const std::set<std::string> missing = missing_functions(first.messages);
    Compiled compiled{.messages = first.messages};
    if (!missing.empty()) {
        Build larger = build;
        compiled.others = other_sources(build.sources);
        larger.sources.insert(larger.sources.end(), compiled.others.begin(), compiled.others.end());
        const Attempt second = compiled.others.empty() ? Attempt{} : attempt(larger, headers.path(), program);
        if (second.made) return {.others = compiled.others};
        if (std::ranges::all_of(missing, [](const std::string& function) { return !is_of_gl(function); }))
            compiled.messages.clear();  // the linker's, which are long
        compiled.failure =
            missing.contains("main") ? tr("{}: it has no main(); give the file that has it, too", name)
            : std::ranges::any_of(missing, is_of_gl)
                ? tr("{}: {} is not in freeglut, GLU and GL; -lNAME adds a library, as -lGLEW", name,
                     *std::ranges::find_if(missing, is_of_gl))
                : tr("{}: it calls {}, which is in no file given here; it needs its project's other files: compile it "
                     "as usual and run 'twinlight record ./program'{}",
                     name, *missing.begin(), with_others(second.messages));
        return compiled;
    }
    const bool lacks_library = first.messages.find("cannot find -lglut") != std::string::npos ||
                               first.messages.find("cannot find -lGLU") != std::string::npos ||
                               first.messages.find("GL/glut.h: No such file") != std::string::npos;
    const std::string header = missing_header(first.messages);
    compiled.failure = tr("{}: it cannot be compiled, see above", name);
    if (lacks_library)
        compiled.failure += tr("; freeglut and GLU are in the packages freeglut3-dev and libglu1-mesa-dev");
    else if (!header.empty())
        compiled.failure += tr(
            "; if {} is in another folder, -IDIR names it; or compile it as usual and run 'twinlight record ./program'",
            header);
    return compiled;
}

}  // namespace twinlight::trace
