#include "core/exchange/assembly.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/exchange/point_numbers.h"
#include "core/exchange/recorded_zero.h"
#include "core/exchange/visits.h"
#include "core/exchange/words.h"
#include "core/session/face.h"
#include "core/session/row_fields.h"
#include "core/session/time_text.h"
#include "core/session/zero_examiner.h"

namespace alidade {

namespace {

bool hasRows(const Session& session) {
  return std::ranges::any_of(session.positions,
                             [](const Position& position) { return !position.readings.empty(); });
}

class Assembly {
 public:
  Assembly(std::vector<Recording> recordings, const std::vector<ReadingsFile>& files,
           const ImportOptions& options)
      : m_files(files), m_options(options), m_isAdded(hasRows(options.base)) {
    m_import.session = options.base;
    for (std::size_t i = 0; i < recordings.size(); ++i) take(recordings[i], i);
    m_recordings = std::move(recordings);
  }

  Import assemble() {
    takeHeadings();
    takeFaces();
    if (m_hasTurns && !m_isAdded)
      countTurns();
    else
      takePositions(m_sightings, m_options.base);
    if (takeRounds(m_sightings, m_options.base))
      remark(Phrase::of("points repeated in the same position and face are assigned to further rounds"));
    numberPoints();
    for (const RecordedSighting& sighting : m_sightings) {
      check(sighting);
      if (!sighting.isZero) addReading(sighting);
    }
    takeZeros();
    if (!m_isAdded) {
      dropEmptyPositions();
      orderPositions();
    }
    addOrigins();
    std::stable_sort(m_problems.begin(), m_problems.end(), [](const auto& a, const auto& b) {
      return std::tie(a.first, a.second.line, a.second.column) <
             std::tie(b.first, b.second.line, b.second.column);
    });
    for (auto& [file, problem] : m_problems) m_import.problems.push_back(std::move(problem));
    return std::move(m_import);
  }

 private:
  void remark(const std::string& sentence) { m_import.remarks.push_back(sentence); }

  /// Renumbers the turns stated in the file without gaps.
  void countTurns() {
    std::map<std::string, std::map<int, int>> numbers;
    for (const RecordedSighting& sighting : m_sightings) numbers[sighting.axis.text][sighting.repeat];
    for (auto& [axis, turns] : numbers) {
      int count = 0;
      for (auto& [stated, number] : turns) number = ++count;
    }
    for (RecordedSighting& sighting : m_sightings)
      sighting.repeat = numbers.at(sighting.axis.text).at(sighting.repeat);
  }

  bool areSeveral() const { return m_files.size() > 1; }
  /// The prefix of a remark: the file's name, if there are several files.
  std::string ofFile(std::size_t file) const {
    return areSeveral() ? quotation(m_files[file].name) + ": " : std::string();
  }
  std::string lineOf(const RecordedSighting& sighting) const {
    return areSeveral() ? Phrase::of("%1 line %2", quotation(m_files[sighting.file].name), sighting.line)
                        : Phrase::of("line %1", sighting.line);
  }

  void take(Recording& recording, std::size_t file) {
    if (m_import.format.find(recording.format) == std::string::npos)
      m_import.format += (m_import.format.empty() ? "" : ", ") + recording.format;
    for (LineProblem& problem : recording.problems) {
      if (areSeveral()) problem.file = m_files[file].name;
      m_problems.emplace_back(file, std::move(problem));
    }
    for (const auto* sentences : {&recording.unused, &recording.unusedBySession})
      for (const std::string& sentence : *sentences) remark(ofFile(file) + sentence);
    m_hasTurns = m_hasTurns || recording.hasTurns;
    takeAxes(recording, file);
    const std::string& round = m_files[file].round;
    for (RecordedSighting& sighting : recording.sightings) {
      sighting.file = file;
      if (!round.empty() && !sighting.isZero) sighting.row.round = round;
    }
    append(m_sightings, std::exchange(recording.sightings, {}));
  }

