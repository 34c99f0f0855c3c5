#include "core/exchange/import.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_reader.h"
#include "core/exchange/gsi_reader.h"
#include "core/exchange/gsi_word.h"
#include "core/exchange/point_numbers.h"
#include "core/exchange/text_lines.h"
#include "core/session/face.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

/// Decimals of arcseconds a mean of several sightings is written with: beyond any circle's last digit.
constexpr int meanDecimals = 2;

/// The first line with any content decides.
Result<Recording> readRecording(std::string_view text, const ImportOptions& options) {
  TextLines lines(text);
  while (const auto next = lines.next()) {
    const TextLine& line = *next;
    const std::size_t first = line.text.find_first_not_of(" \t");
    if (first == std::string_view::npos ||
        std::string_view("#@?%").find(line.text[first]) != std::string_view::npos)
      continue;
    if (line.text[first] == '{') return Problem{"is no file of readings but JSON: open it as a session"};
    return looksLikeGsi(line.text) ? readGsi(text, options.zeroPoint)
                                   : readCsv(text, options.unit, options.zeroPoint);
  }
  return Problem{"holds no readings: choose a GSI file or a CSV table"};
}

/// Of no use, and no word of it would be said: everything would stand at 0°.
std::optional<Problem> turnedBehindTheEnd(const Recording& recording, const ImportOptions& options) {
  const std::size_t last = std::ranges::max_element(recording.sightings, {}, &RecordedSighting::line)->line;
  if (!options.turnedAtLine || *options.turnedAtLine <= last) return std::nullopt;
  return Problem{"has its last reading in line " + std::to_string(last) + ", so none is at 180° from line " +
                 std::to_string(*options.turnedAtLine) + " on: give a line within the file"};
}

/// Puts the sightings of a recording into a session.
class Assembly {
 public:
  Assembly(Recording recording, const ImportOptions& options)
      : m_recording(std::move(recording)), m_options(options) {
    m_import.session = options.base;
    m_import.format = m_recording.format;
    m_import.problems = std::move(m_recording.problems);
    m_import.remarks = std::move(m_recording.unused);
  }

  Import assemble() {
    takeHeadings();
    takeAxes();
    takeFaces();
    takePositions();
    takeRounds();
    numberPoints();
    for (const RecordedSighting& sighting : m_recording.sightings) {
      check(sighting);
      if (!sighting.isZero) addReading(sighting);
    }
    takeZeros();
    dropEmptyPositions();
    orderPositions();
    std::stable_sort(m_import.problems.begin(), m_import.problems.end(),
                     [](const LineProblem& a, const LineProblem& b) {
                       return std::tie(a.line, a.column) < std::tie(b.line, b.column);
                     });
    return std::move(m_import);
  }

 private:
  void remark(const std::string& sentence) { m_import.remarks.push_back(sentence); }

  static void fill(std::string& text, const std::string& value) {
    if (text.empty()) text = value;
  }

  void takeHeadings() {
    Session& session = m_import.session;
    fill(session.instrument.name, m_recording.instrumentName);
    fill(session.instrument.serial, m_recording.instrumentSerial);
    fill(session.measuredOn, m_recording.measuredOn);
    const std::string& named = m_recording.verticalCircle;
    if (std::string& stated = session.geometry.verticalCircle; !named.empty()) {
      if (!stated.empty() && stated != named)
        remark("the vertical circle is stated as " + quotation(stated) + ", but its column is named " +
               named + ": the column is followed");
      stated = named;
    }
    const Result<VerticalCircle> circle = verticalCircleEntry(session.geometry.verticalCircle);
    if (circle) m_circle = *circle;
  }

  void takeAxes() {
    std::vector<RecordedSighting>& sightings = m_recording.sightings;
    const bool told = std::any_of(sightings.begin(), sightings.end(), [](const RecordedSighting& sighting) {
      return !sighting.axis.text.empty();
    });
    std::string last = "0";
    for (RecordedSighting& sighting : sightings) {
      if (!told && m_options.turnedAtLine) last = sighting.line < *m_options.turnedAtLine ? "0" : "180";
      if (sighting.axis.text.empty()) sighting.axis.text = last;
      last = sighting.axis.text;
      if (const Result<int> axis = axisEntry(last)) sighting.axis.text = std::to_string(*axis);
    }
    if (!told && !m_options.turnedAtLine)
      remark("nothing in the file says how the axis stood: all its readings are put at 0°");
    if (told && m_options.turnedAtLine)
      remark("the file itself says how the axis stood: that is what counts");
  }

