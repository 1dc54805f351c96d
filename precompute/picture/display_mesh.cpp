// Cutting the room's triangles where their charts' grid lines pass, blending patches at the corners, and
// the parts that come of it.
#include "precompute/picture/display_mesh.h"

#include <algorithm>
#include <cmath>

#include "precompute/picture/display_junctions.h"
#include "precompute/picture/display_part.h"
#include "precompute/room/grid_cut.h"

namespace fiatlux {
namespace {

using nlohmann::ordered_json;

// Of a cell's edge or area, unless said otherwise.
constexpr double kSmall = 1.2;      // a triangle of at most this size carries the light well enough uncut
constexpr double kNoArea = 1e-7;    // rounding's crumbs of a cut
constexpr double kWhole = 1e-5;     // how nearly its pieces must fill a cell to be called whole
constexpr double kFlat = 1e-3;      // how far they may leave its plane
constexpr double kSameUv = 2e-4;    // of a texture's edge: the same texture coordinates
constexpr double kPlausible = 0.1;  // cosine between a face and the file's smooth normal of it

/// Attributes of the source at points of one of its triangles.
class Shader {
 public:
  Shader(const SourceScene& source, const SourceTriangle& from, const Vec3& faceNormal, bool turned)
      : mesh_(source.meshes[from.mesh]),
        v_(mesh_.triangles[from.triangle]),
        faceNormal_(faceNormal),
        turned_(turned) {
    const auto& p = mesh_.positions;
    e1_ = p[v_[1]] - p[v_[0]], e2_ = p[v_[2]] - p[v_[0]], n_ = cross(e1_, e2_);
    textured_ = mesh_.material >= 0 && source.materials[mesh_.material].image >= 0 && !mesh_.uv.empty();
  }

  Vertex at(const Vec3& p, const PatchBlend& blend) const {
    Vertex vertex;
    vertex.blend = blend;
    vertex.position = tidyPosition(p);
    const Vec3 d = p - mesh_.positions[v_[0]];
    const double nn = std::max(dot(n_, n_), 1e-300);
    const double w1 = dot(cross(d, e2_), n_) / nn, w2 = dot(cross(e1_, d), n_) / nn, w0 = 1 - w1 - w2;
    Vec3 normal = faceNormal_;
    if (!mesh_.normals.empty()) {
      const auto vec = [&](int i) {
        return Vec3{mesh_.normals[v_[i]][0], mesh_.normals[v_[i]][1], mesh_.normals[v_[i]][2]};
      };
      const Vec3 smooth = normalized((turned_ ? -1.0 : 1.0) * (w0 * vec(0) + w1 * vec(1) + w2 * vec(2)));
      if (dot(smooth, faceNormal_) > kPlausible) normal = smooth;
    }
    vertex.normal = packedNormal(normal);
    if (textured_)
      for (int c = 0; c < 2; ++c)
        vertex.uv[c] =
            tidy(w0 * mesh_.uv[v_[0]][c] + w1 * mesh_.uv[v_[1]][c] + w2 * mesh_.uv[v_[2]][c], kUvSteps);
    if (!mesh_.colors.empty())
      for (int c = 0; c < 4; ++c) {
        const double tint =
            w0 * mesh_.colors[v_[0]][c] + w1 * mesh_.colors[v_[1]][c] + w2 * mesh_.colors[v_[2]][c];
        vertex.color[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(tint, 0.0, 1.0)));
      }
    return vertex;
  }
  bool textured() const { return textured_; }
  bool colored() const { return !mesh_.colors.empty(); }

 private:
  const SourceMesh& mesh_;
  std::array<std::uint32_t, 3> v_;
  Vec3 faceNormal_, e1_, e2_, n_;
  bool turned_, textured_ = false;
};

/// A face of the room, to be drawn.
struct DrawnFace {
  std::uint32_t triangle;
  bool back;
};

/// A piece of a face in one cell, kept until it is known whether the cell is one rectangle.
struct CellPiece {
  std::uint32_t cell, face;
  std::vector<Vec3> polygon;
  double area;  // in cells
};

class Mesher {
 public:
  Mesher(const SourceScene& source, const Room& room) : source_(source), room_(room), blender_(room) {}

  Parts parts;