  /// Moves the rows if `all` is empty: a single file may have a million rows.
  static void append(std::vector<RecordedSighting>& all, std::vector<RecordedSighting> more) {
    if (all.empty())
      all = std::move(more);
    else
      all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }

  static void fill(std::string& text, const std::string& value) {
    if (text.empty()) text = value;
  }

  void takeHeadings() {
    Session& session = m_import.session;
    for (const Recording& recording : m_recordings) {
      fill(session.instrument.name, recording.instrumentName);
      fill(session.instrument.serial, recording.instrumentSerial);
      fill(session.measuredOn, recording.measuredOn);
      const std::string &serial = recording.instrumentSerial, &kept = session.instrument.serial;
      if (!serial.empty() && serial != kept)
        remark(Phrase::of("a file is of the instrument with the serial number %1; the session keeps %2",
                          quotation(serial), quotation(kept)));
      const std::string& named = recording.verticalCircle;
      if (named.empty()) continue;
      std::string& stated = session.geometry.verticalCircle;
      if (!recording.circleRemark.empty() && stated != named) remark(recording.circleRemark);
      if (!stated.empty() && stated != named)
        remark(Phrase::of(
            "the vertical circle is stated as %1, but the file says %2: the circle is read as the file says",
            quotation(stated), plainKey(named)));
      stated = named;
    }
    const Result<VerticalCircle> circle = verticalCircleEntry(session.geometry.verticalCircle);
    if (circle) m_circle = *circle;
  }

  void takeAxes(Recording& recording, std::size_t file) {
    std::vector<RecordedSighting>& sightings = recording.sightings;
    const ReadingsFile& wanted = m_files[file];
    const bool stated = std::any_of(sightings.begin(), sightings.end(), [](const RecordedSighting& sighting) {
      return !sighting.axis.text.empty();
    });
    std::string last = "0";
    for (RecordedSighting& sighting : sightings) {
      if (!wanted.axis.empty()) sighting.axis = {wanted.axis, 0};
      if (!stated && wanted.turnedAtLine) last = sighting.line < *wanted.turnedAtLine ? "0" : "180";
      if (sighting.axis.text.empty()) sighting.axis.text = last;
      last = sighting.axis.text;
      if (const Result<int> axis = axisEntry(last)) sighting.axis.text = std::to_string(*axis);
    }
    if (!wanted.axis.empty()) return;
    if (!stated && !wanted.turnedAtLine) {
      m_import.unplaced.push_back(file);
      remark(ofFile(file) + Phrase::of(putAtZero));
    }
    if (stated && wanted.turnedAtLine)
      remark(ofFile(file) +
             Phrase::of("the file states the axis positions: the line given for 180° is not used"));
  }

  /// The vertical circle decides between face 1 and face 2 if the file states no face.
  void takeFaces() {
    bool second = false;
    for (RecordedSighting& sighting : m_sightings) {
      const Result<Angle> vertical = parseAngle(sighting.row.vertical);
      if (sighting.row.face.empty() && vertical && isFaceTwo(*vertical, m_circle)) sighting.row.face = "2";
      second = second || sighting.row.face == "2";
    }
    if (!second) return;
    for (RecordedSighting& sighting : m_sightings)
      if (sighting.row.face.empty()) sighting.row.face = "1";
  }

  /// The first point number for the new readings of a position: after those of the session, else 1.
  int firstNumberAt(const PositionKey& key) const {
    int largest = 0;
    if (const Position* position = m_isAdded ? positionIn(m_options.base, key) : nullptr)
      for (const Reading& row : position->readings)
        if (const Result<int> number = parseWhole(row.point)) largest = std::max(largest, *number);
    return largest + 1;
  }

