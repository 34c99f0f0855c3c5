#include "ui/report/report_terms.h"

#include <algorithm>
#include <utility>

#include "core/diagnosis/conformance.h"
#include "core/diagnosis/decision.h"
#include "core/effects/known_sizes.h"
#include "ui/report/report_facts.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/known_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

constexpr int longestNote = 60, longestText = 120;  // characters
constexpr std::size_t mostNotes = 4;

bool isOfDistance(const Gap& gap) {
  const auto& measurement = gap.evaluation->examined.measurement;
  return measurement && measurement->measurand == Measurand::Distance;
}

QString measurandText(const Gap& gap) {
  const QString inPlane = QStringLiteral(
      "Intersection Δd = (y(O1) − y(O2))/2: half the difference of the heights of the arc centres at 0° (O1) "
      "and at 180° (O2), y up; positive where the centre is the higher one at 0°.");
  if (!isOfDistance(gap)) return inPlane;
  return inPlane +
         QStringLiteral(
             " The tolerance is of the distance d = √(Δd² + Δz²) of the centre from the axis, Δz across "
             "the plane of the arc.");
}

/// Empty where no verdict is to be had: without a tolerance, a result or a coverage that guards.
QString ruleText(const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  const auto& measurement = evaluation.examined.measurement;
  const auto& fitted = evaluation.fit.intersection;
  if (!fitted || !measurement->tolerance || measurement->coverage < leastCoverageOfVerdict) return {};
  const QString tolerance = plainNumberText(*measurement->tolerance) + QStringLiteral(" mm");
  const QString agreed = shortLine(qText(evaluation.session.report.ruleAgreedBy).trimmed(), longestText);
  const QString end = agreed.isEmpty() ? QStringLiteral(".") : QStringLiteral(". Agreed by: ") + agreed;
  if (isOfDistance(gap))
    return QStringLiteral(
               "Accepted: d + U ≤ %1 as measured, and |Δd| + U ≤ %1 by the fit alone; rejected: d − U > %1; "
               "else undecided. Guard band w = U (coverage %2 %)")
               .arg(tolerance, plainNumberText(100 * measurement->coverage)) +
           end;
  QString text = QStringLiteral(
                     "Accepted: |Δd| + U ≤ %1; rejected: |Δd| − U > %1; by the fit alone%2; else "
                     "undecided. Guard band w = U (coverage %3 %)")
                     .arg(tolerance, gap.diagnosis ? QStringLiteral(" and as measured") : QString(),
                          plainNumberText(100 * measurement->coverage));
  const MeasuredIntersection* measured = gap.measured();
  if (const auto risk =
          greatestRisk(measured ? measured->estimate : estimateOf(*fitted), *measurement->tolerance))
    text += QStringLiteral(": a verdict is wrong with a probability of at most %1 % (JCGM 106, ILAC-G8)")
                .arg(numberText(100 * *risk, 1));
  return text + end;
}

/// How many rows were left out for the same reason, in the order of the file.
std::vector<std::pair<QString, int>> reasonsOf(const Session& session) {
  std::vector<std::pair<QString, int>> reasons;
  for (const Position& position : session.positions)
    for (const Reading& row : position.readings) {
      if (!row.excluded) continue;
      const QString note = shortLine(qText(row.note).trimmed(), longestNote);
      const auto same = std::ranges::find(reasons, note, &std::pair<QString, int>::first);
      if (same == reasons.end())
        reasons.emplace_back(note, 1);
      else
        ++same->second;
    }
  return reasons;
}

QString exclusionsText(const Session& session) {
  std::size_t rows = 0;
  for (const Position& position : session.positions) rows += position.readings.size();
  const auto reasons = reasonsOf(session);
  if (reasons.empty()) return QStringLiteral("none of %1 rows of readings").arg(rows);
  int count = 0, further = 0;
  QStringList parts;
  for (const auto& [note, times] : reasons) {
    count += times;
    if (static_cast<std::size_t>(parts.size()) == mostNotes) {
      further += times;
      continue;
    }
    parts.append(QStringLiteral("%1 × %2").arg(times).arg(note.isEmpty() ? QStringLiteral("without a note")
                                                                         : u'“' + note + u'”'));
  }
  if (further > 0) parts.append(QStringLiteral("%1 × for other reasons").arg(further));
  return QStringLiteral("%1 of %2 rows of readings: %3")
      .arg(count)
      .arg(rows)
      .arg(parts.join(QStringLiteral(", ")));
}

