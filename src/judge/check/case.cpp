#include "judge/check/case.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/image/file.h"
#include "base/text/input_text.h"
#include "judge/compare/releases.h"
#include "render/context/driver_name.h"
#include "scene/command/lexer.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::check {

namespace {

// Table 2.3, without GL_TABLE_TOO_LARGE, which belongs to the imaging subset.
struct NamedError {
    Enum code;
    std::string_view name;
};
constexpr NamedError kErrors[] = {{kGL_NO_ERROR, "GL_NO_ERROR"},
                                  {kGL_INVALID_ENUM, "GL_INVALID_ENUM"},
                                  {kGL_INVALID_VALUE, "GL_INVALID_VALUE"},
                                  {kGL_INVALID_OPERATION, "GL_INVALID_OPERATION"},
                                  {kGL_STACK_OVERFLOW, "GL_STACK_OVERFLOW"},
                                  {kGL_STACK_UNDERFLOW, "GL_STACK_UNDERFLOW"},
                                  {kGL_OUT_OF_MEMORY, "GL_OUT_OF_MEMORY"}};

// One entry of the head: "// key: value", with its continuation lines.
struct Entry {
    int line = 0;
    std::string key, value;
};

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

class Head {
  public:
    Head(std::string_view text, std::string file) : file_(std::move(file)) {
        constexpr std::string_view kIndented = "//   ", kComment = "// ";
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
        int line = 0;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::string here(text.substr(begin, end - begin));
            begin = end + 1;
            ++line;
            if (!here.starts_with("//")) break;
            if (std::ranges::any_of(
                    here, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) && c != '\t' && c != '\r'; }))
                refuse(line, "control characters are not allowed in the head");  // a terminal would obey them
            if (here.starts_with(kIndented) && !entries_.empty()) {
                entries_.back().value += " " + trimmed(here.substr(kIndented.size()));
                continue;
            }
            const std::size_t colon = here.find_first_not_of("abcdefghijklmnopqrstuvwxyz", kComment.size());
            if (!here.starts_with(kComment) || colon == kComment.size() || colon == std::string::npos ||
                here[colon] != ':')
                refuse(line,
                       "a line of the head must be '// key: value', or start with '//   ' to continue the entry above");
            const std::string key = here.substr(kComment.size(), colon - kComment.size());
            entries_.push_back({line, key, trimmed(here.substr(colon + 1))});
        }
    }

    const std::vector<Entry>& entries() const { return entries_; }
    [[noreturn]] void refuse(int line, const std::string& why) const {
        throw SceneError(fmt::format("{}:{}: {}; docs/hard-cases.md describes the format", file_, line, why));
    }

    std::vector<double> numbers(const Entry& entry, const std::string& text, std::size_t count) const {
        std::vector<double> values;
        const char* at = text.c_str();
        while (*at) {
            char* end = nullptr;
            values.push_back(std::strtod(at, &end));
            if (end == at) refuse(entry.line, twinlight::in_quotes(text) + " is not a list of numbers");
            // A driver may give NaN or infinity; neither is ever right.
            if (entry.key != "differs" && !std::isfinite(values.back()))
                refuse(entry.line, twinlight::in_quotes(text) + " is not finite");
            at = end + std::strspn(end, " ");
        }
        if (values.size() != count)
            refuse(entry.line, fmt::format("{} must be {} numbers", twinlight::in_quotes(text), count));
        return values;
    }

    Seen seen(const Entry& entry, const Spot& spot, const std::string& text) const {
        if (spot.kind == Spot::Kind::kError) {
            const auto error = std::ranges::find(kErrors, text, &NamedError::name);
            if (error == std::end(kErrors))
                refuse(entry.line, twinlight::in_quotes(text) + " is not the name of an OpenGL error");
            return error->code;
        }
        const std::vector<double> v = numbers(entry, text, 4);
        return glm::dvec4(v[0], v[1], v[2], v[3]);
    }

    Spot spot(const Entry& entry, const std::string& text) const {
        std::string_view rest = text;
        const auto take = [&](std::string_view word) {
            const bool is_here = rest.starts_with(word);
            if (is_here) rest.remove_prefix(word.size());
            return is_here;
        };
        const auto take_number = [&](int& into) {
            const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), into);
            rest = {end, rest.data() + rest.size()};
            return error == std::errc();
        };
        const auto is_in = [](int value, int end) { return value >= 0 && value < end; };
        Spot spot;
        if (text == "error") return {.kind = Spot::Kind::kError, .shading = {}};
        if (take("vertex ") && take_number(spot.vertex) && rest.empty() && is_in(spot.vertex, 3)) return spot;
        spot = {.kind = Spot::Kind::kPixel, .shading = {}};
        if (take("pixel ") && take_number(spot.x) && take(",") && take_number(spot.y)) {
            if (take(" phong"))
                spot.shading = Shading::kPhong;
            else if (take(" exact"))
                spot.shading = Shading::kExact;
            if (rest.empty() && is_in(spot.x, kSide) && is_in(spot.y, kSide)) return spot;
        }
        refuse(entry.line,
               fmt::format("{} is not a place: write 'error', 'vertex N', 'pixel X,Y', 'pixel X,Y phong' or 'pixel X,Y "
                           "exact', with N from 0 to 2, and X and Y from 0 to {}",
                           twinlight::in_quotes(text), kSide - 1));
    }

  private:
    std::string file_;
    std::vector<Entry> entries_;
};

