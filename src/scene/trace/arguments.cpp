#include "scene/trace/arguments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text/translation.h"
#include "scene/command/lexer.h"
#include "scene/command/text.h"
#include "scene/trace/functions.h"
#include "scene/trace/window_formats.h"

namespace twinlight::trace {

namespace {

using Form = Argument::Form;

constexpr std::size_t kLongestNameShown = 80;
constexpr std::size_t kLongestFileName = 255;
constexpr int kDeepest = 8;  // arrays in arrays, pointers to pointers, members of structures

class Reading {
  public:
    Reading(DumpLexer& lexer, Arguments& arguments) : lexer_(lexer), arguments_(arguments) {}

    // Returns false and sets the message if the text is wrong.
    bool list() {
        if (lexer_.accept(')')) return true;
        do {
            lexer_.skip_blanks();
            if (arguments_.list.size() >= kMostArguments) {
                return wrong(tr("this call has more than {} arguments", kMostArguments));
            }
            if (!named_value()) return false;
        } while (lexer_.accept(','));
        return lexer_.accept(')') || wrong_character(tr("',' or ')' after an argument"));
    }

    bool value() {
        Argument argument{Form::kNumber, arguments_.numbers.size(), 0};
        if (!value_into(argument, 0)) return false;
        arguments_.list.push_back(argument);
        return true;
    }

    std::string take_message() { return std::move(message_); }

  private:
    static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

    bool wrong(std::string message) {
        message_ = std::move(message);
        return false;
    }
    bool wrong_character(std::string_view expected) {
        if (lexer_.at_end()) return wrong(tr("the dump ends inside this call"));
        const char c = lexer_.peek();
        return wrong(tr("expected {}, found {}", expected, in_quotes({&c, 1})));
    }

    // Reads "x = 1", or "1" in a dump without names.
    bool named_value() {
        if (!is_letter(lexer_.peek())) return value();
        Argument argument{Form::kNumber, arguments_.numbers.size(), 0};
        const std::string_view word = lexer_.word();
        if (lexer_.accept(" = ")) return value();
        if (!word_value(word, argument, 0)) return false;
        arguments_.list.push_back(argument);
        return true;
    }

    bool value_into(Argument& argument, int depth) {
        switch (lexer_.peek()) {
            case '{': return array(argument, depth);
            case '&': return pointed_at(argument, depth);
            case '"':
                lexer_.string(0);
                argument.form = Form::kOther;
                return true;
            case '?':
                lexer_.skip();
                argument.form = Form::kMissing;
                return true;
            default: break;
        }
        if (is_letter(lexer_.peek())) return word_value(lexer_.word(), argument, depth);
        double number = 0;
        if (lexer_.number(number)) return number_value(number, argument);
        if (lexer_.accept("-inf")) return number_value(-std::numeric_limits<double>::infinity(), argument);
        if (lexer_.accept("-nan")) return number_value(std::numeric_limits<double>::quiet_NaN(), argument);
        return wrong_character(tr("a value"));
    }

    // Adds the number and everything combined with it: GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | 0x10.
    bool number_value(double number, Argument& argument) {
        while (lexer_.peek() == ' ' && lexer_.accept(" | ")) {
            double other = 0;
            if (is_letter(lexer_.peek())) {
                other = enumerant(lexer_.word());
            } else if (!lexer_.number(other)) {
                return wrong_character(tr("a number or a name after '|'"));
            }
            const auto is_mask = [](double value) {
                return value >= 0 && value <= std::numeric_limits<std::uint32_t>::max() && value == std::trunc(value);
            };
            if (!is_mask(number) || !is_mask(other)) return wrong(tr("'|' can combine only whole numbers and names"));
            number = static_cast<std::uint32_t>(number) | static_cast<std::uint32_t>(other);
        }
        if (arguments_.numbers.size() >= kMaxArrayLength) {
            return wrong(tr("this call has more than {} values", kMaxArrayLength));
        }
        arguments_.numbers.push_back(number);
        ++argument.count;
        return true;
    }

