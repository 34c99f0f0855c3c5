#include "ui/charts/gap/own_effect_curve.h"

#include <QtCharts/QChart>
#include <QtCharts/QLineSeries>
#include <QtCharts/QScatterSeries>
#include <QtCharts/QValueAxis>

#include "core/terms/formula.h"
#include "ui/charts/plotting/plot_style.h"
#include "ui/text/effect_text.h"

namespace alidade::ui {

namespace {

constexpr std::size_t fewPoints = 12;  // leg, face, rounds: no line joins them

QString variableTitle(std::string_view variable) {
  if (variable.empty()) return OwnEffectCurve::tr("sighting of the session");
  const bool isAngle = variable != "t" && variable != "leg" && variable != "round" && variable != "face" &&
                       variable != "position";
  const QString name = qText(std::string(variable));
  return isAngle ? name + QStringLiteral(" (°)") : name;
}

}  // namespace

OwnEffectCurve::OwnEffectCurve(QWidget* parent) : QChartView(new QChart, parent) {
  setRenderHint(QPainter::Antialiasing);
  setAccessibleName(tr("Curve of the effect"));
  setMinimumHeight(sizeHint().height());
  setFocusPolicy(Qt::NoFocus);
  chart()->setMargins({});
  chart()->layout()->setContentsMargins(0, 0, 0, 0);
  chart()->setBackgroundRoundness(0);
  setCurves({});
}

void OwnEffectCurve::setCurves(const std::vector<OwnCurve>& curves) {
  const PlotStyle style = screenStyle(palette(), font());
  chart()->removeAllSeries();
  for (QAbstractAxis* axis : chart()->axes()) chart()->removeAxis(axis);
  chart()->setBackgroundBrush(style.background);
  QStringList carriers;
  for (const OwnCurve& curve : curves) {
    if (curve.points.empty() || unitOf(curve.carrier) != unitOf(curves.front().carrier)) continue;
    carriers.append(qText(std::string(nameOf(curve.carrier))));
    const bool isFew = curve.points.size() < fewPoints;
    QXYSeries* series = isFew ? static_cast<QXYSeries*>(new QScatterSeries) : new QLineSeries;
    if (auto* dots = qobject_cast<QScatterSeries*>(series)) dots->setMarkerSize(8 * style.unit());
    for (const auto& [x, y] : curve.points) series->append(x, y);
    series->setName(carriers.last());
    const QColor colour = chart()->series().isEmpty() ? style.upper : style.lower;
    series->setPen(QPen(colour, 2 * style.unit()));
    series->setBrush(colour);
    chart()->addSeries(series);
  }
  chart()->legend()->setVisible(chart()->series().size() > 1);
  chart()->legend()->setLabelColor(style.text);
  chart()->setTitleBrush(style.mutedText);
  chart()->setTitle(chart()->series().isEmpty() ? tr("A curve appears once the formula is sound.")
                                                : QString());
  if (chart()->series().isEmpty()) return;
  chart()->createDefaultAxes();
  const QStringList titles = {
      variableTitle(curves.front().variable),
      QStringLiteral("%1 (%2)").arg(carriers.join(QStringLiteral(", ")),
                                    unitText(std::string(unitOf(curves.front().carrier))))};
  for (QAbstractAxis* axis : chart()->axes()) {
    axis->setTitleText(titles[axis->orientation() == Qt::Horizontal ? 0 : 1]);
    axis->setTitleBrush(style.mutedText);
    axis->setTitleFont(style.font);
    axis->setLabelsBrush(style.text);
    axis->setLabelsFont(style.font);
    axis->setGridLineColor(style.grid);
    axis->setLinePenColor(style.frame);
    auto* values = qobject_cast<QValueAxis*>(axis);
    const double beside = 0.05 * (values->max() - values->min());
    values->setRange(values->min() - beside, values->max() + beside);
    values->applyNiceNumbers();
  }
}

}  // namespace alidade::ui
