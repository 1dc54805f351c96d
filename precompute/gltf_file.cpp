// glTF 2.0 -> SourceScene: accessors of any type, node transforms, materials. The only file that includes
// tinygltf, which gets checked JSON (gltf_document.h) and virtual buffers, so that it opens nothing and
// trusts nothing new.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "precompute/gltf_document.h"
#include "precompute/image_file.h"
#include "precompute/names.h"
#include "precompute/node_transform.h"
#include "precompute/source_scene.h"

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

namespace fiatlux {
namespace {

using tinygltf::Model;

std::string inQuotes(const std::string& name) { return "'" + name + "'"; }

// --- tinygltf, with its doors shut
// -----------------------------------------------------------------------------------

/// Gives the document's JSON to tinygltf; buffers come from memory under made-up names, images stay outside.
Model parseModel(GltfDocument& document) {
  auto& json = document.json;
  json.erase("images");
  json.erase("animations");
  json.erase("cameras");
  for (std::size_t i = 0; i < document.buffers.size(); ++i)
    json["buffers"][i]["uri"] = "buffer-" + std::to_string(i);
  tinygltf::FsCallbacks files{};
  files.user_data = &document;
  files.FileExists = [](const std::string& name, void*) { return name.find("buffer-") != std::string::npos; };
  files.ExpandFilePath = [](const std::string& name, void*) { return name; };
  files.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name,
                           void* user) {
    auto& source = *static_cast<GltfDocument*>(user);
    const auto index = std::strtoul(name.c_str() + name.rfind('-') + 1, nullptr, 10);
    if (index >= source.buffers.size()) return false;
    *out = std::move(source.buffers[index]);
    out->resize(source.json["buffers"][index]["byteLength"].get<std::size_t>());
    return true;
  };
  files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };

  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(files);
  Model model;
  std::string error, warning;
  if (!loader.LoadASCIIFromString(&model, &error, &warning, text.c_str(), static_cast<unsigned>(text.size()),
                                  ""))
    throw GltfError("not understood: " + cleanText(error.substr(0, 400)) + "; export the file again");
  return model;
}

// --- accessors
// -------------------------------------------------------------------------------------------------------

double componentAt(const unsigned char* at, int type, bool normalized) {
  const auto read = [&](auto value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case 5120:
      return normalized ? std::max(read(std::int8_t{}) / 127, -1.0) : read(std::int8_t{});
    case 5121:
      return read(std::uint8_t{}) / (normalized ? 255 : 1);
    case 5122:
      return normalized ? std::max(read(std::int16_t{}) / 32767, -1.0) : read(std::int16_t{});
    case 5123:
      return read(std::uint16_t{}) / (normalized ? 65535 : 1);
    case 5125:
      return read(std::uint32_t{});
    default:
      return read(float{});
  }
}

/// All components of an accessor, element by element, sparse changes applied.
template <class T>
std::vector<T> readAccessor(const Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors[index];
  const int width = tinygltf::GetNumComponentsInType(accessor.type);
  const int bytes = tinygltf::GetComponentSizeInBytes(accessor.componentType);
  std::vector<T> values(accessor.count * width, T{0});
  const auto copy = [&](const tinygltf::BufferView& view, std::size_t offset, std::size_t element,
                        std::size_t target) {
    const std::size_t stride = view.byteStride ? view.byteStride : std::size_t(width) * bytes;
    const unsigned char* at =
        model.buffers[view.buffer].data.data() + view.byteOffset + offset + element * stride;
    for (int c = 0; c < width; ++c)
      values[target * width + c] =
          static_cast<T>(componentAt(at + c * bytes, accessor.componentType, accessor.normalized));
  };
  if (accessor.bufferView >= 0)
    for (std::size_t i = 0; i < accessor.count; ++i)
      copy(model.bufferViews[accessor.bufferView], accessor.byteOffset, i, i);
  if (!accessor.sparse.isSparse) return values;
  const auto& sparse = accessor.sparse;
  const tinygltf::BufferView& view = model.bufferViews[sparse.indices.bufferView];
  const int indexBytes = tinygltf::GetComponentSizeInBytes(sparse.indices.componentType);
  for (int i = 0; i < sparse.count; ++i) {
    const unsigned char* at = model.buffers[view.buffer].data.data() + view.byteOffset +
                              sparse.indices.byteOffset + std::size_t(i) * indexBytes;
    const double target = componentAt(at, sparse.indices.componentType, false);
    if (target >= static_cast<double>(accessor.count))
      throw GltfError("accessor " + std::to_string(index) +
                      ": a sparse index is out of range; export the file again");
    copy(model.bufferViews[sparse.values.bufferView], sparse.values.byteOffset, i,
         static_cast<std::size_t>(target));
  }
  return values;
}

