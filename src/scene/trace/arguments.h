// The arguments of one call, as they stand in a dump: values without types.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/trace/dump_lexer.h"

namespace twinlight::trace {

struct Argument {
    enum class Form : std::uint8_t {
        kNumber,    // or an enumerant, or several joined by |
        kArray,     // {1, 2}, or &1
        kNull,      // NULL
        kBlob,      // blob("file"): memory, in a file
        kBlobSize,  // blob(24): memory that was not dumped
        kOther,     // a string, a structure
        kMissing,   // ?: the call was never finished
    };
    Form form = Form::kNumber;
    std::size_t first = 0, count = 0;  // the values of a number or an array, in Arguments::numbers; kBlob: in blobs
};

struct Arguments {
    std::vector<Argument> list;
    std::vector<double> numbers;
    std::vector<std::string> blobs;
    std::string unknown_name;  // the first name that has no value here; empty where all have

    void clear();
};

// Reads what stands between the parentheses of a call, and the closing one: "light = GL_LIGHT0, params = {5, 5, 10, 0})".
// What is wrong is answered as a message, empty where all is well.
std::string read_arguments(DumpLexer& lexer, Arguments& arguments);
// One value, such as what a call returned.
std::string read_value(DumpLexer& lexer, Arguments& arguments);

}  // namespace twinlight::trace
