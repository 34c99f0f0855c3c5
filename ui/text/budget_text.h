#pragma once

#include <QString>
#include <QVector>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade::ui {

/// A line of the budget of Δd, measured, as shown to the user.
struct BudgetLine {
  QString source;
  QString sizes;     ///< 1σ of an effect's numbers: "30″"; else empty
  QString type;      ///< "A" or "B"
  QString from;      ///< source of the size
  double sigma = 0;  ///< mm
};

/// Largest share first; shares below one percent of the variance are combined in the last line.
QVector<BudgetLine> budgetLines(const MeasuredIntersection& measured);

/// A share of the variance: "63.1 %".
QString shareText(double part, double whole);

/// "12", "many" for very large numbers, "∞".
QString degreesOfFreedomText(double degrees);

}  // namespace alidade::ui
