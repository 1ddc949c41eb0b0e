#include "render/webgpu/wgsl_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace twinlight::webgpu {
namespace {

// ---- Types ----

const std::map<std::string, std::string>& basic_types() {
    static const std::map<std::string, std::string> kTypes = {
        {"float", "f32"},   {"int", "i32"},          {"uint", "u32"},     {"bool", "bool"},   {"vec2", "vec2f"},
        {"vec3", "vec3f"},  {"vec4", "vec4f"},       {"ivec2", "vec2i"},  {"ivec3", "vec3i"}, {"uvec2", "vec2u"},
        {"uvec4", "vec4u"}, {"bvec3", "vec3<bool>"}, {"mat3", "mat3x3f"}, {"mat4", "mat4x4f"}};
    return kTypes;
}

bool is_vector(const std::string& type) { return type.find("vec") != type.npos && !type.ends_with("]"); }
bool is_matrix(const std::string& type) { return type.starts_with("mat"); }
std::string component_of(const std::string& vector) {
    return vector[0] == 'i' ? "int" : vector[0] == 'u' ? "uint" : vector[0] == 'b' ? "bool" : "float";
}
// A vector of the same components.
std::string vector_of(const std::string& vector, std::size_t size) {
    if (size == 1) return component_of(vector);
    return vector.substr(0, vector.find("vec")) + "vec" + std::to_string(size);
}
std::size_t size_of(const std::string& vector) { return static_cast<std::size_t>(vector.back() - '0'); }

// ---- Tokens ----

struct Token {
    std::string before;  // spaces, line breaks and comments
    std::string text;
    bool is_word() const {
        return !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '_');
    }
    bool is_number() const {
        return !text.empty() &&
               (std::isdigit(static_cast<unsigned char>(text[0])) != 0 || (text[0] == '.' && text.size() > 1));
    }
};

bool continues_number(std::string_view text, std::size_t at) {
    const char c = text[at];
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.') return true;
    return (c == '-' || c == '+') && (text[at - 1] == 'e' || text[at - 1] == 'E');
}

// The last one has no text.
std::vector<Token> tokens_of(std::string_view text) {
    constexpr std::string_view kTwoCharacters[] = {"<<", ">>", "<=", ">=", "==", "!=", "&&",
                                                   "||", "+=", "-=", "*=", "/=", "++", "--"};
    std::vector<Token> tokens;
    std::size_t at = 0;
    while (true) {
        Token token;
        const std::size_t begin = at;
        while (at < text.size() && (text[at] == ' ' || text[at] == '\n' || text.substr(at).starts_with("//")))
            at = text[at] == '/' ? std::min(text.find('\n', at), text.size()) : at + 1;
        token.before = text.substr(begin, at - begin);
        const std::size_t start = at;
        if (at < text.size()) {
            const auto c = static_cast<unsigned char>(text[at++]);
            if (std::isdigit(c) != 0)
                while (at < text.size() && continues_number(text, at)) ++at;
            else if (std::isalpha(c) != 0 || c == '_')
                while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_'))
                    ++at;
            else if (std::ranges::find(kTwoCharacters, text.substr(start, 2)) != std::end(kTwoCharacters))
                ++at;
        }
        token.text = text.substr(start, at - start);
        tokens.push_back(token);
        if (token.text.empty()) return tokens;
    }
}

// ---- Expressions ----

enum Level { kTernary, kOr, kAnd, kBitOr, kBitXor, kBitAnd, kEqual, kLess, kShift, kSum, kProduct, kUnary, kPrimary };

struct Expression {
    std::string before, text, type;
    int level = kPrimary;
    bool is_select = false;
};

