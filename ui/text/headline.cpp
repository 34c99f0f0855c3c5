#include "ui/text/headline.h"

#include <QCoreApplication>

#include "core/wording/across.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

struct HeadlineText {
  Q_DECLARE_TR_FUNCTIONS(HeadlineText)
};

//: a name and what it is: "Δd, measured: 1.30 ± 0.74 mm"
QString named(const QString& name, const QString& what) {
  return HeadlineText::tr("%1: %2").arg(name, what);
}

QString measuredName() {
  return HeadlineText::tr("Δd, measured");
}

QString fitOnlyName() {
  return HeadlineText::tr("Δd, fit only");
}

QString toleranceText(const Evaluation& evaluation) {
  const auto& measurement = evaluation.examined.measurement;
  if (!measurement || !measurement->tolerance) return {};
  const QString size = plainNumberText(*measurement->tolerance);
  return measurement->measurand == Measurand::Distance
             ? HeadlineText::tr("Tolerance of the distance d: %1 mm").arg(size)
             : HeadlineText::tr("Tolerance ± %1 mm").arg(size);
}

QString exactly(double value, double expanded) {
  return HeadlineText::tr("Δd = %1 mm, U = %2 mm").arg(numberText(value, 6), numberText(expanded, 6));
}

QString referenceText(const Measurement& measurement, double value) {
  if (!measurement.referenceIntersection) return {};
  return HeadlineText::tr("Reference %1, difference %2")
      .arg(lengthText(*measurement.referenceIntersection, 3),
           lengthText(value - *measurement.referenceIntersection, 3));
}

/// Everything except the figure itself and the verdict.
Headline frameOf(const Evaluation& evaluation) {
  Headline headline;
  headline.name = measuredName();
  headline.figure = notStated();
  headline.tolerance = toleranceText(evaluation);
  const auto& fitted = evaluation.fit.intersection;
  if (!fitted) return headline;
  const Measurement& measurement = *evaluation.examined.measurement;
  headline.fitOnly = named(fitOnlyName(), intersectionText(measurement, fitted->value, fitted->expanded));
  headline.fitOnlyDetails =
      HeadlineText::tr("U at %1 % coverage (k = %2); u = %3")
          .arg(plainNumberText(fitted->coverage * 100), numberText(fitted->coverageFactor, 2),
               lengthText(fitted->sigma, decimalsFor(fitted->sigma)));
  headline.reference = referenceText(measurement, fitted->value);
  return headline;
}

QString measuredTip(const Measurement& measurement, const MeasuredIntersection& measured) {
  return HeadlineText::tr(
             "%1 at %2 % coverage.\nIncludes every catalogued effect, limited by these readings or by its "
             "plausible size. The page Budget lists what each contributes.\n%3")
      .arg(exactly(measured.estimate.value, measured.estimate.expanded),
           plainNumberText(100 * measurement.coverage), qText(acrossSentence(measured)));
}

}  // namespace

QString Headline::nameAndFigure() const {
  return named(name, figure);
}

QString Headline::toleranceAndVerdict() const {
  return tolerance.isEmpty() ? verdict.word : tolerance + QStringLiteral(" · ") + verdict.word;
}

Headline headlineOf(const Evaluation& evaluation) {
  Headline headline = frameOf(evaluation);
  headline.verdict = provisionalVerdict(evaluation);
  const auto& fitted = evaluation.fit.intersection;
  if (!fitted) return headline;
  headline.name = fitOnlyName();
  headline.figure = intersectionText(*evaluation.examined.measurement, fitted->value, fitted->expanded);
  headline.tip = exactly(fitted->value, fitted->expanded);
  headline.isProvisional = true;
  return headline;
}

Headline headlineOf(const Gap& gap) {
  Headline headline = frameOf(*gap.evaluation);
  headline.verdict = verdictText(*gap.evaluation, gap.found());
  if (!gap.evaluation->fit.intersection) return headline;
  const MeasuredIntersection* measured = gap.measured();
  if (!measured) {
    headline.figure = gap.diagnosis ? HeadlineText::tr("not determined by these readings")
                                    : HeadlineText::tr("no diagnosis was made");
    headline.tip = qText(gap.reason);
    return headline;
  }
  const Measurement& measurement = *gap.evaluation->examined.measurement;
  const IntersectionEstimate& found = measured->estimate;
  headline.isMeasured = true;
  headline.figure = intersectionText(measurement, found.value, found.expanded);
  headline.tip = measuredTip(measurement, *measured);
  headline.reference = referenceText(measurement, found.value);
  return headline;
}

}  // namespace alidade::ui
