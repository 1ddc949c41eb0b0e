#include "scene/record/keys.h"

#include <cctype>
#include <string_view>

#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/trace/process.h"

namespace twinlight::trace {

namespace {

// Of the characters from ' ' on that are no letters and digits (X11/keysymdef.h).
std::string name_of(char c) {
    static constexpr std::string_view kFromBlank[] = {
        "space",     "exclam",     "quotedbl", "numbersign", "dollar", "percent", "ampersand", "apostrophe",
        "parenleft", "parenright", "asterisk", "plus",       "comma",  "minus",   "period",    "slash"};
    static constexpr std::string_view kFromColon[] = {"colon",   "semicolon", "less", "equal",
                                                      "greater", "question",  "at"};
    static constexpr std::string_view kFromBracket[] = {"bracketleft", "backslash",  "bracketright",
                                                        "asciicircum", "underscore", "grave"};
    static constexpr std::string_view kFromBrace[] = {"braceleft", "bar", "braceright", "asciitilde"};
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) return std::string(1, c);
    if (c == '\n') return "Return";
    if (c == '\t') return "Tab";
    if (c >= ' ' && c <= '/') return std::string(kFromBlank[c - ' ']);
    if (c >= ':' && c <= '@') return std::string(kFromColon[c - ':']);
    if (c >= '[' && c <= '`') return std::string(kFromBracket[c - '[']);
    if (c >= '{' && c <= '~') return std::string(kFromBrace[c - '{']);
    throw SceneError(tr("--keys: only ASCII characters and names such as <Left> can be sent"));
}

}  // namespace

std::vector<std::string> keys_of(const std::string& text) {
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '<') {
            keys.push_back(name_of(text[i]));
            continue;
        }
        const std::size_t end = text.find('>', i);
        if (end == text.npos || end == i + 1)
            throw SceneError(tr("--keys: < starts the name of a key, as <Left>; for < itself, write <less>"));
        keys.push_back(text.substr(i + 1, end - i - 1));
        i = end;
    }
    return keys;
}

std::vector<std::string> sender_of(const std::vector<std::string>& keys) {
    need("xdotool", "xdotool", "--keys");
    // The root window has no name. Without a window manager no window has the focus of the keyboard.
    std::vector<std::string> command = {"xdotool", "search", "--sync",      "--onlyvisible", "--name",  ".",
                                        "sleep",   "0.1",    "windowfocus", "key",           "--delay", "60"};
    command.insert(command.end(), keys.begin(), keys.end());
    return command;
}

}  // namespace twinlight::trace
