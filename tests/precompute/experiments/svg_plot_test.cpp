// Where points, ticks and luminaires land in the plots, and that no text breaks the SVG.
#include "precompute/experiments/svg_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/corridor_scene.h"

using ::testing::HasSubstr;
using ::testing::Not;

namespace fiatlux {
namespace {

using Mark = PlotSeries::Mark;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(SvgPlot, PutsPointsWhereTheAxesSay) {
  const std::string svg = svgPlot("t", "x", "y", {{"line", "#000", Mark::kLine, {{0, 0}, {10, 100}}}});
  EXPECT_THAT(svg, HasSubstr("M72.0 346.0L")) << "the origin is the lower left corner";
  EXPECT_THAT(svg, HasSubstr(">100<")) << "a tick at a round number";
}

TEST(SvgPlot, EveryPointOfEveryMarkIsThere) {
  const std::string svg = svgPlot("t", "x", "y",
                                  {{"a", "#a00", Mark::kSquare, {{1, 1}, {2, 3}}},
                                   {"b", "#0b0", Mark::kCircle, {{1, 2}}},
                                   {"c", "#00c", Mark::kStar, {{2, 2}, {3, 1}, {4, 1}}}});
  EXPECT_EQ(count(svg, "fill=\"#a00\""), 3u) << "two points and the legend";
  EXPECT_EQ(count(svg, "stroke=\"#0b0\""), 2u);
  EXPECT_EQ(count(svg, "stroke=\"#00c\""), 4u);
}

TEST(SvgPlot, TextIsEscaped) {
  const std::string svg = svgPlot("t < 1 & \"u\"", "x>", "y", {});
  EXPECT_THAT(svg, HasSubstr("t &lt; 1 &amp; &quot;u&quot;"));
  EXPECT_THAT(svg, HasSubstr("x&gt;"));
}

TEST(SvgPlot, NoPointsAndOnePointHaveAxesToo) {
  for (const auto& points : {std::vector<std::pair<double, double>>{}, {{5, 5}}, {{5, 0}, {5, 0}}}) {
    const std::string svg = svgPlot("t", "x", "y", {{"s", "#000", Mark::kCircle, points}});
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
}

TEST(SvgPlan, ShadesClustersAndMarksLuminaires) {
  const Scene& scene = fiatlux::testing::smallRoom();
  const std::vector<float> dark(scene.patches.rows(), 0.0f), bright(scene.patches.rows(), 9.0f);
  const Layout layout{{0, 1}, {1, 1}, 1};
  EXPECT_EQ(count(svgPlan(scene, dark, 3, layout), "<circle"), 2u);
  EXPECT_THAT(svgPlan(scene, dark, 3, layout), HasSubstr("rgb(25,25,45)"));
  EXPECT_THAT(svgPlan(scene, bright, 3, layout), HasSubstr("rgb(255,240,195)")) << "never beyond white";
}

}  // namespace
}  // namespace fiatlux
