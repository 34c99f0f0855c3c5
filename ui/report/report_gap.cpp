#include "ui/report/report_parts.h"

#include <algorithm>

#include "core/wording/beyond.h"
#include "core/wording/closures.h"
#include "core/wording/measure.h"
#include "core/wording/verdict.h"
#include "ui/report/report_table.h"
#include "ui/report/report_text.h"
#include "ui/text/cause_text.h"
#include "ui/text/closure_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

void addStages(ReportSheet& sheet, const Gap& gap) {
  constexpr auto right = Qt::AlignRight;
  ReportTable table(sheet, {{Report::tr("Model"), 78},
                            {Report::tr("rms"), 20, right},
                            {QStringLiteral("χ²/f"), 20, right},
                            {QStringLiteral("Δd ± U (mm)"), 38, right}});
  table.head();
  for (const GapStage& stage : gap.stages)
    table.row({stageText(gap, stage), arcsecText(stage.rms, 2), numberText(stage.reducedChiSquare, 2),
               estimateText(stage.intersection)});
  if (const std::string beyond = textOf(beyondTheFit(*gap.diagnosis)); !beyond.empty())
    table.row({QString::fromStdString(beyond), arcsecText(gap.diagnosis->after.rms, 2),
               numberText(gap.diagnosis->after.reducedChiSquare, 2),
               estimateText(gap.diagnosis->afterwards)});
  const MeasuredIntersection* measured = gap.measured();
  table.row({Report::tr("measured: every effect at its plausible size"), notStated(), notStated(),
             estimateText(measured ? std::optional(measured->estimate) : std::nullopt)});
  table.finish();
}

/// The assumptions of the probabilities, with the plausible sizes.
QString probabilityNote(const Diagnosis& diagnosis) {
  QStringList sizes;
  for (const Cause& cause : diagnosis.causes)
    if (const QString size = plausibleText(cause.effect); !size.isEmpty())
      sizes.append(causeName(cause.effect) + u' ' + size);
  if (sizes.isEmpty())
    return Report::tr("Probabilities: given the catalogue and how large its effects plausibly are.");
  //: %1: effects with their sizes, "collimation 30″, refraction 2″"
  return Report::tr("Probabilities: given the catalogue and how large its effects plausibly are (1σ: %1).")
      .arg(Report::list(sizes));
}

/// "Collimation, −3.53″ (u 0.17); probability 79 %."
QString causeLine(const Cause& cause) {
  QStringList parts{causeTitle(cause.effect)};
  for (const CauseParameter& parameter : cause.parameters)
    if (parameter.sigma > 0) parts.append(parameterText(cause, parameter));
  for (const ReadingDeviation& reading : cause.readings) parts.append(deviationText(reading));
  //: %1: a cause with its numbers
  return Report::tr("%1; probability %2.")
      .arg(Report::clauses(parts), qText(shortProbabilityText(cause.probability)));
}

/// A lower bound of the section's height, in mm.
double heightOf(const ReportSheet& sheet, const Gap& gap) {
  const double line = sheet.lineHeight(type::body), row = line + 1.5;
  auto lines = sheet.lines(gapSentence(gap), type::body, ReportSheet::width).size() + 1;
  for (const Cause& cause : gap.diagnosis->causes)
    lines += sheet.lines(causeLine(cause), type::body, ReportSheet::width - 8).size();
  return 16 + static_cast<double>(lines) * line + static_cast<double>(gap.stages.size() + 2) * row;
}

void addClosureTable(ReportSheet& sheet, const Gap& gap) {
  constexpr auto right = Qt::AlignRight;
  const double coverage = gap.evaluation->examined.measurement->coverage;
  const bool hasCauses = !gap.diagnosis->causes.empty();
  std::vector<ReportColumn> columns{{Report::tr("Closure"), 46},
                                    {Report::tr("as modelled ± U"), 38, right},
                                    {Report::tr("size"), 20, right}};
  if (hasCauses) {
    columns.push_back({Report::tr("with the causes ± U"), 42, right});
    columns.push_back({Report::tr("size"), 20, right});
  }
  ReportTable table(sheet, columns);
  table.head();
  for (const ClosureStep& step : gap.diagnosis->closures) {
    const TextStyle style = step.isOpen() ? type::body.inBold() : type::body;
    std::vector<ReportCell> cells{{qText(nameInWords(step.before)), style},
                                  {closureText(step.before, coverage), style},
                                  {closureSigmasText(step.before), style}};
    if (hasCauses) {
      cells.emplace_back(step.after ? closureText(*step.after, coverage) : notStated(), style);
      cells.emplace_back(step.after ? closureSigmasText(*step.after) : notStated(), style);
    }
    table.row(cells);
  }
  table.finish();
}

