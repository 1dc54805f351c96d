// Plots and plans; see svg_plot.h.
#include "precompute/experiments/svg_plot.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <limits>

namespace fiatlux {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kWidth = 640, kHeight = 400, kLeft = 72, kRight = 620, kTop = 44, kBottom = 346;

template <class... Args>
std::string format(const char* pattern, Args... args) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, pattern, args...);
  return buffer;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text)
    result += c == '<'   ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '&' ? "&amp;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  return result;
}

std::string label(double x, double y, const std::string& text, const char* extra = "") {
  return format("<text x=\"%.1f\" y=\"%.1f\" %s>", x, y, extra) + escaped(text) + "</text>\n";
}

/// One axis: data range widened a little, and a round tick step.
struct Axis {
  double low = 0, high = 1, step = 1;
  Axis(double least, double largest) {
    if (!(largest > least)) largest = least + std::max(1e-9, std::fabs(least));
    const double pad = 0.04 * (largest - least);
    low = least >= 0 && least < 0.25 * largest ? 0 : least - pad;
    high = largest + pad;
    const double rough = (high - low) / 6, power = std::pow(10, std::floor(std::log10(rough)));
    const double share = rough / power;
    step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
  }
  double at(double value, double from, double to) const {
    return from + (value - low) / (high - low) * (to - from);
  }
};

std::string axesOf(const Axis& x, const Axis& y) {
  std::string svg;
  for (double v = std::ceil(x.low / x.step) * x.step; v <= x.high + 1e-9 * x.step; v += x.step) {
    const double at = x.at(v, kLeft, kRight);
    svg += format("<line x1=\"%.1f\" y1=\"%.0f\" x2=\"%.1f\" y2=\"%.0f\" stroke=\"#ddd\"/>\n", at, kTop, at,
                  kBottom);
    svg += label(at, kBottom + 16, format("%.4g", std::fabs(v) < 1e-9 * x.step ? 0 : v),
                 "text-anchor=\"middle\"");
  }
  for (double v = std::ceil(y.low / y.step) * y.step; v <= y.high + 1e-9 * y.step; v += y.step) {
    const double at = y.at(v, kBottom, kTop);
    svg += format("<line x1=\"%.0f\" y1=\"%.1f\" x2=\"%.0f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", kLeft, at,
                  kRight, at);
    svg +=
        label(kLeft - 6, at + 4, format("%.4g", std::fabs(v) < 1e-9 * y.step ? 0 : v), "text-anchor=\"end\"");
  }
  return svg + format("<path d=\"M%.0f %.0fV%.0fH%.0f\" fill=\"none\" stroke=\"#333\"/>\n", kLeft, kTop,
                      kBottom, kRight);
}

std::string markOf(PlotSeries::Mark mark, double x, double y, const std::string& color) {
  const char* c = color.c_str();
  if (mark == PlotSeries::Mark::kSquare)
    return format("<rect x=\"%.1f\" y=\"%.1f\" width=\"7\" height=\"7\" fill=\"%s\"/>\n", x - 3.5, y - 3.5,
                  c);
  if (mark == PlotSeries::Mark::kCircle)
    return format(
        "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"5\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\"/>\n", x, y,
        c);
  return format(
      "<path d=\"M%.1f %.1fm-5 0h10m-5 -5v10m-3.5 -8.5l7 7m0 -7l-7 7\" stroke=\"%s\" fill=\"none\"/>\n", x, y,
      c);
}

std::string seriesOf(const PlotSeries& series, const Axis& x, const Axis& y) {
  std::string svg, path;
  for (const auto& [px, py] : series.points) {
    const double sx = x.at(px, kLeft, kRight), sy = y.at(py, kBottom, kTop);
    if (series.mark == PlotSeries::Mark::kLine)
      path += format("%s%.1f %.1f", path.empty() ? "M" : "L", sx, sy);
    else
      svg += markOf(series.mark, sx, sy, series.color);
  }
  if (!path.empty())
    svg += "<path d=\"" + path + "\" fill=\"none\" stroke-width=\"1.5\" stroke=\"" + series.color + "\"/>\n";
  return svg;
}

}  // namespace

