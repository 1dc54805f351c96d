// What is asked of luminaires of photometric files, where their candidates cannot answer it.
#include "precompute/files/asked_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/core/operator_scene.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

/// One type, of a square opening of so many metres.
std::string refusalOfOpening(double edge, bool isSeen) {
  samples::IesFile file;
  file.width = file.length = edge;
  IntentionsFile asked;
  asked.intentions.luminaires.count = 1;
  asked.intentions.luminaires.types = {{}};
  asked.intentions.goals = {{Statistic::kMean, Sense::kMaximize, 1, {0}, {}}};
  if (isSeen) asked.intentions.observers = {{"me", {1, 1.2, 1}, {1, 0, 0}}};
  AskedType type;
  type.name = "point.ies";
  type.photometry = std::make_shared<const Photometry>(samples::read(file.text()).value());
  asked.types = {type};
  Scene room = operatorScene(12, 3);
  const Result<AskedSearch> search = AskedSearch::make(room, std::move(asked));
  return search ? "" : search.error().message;
}

TEST(AskedSearch, OfALuminaireWithoutAreaNobodyCanSayHowItGlares) {
  EXPECT_EQ(refusalOfOpening(0, false), "");
  EXPECT_EQ(refusalOfOpening(0.1, true), "");
  EXPECT_THAT(
      refusalOfOpening(0, true),
      ::testing::StartsWith("luminaires.types[0]: point.ies has no luminous area, so nobody can say"));
}

}  // namespace
}  // namespace fiatlux
