// The arguments of one call in a dump: values without types.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/trace/dump_lexer.h"

namespace twinlight::trace {

struct Argument {
    enum class Form : std::uint8_t {
        kNumber,    // a number, an enumerant, or several combined by |
        kArray,     // {1, 2}, or &1
        kNull,      // NULL
        kBlob,      // blob("file"): memory, stored in a file
        kBlobSize,  // blob(24): memory that was not dumped
        kOther,     // a string, a structure
        kMissing,   // ?: the call was never finished
    };
    Form form = Form::kNumber;
    std::size_t first = 0, count = 0;  // a number or array: its values in Arguments::numbers; kBlob: its file in blobs
};

struct Arguments {
    std::vector<Argument> list;
    std::vector<double> numbers;
    std::vector<std::string> blobs;
    std::string unknown_name;  // the first unknown enumerant; empty if all are known

    void clear();
};

// Reads the arguments of a call and the closing parenthesis: "light = GL_LIGHT0, params = {5, 5, 10, 0})". Returns an
// error message, or "" on success.
std::string read_arguments(DumpLexer& lexer, Arguments& arguments);
// Reads one value, such as the result of a call. Returns an error message, or "" on success.
std::string read_value(DumpLexer& lexer, Arguments& arguments);

}  // namespace twinlight::trace
