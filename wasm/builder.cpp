// The page's second module: the pipeline that makes scene files, bound as one class for the workers of
// web/builder. Conversions only; every decision is in precompute/pipeline. The TypeScript face with shapes
// and units is web/builder/builder.ts. Arrays are copied in and come back as fresh copies; an error comes
// back as one line.
#include <emscripten/bind.h>
#include <emscripten/heap.h>
#include <emscripten/val.h>

#include <optional>

#include "core/transport/mounted_luminaire.h"
#include "precompute/pipeline/draft.h"
#include "precompute/pipeline/foreseen.h"
#include "precompute/pipeline/scene_parts.h"

namespace fiatlux {
namespace {

using emscripten::val;

val copied(std::span<const std::uint8_t> bytes) {
  return val(emscripten::typed_memory_view(bytes.size(), bytes.data())).call<val>("slice");
}

std::vector<std::uint8_t> bytesOf(const val& array) {
  return emscripten::convertJSArrayToNumberVector<std::uint8_t>(array);
}

std::vector<std::string> namesOf(const val& list) {
  std::vector<std::string> names;
  for (unsigned i = 0, count = list["length"].as<unsigned>(); i < count; ++i)
    names.push_back(list[i].as<std::string>());
  return names;
}

SceneOptions optionsOf(const val& asked) {
  SceneOptions options;
  options.room.patch = asked["patch"].as<double>();
  options.room.scale = asked["scale"].as<double>();
  options.room.siteSpacing = asked["siteSpacing"].as<double>();
  options.room.siteSize = asked["siteSize"].as<double>();
  options.room.ceiling = asked["ceiling"].as<double>();
  options.room.drop = asked["drop"].as<double>();
  options.room.plane = asked["plane"].as<double>();
  options.room.planeRim = asked["planeRim"].as<double>();
  const std::string up = asked["up"].as<std::string>();
  options.room.up = up == "z" ? UpAxis::kZ : up == "y" ? UpAxis::kY : UpAxis::kGuess;
  const val reflectances = asked["reflectances"];
  for (unsigned i = 0, count = reflectances["length"].as<unsigned>(); i < count; ++i)
    options.room.reflectances.push_back(
        {reflectances[i][0].as<std::string>(), reflectances[i][1].as<double>()});
  if (const std::vector<double> at = emscripten::vecFromJSArray<double>(asked["inside"]); at.size() == 3)
    options.room.place.inside = Vec3{at[0], at[1], at[2]};
  options.room.place.doors = asked["doors"].as<std::uint32_t>();
  options.room.place.lid = static_cast<PlaceOptions::Lid>(asked["lid"].as<int>());
  options.room.doubleSided = asked["doubleSided"].as<bool>();
  options.room.memory = asked["memory"].as<double>();
  options.room.mounts = namesOf(asked["mounts"]);
  options.transport.rays = asked["rays"].as<std::uint32_t>();
  options.transport.seed = asked["seed"].as<std::uint32_t>();
  options.transport.exchange = asked["exchange"].as<bool>();
  options.draft = asked["draft"].as<bool>();
  return options;
}

/// What the page lends: deflate(bytes) -> zlib bytes, sibling(name) -> bytes or undefined, tell(stage,
/// share).
class Page : public Progress {
 public:
  explicit Page(val lent) : lent_(std::move(lent)) {}

  void begin(const std::string& stage) override {
    stage_ = stage;
    tell(0);
  }
  void update(double fraction) override { tell(fraction); }

  Host host() {
    Host host;
    host.progress = this;
    host.deflate = [this](std::span<const std::uint8_t> bytes, DeflateKind kind) {
      // note: fflate has no Huffman-only mode; what looks like a bomb is stored as it is.
      if (kind == DeflateKind::kHuffman) return std::vector<std::uint8_t>();
      return bytesOf(lent_.call<val>("deflate", copied(bytes)));
    };
    host.resolve = [this](const std::string& name) -> Result<std::optional<std::vector<std::uint8_t>>> {
      const val bytes = lent_.call<val>("sibling", name);
      if (bytes.isUndefined()) return std::optional<std::vector<std::uint8_t>>();
      return std::optional(bytesOf(bytes));
    };
    return host;
  }

