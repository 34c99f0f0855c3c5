#include "core/series/instrument_check/check_files.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/statistics.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_reader.h"
#include "core/exchange/file_format.h"
#include "core/exchange/grouped_problems.h"
#include "core/exchange/recognise.h"
#include "core/exchange/words.h"
#include "core/session/face.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

// Both circles may read from −360° to 360°: some instruments read slightly below zero.
constexpr AngleRule eitherCircle{.low = -360, .lowOfElevation = -360, .high = 360, .isHighIncluded = true};

/// The file's name without its last suffix: the name of its station.
std::string stemOf(const std::string& name) {
  const std::size_t from = name.find_last_of("/\\") + 1, dot = name.rfind('.');
  return name.substr(from, dot != std::string::npos && dot > from ? dot - from : std::string::npos);
}

/// The layout that follows from the column names. If the table has rounds or sets, `series` is the station.
TableLayout layoutOf(const Recognised& recognised, AngleUnit unit) {
  TableLayout layout;
  layout.unit = unit;
  layout.seriesIsStation = true;
  if (recognised.table.headRows == 0) return layout;
  layout.separator = recognised.table.separator;
  layout.headRows = recognised.table.headRows;
  return layout;
}

/// Returns the misclosure of the two faces of a target, degrees. The vertical readings of both faces add up
/// to a full turn (zenith angles) or half a turn (elevations); the horizontal ones differ by half a turn.
double openingOf(double before, double after, bool isVertical) {
  return std::abs(isVertical ? std::remainder(after + before, 180)
                             : std::remainder(after - before - 180, 360));
}

/// The median misclosure over all targets, degrees; infinite if the readings cannot be read in this unit.
double closureIn(AngleUnit unit, const Recording& recording) {
  const double unreadable = std::numeric_limits<double>::infinity();
  std::map<std::pair<std::size_t, std::string>, double> last;
  std::vector<double> closures;
  for (const RecordedSighting& sighting : recording.sightings) {
    const bool isVertical = !sighting.row.vertical.empty();
    const auto horizontal = parseAngle(withUnit(sighting.row.horizontal, unit));
    const auto closing = isVertical ? parseAngle(withUnit(sighting.row.vertical, unit)) : horizontal;
    if (!closing || (!horizontal && !sighting.row.horizontal.empty())) return unreadable;
    const double degrees = closing->degrees();
    const auto [before, isFirst] = last.try_emplace({sighting.station, sighting.row.point}, degrees);
    constexpr double betweenFaces = 90;
    const double step = degrees - before->second;
    if (!isFirst && std::abs(isVertical ? step : std::remainder(step, 360)) > betweenFaces)
      closures.push_back(openingOf(before->second, degrees, isVertical));
    before->second = degrees;
  }
  if (closures.empty()) return unreadable;
  return medianOf(std::move(closures));
}

/// The unit with clearly the smallest misclosure of the faces; Unstated if no unit stands out.
AngleUnit unitByFaces(const Recording& plain) {
  constexpr double most = 0.5, byFar = 3;
  std::vector<std::pair<double, AngleUnit>> closures;
  for (const AngleUnit unit : {AngleUnit::Degrees, AngleUnit::Gon, AngleUnit::Dms})
    closures.emplace_back(closureIn(unit, plain), unit);
  std::ranges::sort(closures);
  const bool isClear = closures[0].first < most && closures[1].first > byFar * closures[0].first;
  return isClear ? closures[0].second : AngleUnit::Unstated;
}

std::string accessibleUnit(AngleUnit unit) {
  if (unit == AngleUnit::Gon) return Phrase::of("gon");
  return unit == AngleUnit::Degrees ? Phrase::of("decimal degrees") : Phrase::of("degrees.minutes seconds");
}

/// Whether two files state the same circle readings in the same order: one is a copy.
bool haveSameReadings(const Recording& one, const Recording& other) {
  return std::ranges::equal(one.sightings, other.sightings,
                            [](const RecordedSighting& a, const RecordedSighting& b) {
                              return a.row.point == b.row.point && a.row.face == b.row.face &&
                                     a.row.horizontal == b.row.horizontal && a.row.vertical == b.row.vertical;
                            });
}

/// Combines the sightings of all files.
class CheckFiles {
 public:
  CheckFiles(const std::vector<CheckFile>& files, const CheckFileOptions& options)
      : m_files(files), m_options(options) {}

