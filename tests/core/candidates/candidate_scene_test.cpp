// A room of candidates against the light of each of them, and its statistics against those made beforehand.
#include "core/candidates/candidate_scene.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/search/shown.h"
#include "core/transport/photometric_light.h"
#include "core/transport/surface_statistics.h"
#include "tests/core/operator_scene.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

PhotometricType spot() {
  samples::IesFile file;
  file.candela = samples::cosinePower(1000, 4);
  const std::string text = file.text();
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  return sampledType(std::make_shared<const Photometry>(*readPhotometry({bytes, text.size()})));
}

const std::vector<Candidate> kCandidates = {
    {2, 0, 0, 0, {}}, {2, 0, 1, 90, {}}, {4, 1, 2, 30, Vec3{1, 0, 1}}, {0, 0, 3, 0, Vec3{2, 0, 0.5}}};

/// In slices of three.
Result<Scene> candidateScene(const Scene& room, Quantity quantity, const std::vector<CandidateType>& types,
                             const std::vector<Candidate>& candidates) {
  Result<CandidateScene> making = CandidateScene::begin(room, types, candidates);
  if (!making) return making.error();
  while (!making->advance(3)) continue;
  return making->finish(quantity);
}

std::vector<CandidateType> typesOfSpots() { return {{spot(), 1500, 12}, {spot(), 400, 5}}; }

TEST(CandidateScene, HasTheLightOfEachCandidate) {
  const Scene room = operatorScene(12, 6);
  const auto types = typesOfSpots();
  const Result<Scene> scene = candidateScene(room, Quantity::kIlluminance, types, kCandidates);
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->sites.size(), kCandidates.size());
  const PhotometricLight light(room);
  for (std::uint32_t j = 0; j < kCandidates.size(); ++j) {
    const Candidate& candidate = kCandidates[j];
    Mounting mounting;
    mounting.turn = candidate.turn;
    mounting.aim = candidate.aim;
    const Site& site = room.sites[candidate.site];
    const CandidateType& type = types[candidate.type];
    const std::vector<PhotometricCandidate> one = {
        {candidate.site, mountedLuminaire(type.photometric, type.flux, site, mounting), type.photometric.map,
         static_cast<float>(type.flux / type.photometric.flux)}};
    const std::vector<float> column = light.total(one, light.direct(one));
    for (std::size_t p = 0; p < column.size(); ++p)
      ASSERT_NEAR(scene->responses.column(j)[p], column[p], 1e-4f * column[p] + 1e-6f) << j << ' ' << p;
    EXPECT_EQ(scene->sites[j].position.x, site.position.x);
  }
}

/// Light of another's making is the scene's, and its mean rows are those of that light.
TEST(CandidateScene, TakesLightAsItIsKnown) {
  const Scene room = operatorScene(12, 6);
  const std::size_t size = kCandidates.size() * room.responses.rows;
  Result<CandidateScene> making = CandidateScene::begin(room, typesOfSpots(), kCandidates);
  std::vector<float> dark(size, 1.0f);
  dark[1] = -1;
  EXPECT_FALSE(making->know(dark));
  EXPECT_FALSE(making->know(std::vector<float>(size - 1)));
  EXPECT_FALSE(making->know(std::vector<float>(size, std::numeric_limits<float>::quiet_NaN())));
  ASSERT_TRUE(making->know(std::vector<float>(size, 2.5f)));
  EXPECT_TRUE(making->advance(1));
  const Scene scene = making->finish(Quantity::kIlluminance);
  EXPECT_EQ(scene.responses.illuminance, std::vector<float>(size, 2.5f));
  for (const double mean : scene.illuminance[0].mean) EXPECT_NEAR(mean, 2.5, 1e-6);
}

