// layout.json: luminaires on sites or anywhere, read strictly; one line says what is wrong.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/luminaire.h"
#include "core/scene/scene.h"
#include "core/transport/mounted_luminaire.h"
#include "precompute/files/areas_json.h"
#include "precompute/files/named_files.h"
#include "precompute/files/observers_json.h"
#include "precompute/files/paint_json.h"
#include "precompute/files/planes_json.h"

namespace fiatlux {

/// A luminaire of a photometric file, and how it is to hang on a site.
struct PhotometricEntry {
  std::shared_ptr<const Photometry> photometry;
  double flux = 0;  // lm, before dimming; 0: what the file holds
  Mounting mounting;
};

/// One luminaire as it was written: a site, a position, or both.
struct LayoutEntry {
  double flux = 0;  // lm, before dimming
  std::optional<PhotometricEntry> photometric;
  std::optional<std::uint32_t> site;
  std::optional<Luminaire> free;      // has a position; flux as above
  std::vector<std::string> freeKeys;  // those given of normal, size, axis, distribution: of free ones alone
};

struct LayoutFile {
  double dimming = 1;
  std::vector<LayoutEntry> luminaires;
  AskedObservers observers;
  std::vector<NamedPaint> paint;
  std::vector<AskedPlane> planes;
  std::vector<AskedArea> taskAreas;  // of a scene; `light` knows none
  bool directOnly = false;  // "quantity": "direct", of what nothing has reflected; else all light is read
};

/// Without `read`, luminaires of photometric files are refused.
Result<LayoutFile> parseLayout(const std::string& text, const ReadNamed& read = {});
/// The same from a file, which may name others in its folder and below; errors begin with the path.
Result<LayoutFile> readLayoutFile(const std::string& path);

/// On the sites of a scene: a site number as it is, a position on the nearest site. Notes say where a
/// position is further than half a site away and which keys were ignored. An error where a site is not there.
Result<Layout> layoutOnSites(const LayoutFile& file, const Scene& scene, std::vector<std::string>& notes);

/// Luminaires anywhere, dimming included in their flux. A site number means a site of the room; a position
/// beside it must agree, and keys of a free luminaire outrank it. An error where a site is not there.
Result<std::vector<Luminaire>> freeLuminaires(const LayoutFile& file, const std::vector<Site>& sites);

/// {"site", "position", "flux"}, before dimming.
nlohmann::ordered_json luminaireJson(std::uint32_t site, const Vec3& position, double flux);

/// {"dimming", "luminaires": [{"site", "position", "flux"}]}: what readLayoutFile reads.
nlohmann::ordered_json layoutJson(const Layout& layout, const Scene& scene);

}  // namespace fiatlux
