// A whole GLUT program while Reader runs it: its tokens, its functions and the variables of running functions. Used only by
// read*.cpp and run*.cpp.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/command/lexer.h"
#include "scene/command/random_numbers.h"
#include "scene/command/reader.h"
#include "scene/command/text.h"

namespace twinlight {

struct FormalParameter {
    std::string_view name;
    const DataType* type = nullptr;
};

// What follows the words of a type in a declaration: *name, name[3] or (*name)(int).
struct Declarator {
    Token name;  // without a text if there is none
    const DataType* type = nullptr;
    std::size_t at = 0;  // the index of the name
};

struct Function {
    Token name;
    const DataType* result = nullptr;
    std::vector<FormalParameter> parameters{};
    bool takes_more = false;              // f(const char* form, ...)
    std::size_t body = 0;                 // the index of its "{"
    std::optional<SceneError> refusal{};  // why its result or its parameters cannot be read; thrown where it is called
};

// The object belongs to `owned`, or to Program::statics.
struct Local {
    std::string_view name;
    Object* object;
    std::unique_ptr<Object> owned;
    std::size_t block;  // the first local of its block: blocks inside it have larger numbers
};

// A function that GLUT calls, with its last argument as an address (Reader::address) where it was registered with one.
struct Callback {
    Token function;
    std::optional<std::uint64_t> data{};
};

struct Program {
    std::vector<Token> tokens;  // the last is kEnd
    // For each opening bracket, the index of the closing one.
    std::vector<std::size_t> partners{};
    ReadOptions options{};

    std::map<std::string_view, Function> functions{};
    std::map<std::string_view, Token> prototypes{};
    std::map<std::string_view, const DataType*> types{};  // from typedef
    std::map<std::string_view, DataType*> structs{};      // by their names
    std::map<std::size_t, DataType*> structs_at{};        // by the index of their "{"
    std::map<std::string_view, Value> constants{};        // from enum
    std::map<std::size_t, Object> statics{};              // local static variables, by the index of their name
    std::map<std::size_t, Object> texts{};                // in quotes, by the index of their first token
    std::map<std::string_view, Object> function_objects{};
    std::map<std::pair<std::size_t, char>, std::shared_ptr<const Memory>> glyphs{};  // of bitmap fonts
    std::deque<Object> heap{};  // from malloc; freed ones have no memory
    // The objects whose addresses were stored, by their numbers.
    std::unordered_map<std::uint32_t, Object*> objects{};
    std::uint32_t last_number = 0;

    std::size_t at = 0;  // the index of the token that is being read
    std::size_t steps = 0;
    std::size_t loop = 0;   // the index of the loop that last began a round; 0 if there was none
    std::size_t depth = 0;  // statements, expressions and calls inside each other
    std::vector<Local> locals{};
    std::size_t frame = 0;                     // the first local of the running function
    std::size_t block = 0;                     // the first local of the running block
    bool in_function = false;                  // false while the global variables are read
    const DataType* result = nullptr;          // of the running function
    std::optional<std::vector<Value>> more{};  // what the running function gets for ..., if it has that
    Value returned{};                          // by the last return; a pointer as its address, in `integer`
    std::shared_ptr<Memory> returned_struct{};
    RandomNumbers random{};
    std::uint64_t random_48 = 0x1234abcd330e;  // drand48()
    int elapsed_ms = 0;                        // GLUT_ELAPSED_TIME of the picture
    int windows = 0;                           // number created so far; the first is that of the picture
    int current_window = 0;                    // its number; 0 before the first
    bool is_in_other_window() const { return current_window > 1; }
    std::size_t commands_of_picture = 0;  // before another window became current
    std::optional<std::array<double, 4>> viewport_of_picture{};
    bool asks_for_samples = false;  // a window with several samples per pixel
    bool reached_main_loop = false;
    std::optional<std::size_t> kept_locals{};  // of main, once it waits in GLUT's loop and the callbacks run

    std::optional<Callback> display{}, reshape{}, idle{}, timer{}, keyboard{};
    Value timer_value{};                             // what the timer function gets
    WindowSize window{.width = 300, .height = 300};  // GLUT's own size
};

// From one picture to the next.
inline constexpr int kFrameMs = 20;

inline bool is_step(const Token& token) { return token.is("++") || token.is("--"); }

// The value of a name of GLUT that can decide what main and its functions call: GLUT_DOUBLE is 2.
std::optional<int> glut_constant(std::string_view name);
// The value of a name of C's headers: RAND_MAX.
std::optional<Value> constant_of_c(std::string_view name);
// The value of GLUT_BITMAP_HELVETICA_18 and the like.
std::optional<Value> font_named(std::string_view name);

// How a statement ends.
enum class Flow : std::uint8_t { kNext, kBreak, kContinue, kReturn };

}  // namespace twinlight
