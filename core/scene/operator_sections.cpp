// Writer and reader of one thing side by side, so that they stay each other's inverse.
#include "core/scene/operator_sections.h"

#include <algorithm>
#include <cmath>

#include "core/scene/exchange_codec.h"
#include "core/scene/older_operator_codec.h"
#include "core/scene/scene_sections.h"
#include "core/scene/section_codec.h"
#include "core/scene/surface_exchange_codec.h"
#include "core/scene/visibility_codec.h"

namespace fiatlux {
namespace {

constexpr double kLongestCell = 1e6;  // m
// Steps of 1 that charts' frames are kept in; finer is noise of the model's vertices, which no two of a row
// of chairs share, so that it does not deflate.
constexpr double kFrameSteps = 4096;
constexpr std::string_view kNames[] = {"siteVisibility", "charts",   "chartFrames",
                                       "groups",         "exchange", "exchangeRest"};
constexpr std::string_view kAspects = "chartAspects", kSurfaceExchange = "surfaceExchange";

/// How many sites' shares fit one section, even if no two rows were alike.
std::uint32_t visibilityBlockSites(std::uint32_t rows) {
  return static_cast<std::uint32_t>(
      std::max<std::uint64_t>(1, kMaxInflatedBytes / (6 * std::uint64_t{rows} + 6)));
}

/// A part of a unit vector. Zero has no sign.
float keptPart(double x) { return static_cast<float>(std::round(x * kFrameSteps) / kFrameSteps + 0.0); }

/// A length, of which the parts of the next power of 2 are kept.
float keptLength(double x) {
  int exponent = 0;
  const double part = std::frexp(x, &exponent);
  return static_cast<float>(std::ldexp(std::round(part * kFrameSteps) / kFrameSteps, exponent));
}

PlainSection bytesSection(std::string name, std::vector<std::uint8_t> bytes) {
  const auto length = static_cast<std::uint32_t>(bytes.size());
  return plainSection(std::move(name), ElementType::kUint8, Encoding::kPlain, length, 1, std::move(bytes));
}

PlainSection integersSection(const char* name, const std::vector<std::uint32_t>& values,
                             std::uint32_t columns) {
  return plainSection(name, ElementType::kUint32, Encoding::kDeltaPlanes,
                      static_cast<std::uint32_t>(values.size() / columns), columns,
                      encodeDeltaPlanes(values, columns));
}

PlainSection steppedSection(std::string name, std::vector<std::uint8_t> bytes, double step) {
  const auto length = static_cast<std::uint32_t>(bytes.size());
  return plainSection(std::move(name), ElementType::kUint8, Encoding::kBeside, length, 1, std::move(bytes),
                      static_cast<float>(step));
}

/// Range coded bytes, what they count in, and whether they are as of today.
struct Stepped {
  std::vector<std::uint8_t> bytes;
  double step = 0;
  bool isOlder = false;
};

/// `oldest`: the step of files that do not tell theirs.
Stepped takeStepped(CheckedSections& in, std::string_view name, double oldest) {
  const Encoding encoding = in.has(name) ? in.line(name).encoding : Encoding::kPlain;
  const auto take = [&] {
    return in.take(name, ElementType::kUint8, encoding, CheckedSections::kAnyRows, 1);
  };
  if (encoding == Encoding::kPlain) return {take(), oldest, true};
  const double step = in.line(name).errorBound;
  if (encoding != Encoding::kStepped && encoding != Encoding::kBeside)
    in.fail(name, "its shape does not fit the room's counts");
  if (!(step > 0 && step < 1)) in.fail(name, "it has no steps");
  return {take(), step, encoding == Encoding::kStepped};
}

std::string decodeBlock(const Stepped& block, const Scene& scene, std::uint32_t first, std::uint32_t last,
                        SiteVisibility& visibility) {
  if (block.isOlder) return decodeOlderVisibility(block.bytes, scene.patches, first, last, visibility);
  const double steps = std::round(1 / block.step);
  if (steps > SiteVisibility::kSteps) return "its steps are too small";
  return decodeVisibility(block.bytes, scene.patches, scene.sites, first, last, visibility,
                          static_cast<std::uint32_t>(steps));
}

void readVisibility(CheckedSections& in, const SceneCounts& counts, const Scene& scene,
                    SiteVisibility& visibility) {
  visibility.rows = counts.rows();
  visibility.sites = counts.sites;
  visibility.steps.resize(std::size_t{visibility.rows} * visibility.sites);
  const std::uint32_t perBlock = visibilityBlockSites(visibility.rows);
  for (std::uint32_t first = 0, block = 0; in.ok() && first < counts.sites; first += perBlock, ++block) {
    const std::string name = numberedName("siteVisibility", block);
    const Stepped stepped = takeStepped(in, name, 1.0 / SiteVisibility::kSteps);
    if (!in.ok()) return;
    const std::string fault =
        decodeBlock(stepped, scene, first, std::min(first + perBlock, counts.sites), visibility);
    if (!fault.empty()) in.fail(name, fault);
  }
}

void readCharts(CheckedSections& in, const SceneCounts& counts, Charts& charts) {
  charts.ofRow = in.integers("charts", counts.rows(), 1);
  const std::vector<float> numbers =
      in.floats("chartFrames", Encoding::kFloatPlanes, CheckedSections::kAnyRows, kChartColumns,
                -kLongestCell, kLongestCell);
  if (!in.ok()) return;
  for (std::size_t i = 0; i + kChartColumns <= numbers.size(); i += kChartColumns) {
    const float* v = &numbers[i];
    const Charts::Frame frame{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6], v[7]};
    const bool unit = std::abs(length(frame.uAxis) - 1) < 1e-3 && std::abs(length(frame.vAxis) - 1) < 1e-3 &&
                      std::abs(dot(frame.uAxis, frame.vAxis)) < 1e-3;
    if (!unit || !(frame.cellU > 0) || !(frame.cellV > 0))
      return in.fail("chartFrames", "a chart has no size or direction");
    charts.frames.push_back(frame);
  }
  for (const std::uint32_t chart : charts.ofRow)
    if (chart >= charts.frames.size()) return in.fail("charts", "a row is on a chart that is not there");
  if (!in.isThere(kAspects)) return;
  const std::vector<std::uint8_t> aspects =
      in.take(kAspects, ElementType::kUint8, Encoding::kPlain, counts.rows(), 1);
  charts.aspect.assign(aspects.begin(), aspects.end());
}

void readGroups(CheckedSections& in, const SceneCounts& counts, ExchangeGroups& groups) {
  const std::vector<std::uint32_t> values = in.integers("groups", counts.rows(), kGroupColumns);
  if (!in.ok()) return;
  for (std::uint32_t p = 0; p < counts.rows(); ++p) {
    const std::uint32_t group = values[kGroupColumns * p], barriers = values[kGroupColumns * p + 1];
    if (group >= counts.rows() || barriers > 3) return in.fail("groups", "a value is out of range");
    groups.ofRow.push_back(group);
    groups.barriers.push_back(static_cast<std::uint8_t>(barriers));
    groups.total = std::max(groups.total, group + 1);
    if (p < counts.patches)
      groups.count = groups.total;
    else if (group < groups.count)
      return in.fail("groups", "a receiver is in a group of patches");
  }
  std::vector<char> seen(groups.total, 0);
  for (const std::uint32_t group : groups.ofRow) seen[group] = 1;
  if (std::find(seen.begin(), seen.end(), 0) != seen.end()) return in.fail("groups", "a group is empty");
  if (std::uint64_t{groups.total} * groups.count > kMaxExchangeValues)
    in.fail("groups", "there are too many");
}

void readExchange(CheckedSections& in, const Patches& patches, LightOperator& op) {
  const Stepped means = takeStepped(in, "exchange", kOldestExchangeStep),
                rest = takeStepped(in, "exchangeRest", kOldestExchangeStep);
  if (!in.ok()) return;
  std::string fault = (means.isOlder ? decodeOlderExchangeMeans : decodeExchangeMeans)(
      means.bytes, patches, op.groups, op.exchange, means.step);
  if (!fault.empty()) return in.fail("exchange", fault);
  fault = (rest.isOlder ? decodeOlderExchangeRest : decodeExchangeRest)(rest.bytes, patches, op.groups,
                                                                        op.exchange, rest.step);
  if (!fault.empty()) in.fail("exchangeRest", fault);
}

void readSurfaceExchange(CheckedSections& in, const Scene& scene, SurfaceExchange& exchange) {
  if (!in.isThere(kSurfaceExchange)) return;
  const Stepped means = takeStepped(in, kSurfaceExchange, kSurfaceExchangeStep);
  if (!in.ok()) return;
  exchange.surfaces = static_cast<std::uint32_t>(scene.surfaces.size());
  if (std::uint64_t{exchange.surfaces} * scene.patches.count > kMaxSurfaceExchangeValues)
    return in.fail(kSurfaceExchange, "there are too many surfaces");
  const std::string fault =
      decodeSurfaceExchange(means.bytes, scene.patches, exchange, means.step, means.isOlder);
  if (!fault.empty()) in.fail(kSurfaceExchange, fault);
}

}  // namespace

