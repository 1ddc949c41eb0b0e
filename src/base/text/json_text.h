// JSON whose members keep their order.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace twinlight {

using Json = nlohmann::ordered_json;

// A scene's text may hold any bytes, but JSON is UTF-8.
inline std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace twinlight
