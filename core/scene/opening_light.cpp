// A layout is a table of numbers; its light is coded as one column of responses.
#include "core/scene/opening_light.h"

#include <cstring>
#include <set>

#include "core/scene/response_codec.h"
#include "core/scene/section_codec.h"

namespace fiatlux {
namespace {

constexpr double kBrightestFlux = 1e9, kBrightestLight = 1e12;  // lm, lx: far beyond any room's

const std::vector<ResponseReferences> kAlone = {{kNone, kNone}};

}  // namespace

std::vector<PlainSection> encodeOpening(const Patches& patches, std::uint32_t surfaces,
                                        const OpeningLight& opening) {
  const std::vector<double> steps(surfaces, kResponseStep);
  EncodedResponses light = encodeResponses({patches.rows(), 1, opening.illuminance}, patches, steps, kAlone);
  std::vector<double> rows = {opening.layout.dimming, 0};
  for (std::size_t i = 0; i < opening.layout.sites.size(); ++i)
    rows.insert(rows.end(), {static_cast<double>(opening.layout.sites[i]), opening.layout.flux[i]});
  std::vector<std::uint8_t> table(rows.size() * sizeof(double));
  std::memcpy(table.data(), rows.data(), table.size());
  std::vector<float> scales;
  for (const ResponseScale& scale : light.scales) scales.insert(scales.end(), {scale.step, scale.floor});

  std::vector<PlainSection> sections;
  sections.push_back(plainSection("openingLayout", ElementType::kFloat64, Encoding::kPlain,
                                  static_cast<std::uint32_t>(rows.size() / 2), 2, std::move(table)));
  sections.push_back(plainSection("openingScales", ElementType::kFloat32, Encoding::kFloatPlanes, surfaces, 2,
                                  encodeFloatPlanes(scales)));
  const auto bytes = static_cast<std::uint32_t>(light.blocks[0].size());
  sections.push_back(plainSection("openingLight", ElementType::kUint8, Encoding::kPredicted, bytes, 1,
                                  std::move(light.blocks[0])));
  return sections;
}

OpeningLight readOpening(CheckedSections& in, const Patches& patches, std::uint32_t surfaces,
                         std::uint32_t sites) {
  const std::vector<double> rows =
      in.doubles("openingLayout", CheckedSections::kAnyRows, 2, 0, kBrightestFlux);
  const std::vector<float> numbers =
      in.floats("openingScales", Encoding::kFloatPlanes, surfaces, 2, 0, kBrightestLight);
  const std::vector<std::uint8_t> bytes =
      in.take("openingLight", ElementType::kUint8, Encoding::kPredicted, CheckedSections::kAnyRows, 1);
  if (!in.ok()) return {};
  OpeningLight opening;
  if (rows.empty() || rows.size() / 2 - 1 > sites) in.fail("openingLayout", "it has too many luminaires");
  if (in.ok()) opening.layout.dimming = rows[0];
  std::set<double> taken;
  for (std::size_t i = 2; in.ok() && i < rows.size(); i += 2) {
    const auto site = static_cast<std::uint32_t>(rows[i]);
    if (site != rows[i] || site >= sites || !taken.insert(rows[i]).second)
      in.fail("openingLayout", "a site is not there, or there twice");
    opening.layout.sites.push_back(site);
    opening.layout.flux.push_back(rows[i + 1]);
  }
  if (bytes.size() < patches.rows() / kValuesPerByte)
    in.fail("openingLight", "it is too short for the patches");
  if (!in.ok()) return {};
  ResponseDecoder decoder(patches, surfaces, kAlone);
  const std::string fault = decoder.decode(bytes);
  if (!fault.empty()) in.fail("openingLight", fault);
  std::vector<ResponseScale> scales;
  for (std::size_t i = 0; i < numbers.size(); i += 2) scales.push_back({numbers[i], numbers[i + 1]});
  if (in.ok()) opening.illuminance = decoder.finish(scales);
  return opening;
}

}  // namespace fiatlux
