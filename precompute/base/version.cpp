#include "precompute/base/version.h"

namespace fiatlux {

const char* programVersion() { return "fiatlux " FIATLUX_VERSION; }

}  // namespace fiatlux
