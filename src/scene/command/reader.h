// Reader: parses the C dialect and evaluates its expressions. Used only by read*.cpp and run*.cpp.
//
// A whole program is read by the same functions. Reader runs it while it reads: a loop's body is read again for each
// round, and what is not executed is skipped.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/command/lexer.h"
#include "scene/command/object_names.h"
#include "scene/command/text.h"

namespace twinlight {

// The lengths of an array of arrays, the outermost first; none for a single value.
using Dimensions = std::vector<std::size_t>;

// A variable, an array or a compound literal: its bytes, and whether their values are known.
struct Object {
    Kind kind{};
    Dimensions dimensions;
    std::shared_ptr<Memory> memory{};  // shared with the commands that point into it; if shared, copied before a change
    std::string shown;                 // for messages: its name, or "this array"
    Place place;
    bool is_literal = false;
    bool known = false;  // false if declared without a value, or written by glGet*
    std::string unknown_because{};
    // A pointer or an array parameter of a program has no memory: `target` is the array that it points into, `offset` is
    // in bytes, and `dimensions` are what lies behind that place. NULL has no target.
    bool is_pointer = false;
    Object* target = nullptr;
    std::size_t offset = 0;
    bool is_local = false;           // of a block or a function, so it ends before the program does
    std::vector<Object> pointers{};  // of an array of pointers: its elements, which are pointers
    bool is_text = false;            // a char array or pointer of a program; its characters are not kept

    std::size_t length() const;  // number of values
};

// The value of an expression: a number with its C type - int (64 bits here, so that every GL type fits), float or
// double - or a pointer.
struct Value {
    enum class Type : std::uint8_t { kInteger, kFloat, kDouble, kPointer };
    Type type = Type::kInteger;
    std::int64_t integer = 0;
    double real = 0;

    // For a pointer: the object and the offset in bytes from its start (without an object, NULL is offset 0); the type
    // that it points at (nullopt for void and char) and the size of that type (1 for void and char).
    Object* object = nullptr;
    std::int64_t offset = 0;
    std::optional<Kind> kind{};
    std::size_t step = 1;

    bool is_pointer() const { return type == Type::kPointer; }
    bool is_integer() const { return type == Type::kInteger; }
    double number() const { return is_integer() ? static_cast<double>(integer) : real; }
};

struct Program;
struct Function;
struct FormalParameter;
enum class Flow : std::uint8_t;

// Whether a name begins as those of OpenGL, GLU and GLUT do: gluPickMatrix, GL_LINE_WIDTH_GRANULARITY. For names that Twinlight does
// not know, so that nobody looks for them in the program.
bool is_like_gl(std::string_view name);

class Reader {
  public:
    // Of a scene with steps, reads the lines of all steps and those of the step with this number (from 1).
    Reader(std::string_view text, const std::string& file, const ImageLoader& load_image, const ReadOptions& options,
           std::size_t step);
    // A whole program, from preprocess().
    Reader(std::vector<Token> tokens, const std::string& file, const ImageLoader& load_image,
           const ReadOptions& options);
    ~Reader();
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    // Reads all statements. After an error it continues with the next statement; see errors().
    std::vector<Command> read();
    // Runs a whole program in GLUT's order: main up to glutMainLoop, the reshape function, the display function.
    CommandList run(const std::string& name);
    // At most kMaxErrorsShown; reading ends there.
    const std::vector<TextError>& errors() const { return errors_; }
    // The titles of the scene's steps.
    const std::vector<std::string>& steps() const { return steps_; }
    // The size that a scene gives its picture; nullopt if it gives none.
    std::optional<WindowSize> window() const { return window_; }

  private:
    // The object or part of an object that a name with subscripts denotes. Without dimensions it is a single value.
    struct Lvalue {
        Object* object = nullptr;
        std::size_t offset = 0;  // in bytes
        Dimensions dimensions;
        Object* pointer = nullptr;  // the pointer variable that the name is, if no subscript follows it
    };

    // -- tokens --
    void advance();
    bool accept(std::string_view text);
    template <class... Values>
    void expect(std::string_view text, fmt::format_string<Values...> where, Values&&... values) {
        if (!accept(text)) fail_missing(text, fmt::format(where, std::forward<Values>(values)...));
    }
    [[noreturn]] void fail_missing(std::string_view text, std::string_view where);

