// JSON that a person or a stranger wrote: broken, too deep or sound.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/result.h"

namespace fiatlux {

/// Any JSON text, at most 64 deep. An error names the line and the byte.
Result<nlohmann::json> parseJson(const std::string& text);

}  // namespace fiatlux