/// A lower bound of the height of heading, table and sentence, in mm.
double closuresHeight(const ReportSheet& sheet, const Gap& gap, const QString& sentence) {
  const double line = sheet.lineHeight(type::body);
  const auto lines = sheet.lines(sentence, type::body, ReportSheet::width).size();
  return 16 + static_cast<double>(lines) * line +
         static_cast<double>(gap.diagnosis->closures.size() + 1) * (line + 1.5);
}

void addRequired(ReportSheet& sheet, const std::vector<Required>& list) {
  if (list.empty()) return;
  constexpr auto right = Qt::AlignRight;
  const double row = sheet.lineHeight(type::body) + 1.5;
  sheet.keepTogether(std::min(20 + static_cast<double>(list.size() + 1) * row, sheet.height() / 2));
  sheet.heading(Report::tr("What it would take to explain Δd − reference"));
  ReportTable table(sheet, {{Report::tr("Effect"), 70},
                            {Report::tr("size"), 26, right},
                            {Report::tr("plausible sizes"), 32, right},
                            {Report::tr("leaves (σ)"), 28, right}});
  table.head();
  for (const Required& required : list)
    table.row({causeTitle(required.effect), requiredSizeText(required), plausibleSizesText(required),
               numberText(required.visibleSigma, 1)});
  table.finish();
  sheet.paragraph(Report::tr("Each by itself, of the effects that these readings do not exclude at that "
                             "size; leaves: what it would leave in these readings."),
                  type::small);
}

}  // namespace

void addGap(ReportSheet& sheet, const Gap& gap) {
  if (!gap.diagnosis || gap.isNoiseAlone() || (!gap.isOpen() && gap.stages.size() < 2)) return;
  sheet.keepTogether(std::min(heightOf(sheet, gap), sheet.height() / 2));
  sheet.heading(Report::tr("Gap between model and readings"));
  //: a headline as a sentence
  sheet.paragraph(Report::tr("%1.").arg(gapHeadline(*gap.diagnosis)), type::body.inBold());
  sheet.paragraph(gapSentence(gap));
  for (const Cause& cause : gap.diagnosis->causes)
    sheet.paragraph(QStringLiteral("– ") + causeLine(cause), type::body, 3);
  if (!gap.diagnosis->causes.empty()) sheet.paragraph(probabilityNote(*gap.diagnosis), type::small);
  sheet.skip(1);
  addStages(sheet, gap);
  if (gap.isOpen())
    sheet.paragraph(
        Report::tr(
            "The figures of this report are those of the model as it is, but for what is said to be "
            "measured; nothing was added or left out because of the diagnosis. The verdict stands only where "
            "both accounts say so."),
        type::small);
}

void addClosures(ReportSheet& sheet, const Gap& gap) {
  if (!gap.diagnosis || gap.diagnosis->closures.empty()) return;
  const QString open = qText(misclosureSentence(*gap.diagnosis));
  sheet.keepTogether(closuresHeight(sheet, gap, open));
  sheet.heading(Report::tr("Closures: what must agree"));
  addClosureTable(sheet, gap);
  const Measurement& measurement = *gap.evaluation->examined.measurement;
  const QString says =
      hasRepeats(measurement)
          ? Report::tr(
                "Half a turn of one rigid arc about an axis along x keeps its radius and leaves the "
                "centre's x alone; an arc measured again is where it was; R0 and the reference count "
                "where their σ is stated. U at %1 %.")
          : Report::tr(
                "Half a turn of one rigid arc about an axis along x keeps its radius and leaves the "
                "centre's x alone; R0 and the reference count where their σ is stated. U at %1 %.");
  sheet.paragraph(says.arg(plainNumberText(100 * measurement.coverage)), type::small);
  if (!open.isEmpty()) sheet.paragraph(open);
  addRequired(sheet, gap.diagnosis->whatItWouldTake);
}

void addUndetectable(ReportSheet& sheet, const Gap& gap) {
  const std::vector<UndetectableEffect> undetectable = gap.noticeablyUndetectable();
  if (undetectable.empty()) return;
  QStringList measures;
  for (const Advice& advice : gap.diagnosis->advice)
    if (advice.ofUndetectable) measures.append(qText(textOf(advice.measures)));
  QStringList sentences{
      Report::tr(
          "The following effects are undetectable in these readings. U of Δd, fit only, does not include "
          "them; U of Δd, measured, includes what its budget lists. A plausible size of each would move "
          "Δd by: %1.")
          .arg(undetectableText(undetectable))};
  if (!measures.isEmpty())
    sentences.append(
        Report::tr("Further readings would show some of them: %1.").arg(Report::clauses(measures)));
  const QString text = Report::sentences(sentences);
  const auto lines = sheet.lines(text, type::body, ReportSheet::width).size();
  sheet.keepTogether(16 + static_cast<double>(lines) * sheet.lineHeight(type::body));
  sheet.heading(Report::tr("What these readings would not show"));
  sheet.paragraph(text);
}

}  // namespace alidade::ui
