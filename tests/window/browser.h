// A browser without a window, for the tests of pages.
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "../unit/run_program.h"
#include "base/text/json.h"

namespace twinlight {

// The first of these programs that is installed; empty without one.
inline std::string first_installed(std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (run_shell("", std::string("command -v ") + name).status == 0) return name;
    return {};
}
inline std::string browser() { return first_installed({"chromium", "chromium-browser", "google-chrome"}); }
inline std::string firefox() { return first_installed({"firefox-esr", "firefox"}); }

// What innerHTML escapes.
inline std::string unescaped(std::string text) {
    for (const auto& [escaped, character] : {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&nbsp;", " "}, {"&amp;", "&"}})
        for (std::size_t at = 0; (at = text.find(escaped, at)) != std::string::npos; ++at)
            text.replace(at, std::string_view(escaped).size(), character);
    return text;
}

inline std::string from_base64(std::string_view text) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char letter : text.substr(0, text.find('='))) {
        bits = bits << 6 | static_cast<unsigned>(kLetters.find(letter));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xFF);
    }
    return bytes;
}

// Opens the file `page` of the folder. Returns the JSON that the page's script leaves between "told:" and ":told". No name
// resolves: what is not in the page does not load.
inline nlohmann::json json_of_page(const std::string& program, const std::string& options, const std::string& page,
                                   const TemporaryFolder& folder) {
    const ProgramResult result =
        run_shell("", program + " --headless --no-sandbox --no-first-run " + options +
                          " --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir=" + quoted(folder / "profile") +
                          " --virtual-time-budget=20000 --dump-dom " + quoted("file://" + folder / page));
    const std::size_t begin = result.out.find("told:{"), end = result.out.rfind("}:told");
    if (begin == std::string::npos || end == std::string::npos)
        throw std::runtime_error("the page says nothing: " + result.out.substr(0, 500) + result.err);
    return nlohmann::json::parse(unescaped(result.out.substr(begin + 5, end + 1 - (begin + 5))));
}

}  // namespace twinlight