template <std::size_t N>
std::vector<std::array<float, N>> readVectors(const Model& model, const tinygltf::Primitive& primitive,
                                              const std::string& name, float fill) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return {};
  const auto width =
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(model.accessors[found->second].type));
  const std::vector<float> values = readAccessor<float>(model, found->second);
  std::vector<std::array<float, N>> vectors(values.size() / width);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (std::size_t c = 0; c < N; ++c) {
      const float value = c < width ? values[i * width + c] : fill;
      vectors[i][c] = std::isfinite(value) ? value : 0;
    }
  return vectors;
}

// --- primitives
// ------------------------------------------------------------------------------------------------------

std::size_t triangleCount(const Model& model, const tinygltf::Primitive& primitive) {
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) return 0;
  const std::size_t n = model.accessors[primitive.indices >= 0 ? primitive.indices : position->second].count;
  if (primitive.mode == 4 || primitive.mode == -1) return n / 3;
  return primitive.mode >= 5 && n >= 3 ? n - 2 : 0;
}

/// A primitive in its own space, and what its skin will do to it.
struct LocalPrimitive {
  SourceMesh mesh;
  Influences influences;
};

using Vectors = std::vector<std::array<float, 3>>;

/// Adds the morph targets of an attribute by their weights (glTF 2.0, section 3.7.2.2).
void addMorphTargets(const Model& model, const tinygltf::Primitive& primitive,
                     const std::vector<double>& weights, const std::string& name, Vectors& vectors) {
  for (std::size_t t = 0; t < std::min(weights.size(), primitive.targets.size()); ++t) {
    const auto found = primitive.targets[t].find(name);
    if (weights[t] == 0 || found == primitive.targets[t].end()) continue;
    const std::vector<float> change = readAccessor<float>(model, found->second);
    for (std::size_t i = 0; i < std::min(vectors.size(), change.size() / 3); ++i)
      for (std::size_t c = 0; c < 3; ++c) vectors[i][c] += static_cast<float>(weights[t] * change[3 * i + c]);
  }
}

/// Joints and weights, all sets of four, of the vertices that were kept: target[vertex] is its new number.
Influences readInfluences(const Model& model, const tinygltf::Primitive& primitive,
                          const std::vector<std::uint32_t>& target, std::size_t kept) {
  Influences influences;
  std::vector<std::vector<std::array<float, 4>>> joints, weights;
  for (std::size_t set = 0; primitive.attributes.count("JOINTS_" + std::to_string(set)) != 0; ++set) {
    joints.push_back(readVectors<4>(model, primitive, "JOINTS_" + std::to_string(set), 0));
    weights.push_back(readVectors<4>(model, primitive, "WEIGHTS_" + std::to_string(set), 0));
    weights.back().resize(joints.back().size());
  }
  influences.perVertex = 4 * joints.size();
  influences.joints.resize(kept * influences.perVertex);
  influences.weights.resize(kept * influences.perVertex);
  for (std::size_t v = 0; v < target.size(); ++v) {
    if (target[v] == UINT32_MAX) continue;
    for (std::size_t i = 0; i < influences.perVertex; ++i) {
      const std::size_t at = target[v] * influences.perVertex + i;
      influences.joints[at] = static_cast<std::uint32_t>(joints[i / 4][v][i % 4]);
      influences.weights[at] = std::max(0.0f, weights[i / 4][v][i % 4]);
    }
  }
  return influences;
}

