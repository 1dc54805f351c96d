// A model's bytes and options -> the bytes of a scene file, warnings and a report: the one function that the
// command and the page's builder call. It reads and writes no file, and knows no clock and no terminal: what
// it needs from outside is lent by its host.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "precompute/base/progress.h"
#include "precompute/geometry/room_options.h"
#include "precompute/geometry/survey.h"
#include "precompute/gltf/source_scene.h"
#include "precompute/light/operator_errors.h"
#include "precompute/light/transport.h"
#include "precompute/pipeline/scene_build.h"
#include "precompute/pipeline/verdict.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// A .glb or .gltf in memory. Messages name it as it is called; the scene file keeps what follows the last
/// '/'.
struct ModelFile {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

/// One to one with the options of `fiatlux precompute`. What the room and the light share (rays, paper,
/// threads) is said by `transport` and the host.
struct SceneOptions {
  RoomOptions room;
  TransportOptions transport;
  /// Patches longer than the room's options say, and few rays (draft.h); without the exchange.
  bool draft = false;
  /// Chooses the layout and the light that the file's readers are to see first; empty: none. Changes nothing
  /// else, not even the identity.
  std::function<Result<OpeningLight>(const Scene&)> opening;
};

/// What the machine around the pipeline lends it.
struct Host {
  Deflate deflate;               // required
  Resolve resolve;               // the model's siblings; empty: a model that names others is refused
  unsigned threads = 1;          // never more are started
  Progress* progress = nullptr;  // stages as they begin, the wish to stop, and the seconds for the provenance
  std::function<void(const std::vector<std::string>&)>
      warn;  // before the work: all warnings once they are known, and how long it is; may be empty
};

/// What was made, in numbers.
struct SceneReport {
  std::string identity;  // 16 hex digits: source, options that change the light, version of the method
  std::uint32_t patches = 0, clusters = 0, sites = 0, surfaces = 0;
  double lost = 0;                // share of the rays of all surfaces, by area
  LightBalance balance;           // where the luminaires' light goes
  OpeningAsk ask;                 // what a room that nobody has described is asked for at first
  std::string useless;            // why the result is of no use, and the likely cause; "": it is
  std::vector<double> residuals;  // Transport::residuals
  FileErrors errors;
  std::vector<OperatorError> operatorErrors;  // of light that is exchanged; empty without a light operator
};

struct MadeScene {
  std::vector<std::uint8_t> file;
  std::vector<std::string> warnings;  // those that the host was told
  SceneReport report;
};

/// The same model, options and method version give the same file but for the seconds in its provenance.
/// Errors are one line with the cure; "stopped" where the host's progress said so.
Result<MadeScene> makeScene(const ModelFile& model, const SceneOptions& options, const Host& host);

/// How every run begins: a model read and cut into patches, with the rays that it loses told as warnings.
struct OpenedRoom {
  SourceScene source;
  Room room;
  RayTracer tracer;  // of the room's triangles
};
Result<OpenedRoom> openRoom(const ModelFile& model, const RoomOptions& options, const Host& host);

/// What surfaces a model has, and what they are good for; nothing is cut or cast.
Result<Survey> surveyModel(const ModelFile& model, const RoomOptions& options, const Host& host);

}  // namespace fiatlux
