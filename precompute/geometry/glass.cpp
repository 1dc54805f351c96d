#include "precompute/geometry/glass.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "precompute/gltf/reflectance.h"

namespace fiatlux {
namespace {

constexpr double kNightPane = 0.1;  // reflectance

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || (c & 0x80) != 0; }
bool isCapital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

bool isGlass(std::string_view word) {
  constexpr std::array<std::string_view, 8> kWords = {"glazing", "verre",   "vitre", "vitrage",
                                                      "vidrio",  "cristal", "vetro", "vidro"};
  constexpr std::array<std::string_view, 4> kStarts = {"glast", "glassch", "glaswand", "verglas"};
  const auto starts = [&](std::string_view with) { return word.substr(0, with.size()) == with; };
  const auto ends = [&](std::string_view with) {
    return word.size() >= with.size() && word.substr(word.size() - with.size()) == with;
  };
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end() ||
         std::any_of(kStarts.begin(), kStarts.end(), starts) ||
         ((ends("glas") || ends("glass")) && !starts("fib"));
}

/// What is made beside glass, or of its threads.
bool isOther(std::string_view word) {
  constexpr std::array<std::string_view, 5> kOthers = {"frame", "rahmen", "wool", "wolle", "cadre"};
  return std::find(kOthers.begin(), kOthers.end(), word) != kOthers.end();
}

}  // namespace

bool saysGlass(const std::string& name) {
  bool says = false;
  for (std::size_t at = 0; at < name.size();) {
    std::string word;
    // A word ends where no letter follows, and where a capital follows a small letter.
    for (; at < name.size() && isLetter(name[at]); ++at) {
      if (!word.empty() && isCapital(name[at]) && !isCapital(name[at - 1])) break;
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(name[at])));
    }
    if (word.empty()) ++at;
    if (isOther(word)) return false;
    says = says || isGlass(word);
  }
  return says;
}

bool isOpaqueGlass(const SourceScene& source, const SourceMesh& mesh) {
  if (mesh.material < 0 || mesh.extras.reflectance) return false;
  const SourceMaterial& material = source.materials[static_cast<std::size_t>(mesh.material)];
  const auto& [r, g, b, a] = material.baseColor;
  return material.alpha != SourceMaterial::Alpha::kBlend && luminanceOf(r, g, b) > kNightPane &&
         saysGlass(material.name);
}

}  // namespace fiatlux
