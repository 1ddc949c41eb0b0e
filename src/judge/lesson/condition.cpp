// Reads conditions: recursive descent over the text.
#include "judge/lesson/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "scene/command/names.h"

namespace twinlight::lesson {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kMostDepth = 50, kMostObjects = 1000, kMostPixels = 10000;

Measure constant(double value) {
    return [value](const Work&) { return value; };
}
template <class Operation>
Measure combined(Measure a, Measure b, Operation operation) {
    return [a = std::move(a), b = std::move(b), operation](const Work& work) { return operation(a(work), b(work)); };
}
// The largest value, or with `sign` -1 the smallest; NaN if one is NaN.
Measure extreme(std::vector<Measure> measures, int sign) {
    return [measures = std::move(measures), sign](const Work& work) {
        double most = -kInfinite;
        for (const Measure& measure : measures) {
            const double value = sign * measure(work);
            if (!(value <= most)) most = value;
            if (std::isnan(most)) break;
        }
        return sign * most;
    };
}
Measure absolute(Measure measure) {
    return [measure = std::move(measure)](const Work& work) { return std::abs(measure(work)); };
}
Measure at_start(Measure measure) {
    return [measure = std::move(measure)](const Work& work) { return measure(work.start()); };
}
Measure camera_moved(Measure measure) {
    return [measure = std::move(measure)](const Work& work) {
        const Work* moved = work.moved();
        return measure(moved ? *moved : work);
    };
}

class ConditionReader {
  public:
    ConditionReader(std::string_view text, const std::string& folder) : text_(text), folder_(folder) {}

    Condition read() {
        Condition condition;
        condition.measure = sum();
        const std::string word = name();
        if (word == "at") {
            const std::string bound = name();
            if (bound != "least" && bound != "most") refuse_bound();
            condition.low = bound == "least" ? number() : -kInfinite;
            condition.high = bound == "most" ? number() : kInfinite;
        } else if (word == "from") {
            condition.low = number();
            if (name() != "to") refuse_bound();
            condition.high = number();
            if (condition.low > condition.high) refuse("the numbers after 'from' and 'to' are the wrong way round");
        } else if (word == "is") {
            condition.low = condition.high = number();
        } else {
            refuse_bound();
        }
        if (skip_blanks() < text_.size()) refuse(fmt::format("'{}' is left over at the end", text_.substr(at_)));
        return condition;
    }

  private:
    [[noreturn]] static void refuse(const std::string& why) { throw std::runtime_error(why); }
    [[noreturn]] void refuse_bound() const {
        refuse("a check must end with 'at least N', 'at most N', 'from N to N' or 'is N'");
    }

