#include "ui/report/report_result.h"

#include <algorithm>
#include <cmath>

#include "core/wording/across.h"
#include "core/wording/budget.h"
#include "ui/report/report_table.h"
#include "ui/text/budget_text.h"
#include "ui/text/cause_text.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/spoken_place.h"
#include "ui/text/verdict_text.h"

namespace alidade::ui {
namespace {

const QColor red(0xb0, 0x00, 0x20);
const QColor pale(0xf2, 0xf2, 0xf2);
constexpr double rowHeight = 4.5;  // mm, about
const TextStyle wordStyle{.points = 15, .bold = true};
const TextStyle valueStyle{.points = 11, .bold = true};

QString percent(double share) {
  return plainNumberText(std::round(share * 1e6) / 1e4) + QStringLiteral(" %");
}

QString toleranceText(const Evaluation& evaluation) {
  const std::optional<double> tolerance = evaluation.examined.measurement->tolerance;
  return tolerance ? QStringLiteral("tolerance ± ") + plainNumberText(*tolerance) + QStringLiteral(" mm")
                   : QStringLiteral("no tolerance stated");
}

/// The result of the measurement, and below it what the fit alone has; without a diagnosis that only.
QStringList intersectionLines(const Gap& gap) {
  const auto& fitted = gap.evaluation->fit.intersection;
  if (!fitted) return {};
  const Measurement& measurement = *gap.evaluation->examined.measurement;
  const QString ofFit = intersectionText(measurement, fitted->value, fitted->expanded);
  const QString tolerance = QStringLiteral("     ") + toleranceText(*gap.evaluation);
  if (!gap.diagnosis) return {ofFit + QStringLiteral(" of the fit alone") + tolerance};
  const MeasuredIntersection* measured = gap.measured();
  const QString first =
      measured ? QStringLiteral("Measured: ") +
                     intersectionText(measurement, measured->estimate.value, measured->estimate.expanded)
               : QStringLiteral("Measured: these readings do not determine Δd");
  return {first + tolerance, QStringLiteral("of the fit alone: ") + ofFit};
}

QString coverageLine(const Gap& gap) {
  const Intersection& fitted = *gap.evaluation->fit.intersection;
  const auto degrees = [](double f) { return QStringLiteral("ν = ") + degreesOfFreedomText(f); };
  const auto u = [](double sigma) { return QStringLiteral("u = ") + lengthText(sigma, decimalsFor(sigma)); };
  QString line = QStringLiteral("U: coverage %1. ").arg(percent(fitted.coverage));
  if (const MeasuredIntersection* measured = gap.measured())
    line += QStringLiteral("As measured: %1, %2. ")
                .arg(u(measured->estimate.sigma), degrees(measured->estimate.degreesOfFreedom));
  return line + QStringLiteral("Of the fit alone: k = %1, %2, %3.")
                    .arg(numberText(fitted.coverageFactor, 2), u(fitted.sigma),
                         degrees(fitted.effectiveDegreesOfFreedom));
}

QString problemText(const Session& session, const Problem& problem) {
  const QString place = spokenPlace(session, problem.where);
  return (place.isEmpty() ? QString() : place + QStringLiteral(": ")) + qText(problem.what);
}

/// Points to the findings, so that a verdict is never read without them.
QString findingsLine(const Gap& gap) {
  const std::vector<Finding> findings = findingsOf(*gap.evaluation);
  const auto serious =
      std::count_if(findings.begin(), findings.end(),
                    [](const Finding& finding) { return finding.severity != Severity::Note; }) +
      (gap.evaluation->suspects.empty() ? 0 : 1) + (gap.isOpen() ? 1 : 0);
  if (serious == 0) return {};
  return serious == 1 ? QStringLiteral("1 finding: see below.")
                      : QStringLiteral("%1 findings: see below.").arg(serious);
}

void addArcs(ReportSheet& sheet, const SessionFit& fit) {
  constexpr auto right = Qt::AlignRight;
  ReportTable table(sheet, {{QStringLiteral("Arc"), 28},
                            {QStringLiteral("x (mm)"), 18, right},
                            {QStringLiteral("u(x)"), 13, right},
                            {QStringLiteral("y (mm)"), 18, right},
                            {QStringLiteral("u(y)"), 13, right},
                            {QStringLiteral("R (mm)"), 20, right},
                            {QStringLiteral("u(R)"), 13, right},
                            {QStringLiteral("n"), 11, right},
                            {QStringLiteral("rms"), 14, right},
                            {QStringLiteral("χ²/f"), 12, right},
                            {QStringLiteral("f"), 10, right}});
  table.head();
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    const ArcFit& arc = fit.arcs[i];
    const ArcSigma& sigma = fit.sigmas[i];
    const int decimals = std::max({decimalsFor(sigma.x), decimalsFor(sigma.y), decimalsFor(sigma.radius)});
    const auto length = [decimals](double value) { return numberText(value, decimals); };
    table.row({QStringLiteral("%1 at %2")
                   .arg(arc.axisDeg == 0 ? QStringLiteral("O1") : QStringLiteral("O2"),
                        positionText(arc.axisDeg, arc.time)),
               length(arc.circle.x), length(sigma.x), length(arc.circle.y), length(sigma.y),
               length(arc.circle.radius), length(sigma.radius), QString::number(arc.residuals.size()),
               arcsecText(arc.residualRms, 2),
               arc.degreesOfFreedom > 0 ? numberText(arc.reducedChiSquare(), 2) : notStated(),
               QString::number(arc.degreesOfFreedom)});
  }
  table.finish();
}

void addBudget(ReportSheet& sheet, const MeasuredIntersection& measured, const QString& attainable,
               double coverage) {
  constexpr auto right = Qt::AlignRight;
  const QVector<BudgetLine> lines = budgetLines(measured);
  const IntersectionEstimate& found = measured.estimate;
  sheet.keepTogether(static_cast<double>(lines.size() + 5) * rowHeight);
  sheet.heading(QStringLiteral("Uncertainty of the intersection as measured"));
  ReportTable table(sheet, {{QStringLiteral("Source"), 62},
                            {QStringLiteral("1σ of its size"), 24, right},
                            {QStringLiteral("type"), 10, right},
                            {QStringLiteral("  from"), 40},
                            {QStringLiteral("u (mm)"), 16, right},
                            {QStringLiteral("of variance"), 18, right}});
  table.head();
  const int decimals = decimalsFor(found.sigma) + 1;
  for (const BudgetLine& line : lines)
    table.row({line.source, line.sizes, line.type,
               line.from.isEmpty() ? QString() : QStringLiteral("  ") + line.from,
               numberText(line.sigma, decimals), shareText(line.sigma, found.sigma)});
  const TextStyle bold = type::body.inBold();
  table.row({{QStringLiteral("combined standard uncertainty u"), bold},
             {},
             {},
             {},
             {numberText(found.sigma, decimals), bold},
             {QStringLiteral("100.0 %"), bold}});
  table.row({{QStringLiteral("expanded uncertainty U (%1)").arg(percent(coverage)), bold},
             {},
             {},
             {},
             {numberText(found.expanded, decimals), bold},
             {}});
  table.finish();
  sheet.paragraph(
      QStringLiteral(
          "Every effect of the catalogue takes part, as large as these readings and what is "
          "plausible leave it. Type A: by the scatter of these readings; B: by other knowledge. ") +
          attainable,
      type::small);
}

void addBudget(ReportSheet& sheet, const Intersection& found) {
  constexpr auto right = Qt::AlignRight;
  sheet.keepTogether(static_cast<double>(found.budget.size() + 4) * rowHeight);
  sheet.heading(QStringLiteral("Uncertainty of the intersection of the fit alone"));
  ReportTable table(sheet, {{QStringLiteral("Source"), 62},
                            {QStringLiteral("u (mm)"), 26, right},
                            {QStringLiteral("share of variance"), 34, right}});
  table.head();
  const int decimals = decimalsFor(found.sigma) + 1;
  for (const BudgetEntry& entry : found.budget)
    table.row({qText(textOf(entry.source)), numberText(entry.sigma, decimals),
               shareText(entry.sigma, found.sigma)});
  const TextStyle bold = type::body.inBold();
  table.row({{QStringLiteral("combined standard uncertainty u"), bold},
             {numberText(found.sigma, decimals), bold},
             {QStringLiteral("100.0 %"), bold}});
  table.row({{QStringLiteral("expanded uncertainty U (%1)").arg(percent(found.coverage)), bold},
             {numberText(found.expanded, decimals), bold},
             {}});
  table.finish();
}

void addEffects(ReportSheet& sheet, const std::vector<EffectEstimate>& effects) {
  if (effects.empty()) return;
  constexpr auto right = Qt::AlignRight;
  sheet.keepTogether((static_cast<double>(effects.size()) + 3) * 4.5);
  sheet.heading(QStringLiteral("Model effects"));
  ReportTable table(sheet, {{QStringLiteral("Estimated along with the arcs"), 80},
                            {QStringLiteral("value"), 30, right},
                            {QStringLiteral("u"), 30, right},
                            {QStringLiteral("unit"), 16, right}});
  table.head();
  for (const EffectEstimate& estimate : effects) {
    const int decimals = decimalsFor(estimate.sigma);
    table.row({effectText(estimate), numberText(estimate.value, decimals),
               numberText(estimate.sigma, decimals), effectUnitText(estimate)});
  }
  table.finish();
}

QString errorText(const QString& name, const InstrumentError& error) {
  return name + QStringLiteral(" = ") +
         withStandardUncertainty(error.value.arcseconds(), error.sigma.arcseconds(), QStringLiteral("″"));
}

/// What the differences of the faces say about the instrument, in a sentence.
void addTwoFaces(ReportSheet& sheet, const TwoFaces& faces) {
  QStringList parts{errorText(QStringLiteral("collimation c"), faces.collimation)};
  if (faces.trunnionTilt) parts << errorText(QStringLiteral("trunnion tilt i"), *faces.trunnionTilt);
  parts << errorText(QStringLiteral("vertical index j"), faces.index);
  QString text =
      QStringLiteral("Both faces, %1 visits: ").arg(faces.visits.size()) + parts.join(QStringLiteral(", "));
  if (faces.horizontal.degreesOfFreedom > 0 && faces.vertical.degreesOfFreedom > 0)
    text += QStringLiteral("; scatter against the stated σ: horizontal × %1, vertical × %2")
                .arg(numberText(faces.horizontal.ratio(), 2), numberText(faces.vertical.ratio(), 2));
  sheet.skip(1);
  sheet.paragraph(text + u'.');
}

/// What lies across the plane, unless the verdict tells it.
QString acrossText(const Gap& gap) {
  const MeasuredIntersection* measured = gap.measured();
  if (!measured || verdictText(*gap.evaluation, gap.found()).tellsAcross) return {};
  return u' ' + qText(acrossSentence(*measured));
}

/// Where one is given, against the result of the measurement, where there is one.
void addReference(ReportSheet& sheet, const Gap& gap) {
  const Measurement& measurement = *gap.evaluation->examined.measurement;
  const std::optional<double> reference = measurement.referenceIntersection;
  if (!reference) return;
  const std::optional<double> sigma = measurement.sigmaReference;
  const MeasuredIntersection* measured = gap.measured();
  const IntersectionEstimate found =
      measured ? measured->estimate : estimateOf(*gap.evaluation->fit.intersection);
  sheet.paragraph(
      QStringLiteral("Reference (never enters the fit): %1 mm%2; Δd − reference = %3 %4")
          .arg(plainNumberText(*reference),
               sigma ? QStringLiteral(" (u %1 mm)").arg(plainNumberText(*sigma)) : QString(),
               valueWithUncertainty(found.value - *reference, found.expanded, QStringLiteral("mm")),
               measured ? QStringLiteral("as measured") : QStringLiteral("of the fit alone")));
}

}  // namespace

