// What a search is asked by a file of intentions: about the sites of the room, or, where luminaires are of
// photometric files or the room is painted, about the candidates that these make in it (core/candidates), and
// back again.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/candidates/candidate_scene.h"
#include "core/search/shown.h"
#include "precompute/files/intentions_json.h"
#include "precompute/files/light_results.h"

namespace fiatlux {

class AskedSearch {
 public:
  /// Computes the light of all candidates, and what observers see of them or of the room's squares. An error
  /// where the room knows squares in its own paint only, nothing fits, a painted surface is not there, or the
  /// intentions do not pass checkIntentions. The room must outlive it.
  static Result<AskedSearch> make(Scene& room, IntentionsFile asked);

  bool isOfTypes() const { return !types_.empty(); }
  /// What is searched: its sites are candidates where luminaires are of types.
  const Scene& scene() const { return hasCandidates() ? candidateScene_ : *room_; }
  const Intentions& intentions() const { return intentions_; }
  const Scene& room() const { return *room_; }

  /// Surfaces under a layout of that scene; under its direct light alone where that is the quantity asked
  /// for.
  LightResults lightResults(const Layout& layout) const;
  /// A layout of that scene as readLayoutFile reads it, on sites of the room; photometric files are named as
  /// in the intentions. With the paint that was asked for.
  nlohmann::ordered_json layoutJson(const Layout& layout) const;
  /// A layout of that scene as one of the room's sites: where luminaires hang, and their lm.
  Layout onSites(const Layout& layout) const;
  /// "L1 on site 4 at (1.000, 2.800, 3.000) m, 1200 lm", and of types the file, turn and aim.
  std::string luminaireLine(const Layout& layout, std::size_t i) const;

  /// Photometric files are from now on named as a document at `to` sees them, instead of the intentions at
  /// `from`; an error where one lies neither beside that nor below.
  Result<Done> nameFilesFrom(const std::string& to, const std::string& from);

 private:
  explicit AskedSearch(const Scene& room, IntentionsFile asked);
  /// Of types on sites, or of the sites themselves in the painted room, by their numbers.
  bool hasCandidates() const { return isOfTypes() || !paint_.empty(); }
  Result<std::shared_ptr<const Repaint>> repaint(const PhotometricLight* light) const;
  Result<CandidateScene> beginCandidates(std::shared_ptr<const PhotometricLight> light);
  Result<Done> makeCandidates();
  nlohmann::ordered_json typesJson(const Layout& layout) const;
  Result<Done> takeSites(const LuminaireRules& asked);
  Result<Done> checkPower() const;
  Result<Done> checkGlare() const;

  const Scene* room_;
  Intentions intentions_;
  std::vector<AskedType> types_;
  std::vector<NamedPaint> paint_;
  std::vector<double> flux_;  // lm, of each type
  std::vector<Candidate> candidates_;
  Scene candidateScene_;
};

}  // namespace fiatlux