    std::size_t skip_blanks() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_;
    }
    char next() { return skip_blanks() < text_.size() ? text_[at_] : '\0'; }
    bool take(char c) {
        if (next() != c) return false;
        ++at_;
        return true;
    }
    void expect(char c, const std::string& where) {
        if (!take(c)) refuse(fmt::format("'{}' is missing {}", c, where));
    }
    // Letters, digits and _; empty if there are none.
    std::string name() {
        const std::size_t start = skip_blanks();
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) ++at_;
        return std::string(text_.substr(start, at_ - start));
    }
    double number() {
        const bool is_negative = take('-');
        skip_blanks();
        const std::string rest(text_.substr(at_));
        char* end = nullptr;
        // strtod would take "inf" and "nan".
        const bool starts = !rest.empty() && (std::isdigit(static_cast<unsigned char>(rest[0])) || rest[0] == '.');
        const double value = starts ? std::strtod(rest.c_str(), &end) : kInfinite;
        if (!starts || end == rest.c_str() || !std::isfinite(value))
            refuse(rest.empty() ? "a number is missing at the end"
                                : fmt::format("'{}' must start with a number", rest));
        at_ += static_cast<std::size_t>(end - rest.c_str());
        return is_negative ? -value : value;
    }
    int whole_number(int low, int high, std::string_view what) {
        const double value = number();
        if (value != std::floor(value) || value < low || value > high)
            refuse(fmt::format("{} must be a whole number from {} to {}", what, low, high));
        return static_cast<int>(value);
    }

    Measure sum() {
        Measure left = product();
        for (;;) {
            if (take('+'))
                left = combined(std::move(left), product(), std::plus<>());
            else if (take('-'))
                left = combined(std::move(left), product(), std::minus<>());
            else
                return left;
        }
    }
    Measure product() {
        Measure left = factor();
        for (;;) {
            if (take('*'))
                left = combined(std::move(left), factor(), std::multiplies<>());
            else if (take('/'))
                left = combined(std::move(left), factor(), std::divides<>());
            else
                return left;
        }
    }
    Measure factor() {
        if (++depth_ > kMostDepth) refuse("the check has too many parentheses");
        Measure result = bare_factor();
        --depth_;
        return result;
    }
    Measure bare_factor() {
        if (take('(')) {
            Measure inner = sum();
            expect(')', "after what is in parentheses");
            return inner;
        }
        const char c = next();
        if (!std::isalpha(static_cast<unsigned char>(c))) return constant(number());
        const std::string function = name();
        expect('(', "after " + function);
        Measure result = called(function);
        expect(')', "at the end of " + function);
        return result;
    }
    Measure called(const std::string& function) {
        if (function == "abs") return absolute(sum());
        if (function == "at_start") return at_start(sum());
        if (function == "camera_moved") return camera_moved(sum());
        if (function == "min" || function == "max") {
            std::vector<Measure> values{sum()};
            while (take(',')) values.push_back(sum());
            return extreme(std::move(values), function == "max" ? 1 : -1);
        }
        const auto row = std::ranges::find(measures(), function, &MeasureRow::name);
        if (row == measures().end()) refuse_name(function);
        return row->make(arguments_of(*row));
    }
    [[noreturn]] static void refuse_name(const std::string& function) {
        std::vector<std::string_view> names{"abs", "min", "max", "at_start", "camera_moved"};
        for (const MeasureRow& row : measures()) names.push_back(row.name);
        const auto near = nearest(function, names);
        refuse(
            fmt::format("there is no measure '{}'; {}", function,
                        near ? fmt::format("did you mean '{}'?", *near) : "'twinlight lesson --measures' lists them"));
    }

    MeasureArguments arguments_of(const MeasureRow& row) {
        MeasureArguments arguments{.folder = folder_};
        bool is_first = true;
        const auto comma = [&] {
            if (!std::exchange(is_first, false)) expect(',', fmt::format("in {}(...)", row.name));
        };
        const auto numbers = [&](int count) {
            for (int i = 0; i < count; ++i) {
                comma();
                arguments.numbers.push_back(number());
            }
        };
        for (const ParameterKind kind : row.parameters) {
            switch (kind) {
                case ParameterKind::kBox:
                    arguments.boxes.push_back({0, 0, 640, 480});
                    if (next() == ')') break;
                    for (int* part : {&arguments.boxes.back().x, &arguments.boxes.back().y,
                                      &arguments.boxes.back().width, &arguments.boxes.back().height}) {
                        comma();
                        *part = whole_number(0, kMostPixels, "a box's number");
                    }
                    break;
                case ParameterKind::kObject:
                case ParameterKind::kObjects:
                    do {
                        comma();
                        arguments.objects.push_back(whole_number(1, kMostObjects, "an object's number") - 1);
                    } while (kind == ParameterKind::kObjects && next() == ',');
                    break;
                case ParameterKind::kVector: numbers(3); break;
                case ParameterKind::kNumber: numbers(1); break;
                case ParameterKind::kMaybeText:
                    if (next() == ')') break;
                    [[fallthrough]];
                case ParameterKind::kText:
                    comma();
                    arguments.texts.push_back(text());
                    break;
            }
        }
        return arguments;
    }
    std::string text() {
        if (!take('"')) {
            const std::string bare = name();
            if (bare.empty()) refuse("a name, or text in quotes, is missing");
            return bare;
        }
        const std::size_t end = text_.find('"', at_);
        if (end == std::string_view::npos) refuse("a quote is not closed");
        const std::string quoted(text_.substr(at_, end - at_));
        at_ = end + 1;
        return quoted;
    }

    std::string_view text_;
    const std::string& folder_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

Condition read_condition(std::string_view text, const std::string& folder) {
    return ConditionReader(text, folder).read();
}

}  // namespace twinlight::lesson