  Result<CheckReadings> read() {
    std::vector<Recording> recordings;
    std::size_t rows = 0;
    for (m_file = 0; m_file < m_files.size(); ++m_file) {
      Result<Recording> read = readRecording();
      if (!read) return named(read.problem());
      Recording recording = *std::move(read);
      recording.problems.insert(recording.problems.end(), recording.distanceProblems.begin(),
                                recording.distanceProblems.end());
      if (!recording.problems.empty()) return problemOf(std::move(recording.problems));
      if (recording.sightings.empty())
        return named(Problem{Phrase::of("holds no readings of a circle: choose another file")});
      if (const auto same = std::ranges::find_if(
              recordings, [&](const Recording& other) { return haveSameReadings(other, recording); });
          same != recordings.end())
        return named(Problem{
            Phrase::of("has the readings of %1 once more: leave one of the two out",
                       quotation(m_files[static_cast<std::size_t>(same - recordings.begin())].name))});
      rows += recording.sightings.size();
      if (rows > limits::mostRows) return named(limits::tooManyRows());
      recordings.push_back(std::move(recording));
    }
    if (recordings.empty()) return Problem{Phrase::of("no file was chosen: choose one")};
    if (auto problem = takeCircles(recordings)) return *std::move(problem);
    if (auto problem = takeCircle(recordings)) return *std::move(problem);
    if (areSeveral())
      for (const CheckFile& file : m_files) m_result.files.push_back(file.name);
    nameStations(recordings);
    for (m_file = 0; m_file < m_files.size(); ++m_file)
      if (auto problem = take(recordings[m_file])) return *std::move(problem);
    reportFaces();
    return std::move(m_result);
  }

 private:
  bool areSeveral() const { return m_files.size() > 1; }
  std::string fileName() const { return areSeveral() ? m_files[m_file].name : std::string(); }
  Problem named(const Problem& problem) const {
    return areSeveral() ? Problem{quotation(m_files[m_file].name) + " " + problem.what} : problem;
  }
  void remark(const std::string& sentence) {
    m_result.remarks.push_back(areSeveral() ? quotation(m_files[m_file].name) + ": " + sentence : sentence);
  }

  Problem problemOf(std::vector<LineProblem> problems) const {
    for (LineProblem& problem : problems) {
      problem.file = fileName();
      if (m_files[m_file].table) problem.column = 0;  // the user does not see the line made of the cells
    }
    std::ranges::stable_sort(problems, {}, &LineProblem::line);
    return Problem{problems.size() == 1
                       ? problems.front().text()
                       : Phrase::of("%1 (and %2 more)", problems.front().text(), problems.size() - 1)};
  }

  Result<Recording> readRecording() {
    const Result<std::string> text = readingsText(m_files[m_file].bytes, m_files[m_file].name);
    if (!text) return text.problem();
    if (m_files[m_file].table) return readTableOf(*text, *m_files[m_file].table);
    const Result<Recognised> recognised = recognise(*text);
    if (!recognised) return recognised.problem();
    if (!recognised->isTable()) return recognised->format->read(*text, {});
    return readTableOf(*text, layoutOf(*recognised, m_options.unit));
  }

  /// True if a circle reading is a plain number, whose unit is ambiguous.
  static bool asksUnit(const Recording& recording) {
    return std::ranges::any_of(recording.sightings, [](const RecordedSighting& sighting) {
      const auto isPlain = [](const std::string& text) { return parseNumber(text) && !parseAngle(text); };
      return isPlain(sighting.row.horizontal) || isPlain(sighting.row.vertical);
    });
  }

  Result<Recording> readTableOf(std::string_view text, TableLayout layout) {
    if (layout.unit == AngleUnit::Unstated) layout.unit = m_options.unit;
    layout.needsVertical = false;
    Recording recording = readTable(text, layout);
    if (layout.unit != AngleUnit::Unstated || !recording.problems.empty() || !asksUnit(recording))
      return recording;
    layout.unit = unitByFaces(recording);
    if (layout.unit == AngleUnit::Unstated)
      return Problem{Phrase::of(
          "has angles without a unit, and no single unit lets both faces add up to a full turn: put the unit "
          "into the column names, such as “horizontal [gon]”, or choose it (--unit)")};
    remark(
        Phrase::of("numbers without a unit are read as %1, since the vertical readings of both faces then "
                   "add up to a full turn",
                   accessibleUnit(layout.unit)));
    return readTable(text, layout);
  }

