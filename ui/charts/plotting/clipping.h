#pragma once

#include <QLineF>
#include <QList>
#include <QPointF>
#include <QRectF>
#include <optional>

namespace alidade::ui {

// Lines are clipped here as well as by the painter, since SVG pictures of Qt 6.4 do not support clipping.

/// The part of a line inside `frame`; absent if no part is inside, or if an end is not finite.
std::optional<QLineF> clipped(const QLineF& line, const QRectF& frame);

/// The pieces of a polyline inside `frame`, in its order.
QList<QList<QPointF>> clipped(const QList<QPointF>& polyline, const QRectF& frame);

}  // namespace alidade::ui
