#pragma once

#include <QLineF>
#include <QList>
#include <QPointF>
#include <QRectF>
#include <optional>

namespace alidade::ui {

// What leaves a frame is cut here, not by the painter alone: an SVG picture of Qt 6.4 knows no clip.

/// The part of a line inside `frame`; absent where none is, or where an end is not finite.
std::optional<QLineF> clipped(const QLineF& line, const QRectF& frame);

/// The pieces of a polyline inside `frame`, in its order.
QList<QList<QPointF>> clipped(const QList<QPointF>& polyline, const QRectF& frame);

}  // namespace alidade::ui