/// What was taken is what it would have been, and nothing else is looked at.
TEST(CandidateScene, TakesWhatAnotherSceneKnows) {
  const Scene room = operatorScene(12, 6);
  const std::vector<Observer> observers = {{"west", {1, 1.2, 1}, {1, 0, 0}},
                                           {"east", {1, 1.2, 1}, {-1, 0, 0}}};
  const auto sceneOf = [&](const std::vector<Candidate>& candidates, const Scene* known,
                           const std::vector<std::uint32_t>& there) {
    Result<CandidateScene> making = CandidateScene::begin(room, typesOfSpots(), candidates);
    if (known) making->take(*known, there);
    while (!making->advance(1)) continue;
    std::vector<ObserverRows> rows = making->seenBy(observers);
    Scene scene = making->finish(Quantity::kIlluminance);
    scene.observers = std::move(rows);
    return scene;
  };
  const Scene plain = sceneOf(kCandidates, nullptr, {});
  const Scene some = sceneOf({kCandidates[3], kCandidates[1]}, nullptr, {});
  const std::vector<std::uint32_t> there = {kNone, 1, kNone, 0};
  const Scene taken = sceneOf(kCandidates, &some, there);
  EXPECT_EQ(taken.responses.illuminance, plain.responses.illuminance);
  for (std::size_t o = 0; o < observers.size(); ++o) {
    EXPECT_EQ(taken.observers[o].glare, plain.observers[o].glare);
    EXPECT_EQ(taken.observers[o].background, plain.observers[o].background);
    EXPECT_EQ(taken.observers[o].vertical, plain.observers[o].vertical);
    EXPECT_EQ(taken.observers[o].cylindrical, plain.observers[o].cylindrical);
  }
  Scene told = some;
  told.responses.illuminance[room.patches.rows()] = 7;
  told.observers[1].background[0] = 8;
  const Scene changed = sceneOf(kCandidates, &told, there);
  EXPECT_EQ(changed.responses.column(1)[0], 7);
  EXPECT_EQ(changed.observers[1].background[3], 8);
}

/// Observers of one place are looked for together, one place after the other; whoever changes is anew.
/// Under paint as well, of which the others' light is what it is without the dark ones.
TEST(CandidateScene, LeavesDarkWhatNobodyIsToTry) {
  const Scene room = operatorScene(12, 6);
  const std::vector<Observer> observers = {{"west", {1, 1.2, 1}, {1, 0, 0}}};
  const auto light = std::make_shared<const PhotometricLight>(room);
  const auto paint =
      std::make_shared<const Repaint>(room, light->exchange(), paintedReflectance(room, {{0, 0.3}}));
  for (const bool isPainted : {false, true}) {
    const auto sceneOf = [&](const std::vector<std::uint32_t>& dark) {
      Result<CandidateScene> making = CandidateScene::begin(room, typesOfSpots(), kCandidates, light);
      making->leaveDark(dark);
      while (!making->advance(1)) continue;
      if (isPainted) making = making->repainted(paint);
      while (!making->advance(1)) continue;
      std::vector<ObserverRows> rows = making->seenBy(observers);
      Scene scene = making->finish(Quantity::kIlluminance);
      scene.observers = std::move(rows);
      return scene;
    };
    const Scene lit = sceneOf({}), some = sceneOf({0, 2});
    const std::uint32_t rows = room.patches.rows();
    for (std::uint32_t j = 0; j < kCandidates.size(); ++j) {
      const bool isDark = j == 0 || j == 2;
      const std::vector<float> column(some.responses.column(j), some.responses.column(j) + rows),
          wanted(lit.responses.column(j), lit.responses.column(j) + rows);
      EXPECT_EQ(column, isDark ? std::vector<float>(rows) : wanted) << j;
      EXPECT_EQ(some.illuminance[0].mean[j], isDark ? 0 : lit.illuminance[0].mean[j]) << j;
      EXPECT_EQ(some.observers[0].background[j], isDark ? 0 : lit.observers[0].background[j]) << j;
      EXPECT_EQ(some.observers[0].glare[j], isDark ? 0 : lit.observers[0].glare[j]) << j;
      EXPECT_GT(lit.observers[0].background[j], 0) << j;
    }
  }
}

