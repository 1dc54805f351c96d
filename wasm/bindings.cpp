// The only Emscripten code: binds the core's Session for the page's worker.
#include <emscripten/bind.h>

#include "core/patches.h"

EMSCRIPTEN_BINDINGS(core) {
  emscripten::constant("none", fiatlux::kNone);
}
