#pragma once

#include <QString>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade::ui {

/// U of a misclosure at `coverage`, mm. Treats its σ as exactly known.
double expandedOf(const Closure& closure, double coverage);

/// "1.96 ± 0.55 mm".
QString closureText(const Closure& closure, double coverage);
/// "7.0 σ".
QString closureSigmasText(const Closure& closure);

/// "12.3″", "5.8 mm": the size with two digits, without a sign for numbers in two directions.
QString requiredSizeText(const Required& required);
/// "2.4", "< 0.1": the same in plausible sizes.
QString plausibleSizesText(const Required& required);

}  // namespace alidade::ui