/// A primitive in its own space, its morph targets applied, triangulated, only with the vertices it uses.
LocalPrimitive readPrimitive(const Model& model, const tinygltf::Primitive& primitive, int texCoord,
                             const std::vector<double>& morphWeights, const std::string& place) {
  Vectors positions(model.accessors[primitive.attributes.at("POSITION")].count);
  const std::vector<float> raw = readAccessor<float>(model, primitive.attributes.at("POSITION"));
  for (std::size_t i = 0; i < raw.size(); ++i) positions[i / 3][i % 3] = raw[i];
  addMorphTargets(model, primitive, morphWeights, "POSITION", positions);
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (const float x : positions[i])
      if (!std::isfinite(x))
        throw GltfError(place + ": vertex " + std::to_string(i) +
                        " is not a number; repair the mesh in the modelling program");
  std::vector<std::uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = readAccessor<std::uint32_t>(model, primitive.indices);
  } else {
    indices.resize(positions.size());
    for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
  }
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= positions.size())
      throw GltfError(place + ": index " + std::to_string(indices[i]) + " is out of range (" +
                      std::to_string(positions.size()) + " vertices); export the file again");

  SourceMesh mesh;
  const std::size_t triangles = triangleCount(model, primitive);
  mesh.triangles.reserve(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    if (primitive.mode == 5) {  // strip: every other triangle is turned over
      mesh.triangles.push_back({indices[t], indices[t + 1 + t % 2], indices[t + 2 - t % 2]});
    } else if (primitive.mode == 6) {
      mesh.triangles.push_back({indices[t + 1], indices[t + 2], indices[0]});
    } else {
      mesh.triangles.push_back({indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]});
    }
  }
  // Keep the vertices that are used, in order of first use.
  Vectors normals = readVectors<3>(model, primitive, "NORMAL", 0);
  addMorphTargets(model, primitive, morphWeights, "NORMAL", normals);
  const auto uv = readVectors<2>(model, primitive, "TEXCOORD_" + std::to_string(texCoord), 0);
  const auto colors = readVectors<4>(model, primitive, "COLOR_0", 1);
  std::vector<std::uint32_t> target(positions.size(), UINT32_MAX);
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& v : triangle) {
      if (target[v] == UINT32_MAX) {
        target[v] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back({positions[v][0], positions[v][1], positions[v][2]});
        if (v < normals.size()) mesh.normals.push_back(normals[v]);
        if (v < uv.size()) mesh.uv.push_back(uv[v]);
        if (v < colors.size()) mesh.colors.push_back(colors[v]);
      }
      v = target[v];
    }
  mesh.material = primitive.material;
  Influences influences = readInfluences(model, primitive, target, mesh.positions.size());
  return {std::move(mesh), std::move(influences)};
}

// --- nodes
// -----------------------------------------------------------------------------------------------------------

NodeExtras readExtras(const tinygltf::Node& node, const std::string& name,
                      std::vector<std::string>& warnings) {
  NodeExtras extras;
  if (!node.extras.IsObject() || !node.extras.Has("fiatlux") || !node.extras.Get("fiatlux").IsObject())
    return extras;
  const tinygltf::Value& own = node.extras.Get("fiatlux");
  const auto wrong = [&](const char* key, const char* cure) {
    warnings.push_back("node " + inQuotes(name) + ": extras.fiatlux." + key + " is ignored; " + cure);
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
  if (own.Has("surface")) {
    if (own.Get("surface").IsString()) extras.surface = cleanName(own.Get("surface").Get<std::string>());
    if (extras.surface.empty()) wrong("surface", "write a name");
  }
  extras.mount = flag("mount");
  extras.measure = flag("measure");
  extras.siteSpacing = number("siteSpacing", 1e-3, 1e3, "write metres");
  extras.reflectance = number("reflectance", 0, 1, "write a number from 0 to 0.95");
  if (extras.reflectance && *extras.reflectance > 0.95) {
    warnings.push_back("node " + inQuotes(name) + ": reflectance " +
                       std::to_string(*extras.reflectance).substr(0, 4) + " is taken as 0.95");
    extras.reflectance = 0.95;
  }
  return extras;
}

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

/// The nodes of the default scene.
std::vector<int> nodesOfScene(const Model& model) {
  if (model.scenes.empty()) return nodesBelow(model, nodesWithoutParent(model));
  return nodesBelow(model, model.scenes[std::max(model.defaultScene, 0)].nodes);
}

/// Of all nodes: a skin's joints need not be in the scene. The file's own pose: animations do not run.
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

/// joint x inverse bind matrix of every joint.
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

// --- materials
// -------------------------------------------------------------------------------------------------------

double numberOf(const tinygltf::Value& value, double fallback) {
  return value.IsNumber() ? value.GetNumberAsDouble() : fallback;
}

void readTextureTransform(const tinygltf::ExtensionMap& extensions, SourceMaterial& material) {
  const auto found = extensions.find("KHR_texture_transform");
  if (found == extensions.end() || !found->second.IsObject()) return;
  const tinygltf::Value& value = found->second;
  const auto pair = [&](const char* key, int at) {
    if (!value.Has(key) || !value.Get(key).IsArray() || value.Get(key).ArrayLen() != 2) return;
    for (int i = 0; i < 2; ++i)
      material.uvTransform[at + i] = numberOf(value.Get(key).Get(i), material.uvTransform[at + i]);
  };
  pair("offset", 0), pair("scale", 2);
  material.uvTransform[4] = numberOf(value.Get("rotation"), 0);
  const double set = numberOf(value.Get("texCoord"), material.texCoord);
  if (set >= 0 && set < 64) material.texCoord = static_cast<int>(set);
}

std::vector<SourceMaterial> readMaterials(const Model& model, std::vector<std::string>& warnings) {
  std::vector<SourceMaterial> materials;
  for (const tinygltf::Material& from : model.materials) {
    SourceMaterial to;
    to.name = cleanName(from.name);
    if (to.name.empty()) to.name = "material " + std::to_string(materials.size());
    const auto& pbr = from.pbrMetallicRoughness;
    bool odd = false;
    for (std::size_t c = 0; c < pbr.baseColorFactor.size() && c < 4; ++c) {
      to.baseColor[c] = std::clamp(pbr.baseColorFactor[c], 0.0, 1.0);
      odd = odd || to.baseColor[c] != pbr.baseColorFactor[c];
    }
    if (odd)
      warnings.push_back("material " + inQuotes(to.name) +
                         ": its base colour lies outside 0..1 and is clamped");
    to.roughness = pbr.roughnessFactor, to.metallic = pbr.metallicFactor;
    to.doubleSided = from.doubleSided;
    to.unlit = from.extensions.count("KHR_materials_unlit") != 0;
    to.alpha = from.alphaMode == "BLEND"  ? SourceMaterial::Alpha::kBlend
               : from.alphaMode == "MASK" ? SourceMaterial::Alpha::kMask
                                          : SourceMaterial::Alpha::kOpaque;
    if (const int texture = pbr.baseColorTexture.index; texture >= 0) {
      to.image = model.textures[texture].source;
      to.texCoord = pbr.baseColorTexture.texCoord;
      readTextureTransform(pbr.baseColorTexture.extensions, to);
      if (const int sampler = model.textures[texture].sampler; sampler >= 0)
        to.wrapS = model.samplers[sampler].wrapS, to.wrapT = model.samplers[sampler].wrapT;
    }
    materials.push_back(to);
  }
  return materials;
}

std::vector<SourceImage> readImages(GltfDocument& document, std::vector<std::string>& warnings) {
  std::vector<SourceImage> images(document.images.size());
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    images[i].encoded = std::move(document.images[i].bytes);
    images[i].mimeType = document.images[i].mimeType;
    if (images[i].encoded.empty()) continue;
    std::string why;
    if (!decodeImage(images[i], why)) {
      warnings.push_back("image " + std::to_string(i) + " " + why +
                         ": its colour is taken as white times the material's factor");
      images[i] = {};
      continue;
    }
    pixels += images[i].rgba.size() / 4;
    if (pixels > std::size_t{256} << 20)
      throw GltfError("its textures exceed 256 million pixels together; make them smaller");
    images[i].mimeType = images[i].encoded[0] == 0x89 ? "image/png" : "image/jpeg";
  }
  return images;
}

