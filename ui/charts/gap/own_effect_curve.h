#pragma once

#include <QtCharts/QChartView>
#include <vector>

#include "core/diagnosis/own_effect_curve.h"

namespace alidade::ui {

/// The displacements by a user's own effect at its plausible sizes, a line for each carrier.
class OwnEffectCurve : public QChartView {
  Q_OBJECT

 public:
  explicit OwnEffectCurve(QWidget* parent = nullptr);

  /// Lines in mm and in arcseconds cannot share a picture: the unit of the first curve decides which
  /// lines are shown. Without points the picture says why it is empty.
  void setCurves(const std::vector<OwnCurve>& curves);

  QSize sizeHint() const override { return {420, 190}; }
};

}  // namespace alidade::ui
