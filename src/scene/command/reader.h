// Reader: parses the C dialect and evaluates its expressions. Used only by read*.cpp and run*.cpp.
//
// A whole program is read by the same functions. Reader runs it while it reads: a loop's body is read again for each
// round, and what is not executed is skipped.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/translation.h"
#include "scene/command/data_type.h"
#include "scene/command/lexer.h"
#include "scene/command/object_names.h"
#include "scene/command/text.h"

namespace twinlight {

// The lengths of an array of arrays, the outermost first; none for a single value.
using Dimensions = std::vector<std::size_t>;

// A variable, a compound literal, a text in quotes or allocated memory: its bytes, and whether their values are known. Or a function
// of the program, so that pointers can point at it.
struct Object {
    const DataType* type = nullptr;
    std::shared_ptr<Memory> memory{};  // shared with the commands that point into it; if shared, copied before a change
    std::string shown{};               // for messages: its name, or "this array"
    Place place{};
    bool is_literal = false;
    // If not known, the bytes from unknown_from to unknown_to were declared without a value, or written by glGet*.
    bool known = false;
    std::size_t unknown_from = 0, unknown_to = kMaxMemoryBytes;
    std::string unknown_because{};
    std::uint32_t number = 0;          // in the addresses of a program; 0 if none was stored
    bool is_constant = false;          // a text in quotes
    bool is_allocated = false;         // by malloc
    std::string_view function_name{};  // of a function

    std::size_t bytes() const { return memory ? memory->bytes.size() : 0; }
};

// The value of an expression: a number with its C type - int (64 bits here, so that every GL type fits), float or
// double - or a pointer, or a struct.
struct Value {
    enum class Type : std::uint8_t { kInteger, kFloat, kDouble, kPointer, kStruct };
    Type type = Type::kInteger;
    std::int64_t integer = 0;
    double real = 0;

    // For a pointer: the object and the offset in bytes from its start (without an object, NULL is offset 0), and the type that it
    // points at (nullptr for void). For a struct: the object that has it, and its type.
    Object* object = nullptr;
    std::int64_t offset = 0;
    const DataType* of = nullptr;

    bool is_pointer() const { return type == Type::kPointer; }
    bool is_struct() const { return type == Type::kStruct; }
    bool is_integer() const { return type == Type::kInteger; }
    bool is_null() const { return !object && (is_integer() ? integer : offset) == 0 && (is_integer() || is_pointer()); }
    double number() const { return is_integer() ? static_cast<double>(integer) : real; }
    // The kind of the numbers that a pointer points at; nullopt for void, char and mixed structs.
    std::optional<Kind> kind() const;
    // The bytes from one element that a pointer points at to the next.
    std::size_t step() const;
};

struct Program;
struct Callback;
struct Function;
struct FormalParameter;
struct Declarator;
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
    // The object or part of an object that an expression denotes. Without an object it is read for its type only.
    struct Lvalue {
        Object* object = nullptr;
        std::size_t offset = 0;  // in bytes
        const DataType* type = nullptr;
    };
    // What an expression gives: a place that can be changed, or a value.
    struct Operand {
        std::optional<Lvalue> place{};
        Value value{};
    };

