#include "precompute/gltf/nodes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/short_number.h"
#include "precompute/base/names.h"
#include "precompute/gltf/reflectance.h"

namespace fiatlux {
namespace {

constexpr double kLeastSpacing = 1e-3, kMostSpacing = 1e3;  // m, of sites
constexpr double kMostDrop = 1e3;                           // m
constexpr double kMostBorder = 1e3;                         // m

/// The nodes below `roots`, parents first, each once; without recursion.
std::vector<int> nodesBelow(const Model& model, const std::vector<int>& roots) {
  std::vector<bool> met(model.nodes.size(), false);
  std::vector<int> nodes, stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const int at = stack.back();
    stack.pop_back();
    if (met[at]) continue;
    met[at] = true;
    nodes.push_back(at);
    const auto& children = model.nodes[at].children;
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  return nodes;
}

std::vector<int> nodesWithoutParent(const Model& model) {
  std::vector<bool> child(model.nodes.size(), false);
  for (const auto& node : model.nodes)
    for (const int c : node.children) child[c] = true;
  std::vector<int> roots;
  for (std::size_t i = 0; i < child.size(); ++i)
    if (!child[i]) roots.push_back(static_cast<int>(i));
  return roots;
}

}  // namespace

NodeExtras readExtras(const tinygltf::Node& node, const std::string& name,
                      std::vector<std::string>& warnings) {
  NodeExtras extras;
  if (!node.extras.IsObject() || !node.extras.Has("fiatlux") || !node.extras.Get("fiatlux").IsObject())
    return extras;
  const tinygltf::Value& own = node.extras.Get("fiatlux");
  const auto wrong = [&](const char* key, const char* cure) {
    warnings.push_back("node '" + name + "': extras.fiatlux." + key + " is ignored; " + cure);
  };
  const auto flag = [&](const char* key) {
    if (!own.Has(key)) return false;
    if (!own.Get(key).IsBool()) return wrong(key, "write true or false"), false;
    return own.Get(key).Get<bool>();
  };
  const auto number = [&](const char* key, double least, double most,
                          const char* cure) -> std::optional<double> {
    if (!own.Has(key)) return {};
    const double value = own.Get(key).IsNumber() ? own.Get(key).GetNumberAsDouble() : NAN;
    if (!(value >= least && value <= most)) return wrong(key, cure), std::nullopt;
    return value;
  };

  // Each member by itself: what is wrong does not spoil the others.
  if (own.Has("surface")) {
    if (own.Get("surface").IsString()) extras.surface = cleanName(own.Get("surface").Get<std::string>());
    if (extras.surface.empty()) wrong("surface", "write a name");
  }
  extras.mount = flag("mount");
  extras.measure = flag("measure");
  extras.siteSpacing = number("siteSpacing", kLeastSpacing, kMostSpacing, "write metres");
  extras.siteSize = number("siteSize", kLeastSpacing, kMostSpacing, "write metres");
  extras.drop = number("drop", 0, kMostDrop, "write metres");
  extras.border = number("border", 0, kMostBorder, "write metres");
  const std::string most = shortNumber(kMostReflectance);
  extras.reflectance = number("reflectance", 0, 1, ("write a number from 0 to " + most).c_str());
  if (extras.reflectance && *extras.reflectance > kMostReflectance) {
    warnings.push_back("node '" + name + "': reflectance " +
                       std::to_string(*extras.reflectance).substr(0, 4) + " is taken as " + most);
    extras.reflectance = kMostReflectance;
  }
  return extras;
}

std::vector<int> nodesOfScene(const Model& model) {
  if (model.scenes.empty()) return nodesBelow(model, nodesWithoutParent(model));
  return nodesBelow(model, model.scenes[std::max(model.defaultScene, 0)].nodes);
}

std::vector<Matrix> worldFromNodes(const Model& model) {
  std::vector<Matrix> world(model.nodes.size(), kIdentity);
  for (const int i : nodesBelow(model, nodesWithoutParent(model))) {
    const tinygltf::Node& node = model.nodes[i];
    // note: a node is met after its parent, which has left its own transform here
    world[i] = product(world[i], parentFromNode(node.matrix, node.translation, node.rotation, node.scale));
    for (const int child : node.children) world[child] = world[i];
  }
  return world;
}

std::vector<Matrix> worldFromBind(const Model& model, int skin, const std::vector<Matrix>& worldFromNode) {
  const tinygltf::Skin& from = model.skins[skin];
  std::vector<double> inverse;
  if (from.inverseBindMatrices >= 0) inverse = readAccessor<double>(model, from.inverseBindMatrices);
  std::vector<Matrix> matrices;
  for (std::size_t j = 0; j < from.joints.size(); ++j) {
    Matrix bind = kIdentity;
    if (!inverse.empty())
      std::copy_n(inverse.begin() + static_cast<std::ptrdiff_t>(16 * j), 16, bind.begin());
    matrices.push_back(product(worldFromNode[from.joints[j]], bind));
  }
  return matrices;
}

}  // namespace fiatlux