/// "collimation 3.20″": what the session says a number is, where it says other than nothing.
QStringList knownSizes(const Measurement& measurement) {
  QStringList sizes;
  for (const Effect& effect : effectCatalogue())
    for (const EffectParameter& number : effect.parameters)
      if (const auto known = knownOf(measurement, number); known && known->value != 0) {
        const double unit = modelUnitsPer(number.unit);
        sizes.append(numberName(effect, number) + u' ' +
                     withUnit(numberText(known->value / unit, decimalsFor(known->sigma / unit)),
                              unitText(std::string(number.unit))));
      }
  return sizes;
}

QString correctionsText(const Evaluation& evaluation) {
  QStringList estimated, parts;
  for (const EffectEstimate& effect : evaluation.fit.effects)
    if (const QString name = effectName(effect.effect); !estimated.contains(name)) estimated.append(name);
  if (!estimated.isEmpty())
    parts.append(
        QStringLiteral("%1, estimated along with the arcs").arg(estimated.join(QStringLiteral(", "))));
  if (const auto& measurement = evaluation.examined.measurement)
    if (const QStringList known = knownSizes(*measurement); !known.isEmpty())
      parts.append(QStringLiteral("as measured, what is known beforehand: ") +
                   known.join(QStringLiteral(", ")));
  const QString text = parts.isEmpty() ? QStringLiteral("none") : parts.join(QStringLiteral("; "));
  return evaluation.session.journal.empty() ? text + QStringLiteral("; nothing was changed after it stood")
                                            : text;
}

/// Empty where nothing was changed.
QString changesText(const Evaluation& evaluation, bool isJournalPrinted) {
  if (evaluation.session.journal.empty()) return {};
  const QString summary = visibleLine(evaluation.journal);
  const auto count = evaluation.session.journal.size();
  const QString where =
      isJournalPrinted ? QStringLiteral(", see below") : QStringLiteral(" of the session, left out here");
  const QString entries = (count == 1 ? QStringLiteral("one entry in the journal")
                                      : QStringLiteral("%1 entries in the journal").arg(count)) +
                          where;
  return summary.isEmpty() ? entries : summary + u' ' + capitalised(entries) + u'.';
}

/// The temperature, and what it does to the lengths.
QString temperatureText(const Evaluation& evaluation) {
  const Environment& environment = evaluation.session.environment;
  const auto typed = [](const std::string& text) { return shortLine(qText(text).trimmed(), longestText); };
  QString text = typed(environment.temperatureC);
  if (text.isEmpty()) return text;
  text += QStringLiteral(" °C");
  if (const QString sigma = typed(environment.sigmaTemperatureC); !sigma.isEmpty())
    text += QStringLiteral(" (σ %1 K)").arg(sigma);
  const auto& measurement = evaluation.examined.measurement;
  QStringList changes;
  const auto tell = [&](const QString& length, double change) {
    if (change == 0) return;
    changes.append(QStringLiteral("%1 %2 mm").arg(length, signedNumberText(change, 3)));
  };
  if (measurement) {
    tell(QStringLiteral("L"), measurement->distanceExpansion);
    tell(QStringLiteral("R0"), measurement->radiusExpansion);
  }
  if (changes.isEmpty()) return text + QStringLiteral("; no expansion of L and R0 is stated");
  return text + QStringLiteral("; against 20 °C, for which they are stated, ") +
         changes.join(QStringLiteral(" and "));
}

}  // namespace

void addTerms(ReportSheet& sheet, const Gap& gap, const ReportContents& contents) {
  const Evaluation& evaluation = *gap.evaluation;
  sheet.skip(1);
  const std::vector<LabelledText> terms{
      {QStringLiteral("Measurand"), measurandText(gap)},
      {QStringLiteral("Decision rule"), ruleText(gap)},
      {QStringLiteral("Exclusions"), exclusionsText(evaluation.session)},
      {QStringLiteral("Corrections"), correctionsText(evaluation)},
      {QStringLiteral("Changes"), changesText(evaluation, isPrinted(ReportPart::Journal, contents, gap))},
      {QStringLiteral("Temperature"), temperatureText(evaluation)},
      {QStringLiteral("Left out"), leftOutTitles(contents, gap).join(QStringLiteral(", "))},
      {QStringLiteral("Scope"), QStringLiteral("The results relate only to the item measured.")}};
  sheet.keepTogether(labelledHeight(sheet, terms, ReportSheet::width));
  sheet.skip(placeLabelled(sheet, terms, 0, sheet.y(), ReportSheet::width) - sheet.y());
}

}  // namespace alidade::ui
