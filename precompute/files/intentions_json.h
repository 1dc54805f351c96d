// intentions.json read strictly: every key known, every type right, every surface found, or one line that
// says what is wrong and where. Surfaces are names (core/scene/surface_names.h) or lists of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/candidates/candidate_list.h"
#include "core/scene/scene.h"
#include "core/search/intentions.h"
#include "precompute/files/named_files.h"
#include "precompute/files/paint_json.h"

namespace fiatlux {

/// A luminaire type that may be used: a photometric file, and the ways in which luminaires of it may hang.
/// How many there may be is in LuminaireRules::types, in the same order.
struct AskedType {
  std::string name;  // of the file, as it was written
  std::shared_ptr<const Photometry> photometry;
  double flux = 0;   // lm of one luminaire; 0: what the file's table holds
  double watts = 0;  // W of one luminaire; 0: not known
  TypeWays ways;
};

struct IntentionsFile {
  Intentions intentions;         // pinned and excluded sites are those of the room
  std::vector<AskedType> types;  // none: luminaires are Lambertian squares
  std::vector<NamedPaint> paint;
};

/// The intentions in `text` for this room. Those without types are checked by checkIntentions too; of those
/// with types that is left to their candidates (asked_search.h). Without `read`, photometric files are
/// refused.
Result<IntentionsFile> parseIntentionsFile(const Scene& room, const std::string& text,
                                           const ReadNamed& read = {});
/// The same from a file, which may name others in its folder and below; errors begin with the path.
Result<IntentionsFile> readIntentionsFile(const Scene& room, const std::string& path);

}  // namespace fiatlux