int level_of(const std::string& op) {
    static const std::map<std::string, int> kLevels = {
        {"||", kOr},    {"&&", kAnd}, {"|", kBitOr}, {"^", kBitXor},  {"&", kBitAnd},  {"==", kEqual},
        {"!=", kEqual}, {"<", kLess}, {">", kLess},  {"<=", kLess},   {">=", kLess},   {"<<", kShift},
        {">>", kShift}, {"+", kSum},  {"-", kSum},   {"*", kProduct}, {"/", kProduct}, {"%", kProduct}};
    const auto found = kLevels.find(op);
    return found == kLevels.end() ? -1 : found->second;
}
bool is_bitwise(int level) { return (level >= kBitOr && level <= kBitAnd) || level == kShift; }

bool is_assignment(const std::string& op) { return op == "=" || op == "+=" || op == "-=" || op == "*=" || op == "/="; }

class BodyWriter {
  public:
    BodyWriter(const Function& function, const WgslNames& names, std::string result)
        : names_(names), result_(std::move(result)), tokens_(tokens_of(function.body)) {
        for (const Variable& one : function.parameters) locals_[one.name] = one.type;
        find_assigned();
    }

    bool assigns(const std::string& name) const { return assigned_.contains(name); }

    std::string body() {
        while (!peek().text.empty()) statement();
        return out_ + peek().before;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw std::logic_error(fmt::format("WGSL: {} near '{}'", what, tokens_[at_].text));
    }
    const Token& peek(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
    Token take() {
        if (peek().text.empty()) fail("the function ends too early");
        return tokens_[at_++];
    }
    Token take(const char* text) {
        if (peek().text != text) fail(fmt::format("no '{}'", text));
        return take();
    }
    bool is_type(const Token& token) const {
        return basic_types().contains(token.text) || names_.structs.contains(token.text);
    }

    // Names that are assigned after their declaration: they are `var`, others `let`.
    void find_assigned() {
        for (std::size_t i = 1; i < tokens_.size(); ++i) {
            const std::string& op = tokens_[i].text;
            if (op == "++" || op == "--") assigned_.insert(tokens_[i + 1].text);
            if (!is_assignment(op)) continue;
            std::size_t root = i - 1;
            while (root > 1 && tokens_[root - 1].text == ".") root -= 2;
            if (root > 0 && is_type(tokens_[root - 1])) continue;  // a declaration
            assigned_.insert(tokens_[root].text);
        }
        // One without a value gets it later.
        for (std::size_t i = 0; i + 2 < tokens_.size(); ++i)
            if (is_type(tokens_[i]) && tokens_[i + 1].is_word() && tokens_[i + 2].text == ";")
                assigned_.insert(tokens_[i + 1].text);
    }

    // ---- Statements ----

    void statement() {
        const Token& first = peek();
        if (first.text == "{") return block();
        if (first.text == "if") return condition();
        if (first.text == "for") return loop();
        if (first.text == "return" || first.text == "discard") {
            const Token word = take();
            out_ += word.before + word.text;
            if (peek().text != ";") {
                const Expression value = expression();
                out_ += value.before + value.text;
            }
            out_ += take(";").before + ";";
            return;
        }
        const bool is_constant = first.text == "const";
        if (is_constant || (is_type(first) && peek(1).is_word())) return declaration();
        assignment();
        take(";");
        out_ += ";";
    }

    void block() {
        out_ += take("{").before + "{";
        while (peek().text != "}") statement();
        out_ += take("}").before + "}";
    }

    // WGSL has a block after if.
    void braced() {
        if (peek().text == "{") return block();
        out_ += " {";
        statement();
        out_ += " }";
    }
    void condition() {
        out_ += take("if").before + "if ";
        take("(");
        const Expression value = expression();
        take(")");
        out_ += "(" + value.text + ")";
        braced();
        if (peek().text != "else") return;
        out_ += take("else").before + "else";
        if (peek().text == "if") {
            out_ += " ";
            tokens_[at_].before.clear();
            condition();
        } else {
            braced();
        }
    }

    void loop() {
        out_ += take("for").before + "for (";
        take("(");
        take();  // the type
        const std::string name = take().text;
        locals_[name] = "int";
        take("=");
        const Expression begin = expression();
        take(";");
        const Expression condition = expression();
        take(";");
        take("++");
        take();
        take(")");
        out_ += fmt::format("var {} = {}; {}; {}++)", name, begin.text, condition.text, name);
        braced();
    }

    void declaration() {
        const std::string before = peek().before;
        const bool is_constant = peek().text == "const";
        if (is_constant) take();
        const std::string type = take().text;
        for (bool is_first = true; is_first || peek().text == ","; is_first = false) {
            const std::size_t line = before.rfind('\n');
            if (!is_first) {
                take(",");
                out_ += ";" + (line == before.npos ? " " : before.substr(line));
            } else {
                out_ += before;
            }
            const std::string name = take().text;
            locals_[name] = type;
            const char* const word = is_constant ? "const" : assigned_.contains(name) ? "var" : "let";
            if (peek().text != "=") {
                out_ += fmt::format("var {}: {}", name, wgsl_type(type));
                continue;
            }
            take("=");
            const Expression value = expression();
            // A whole number for a float needs its type.
            out_ += fmt::format("{} {} ={}{}", word, name, value.before, converted(value, type));
        }
        take(";");
        out_ += ";";
    }

    static std::string converted(const Expression& value, const std::string& type) {
        return type == "float" && value.type == "int" ? fmt::format("f32({})", value.text) : value.text;
    }

    // ---- Assignments ----

    void assignment() {
        if (peek().text == result_ && !result_.empty()) {
            out_ += take().before + "return";
            take("=");
            const Expression value = expression();
            out_ += value.before + value.text;
            return;
        }
        const std::size_t start = at_;
        const Expression target = postfix();
        const Vector vector = std::exchange(vector_, {});
        if (!is_assignment(peek().text)) {  // a call
            out_ += target.before + target.text;
            return;
        }
        const Token op = take();
        const Expression value = expression();
        if (vector.components.size() > 1)
            assign_components(start, target, vector, op, value);
        else
            out_ += fmt::format("{}{} {}{}{}", target.before, target.text, op.text, value.before, value.text);
    }

    // What an expression takes components of: v and "xyz" of v.xyz.
    struct Vector {
        std::string text{}, type{}, components{};
    };

    // Whether the next statement assigns the component to the same vector as the statement at `start`, and does not read it.
    bool assigns_next(std::size_t start, char component) const {
        const std::string& vector = tokens_[start].text;
        std::size_t next = at_ + 1;  // after the semicolon
        for (; tokens_[start + 1].text != "="; ++start, ++next)
            if (next >= tokens_.size() || tokens_[start].text != tokens_[next].text) return false;
        if (next + 1 >= tokens_.size() || tokens_[next].text != std::string(1, component) ||
            tokens_[next + 1].text != "=")
            return false;
        for (next += 2; tokens_[next].text != ";"; ++next)
            if (tokens_[next].text == vector) return false;
        return true;
    }

    // v.rgb = x for a vector v of more components; the statement begins at `start`.
    void assign_components(std::size_t start, const Expression& target, const Vector& vector, const Token& op,
                           const Expression& value) {
        const std::string all = vector.components[0] == 'r' ? "rgba" : "xyzw", type = wgsl_type(vector.type);
        const std::size_t count = vector.components.size(), rest = size_of(vector.type) - count;
        if (all.substr(0, count) != vector.components) fail("components are assigned that are not the first");
        const std::string text = is_vector(value.type)
                                     ? value.text
                                     : fmt::format("{}({})", wgsl_type(vector_of(vector.type, count)), value.text);
        if (rest == 0) {
            out_ += fmt::format("{}{} {}{}{}", target.before, vector.text, op.text, value.before, text);
            return;
        }
        const auto same = [&](const char* number) {
            return rest == 1 ? number : fmt::format("vec{}f({})", rest, number);
        };
        if (op.text == "=" && rest == 1 && assigns_next(start, all[count])) {
            take(";");
            const std::string between = peek().before;
            while (take().text != "=") continue;
            const Expression last = expression();
            const bool has_comment = between.find("//") != between.npos;
            const std::string inner = has_comment ? "\n        " : "";
            // The comment stays behind the first components.
            out_ += fmt::format("{}{} = {}({}{},{}{})", target.before, vector.text, type, inner, text,
                                has_comment ? between.substr(0, between.find('\n')) + inner : " ", last.text);
            return;
        }
        const std::string others = op.text == "=" ? fmt::format("{}.{}", vector.text, all.substr(count, rest))
                                   : op.text == "+=" || op.text == "-=" ? same("0.0")
                                                                        : same("1.0");
        out_ += fmt::format("{}{} {} {}({}, {})", target.before, vector.text, op.text, type, text, others);
    }

    // ---- Expressions ----

    Expression expression() {
        Expression condition = binary(kOr);
        if (peek().text != "?") return condition;
        take("?");
        const Expression yes = expression();
        take(":");
        const Expression no = expression();
        return {condition.before, fmt::format("select({}, {}, {})", no.text, yes.text, condition.text), yes.type,
                kPrimary, true};
    }

    Expression binary(int level) {
        if (level > kProduct) return unary();
        Expression left = binary(level + 1);
        while (level_of(peek().text) == level) {
            const Token op = take();
            const Expression right = binary(level + 1);
            left = joined(left, op, right, level);
        }
        return left;
    }

    static std::string grouped(const Expression& one, int level) {
        const bool is_binary = one.level > kTernary && one.level < kUnary && one.level != level;
        const bool needs =
            is_bitwise(level) || (is_bitwise(one.level) && level != kAnd && level != kOr) || level == kOr;
        return is_binary && needs && !(level == kOr && one.level != kAnd) ? "(" + one.text + ")" : one.text;
    }

    Expression joined(const Expression& left, const Token& op, const Expression& right, int level) const {
        std::string second = grouped(right, level);
        if (level == kShift && right.type == "int") second = fmt::format("u32({})", right.text);
        return {left.before, grouped(left, level) + op.before + op.text + right.before + second,
                level == kOr || level == kAnd || level == kEqual || level == kLess
                    ? "bool"
                    : type_of(left.type, op.text, right.type),
                level};
    }
    static std::string type_of(const std::string& left, const std::string& op, const std::string& right) {
        if (is_matrix(left)) return is_vector(right) || is_matrix(right) ? right : left;
        if (is_matrix(right)) return is_vector(left) && op == "*" ? left : right;
        return is_vector(right) ? right : left;
    }

    Expression unary() {
        if (peek().text != "-" && peek().text != "!" && peek().text != "~") return postfix();
        const Token op = take();
        const Expression value = unary();
        return {op.before, op.text + value.text, value.type, kUnary};
    }

    Expression postfix() {
        Expression value = primary();
        vector_ = {};
        while (peek().text == "." || peek().text == "[") {
            if (take().text == ".") {
                const Token member = take();
                vector_ = {};
                if (const auto found = names_.structs.find(value.type); found != names_.structs.end()) {
                    value.type = member_type(found->second, member.text);
                    value.text += "." + member.text;
                } else if (is_vector(value.type)) {
                    vector_ = {value.text, value.type, with_xyzw(member.text)};
                    value.type = vector_of(value.type, member.text.size());
                    value.text += "." + with_xyzw(member.text);
                } else {
                    fail(fmt::format("a member of {}", value.type));
                }
                continue;
            }
            const Expression index = expression();
            take("]");
            value.text += "[" + index.text + "]";
            value.type = value.type.ends_with("[]") ? value.type.substr(0, value.type.size() - 2)
                         : is_matrix(value.type)    ? "vec" + value.type.substr(3)
                                                    : component_of(value.type);
        }
        return value;
    }
    static std::string with_xyzw(std::string components) {
        constexpr std::string_view kTexture = "stpq", kPlace = "xyzw";
        for (char& c : components)
            if (const std::size_t at = kTexture.find(c); at != kTexture.npos) c = kPlace[at];
        return components;
    }
    std::string member_type(const std::vector<Variable>& members, const std::string& name) const {
        const auto found = std::ranges::find(members, name, &Variable::name);
        if (found == members.end()) fail("no member " + name);
        return found->type;
    }

    Expression primary() {
        const Token token = take();
        if (token.text == "(") {
            const Expression inner = expression();
            take(")");
            if (inner.is_select) return {token.before, inner.text, inner.type};
            return {token.before, "(" + inner.text + ")", inner.type};
        }
        if (token.is_number()) {
            const bool is_float = token.text.find_first_of(".e") != token.text.npos;
            return {token.before, token.text, is_float ? "float" : token.text.ends_with("u") ? "uint" : "int"};
        }
        if (!token.is_word()) fail("no value");
        if (peek().text == "(") return call(token);
        if (token.text == "true" || token.text == "false") return {token.before, token.text, "bool"};
        if (const auto found = locals_.find(token.text); found != locals_.end())
            return {token.before, token.text, found->second};
        const auto found = names_.globals.find(token.text);
        if (found == names_.globals.end()) fail(fmt::format("{} is not known", token.text));
        return {token.before, found->second.text, found->second.type};
    }

    // ---- Calls ----

    Expression call(const Token& name) {
        std::vector<Expression> arguments;
        take("(");
        while (peek().text != ")") {
            arguments.push_back(expression());
            if (peek().text == ",") take();
        }
        take(")");
        if (is_type(name)) return {name.before, wgsl_type(name.text) + listed(arguments), name.text};
        for (const auto& one : names_.functions)
            if (one.name == name.text && takes(one, arguments))
                return {name.before, one.wgsl_name + listed(arguments), one.type};
        Expression result = built_in(name.text, arguments);
        result.before = name.before;
        return result;
    }
    static bool takes(const WgslNames::Callable& one, const std::vector<Expression>& arguments) {
        return std::ranges::equal(one.parameters, arguments, {}, {}, &Expression::type);
    }
    static std::string listed(const std::vector<Expression>& arguments, std::size_t first = 0) {
        std::string text;
        for (std::size_t i = first; i < arguments.size(); ++i)
            text += (i == 0 ? "" : "," + (arguments[i].before.empty() ? " " : arguments[i].before)) + arguments[i].text;
        return "(" + text + ")";
    }

    Expression built_in(const std::string& name, std::vector<Expression> arguments) const {
        static const std::set<std::string> kSame = {"abs",       "ceil",    "cos",   "cross", "exp",
                                                    "exp2",      "floor",   "fract", "log",   "log2",
                                                    "normalize", "reflect", "sign",  "sin",   "sqrt"};
        static const std::set<std::string> kEqualTypes = {"max", "min", "clamp", "mix", "step", "pow"};
        static const std::map<std::string, std::string> kRenamed = {
            {"inversesqrt", "inverseSqrt"}, {"dFdx", "dpdx"}, {"dFdy", "dpdy"}};
        if (arguments.empty()) fail(name + "()");
        const std::string& type = arguments[0].type;
        if (name.starts_with("texture")) return lookup(name, arguments);
        if (name == "dot" || name == "length" || name == "distance") return {"", name + listed(arguments), "float"};
        if (kSame.contains(name)) return {"", name + listed(arguments), type};
        if (const auto found = kRenamed.find(name); found != kRenamed.end())
            return {"", found->second + listed(arguments), type};
        static const std::map<std::string, std::string> kComparisons = {
            {"greaterThan", ">"}, {"greaterThanEqual", ">="}, {"lessThan", "<"}, {"lessThanEqual", "<="}};
        if (const auto found = kComparisons.find(name); found != kComparisons.end())
            return {"", fmt::format("{} {} {}", arguments.at(0).text, found->second, arguments.at(1).text),
                    "bvec" + type.substr(type.size() - 1), kLess};
        if (name == "any" || name == "all") return {"", name + listed(arguments), "bool"};
        if (name == "mix" && arguments.at(2).type[0] == 'b') return {"", "select" + listed(arguments), type};
        if (!kEqualTypes.contains(name)) fail(fmt::format("the function {} is not supported", name));
        const auto vector = std::ranges::find_if(arguments, [](const Expression& one) { return is_vector(one.type); });
        const std::string common = vector == arguments.end() ? type : vector->type;
        if (name == "clamp" && arguments[1].text == "0.0" && arguments[2].text == "1.0")
            return {"", "saturate(" + arguments[0].text + ")", common};
        for (std::size_t i = 0; i < arguments.size(); ++i)
            if (is_vector(common) && !is_vector(arguments[i].type) && !(name == "mix" && i == 2))
                arguments[i].text = fmt::format("{}({})", wgsl_type(common), arguments[i].text);
        return {"", name + listed(arguments), common};
    }

    // Each texture has a sampler beside it.
    Expression lookup(const std::string& name, std::vector<Expression> arguments) const {
        const std::string first = fmt::format("{0}, {0}Sampler", arguments[0].text);
        if (arguments[0].type != "sampler2D" && arguments[0].type != "sampler3D" && arguments[0].type != "samplerCube")
            fail("a texture of the type " + arguments[0].type);
        std::string function = name == "textureGrad" ? "textureSampleGrad" : "textureSample";
        if (name != "textureGrad" && arguments.size() == 3) function = "textureSampleBias";
        if (name == "textureProj") {  // divides by the last component
            const std::size_t size = size_of(arguments[1].type);
            arguments[1].text = fmt::format("{0}.{1} / {0}.{2}", arguments[1].text,
                                            arguments[0].type == "sampler3D" ? "xyz" : "xy", size == 3 ? "z" : "w");
        } else if (name != "texture" && name != "textureGrad") {
            fail(fmt::format("the function {} is not supported", name));
        }
        arguments[0].text = first;
        return {"", function + listed(arguments), "vec4"};
    }

    const WgslNames& names_;
    std::string result_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    std::map<std::string, std::string> locals_;  // their types
    std::set<std::string> assigned_;
    Vector vector_;  // of the last postfix(), if it ends in components
    std::string out_;
};

}  // namespace

