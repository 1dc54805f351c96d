// Numbers beyond all sense on the command line: one line, status 2, nothing written, nothing hangs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/precompute/commands/command_run.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

struct Option {
  const char* name;
  std::vector<const char*> refused;  // values
};

class Options : public ::testing::Test {
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

  static void expectRefused(const std::string& command, const std::vector<Option>& options) {
    for (const Option& option : options)
      for (const char* value : option.refused) expectRefused(command, option.name, value);
  }

  static TemporaryFolder* folder_;
};
TemporaryFolder* Options::folder_ = nullptr;

const std::vector<Option> kOfARoom = {
    {"--patch", {"-1", "nan", "0", "inf", "1e-300", "wide", "0x10"}},
    {"--rays", {"0", "1e9", "-1", "99999999999999999999", "1.5"}},
    {"--scale", {"0", "inf", "nan", "-1"}},
    {"--memory", {"0", "nan", "-4"}},
    {"--threads", {"-1", "1e9"}},
    {"--site-spacing", {"0", "-0.5", "nan"}},
    {"--site-size", {"nan", "0", "inf"}},
    {"--plane", {"0", "-1", "nan"}},
    {"--plane-rim", {"-1", "inf"}},
    {"--up", {"x"}},
    {"--reflectance", {"grey", "grey=1", "=0.5", "grey=0.5x"}},
    {"--seed", {"-1", "1e3", "18446744073709551616"}},
    {"--spacing", {"0"}},  // there are no such options
    {"--size", {"nan"}},
};
const std::vector<Option> kOfPrecompute = {
    {"--refine", {"-1", "101", "nan"}},
    {"--cluster", {"0", "-2", "65"}},
};
const std::vector<Option> kOfASearch = {
    {"--seed", {"-1", "nan"}},
    {"--runs", {"0", "-1", "1e9"}},
    {"--evaluations", {"0", "-5", "inf", "5000000000"}},
};
const std::vector<Option> kOfAlpha = {
    {"--delta-alpha", {"0", "nan"}},
    {"--delta-phi", {"-1", "2"}},
    {"--iterations", {"0", "-1"}},
};

TEST_F(Options, OfARoom) {
  const std::string precompute = "precompute box.gltf -o new.flux";
  expectRefused(precompute, kOfARoom);
  expectRefused(precompute, kOfPrecompute);
  expectRefused("light box.gltf --layout layout.json --patches new.csv", kOfARoom);
}

TEST_F(Options, OfASearch) {
  const std::string alpha = "alpha box.flux --intentions wishes.json -o new.json";
  expectRefused(alpha, kOfASearch);
  expectRefused(alpha, kOfAlpha);
  expectRefused("solve box.flux --intentions wishes.json -o new.json", kOfASearch);
}

TEST_F(Options, OfTheOthers) {
  expectRefused("validate", {{"--rays", {"0"}}, {"--seed", {"-1"}}, {"--threads", {"-1"}}});
  expectRefused("experiments --scene box.flux -o new", {{"--runs", {"0"}}, {"--evaluations", {"-1"}}});
  expectRefused("evaluate box.flux --layout layout.json", {{"--patch", {"-1"}}});
}

TEST_F(Options, SensibleNumbersAreTaken) {
  const CommandRun run =
      runFiatlux(*folder_,
                 "light box.gltf --layout layout.json --patch 5e-1 --rays 16 --scale 1.0 "
                 "--up y --reflectance 'material 0=0.3' --plane 0.75 --plane-rim 0.25 --memory "
                 "0.5 --threads 1 --site-spacing 1 --seed 18446744073709551615");
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST_F(Options, AWordThatIsNoCommandIsNamedWithThoseThereAre) {
  const CommandRun run = runFiatlux(*folder_, "bound box.flux");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("there is no command \"bound\"; the commands are "));
  EXPECT_THAT(run.err, HasSubstr("precompute"));
  EXPECT_THAT(run.err, HasSubstr("solve"));
}

}  // namespace
}  // namespace fiatlux