    // -- tokens --
    void advance();
    bool accept(std::string_view text);
    template <class... Values>
    void expect(std::string_view text, fmt::format_string<Values...> where, Values&&... values) {
        if (!accept(text)) fail_missing(text, vtr(where, fmt::make_format_args(values...)));
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
    Declarator scene_declarator(const DataType* type);
    void declare_object(const Declarator& made, bool is_static);
    void assignment();
    void program();
    void window_statement();
    void pragma();
    void returns_pragma();
    void step_pragma();
    // Reads name(arguments), adds the command to commands_ and returns it.
    const Command& call();
    void check_room_for_command(const Place& place) const;
    // Reads the call on the right of "=" and stores its result.
    void assign_result(const Lvalue& target);
    Dimensions dimensions_in_brackets();
    const DataType* with_rows(const DataType* element, const Dimensions& lengths, const Place& place);
    void hold(std::size_t bytes, const Place& place);
    void allocate(Object& object, const Place& place);
    void fill(Object& object, double value);
    Memory& writable(Object& object);
    void forget(Object& object);
    void forget_literals();

    // -- values of new variables (read_values.cpp) --
    void initialise(Object& object, const Token& name);
    void initialise_array(Object& object, const Place& place, std::string_view shown);
    struct Filled;
    void fill_part(Filled& filled, const DataType* type, std::size_t offset, bool in_braces);
    void fill_elements(Filled& filled, const DataType* type, std::size_t offset, bool in_braces, bool is_open);
    void fill_text(Filled& filled, const DataType* type, std::size_t offset);
    bool at_text_for(const DataType* type) const;
    std::size_t designated(Filled& filled, const DataType* type, std::size_t offset, bool is_open);
    void grow(Filled& filled, std::size_t end, const Place& place);

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
    [[noreturn]] static void fail_no_value(const Token& token);
    Value converted_by_cast(Value value, const DataType* type, const Place& place) const;
    static Value literal(const Token& token);
    Lvalue compound_literal(const DataType* type, const Place& place);
    Value named_value(const Token& name);
    Value size_of_operand();
    std::optional<Lvalue> lvalue(const Token& name);
    Lvalue element(const Lvalue& array);
    [[noreturn]] void unknown_name(const Token& name);
    Value value_of(const Lvalue& lvalue, const Place& place);
    void check_known(const Object& object, std::size_t offset, std::size_t bytes, const Place& place) const;
    static void set_known(Object& object, std::size_t offset, std::size_t bytes);
    [[noreturn]] void fail_unknown(const Object& object, const Place& place) const;
    static Value address_of(const Lvalue& lvalue);
    Value arithmetic(const Token& op, const Value& a, const Value& b) const;
    Value moved(const Token& op, Value pointer, const Value& by) const;
    Value distance(const Token& op, const Value& a, const Value& b) const;
    [[noreturn]] static void fail_outside(const Place& place, std::string_view what, const Value& pointer);
    Object* find_variable(std::string_view name);
    double converted(const Value& number, Kind kind, const Place& place,
                     const std::function<std::string()>& what) const;
    std::vector<std::string_view> visible_names() const;

    // -- types (read_types.cpp) --
    bool at_type() const { return is_type(token_); }
    bool is_type(const Token& token) const;
    const DataType* type_name();
    const DataType* type_of_words();
    [[noreturn]] void unknown_type(const Token& name) const;
    Declarator declarator(const DataType* type, bool is_parameter = false);
    const DataType* after_declarator(const DataType* type, bool is_parameter);
    const DataType* pointers(const DataType* type);
    const DataType* abstract_type();
    const DataType* struct_type();
    void members_of(DataType& made, bool is_union);
    void enum_type();
    void typedef_declaration();

    // -- a whole program: its functions and global variables (read_program.cpp) --
    void match_brackets();
    void read_functions();
    void function(std::size_t at);
    void parameters_of(Function& function);
    FormalParameter parameter(const DataType* type);
    bool skip_extern();
    void call_from_glut(const Callback& callback, std::vector<Value> given);
    bool calls_from_glut(const Callback& callback, const std::vector<Value>& given);
    bool tick();
    std::optional<LaterPicture> picture_after_key();
    std::vector<std::string_view> keys_of(const Function& function) const;
    std::vector<LaterPicture> later_pictures();
    std::vector<Value> arguments_of_main(const Function& main);
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
    Object& declare(const Token& name, Object object);
    bool declare_static(const Declarator& made);
    void forget_locals(std::size_t count);
    Value result_of(const Function& function, const Place& place);
    void skip_token();
    void skip_statement();
    void skip_expression();
    bool condition();
    Value comma_expressions();
    Value run_function(const Function& function, const std::vector<Value>& given, const Place& place);

    // -- a whole program: its pointers and structs (run_pointers.cpp) --
    Lvalue behind(const Value& pointer, const Place& place) const;
    Operand element_of(const Operand& array, const Token& start);
    Operand member_of(const Operand& whole, const Token& start);
    std::uint64_t address(const Value& pointer);
    Value pointer_from(std::uint64_t address, const DataType* of) const;
    Object& function_object(const Token& name);
    const Function& function_behind(const Value& pointer, const Place& place) const;
    std::optional<Value> call_of_memory(const Token& name);
    std::span<std::byte> bytes_behind(const Value& pointer, std::size_t count, bool is_written, const Place& place);

    // -- texts; those of a whole program are objects (run_texts.cpp) --
    void text_argument(Command& command, const Parameter& parameter);
    Value text_in_quotes();
    std::string text_behind(const Value& pointer, const Place& place);
    std::optional<Value> call_of_texts(const Token& name);
    struct Printed;
    Printed printed(const std::string& format, std::span<const Value> values, const Place& place);
    void write_text(const Value& to, std::string_view text, const Place& place);

    // -- a whole program: its expressions (run_expressions.cpp) --
    Operand assignment_expression();
    Value conditional(const Value& test);
    Value binary(Value left, int lowest);
    Operand operand();
    Operand operand_after(const Token& op);
    Operand postfix(Operand result, const Token& start);
    Operand stepped(const Operand& operand, const Token& op, const Token& start, bool gives_before);
    Operand primary_operand();
    const DataType* type_of_operand();
    Value value_of(const Operand& operand, const Place& place);
    Lvalue place_of(const Operand& operand, const Token& start, const Token& op) const;
    Value combined(const Token& op, const Value& a, const Value& b) const;
    static Value compared(const Token& op, const Value& a, const Value& b);
    Value assigned(const Lvalue& place, const Value& value, const Place& where);
    Operand program_name(const Token& name);
    Value in_kind(const Value& value, Kind kind, const Place& place) const;
    static bool is_true(const Value& value);
    void skip_operand(int lowest);

    // -- a whole program: its calls (run_calls.cpp) --
    std::vector<Value> values_in_parentheses();
    std::vector<Value> values_before_list(const Token& name, std::size_t count);
    WindowSize window_size(const Token& name);
    Value call_in_program(const Token& name);
    std::optional<Value> call_of_chance_and_time(const Token& name);
    std::optional<Value> call_of_mathematics(const Token& name);
    std::optional<Value> call_of_glut(const Token& name);
    void go_to_window(int window);
    Value answer_of_get_string(const Command& command);
    std::optional<Callback> callback_argument(const Token& name);
    void later_function(const Token& name);

    // -- a whole program: GLUT's texts (run_fonts.cpp) --
    std::optional<Value> call_of_fonts(const Token& name);
    void send(CommandId id, std::vector<double> values, const Place& place,
              std::shared_ptr<const Memory> memory = nullptr);
    void send_bitmaps(std::size_t number, std::string_view text, const Place& place);
    void send_strokes(bool is_mono, std::string_view text, const Place& place);

    Lexer lexer_;
    std::unique_ptr<Program> program_;  // null for scenes
    // Reads an expression only for its type: nothing is called, assigned or checked.
    bool dry_ = false;
    DataTypes types_{};
    std::map<std::string_view, const DataType*> opaque_{};  // GLUquadric and FILE
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

// Refuses a text that does not fit on one line of a window: too long, or not UTF-8. `what`: "a label".
void check_short_text(const Place& place, std::string_view what, std::string_view text);

// For messages: "'GL_LIGHTT0'", or "the end of the scene".
std::string shown(const Token& token);

// The kind of a GL or C type, by name.
std::optional<Kind> find_type(std::string_view name);

// What an expression of this type has where only its type matters.
Value zero_of(const DataType* type);
Value integer(std::int64_t value);
Value real(double value, bool is_float);

}  // namespace twinlight
