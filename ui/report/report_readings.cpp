#include "ui/report/report_parts.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/session/entry.h"
#include "core/session/face.h"
#include "ui/document/reading_column.h"
#include "ui/report/report_table.h"
#include "ui/report/report_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

constexpr double largeResidual = 3;  // standardised
constexpr int longestCell = 60;      // characters; longer texts are cut, since paper has no tool tip

/// The numbers of an angle without leading zeros and separators: 341 5 4 of 341°05′04″.
QStringList numbersIn(const QString& angle) {
  static const QRegularExpression number(QStringLiteral("\\d+"));
  QStringList numbers;
  for (auto found = number.globalMatch(angle); found.hasNext();) {
    QString digits = found.next().captured();
    while (digits.size() > 1 && digits.startsWith(u'0')) digits.remove(0, 1);
    numbers.append(digits);
  }
  return numbers;
}

/// The angle in the session's unit. A typed text with other numbers is shown on a line above.
QString angleCell(const std::string& typed, CircleUnit unit) {
  const QString text = shortLine(qText(typed).trimmed(), longestCell);
  const QString normal = shortLine(shownAngle(typed, unit).trimmed(), longestCell);
  if (normal == text || numbersIn(normal) == numbersIn(text)) return normal;
  return text + QStringLiteral("\n= ") + normal;
}

/// The text of `angleCell` on one line; "not given" if nothing was typed.
QString angleInLine(const std::string& typed, CircleUnit unit) {
  return typed.empty() ? Report::tr("not given")
                       : angleCell(typed, unit).replace(QStringLiteral("\n="), QStringLiteral(" ="));
}

/// Typed columns, then computed ones; the remark takes the remaining width. The head of the first column
/// names the position, since every page repeats the head.
std::vector<ReportColumn> columns(const QString& position) {
  constexpr auto right = Qt::AlignRight;
  std::vector<ReportColumn> columns;
  for (const ReadingColumnInfo& info : allReadingColumns())
    if (info.printedTitle)
      columns.push_back({QCoreApplication::translate("ReadingColumn", info.printedTitle), info.printedWidth,
                         isFreeText(info.column) ? Qt::AlignLeft : right});
  columns.front().title.append(u'\n' + position);
  columns.push_back({QStringLiteral("φ\n(°)"), 17.5, right});
  //: heads of narrow columns: the residual of the horizontal, then that of the vertical circle
  for (const QString& residual : {Report::tr("v horiz.\n(″)"), Report::tr("v vert.\n(″)")}) {
    columns.push_back({residual, 14, right});
    columns.push_back({QStringLiteral("w"), 10.5, right});
  }
  columns.push_back({QString(), 2});
  double taken = 0;
  for (const ReportColumn& column : columns) taken += column.width;
  columns.push_back({Report::tr("Remark"), ReportSheet::width - taken});
  return columns;
}

/// Rows of one position that `examine` refused.
std::set<std::size_t> unusableRows(const Evaluation& evaluation, std::size_t position) {
  std::set<std::size_t> rows;
  for (const Problem& problem : evaluation.examined.problems) {
    if (problem.where.position == position && problem.where.reading) rows.insert(*problem.where.reading);
  }
  return rows;
}

QString remark(const Reading& reading, bool unusable) {
  if (reading.excluded) return Report::tr("excluded");
  return unusable ? Report::tr("unusable") : QString();
}

/// Compensator tilts and corrections of the row; empty if the row has neither.
QStringList ofCompensator(const Reading& reading) {
  QStringList parts;
  const auto add = [&parts](const QString& says, const std::string& text) {
    if (!text.empty()) parts.append(says.arg(shortLine(text, longestCell)));
  };
  add(Report::tr("tilt across the line of sight %1″"), reading.tiltCrossArcsec);
  add(Report::tr("tilt along the line of sight %1″"), reading.tiltLengthArcsec);
  //: %1: words such as "inclination collimation", or "none"
  add(Report::tr("corrected by the instrument: %1"), reading.corrections);
  return parts;
}

/// Time, return code and instrument of a sighting received from an instrument; empty for a typed sighting.
QStringList ofArrival(const std::string& takenAt, const std::string& code, const std::string& serial) {
  QStringList parts;
  const auto add = [&parts](const QString& says, const std::string& text) {
    if (!text.empty()) parts.append(says.arg(shortLine(text, longestCell)));
  };
  //: %1: date, time and zone, as 2026-03-14T15:09:26+01:00
  add(Report::tr("taken at %1"), takenAt);
  //: of the instrument, as 0 or 1284
  add(Report::tr("return code %1"), code);
  add(Report::tr("instrument %1"), serial);
  return parts;
}