// The text before the first `at`, and the text after it.
std::pair<std::string, std::string> split(const Head& head, const Entry& entry, const std::string& text,
                                          std::string_view at) {
    const std::size_t place = text.find(at);
    if (place == std::string::npos)
        head.refuse(entry.line, fmt::format("{} lacks a '{}'", twinlight::in_quotes(text), trimmed(std::string(at))));
    return {trimmed(text.substr(0, place)), trimmed(text.substr(place + at.size()))};
}

// "1|0 0 0 1" becomes "1 0 0 1", or with the second alternatives "0 0 0 1".
std::string one_of_two(const std::string& text, bool is_second) {
    InputText words(text);
    std::string result;
    for (std::string word; words >> word;) {
        const std::size_t bar = word.find('|');
        result += (result.empty() ? "" : " ") + (bar == std::string::npos ? word
                                                 : is_second              ? word.substr(bar + 1)
                                                                          : word.substr(0, bar));
    }
    return result;
}

Expectation expectation(const Head& head, const Entry& entry) {
    const auto [spot, value] = split(head, entry, entry.value, ": ");
    Expectation result{.spot = head.spot(entry, spot), .value = {}, .other = {}};
    const std::size_t plus = value.find(" + ");
    const std::string primary = value.substr(0, plus);
    if (result.spot.kind == Spot::Kind::kError && value.find('|') != std::string::npos)
        head.refuse(entry.line, "'" + value + "' names two errors, but glGetError returns one");
    result.value = head.seen(entry, result.spot, one_of_two(primary, false));
    result.other = head.seen(entry, result.spot, one_of_two(primary, true));
    if (plus != std::string::npos) {
        const std::vector<double> v = head.numbers(entry, value.substr(plus + 3), 3);
        result.secondary = {v[0], v[1], v[2]};
    }
    return result;
}

// One alternative of a Differs: "llvmpipe*Mesa from 25.0 before 26.1", "softpipe*Mesa at times".
struct Drivers {
    std::string pattern;
    bool at_times = false;
    Releases releases;  // of the text that they were read from
};
Drivers drivers_of(std::string_view text) {
    const auto limit = [&](std::string_view word) -> std::string_view {
        const std::size_t at = text.rfind(word);
        if (at == std::string_view::npos) return {};
        const std::string_view number = text.substr(at + word.size());
        if (number.empty() || number.find_first_not_of("0123456789.") != std::string_view::npos) return {};
        text = text.substr(0, at);
        return number;
    };
    constexpr std::string_view kAtTimes = " at times";
    const bool at_times = text.ends_with(kAtTimes);
    if (at_times) text.remove_suffix(kAtTimes.size());
    const std::string_view before = limit(" before "), from = limit(" from ");
    return {.pattern = std::string(text), .at_times = at_times, .releases = {.from = from, .before = before}};
}

std::vector<Drivers> all_drivers_of(const std::string& alternatives) {
    std::vector<Drivers> list;
    for (std::size_t begin = 0; begin < alternatives.size();) {
        const std::size_t end = std::min(alternatives.find('|', begin), alternatives.size());
        list.push_back(drivers_of(std::string_view(alternatives).substr(begin, end - begin)));
        begin = end + 1;
    }
    return list;
}

// The first of the alternatives that is of the driver.
std::optional<Drivers> alternative_of(const std::string& alternatives, const std::string& driver_name) {
    const Driver driver = parse_driver_name(driver_name);
    for (const Drivers& drivers : all_drivers_of(alternatives))
        if (::fnmatch(("*" + drivers.pattern + "*").c_str(), driver_name.c_str(), 0) == 0 &&
            drivers.releases.contain(driver))
            return drivers;
    return {};
}

