#include "ui/text/position_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

struct ZeroText {
  Q_DECLARE_TR_FUNCTIONS(ZeroText)
};

QString arcsecondsText(Angle angle) {
  return numberText(angle.arcseconds(), 1) + u'″';
}

QString textOf(const Measurement& measurement, const ArcMeasurement& arc) {
  const ZeroSightings& zero = arc.zero;
  const auto circleText = [&](Angle reading) {
    return QString::fromStdString(formatCircleReading(reading, measurement.angleUnit, 1));
  };
  QString text = ZeroText::tr("Mean of %1 sightings: α0 %2 ± %3, β0 %4 ± %5 (1σ)")
                     .arg(QString::number(zero.count), circleText(arc.zeroHorizontal),
                          arcsecondsText(measurement.sigmaOfZeroHorizontal(arc)),
                          circleText(arc.zeroVertical), arcsecondsText(measurement.sigmaOfZeroVertical(arc)));
  if (zero.moved)
    text += ZeroText::tr("; the zero moved by %1 (α0) and %2 (β0)")
                .arg(arcsecondsText(zero.moved->horizontal), arcsecondsText(zero.moved->vertical));
  if (zero.hasLeftOutFace) text += ZeroText::tr("; without face 2, since not every position has it");
  return text;
}

}  // namespace

QString meanZeroText(const Examined& examined, std::size_t position) {
  if (!examined.measurement) return {};
  const auto& arcs = examined.measurement->arcs;
  const auto found = std::ranges::find(arcs, position, &ArcMeasurement::position);
  if (found == arcs.end() || (found->zero.count == 1 && !found->zero.hasLeftOutFace)) return {};
  return textOf(*examined.measurement, *found);
}

}  // namespace alidade::ui
