// Changes a JSON text as a tree, so that what comes out still parses and reaches the checks behind the
// parser: values become extreme, keys vanish or come twice, subtrees move.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/random.h"

namespace fiatlux::fuzz {

using Tree = nlohmann::ordered_json;

/// Brackets that are open at once, at most: what nests deeper is left to bytewise mutation.
inline int depthOf(const std::string& text) {
  int depth = 0, deepest = 0;
  for (const char c : text) {
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    if (c == ']' || c == '}') --depth;
  }
  return deepest;
}

inline void collect(Tree& at, std::vector<Tree*>& nodes) {
  if (nodes.size() < 20000) nodes.push_back(&at);
  if (at.is_structured())
    for (Tree& child : at) collect(child, nodes);
}

/// Values that have hurt parsers before.
inline Tree extremeValue(Random& random) {
  static const std::vector<Tree> kValues = {0,
                                            1,
                                            -1,
                                            2,
                                            3,
                                            0.5,
                                            1e-30,
                                            1e9,
                                            1e30,
                                            -1e308,
                                            255,
                                            65535,
                                            2147483647,
                                            4294967292u,
                                            9007199254740993u,
                                            18446744073709551615u,
                                            true,
                                            false,
                                            nullptr,
                                            "",
                                            "all",
                                            "a\nb\u202e</script>",
                                            "../x",
                                            "http://x/y",
                                            "data:;base64,AAAA",
                                            std::string(300, 'n'),
                                            Tree::array(),
                                            Tree::object(),
                                            Tree::array({0, 0, 0}),
                                            Tree::array({1e9, -1, 0.5, 1})};
  return kValues[random.below(static_cast<std::uint32_t>(kValues.size()))];
}

inline Tree nudged(const Tree& number, Random& random) {
  const double value = number.get<double>();
  if (number.is_number_integer() && std::abs(value) < 1e9) {
    const auto whole = number.get<std::int64_t>();
    const std::int64_t choices[] = {whole + 1, whole - 1, -whole, 2 * whole, whole / 2, whole + 4};
    return choices[random.below(6)];
  }
  const double choices[] = {-value, 2 * value, value / 2, value * 1e6, value * 1e-6, value + 0.1};
  return choices[random.below(6)];
}

/// One change at a random place. `words`: keys and texts of the format.
inline void mutate(Tree& root, Random& random, const std::vector<std::string>& words) {
  std::vector<Tree*> nodes;
  collect(root, nodes);
  const auto any = [&] { return nodes[random.below(static_cast<std::uint32_t>(nodes.size()))]; };
  const auto word = [&] { return words[random.below(static_cast<std::uint32_t>(words.size()))]; };
  Tree& at = *any();
  switch (random.below(8)) {
    case 0:
      at = extremeValue(random);
      return;
    case 1:
    case 2:
      if (at.is_number()) at = nudged(at, random);
      if (at.is_string()) at = word();
      if (at.is_boolean()) at = !at.get<bool>();
      return;
    case 3:  // an element twice, or a copy of another
      if (at.is_array() && !at.empty()) at.push_back(at[random.below(static_cast<std::uint32_t>(at.size()))]);
      if (at.is_object()) at[word()] = extremeValue(random);
      return;
    case 4:
      if (at.is_array() && !at.empty()) at.erase(random.below(static_cast<std::uint32_t>(at.size())));
      if (at.is_object() && !at.empty()) {
        auto member = at.begin();
        std::advance(member, random.below(static_cast<std::uint32_t>(at.size())));
        at.erase(member);
      }
      return;
    case 5: {  // note: a copy, since the other may hold this one
      const Tree copy = *any();
      at = copy;
      return;
    }
    case 6:
      if (at.is_object()) at[word()] = Tree(*any());
      if (at.is_array()) at.push_back(Tree(*any()));
      return;
    default:
      if (at.is_array() && at.size() > 1)
        std::swap(at[random.below(static_cast<std::uint32_t>(at.size()))], at[0]);
      if (at.is_string()) at = at.get<std::string>() + "\t" + word();
  }
}

/// `text` with one to four changes; "" where it is no JSON that can be changed as a tree.
inline std::string mutated(const std::string& text, Random& random, const std::vector<std::string>& words) {
  if (depthOf(text) > 60) return "";
  Tree tree = Tree::parse(text, nullptr, false);
  if (tree.is_discarded()) return "";
  for (std::uint32_t i = 0; i <= random.below(4); ++i) mutate(tree, random, words);
  return tree.dump(-1, ' ', false, Tree::error_handler_t::replace);
}

}  // namespace fiatlux::fuzz
