// How the worth of layouts goes about one of them, to first order in the moments of each surface set: a
// variance goes exactly as luminaires move, so only its root and where the light is dimmed to are
// straightened.
#pragma once

#include <cstdint>
#include <vector>

namespace fiatlux {

/// By mean and variance of one surface set.
struct Slope {
  std::uint32_t set = 0;
  double mean = 0, variance = 0;
};

/// A sum of slopes, and of edges beyond which bounds are broken or aims overshot.
struct LinearWorth {
  struct Edge {
    Slope slope;
    double beyond;  // where the layout stands; what is above 0 counts
  };
  std::vector<Slope> slopes;  // one a set
  std::vector<Edge> edges;
};

}  // namespace fiatlux
