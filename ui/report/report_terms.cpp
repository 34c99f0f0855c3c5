#include "ui/report/report_parts.h"

#include <algorithm>
#include <utility>

#include "core/diagnosis/conformance.h"
#include "core/diagnosis/decision.h"
#include "core/effects/known_sizes.h"
#include "core/session/protocol_progress.h"
#include "core/wording/guidance.h"
#include "ui/report/empty_fields.h"
#include "ui/report/report_facts.h"
#include "ui/report/report_text.h"
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
  QStringList sentences{
      Report::tr("Intersection Δd = (y(O1) − y(O2))/2: half the difference of the heights of the arc centres "
                 "at 0° (O1) and at 180° (O2), y up; positive if the centre is higher at 0°.")};
  if (isOfDistance(gap))
    sentences.append(
        Report::tr("The tolerance applies to the distance d = √(Δd² + Δz²) of the centre from the axis, with "
                   "Δz perpendicular to the plane of the arc."));
  return Report::sentences(sentences);
}

/// A sentence on what is accepted and what is rejected.
QString acceptanceRule(const Gap& gap, const QString& tolerance) {
  if (isOfDistance(gap))
    return Report::tr(
               "Accepted: d + U ≤ %1, measured, and |Δd| + U ≤ %1, fit only; rejected: d − U > %1, measured. "
               "Otherwise, or if the gap has no known cause: undecided.")
        .arg(tolerance);
  if (gap.diagnosis)
    return Report::tr(
               "Accepted: |Δd| + U ≤ %1; rejected: |Δd| − U > %1; each measured and fit only. Otherwise, or "
               "if the gap has no known cause: undecided.")
        .arg(tolerance);
  return Report::tr(
             "Accepted: |Δd| + U ≤ %1; rejected: |Δd| − U > %1; each for Δd, fit only. Otherwise: undecided.")
      .arg(tolerance);
}

/// A sentence on the guard band, with the risk of a wrong verdict if the risk can be computed.
QString guardBand(const Gap& gap, double tolerance, double coverage) {
  const QString share = plainNumberText(100 * coverage);
  const MeasuredIntersection* measured = gap.measured();
  const auto risk = isOfDistance(gap) ? std::nullopt
                                      : greatestRisk(measured ? measured->estimate
                                                              : estimateOf(*gap.evaluation->fit.intersection),
                                                     tolerance);
  if (!risk) return Report::tr("Guard band w = U (coverage %1 %).").arg(share);
  return Report::tr(
             "Guard band w = U (coverage %1 %): a verdict is wrong with a probability of at most %2 % "
             "(JCGM 106, ILAC-G8).")
      .arg(share, numberText(100 * *risk, 1));
}

/// Empty if no verdict is possible, because tolerance, result or a sufficient coverage is missing.
QString ruleText(const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  const auto& measurement = evaluation.examined.measurement;
  const auto& fitted = evaluation.fit.intersection;
  if (!fitted || !measurement->tolerance || measurement->coverage < leastCoverageOfVerdict) return {};
  const double tolerance = *measurement->tolerance;
  QStringList sentences{acceptanceRule(gap, plainNumberText(tolerance) + QStringLiteral(" mm")),
                        guardBand(gap, tolerance, measurement->coverage)};
  const QString agreed = shortLine(qText(evaluation.session.report.ruleAgreedBy).trimmed(), longestText);
  if (!agreed.isEmpty()) sentences.append(Report::tr("Agreed by: %1").arg(agreed));
  return Report::sentences(sentences);
}

/// The number of excluded rows per reason, in file order.
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
  if (reasons.empty()) return Report::tr("none of %1 rows of readings").arg(rows);
  int count = 0, further = 0;
  QStringList parts;
  for (const auto& [note, times] : reasons) {
    count += times;
    if (static_cast<std::size_t>(parts.size()) == mostNotes) {
      further += times;
      continue;
    }
    //: %1: the number of excluded rows, %2: their note
    parts.append(note.isEmpty() ? Report::tr("%1 × without a note").arg(times)
                                : Report::tr("%1 × “%2”").arg(QString::number(times), note));
  }
  if (further > 0) parts.append(Report::tr("%1 × for other reasons").arg(further));
  //: excluded rows; %3: their numbers by note, such as "2 × “blunder”"
  return Report::tr("%1 of %2 rows of readings: %3")
      .arg(QString::number(count), QString::number(rows), listText(parts));
}

/// The non-zero known sizes of the session: "collimation 3.20″".
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