  /// Numbers the points of each position separately.
  void numberPoints() {
    std::map<PositionKey, std::vector<std::string>> names;
    for (const RecordedSighting& sighting : m_sightings)
      if (!sighting.isZero) names[positionOf(sighting)].push_back(sighting.row.point);
    std::map<PositionKey, std::map<std::string, std::string>> numbers;
    for (const auto& [position, namesThere] : names)
      numbers[position] = pointNumbers(namesThere, firstNumberAt(position));
    bool renamed = false;
    for (RecordedSighting& sighting : m_sightings) {
      if (sighting.isZero || sighting.row.point.empty()) continue;
      const std::string& number = numbers.at(positionOf(sighting)).at(sighting.row.point);
      if (number == sighting.row.point) continue;
      renamed = true;
      sighting.row.note = sighting.row.point + (sighting.row.note.empty() ? "" : ": " + sighting.row.note);
      sighting.row.point = number;
    }
    if (renamed) remark(Phrase::of("points with names are numbered; their names are in the notes"));
  }

  void report(const RecordedSighting& sighting, std::size_t column, std::string_view name,
              const Problem& problem, bool asksUnit = false) {
    if (m_problems.size() >= limits::mostProblems) return;
    const std::string& file = areSeveral() ? m_files[sighting.file].name : std::string();
    m_problems.emplace_back(sighting.file, LineProblem{.line = sighting.line,
                                                       .column = column,
                                                       .what = plainKey(name) + " " + problem.what,
                                                       .file = file,
                                                       .asksUnit = asksUnit});
  }

  /// Applies the rules of the session file and reports problems by line and column.
  void check(const RecordedSighting& sighting) {
    if (const auto axis = axisEntry(sighting.axis.text); !axis)
      report(sighting, sighting.axis.column, "axis", axis.problem());
    if (sighting.row.excluded) return;
    for (const RowField& field : rowFields) {
      const bool isNameOfZero = sighting.isZero && field.text == &Reading::point;
      if (!field.text || isNameOfZero) continue;
      const std::string& text = sighting.row.*field.text;
      if (const auto problem = isAngle(field) ? gonWithoutUnit(text) : std::nullopt)
        report(sighting, sighting.columnOf(field), field.key, *problem);
      else if (const auto rule = entryProblem(field, text, m_circle))
        report(sighting, sighting.columnOf(field), field.key, *rule,
               isAngle(field) && parseNumber(text) && !parseAngle(text));
    }
  }

  /// The problem of a plain number above 360, which can only be gon.
  static std::optional<Problem> gonWithoutUnit(const std::string& text) {
    constexpr double turn = 360, turnInGon = 400;
    const Result<double> number = text.size() > 3 ? parseNumber(text) : Result<double>(Problem{});
    if (!number || *number <= turn || *number > turnInGon) return std::nullopt;
    return Problem{Phrase::of(
        "%1 can only be gon, as degrees end at 360: name the unit in the heading, such as Hz [gon], "
        "or choose gon as the unit (--unit gon)",
        quotation(text))};
  }

  /// The position with this axis and repeat; creates it, and any repeats before it, if missing.
  Position& positionAt(const PositionKey& at) {
    std::vector<Position>& positions = m_import.session.positions;
    const Result<int> wanted = axisEntry(at.first);
    int repeat = 0;
    for (Position& position : positions) {
      const Result<int> has = axisEntry(position.axisDeg);
      if ((wanted && has ? *has == *wanted : position.axisDeg == at.first) && ++repeat == at.second)
        return position;
    }
    for (; repeat < at.second; ++repeat)
      positions.push_back({.axisDeg = at.first, .zero = {}, .readings = {}, .origin = {}});
    return positions.back();
  }

  void addReading(const RecordedSighting& sighting) {
    if (!axisEntry(sighting.axis.text)) return;  // reported already
    const PositionKey key = positionOf(sighting);
    positionAt(key).readings.push_back(sighting.row);
    m_lines[key].emplace_back(sighting.file, sighting.line);
    ++m_import.rows;
  }

  /// Is the field used in the name, the readings or the arrival of a pointing zero?
  static bool isOfZero(const RowField& field) {
    const auto of = {&Reading::point, &Reading::round, &Reading::face, &Reading::horizontal,
                     &Reading::vertical};
    return std::ranges::find(of, field.text) != of.end() ||
           std::ranges::find(arrivalTexts, field.text) != std::end(arrivalTexts);
  }