 private:
  void tell(double share) { lent_.call<void>("tell", stage_, share); }

  val lent_;
  std::string stage_;
};

val answer(const Result<std::vector<std::uint8_t>>& part) {
  return part ? copied(*part) : val(part.error().message);
}

val answer(const Result<Done>& done) { return val(done ? std::string() : done.error().message); }

val answer(const Result<std::uint32_t>& count) { return count ? val(*count) : val(count.error().message); }

val listOf(const std::vector<std::string>& lines) {
  val list = val::array();
  for (std::size_t i = 0; i < lines.size(); ++i) list.set(i, lines[i]);
  return list;
}

val listOf(const std::vector<SurveyedSurface>& surfaces) {
  val list = val::array();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    val surface = val::object();
    surface.set("name", surfaces[i].name);
    surface.set("area", surfaces[i].area);
    surface.set("high", surfaces[i].high);
    surface.set("facing", static_cast<int>(surfaces[i].facing));
    surface.set("use", static_cast<int>(surfaces[i].use));
    list.set(i, surface);
  }
  return list;
}

/// `hung`: seven numbers a luminaire: site, index of its photometric file, flux (lm), turn (degrees), and the
/// point that it is aimed at, NaN for none.
constexpr std::size_t kNumbers = 7;
Result<std::vector<Luminaire>> luminairesOf(const val& files, const val& hung,
                                            const std::vector<Site>& sites) {
  std::vector<PhotometricType> types;
  for (unsigned i = 0, count = files["length"].as<unsigned>(); i < count; ++i) {
    Result<Photometry> photometry = readPhotometry(bytesOf(files[i]));
    if (!photometry) return photometry.error();
    types.push_back(exactType(std::make_shared<const Photometry>(std::move(*photometry))));
  }
  const std::vector<double> numbers = emscripten::convertJSArrayToNumberVector<double>(hung);
  std::vector<Luminaire> luminaires;
  for (std::size_t i = 0; i + kNumbers <= numbers.size(); i += kNumbers) {
    const double* n = &numbers[i];
    const auto site = static_cast<std::size_t>(n[0]), type = static_cast<std::size_t>(n[1]);
    if (!(n[0] >= 0 && n[1] >= 0) || site >= sites.size() || type >= types.size())
      return Error{"a luminaire hangs on a site that this room does not have"};
    Mounting mounting;
    mounting.turn = n[3];
    if (n[4] == n[4]) mounting.aim = Vec3{n[4], n[5], n[6]};
    luminaires.push_back(mountedLuminaire(types[type], n[2], sites[site], mounting));
  }
  return luminaires;
}

constexpr const char* kNoMemory = "not enough memory in this browser; choose coarser patches";

/// Nothing that is thrown leaves the module.
template <class Work>
val guarded(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return val(std::string(kNoMemory));
  } catch (const std::exception& error) {
    return val(std::string("the room could not be computed (") + error.what() + ")");
  }
}

/// s that the command would take on one core.
double secondsOf(const Room& room, const SceneOptions& options) {
  const double rows = room.patches.rows(), sites = static_cast<double>(room.sites.size()),
               triangles = static_cast<double>(room.triangles.size());
  return options.draft ? draftSeconds(rows, sites, triangles)
                       : coreSeconds(rows, sites, triangles, options.transport.rays);
}

class Builder {
 public:
  explicit Builder(val lent) : page_(std::move(lent)) {}

