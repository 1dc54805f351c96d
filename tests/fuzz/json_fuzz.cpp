// Random text as layout.json and as intentions.json: a value or one readable line, never more.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "precompute/intentions_json.h"
#include "precompute/layout_json.h"
#include "tests/core/synthetic_scene.h"

namespace {

void checkLine(const std::string& line) {
  if (line.empty() || line.size() > 4000 || line.find('\n') != std::string::npos) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fiatlux::Scene scene = fiatlux::syntheticScene(8, 4);
  const std::string text(reinterpret_cast<const char*>(data), size);
  const fiatlux::Result<fiatlux::LayoutFile> file = fiatlux::parseLayout(text);
  if (file) {
    std::vector<std::string> notes;
    const fiatlux::Result<fiatlux::Layout> layout = fiatlux::layoutOnSites(*file, scene, notes);
    if (layout)
      (void)fiatlux::illuminanceOf(scene, *layout);
    else
      checkLine(layout.error().message);
    (void)fiatlux::freeLuminaires(*file, {});
  } else {
    checkLine(file.error().message);
  }
  const fiatlux::Result<fiatlux::Intentions> intentions = fiatlux::parseIntentions(scene, text);
  if (!intentions) checkLine(intentions.error().message);
  return 0;
}