TEST(CandidateScene, LooksFromOnePlaceAtATime) {
  const Scene room = operatorScene(12, 6);
  const std::vector<Observer> observers = {{"west", {1, 1.2, 1}, {1, 0, 0}},
                                           {"east", {1, 1.2, 1}, {-1, 0, 0}},
                                           {"there", {2, 1.2, 1}, {-1, 0, 0}}};
  const auto making = [&] {
    Result<CandidateScene> scene = CandidateScene::begin(room, typesOfSpots(), kCandidates);
    while (!scene->advance(1)) continue;
    return scene;
  };
  auto whole = making(), sliced = making();
  const std::vector<ObserverRows> rows = whole->seenBy(observers);
  EXPECT_TRUE(sliced->look({}));
  EXPECT_FALSE(sliced->look({observers[2], observers[0]}));
  EXPECT_FALSE(sliced->look(observers));
  EXPECT_TRUE(sliced->look(observers));
  EXPECT_TRUE(sliced->look(observers));
  const std::vector<ObserverRows> looked = sliced->seenBy(observers);
  ASSERT_EQ(looked.size(), 3u);
  for (std::size_t o = 0; o < 3; ++o) {
    EXPECT_EQ(looked[o].observer.name, observers[o].name);
    EXPECT_EQ(looked[o].glare, rows[o].glare);
    EXPECT_EQ(looked[o].background, rows[o].background);
    EXPECT_EQ(looked[o].vertical, rows[o].vertical);
    EXPECT_EQ(looked[o].cylindrical, rows[o].cylindrical);
  }
  // Of those that another scene knows nothing is left to look for.
  Scene known = whole->finish(Quantity::kIlluminance);
  known.observers = rows;
  Result<CandidateScene> taken = CandidateScene::begin(room, typesOfSpots(), kCandidates);
  taken->take(known, {0, 1, 2, 3});
  EXPECT_TRUE(taken->advance(1));
  EXPECT_TRUE(taken->look(observers));
  EXPECT_EQ(taken->seenBy(observers)[2].background, rows[2].background);
}

class OfQuantity : public ::testing::TestWithParam<Quantity> {};

TEST_P(OfQuantity, StatisticsAreMadeWhenTheyAreAskedFor) {
  const Quantity quantity = GetParam();
  const Scene room = operatorScene(12, 6);
  const Result<Scene> scene = candidateScene(room, quantity, typesOfSpots(), kCandidates);
  ASSERT_TRUE(scene);
  Scene before = *scene;
  for (std::uint32_t s = 0; s < before.surfaces.size(); ++s) {
    before.illuminance.resize(before.surfaces.size());
    before.exitance.resize(before.surfaces.size());
    (quantity == Quantity::kExitance ? before.exitance : before.illuminance)[s] =
        responseStatistics(before.patches, before.responses, quantity, s);
  }
  for (const SurfaceSet& set : {SurfaceSet{0}, SurfaceSet{0, 1}, SurfaceSet{}}) {
    const SurfaceStatistics made = unionStatistics(*scene, quantity, set),
                            known = unionStatistics(before, quantity, set);
    const double scale = *std::max_element(known.covariance.begin(), known.covariance.end());
    for (std::size_t i = 0; i < known.mean.size(); ++i)
      EXPECT_NEAR(made.mean[i], known.mean[i], 1e-5 * known.mean[i]);
    for (std::size_t i = 0; i < known.covariance.size(); ++i)
      EXPECT_NEAR(made.covariance[i], known.covariance[i], 1e-5 * scale);
  }
}

/// What covers some of its floor counts in no reading.
TEST_P(OfQuantity, ReadingsAreThoseOfTheLightItself) {
  Scene room = operatorScene(12, 6);
  room.patches.covered.assign(room.patches.rows(), 0);
  for (std::uint32_t p = 0; p < 24; ++p) room.patches.covered[p] = 1;
  room.surfaces[0].area -= 24 * room.patches.area[0];
  const Result<Scene> scene = candidateScene(room, GetParam(), typesOfSpots(), kCandidates);
  ASSERT_TRUE(scene);
  PreparedScene prepared(*scene);
  Intentions intentions;
  intentions.quantity = GetParam();
  intentions.luminaires.count = 2;
  const Shown shown = shownOf(prepared, intentions, {{1, 2}, {1, 1}, 0.5});
  const StatisticsCheck check = checkStatistics(*scene, intentions.quantity, shown);
  EXPECT_LT(check.largestDifference, 1e-6) << check.surface;
  EXPECT_GT(shown.surfaces.back().sigma, 0);
  const std::vector<SurfaceStatistics>& leaves =
      GetParam() == Quantity::kExitance ? scene->exitance : scene->illuminance;
  const SurfaceStatistics floor = responseStatistics(scene->patches, scene->responses, GetParam(), 0);
  for (std::size_t j = 0; j < floor.mean.size(); ++j)
    EXPECT_NEAR(leaves[0].mean[j], floor.mean[j], 1e-5 * floor.mean[j]);
}

