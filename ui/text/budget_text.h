#pragma once

#include <QString>
#include <QVector>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade::ui {

/// A line of the budget of Δd as it was measured, for people.
struct BudgetLine {
  QString source;
  QString sizes;     ///< 1σ of an effect's numbers: "30″"; else empty
  QString type;      ///< "A" or "B"
  QString from;      ///< where the size comes from
  double sigma = 0;  ///< mm
};

/// The greatest share first; those below one percent of the variance together in the last line.
QVector<BudgetLine> budgetLines(const MeasuredIntersection& measured);

/// "63.1 %": of the variance.
QString shareText(double part, double whole);

/// "12", "many" beyond counting, "∞".
QString degreesOfFreedomText(double degrees);

}  // namespace alidade::ui