    // -- errors (read_errors.cpp) --
    struct TooManyErrors {};
    struct FollowingError {};  // an error that results from an earlier one and is not reported
    Token next_token();
    void report(const SceneError& error);
    void statement_or_error();
    void skip_rest_of_statement(std::size_t tokens_at_start);
    bool at_new_statement() const;

    // -- statements (read.cpp) --
    void statement();
    void declaration();
    void declare_object(const Token& name, Kind kind, const Dimensions& row, bool is_static);
    void initialise(Object& object, const Token& name);
    void assignment();
    void program();
    void window_statement();
    void pragma();
    void returns_pragma();
    void step_pragma();
    // Reads name(arguments), adds the command to commands_ and returns it.
    const Command& call();
    // Reads the call on the right of "=" and stores its result.
    void assign_result(const Lvalue& target);
    void arrays_values(Kind kind, std::span<const std::size_t> dimensions, std::vector<double>& values,
                       std::size_t start, bool is_open);
    Dimensions dimensions_in_brackets();
    static Dimensions with_rows(Dimensions outer, const Dimensions& row, const Place& place);
    void hold(std::size_t bytes, const Place& place);
    void allocate(Object& object, const Place& place);
    void fill(Object& object, const std::vector<double>& values);
    Memory& writable(Object& object);
    void forget_literals();

    // -- arguments (read_arguments.cpp) --
    void arguments(Command& command, const Signature& sig);
    void argument(Command& command, std::size_t parameter);
    double word_argument(const Command& command, const Parameter& parameter);
    void pointer_argument(Command& command, const Parameter& parameter);
    void written_argument(Command& command, const Parameter& parameter);
    void array_argument(Command& command, std::size_t parameter);
    void rest_arguments(Command& command, const Parameter& parameter);
    void image_argument(Command& command);
    void mesh_argument(Command& command);
    void follow_viewport(const Command& command);
    void give_names(Command& command, ObjectType type, const Value& array, std::size_t count);
    double result(const Command& command, const Parameter& parameter);

    // -- GLU's quadrics: the value of a pointer to one is its number (read_quadrics.cpp) --
    void quadric_declaration(Object& object);
    void quadric_assignment(Object& object);
    double quadric_value();
    double quadric_argument(const Command& command);

    // -- expressions: bitwise or, sum, product, unary, primary; C's precedence (read_expressions.cpp) --
    Value expression();
    Value number();  // an expression that must not be a pointer
    Value sum();
    Value product();
    Value unary();
    Value primary();
    Value parenthesis();
    Value cast(const Place& place);
    Value literal(const Token& token);
    Value compound_literal(Kind kind, const Place& place);
    Value named_value(const Token& name);
    Value size_of_operand();
    std::optional<Lvalue> lvalue(const Token& name);
    void subscripts(Lvalue& result, const Token& name);
    [[noreturn]] void unknown_name(const Token& name);
    Value value_of(const Lvalue& lvalue, const Place& place) const;
    [[noreturn]] void fail_unknown(const Object& object, const Place& place) const;
    static Value address_of(const Lvalue& lvalue);
    Value arithmetic(const Token& op, const Value& a, const Value& b) const;
    Value moved(const Token& op, Value pointer, const Value& by) const;
    Object* find_variable(std::string_view name);

    bool at_type() const;
    // Reads a type. type_lengths_ is then what a typedef of an array adds: typedef GLfloat point[3];
    Kind type_name();
    void enum_type();
    [[noreturn]] void unknown_type(const Token& name) const;
    bool at_byte_type() const;
    double converted(const Value& number, Kind kind, const Place& place, std::string_view what) const;
    std::vector<std::string_view> visible_names() const;

    // -- a whole program: its functions and global variables (read_program.cpp) --
    void match_brackets();
    void read_functions();
    void function(std::size_t at);
    void parameters_of(Function& function);
    FormalParameter parameter_type();
    void parameter_name(FormalParameter& parameter);
    void typedef_declaration();
    bool skip_extern();
    void call_from_glut(const Token& name, const std::vector<Value>& given);
    std::shared_ptr<const NextPicture> next_picture();
    void leave_functions();
    [[noreturn]] void out_of_reach(const Place& place, std::string_view construct) const;

    // -- a whole program: what its statements do (run_program.cpp) --
    void step();
    void jump(std::size_t at);
    Flow run_statement();
    Flow run_block();
    Flow run_body();
    Flow run_if();
    Flow run_while();
    Flow run_do();
    Flow run_for();
    void check_length_of_for(std::size_t loop);
    Flow run_switch();
    Flow run_return();
    bool is_declaration() const;
    void declare(const Token& name, Object object);
    bool declare_static(const Token& name);
    void forget_locals(std::size_t count);
    void skip_token();
    void skip_statement();
    void skip_expression();
    bool condition();
    void comma_expressions();
    Value run_function(const Function& function, const std::vector<Value>& given, const Place& place);

