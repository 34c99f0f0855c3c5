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

using Kind = FormulaVariable::Kind;

QString variableTitle(const FormulaVariable* variable) {
  if (!variable) return OwnEffectCurve::tr("sighting of the session");
  const QString name = qText(std::string(variable->name));
  return variable->kind == Kind::Angle ? name + QStringLiteral(" (°)") : name;
}

bool isCounted(const OwnCurve& curve) {
  return curve.variable && curve.variable->kind == Kind::Counted;
}

/// A line over a continuous variable; otherwise dots.
QXYSeries* seriesOf(const OwnCurve& curve, const QColor& colour, const PlotStyle& style) {
  const bool isLine = curve.variable && !isCounted(curve);
  QXYSeries* series = isLine ? static_cast<QXYSeries*>(new QLineSeries) : new QScatterSeries;
  for (const auto& [x, y] : curve.points) series->append(x, y);
  series->setName(qText(std::string(nameOf(curve.carrier))));
  series->setPen(isLine ? QPen(colour, 2 * style.unit()) : QPen(Qt::NoPen));
  series->setBrush(colour);
  if (auto* dots = qobject_cast<QScatterSeries*>(series))
    dots->setMarkerSize((isCounted(curve) ? 8 : 4) * style.unit());
  return series;
}

/// `isOpen`: extends the range at both ends, so that no point lies on the frame.
void layOut(QValueAxis& axis, const QString& title, const PlotStyle& style, bool isOpen) {
  axis.setTitleText(title);
  axis.setTitleBrush(style.mutedText);
  axis.setTitleFont(style.font);
  axis.setLabelsBrush(style.text);
  axis.setLabelsFont(style.font);
  axis.setGridLineColor(style.grid);
  axis.setLinePenColor(style.frame);
  const double beside = isOpen ? 0.05 * (axis.max() - axis.min()) : 0;
  axis.setRange(axis.min() - beside, axis.max() + beside);
  axis.applyNiceNumbers();
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
  for (QAbstractAxis* axis : chart()->axes()) {
    chart()->removeAxis(axis);
    delete axis;
  }
  chart()->setBackgroundBrush(style.background);
  for (const OwnCurve& curve : curves)
    if (!curve.points.empty() && unitOf(curve.carrier) == unitOf(curves.front().carrier))
      chart()->addSeries(seriesOf(curve, chart()->series().isEmpty() ? style.upper : style.lower, style));
  chart()->legend()->setVisible(chart()->series().size() > 1);
  chart()->legend()->setLabelColor(style.text);
  chart()->setTitleBrush(style.mutedText);
  chart()->setTitle(chart()->series().isEmpty() ? tr("The curve appears once the formula is correct.")
                                                : QString());
  if (chart()->series().isEmpty()) return;
  chart()->createDefaultAxes();
  const QList<QAbstractSeries*> all = chart()->series();
  layOut(*qobject_cast<QValueAxis*>(chart()->axes(Qt::Horizontal)[0]), variableTitle(curves.front().variable),
         style, isCounted(curves.front()));
  layOut(*qobject_cast<QValueAxis*>(chart()->axes(Qt::Vertical)[0]),
         QStringLiteral("%1 (%2)").arg(all.size() == 1 ? all[0]->name() : tr("size"),
                                       unitText(std::string(unitOf(curves.front().carrier)))),
         style, true);
}

}  // namespace alidade::ui
