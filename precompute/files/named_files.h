// Files that a JSON document names: beside it or in a folder below, never elsewhere.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/photometry/photometry.h"
#include "precompute/files/json_fields.h"

namespace fiatlux {

/// The bytes of a file that a document names.
using ReadNamed = std::function<Result<std::vector<std::uint8_t>>(const std::string& name)>;

/// Files in the folder of `path` and below; errors call the document `what`: "layout".
ReadNamed filesBeside(const std::string& path, const std::string& what);

/// The photometric file that a field names. A fault ends the reading; without `read` every name is one.
std::shared_ptr<const Photometry> photometryOf(const JsonField& name, const ReadNamed& read);

/// How a document at `to` names a file that one at `from` calls `name`; an error where it lies neither beside
/// it nor below. Both documents' folders exist.
Result<std::string> nameSeenFrom(const std::string& to, const std::string& from, const std::string& name);

}  // namespace fiatlux
