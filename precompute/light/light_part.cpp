// Numbers as they lie in memory. Cast: first row, rows; of each row its lost and open shares, U, and near
// patches and slopes after their numbers; then direct light and visible shares. Solved: the block, and its
// lists after their numbers.
#include "precompute/light/light_part.h"

#include <cstring>
#include <type_traits>

namespace fiatlux {
namespace {

class Writer {
 public:
  explicit Writer(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
  template <class T>
  void put(const T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t size = bytes_.size();
    bytes_.resize(size + count * sizeof(T));
    if (count > 0) std::memcpy(bytes_.data() + size, values, count * sizeof(T));
  }
  void putCount(std::size_t count) {
    const auto value = static_cast<std::uint32_t>(count);
    put(&value, 1);
  }
  template <class T>
  void putList(const std::vector<T>& values) {
    putCount(values.size());
    put(values.data(), values.size());
  }

 private:
  std::vector<std::uint8_t>& bytes_;
};

/// False, and nothing more is read, where the bytes end too early.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}
  template <class T>
  bool take(std::vector<T>& values, std::size_t count) {
    if (count > rest_.size() / sizeof(T)) return false;
    values.resize(count);
    if (count > 0) std::memcpy(values.data(), rest_.data(), count * sizeof(T));
    rest_ = rest_.subspan(count * sizeof(T));
    return true;
  }
  template <class T>
  bool take(T& value) {
    if (rest_.size() < sizeof(T)) return false;
    std::memcpy(&value, rest_.data(), sizeof(T));
    rest_ = rest_.subspan(sizeof(T));
    return true;
  }
  template <class T>
  bool takeList(std::vector<T>& values) {
    std::uint32_t count = 0;
    return take(count) && take(values, count);
  }
  bool isAtEnd() const { return rest_.empty(); }

 private:
  std::span<const std::uint8_t> rest_;
};

const Error kDamaged{"a part of the light is damaged"};

bool takeRow(Reader& from, std::size_t clusters, FormFactorRow& row) {
  return from.take(row.lost) && from.take(row.open) && from.take(row.u, clusters) &&
         from.takeList(row.near) && from.takeList(row.slopes);
}

}  // namespace

std::vector<std::uint8_t> encodeLightPart(const LightPart& part) {
  std::vector<std::uint8_t> bytes;
  Writer to(bytes);
  to.putCount(part.first);
  to.putCount(part.rows.size());
  for (const FormFactorRow& row : part.rows) {
    to.put(&row.lost, 1);
    to.put(&row.open, 1);
    to.put(row.u.data(), row.u.size());
    to.putList(row.near);
    to.putList(row.slopes);
  }
  to.put(part.direct.data(), part.direct.size());
  to.put(part.visible.data(), part.visible.size());
  return bytes;
}

Result<LightPart> decodeLightPart(std::span<const std::uint8_t> bytes, std::size_t clusters,
                                  std::size_t sites, bool isVisible) {
  Reader from(bytes);
  LightPart part;
  std::uint32_t rows = 0;
  if (!from.take(part.first) || !from.take(rows)) return kDamaged;
  for (std::uint32_t i = 0; i < rows; ++i) {
    part.rows.emplace_back();
    if (!takeRow(from, clusters, part.rows.back())) return kDamaged;
  }
  if (!from.take(part.direct, rows * sites)) return kDamaged;
  if (!from.take(part.visible, isVisible ? rows * sites : 0) || !from.isAtEnd()) return kDamaged;
  return part;
}

std::vector<std::uint8_t> encodeSolvedPart(const SolvedPart& part) {
  std::vector<std::uint8_t> bytes;
  Writer to(bytes);
  to.putCount(part.block);
  to.putList(part.solved.illuminance);
  to.putList(part.solved.squares);
  to.putList(part.solved.exchange.means);
  to.putList(part.solved.exchange.rest);
  to.putList(part.solved.surfaces);
  return bytes;
}

Result<SolvedPart> decodeSolvedPart(std::span<const std::uint8_t> bytes) {
  Reader from(bytes);
  SolvedPart part;
  SolvedBlock& solved = part.solved;
  const bool isWhole = from.take(part.block) && from.takeList(solved.illuminance) &&
                       from.takeList(solved.squares) && from.takeList(solved.exchange.means) &&
                       from.takeList(solved.exchange.rest) && from.takeList(solved.surfaces) &&
                       from.isAtEnd();
  if (!isWhole) return kDamaged;
  return part;
}

}  // namespace fiatlux