QString zeroArrival(const ZeroSighting& zero) {
  const QStringList parts = ofArrival(zero.takenAt, zero.returnCode, zero.instrumentSerial);
  return parts.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(listText(parts));
}

/// The note, the compensator data, the data received with the reading, and the first texts of changed cells.
QString remarks(const Reading& reading) {
  QStringList parts;
  if (const QString note = visibleLine(qText(reading.note).trimmed()); !note.isEmpty()) parts.append(note);
  parts.append(ofCompensator(reading));
  parts.append(ofArrival(reading.takenAt, reading.returnCode, reading.instrumentSerial));
  for (const auto& [key, text] : reading.asRead.all())
    parts.append(
        //: %1: what was read, as "vertical reading"; %2: as it was typed at first
        Report::tr("%1 first entered as %2")
            .arg(QCoreApplication::translate("ReadingColumn", infoOf(readingColumn(key)).noun),
                 shortLine(text, longestCell)));
  return Report::clauses(parts);
}

QString typedCell(const Reading& row, const RowField& field, CircleUnit unit) {
  const std::string& text = row.*field.text;
  if (isAngle(field)) return angleCell(text, unit);
  const QString typed = shortLine(qText(text).trimmed(), longestCell);
  return typed.isEmpty() ? qText(usualText(field)) : typed;
}

enum class Rows { All, Remarkable };

bool isRemarkable(const Reading& row, bool unusable) {
  return unusable || row.excluded || !row.asRead.all().empty();
}

class PositionTable {
 public:
  PositionTable(ReportSheet& sheet, const Evaluation& evaluation, std::size_t position)
      : m_sheet(sheet),
        m_table(sheet, columns(positionText(evaluation.session, position))),
        m_position(evaluation.session.positions[position]),
        m_unit(circleUnitOf(evaluation.session)),
        m_unusable(unusableRows(evaluation, position)),
        m_residuals(m_position.readings.size(), nullptr) {
    for (std::size_t i = 0; i < evaluation.session.positions.size(); ++i) {
      if (i == position) m_rowsBefore = m_rowsOfAll;
      m_rowsOfAll += evaluation.session.positions[i].readings.size();
    }
    const ArcFit* fit = evaluation.fit.arcOfPosition(position);
    if (!fit) return;
    for (const SightingResidual& residual : fit->residuals) m_residuals[residual.row] = &residual;
  }

  void add(Rows which) {
    m_table.head();
    const std::size_t rows = m_position.readings.size();
    for (std::size_t row = 0; row < rows; ++row) {
      if (!m_sheet.goesOn(static_cast<double>(m_rowsBefore + row) / static_cast<double>(m_rowsOfAll))) return;
      if (which == Rows::All || isRemarkable(m_position.readings[row], m_unusable.contains(row))) addRow(row);
    }
    m_table.finish();
  }

 private:
  static void addResidual(std::vector<ReportCell>& cells, Angle residual, double standardised) {
    const double arcseconds = residual.arcseconds();
    cells.emplace_back(signedNumberText(arcseconds, std::abs(arcseconds) < 1000 ? 1 : 0));
    const QString mark = std::abs(standardised) > largeResidual ? QStringLiteral("*") : QString();
    cells.emplace_back(signedNumberText(standardised, 1) + mark);
  }

  void addRow(std::size_t row) {
    const Reading& reading = m_position.readings[row];
    const SightingResidual* residual = m_residuals[row];
    const bool unusable = m_unusable.contains(row);
    const TextStyle style = reading.excluded ? type::label : unusable ? type::body.inBold() : type::body;
    std::vector<ReportCell> cells;
    for (const ReadingColumnInfo& info : allReadingColumns())
      if (info.printedTitle) cells.emplace_back(typedCell(reading, *info.field, m_unit), style);
    if (residual) {
      cells.emplace_back(numberText(Angle::fromRadians(residual->arcAngle).degrees(), 3));
      addResidual(cells, residual->horizontal, residual->horizontalStandardised);
      addResidual(cells, residual->vertical, residual->verticalStandardised);
    } else {
      for (int i = 0; i < 5; ++i) cells.emplace_back(notStated(), style);
    }
    cells.emplace_back();  // empty column before the remark
    cells.emplace_back(remark(reading, unusable), style);
    m_table.row(cells, remarks(reading));
  }