  /// Where the file says no face, face 2 is where the telescope is turned through.
  void takeFaces() {
    bool second = false;
    for (RecordedSighting& sighting : m_recording.sightings) {
      const Result<Angle> vertical = parseAngle(sighting.row.vertical);
      if (sighting.row.face.empty() && vertical && isFaceTwo(*vertical, m_circle)) sighting.row.face = "2";
      second = second || sighting.row.face == "2";
    }
    if (!second) return;
    for (RecordedSighting& sighting : m_recording.sightings)
      if (sighting.row.face.empty()) sighting.row.face = "1";
  }

  /// Readings one after the other with the axis as it stands.
  struct Turn {
    std::string axis;
    std::vector<RecordedSighting*> sightings;
  };

  std::vector<Turn> turns() {
    std::vector<Turn> turns;
    for (RecordedSighting& sighting : m_recording.sightings) {
      if (turns.empty() || turns.back().axis != sighting.axis.text) turns.push_back({sighting.axis.text, {}});
      turns.back().sightings.push_back(&sighting);
    }
    return turns;
  }

  /// Where the axis comes back and places are sighted that were sighted there before, with nothing that calls
  /// it another round, the position is measured again, and the pointing zeros of that turn are its own.
  void takePositions() {
    if (m_recording.tellsTurns) return countTurns();
    std::vector<Turn> all = turns();
    std::set<std::string> axes;
    for (const Turn& turn : all) axes.insert(turn.axis);
    if (axes.size() == all.size()) return;
    std::map<std::string, std::set<Visited>> sighted;
    std::map<std::string, int> times;
    for (Turn& turn : all) {
      std::set<Visited> own;
      bool isAgain = false;
      for (const RecordedSighting* sighting : turn.sightings) {
        if (sighting->isZero || sighting->row.point.empty()) continue;
        const Visited visit = visited(*sighting);
        own.insert(visit);
        isAgain = isAgain || sighted[turn.axis].contains(visit);
      }
      int& time = times[turn.axis];
      if (time == 0 || isAgain) {
        ++time;
        sighted[turn.axis].clear();
      }
      sighted[turn.axis].merge(own);
      for (RecordedSighting* sighting : turn.sightings) sighting->time = time;
    }
  }

  /// The turns that the file tells, without gaps.
  void countTurns() {
    std::map<std::string, std::map<int, int>> numbers;
    for (const RecordedSighting& sighting : m_recording.sightings) numbers[sighting.axis.text][sighting.time];
    for (auto& [axis, turns] : numbers) {
      int count = 0;
      for (auto& [told, number] : turns) number = ++count;
    }
    for (RecordedSighting& sighting : m_recording.sightings)
      sighting.time = numbers.at(sighting.axis.text).at(sighting.time);
  }

  /// An entry as the number it means, so that 1 and 01 are one point.
  static std::string asNumber(const WholeRule& rule, const std::string& text) {
    const auto number = wholeEntry(rule, text);
    return number && *number ? std::to_string(**number) : text;
  }

  /// Point, face and round of a sighting.
  using Visited = std::tuple<std::string, std::string, std::string>;
  static Visited visited(const RecordedSighting& sighting) {
    return {asNumber(pointRule, sighting.row.point), asNumber(faceRule, sighting.row.face),
            asNumber(roundRule, sighting.row.round)};
  }

  /// Which position a sighting is of.
  using At = std::pair<std::string, int>;
  static At positionOf(const RecordedSighting& sighting) { return {sighting.axis.text, sighting.time}; }
  static std::string nameOf(const At& at) {
    return at.first + "°" + (at.second > 1 ? ", time " + std::to_string(at.second) : "");
  }

  /// Where the file says no round, the first that it does not state for this point and face.
  void takeRounds() {
    using Place = std::tuple<At, std::string, std::string>;
    const auto placeOf = [](const RecordedSighting& sighting) {
      return Place{positionOf(sighting), asNumber(pointRule, sighting.row.point),
                   asNumber(faceRule, sighting.row.face)};
    };
    std::map<Place, std::set<std::string>> stated;
    for (const RecordedSighting& sighting : m_recording.sightings)
      if (!sighting.isZero && !sighting.row.round.empty())
        stated[placeOf(sighting)].insert(asNumber(roundRule, sighting.row.round));
    std::map<Place, int> last;
    bool second = false;
    for (RecordedSighting& sighting : m_recording.sightings) {
      if (sighting.isZero || !sighting.row.round.empty() || sighting.row.point.empty()) continue;
      const Place place = placeOf(sighting);
      int& round = last[place];
      do ++round;
      while (stated[place].contains(std::to_string(round)));
      second = second || round > 1;
      if (round > 1) sighting.row.round = std::to_string(round);
    }
    if (second) remark("points that come again in the same position and face are put into further rounds");
    const bool any =
        std::any_of(m_recording.sightings.begin(), m_recording.sightings.end(),
                    [](const RecordedSighting& sighting) { return !sighting.row.round.empty(); });
    for (RecordedSighting& sighting : m_recording.sightings)
      if (any && !sighting.isZero && sighting.row.round.empty()) sighting.row.round = "1";
  }