  void takeZeros() {
    struct Sighted {
      const RecordedSighting* sighting;
      std::size_t rowsBefore;
    };
    std::map<PositionKey, std::vector<Sighted>> zeros;
    std::map<PositionKey, std::size_t> rows;
    for (const RecordedSighting& sighting : m_sightings) {
      const PositionKey position = positionOf(sighting);
      if (!sighting.isZero) {
        ++rows[position];
        continue;
      }
      for (const RowField& field : rowFields)
        if (field.text && !isOfZero(field) && !(sighting.row.*field.text).empty())
          remark(Phrase::of("the %1 %2 of the pointing zero in %3 is not used", plainKey(field.key),
                            quotation(sighting.row.*field.text), lineOf(sighting)));
      if (sighting.row.excluded) {
        remark(Phrase::of("the excluded sighting of the pointing zero in %1 is not used", lineOf(sighting)));
      } else {
        zeros[position].push_back({&sighting, rows[position]});
      }
    }
    for (const auto& [position, sightings] : zeros) {
      std::vector<ZeroInFile> marked;
      for (const auto& [sighting, before] : sightings)
        marked.push_back({sighting, 2 * before > rows[position]});
      takeZero(position, marked);
    }
  }

  void takeZero(const PositionKey& at, const std::vector<ZeroInFile>& marked) {
    PointingZero& zero = positionAt(at).zero;
    std::vector<const RecordedSighting*> sightings;
    for (const ZeroInFile& one : marked) sightings.push_back(one.sighting);
    if (!zero.horizontal.empty() || !zero.vertical.empty())
      return remark(
          Phrase::of("the pointing zero at %1 keeps its given value; the sighting in %2 is not used",
                     nameOf(at), linesOf(sightings)));
    const RecordedZero recorded = recordedZero(marked, m_circle);
    zero = recorded.zero;
    for (const RecordedZero::Mean& mean : recorded.means)
      remark(mean.isAfter
                 ? Phrase::of("the pointing zero at %1 after the readings, in face %2, is the mean of %3",
                              nameOf(at), mean.face, linesOf(mean.of))
                 : Phrase::of("the pointing zero at %1, in face %2, is the mean of %3", nameOf(at), mean.face,
                              linesOf(mean.of)));
    if (recorded.isConverted)
      remark(
          Phrase::of("the pointing zero at %1 was sighted in face 2 only (%2) and is converted to face 1: "
                     "collimation and index error count as errors of the zero",
                     nameOf(at), linesOf(sightings)));
    if (const auto& apart = recorded.apart) {
      const RowField& field = *std::ranges::find(
          rowFields, apart->isVertical ? &Reading::vertical : &Reading::horizontal, &RowField::text);
      report(*apart->sighting, apart->sighting->columnOf(field), field.key,
             zeroApartProblem(apart->sighting->row.*field.text, apart->degrees));
    }
  }

  /// "line 3", "lines 1, 3", or with the names of the files.
  std::string linesOf(const std::vector<const RecordedSighting*>& sightings) const {
    const bool areNumbers = sightings.size() > 1 && !areSeveral();
    std::string lines;
    for (const RecordedSighting* sighting : sightings)
      lines +=
          (lines.empty() ? "" : ", ") + (areNumbers ? std::to_string(sighting->line) : lineOf(*sighting));
    return areNumbers ? Phrase::of("lines %1", lines) : lines;
  }

  /// Drops positions without any data: the file does not mention them and nothing was typed for them.
  void dropEmptyPositions() {
    std::erase_if(m_import.session.positions, [](const Position& position) {
      return position.readings.empty() && position.zero.horizontal.empty() && position.zero.vertical.empty();
    });
  }