/// The protocol chosen for the session, and the deviations from the protocol; empty without a protocol.
QString protocolText(const Session& session) {
  const auto protocol = protocolOf(session);
  if (!protocol || !*protocol || (*protocol)->isYielding) return {};
  const QString name = shortLine(qText((*protocol)->name).trimmed(), longestNote),
                words = qText(protocolInWords(**protocol));
  return Report::sentences(
      {name.isEmpty() ? Report::tr("%1.").arg(capitalised(words)) : Report::tr("“%1”: %2.").arg(name, words),
       qText(deviationSentences(progressOf(session, **protocol)))});
}

QString correctionsText(const Evaluation& evaluation) {
  QStringList estimated, parts;
  for (const EffectEstimate& effect : evaluation.fit.effects)
    if (const QString name = effectName(effect.effect); !estimated.contains(name)) estimated.append(name);
  if (!estimated.isEmpty())
    //: %1: effects
    parts.append(Report::tr("%1, estimated along with the arcs").arg(listText(estimated)));
  if (const auto& measurement = evaluation.examined.measurement)
    if (const QStringList known = knownSizes(*measurement); !known.isEmpty())
      parts.append(Report::tr("known sizes in Δd, measured: %1").arg(listText(known)));
  //: corrections: none
  if (parts.isEmpty()) parts.append(Report::tr("none"));
  if (evaluation.session.journal.empty() && evaluation.journal.empty())
    parts.append(Report::tr("no entry was changed after it was recorded"));
  return Report::clauses(parts);
}

QString entriesText(std::size_t count, bool isJournalPrinted) {
  if (count == 1)
    return isJournalPrinted ? Report::tr("one entry in the journal, see below")
                            : Report::tr("one entry in the journal of the session, left out here");
  return (isJournalPrinted ? Report::tr("%1 entries in the journal, see below")
                           : Report::tr("%1 entries in the journal of the session, left out here"))
      .arg(count);
}

/// Empty without changes.
QString changesText(const Evaluation& evaluation, bool isJournalPrinted) {
  const QString summary = visibleLine(evaluation.journal);
  if (evaluation.session.journal.empty()) return summary;
  const QString entries = entriesText(evaluation.session.journal.size(), isJournalPrinted);
  if (summary.isEmpty()) return entries;
  //: a clause as a sentence
  return Report::sentences({summary, Report::tr("%1.").arg(capitalised(entries))});
}

/// The temperature, and its influence on the lengths.
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
  const auto addChange = [&](const QString& length, double change) {
    if (change == 0) return;
    changes.append(QStringLiteral("%1 %2 mm").arg(length, signedNumberText(change, 3)));
  };
  if (measurement) {
    addChange(QStringLiteral("L"), measurement->distanceExpansion);
    addChange(QStringLiteral("R0"), measurement->radiusExpansion);
  }
  //: %1: the temperature
  if (changes.isEmpty()) return Report::tr("%1; L and R0 without thermal correction").arg(text);
  //: the changes of two lengths: "L 0.101 mm" and "R0 0.032 mm"
  const QString both = changes.size() == 1 ? changes[0] : Report::tr("%1 and %2").arg(changes[0], changes[1]);
  //: %1: the temperature, %2: what L and R0 change by
  return Report::tr("%1; relative to the stated values at 20 °C: %2").arg(text, both);
}

}  // namespace

void addTerms(ReportSheet& sheet, const Gap& gap, const ReportContents& contents) {
  const Evaluation& evaluation = *gap.evaluation;
  sheet.skip(1);
  const std::vector<LabelledText> terms{
      {Report::tr("Measurand"), measurandText(gap)},
      {Report::tr("Decision rule"), ruleText(gap)},
      {Report::tr("Protocol"), protocolText(evaluation.session)},
      {Report::tr("Exclusions"), exclusionsText(evaluation.session)},
      {Report::tr("Corrections"), correctionsText(evaluation)},
      {Report::tr("Changes"), changesText(evaluation, isPrinted(ReportPart::Journal, contents, gap))},
      {Report::tr("Temperature"), temperatureText(evaluation)},
      {Report::tr("Not stated"), listText(emptyReportFields(evaluation.session))},
      {Report::tr("Left out"), listText(leftOutTitles(contents, gap))},
      {Report::tr("Scope"), Report::tr("The results relate only to the item measured. Not to be reproduced "
                                       "except in full.")}};
  sheet.keepTogether(labelledHeight(sheet, terms, ReportSheet::width));
  sheet.skip(placeLabelled(sheet, terms, 0, sheet.y(), ReportSheet::width) - sheet.y());
}

}  // namespace alidade::ui
