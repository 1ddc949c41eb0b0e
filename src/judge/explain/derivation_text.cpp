// The derivation as text.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text/translation.h"
#include "judge/explain/derivation.h"

namespace twinlight::explain {

namespace {

// The lines of a note are aligned.
std::string note_text(const std::string& note) {
    std::string text = "    note: ";
    for (const char c : note) text += c == '\n' ? "\n          " : std::string(1, c);
    return text + "\n";
}

}  // namespace

std::string columns(const reference::Vec& c) { return fmt::format("{:>9.5f} {:>9.5f} {:>9.5f}", c.x, c.y, c.z); }

std::string color_row(const std::string& what, const std::string& how, const reference::Vec& c) {
    return fmt::format("    {:<12} {:<56} {}\n", what, how, columns(c));
}
std::string color_head(const std::string& what) {
    return fmt::format("{:<73} {:>9} {:>9} {:>9}\n", what, "red", "green", "blue");
}

std::string bold(const std::string& text, bool in_color) { return in_color ? "\x1b[1m" + text + "\x1b[0m" : text; }

std::string text_of(const Line& line, bool in_color) {
    switch (line.kind) {
        case Line::Kind::kHeading: return "  " + line.what + "\n";
        case Line::Kind::kHeadingOfColors: return color_head("  " + line.what);
        case Line::Kind::kLight: return fmt::format("  {}: {}\n", bold(line.what, in_color), line.how);
        case Line::Kind::kEquation: return "  " + line.value + "\n";
        case Line::Kind::kValue:
            return line.how.empty() ? fmt::format("    {:<12} {}\n", line.what, line.value)
                                    : fmt::format("    {:<12} {:<31} {}\n", line.what, line.value, line.how);
        case Line::Kind::kColor: return color_row(line.what, line.how, line.color);
        case Line::Kind::kNote: return note_text(line.value);
    }
    return "";
}

std::string derivation_text(const Derivation& at, const TextOptions& options) {
    std::string text;
    for (const Line& line : derivation_lines(at, options.all)) text += text_of(line, options.in_color);
    return text;
}

std::string rulings_text(const std::vector<reference::PixelFragment::Decided>& rulings) {
    std::string all;
    for (const auto& decided : rulings) {
        const lighting::RulingText& text = lighting::text_of(decided.ruling);
        const std::vector<std::string> lights = names_of(decided.lights);
        all += fmt::format("  {}{}\n", lights.empty() ? "" : tr("for {} ", fmt::join(lights, ", ")),
                           tr("the specification is silent ({}); our choice: {}", tr(text.state), tr(text.answer)));
    }
    return all;
}

}  // namespace twinlight::explain
