// A whole GLUT program while Reader runs it: its tokens, its functions and the variables of running functions. Used only by
// read*.cpp and run*.cpp.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "scene/command/lexer.h"
#include "scene/command/reader.h"

namespace twinlight {

// A parameter of one of the program's functions: a number, or an array. An array has the lengths of its rows.
struct FormalParameter {
    std::string_view name;
    Kind kind{};
    bool is_array = false;
    Dimensions row{};
};

struct Function {
    Token name;
    std::optional<Kind> result;  // nullopt for void
    std::vector<FormalParameter> parameters{};
    std::size_t body = 0;  // the index of its "{"
};

// The object belongs to `owned`, or to Program::statics.
struct Local {
    std::string_view name;
    Object* object;
    std::unique_ptr<Object> owned;
};

struct Program {
    std::vector<Token> tokens;  // the last is kEnd
    // For each opening bracket, the index of the closing one.
    std::vector<std::size_t> partners{};
    ProgramOptions options{};

    std::map<std::string_view, Function> functions{};
    std::map<std::string_view, Value> constants{};  // from enum
    std::map<std::size_t, Object> statics{};        // local static variables, by the index of their name
    std::set<std::string_view> texts{};             // names of char arrays and pointers, which have no values here

    std::size_t at = 0;  // the index of the token that is being read
    std::size_t steps = 0;
    std::size_t loop = 0;   // the index of the loop that last began a round; 0 if there was none
    std::size_t depth = 0;  // statements, expressions and calls inside each other
    std::vector<Local> locals{};
    std::size_t frame = 0;     // the first local of the running function
    bool in_function = false;  // false while the global variables are read
    Value returned{};          // by the last return
    bool reached_main_loop = false;

    std::optional<Token> display{}, reshape{};       // the functions that GLUT calls
    WindowSize window{.width = 300, .height = 300};  // GLUT's own size
};

// How a statement ends.
enum class Flow : std::uint8_t { kNext, kBreak, kContinue, kReturn };

}  // namespace twinlight