    // -- a whole program: its pointers (run_pointers.cpp) --
    void declare_pointer(const Token& name, Kind kind, const Dimensions& row, bool is_static);
    Object& keep_pointer(const Token& name, Object made, bool is_static);
    void declare_pointers(const Token& name, const Object& element, bool is_static);
    Object& element_of(Object& pointers, const Token& name);
    void declare_text(const Token& name);
    void point(Object& pointer, const Value& value, const Token& name) const;
    bool outlives(const Object& target, const Object& pointer) const;
    Lvalue behind(const Value& pointer, const Dimensions& row, const Place& place, std::string_view shown) const;
    static Dimensions row_of(const Value& pointer);
    Value subscripted(const Value& pointer, const Token& start);
    Value dereferenced();
    struct Dereferenced {
        Token name;  // the word after "*", for messages
        Kind kind{};
        std::optional<Lvalue> place{};  // nullopt for a pointer that is read for its type only
    };
    Dereferenced behind_star();
    Value stepped_behind_star(const Token& op);
    std::optional<Value> dereferenced_in_parentheses();
    Value changed_pointer(const Token& name, const Lvalue& place);

    // -- a whole program: its expressions (run_expressions.cpp) --
    Value conditional();
    Value binary(int lowest);
    Value prefix();
    Value combined(const Token& op, const Value& a, const Value& b) const;
    Value variable(const Token& name, Lvalue place);
    Value assigned(const Lvalue& place, const Value& value, const Token& name);
    std::optional<Token> name_in_parentheses();
    Value program_name(const Token& name);
    Value in_kind(const Value& value, Kind kind, const Place& place) const;
    static bool is_true(const Value& value);
    void skip_operand(int lowest);

    // -- a whole program: its calls (run_calls.cpp) --
    std::vector<Value> values_in_parentheses(const Function* called = nullptr);
    WindowSize window_size(const Token& name);
    Value call_in_program(const Token& name);
    std::optional<Value> call_of_mathematics(const Token& name);
    std::optional<Value> call_of_glut(const Token& name);
    void later_function(const Token& name);

    Lexer lexer_;
    std::unique_ptr<Program> program_;  // null for scenes
    // Reads an expression only for its type: nothing is called, assigned or checked.
    bool dry_ = false;
    Dimensions type_lengths_{};
    Token token_, ahead_;
    bool primed_ = false;
    std::size_t nesting_ = 0;
    bool in_program_ = false;
    bool program_read_ = false;
    std::map<std::string_view, Object> variables_;
    std::deque<Object> literals_;  // of the statement that is being read
    // The size of all objects, images, long arguments, and earlier contents of objects that commands point into.
    std::size_t bytes_ = 0;
    const ImageLoader& load_image_;
    struct LoadedImage {
        int width = 0, height = 0;
        std::shared_ptr<const Memory> memory;
    };
    std::map<std::string, LoadedImage, std::less<>> images_;  // by file name
    const MeshLoader& load_mesh_;
    std::map<std::string, std::shared_ptr<const Memory>, std::less<>> meshes_;  // by file name
    ObjectNames names_;
    std::optional<double> returns_;  // the result of the next call, if a pragma gives it
    Place returns_place_;
    std::vector<Command> commands_;
    std::size_t step_ = 1;
    std::vector<std::string> steps_;
    std::optional<WindowSize> window_{};
    double quadrics_ = 0;  // number created so far
    // What glGetIntegerv(GL_VIEWPORT) returns in a whole program; nullopt where that is not known.
    std::optional<std::array<double, 4>> viewport_{};
    std::vector<TextError> errors_;
    std::set<std::string_view> misdeclared_;  // names whose declarations have errors
    std::size_t tokens_ = 0;                  // number read so far
    int line_before_ = 0;                     // the line of the token before token_
    int lexical_error_line_ = 0;              // the line of the last error that the lexer reported
};

// For messages: "'GL_LIGHTT0'", or "the end of the scene".
std::string shown(const Token& token);

// The kind of a GL or C type, by name.
std::optional<Kind> find_type(std::string_view name);

Value integer(std::int64_t value);
Value real(double value, bool is_float);

}  // namespace twinlight
