// Steps; see tabu.h.
#include "core/search/tabu.h"

#include <algorithm>
#include <utility>

namespace fiatlux {
namespace {

constexpr std::uint32_t kTabuLuminaires = 16;   // looked at in a step, of more
constexpr std::uint32_t kMostCandidates = 512;  // of more, a step lasts as long as many steps of a warm walk
constexpr std::uint32_t kTrialsPerStep = 10;    // a step counts as so many, for as long it lasts,
constexpr std::uint32_t kMovesPerTrial = 200;   // and as one more for so many moves
// A site that was left is tabu for so many steps and up to so many more, a luminaire that moved likewise.
constexpr std::uint32_t kLeastAway = 4, kMoreAway = 6, kLeastRest = 1, kMoreRest = 3;

}  // namespace

bool Tabu::isPossible(const Surroundings& at) {
  const std::vector<double>& flux = at.evaluator.flux();
  return at.maySurvey() && at.evaluator.mayLookAround() && at.freeSites.isSimple() &&
         at.freeSites.candidateCount() <= kMostCandidates &&
         at.freeSites.movable().size() > kLeastRest + kMoreRest &&
         std::all_of(flux.begin(), flux.end(), [&](double each) { return each == flux[0]; });
}

void Tabu::clear() {
  step_ = 0;
  siteUntil_.clear();
  luminaireUntil_.clear();
}

void Tabu::open(const Surroundings& at, Scan& scan) {
  siteUntil_.resize(at.freeSites.candidateCount(), 0);
  luminaireUntil_.resize(at.evaluator.sites().size(), 0);
  ++step_;
  luminaires_.clear();
  for (const std::uint32_t i : at.freeSites.movable())
    if (luminaireUntil_[i] <= step_) luminaires_.push_back(i);
  const auto count = static_cast<std::uint32_t>(luminaires_.size());
  if (count > kTabuLuminaires) {
    for (std::uint32_t k = 0; k < kTabuLuminaires; ++k)
      std::swap(luminaires_[k], luminaires_[k + at.random.below(count - k)]);
    luminaires_.resize(kTabuLuminaires);
  }
  scan.found = {{}, 0, kNothingFound};
  scan.size =
      kTrialsPerStep + std::min(count, kTabuLuminaires) * at.freeSites.candidateCount() / kMovesPerTrial;
}

void Tabu::choose(const Surroundings& at, Scan& scan) {
  const std::uint32_t count = at.freeSites.candidateCount(), step = step_;
  const std::uint32_t *inTheWay = at.freeSites.inTheWay().data(), *until = siteUntil_.data();
  closed_.resize(count);
  float* closed = closed_.data();
  for (std::uint32_t c = 0; c < count; ++c) closed[c] = inTheWay[c] != 0 || until[c] > step ? kNoMove : 0.0f;
  Move move;
  if (!at.evaluator.bestMove(luminaires_, closed_, move)) return;
  siteUntil_[at.evaluator.sites()[move.luminaire]] = step_ + kLeastAway + at.random.below(kMoreAway);
  luminaireUntil_[move.luminaire] = step_ + kLeastRest + at.random.below(kMoreRest);
  scan.found.moves[0] = move;
  scan.found.count = 1;  // note: judged when it is made, as of a survey
}

}  // namespace fiatlux