  /// Puts the position at 0° first. If an axis repeats, positions get the order in which the file has them.
  void orderPositions() {
    std::stable_sort(m_import.session.positions.begin(), m_import.session.positions.end(),
                     [](const Position& a, const Position& b) { return rankOf(a) < rankOf(b); });
    std::vector<PositionKey> turns;
    for (const RecordedSighting& sighting : m_sightings) {
      const bool isNew = turns.empty() || turns.back() != positionOf(sighting);
      if (axisEntry(sighting.axis.text) && !sighting.isZero && isNew) turns.push_back(positionOf(sighting));
    }
    const std::set<PositionKey> different(turns.begin(), turns.end());
    const bool isAgain = std::ranges::any_of(different, [](const PositionKey& at) { return at.second > 1; });
    if (turns.size() > different.size())
      remark(
          Phrase::of("the positions of the axis alternate in the file; a session keeps the order of readings "
                     "only within each position"));
    else if (turns.size() == 2 && turns.front().first != "0" && !isAgain && !haveTimes())
      remark(
          Phrase::of("180° was read before 0°, but a session assumes 0° first: a drift or a jump between the "
                     "positions would get the wrong sign"));
    if (isAgain) orderAsRead(turns);
  }

  bool haveTimes() const {
    return std::ranges::all_of(m_sightings, [](const RecordedSighting& sighting) {
      return sighting.isZero || minutesOf(sighting.row.takenAt).has_value();
    });
  }

  static int rankOf(const Position& position) {
    constexpr int behindAll = 360;
    const Result<int> axis = axisEntry(position.axisDeg);
    return axis ? *axis : behindAll;
  }

  void orderAsRead(const std::vector<PositionKey>& turns) {
    std::vector<Position>& positions = m_import.session.positions;
    std::vector<std::size_t> order;
    const auto take = [&](std::size_t index) {
      if (std::ranges::find(order, index) == order.end()) order.push_back(index);
    };
    for (const PositionKey& at : turns) take(static_cast<std::size_t>(&positionAt(at) - positions.data()));
    for (std::size_t i = 0; i < positions.size(); ++i) take(i);
    std::vector<Position> ordered;
    ordered.reserve(order.size());
    for (const std::size_t index : order) ordered.push_back(std::move(positions[index]));
    positions = std::move(ordered);
  }

  void addOrigins() {
    for (const auto& [key, lines] : m_lines) {
      const Position& position = positionAt(key);
      const auto index = static_cast<std::size_t>(&position - m_import.session.positions.data());
      std::size_t row = position.readings.size() - lines.size();
      for (const auto& [file, line] : lines) {
        std::vector<ImportedRows>& origins = m_import.origins;
        const bool goesOn =
            !origins.empty() && origins.back().position == index && origins.back().file == file;
        if (!goesOn)
          origins.push_back({.position = index, .firstRow = row, .count = 0, .file = file, .lines = {}});
        ImportedRows& rows = origins.back();
        ++rows.count;
        ++row;
        const bool isSameLine = !rows.lines.empty() && rows.lines.back().second == line;  // of both faces
        if (isSameLine) continue;
        if (!rows.lines.empty() && rows.lines.back().second + 1 == line)
          rows.lines.back().second = line;
        else
          rows.lines.emplace_back(line, line);
      }
    }
    std::stable_sort(m_import.origins.begin(), m_import.origins.end(),
                     [](const ImportedRows& a, const ImportedRows& b) {
                       return std::tie(a.position, a.firstRow) < std::tie(b.position, b.firstRow);
                     });
  }

  const std::vector<ReadingsFile>& m_files;
  const ImportOptions& m_options;
  bool m_hasTurns = false;  ///< a file states the turn of its rows
  bool m_isAdded;           ///< readings are added to those of a session
  std::vector<Recording> m_recordings;
  std::vector<RecordedSighting> m_sightings;                    ///< sightings of all files, in file order
  std::vector<std::pair<std::size_t, LineProblem>> m_problems;  ///< index of the file, and problem
  std::map<PositionKey, std::vector<std::pair<std::size_t, std::size_t>>> m_lines;  ///< file and line by row
  VerticalCircle m_circle = VerticalCircle::Zenith;
  Import m_import;
};

}  // namespace

Import assemble(std::vector<Recording> recordings, const std::vector<ReadingsFile>& files,
                const ImportOptions& options) {
  return Assembly(std::move(recordings), files, options).assemble();
}

}  // namespace alidade