void addVerdict(ReportSheet& sheet, const Gap& gap) {
  constexpr double inset = 3;
  const Evaluation& evaluation = *gap.evaluation;
  const VerdictText verdict = verdictText(evaluation, gap.found());
  const double inner = ReportSheet::width - 2 * inset;
  struct Part {
    QStringList lines;
    TextStyle style;
  };
  std::vector<Part> parts{{sheet.lines(verdict.word, wordStyle, inner), wordStyle}};
  for (const QString& line : intersectionLines(gap))
    parts.push_back({sheet.lines(line, valueStyle, inner), valueStyle});
  parts.push_back({sheet.lines(verdict.sentence, type::body, inner), type::body});
  if (evaluation.fit.intersection)
    parts.push_back({sheet.lines(coverageLine(gap), type::label, inner), type::label});
  const QString unseen = unseenBeyondUText(gap);
  if (!unseen.isEmpty()) parts.push_back({sheet.lines(unseen, type::body, inner), type::body});
  const QString findings = findingsLine(gap);
  if (!findings.isEmpty()) parts.push_back({{findings}, type::body.inBold()});
  double height = inset;
  for (const Part& part : parts) height += part.lines.size() * sheet.lineHeight(part.style) + 0.4;
  sheet.skip(3.5);
  sheet.keepTogether(height + 2);
  const QRectF box(0, sheet.y(), ReportSheet::width, height);
  sheet.fill(box, pale);
  sheet.outline(box, verdict.verdict == Verdict::Accept ? 0.4 : 0.8);
  double top = sheet.y() + inset / 2;
  for (const Part& part : parts) {
    for (const QString& line : part.lines) {
      sheet.text(line, part.style, inset, top, inner);
      top += sheet.lineHeight(part.style);
    }
    top += 0.4;
  }
  sheet.skip(height + 1.5);
}