  /// What a model's surfaces are good for; nothing is opened.
  val survey(const std::string& name, val model, val asked) {
    return guarded([&] {
      const RoomOptions options = optionsOf(asked).room;
      const Result<Survey> survey = surveyModel({name, bytesOf(model)}, options, page_.host());
      if (!survey) return val(survey.error().message);
      val result = val::object(), size = val::array();
      size.set(0, survey->size.x), size.set(1, survey->size.y), size.set(2, survey->size.z);
      result.set("size", size);
      result.set("scale", survey->scale);
      result.set("up", std::string(survey->isZUp ? "z" : "y"));
      result.set("patch", survey->patch);
      result.set("rows", survey->rows);
      result.set("work", coreSeconds(survey->rows, survey->sites, survey->triangles));
      result.set("sites", survey->sites);
      result.set("lost", survey->lost);
      result.set("surfaces", listOf(survey->surfaces));
      result.set("warnings", listOf(survey->warnings));
      return result;
    });
  }

  /// What the room consists of.
  val open(const std::string& name, val model, val asked) {
    return guarded([&] {
      parts_.reset();
      const SceneOptions options = optionsOf(asked);
      Host host = page_.host();
      // A draft is read once and not kept.
      if (options.draft) host.deflate = [](auto, auto) { return std::vector<std::uint8_t>(); };
      Result<SceneParts> opened = SceneParts::open({name, bytesOf(model)}, options, std::move(host));
      if (!opened) return val(opened.error().message);
      parts_.emplace(std::move(*opened));
      const Room& room = parts_->room();
      val result = val::object();
      result.set("rows", room.patches.rows());
      result.set("sites", static_cast<std::uint32_t>(room.sites.size()));
      result.set("clusters", room.patches.clusterCount);
      result.set("patchSize", room.patchSize);
      result.set("source", room.sourceHash);
      result.set("work", secondsOf(room, options));
      result.set("memory", parts_->bytes() / 1e9);
      result.set("warnings", listOf(room.warnings));
      return result;
    });
  }

  val cast(std::uint32_t first, std::uint32_t rows) {
    return guarded([&] { return answer(parts_->cast(first, rows)); });
  }

  /// '' where all is well.
  val add(val part) {
    return guarded([&] { return answer(parts_->add(bytesOf(part))); });
  }

  /// How many blocks there are.
  val prepare() {
    return guarded([&] { return answer(parts_->prepare()); });
  }

  val solve(std::uint32_t block) {
    return guarded([&] { return answer(parts_->solve(block)); });
  }

  /// '' where all is well.
  val join(val part) {
    return guarded([&] { return answer(parts_->join(bytesOf(part))); });
  }

  /// lx of every row by each luminaire, column-major; seven numbers each say which one it is.
  val light(const val& files, const val& hung) {
    return guarded([&] {
      const Result<std::vector<Luminaire>> luminaires = luminairesOf(files, hung, parts_->room().sites);
      if (!luminaires) return val(luminaires.error().message);
      const Result<std::vector<float>> columns = parts_->light(*luminaires);
      if (!columns) return val(columns.error().message);
      return val(emscripten::typed_memory_view(columns->size(), columns->data())).call<val>("slice");
    });
  }

  /// Bytes that the module holds, which never become fewer.
  double held() const { return static_cast<double>(emscripten_get_heap_size()); }

  /// The scene file.
  val assemble() {
    return guarded([&] {
      const Result<MadeScene> made = parts_->assemble();
      return made ? copied(made->file) : val(made.error().message);
    });
  }

 private:
  Page page_;
  std::optional<SceneParts> parts_;
};

}  // namespace

EMSCRIPTEN_BINDINGS(builder) {
  emscripten::class_<Builder>("Builder")
      .constructor<val>()
      .function("survey", &Builder::survey)
      .function("open", &Builder::open)
      .function("cast", &Builder::cast)
      .function("add", &Builder::add)
      .function("prepare", &Builder::prepare)
      .function("solve", &Builder::solve)
      .function("join", &Builder::join)
      .function("assemble", &Builder::assemble)
      .function("light", &Builder::light)
      .function("held", &Builder::held);
}

}  // namespace fiatlux