// --- the scene
// -------------------------------------------------------------------------------------------------------

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

void refuseCompressed(const Model& model) {
  for (const auto& mesh : model.meshes)
    for (const auto& primitive : mesh.primitives) {
      const auto position = primitive.attributes.find("POSITION");
      if (primitive.extensions.count("KHR_draco_mesh_compression") &&
          position != primitive.attributes.end() && model.accessors[position->second].bufferView < 0)
        throw GltfError("mesh '" + cleanName(mesh.name) +
                        "' is compressed with KHR_draco_mesh_compression; export without compression");
    }
}

/// Refuses what is too many before it is read.
void checkTriangles(const Model& model, const std::vector<int>& nodes) {
  std::size_t triangles = 0;
  for (const int i : nodes)
    if (const int mesh = model.nodes[i].mesh; mesh >= 0)
      for (const auto& primitive : model.meshes[mesh].primitives)
        triangles += triangleCount(model, primitive);
  if (triangles > GltfBudget::kTriangles)
    throw GltfError(std::to_string(triangles) +
                    " triangles after instancing, and 5 million are accepted; simplify the meshes");
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

Result<SourceScene> read(const std::vector<std::uint8_t>& bytes, const std::string& name,
                         const std::string& folder, double scale) {
  const std::string file = cleanText(name);
  try {
    if (!(scale > 1e-9 && scale < 1e9))
      throw GltfError("--scale must be a positive number of metres per unit");
    GltfDocument document = readGltfDocument(bytes, folder);
    SourceScene scene;
    scene.warnings = document.warnings;
    scene.hash = document.hash;
    warnOfWhatIsIgnored(document.json, scene.warnings);
    const Model model = parseModel(document);
    refuseCompressed(model);
    scene.materials = readMaterials(model, scene.warnings);
    scene.images = readImages(document, scene.warnings);
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

}  // namespace

Result<SourceScene> readSourceScene(const std::string& path, double scale) {
  std::vector<std::uint8_t> bytes;
  try {
    bytes = readWholeFile(path);
  } catch (const std::exception& error) {
    return Error{error.what()};
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return read(bytes, path, folder.empty() ? "." : folder, scale);
}

Result<SourceScene> readSourceScene(const std::vector<std::uint8_t>& bytes, const std::string& name,
                                    double scale) {
  return read(bytes, name, "", scale);
}

}  // namespace fiatlux
