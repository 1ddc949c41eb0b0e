#include "scene/trace/call_stacks.h"

#include <cxxabi.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/image/file.h"

namespace twinlight::trace {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostStacks = 1 << 16, kMostSource = 4u << 20;

// The program's, and not those of a library of the system or of a header of the compiler's.
bool is_own(const CallFrame& frame) {
    const auto is_of_system = [](std::string_view path) {
        return path.starts_with("/usr/") || path.starts_with("/lib/") || path.starts_with("/lib64/");
    };
    return frame.line > 0 && !is_of_system(frame.module) && !is_of_system(frame.file);
}

// "MODULE: FUNCTION+0xOFFSET: FILE:LINE", where all but the module may be missing.
CallFrame read_frame(std::string_view text) {
    CallFrame frame;
    const std::size_t end = std::min(text.find(": "), text.size());
    frame.module = text.substr(0, end);
    text.remove_prefix(std::min(end + 2, text.size()));
    const std::size_t after = std::min(text.find(": "), text.size());
    frame.function = text.substr(0, std::min(text.rfind("+0x", after), after));
    text.remove_prefix(std::min(after + 2, text.size()));
    const std::size_t colon = text.rfind(':');
    if (colon == text.npos) return frame;
    const std::string_view digits = text.substr(colon + 1);
    std::from_chars(digits.data(), digits.data() + digits.size(), frame.line);
    frame.file = text.substr(0, colon);
    return frame;
}

// "Body::draw" of "Body::draw(int) const", or of _ZNK4Body4drawEi, which the stack of a crash has.
std::string without_parameters(std::string_view function) {
    const std::string name(function);
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> readable(
        name.starts_with("_Z") ? abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status) : nullptr, std::free);
    if (readable) function = readable.get();
    const std::size_t last = function.rfind(')');
    if (last == function.npos) return std::string(function);
    int depth = 0;
    for (std::size_t at = last + 1; at-- > 0;) {
        if (function[at] == ')') ++depth;
        if (function[at] == '(' && --depth == 0) return std::string(function.substr(0, at));
    }
    return std::string(function);
}

// Relative to the working folder for a file below it.
std::string shown_path(std::string_view file) {
    const fs::path path = fs::path(file).lexically_normal();
    std::error_code error;
    const fs::path folder = fs::current_path(error);
    if (error || path.is_relative()) return path.string();
    const fs::path near = path.lexically_relative(folder);
    return near.empty() || *near.begin() == ".." ? path.string() : near.string();
}

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Where a line has the name as a whole word; npos if it has not.
std::size_t find_name(std::string_view line, std::string_view name) {
    for (std::size_t at = line.find(name); at != line.npos && !name.empty(); at = line.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !is_of_name(line[at - 1])) && (end == line.size() || !is_of_name(line[end]))) return at;
    }
    return line.npos;
}

// The first word such as glutSolidSphere.
std::size_t find_gl(std::string_view line) {
    for (std::size_t at = line.find("gl"); at != line.npos; at = line.find("gl", at + 1)) {
        std::string_view rest = line.substr(at + 2);
        if (rest.starts_with("ut")) rest.remove_prefix(2);
        if (rest.starts_with('u')) rest.remove_prefix(1);
        const bool starts = at == 0 || !is_of_name(line[at - 1]);
        if (starts && !rest.empty() && std::isupper(static_cast<unsigned char>(rest[0])) != 0) return at;
    }
    return line.npos;
}

std::string_view line_of(std::string_view text, int number) {
    for (; number > 1; --number) {
        const std::size_t end = text.find('\n');
        if (end == text.npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find('\n'));
}

int column_of(std::string_view line, std::string_view function, std::string_view of_library) {
    std::size_t at = find_name(line, function);
    if (at == line.npos) at = find_name(line, of_library);
    if (at == line.npos) at = find_gl(line);
    if (at == line.npos) at = std::min(line.find_first_not_of(" \t"), line.size());
    // Columns count characters, whose later bytes in UTF-8 start with the bits 10.
    const std::string_view before = line.substr(0, at);
    return 1 + static_cast<int>(std::ranges::count_if(before, [](char c) { return (c & 0xC0) != 0x80; }));
}

// What a program's text is written in, so that a recording of a stranger makes no other file readable.
bool is_source_name(const std::string& file) {
    static constexpr std::array kExtensions = {".c",   ".cc",  ".cpp", ".cxx", ".c++", ".h",  ".hh",
                                               ".hpp", ".hxx", ".inl", ".ipp", ".inc", ".py", ".tcc"};
    return std::ranges::find(kExtensions, extension_of(file)) != kExtensions.end();
}

}  // namespace

std::vector<CallFrame> frames_of(std::string_view stack) {
    std::vector<CallFrame> frames;
    while (!stack.empty()) {
        frames.push_back(read_frame(stack.substr(0, stack.find('\n'))));
        stack.remove_prefix(std::min(stack.find('\n'), stack.size() - 1) + 1);
    }
    return frames;
}

std::shared_ptr<const std::string> SourceTexts::find(const std::string& file) {
    const auto [found, is_new] = texts_.try_emplace(file);
    if (!is_new) return found->second;
    std::error_code ignored;
    if (!is_source_name(file) || !fs::is_regular_file(file, ignored)) return nullptr;
    try {
        found->second = std::make_shared<const std::string>(read_file(file, kMostSource));
    } catch (const FileError&) {  // then messages have no text of the line
    }
    return found->second;
}

std::shared_ptr<const std::string> CallStacks::shared(std::string text) {
    const auto [found, is_new] = names_.try_emplace(std::move(text));
    if (is_new) found->second = std::make_shared<const std::string>(found->first);
    return found->second;
}

const Place& CallStacks::place(std::string_view stack, std::string_view function,
                               const std::function<std::vector<CallFrame>(std::string_view)>& frames) {
    std::string key(stack);
    key += function;
    if (places_.size() >= kMostStacks) places_.clear();
    const auto [found, is_new] = places_.try_emplace(std::move(key));
    if (is_new) found->second = read(frames(stack), function);
    return found->second;
}

Place CallStacks::read(const std::vector<CallFrame>& stack, std::string_view function) {
    std::optional<CallFrame> innermost;
    std::string_view of_library;  // the function that the innermost own frame calls
    std::vector<std::string> chain;
    for (const CallFrame& frame : stack) {
        if (is_own(frame)) {
            if (!innermost) innermost = frame;
            chain.push_back(without_parameters(frame.function));
        } else if (!innermost) {
            of_library = frame.function;
        }
    }
    if (!innermost) return {};
    const std::string file = shown_path(innermost->file);
    const auto text = sources_.find(file);
    const std::string_view line = text ? line_of(*text, innermost->line) : std::string_view();
    std::ranges::reverse(chain);
    return {.file = shared(file),
            .line = innermost->line,
            .column = line.empty() ? 0 : column_of(line, function, of_library),
            .calls = shared(fmt::format("{}", fmt::join(chain, " > ")))};
}

}  // namespace twinlight::trace
