#include "check/case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <regex>

#include "command/text.h"
#include "image/file.h"
#include "state/state.h"

namespace twinlight::check {

namespace {

// Table 2.3, but for GL_TABLE_TOO_LARGE, which is the imaging subset's.
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

// One entry of the head: "// key: value", and what lines indented below it add.
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
        static const std::regex kEntry("// ([a-z]+): (.*)");
        int line = 0;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::string here(text.substr(begin, end - begin));
            begin = end + 1;
            ++line;
            if (!here.starts_with("//")) break;
            std::smatch found;
            if (here.starts_with("//   ") && !entries_.empty())
                entries_.back().value += " " + trimmed(here.substr(2));
            else if (std::regex_match(here, found, kEntry))
                entries_.push_back({line, found[1], trimmed(found[2])});
            else
                refuse(line, "a head's line is '// key: value', or goes on with '//   '");
        }
    }

    const std::vector<Entry>& entries() const { return entries_; }
    [[noreturn]] void refuse(int line, const std::string& why) const {
        throw SceneError(fmt::format("{}:{}: {}; docs/hard-cases.md tells the form", file_, line, why));
    }

    std::vector<double> numbers(const Entry& entry, const std::string& text, std::size_t count) const {
        std::vector<double> values;
        const char* at = text.c_str();
        while (*at) {
            char* end = nullptr;
            values.push_back(std::strtod(at, &end));
            if (end == at) refuse(entry.line, "'" + text + "' is not a list of numbers");
            at = end + std::strspn(end, " ");
        }
        if (values.size() != count) refuse(entry.line, fmt::format("'{}' is not {} numbers", text, count));
        return values;
    }

    Seen seen(const Entry& entry, const Spot& spot, const std::string& text) const {
        if (spot.kind == Spot::Kind::kError) {
            const auto error = std::ranges::find(kErrors, text, &NamedError::name);
            if (error == std::end(kErrors)) refuse(entry.line, "'" + text + "' is none of GL's errors");
            return error->code;
        }
        const std::vector<double> v = numbers(entry, text, 4);
        return glm::dvec4(v[0], v[1], v[2], v[3]);
    }

    Spot spot(const Entry& entry, const std::string& text) const {
        static const std::regex kVertex("vertex ([0-2])"), kPixel("pixel ([0-9]+),([0-9]+)( phong| exact)?");
        std::smatch found;
        if (text == "error") return {.kind = Spot::Kind::kError, .shading = {}};
        if (std::regex_match(text, found, kVertex)) return {.vertex = std::stoi(found[1]), .shading = {}};
        if (!std::regex_match(text, found, kPixel))
            refuse(entry.line,
                   "'" + text + "' is neither 'vertex N' nor 'error' nor 'pixel X,Y', 'pixel X,Y phong' or 'exact'");
        Spot spot{.kind = Spot::Kind::kPixel, .x = std::stoi(found[1]), .y = std::stoi(found[2]), .shading = {}};
        if (std::max(spot.x, spot.y) >= kSide) refuse(entry.line, fmt::format("a picture has {} pixels a side", kSide));
        if (found[3].matched) spot.shading = found[3] == " phong" ? Shading::kPhong : Shading::kExact;
        return spot;
    }

  private:
    std::string file_;
    std::vector<Entry> entries_;
};

// "a: b: c" at its first two colons.
std::pair<std::string, std::string> split(const Head& head, const Entry& entry, const std::string& text,
                                          std::string_view at) {
    const std::size_t place = text.find(at);
    if (place == std::string::npos)
        head.refuse(entry.line, fmt::format("'{}' lacks a '{}'", text, trimmed(std::string(at))));
    return {trimmed(text.substr(0, place)), trimmed(text.substr(place + at.size()))};
}

