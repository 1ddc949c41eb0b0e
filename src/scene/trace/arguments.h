// The arguments of one call of a recording: values without types.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/command/command.h"
#include "scene/trace/dump_lexer.h"

namespace twinlight::trace {

struct Argument {
    enum class Form : std::uint8_t {
        kNumber,    // a number, an enumerant, or several combined by |
        kArray,     // {1, 2}, or &1
        kNull,      // NULL
        kBlob,      // blob("file"): memory
        kBlobSize,  // blob(24): memory that was not dumped, or not read
        kOther,     // a string, a structure
        kMissing,   // ?: the call was never finished
    };
    Form form = Form::kNumber;
    std::size_t first = 0, count = 0;  // a number or array: its values in Arguments::numbers; kBlob: in blobs
};

struct Blob {
    std::string name;                        // for a BlobLoader
    std::shared_ptr<const Memory> memory{};  // null: the loader gives it
};

inline constexpr std::size_t kMostArguments = 64, kMostBlobs = 4096;  // of a call

struct Arguments {
    std::vector<Argument> list;
    std::vector<double> numbers;
    std::vector<Blob> blobs;
    std::string unknown_name;  // the first unknown enumerant; empty if all are known

    void clear();
    bool are_complete() const;  // the call was finished
    // The value of a name; `known` is known_value(name). An unknown name is noted and gives 0.
    double value_of(std::string_view name, std::optional<Enum> known);
};

// The value of a name of GL or of the window system.
std::optional<Enum> known_value(std::string_view name);

// Reads the arguments of a call and the closing parenthesis: "light = GL_LIGHT0, params = {5, 5, 10, 0})". Returns an
// error message, or "" on success.
std::string read_arguments(DumpLexer& lexer, Arguments& arguments);
// Reads one value, such as the result of a call. Returns an error message, or "" on success.
std::string read_value(DumpLexer& lexer, Arguments& arguments);

}  // namespace twinlight::trace
