// Intentions of a text that asks for no types.
#pragma once

#include <string>

#include "precompute/files/intentions_json.h"

namespace fiatlux {

inline Result<Intentions> intentionsIn(const Scene& scene, const std::string& text) {
  const Result<IntentionsFile> asked = parseIntentionsFile(scene, text);
  if (!asked) return asked.error();
  return asked->intentions;
}

}  // namespace fiatlux