  ReportSheet& m_sheet;
  ReportTable m_table;
  const Position& m_position;
  CircleUnit m_unit;
  std::set<std::size_t> m_unusable;
  std::vector<const SightingResidual*> m_residuals;
  std::size_t m_rowsBefore = 0, m_rowsOfAll = 0;  ///< rows of earlier positions, and of all positions
};

void addPosition(ReportSheet& sheet, const Evaluation& evaluation, std::size_t index) {
  const Position& position = evaluation.session.positions[index];
  const auto zero = [unit = circleUnitOf(evaluation.session)](const std::string& text) {
    return angleInLine(text, unit);
  };
  sheet.keepTogether(35);
  sheet.heading(Report::tr("Readings with the axis at %1").arg(positionText(evaluation.session, index)));
  sheet.paragraph(Report::tr("Pointing zero: horizontal α0 = %1, vertical β0 = %2")
                      .arg(zero(position.zero.horizontal), zero(position.zero.vertical)) +
                  zeroArrival(firstSighting(position.zero)));
  QStringList further;
  for (const ZeroSlot& slot : furtherZeros) {
    const ZeroSighting& sighting = position.zero.*slot.sighting;
    if (sighting.horizontal.empty() && sighting.vertical.empty()) continue;
    const QString says = slot.isAfter ? Report::tr("after the readings in %1: %2, %3")
                                      : Report::tr("before the readings in %1: %2, %3");
    further.append(says.arg(qText(faceName(slot.face)), zero(sighting.horizontal), zero(sighting.vertical)) +
                   zeroArrival(sighting));
  }
  if (!further.isEmpty()) {
    //: %1: "before them in face 2: 170°, 90°; after the readings in face 1: …"
    sheet.paragraph(Report::tr("Sighted again %1").arg(Report::clauses(further)));
    if (const QString mean = meanZeroText(evaluation.examined, index); !mean.isEmpty()) sheet.paragraph(mean);
  }
  sheet.skip(0.8);
  if (position.readings.empty()) {
    sheet.paragraph(Report::tr("No readings."));
    return;
  }
  PositionTable(sheet, evaluation, index).add(Rows::All);
}

QString footnote(const Evaluation& evaluation) {
  QStringList sentences{
      Report::tr("v: residual, observed minus adjusted, right and up positive. φ: arc angle from +x, "
                 "counter-clockwise as the observer sees it.")};
  if (!evaluation.fit.arcs.empty())
    sentences.append(
        Report::tr(
            "w = v/(s0 σ √r): standardised residual, s0 = %1; — where no other reading checks the "
            "reading. * marks residuals with |w| > %2, for information: no reading is left out because "
            "of its residual.")
            .arg(numberText(evaluation.fit.noise.factor, 2), plainNumberText(largeResidual)));
  return Report::sentences(sentences);
}

bool hasRemarkable(const Evaluation& evaluation, std::size_t position) {
  const std::set<std::size_t> unusable = unusableRows(evaluation, position);
  const std::vector<Reading>& rows = evaluation.session.positions[position].readings;
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (isRemarkable(rows[row], unusable.contains(row))) return true;
  return false;
}

}  // namespace

void addReadings(ReportSheet& sheet, const Evaluation& evaluation) {
  sheet.newPage();
  for (std::size_t i = 0; i < evaluation.session.positions.size(); ++i) addPosition(sheet, evaluation, i);
  sheet.paragraph(footnote(evaluation), type::small);
}

void addRemarkableReadings(ReportSheet& sheet, const Evaluation& evaluation) {
  bool isAny = false;
  for (std::size_t i = 0; i < evaluation.session.positions.size(); ++i) {
    if (!hasRemarkable(evaluation, i)) continue;
    sheet.keepTogether(35);
    sheet.heading(Report::tr("Readings changed, excluded or not usable, with the axis at %1")
                      .arg(positionText(evaluation.session, i)));
    PositionTable(sheet, evaluation, i).add(Rows::Remarkable);
    isAny = true;
  }
  if (isAny) sheet.paragraph(footnote(evaluation), type::small);
}

}  // namespace alidade::ui