std::string svgPlot(const std::string& title, const std::string& xLabel, const std::string& yLabel,
                    const std::vector<PlotSeries>& series) {
  double x0 = kInfinity, x1 = -kInfinity, y0 = kInfinity, y1 = -kInfinity;
  for (const PlotSeries& one : series)
    for (const auto& [x, y] : one.points) {
      x0 = std::min(x0, x), x1 = std::max(x1, x);
      y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
  if (x0 > x1) x0 = y0 = 0, x1 = y1 = 1;
  const Axis xAxis(x0, x1), yAxis(y0, y1);
  std::string svg = format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" "
      "font-size=\"12\" fill=\"#222\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
      kWidth, kHeight);
  svg += label(kWidth / 2, 18, title, "text-anchor=\"middle\" font-weight=\"bold\"") + axesOf(xAxis, yAxis);
  svg += label((kLeft + kRight) / 2, kHeight - 16, xLabel, "text-anchor=\"middle\"");
  svg += label(-(kTop + kBottom) / 2, 16, yLabel, "text-anchor=\"middle\" transform=\"rotate(-90)\"");
  double legend = kLeft;
  for (const PlotSeries& one : series) {
    svg += seriesOf(one, xAxis, yAxis);
    svg +=
        one.mark == PlotSeries::Mark::kLine
            ? format("<line x1=\"%.1f\" y1=\"32\" x2=\"%.1f\" y2=\"32\" stroke=\"%s\" stroke-width=\"2\"/>\n",
                     legend, legend + 12, one.color.c_str())
            : markOf(one.mark, legend + 6, 32, one.color);
    svg += label(legend + 18, 36, one.name);
    legend += 34 + 6.6 * static_cast<double>(one.name.size());
  }
  return svg + "</svg>\n";
}

std::string svgPlan(const Scene& scene, const std::vector<float>& values, double brightest,
                    const Layout& layout) {
  assert(values.size() == scene.patches.rows() && brightest > 0);
  struct Cell {
    double x0 = kInfinity, x1 = -kInfinity, z0 = kInfinity, z1 = -kInfinity, area = 0, sum = 0;
  };
  std::vector<Cell> cells(scene.patches.clusterCount);
  double x0 = kInfinity, x1 = -kInfinity, z0 = kInfinity, z1 = -kInfinity;
  for (std::uint32_t p = 0; p < scene.patches.count; ++p) {
    if (scene.patches.normal[p].y < 0.9) continue;
    const Vec3& at = scene.patches.center[p];
    const double half = std::sqrt(scene.patches.area[p]) / 2;
    Cell& cell = cells[scene.patches.cluster[p]];
    cell.x0 = std::min(cell.x0, at.x - half), cell.x1 = std::max(cell.x1, at.x + half);
    cell.z0 = std::min(cell.z0, at.z - half), cell.z1 = std::max(cell.z1, at.z + half);
    cell.area += scene.patches.area[p];
    cell.sum += scene.patches.area[p] * values[p];
    x0 = std::min(x0, cell.x0), x1 = std::max(x1, cell.x1), z0 = std::min(z0, cell.z0),
    z1 = std::max(z1, cell.z1);
  }
  // Long rooms lie on their side: z runs to the right, x downwards.
  std::string svg = format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"%.3f %.3f %.3f %.3f\">\n",
                           z0 - 0.3, x0 - 0.3, z1 - z0 + 0.6, x1 - x0 + 0.6);
  for (const Cell& cell : cells) {
    if (cell.area == 0) continue;
    const double share = std::sqrt(std::clamp(cell.sum / cell.area / brightest, 0.0, 1.0));
    svg +=
        format("<rect x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" height=\"%.3f\" fill=\"rgb(%.0f,%.0f,%.0f)\"/>\n",
               cell.z0, cell.x0, cell.z1 - cell.z0 + 0.01, cell.x1 - cell.x0 + 0.01, 25 + 230 * share,
               25 + 215 * share, 45 + 150 * share);
  }
  for (std::uint32_t site : layout.sites) {
    const Vec3& at = scene.sites[site].position;
    svg += format(
        "<circle cx=\"%.3f\" cy=\"%.3f\" r=\"0.28\" fill=\"#d22\" stroke=\"#fff\" stroke-width=\"0.06\"/>\n",
        at.z, at.x);
  }
  return svg + "</svg>\n";
}

}  // namespace fiatlux