    double enumerant(std::string_view name) { return arguments_.value_of(name, known_value(name)); }

    bool word_value(std::string_view word, Argument& argument, int depth) {
        if (word.starts_with("GL_")) return number_value(enumerant(word), argument);
        if (word == "NULL") {
            argument.form = depth == 0 ? Form::kNull : Form::kOther;
            return true;
        }
        if (word == "inf") return number_value(std::numeric_limits<double>::infinity(), argument);
        if (word == "nan") return number_value(std::numeric_limits<double>::quiet_NaN(), argument);
        if (word == "blob") return blob(argument);
        if (word == "L" && lexer_.peek() == '"') {
            lexer_.string(0);
            argument.form = Form::kOther;
            return true;
        }
        if (lexer_.accept(" = ")) {  // a member of a structure
            if (depth >= kDeepest) return wrong(tr("these values are nested more than {} deep", kDeepest));
            if (!value_into(argument, depth + 1)) return false;
            argument.form = Form::kOther;
            return true;
        }
        return number_value(enumerant(word), argument);  // a name of the window system, or True
    }

    bool blob(Argument& argument) {
        if (!lexer_.accept('(')) return wrong_character(tr("'(' after blob"));
        if (arguments_.blobs.size() >= kMostBlobs) {
            return wrong(tr("this call has more than {} blobs", kMostBlobs));
        }
        if (lexer_.peek() == '"') {
            argument.form = Form::kBlob;
            argument.first = arguments_.blobs.size();
            argument.count = 1;
            arguments_.blobs.push_back({std::string(lexer_.string(kLongestFileName + 1))});
        } else {
            double size = 0;
            if (!lexer_.number(size)) return wrong_character(tr("a blob's file or size"));
            argument.form = Form::kBlobSize;
        }
        return lexer_.accept(')') || wrong_character(tr("')' after a blob"));
    }

    bool array(Argument& argument, int depth) {
        if (depth >= kDeepest) return wrong(tr("these arrays are nested more than {} deep", kDeepest));
        lexer_.skip();
        Form form = Form::kArray;
        if (!lexer_.accept('}')) {
            do {
                lexer_.skip_blanks();
                argument.form = Form::kNumber;
                if (!value_into(argument, depth + 1)) return false;
                if (argument.form != Form::kNumber && argument.form != Form::kArray) form = Form::kOther;
            } while (lexer_.accept(','));
            if (!lexer_.accept('}')) return wrong_character(tr("',' or '}' in an array"));
        }
        argument.form = form;
        return true;
    }

    bool pointed_at(Argument& argument, int depth) {
        if (depth >= kDeepest) return wrong(tr("these pointers are nested more than {} deep", kDeepest));
        lexer_.skip();
        if (!value_into(argument, depth + 1)) return false;
        argument.form = argument.form == Form::kNumber ? Form::kArray : Form::kOther;
        return true;
    }

    DumpLexer& lexer_;
    Arguments& arguments_;
    std::string message_;
};

}  // namespace

void Arguments::clear() {
    list.clear();
    numbers.clear();
    blobs.clear();
    unknown_name.clear();
}

bool Arguments::are_complete() const {
    return std::ranges::none_of(list, [](const Argument& argument) { return argument.form == Form::kMissing; });
}

std::optional<Enum> known_value(std::string_view name) {
    return name.starts_with("GL_") ? find_dumped_name(name) : sample_attribute(name);
}

double Arguments::value_of(std::string_view name, std::optional<Enum> known) {
    if (!known && unknown_name.empty()) unknown_name = name.substr(0, kLongestNameShown);
    return known.value_or(0);
}

std::string read_arguments(DumpLexer& lexer, Arguments& arguments) {
    Reading reading(lexer, arguments);
    return reading.list() ? "" : reading.take_message();
}

std::string read_value(DumpLexer& lexer, Arguments& arguments) {
    Reading reading(lexer, arguments);
    return reading.value() ? "" : reading.take_message();
}

}  // namespace twinlight::trace