bool isOperatorSection(std::string_view name) {
  return name == kAspects || name == kSurfaceExchange ||
         std::find(std::begin(kNames), std::end(kNames), name.substr(0, name.find('.'))) != std::end(kNames);
}

Result<Done> encodeOperator(const Scene& scene, std::vector<PlainSection>& sections) {
  const auto& [visibility, charts, groups, exchange, surfaces] = *scene.lightOperator;
  if (std::uint64_t{groups.total} * groups.count > kMaxExchangeValues)
    return Error{std::to_string(groups.total) +
                 " groups of patches are too many for a scene file: use larger patches"};
  const std::uint32_t perBlock = visibilityBlockSites(visibility.rows);
  for (std::uint32_t first = 0, block = 0; first < visibility.sites; first += perBlock, ++block)
    sections.push_back(steppedSection(numberedName("siteVisibility", block),
                                      encodeVisibility(scene.patches, scene.sites, visibility, first,
                                                       std::min(first + perBlock, visibility.sites)),
                                      1.0 / kStoredShares));
  std::vector<float> frames;
  for (const Charts::Frame& frame : charts.frames) {
    for (const Vec3& v : {frame.uAxis, frame.vAxis})
      for (const double x : {v.x, v.y, v.z}) frames.push_back(keptPart(x));
    for (const double edge : {frame.cellU, frame.cellV}) frames.push_back(keptLength(edge));
  }
  sections.push_back(integersSection("charts", charts.ofRow, 1));
  sections.push_back(plainSection("chartFrames", ElementType::kFloat32, Encoding::kFloatPlanes,
                                  static_cast<std::uint32_t>(charts.frames.size()), kChartColumns,
                                  encodeFloatPlanes(frames)));
  if (!charts.aspect.empty())
    sections.push_back(bytesSection(std::string(kAspects), {charts.aspect.begin(), charts.aspect.end()}));
  std::vector<std::uint32_t> labels;
  for (std::size_t p = 0; p < groups.ofRow.size(); ++p)
    labels.insert(labels.end(), {groups.ofRow[p], groups.barriers[p]});
  sections.push_back(integersSection("groups", labels, kGroupColumns));
  sections.push_back(
      steppedSection("exchange", encodeExchangeMeans(scene.patches, groups, exchange), kExchangeMeanStep));
  sections.push_back(
      steppedSection("exchangeRest", encodeExchangeRest(scene.patches, groups, exchange), kExchangeRestStep));
  if (surfaces.surfaces > 0 && surfaces.means.size() <= kMaxSurfaceExchangeValues)
    sections.push_back(steppedSection(std::string(kSurfaceExchange),
                                      encodeSurfaceExchange(scene.patches, surfaces), kSurfaceExchangeStep));
  return Done{};
}

void readOperator(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  if (std::none_of(std::begin(kNames), std::end(kNames),
                   [&](std::string_view name) { return in.isThere(name); }))
    return;
  LightOperator op;
  readVisibility(in, counts, scene, op.visibility);
  if (in.ok()) readCharts(in, counts, op.charts);
  if (in.ok()) readGroups(in, counts, op.groups);
  if (in.ok()) readExchange(in, scene.patches, op);
  if (in.ok()) readSurfaceExchange(in, scene, op.surfaces);
  if (in.ok()) scene.lightOperator = std::move(op);
}

}  // namespace fiatlux
