#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>

#include "core/statement/tolerance_scale.h"

class QPainter;

namespace alidade::ui {

/// Colours and type of the picture; the font has a pixel size.
struct ToleranceColours {
  QColor text, frame, size, within, beyond;
  QFont font;
};

/// Paints the scale from zero: the size as a bar, the interval as a bracket with a mark at the size, the
/// limit as a line. Size and limit are named below if there is room. Two colours of the ground show what is
/// within and beyond the limit.
void paintToleranceScale(QPainter& painter, const QRectF& area, const ToleranceScale& scale,
                         const ToleranceColours& colours);

/// The height of the scale for this font.
double heightOfToleranceScale(const QFont& font);

}  // namespace alidade::ui