void addProblems(ReportSheet& sheet, const Evaluation& evaluation) {
  if (evaluation.examined.problems.empty()) return;
  const TextStyle style = type::body.inBold().inColour(red);
  sheet.heading(QStringLiteral("Entries that could not be used"));
  const auto bar = [&](double top, double bottom) { sheet.rule(0.5, top, 0.5, bottom, 1, red); };
  for (const Problem& problem : evaluation.examined.problems) {
    const QStringList lines =
        sheet.lines(problemText(evaluation.session, problem), style, ReportSheet::width - 4);
    const double height = lines.size() * sheet.lineHeight(style);
    sheet.keepTogether(height);
    if (&problem != &evaluation.examined.problems.front()) sheet.mayBreak();
    bar(sheet.y(), sheet.y() + height);
    for (const QString& line : lines) {
      sheet.text(line, style, 4, sheet.y(), ReportSheet::width - 4);
      sheet.skip(sheet.lineHeight(style));
    }
  }
}

void addResult(ReportSheet& sheet, const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  const SessionFit& fit = evaluation.fit;
  sheet.heading(QStringLiteral("Arc centres and radii"));
  if (fit.arcs.empty()) {
    sheet.paragraph(QStringLiteral("No arc could be fitted."));
    return;
  }
  addArcs(sheet, fit);
  sheet.paragraph(
      QStringLiteral(
          "Lengths in mm; u: standard uncertainty, scaled by s0 = %1; n: sightings; rms: of all residuals; "
          "χ²/f: with the stated σ; f: redundancy.%2")
          .arg(numberText(fit.noise.factor, 2),
               hasRepeats(*evaluation.examined.measurement)
                   ? QStringLiteral(
                         " Positions at the same axis have one centre and radius, which their f leave out.")
                   : QString()),
      type::small);
  addEffects(sheet, fit.effects);
  if (evaluation.twoFaces) addTwoFaces(sheet, *evaluation.twoFaces);
  if (!fit.intersection) return;
  sheet.skip(1);
  sheet.paragraph(QStringLiteral("Half the distance of the centres in the plane, |O1 − O2|/2 = ") +
                  valueWithUncertainty(fit.intersection->inPlane, fit.intersection->inPlaneExpanded,
                                       QStringLiteral("mm")) +
                  u'.' + acrossText(gap));
  addReference(sheet, gap);
}

void addUncertainty(ReportSheet& sheet, const Gap& gap) {
  const auto& fitted = gap.evaluation->fit.intersection;
  if (!fitted) return;
  if (const MeasuredIntersection* measured = gap.measured())
    addBudget(sheet, *measured, attainableText(gap), fitted->coverage);
  addBudget(sheet, *fitted);
}

}  // namespace alidade::ui
