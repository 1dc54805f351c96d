// The program's name and version, as files and --version state them; package.json is where the number is
// typed.
#pragma once

namespace fiatlux {

/// "fiatlux 1.0.0".
const char* programVersion();

}  // namespace fiatlux
