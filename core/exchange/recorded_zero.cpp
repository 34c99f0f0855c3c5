#include "core/exchange/recorded_zero.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/base/angle_text.h"
#include "core/session/face.h"
#include "core/session/zero_examiner.h"

namespace alidade {

namespace {

/// Decimals of arcseconds in a mean of several sightings: finer than any circle's last digit.
constexpr int meanDecimals = 2;

struct Sighted {
  const RecordedSighting* sighting;
  FaceOneReading inFaceOne;
};

using Group = std::vector<Sighted>;

int faceOf(const RecordedSighting& sighting) {
  return sighting.row.face == "2" ? 2 : 1;
}

std::string written(Angle angle, Angle centre) {
  return formatDms(wrappedAsWritten(angle, meanDecimals, centre), meanDecimals, AngleSigns::Typewriter);
}

FaceOneReading meanOf(const Group& group) {
  const FaceOneReading first = group.front().inFaceOne;
  FaceOneReading sum{};
  for (const Sighted& one : group) {
    sum.horizontal = sum.horizontal + wrapped(one.inFaceOne.horizontal, first.horizontal);
    sum.vertical = sum.vertical + wrapped(one.inFaceOne.vertical, first.vertical);
  }
  const double share = 1 / static_cast<double>(group.size());
  return {sum.horizontal * share, sum.vertical * share};
}

class Assembled {
 public:
  Assembled(const std::vector<ZeroInFile>& sightings, VerticalCircle circle) : m_circle(circle) {
    for (const auto& [sighting, isAfter] : sightings) {
      const Result<Angle> horizontal = parseAngle(sighting->row.horizontal);
      const Result<Angle> vertical = parseAngle(sighting->row.vertical);
      if (!horizontal || !vertical) {
        m_result.zero.horizontal = sightings.front().sighting->row.horizontal;
        m_result.zero.vertical = sightings.front().sighting->row.vertical;
        return;
      }
      const int face = faceOf(*sighting);
      const Sighted read{sighting, inFaceOne(*horizontal, *vertical, face, circle)};
      if (!m_first) m_first = read.inFaceOne;
      compare(read);
      m_groups[{face, isAfter}].push_back(read);
    }
    fill();
  }

  RecordedZero take() { return std::move(m_result); }

 private:
  void compare(const Sighted& read) {
    const double horizontal = std::abs(wrapped(read.inFaceOne.horizontal - m_first->horizontal).degrees()),
                 vertical = std::abs(wrapped(read.inFaceOne.vertical - m_first->vertical).degrees());
    if (m_result.apart || std::max(horizontal, vertical) <= farthestZeroSighting) return;
    m_result.apart = {read.sighting, vertical > horizontal, std::max(horizontal, vertical)};
  }

  void fill() {
    const std::pair<int, bool> firstOf[] = {{1, false}, {1, true}, {2, false}, {2, true}};
    const auto first = *std::ranges::find_if(firstOf, [&](const auto& at) { return m_groups.contains(at); });
    m_result.isConverted = first.first == 2;
    PointingZero& zero = m_result.zero;
    const auto enter = [&](const auto& at, auto& entry, bool isInFaceOne) {
      const auto found = m_groups.find(at);
      if (found == m_groups.end()) return;
      enterGroup(found->second, at.second, entry, isInFaceOne);
      m_groups.erase(found);
    };
    enter(first, zero, true);
    for (const ZeroSlot& slot : furtherZeros) {
      const bool isConverted = m_result.isConverted && slot.face == 1;
      enter(std::pair(isConverted ? 2 : slot.face, slot.isAfter), zero.*slot.sighting, slot.face == 1);
    }
  }

  /// `Entry` has the texts of both circles and of their arrival.
  template <typename Entry>
  void enterGroup(const Group& group, bool isAfter, Entry& entry, bool isInFaceOne) {
    const Reading& row = group.front().sighting->row;
    const int face = faceOf(*group.front().sighting);
    if (group.size() == 1) {
      entry.takenAt = row.takenAt;
      entry.returnCode = row.returnCode;
      entry.instrumentSerial = row.instrumentSerial;
    }
    if (group.size() == 1 && (face == 1) == isInFaceOne) {
      entry.horizontal = row.horizontal;
      entry.vertical = row.vertical;
      return;
    }
    FaceOneReading mean = meanOf(group);
    if (!isInFaceOne) mean = inFaceOne(mean.horizontal, mean.vertical, 2, m_circle);  // its own inverse
    const Angle half = Angle::fromDegrees(180), quarter = Angle::fromDegrees(90);
    entry.horizontal = written(mean.horizontal, half);
    entry.vertical = written(mean.vertical, m_circle == VerticalCircle::Zenith ? half : quarter);
    if (group.size() == 1) return;
    RecordedZero::Mean& of = m_result.means.emplace_back();
    of.face = face;
    of.isAfter = isAfter;
    for (const Sighted& one : group) of.of.push_back(one.sighting);
  }

  VerticalCircle m_circle;
  std::optional<FaceOneReading> m_first;
  std::map<std::pair<int, bool>, Group> m_groups;  ///< by face and whether after the readings
  RecordedZero m_result;
};

}  // namespace

RecordedZero recordedZero(const std::vector<ZeroInFile>& sightings, VerticalCircle circle) {
  return Assembled(sightings, circle).take();
}

}  // namespace alidade