  /// Requires the same circles in all files: both, or the same single one.
  std::optional<Problem> takeCircles(const std::vector<Recording>& recordings) {
    m_result.circles = circlesOf(recordings.front());
    const auto isOther = [this](const Recording& each) { return circlesOf(each) != m_result.circles; };
    if (std::ranges::any_of(recordings, isOther))
      return Problem{
          Phrase::of("files with both circles and files with one of them cannot be checked together: check "
                     "them one after the other")};
    return std::nullopt;
  }

  static CheckCircles circlesOf(const Recording& recording) {
    const auto lacks = [&recording](std::string Reading::*circle) {
      return std::ranges::all_of(recording.sightings, [circle](const RecordedSighting& sighting) {
        return (sighting.row.*circle).empty();
      });
    };
    if (lacks(&Reading::vertical)) return CheckCircles::HorizontalOnly;
    return lacks(&Reading::horizontal) ? CheckCircles::VerticalOnly : CheckCircles::Both;
  }

  bool isRead(std::string Reading::*circle) const {
    return m_result.circles == CheckCircles::Both ||
           (circle == &Reading::horizontal) == (m_result.circles == CheckCircles::HorizontalOnly);
  }

  /// Requires one kind of vertical circle in all files; if none states the kind, the readings decide.
  std::optional<Problem> takeCircle(const std::vector<Recording>& recordings) {
    std::string kind = m_options.verticalCircle;
    for (const Recording& recording : recordings) {
      if (recording.verticalCircle.empty() || kind == recording.verticalCircle) continue;
      if (!kind.empty())
        return Problem{Phrase::of("the files have both %1 and %2 circles: check them separately",
                                  plainKey(kind), plainKey(recording.verticalCircle))};
      kind = recording.verticalCircle;
    }
    if (kind.empty() && areElevations(recordings)) {
      kind = "elevation";
      m_result.remarks.push_back(
          Phrase::of("the vertical readings are treated as elevations, because they are near 0° and 180°"));
    }
    if (kind == "elevation") m_result.circle = m_result.identity.circle = VerticalCircle::Elevation;
    return std::nullopt;
  }

  static bool areElevations(const std::vector<Recording>& recordings) {
    std::size_t elevations = 0, all = 0;
    for (const Recording& recording : recordings)
      for (const RecordedSighting& sighting : recording.sightings) {
        const auto vertical = parseAngle(sighting.row.vertical);
        if (!vertical) continue;
        ++all;
        elevations += std::abs(std::cos(vertical->radians())) > std::numbers::sqrt2 / 2 ? 1 : 0;
      }
    return 2 * elevations > all;
  }

  /// Names the stations as in the files. A station without a name gets the stem of the file's name; a name
  /// that several stations have is preceded by this stem.
  void nameStations(const std::vector<Recording>& recordings) {
    std::map<std::string, std::size_t> uses;
    for (const Recording& recording : recordings)
      for (const std::string& station : recording.stations) ++uses[station];
    for (std::size_t file = 0; file < recordings.size(); ++file) {
      m_firstStation.push_back(m_result.stations.size());
      const std::string stem = stemOf(m_files[file].name);
      for (const std::string& station : recordings[file].stations) {
        const bool isAlone = uses[station] == 1;
        std::string name = station.empty() || !isAlone ? stem : station;
        if (!station.empty() && !isAlone) name.append(" ").append(station);
        m_result.stations.push_back(std::move(name));
      }
    }
  }

  /// Takes what the first file states; the files of one check are of one instrument.
  std::optional<Problem> takeHeadings(const Recording& recording) {
    CheckIdentity& identity = m_result.identity;
    const std::string& serial = recording.instrumentSerial;
    if (!serial.empty() && !identity.serial.empty() && serial != identity.serial)
      return named(
          Problem{Phrase::of("is of the instrument with the serial number %1, an earlier file of that with "
                             "%2: check each instrument by itself",
                             quotation(serial), quotation(identity.serial))});
    const auto fill = [](std::string& text, const std::string& value) {
      if (text.empty()) text = value;
    };
    fill(identity.name, recording.instrumentName);
    fill(identity.serial, serial);
    fill(identity.measuredOn, recording.measuredOn);
    if (!recording.measuredOn.empty() && recording.measuredOn != identity.measuredOn)
      remark(Phrase::of("measured on %1; the check takes the day of an earlier file, %2",
                        recording.measuredOn, identity.measuredOn));
    return std::nullopt;
  }

