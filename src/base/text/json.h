// nlohmann::json, and JSON whose members keep their order.
#pragma once

#include <cassert>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#ifdef INCLUDE_NLOHMANN_JSON_HPP_
#error "include base/text/json.h in place of <nlohmann/json.hpp>"
#endif
namespace twinlight {
// json's destructor takes a value for whole that an allocation's exception left half made (before version 3.11.3). Thrown from there,
// this exception ends the program, as one of memory that is short.
inline bool is_half_made() {
    if (std::uncaught_exceptions() > 0) throw std::bad_alloc();
    return false;
}
}  // namespace twinlight
#define JSON_ASSERT(condition) assert((condition) || twinlight::is_half_made())
#include <nlohmann/json.hpp>

namespace twinlight {

using Json = nlohmann::ordered_json;

// These are compiled once: json's own functions are templates, which each room would compile again.
// In one line. A scene's text may hold any bytes, but JSON is UTF-8: what is not becomes U+FFFD.
std::string dumped(const Json& json);
// The same with a line for each value, and a newline at the end: a file.
std::string dumped_lines(const Json& json);
// Json::is_discarded() if the text is not JSON.
Json parsed_json(std::string_view text);

}  // namespace twinlight