Differs difference(const Head& head, const Entry& entry) {
    const auto [driver, rest] = split(head, entry, entry.value, ": ");
    for (const std::string_view word : {" before ", " from "})
        if (std::ranges::any_of(all_drivers_of(driver), [&](const Drivers& drivers) {
                return drivers.pattern.find(word) != std::string::npos;
            }))
            head.refuse(entry.line, fmt::format("{} lacks the number of a release, such as 25.0, after '{}'",
                                                twinlight::in_quotes(driver), trimmed(std::string(word))));
    const auto [place, rest_of_it] = split(head, entry, rest, ": ");
    const auto [value, name] = split(head, entry, rest_of_it, "; ");
    const Spot spot = head.spot(entry, place);
    return {.driver = driver, .spot = spot, .value = head.seen(entry, spot, value), .name = name};
}

void take(Case& into, const Head& head, const Entry& entry) {
    if (entry.value.empty()) head.refuse(entry.line, "'" + entry.key + "' is empty");
    if (entry.key == "expect") {
        into.expectations.push_back(expectation(head, entry));
        return;
    }
    if (entry.key == "differs") {
        into.differs.push_back(difference(head, entry));
        return;
    }
    if (std::ranges::find(head.entries(), entry.key, &Entry::key)->line != entry.line)
        head.refuse(entry.line, "'" + entry.key + "' is given twice");
    if (entry.key == "what") {
        into.what = entry.value;
    } else if (entry.key == "why") {
        into.why = entry.value;
    } else if (entry.key == "text") {
        into.text = entry.value;
    } else if (entry.key == "derived") {
        into.derived = entry.value;
    } else if (entry.key == "status") {
        if (entry.value != "defined" && entry.value != "ruling")
            head.refuse(entry.line, "the status must be 'defined' or 'ruling'");
        into.is_ruling = entry.value == "ruling";
    } else if (entry.key == "tolerance") {
        const auto [number, causes] = split(head, entry, entry.value, ", ");
        into.tolerance = head.numbers(entry, number, 1)[0];
        if (*into.tolerance < 0) head.refuse(entry.line, "a tolerance must be at least 0");
        if (causes.empty()) head.refuse(entry.line, "the causes of the tolerance must follow its number");
        into.tolerance_causes = causes;
    } else {
        head.refuse(entry.line, "there is no key " + twinlight::in_quotes(entry.key) +
                                    "; the keys are what, why, text, derived, status, tolerance, expect and differs");
    }
}

// Rules between entries: all keys are given, and places match.
void check_consistency(const Case& hard_case, const Head& head) {
    const auto line_of = [&](const char* key, std::size_t which) {
        for (const Entry& entry : head.entries())
            if (entry.key == key && which-- == 0) return entry.line;
        return 1;
    };
    for (const char* key : {"what", "why", "text", "derived", "status", "expect"}) {
        if (std::ranges::find(head.entries(), key, &Entry::key) == head.entries().end())
            head.refuse(1, fmt::format("the head lacks '{}'", key));
    }
    const auto place_of = [&](const Spot& spot) {
        const auto found = std::ranges::find(hard_case.expectations, spot, &Expectation::spot);
        return static_cast<std::size_t>(found - hard_case.expectations.begin());
    };
    for (std::size_t i = 0; i < hard_case.differs.size(); ++i) {
        const int line = line_of("differs", i);
        if (hard_case.is_ruling)
            head.refuse(line,
                        "'differs' needs the status 'defined': where the specification is silent, no driver is wrong");
        if (place_of(hard_case.differs[i].spot) == hard_case.expectations.size())
            head.refuse(line, "'differs' names " + hard_case.differs[i].spot.str() + ", but no 'expect' does");
    }
    std::optional<Spot::Kind> about;
    for (std::size_t i = 0; i < hard_case.expectations.size(); ++i) {
        const Spot& spot = hard_case.expectations[i].spot;
        const int line = line_of("expect", i);
        if (place_of(spot) != i) head.refuse(line, spot.str() + " is expected twice");
        if (spot.kind == Spot::Kind::kError) continue;
        if (about && *about != spot.kind)
            head.refuse(line, "a case expects colours of vertices or of pixels, not of both");
        about = spot.kind;
    }
    if (!about)
        head.refuse(line_of("expect", 0), "a case must expect a colour of a vertex or a pixel, not only an error");
}

}  // namespace

bool Differs::is_of(const std::string& driver_name) const { return alternative_of(driver, driver_name).has_value(); }

