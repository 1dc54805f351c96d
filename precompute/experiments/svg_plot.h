// Small plots as SVG text: points and lines over two labelled axes, and a plan of a room seen from above. No
// library, no fonts beyond the browser's own, the same bytes for the same numbers.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux {

struct PlotSeries {
  enum class Mark { kLine, kStar, kSquare, kCircle };
  std::string name;
  std::string color;  // any SVG colour
  Mark mark = Mark::kLine;
  std::vector<std::pair<double, double>> points;
};

/// A plot of 640 x 400: axes that hold all points, ticks at round numbers, a legend.
std::string svgPlot(const std::string& title, const std::string& xLabel, const std::string& yLabel,
                    const std::vector<PlotSeries>& series);

/// The floor from above: the values of upward-facing patches (one per row of the scene) averaged over their
/// clusters, in shades from 0 to `brightest`, and the luminaires of the layout.
std::string svgPlan(const Scene& scene, const std::vector<float>& values, double brightest,
                    const Layout& layout);

}  // namespace fiatlux
