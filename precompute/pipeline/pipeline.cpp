// The method from end to end, one line per step.
#include "precompute/pipeline/pipeline.h"

#include <cassert>
#include <utility>

#include "precompute/base/error.h"
#include "precompute/geometry/build_room.h"
#include "precompute/geometry/place.h"
#include "precompute/geometry/scale_guess.h"
#include "precompute/geometry/source_changes.h"
#include "precompute/geometry/up_guess.h"
#include "precompute/light/lost_light.h"
#include "precompute/picture/display_mesh.h"
#include "precompute/pipeline/draft.h"
#include "precompute/pipeline/foreseen.h"
#include "precompute/pipeline/provenance.h"
#include "precompute/pipeline/steps.h"

namespace fiatlux {

SceneOptions consistent(SceneOptions options, const Host& host) {
  options.transport.threads = options.room.threads = host.threads;
  options.transport.progress = host.progress;
  if (options.draft) {
    options.room.coarser = draftCoarseness;
    options.transport.rays = kDraftRays;
    options.transport.draft = true;
    options.transport.exchange = false;
  }
  options.room.rays = options.transport.rays;
  options.room.paper = options.transport.paper;
  options.room.exchange = options.transport.exchange && !options.transport.paper;
  return options;
}

namespace {

constexpr double kMuchLost = 0.2;  // of the flux

/// A model in metres, y up.
struct Measured {
  SourceScene source;
  double scale = 1;                // metres per unit of the file
  bool isZUp = false;              // in the file
  std::vector<std::string> notes;  // one line where each was guessed, one where only a place of it stays
};

Measured measured(const ModelFile& model, const RoomOptions& options, const Host& host) {
  const double asked = options.scale > 0 ? options.scale : 1;
  SourceScene source = orThrow(readSourceScene(model.bytes, model.name, asked, host.resolve));
  const bool isGuess = options.up == UpAxis::kGuess;
  const bool isZUp = isGuess ? looksZUp(source, options.scale) : options.up == UpAxis::kZ;
  if (isZUp) standUpright(source);
  repaint(options.reflectances, source);
  const double guess = options.scale > 0 ? 1 : guessedScale(source);
  std::vector<std::string> notes;
  if (guess != 1) {
    scaleBy(guess, source);
    notes.push_back(noteOfScale(guess, source));
  }
  if (isZUp && isGuess) notes.insert(notes.begin(), noteOfUp(source));
  if (options.place.inside) notes.push_back(keepPlace(options.place, source));
  return {std::move(source), asked * guess, isZUp, std::move(notes)};
}

}  // namespace

OpenedRoom opened(const ModelFile& model, const RoomOptions& options, const Host& host) {
  beginStage(host.progress, "reading");
  auto [source, scale, isZUp, notes] = measured(model, options, host);
  beginStage(host.progress, "patches");
  auto [room, tracer] = orThrow(buildTracedRoom(source, options));
  room.scale = scale;
  room.isZUp = isZUp;

  // What is lost is told after where luminaires hang, and before what is found in the file; where it is much,
  // before all.
  const LostLight lost = lostLight(room, options.luminaires, tracer);
  const auto after = lost.share > kMuchLost ? 0 : static_cast<std::ptrdiff_t>(room.leading);
  room.warnings.insert(room.warnings.begin() + after, lost.warnings.begin(), lost.warnings.end());
  room.warnings.insert(room.warnings.begin(), notes.begin(), notes.end());
  if (host.warn) host.warn(room.warnings);
  return {std::move(source), std::move(room), std::move(tracer)};
}

namespace {

SceneReport reportOf(const SceneOptions& options, const Room& room, const Transport& transport) {
  SceneReport report;
  report.identity = identityOf(options, room);
  report.patches = room.patches.count;
  report.clusters = room.patches.clusterCount;
  report.sites = static_cast<std::uint32_t>(room.sites.size());
  report.surfaces = static_cast<std::uint32_t>(room.surfaces.size());
  report.lost = lostShare(room, transport);
  report.balance = balanceOf(room, transport.responses);
  report.ask = openingOf(room, transport);
  report.residuals = transport.residuals;
  return report;
}

}  // namespace

MadeScene fileOf(const std::string& name, const SourceScene& source, const Room& room, Transport&& transport,
                 const SceneOptions& options, const Host& host) {
  SceneReport report = reportOf(options, room, transport);

  beginStage(host.progress, "display mesh");
  std::vector<std::uint8_t> picture = displayMesh(source, room);

  beginStage(host.progress, "scene file");
  const std::optional<PaperTransport> paper = std::move(transport.paper);
  FormFactors factors = std::move(transport.factors);
  const Scene scene = sceneOf(room, std::move(transport), report.identity);
  if (scene.lightOperator) report.operatorErrors = orThrow(measureOperator(scene, factors));
  std::optional<OpeningLight> opening;
  if (options.opening) opening = orThrow(options.opening(scene));
  EncodedScene encoded =
      orThrow(encodeSceneFile(scene, std::move(picture), paper, opening, host.deflate, host.threads));
  report.errors = encoded.errors;
  if (!options.transport.paper)
    report.useless = uselessness({report.balance, report.residuals.empty() ? 0 : report.residuals.back(),
                                  std::max(report.errors.mean, report.errors.sigma)});
  const std::vector<StageSeconds> seconds =
      host.progress ? host.progress->seconds() : std::vector<StageSeconds>{};
  const std::string provenance =
      provenanceOf({name, source.plan, options, room, report, encoded.ranks, seconds});
  std::vector<std::uint8_t> file = orThrow(closeSceneFile(std::move(encoded), provenance, host.deflate));
  transport.factors = std::move(factors);
  std::vector<std::string> warnings = room.warnings;
  if (!report.residuals.empty() && report.residuals.back() > kSettled)
    warnings.push_back(unsettled(report.residuals.back()));
  return {std::move(file), std::move(warnings), std::move(report)};
}

namespace {

MadeScene made(const ModelFile& model, const SceneOptions& options, const Host& host) {
  const auto [source, room, tracer] = opened(model, options.room, host);
  const std::string time = noteOfTime(room, options.transport.rays, host.threads);
  if (host.warn && !time.empty())
    host.warn({time});  // note: not in the file, which is the same on any machine
  Transport transport = orThrow(computeTransport(room, tracer, options.transport));
  return fileOf(model.name, source, room, std::move(transport), options, host);
}

}  // namespace

Result<MadeScene> makeScene(const ModelFile& model, const SceneOptions& options, const Host& host) {
  assert(host.deflate && host.threads > 0);
  return atDoor([&] { return made(model, consistent(options, host), host); }, kNoMemory);
}

Result<OpenedRoom> openRoom(const ModelFile& model, const RoomOptions& options, const Host& host) {
  return atDoor([&] { return opened(model, options, host); }, kNoMemory);
}

Result<Survey> surveyModel(const ModelFile& model, const RoomOptions& options, const Host& host) {
  const auto survey = [&] {
    const auto [source, scale, isZUp, notes] = measured(model, options, host);
    Survey survey = orThrow(surveyRoom(source, options));
    survey.scale = scale;
    survey.isZUp = isZUp;
    survey.warnings.insert(survey.warnings.begin(), notes.begin(), notes.end());
    return survey;
  };
  return atDoor(survey, kNoMemory);
}

}  // namespace fiatlux
