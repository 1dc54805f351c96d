// Results that are of no use are called so, and a room is asked for what it can have.
#include "precompute/pipeline/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

/// Two patches of 2 m2, on surfaces of their own, for two sites; `light`: lx per lm, patch by patch of each.
Room twoPatches() {
  Room room;
  room.patches.count = 2;
  room.patches.area = {2, 2};
  room.patches.reflectance = {0.5f, 0.25f};
  room.patches.surface = {0, 1};
  room.surfaces.resize(2);
  room.surfaces[0].name = "floor", room.surfaces[1].name = "wall";
  room.sites.resize(2);
  return room;
}

TEST(Verdict, TheBalanceIsWhatSurfacesTakeUp) {
  Responses responses{2, 2, {0.4f, 0.2f, 0.1f, 0.3f}};
  const LightBalance balance = balanceOf(twoPatches(), responses);
  EXPECT_NEAR(balance.absorbed, 0.5 * (0.5 * 0.8 + 0.75 * 0.4) + 0.5 * (0.5 * 0.2 + 0.75 * 0.6), 1e-6);
  EXPECT_NEAR(balance.reflected, 0.5 * (0.5 * 0.8 + 0.25 * 0.4) + 0.5 * (0.5 * 0.2 + 0.25 * 0.6), 1e-6);
  EXPECT_NEAR(balance.mostLit, 0.8, 1e-6);
}

TEST(Verdict, NamesWhatIsOfNoUse) {
  const Quality good{{0.8, 0.4, 0.5}, 1e-3, 1e-3};
  EXPECT_EQ(uselessness(good), "");
  const auto with = [&](auto change) {
    Quality quality = good;
    change(quality);
    return uselessness(quality);
  };
  EXPECT_THAT(with([](Quality& q) { q.balance.absorbed = 0.01; }), HasSubstr("nearly all light is lost"));
  EXPECT_THAT(with([](Quality& q) { q.balance.mostLit = 0.03; }), HasSubstr("no surface gets more than 3 %"));
  EXPECT_THAT(with([](Quality& q) { q.balance.absorbed = 1.2; }), HasSubstr("does not close"));
  EXPECT_THAT(with([](Quality& q) { q.balance.absorbed = 1.2; }), HasSubstr("(120 % of"));
  EXPECT_THAT(with([](Quality& q) { q.balance.reflected = 0.001; }), HasSubstr("surfaces reflect 0.12 %"));
  EXPECT_THAT(with([](Quality& q) { q.residual = 0.07; }), HasSubstr("pass --refine"));
  EXPECT_THAT(with([](Quality& q) { q.error = 0.1; }), HasSubstr("off by up to 10 %"));
}

TEST(Verdict, AsksForThreeHundredLuxOrWhatCanBeHad) {
  Room room = twoPatches();
  room.sites.resize(40);
  Transport transport;
  transport.illuminance.resize(2);
  const auto askedAt = [&](double lxPerLumen) {
    for (auto& statistics : transport.illuminance) statistics.mean.assign(40, lxPerLumen);
    return openingOf(room, transport);
  };
  EXPECT_EQ(askedAt(0.02).surface, "");  // nothing lies below the sites
  room.floor = 0;
  OpeningAsk ask = askedAt(0.02);
  EXPECT_EQ(ask.surface, "floor");
  EXPECT_EQ(ask.mean, 300);
  EXPECT_EQ(ask.count, 5u);
  ask = askedAt(0.001);
  EXPECT_EQ(ask.count, 24u);
  EXPECT_EQ(ask.mean, std::floor(0.9 * 24 * 3));
  room.surfaces[1].measuring = true;
  EXPECT_EQ(askedAt(0.02).surface, "wall");
}

TEST(Verdict, AsksForTheStoreyOfItsFloorWithLuminairesApart) {
  Room room = twoPatches();
  room.floor = 0;
  room.sites.clear();
  for (int storey = 0; storey < 2; ++storey)
    for (int i = 0; i < 100; ++i)
      room.sites.push_back({{0.5 * (i % 10), 3.0 * storey, 0.5 * (i / 10)}, {0, -1, 0}, {1, 0, 0}, 0.5});
  Transport transport;
  transport.illuminance.resize(2);
  auto& mean = transport.illuminance[0].mean;
  mean.assign(200, 0);
  std::fill(mean.begin(), mean.begin() + 100, 0.01);
  OpeningAsk ask = openingOf(room, transport);
  EXPECT_EQ(ask.mean, 300);
  EXPECT_EQ(ask.count, 10u);  // those of the other storey do not count
  EXPECT_NEAR(ask.apart, 0.8 * std::sqrt(25. / 10), 0.05);

  // Along a rail so many find room only closer to each other.
  room.sites.clear();
  for (int i = 0; i < 20; ++i) room.sites.push_back({{0.5 * i, 3, 0}, {0, -1, 0}, {1, 0, 0}, 0.5});
  mean.assign(20, 0.01);
  ask = openingOf(room, transport);
  EXPECT_EQ(ask.count, 10u);
  EXPECT_EQ(ask.apart, 0);
  mean.assign(20, 0.02);
  ask = openingOf(room, transport);
  EXPECT_EQ(ask.count, 5u);
  EXPECT_GT(ask.apart, 0.5);
  EXPECT_LE(ask.apart, 1.5);
}

}  // namespace
}  // namespace fiatlux