  /// In each position by itself.
  void numberPoints() {
    std::map<At, std::vector<std::string>> names;
    for (const RecordedSighting& sighting : m_recording.sightings)
      if (!sighting.isZero) names[positionOf(sighting)].push_back(sighting.row.point);
    std::map<At, std::map<std::string, std::string>> numbers;
    for (const auto& [position, namesThere] : names) numbers[position] = pointNumbers(namesThere);
    bool renamed = false;
    for (RecordedSighting& sighting : m_recording.sightings) {
      if (sighting.isZero || sighting.row.point.empty()) continue;
      const std::string& number = numbers.at(positionOf(sighting)).at(sighting.row.point);
      if (number == sighting.row.point) continue;
      renamed = true;
      sighting.row.note = sighting.row.point + (sighting.row.note.empty() ? "" : ": " + sighting.row.note);
      sighting.row.point = number;
    }
    if (renamed) remark("points with names are numbered; their names stand in the notes");
  }

  void report(std::size_t line, std::size_t column, std::string_view name, const Problem& problem) {
    if (m_import.problems.size() >= limits::mostProblems) return;
    m_import.problems.push_back({line, column, std::string(name) + " " + problem.what});
  }

  /// The rules of the session file, told by line and column.
  void check(const RecordedSighting& sighting) {
    if (const auto axis = axisEntry(sighting.axis.text); !axis)
      report(sighting.line, sighting.axis.column, "axis", axis.problem());
    if (sighting.row.excluded) return;
    for (const RowField& field : rowFields) {
      const bool isNameOfZero = sighting.isZero && field.text == &Reading::point;
      if (!field.text || isNameOfZero) continue;
      if (const auto problem = entryProblem(field, sighting.row.*field.text, m_circle))
        report(sighting.line, sighting.columnOf(field), field.key, *problem);
    }
  }

  /// The position of that axis, made where there is none, and those before it.
  Position& positionAt(const At& at) {
    std::vector<Position>& positions = m_import.session.positions;
    const Result<int> wanted = axisEntry(at.first);
    int time = 0;
    for (Position& position : positions) {
      const Result<int> has = axisEntry(position.axisDeg);
      if ((wanted && has ? *has == *wanted : position.axisDeg == at.first) && ++time == at.second)
        return position;
    }
    for (; time < at.second; ++time)
      positions.push_back({.axisDeg = at.first, .zero = {}, .readings = {}, .origin = {}});
    return positions.back();
  }

  void addReading(const RecordedSighting& sighting) {
    if (!axisEntry(sighting.axis.text)) return;  // reported already
    positionAt(positionOf(sighting)).readings.push_back(sighting.row);
    ++m_import.rows;
  }

  /// Does the field name or measure a pointing zero?
  static bool isOfZero(const RowField& field) {
    return field.text == &Reading::point || field.text == &Reading::round || field.text == &Reading::face ||
           field.text == &Reading::horizontal || field.text == &Reading::vertical;
  }

  void takeZeros() {
    std::map<At, std::vector<const RecordedSighting*>> zeros;
    for (const RecordedSighting& sighting : m_recording.sightings) {
      if (!sighting.isZero) continue;
      const std::string where = " of the pointing zero in line " + std::to_string(sighting.line);
      for (const RowField& field : rowFields)
        if (field.text && !isOfZero(field) && !(sighting.row.*field.text).empty())
          remark("the " + std::string(field.key) + " " + quotation(sighting.row.*field.text) + where +
                 " is not used");
      if (sighting.row.excluded) {
        remark("the excluded sighting" + where + " is not used");
      } else {
        zeros[positionOf(sighting)].push_back(&sighting);
      }
    }
    for (const auto& [position, sightings] : zeros) takeZero(position, sightings);
  }

  void takeZero(const At& at, const std::vector<const RecordedSighting*>& sightings) {
    PointingZero& zero = positionAt(at).zero;
    std::string lines;
    for (const RecordedSighting* sighting : sightings) {
      lines += lines.empty() ? (sightings.size() == 1 ? "line " : "lines ") : ", ";
      lines += std::to_string(sighting->line);
    }
    if (!zero.horizontal.empty() || !zero.vertical.empty())
      return remark("the pointing zero at " + nameOf(at) + " stays as it was given; that of " + lines +
                    " is not used");
    const RecordedSighting& first = *sightings.front();
    const auto mean = sightings.size() > 1 || first.row.face == "2" ? meanOf(sightings) : std::nullopt;
    if (!mean) {
      zero.horizontal = first.row.horizontal;
      zero.vertical = first.row.vertical;
      return;
    }
    const auto written = [](Angle angle) { return formatDms(angle, meanDecimals, AngleSigns::Typewriter); };
    zero.horizontal = written(wrapped(mean->horizontal, Angle::fromDegrees(180)));
    zero.vertical = written(mean->vertical);
    remark("the pointing zero at " + nameOf(at) + " is the face 1 mean of " + lines);
  }