  std::optional<Problem> take(const Recording& recording) {
    for (const std::string& sentence : recording.unused) remark(sentence);
    if (!recording.circleRemark.empty() && m_options.verticalCircle.empty()) remark(recording.circleRemark);
    if (auto problem = takeHeadings(recording)) return problem;
    const bool countsFromZero = std::ranges::any_of(
        recording.sightings, [](const auto& sighting) { return sighting.row.face == "0"; });
    std::vector<LineProblem> problems;
    std::size_t excluded = 0;
    for (const RecordedSighting& sighting : recording.sightings) {
      if (sighting.row.excluded)
        ++excluded;
      else if (const auto problem = takeSighting(sighting, countsFromZero))
        problems.push_back(*problem);
      if (problems.size() >= limits::mostProblems) break;
    }
    if (!problems.empty()) return problemOf(problems);
    if (excluded > 0) remark(Phrase::of("excluded rows, not used: %1", excluded));
    return std::nullopt;
  }

  /// Adds a sighting to the result, or returns the reason why its line cannot be used.
  std::optional<LineProblem> takeSighting(const RecordedSighting& sighting, bool countsFromZero) {
    const Reading& row = sighting.row;
    const auto refuse = [&](const RowField& field, const std::string& why) {
      return LineProblem{sighting.line, sighting.columnOf(field), why};
    };
    if (row.point.empty())
      return refuse(rowField(&Reading::point), Phrase::of("has no target: enter its name"));
    FaceReading reading;
    for (const auto& [field, angle] : {std::pair(&Reading::horizontal, &reading.horizontal),
                                       std::pair(&Reading::vertical, &reading.vertical)}) {
      if (!isRead(field)) continue;
      const auto entry = angleEntry(eitherCircle, row.*field, m_result.circle);
      if (!entry) return refuse(rowField(field), entry.problem().what);
      *angle = **entry;
    }
    if (isRead(&Reading::vertical)) {
      reading.face = isFaceTwo(wrapped(reading.vertical, Angle::fromDegrees(180)), m_result.circle) ? 2 : 1;
      noteFace(row.face, countsFromZero, reading.face);
    } else if (const auto face = statedFace(row.face, countsFromZero)) {
      reading.face = *face;
    } else {
      return refuse(
          rowField(&Reading::face),
          Phrase::of("has neither a vertical reading nor a face: state the face of each row, 1 or 2"));
    }
    reading.station = m_firstStation[m_file] + sighting.station;
    const auto [target, isNew] = m_targets.try_emplace(row.point, m_result.targets.size());
    if (isNew) m_result.targets.push_back(row.point);
    reading.target = target->second;
    reading.round = row.round;
    reading.distanceM = slopeOf(sighting, reading);
    reading.file = m_file;
    reading.line = sighting.line;
    m_result.readings.push_back(std::move(reading));
    return std::nullopt;
  }

  static std::optional<int> statedFace(const std::string& stated, bool countsFromZero) {
    const Result<int> number = parseWhole(stated);
    if (!number) return std::nullopt;
    const int face = *number + (countsFromZero ? 1 : 0);
    return face == 1 || face == 2 ? std::optional(face) : std::nullopt;
  }

  /// Counts a stated face that differs from `face`, the face that the vertical circle shows and that is used.
  void noteFace(const std::string& stated, bool countsFromZero, int face) {
    if (stated.empty()) return;
    if (statedFace(stated, countsFromZero) != face) ++m_otherFaces;
  }

  double slopeOf(const RecordedSighting& sighting, const FaceReading& reading) const {
    if (!sighting.isDistanceHorizontal || !isRead(&Reading::vertical)) return sighting.distanceM;
    const double v = reading.vertical.radians();
    const double cosine = std::abs(m_result.circle == VerticalCircle::Zenith ? std::sin(v) : std::cos(v));
    return cosine > 0 ? sighting.distanceM / cosine : 0;
  }

  void reportFaces() {
    if (m_otherFaces > 0)
      m_result.remarks.push_back(Phrase::of(
          "rows whose stated face contradicts their vertical circle: %1; the circle is used", m_otherFaces));
  }

  const std::vector<CheckFile>& m_files;
  const CheckFileOptions& m_options;
  std::size_t m_file = 0;
  std::size_t m_otherFaces = 0;
  std::vector<std::size_t> m_firstStation;  ///< of each file: the index of its first station
  std::map<std::string, std::size_t> m_targets;
  CheckReadings m_result;
};

}  // namespace

Result<CheckReadings> readCheckFiles(const std::vector<CheckFile>& files, const CheckFileOptions& options) {
  return CheckFiles(files, options).read();
}

}  // namespace alidade