bool Differs::is_at_times(const std::string& driver_name) const {
    const std::optional<Drivers> found = alternative_of(driver, driver_name);
    return found && found->at_times;
}

std::string Differs::note(const std::string& driver_name) const {
    const std::optional<Drivers> found = alternative_of(driver, driver_name);
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (!found || found->pattern == "*" || std::ranges::any_of(found->pattern, is_digit)) return "";
    return compare::measured_note(parse_driver_name(driver_name));
}

std::string Spot::str() const {
    switch (kind) {
        case Kind::kVertex: return fmt::format("vertex {}", vertex);
        case Kind::kPixel:
            return fmt::format("pixel {},{}{}", x, y,
                               !shading                      ? ""
                               : *shading == Shading::kPhong ? " phong"
                                                             : " exact");
        case Kind::kError: break;
    }
    return "error";
}

std::string text_of(const std::optional<Seen>& seen) {
    if (!seen) return "nothing";
    if (const Enum* error = std::get_if<Enum>(&*seen)) {
        const auto* const named = std::ranges::find(kErrors, *error, &NamedError::code);
        return named == std::end(kErrors) ? fmt::format("the error {:#x}", *error) : std::string(named->name);
    }
    glm::dvec4 c = std::get<glm::dvec4>(*seen);
    for (int i = 0; i < 4; ++i)
        if (std::isnan(c[i])) c[i] = std::abs(c[i]);  // the sign bit of a NaN says nothing
    return fmt::format("({:.7g}, {:.7g}, {:.7g}, {:.7g})", c.r, c.g, c.b, c.a);
}

bool Case::is_of_vertices() const {
    return std::ranges::any_of(expectations, [](const Expectation& e) { return e.spot.kind == Spot::Kind::kVertex; });
}

bool Case::expects_error() const {
    return std::ranges::any_of(expectations, [](const Expectation& e) { return e.spot.kind == Spot::Kind::kError; });
}

CarriedOut Case::carried_out(int side) const {
    const StateOptions options{.width = side, .height = side};
    if (!expects_error()) return {.scene = make_scene(scene, options)};
    State state(options);
    for (const Command& command : scene->commands) state.apply(command);
    // A scene too large for Twinlight must not reach the driver.
    if (const auto error = state.exhausted() ? state.exhausted() : state.unfinished())
        throw SceneError(fmt::format("{}: {}", error->place.str(), error->message));
    return {{scene, state.take_frame()}, state.errors().empty() ? kGL_NO_ERROR : state.errors().front().code};
}

Case read_case(std::string_view text, const std::string& file, const std::string& name) {
    const Head head(text, file);
    Case result;
    result.name = name;
    result.scene_text = text;
    for (const Entry& entry : head.entries()) take(result, head, entry);
    check_consistency(result, head);
    result.scene = std::make_shared<CommandList>(read_scene(text, file, name));
    return result;
}

std::vector<Case> load_cases(const std::vector<std::string>& names) {
    std::vector<Case> cases;
    if (names.empty()) {
        for (const EmbeddedFile& file : kCaseFiles)
            cases.push_back(read_case(file.text, "golden/hard/" + std::string(file.name),
                                      std::string(file.name.substr(0, file.name.rfind(".gl")))));
        return cases;
    }
    for (const std::string& name : names) {
        const auto file = std::ranges::find(kCaseFiles, name + ".gl", &EmbeddedFile::name);
        if (file != kCaseFiles.end()) {
            cases.push_back(read_case(file->text, "golden/hard/" + std::string(file->name), name));
            continue;
        }
        const std::filesystem::path path(name);
        std::vector<std::string_view> known;
        for (const EmbeddedFile& one : kCaseFiles) known.push_back(one.name.substr(0, one.name.rfind(".gl")));
        std::error_code ignored;
        if (!path.has_extension() && !std::filesystem::exists(path, ignored)) {
            const auto near = nearest(name, known);
            throw SceneError(
                fmt::format("{}: there is no case or file with this name; {}", name,
                            near ? fmt::format("did you mean '{}'?", *near) : "'twinlight check' lists the cases"));
        }
        constexpr std::size_t kMaxCaseBytes = 1u << 20;
        const std::string text = read_file(name, kMaxCaseBytes + 1);
        if (text.size() > kMaxCaseBytes)
            throw SceneError(name + ": is larger than 1 MiB; a case is a head of comment lines and a small scene");
        cases.push_back(read_case(text, name, path.stem().string()));
    }
    return cases;
}

}  // namespace twinlight::check
