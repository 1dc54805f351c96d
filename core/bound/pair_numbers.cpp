// Sizes first, then what has them; see pair_numbers.h.
#include "core/bound/pair_numbers.h"

#include <cmath>

namespace fiatlux {
namespace {

constexpr double kMostOfPairs = 1e7;  // numbers of a kind

/// One walk over a goal for both ways, so that they cannot differ.
template <class Ends>
void passPairGoal(PairGoal& goal, Ends& ends) {
  PairProblem& layouts = goal.layouts;
  ends.size(layouts.sites);
  ends.list(layouts.kinds);
  ends.list(layouts.forms);
  ends.list(layouts.apart);
  ends.list(goal.square);
  ends.list(goal.linear);
  for (double* number : {&layouts.count, &goal.inverseLow, &goal.inverseHigh, &goal.factor,
                         &goal.squareConstant, &goal.constant, &goal.incumbent, &goal.inverse})
    ends.number(*number);
  for (PairKind& kind : layouts.kinds) {
    ends.list(kind.sites);
    for (std::uint32_t& site : kind.sites) ends.size(site);
    for (double* number : {&kind.least, &kind.most}) ends.number(*number);
  }
  for (PairForm& form : layouts.forms) {
    ends.list(form.a);
    for (double* number : {&form.fixed, &form.inverse, &form.least, &form.most}) ends.number(*number);
    for (double& entry : form.a) ends.number(entry);
  }
  for (auto& [i, j] : layouts.apart) {
    ends.size(i);
    ends.size(j);
  }
  for (double& entry : goal.square) ends.number(entry);
  for (double& entry : goal.linear) ends.number(entry);
}

struct PairWriter {
  std::vector<double> numbers;
  void number(double& value) { numbers.push_back(value); }
  void size(std::uint32_t& value) { numbers.push_back(value); }
  template <class T>
  void list(std::vector<T>& values) {
    numbers.push_back(static_cast<double>(values.size()));
  }
};

struct PairReader {
  const std::vector<double>& numbers;
  std::size_t at = 0;
  bool fits = true;
  void number(double& value) {
    fits = fits && at < numbers.size();
    value = fits ? numbers[at++] : 0;
  }
  double count() {
    double value = 0;
    number(value);
    fits = fits && value >= 0 && value <= kMostOfPairs && value == std::floor(value);
    return fits ? value : 0;
  }
  void size(std::uint32_t& value) { value = static_cast<std::uint32_t>(count()); }
  template <class T>
  void list(std::vector<T>& values) {
    values.resize(static_cast<std::size_t>(count()));
  }
};

/// Whether all lists are as long as the number of sites says.
bool fitsTogether(const PairGoal& goal) {
  const std::size_t m = goal.layouts.sites;
  for (const PairForm& form : goal.layouts.forms)
    if (form.a.size() != m) return false;
  for (const PairKind& kind : goal.layouts.kinds)
    for (const std::uint32_t site : kind.sites)
      if (site >= m) return false;
  for (const auto& [i, j] : goal.layouts.apart)
    if (i >= j || j >= m) return false;
  return m > 0 && goal.linear.size() == m && (goal.square.empty() || goal.square.size() == m * m);
}

}  // namespace

std::vector<double> numbersOf(const PairGoal& goal) {
  PairGoal copy = goal;
  PairWriter writer;
  passPairGoal(copy, writer);
  return std::move(writer.numbers);
}

std::optional<PairGoal> pairGoalFrom(const std::vector<double>& numbers) {
  PairGoal goal;
  PairReader reader{numbers};
  passPairGoal(goal, reader);
  if (!reader.fits || reader.at != numbers.size() || !fitsTogether(goal)) return std::nullopt;
  return goal;
}

}  // namespace fiatlux