  /// Draws all faces of one chart.
  void addChart(std::uint32_t index, const std::vector<DrawnFace>& faces) {
    // Small triangles are drawn as they are, the others cut along the grid.
    const Chart& chart = room_.charts[index];
    pieces_.clear();
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      const std::array<std::uint32_t, 3> v = vertices(faces[f]);
      const std::array<Vec3, 3> p{room_.positions[v[0]], room_.positions[v[1]], room_.positions[v[2]]};
      if (isSmall(chart, p)) {
        const Vec3 normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
        const Shader shader = shaderOf(faces[f], normal);
        Part& part = partOf(chart, faces[f], shader);
        const auto at = [&](int i) { return shader.at(p[i], blender_.atVertex(v[i], index, normal)); };
        part.triangle(at(0), at(1), at(2), index);
        continue;
      }
      cut_.cut(chart, p, [&](std::uint32_t cell, const std::vector<GridCorner>& polygon) {
        CellPiece piece{cell, f, {}, 0};
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          piece.polygon.push_back(polygon[i].position);
          const GridCorner& a = polygon[i];
          const GridCorner& b = polygon[(i + 1) % polygon.size()];
          piece.area += 0.5 * (a.u * b.v - a.v * b.u);
        }
        if (piece.area > kNoArea) pieces_.push_back(std::move(piece));
      });
    }

    // Cell by cell: a rectangle where the pieces agree, else the pieces.
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const CellPiece& a, const CellPiece& b) { return a.cell < b.cell; });
    for (std::size_t i = 0, j; i < pieces_.size(); i = j) {
      double area = 0;
      for (j = i; j < pieces_.size() && pieces_[j].cell == pieces_[i].cell; ++j) area += pieces_[j].area;
      if (std::abs(area - 1) > kWhole || !drawRectangle(index, faces, i, j)) drawPieces(index, faces, i, j);
    }
  }

 private:
  std::array<std::uint32_t, 3> vertices(const DrawnFace& face) const {
    auto v = room_.triangles[face.triangle].vertex;
    if (face.back) std::swap(v[1], v[2]);
    return v;
  }

  Shader shaderOf(const DrawnFace& face, const Vec3& normal) const {
    const RoomTriangle& triangle = room_.triangles[face.triangle];
    const SourceTriangle& from = face.back ? triangle.backSource : triangle.source;
    // Turned over when the side drawn is not the side the source drew.
    const SourceMesh& mesh = source_.meshes[from.mesh];
    const auto& v = mesh.triangles[from.triangle];
    const Vec3 drawn =
        cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]);
    return {source_, from, normal, dot(drawn, normal) < 0};
  }

  Part& partOf(const Chart& chart, const DrawnFace& face, const Shader& shader) {
    const RoomTriangle& triangle = room_.triangles[face.triangle];
    Part& part = parts[{chart.surface,
                        source_.meshes[(face.back ? triangle.backSource : triangle.source).mesh].material}];
    part.textured = part.textured || shader.textured();
    part.colored = part.colored || shader.colored();
    return part;
  }

  /// A triangle about as small as a cell carries the light well enough uncut.
  static bool isSmall(const Chart& chart, const std::array<Vec3, 3>& p) {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    for (const Vec3& point : p) {
      const GridCorner c = gridCorner(chart, point);
      low[0] = std::min(low[0], c.u), high[0] = std::max(high[0], c.u);
      low[1] = std::min(low[1], c.v), high[1] = std::max(high[1], c.v);
    }
    return high[0] - low[0] < kSmall && high[1] - low[1] < kSmall;
  }

  /// A cell that is covered wholly by triangles that agree on material and texture coordinates: two
  /// triangles.
  bool drawRectangle(std::uint32_t index, const std::vector<DrawnFace>& faces, std::size_t begin,
                     std::size_t end) {
    const Chart& chart = room_.charts[index];
    const std::uint32_t r = pieces_[begin].cell / chart.columns, c = pieces_[begin].cell % chart.columns;
    std::array<Vertex, 4> corners;
    Part* part = nullptr;
    for (std::size_t i = begin; i < end; ++i) {
      const DrawnFace& face = faces[pieces_[i].face];
      const Shader shader = shaderOf(face, chart.normal);
      Part& own = partOf(chart, face, shader);
      if (part && part != &own) return false;
      for (const Vec3& p : pieces_[i].polygon)
        if (std::abs(dot(p - chart.origin, chart.normal)) > kFlat * std::min(chart.cellU, chart.cellV))
          return false;
      for (int k = 0; k < 4; ++k) {
        const Vec3 p = chart.origin + (c + (k == 1 || k == 2)) * chart.cellU * chart.uAxis +
                       (r + (k >= 2)) * chart.cellV * chart.vAxis;
        const Vertex vertex = shader.at(p, part ? corners[k].blend : blender_.inChart(index, p));
        if (!part) {
          corners[k] = vertex;
        } else if (std::abs(vertex.uv[0] - corners[k].uv[0]) > kSameUv ||
                   std::abs(vertex.uv[1] - corners[k].uv[1]) > kSameUv ||
                   vertex.normal != corners[k].normal || vertex.color != corners[k].color) {
          return false;
        }
      }
      part = &own;
    }
    // note: this order of corners repeats pairs of the cell before, which compresses best
    part->triangle(corners[3], corners[0], corners[2], index);
    part->triangle(corners[1], corners[2], corners[0], index);
    return true;
  }

  void drawPieces(std::uint32_t index, const std::vector<DrawnFace>& faces, std::size_t begin,
                  std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const DrawnFace& face = faces[pieces_[i].face];
      const auto v = vertices(face);
      const Vec3 normal = normalized(cross(room_.positions[v[1]] - room_.positions[v[0]],
                                           room_.positions[v[2]] - room_.positions[v[0]]));
      const Shader shader = shaderOf(face, normal);
      Part& part = partOf(room_.charts[index], face, shader);
      const auto& polygon = pieces_[i].polygon;
      const auto vertexAt = [&](const Vec3& p) {
        for (const std::uint32_t corner : v)
          if (length(room_.positions[corner] - p) == 0)
            return shader.at(p, blender_.atVertex(corner, index, normal));
        return shader.at(p, blender_.inChart(index, p));
      };
      for (std::size_t k = 2; k < polygon.size(); ++k)
        part.triangle(vertexAt(polygon[0]), vertexAt(polygon[k - 1]), vertexAt(polygon[k]), index);
    }
  }

  const SourceScene& source_;
  const Room& room_;
  PatchBlender blender_;
  GridCut cut_;
  std::vector<CellPiece> pieces_;
};

