// Numbers beyond all sense on the command line: one line, status 2, nothing written, nothing hangs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/precompute/command_run.h"

namespace fiatlux {
namespace {

using testing::HasSubstr;

class Options : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    writeBoxRoom(*folder_, "box");
    writeTextFile(*folder_ / "layout.json", R"({"luminaires": [{"site": 4, "flux": 1000}]})");
    writeTextFile(*folder_ / "wishes.json",
                  R"({"luminaires": {"count": 2, "flux": 1000},
                      "goals": [{"surface": "floor", "statistic": "mean", "sense": "max"}],
                      "constraints": [{"surface": "floor", "statistic": "minimum", "min": 1}]})");
    ASSERT_EQ(runFiatlux(*folder_, "precompute box.gltf -o box.flux --patch 0.5 --rays 64").status, 0);
  }
  static void TearDownTestSuite() { delete folder_; }

  static void expectRefused(const std::string& command, const std::string& option, const std::string& value) {
    const std::size_t files = folder_->files();
    const CommandRun run = runFiatlux(*folder_, command + " " + option + " " + value);
    const std::string said = command + " " + option + " " + value + ": " + run.err;
    EXPECT_EQ(run.status, 2) << said;
    EXPECT_EQ(run.out, "") << said;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << said;
    EXPECT_THAT(run.err, HasSubstr(option)) << said;
    EXPECT_THAT(run.err, HasSubstr(value)) << said;
    EXPECT_EQ(folder_->files(), files) << said;
  }

  static TemporaryFolder* folder_;
};
TemporaryFolder* Options::folder_ = nullptr;

struct Case {
  const char *option, *value;
};

TEST_F(Options, OfARoom) {
  for (const char* command :
       {"precompute box.gltf -o new.flux", "light box.gltf --layout layout.json --patches new.csv"})
    for (const Case& c : std::initializer_list<Case>{{"--patch", "-1"},
                                                     {"--patch", "nan"},
                                                     {"--patch", "0"},
                                                     {"--patch", "inf"},
                                                     {"--patch", "1e-300"},
                                                     {"--patch", "wide"},
                                                     {"--patch", "0x10"},
                                                     {"--rays", "0"},
                                                     {"--rays", "1e9"},
                                                     {"--rays", "-1"},
                                                     {"--rays", "99999999999999999999"},
                                                     {"--rays", "1.5"},
                                                     {"--scale", "0"},
                                                     {"--scale", "inf"},
                                                     {"--scale", "nan"},
                                                     {"--scale", "-1"},
                                                     {"--memory", "0"},
                                                     {"--memory", "nan"},
                                                     {"--memory", "-4"},
                                                     {"--threads", "-1"},
                                                     {"--threads", "1e9"},
                                                     {"--site-spacing", "0"},
                                                     {"--site-spacing", "-0.5"},
                                                     {"--site-spacing", "nan"},
                                                     {"--site-size", "nan"},
                                                     {"--site-size", "0"},
                                                     {"--site-size", "inf"},
                                                     {"--seed", "-1"},
                                                     {"--seed", "1e3"},
                                                     {"--seed", "18446744073709551616"},
                                                     {"--spacing", "0"},
                                                     {"--size", "nan"}})
      expectRefused(command, c.option, c.value);
  for (const Case& c : std::initializer_list<Case>{{"--refine", "-1"},
                                                   {"--refine", "101"},
                                                   {"--refine", "nan"},
                                                   {"--cluster", "0"},
                                                   {"--cluster", "-2"},
                                                   {"--cluster", "65"}})
    expectRefused("precompute box.gltf -o new.flux", c.option, c.value);
}

TEST_F(Options, OfASearch) {
  for (const char* command : {"solve box.flux --intentions wishes.json -o new.json",
                              "alpha box.flux --intentions wishes.json -o new.json"})
    for (const Case& c : std::initializer_list<Case>{{"--seed", "-1"},
                                                     {"--seed", "nan"},
                                                     {"--runs", "0"},
                                                     {"--runs", "-1"},
                                                     {"--runs", "1e9"},
                                                     {"--evaluations", "0"},
                                                     {"--evaluations", "-5"},
                                                     {"--evaluations", "inf"},
                                                     {"--evaluations", "5000000000"}})
      expectRefused(command, c.option, c.value);
  for (const Case& c : std::initializer_list<Case>{{"--delta-alpha", "0"},
                                                   {"--delta-alpha", "nan"},
                                                   {"--delta-phi", "-1"},
                                                   {"--delta-phi", "2"},
                                                   {"--iterations", "0"},
                                                   {"--iterations", "-1"}})
    expectRefused("alpha box.flux --intentions wishes.json -o new.json", c.option, c.value);
}

TEST_F(Options, OfTheOthers) {
  for (const Case& c : std::initializer_list<Case>{{"--rays", "0"}, {"--seed", "-1"}, {"--threads", "-1"}})
    expectRefused("validate", c.option, c.value);
  for (const Case& c : std::initializer_list<Case>{{"--runs", "0"}, {"--evaluations", "-1"}})
    expectRefused("experiments --scene box.flux -o new", c.option, c.value);
  expectRefused("evaluate box.flux --layout layout.json", "--patch", "-1");
}

TEST_F(Options, SensibleNumbersAreTaken) {
  const CommandRun run = runFiatlux(*folder_,
                                    "light box.gltf --layout layout.json --patch 5e-1 --rays 16 --scale 1.0 "
                                    "--memory 0.5 --threads 1 --site-spacing 1 --seed 18446744073709551615");
  EXPECT_EQ(run.status, 0) << run.err;
}

}  // namespace
}  // namespace fiatlux
