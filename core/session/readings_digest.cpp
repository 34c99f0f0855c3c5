#include "core/session/readings_digest.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "core/base/sha256.h"

namespace alidade {

namespace {

/// Concatenates numbers, and texts with their lengths, so that different lists have different bytes.
class ReadingBytes {
 public:
  void add(std::uint64_t number) {
    constexpr int bitsOfByte = 8;
    for (std::size_t i = 0; i < sizeof number; ++i)
      m_bytes += static_cast<char>(number >> (bitsOfByte * i) & 0xFFU);
  }
  void add(int number) { add(static_cast<std::uint64_t>(number)); }
  void add(const std::string& text) {
    add(std::uint64_t{text.size()});
    m_bytes += text;
  }
  /// Rounded to 0.1″: a reading retyped in another unit changes by less, the rounding of its last decimal,
  /// while two sessions differ by more in some reading. The offset puts the ends of the steps between the
  /// hundredths of an arcsecond, where no reading of two decimals lies. 0 and −0 are one angle.
  void add(Angle angle) {
    constexpr double stepsPerArcsecond = 10, offset = 0.03;
    add(std::bit_cast<std::uint64_t>(std::round(angle.arcseconds() * stepsPerArcsecond + offset) + 0.0));
  }
  void add(const std::optional<Angle>& angle) {
    add(angle ? 1 : 0);
    if (angle) add(*angle);
  }

  const std::string& bytes() const { return m_bytes; }

 private:
  std::string m_bytes;
};

void addArc(ReadingBytes& bytes, const ArcMeasurement& arc) {
  bytes.add(arc.axisDeg);
  bytes.add(arc.repeat);
  bytes.add(arc.zeroHorizontal);
  bytes.add(arc.zeroVertical);
  bytes.add(std::uint64_t{arc.sightings.size()});
  for (const Sighting& row : arc.sightings) {
    for (const int number : {row.round, row.point, row.face}) bytes.add(number);
    bytes.add(row.a);
    bytes.add(row.e);
    bytes.add(row.slider);
  }
}

}  // namespace

std::string readingsDigest(const Session& session, const Measurement& measurement) {
  ReadingBytes bytes;
  bytes.add(session.measuredOn);
  bytes.add(session.instrument.serial.empty() ? "name " + session.instrument.name
                                              : "serial " + session.instrument.serial);
  bytes.add(session.device.serial.empty() ? "name " + session.device.name
                                          : "serial " + session.device.serial);
  for (const ArcMeasurement& arc : measurement.arcs) addArc(bytes, arc);
  return sha256(bytes.bytes());
}

std::vector<std::size_t> firstsAlike(const std::vector<std::string>& digests) {
  std::unordered_map<std::string, std::size_t> seen;
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < digests.size(); ++i)
    firsts.push_back(digests[i].empty() ? i : seen.emplace(digests[i], i).first->second);
  return firsts;
}

}  // namespace alidade
