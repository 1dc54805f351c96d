// glTF 2.0 -> SourceScene: the default scene flattened, each mesh read once and copied to the nodes that show
// it.
#include "precompute/gltf/source_scene.h"

#include <algorithm>
#include <new>

#include "precompute/base/json_text.h"
#include "precompute/base/names.h"
#include "precompute/gltf/materials.h"
#include "precompute/gltf/nodes.h"
#include "precompute/gltf/primitive.h"
#include "precompute/gltf/refusal.h"

namespace fiatlux {
namespace {

void warnOfWhatIsIgnored(const nlohmann::json& json, std::vector<std::string>& warnings) {
  const auto any = [&](const char* list, const char* key) {
    if (json.contains(list))
      for (const auto& entry : json[list])
        if (entry.contains(key)) return true;
    return false;
  };
  if (json.contains("animations") && !json["animations"].empty())
    warnings.push_back("the file is animated: its rest pose is used");
  if (any("nodes", "skin"))
    warnings.push_back(
        "the file holds skinned meshes: they stand as the rest pose of their joints bends them");
  bool shines = json.contains("extensions") && json["extensions"].is_object() &&
                json["extensions"].contains("KHR_lights_punctual");
  if (json.contains("materials"))
    for (const auto& material : json["materials"])
      if (material.contains("emissiveFactor"))
        for (const auto& factor : material["emissiveFactor"]) shines = shines || factor.get<double>() > 0;
  if (shines)
    warnings.push_back(
        "lights and emissive materials of the file do not shine: only the luminaires that are placed do");
}

/// `extras.fiatlux.plan` of the default scene: carried along, not understood here. Too long ones are left.
std::string planIn(const nlohmann::json& json) {
  constexpr std::size_t kLongest = 1 << 16;  // bytes
  const std::size_t index = json.value("scene", std::size_t{0});
  if (!json.contains("scenes") || index >= json["scenes"].size()) return {};
  const nlohmann::json& scene = json["scenes"][index];
  const nlohmann::json::json_pointer at("/extras/fiatlux/plan");
  if (!scene.contains(at) || !scene[at].is_array()) return {};
  std::string text = jsonText(scene[at], -1);
  return text.size() > kLongest ? std::string() : text;
}

/// Triangles of one mesh wherever it is shown.
struct Shown {
  std::size_t each = 0, times = 0;
  int first = -1;  // node
};

/// Refuses what is too many before it is read.
void checkTriangles(const Model& model, const std::vector<int>& nodes) {
  std::vector<Shown> meshes(model.meshes.size());
  std::size_t triangles = 0;
  for (const int i : nodes)
    if (const int mesh = model.nodes[i].mesh; mesh >= 0) {
      Shown& shown = meshes[mesh];
      if (shown.times++ == 0) {
        shown.first = i;
        for (const auto& primitive : model.meshes[mesh].primitives)
          shown.each += triangleCount(model, primitive);
      }
      triangles += shown.each;
    }
  if (triangles > GltfBudget::kTriangles) {
    const auto most = std::max_element(meshes.begin(), meshes.end(), [](const Shown& a, const Shown& b) {
      return a.each * a.times < b.each * b.times;
    });
    throw GltfError(std::to_string(triangles) + " triangles after instancing, most of them in node " +
                    std::to_string(most->first) + " '" + cleanName(model.nodes[most->first].name) + "' (" +
                    std::to_string(most->each) + ", " + std::to_string(most->times) + " times), and " +
                    std::to_string(GltfBudget::kTriangles / 1'000'000) +
                    " million are accepted; simplify the meshes");
  }
  if (triangles == 0)
    throw GltfError("no surfaces: it holds no triangles; export meshes, not points or lines");
}

std::vector<LocalPrimitive> readMesh(const Model& model, int index, const std::vector<double>& morphWeights,
                                     const std::vector<SourceMaterial>& materials) {
  std::vector<LocalPrimitive> primitives;
  for (const auto& primitive : model.meshes[index].primitives) {
    if (triangleCount(model, primitive) == 0) continue;
    const int texCoord = primitive.material >= 0 ? materials[primitive.material].texCoord : 0;
    primitives.push_back(
        readPrimitive(model, primitive, texCoord, morphWeights, "mesh " + std::to_string(index)));
  }
  return primitives;
}

void flatten(const Model& model, double scale, SourceScene& scene) {
  const std::vector<int> nodes = nodesOfScene(model);
  checkTriangles(model, nodes);
  const std::vector<Matrix> worldFromNode = worldFromNodes(model);
  // Read each mesh once; copy it to each node that shows it. A node may have morph weights of its own.
  std::vector<std::vector<LocalPrimitive>> shared(model.meshes.size());
  std::vector<LocalPrimitive> own;
  for (const int index : nodes) {
    const tinygltf::Node& node = model.nodes[index];
    if (node.mesh < 0) continue;
    const bool isOwn = !node.weights.empty();
    auto& primitives = isOwn ? own : shared[node.mesh];
    if (isOwn || primitives.empty())
      primitives =
          readMesh(model, node.mesh, isOwn ? node.weights : model.meshes[node.mesh].weights, scene.materials);
    std::string name = cleanName(node.name);
    if (name.empty()) name = "node " + std::to_string(index);
    const NodeExtras extras = readExtras(node, name, scene.warnings);
    std::vector<Matrix> joints;
    if (node.skin >= 0) joints = worldFromBind(model, node.skin, worldFromNode);
    for (const LocalPrimitive& primitive : primitives) {
      SourceMesh mesh = primitive.mesh;
      mesh.node = name;
      mesh.nodeIndex = static_cast<std::uint32_t>(index);
      mesh.extras = extras;
      if (node.skin >= 0 && primitive.influences.perVertex > 0)
        moveToJoints(mesh, primitive.influences, joints, scale);
      else
        moveToWorld(mesh, worldFromNode[index], scale);
      scene.meshes.push_back(std::move(mesh));
    }
  }
}

}  // namespace

Result<SourceScene> readSourceScene(const std::vector<std::uint8_t>& bytes, const std::string& name,
                                    double scale, const Resolve& resolve) {
  const std::string file = cleanText(name);
  try {
    if (!(scale > 1e-9 && scale < 1e9))
      throw GltfError("--scale must be a positive number of metres per unit");
    GltfDocument document = readGltfDocument(bytes, resolve);
    SourceScene scene;
    scene.warnings = document.warnings;
    scene.hash = document.hash;
    scene.plan = planIn(document.json);
    warnOfWhatIsIgnored(document.json, scene.warnings);
    const Model model = parseModel(document);
    scene.materials = readMaterials(model, scene.warnings);
    scene.images = readImages(document, scene.materials, scene.warnings);
    flatten(model, scale, scene);
    return scene;
  } catch (const GltfError& error) {
    return Error{file + ": " + error.what()};
  } catch (const std::bad_alloc&) {
    return Error{file + ": needs more memory than there is; make the model smaller"};
  } catch (const std::exception& error) {
    return Error{file + ": not understood (" + cleanText(error.what()) + "); export the file again"};
  }
}

}  // namespace fiatlux