/// Each column as if the paint had been there alone; the readings follow the new reflectance.
TEST_P(OfQuantity, PaintChangesSquaresAndTypesAlike) {
  const Scene room = operatorScene(12, 6);
  const auto light = std::make_shared<const PhotometricLight>(room);
  const std::vector<SurfacePaint> wall = {{1, 0.8}};
  const auto paint = std::make_shared<const Repaint>(room, light->exchange(), paintedReflectance(room, wall));
  Result<CandidateScene> squares = CandidateScene::ofSquares(room, {4, 1}, paint);
  Result<CandidateScene> types = CandidateScene::begin(room, typesOfSpots(), kCandidates, light, paint);
  ASSERT_TRUE(squares && types);
  while (!squares->advance(1)) continue;
  while (!types->advance(3)) continue;
  Result<CandidateScene> asInTheFile = CandidateScene::begin(room, typesOfSpots(), kCandidates, light);
  while (!asInTheFile->advance(3)) continue;
  CandidateScene repainted = asInTheFile->repainted(paint);
  EXPECT_FALSE(repainted.advance(3));
  EXPECT_TRUE(repainted.advance(3));
  const Scene ofBoth = repainted.finish(GetParam());
  const Scene ofSquares = squares->finish(GetParam()), ofTypes = types->finish(GetParam());
  const Result<Scene> before = candidateScene(room, GetParam(), typesOfSpots(), kCandidates);
  const auto expectPainted = [&](const Scene& scene, std::uint32_t j, const float* column) {
    const std::vector<float> expected = paint->light({column, column + room.patches.rows()}, 1);
    for (std::size_t p = 0; p < expected.size(); ++p)
      ASSERT_NEAR(scene.responses.column(j)[p], expected[p], 1e-4f * expected[p]) << j << ' ' << p;
  };
  for (std::uint32_t j = 0; j < kCandidates.size(); ++j) {
    expectPainted(ofTypes, j, before->responses.column(j));
    expectPainted(ofBoth, j, before->responses.column(j));
  }
  expectPainted(ofSquares, 0, room.responses.column(4));
  expectPainted(ofSquares, 1, room.responses.column(1));
  EXPECT_TRUE(ofSquares.hangings.empty());
  EXPECT_NEAR(ofSquares.surfaces[1].reflectance, 0.8, 1e-6);
  EXPECT_FALSE(CandidateScene::ofSquares(room, {6}, paint));
  EXPECT_FALSE(CandidateScene::ofSquares(room, {}, paint));
  PreparedScene prepared(ofSquares);
  Intentions intentions;
  intentions.quantity = GetParam();
  intentions.luminaires.count = 2;
  const Shown shown = shownOf(prepared, intentions, {{0, 1}, {900, 300}, 0.5});
  EXPECT_LT(checkStatistics(ofSquares, intentions.quantity, shown).largestDifference, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Both, OfQuantity, ::testing::Values(Quantity::kIlluminance, Quantity::kExitance));

TEST(CandidateScene, WhatCannotBeIsSaidInOneLine) {
  const Scene room = operatorScene(12, 6);
  Scene squares = room;
  squares.lightOperator.reset();
  const auto refusal = [](const Scene& in, const std::vector<Candidate>& candidates) {
    const Result<Scene> scene = candidateScene(in, Quantity::kIlluminance, typesOfSpots(), candidates);
    return scene ? std::string() : scene.error().message;
  };
  EXPECT_NE(refusal(squares, kCandidates).find("Lambertian squares only"), std::string::npos);
  EXPECT_NE(refusal(room, {}).find("fits anywhere"), std::string::npos);
  EXPECT_NE(refusal(room, {{6, 0, 0, 0, {}}}).find("site 6"), std::string::npos);
  EXPECT_NE(refusal(room, {{0, 2, 0, 0, {}}}).find("type 2"), std::string::npos);
  EXPECT_NE(refusal(room, std::vector<Candidate>(kMaxCandidates + 1)).find("allow fewer"), std::string::npos);
  Scene fine = room;
  fine.responses.rows = kMaxCandidateLight / sizeof(float) / 2000;
  EXPECT_NE(refusal(fine, std::vector<Candidate>(2001)).find("larger patches"), std::string::npos);
}

}  // namespace
}  // namespace fiatlux