  /// In face 1; absent where one of the angles cannot be read, which `check` has said.
  std::optional<FaceOneReading> meanOf(const std::vector<const RecordedSighting*>& sightings) const {
    std::vector<FaceOneReading> readings;
    for (const RecordedSighting* sighting : sightings) {
      const Result<Angle> horizontal = parseAngle(sighting->row.horizontal);
      const Result<Angle> vertical = parseAngle(sighting->row.vertical);
      if (!horizontal || !vertical) return std::nullopt;
      readings.push_back(inFaceOne(*horizontal, *vertical, sighting->row.face == "2" ? 2 : 1, m_circle));
    }
    const FaceOneReading first = readings.front();
    FaceOneReading sum{};
    for (const FaceOneReading& reading : readings) {
      sum.horizontal = sum.horizontal + wrapped(reading.horizontal, first.horizontal);
      sum.vertical = sum.vertical + wrapped(reading.vertical, first.vertical);
    }
    const double share = 1 / static_cast<double>(readings.size());
    return FaceOneReading{sum.horizontal * share, sum.vertical * share};
  }

  /// A position the file says nothing of, and nothing was typed for, was not measured.
  void dropEmptyPositions() {
    std::erase_if(m_import.session.positions, [](const Position& position) {
      return position.readings.empty() && position.zero.horizontal.empty() && position.zero.vertical.empty();
    });
  }

  /// A session has the position at 0° read first, and where an axis comes again those that the file holds in
  /// its order.
  void orderPositions() {
    std::stable_sort(m_import.session.positions.begin(), m_import.session.positions.end(),
                     [](const Position& a, const Position& b) { return rankOf(a) < rankOf(b); });
    std::vector<At> turns;
    for (const RecordedSighting& sighting : m_recording.sightings) {
      const bool isNew = turns.empty() || turns.back() != positionOf(sighting);
      if (axisEntry(sighting.axis.text) && !sighting.isZero && isNew) turns.push_back(positionOf(sighting));
    }
    const std::set<At> different(turns.begin(), turns.end());
    const bool isAgain = std::ranges::any_of(different, [](const At& at) { return at.second > 1; });
    if (turns.size() > different.size())
      remark("the positions of the axis alternate in the file; a session keeps the order within each only");
    else if (turns.size() == 2 && turns.front().first != "0" && !isAgain)
      remark(
          "180° was read before 0°, but a session takes 0° as read first: a drift or a jump between the "
          "positions would be taken the wrong way round");
    if (isAgain) orderAsRead(turns);
  }

  static int rankOf(const Position& position) {
    constexpr int behindAll = 360;
    const Result<int> axis = axisEntry(position.axisDeg);
    return axis ? *axis : behindAll;
  }

  void orderAsRead(const std::vector<At>& turns) {
    std::vector<Position>& positions = m_import.session.positions;
    std::vector<std::size_t> order;
    const auto take = [&](std::size_t index) {
      if (std::ranges::find(order, index) == order.end()) order.push_back(index);
    };
    for (const At& at : turns) take(static_cast<std::size_t>(&positionAt(at) - positions.data()));
    for (std::size_t i = 0; i < positions.size(); ++i) take(i);
    std::vector<Position> ordered;
    for (const std::size_t index : order) ordered.push_back(std::move(positions[index]));
    positions = std::move(ordered);
  }

  Recording m_recording;
  const ImportOptions& m_options;
  VerticalCircle m_circle = VerticalCircle::Zenith;
  Import m_import;
};

}  // namespace

Result<Import> importReadings(std::string_view bytes, const ImportOptions& options) {
  const Result<std::string> text = utf8Text(bytes);
  if (!text) return text.problem();
  Result<Recording> recording = readRecording(*text, options);
  if (!recording) return recording.problem();
  if (recording->sightings.empty()) {
    if (!recording->problems.empty()) return Problem{recording->problems.front().text()};
    return Problem{"holds no readings with a horizontal and a vertical circle: choose another file"};
  }
  if (auto problem = turnedBehindTheEnd(*recording, options)) return *std::move(problem);
  return Assembly(*std::move(recording), options).assemble();
}

}  // namespace alidade
