// A source scene taken as far as its charts, by the steps that need no rays.
#pragma once

#include <vector>

#include "precompute/base/names.h"
#include "precompute/geometry/charts.h"
#include "precompute/geometry/faces.h"
#include "precompute/geometry/surfaces.h"
#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux::testing {

struct Charted {
  WeldedMesh mesh;
  SurfaceTree tree;
  std::vector<ChartDraft> charts;

  /// All meshes of the scene, their fronts and the backs that they have, for patches of edge `patch`.
  Charted(const SourceScene& source, double patch) {
    std::vector<std::uint32_t> meshes(source.meshes.size());
    for (std::uint32_t m = 0; m < meshes.size(); ++m) meshes[m] = m;
    mesh = weld(source, meshes);
    std::vector<Face> faces;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      faces.push_back({mesh.triangles[t].vertex, t, mesh.triangles[t].mesh, mesh.triangles[t].source, false});
    for (const Face& face : backFaces(source, mesh)) faces.push_back(face);
    UniqueNames names;
    tree = findSurfaces(source, mesh, faces, 0.01, names);
    charts = makeCharts(mesh, tree, patch, 0);
  }
};

}  // namespace fiatlux::testing