std::string wgsl_type(const std::string& type, int length) {
    const auto found = basic_types().find(type);
    const std::string one = found == basic_types().end() ? type : found->second;
    return length > 0 ? fmt::format("array<{}, {}>", one, length) : one;
}

std::string wgsl_body(const Function& function, const WgslNames& names, const std::string& result) {
    return BodyWriter(function, names, result).body();
}

std::string wgsl_function(const Function& function, const WgslNames& names) {
    BodyWriter writer(function, names, "");
    std::string parameters, copies, name = function.name;
    std::vector<std::string> types;
    for (const Variable& one : function.parameters) {
        types.push_back(one.type);
        std::string of_call = one.name;
        if (writer.assigns(one.name)) {
            of_call += "_given";
            copies += fmt::format("    var {} = {};  // a parameter cannot change in WGSL\n", one.name, of_call);
        }
        parameters += fmt::format("{}{}: {}", parameters.empty() ? "" : ", ", of_call, wgsl_type(one.type));
    }
    for (const auto& one : names.functions)
        if (one.name == function.name && one.parameters == types) name = one.wgsl_name;
    return fmt::format("{}fn {}({}) -> {} {{\n{}{}}}\n", function.above, name, parameters, wgsl_type(function.type),
                       copies, writer.body());
}

}  // namespace twinlight::webgpu