/// Measuring planes have no triangles in the room: their patches' pieces are drawn.
void addReceivers(const Room& room, const PatchBlender& blender, Parts& parts) {
  for (std::uint32_t p = room.patches.count; p < room.patches.rows(); ++p)
    for (const Fragment& fragment : room.fragmentsOf(p)) {
      const std::uint32_t chart = room.chartOfPatch[p];
      const auto at = [&](const Vec3& corner) {
        Vertex vertex;
        vertex.position = tidyPosition(corner);
        vertex.normal = packedNormal(room.patches.normal[p]);
        vertex.blend = blender.inChart(chart, corner);
        return vertex;
      };
      const auto& corner = fragment.corner;
      parts[{room.patches.surface[p], -1}].triangle(at(corner[0]), at(corner[1]), at(corner[2]), chart);
    }
}

/// Glass and the like: shown, not lit.
void addUnlit(const SourceScene& source, std::uint32_t m, Part& part) {
  const SourceMesh& mesh = source.meshes[m];
  part.lit = false;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const Vec3 normal = normalized(
        cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]));
    const Shader shader(source, {m, t}, normal, false);
    part.textured = shader.textured(), part.colored = shader.colored();
    const auto at = [&](int i) { return shader.at(mesh.positions[v[i]], {}); };
    part.triangle(at(0), at(1), at(2), kNone);
  }
}

}  // namespace

std::vector<std::uint8_t> displayMesh(const SourceScene& source, const Room& room) {
  // What is lit: the faces of every chart, measuring planes, and no cracks between them.
  Mesher mesher(source, room);
  std::vector<std::vector<DrawnFace>> facesOfChart(room.charts.size());
  for (std::uint32_t t = 0; t < room.triangles.size(); ++t) {
    if (room.triangles[t].chart != kNone) facesOfChart[room.triangles[t].chart].push_back({t, false});
    if (room.triangles[t].backChart != kNone) facesOfChart[room.triangles[t].backChart].push_back({t, true});
  }
  for (std::uint32_t c = 0; c < room.charts.size(); ++c) mesher.addChart(c, facesOfChart[c]);
  const PatchBlender blender(room);
  addReceivers(room, blender, mesher.parts);
  closeJunctions(blender, mesher.parts);

  GlbWriter glb;
  glb.json["scene"] = 0;
  glb.json["scenes"] = ordered_json::array({{{"nodes", ordered_json::array()}}});
  packMaterials(glb, source);
  for (const auto& [key, part] : mesher.parts) {
    const auto [surface, material] = key;
    ordered_json extras = {{"surface", room.surfaces[surface].name}, {"surfaceIndex", surface}};
    if (room.surfaces[surface].measuring) extras["measuring"] = true;
    packPart(glb, part, material, room.patches.rows(), room.surfaces[surface].name, std::move(extras));
  }

  // What is shown only.
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    if (mesh.extras.measure || mesh.material < 0 ||
        source.materials[mesh.material].alpha != SourceMaterial::Alpha::kBlend)
      continue;
    Part part;
    addUnlit(source, m, part);
    packPart(glb, part, mesh.material, room.patches.rows(), mesh.node, {{"lit", false}});
  }
  return glb.bytes();
}

}  // namespace fiatlux