Expectation expectation(const Head& head, const Entry& entry) {
    const auto [spot, value] = split(head, entry, entry.value, ": ");
    Expectation result{.spot = head.spot(entry, spot), .value = {}, .other = {}};
    const std::size_t plus = value.find(" + ");
    // "1|0": 1, of floats 0 too.
    static const std::regex kOther("[|][^ ]*"), kFirst("[^ ]*[|]");
    const std::string primary = value.substr(0, plus);
    if (result.spot.kind == Spot::Kind::kError && value.find('|') != std::string::npos)
        head.refuse(entry.line, "'" + value + "' is two errors; glGetError tells one, so that 'error:' takes one");
    result.value = head.seen(entry, result.spot, std::regex_replace(primary, kOther, ""));
    result.other = head.seen(entry, result.spot, std::regex_replace(primary, kFirst, ""));
    if (plus != std::string::npos) {
        const std::vector<double> v = head.numbers(entry, value.substr(plus + 3), 3);
        result.secondary = {v[0], v[1], v[2]};
    }
    return result;
}

Differs difference(const Head& head, const Entry& entry) {
    const auto [driver, rest] = split(head, entry, entry.value, ": ");
    const auto [place, rest_of_it] = split(head, entry, rest, ": ");
    const auto [value, name] = split(head, entry, rest_of_it, "; ");
    const Spot spot = head.spot(entry, place);
    return {.driver = driver, .spot = spot, .value = head.seen(entry, spot, value), .name = name};
}

void take(Case& into, const Head& head, const Entry& entry) {
    const auto sentence = [&](std::string& place) {
        if (!place.empty()) head.refuse(entry.line, "'" + entry.key + "' stands here twice");
        if (entry.value.empty()) head.refuse(entry.line, "'" + entry.key + "' says nothing");
        place = entry.value;
    };
    if (entry.key == "what") {
        sentence(into.what);
    } else if (entry.key == "why") {
        sentence(into.why);
    } else if (entry.key == "text") {
        sentence(into.text);
    } else if (entry.key == "derived") {
        sentence(into.derived);
    } else if (entry.key == "status") {
        if (entry.value != "defined" && entry.value != "ruling")
            head.refuse(entry.line, "the status is 'defined' or 'ruling'");
        into.is_ruling = entry.value == "ruling";
    } else if (entry.key == "tolerance") {
        const auto [number, causes] = split(head, entry, entry.value, ", ");
        into.tolerance = head.numbers(entry, number, 1)[0];
        sentence(into.tolerance_causes);
    } else if (entry.key == "expect") {
        into.expectations.push_back(expectation(head, entry));
    } else if (entry.key == "differs") {
        into.differs.push_back(difference(head, entry));
    } else {
        head.refuse(entry.line, "there is no key '" + entry.key +
                                    "'; the keys are what, why, text, derived, status, tolerance, expect and differs");
    }
}

}  // namespace

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
        if (std::isnan(c[i])) c[i] = std::abs(c[i]);  // whatever its sign bit
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
    if (!expects_error()) return {.frame = make_frame(scene, options)};
    State state(options);
    for (const Command& command : scene->commands) state.apply(command);
    // What is too large for Twinlight, the driver must not be asked for.
    if (const auto error = state.exhausted() ? state.exhausted() : state.unfinished())
        throw SceneError(fmt::format("{}: {}", error->place.str(), error->message));
    return {state.take_frame(scene), state.errors().empty() ? kGL_NO_ERROR : state.errors().front().code};
}

Case read_case(std::string_view text, const std::string& file, const std::string& name) {
    const Head head(text, file);
    Case result;
    result.name = name;
    result.scene_text = text;
    for (const Entry& entry : head.entries()) take(result, head, entry);
    for (const char* key : {"what", "why", "text", "derived", "status", "expect"}) {
        if (std::ranges::find(head.entries(), key, &Entry::key) == head.entries().end())
            head.refuse(1, fmt::format("the head lacks '{}'", key));
    }
    for (const Differs& differs : result.differs) {
        if (result.is_ruling) head.refuse(1, "what the specification leaves open, no driver departs from");
        if (std::ranges::find(result.expectations, differs.spot, &Expectation::spot) == result.expectations.end())
            head.refuse(1, "'differs' names " + differs.spot.str() + ", of which nothing is expected");
    }
    const auto is_about = [&](Spot::Kind kind) {
        return std::ranges::any_of(result.expectations, [&](const Expectation& e) { return e.spot.kind == kind; });
    };
    if (is_about(Spot::Kind::kVertex) == is_about(Spot::Kind::kPixel))
        head.refuse(1, "a case is about vertices or about pixels, and not about both");
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
                fmt::format("{}: there is no case and no file of this name; {}", name,
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
