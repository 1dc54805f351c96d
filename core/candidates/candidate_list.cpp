#include "core/candidates/candidate_list.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "core/candidates/mount_area.h"
#include "core/transport/candidate_fit.h"

namespace fiatlux {
namespace {

constexpr double kAngleSlack = 1e-6;  // degrees: a limit that is an aim's very angle holds it

/// Degrees between two directions.
double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

}  // namespace

Mounting mountingOf(const Candidate& candidate) {
  Mounting mounting;
  mounting.turn = candidate.turn;
  mounting.aim = candidate.aim;
  return mounting;
}

std::vector<Candidate> candidatesOf(const Scene& room, const std::vector<CandidateType>& types,
                                    const std::vector<TypeWays>& ways) {
  assert(room.lightOperator && ways.size() == types.size());
  // What hangs on each site, as if there were one.
  std::vector<Candidate> onOne;
  for (std::uint32_t t = 0; t < types.size(); ++t)
    for (const double turn : ways[t].turns) {
      const auto add = [&](const std::optional<Vec3>& aim) {
        onOne.push_back({0, t, static_cast<std::uint32_t>(onOne.size()), turn, aim});
      };
      if (ways[t].aims.empty()) add({});
      for (const Vec3& aim : ways[t].aims) add(aim);
    }
  const MountArea mount(room.sites);
  const CandidateFit fit(room);
  std::vector<Candidate> candidates;
  for (std::uint32_t site = 0; site < room.sites.size(); ++site)
    for (Candidate candidate : onOne) {
      candidate.site = site;
      const CandidateType& type = types[candidate.type];
      const Luminaire luminaire =
          mountedLuminaire(type.photometric, type.flux, room.sites[site], mountingOf(candidate));
      const double most = ways[candidate.type].maxAimingAngle + kAngleSlack;
      if (candidate.aim && angleBetween(room.sites[site].normal, luminaire.normal) > most) continue;
      if (mount.holds(site, luminaire) && fit.fits(luminaire, type.photometric.luminous.height))
        candidates.push_back(candidate);
    }
  return candidates;
}

}  // namespace fiatlux
