#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>
#include <QString>
#include <functional>

class QPainter;

namespace alidade::ui {

/// A picture as it can be written anywhere: paints itself at (0, 0) in `size`, opaque.
struct PaintedPicture {
  QSize size;
  QString title, description;  ///< for those who cannot see it
  std::function<void(QPainter*)> paint;
};

/// With `scale` pixels to a unit.
QImage imageOf(const PaintedPicture& picture, int scale);
/// The image as PNG, title and description in it. Empty where it cannot be made.
QByteArray pngOf(const PaintedPicture& picture, int scale);
/// An SVG document, shapes and texts kept as such.
QByteArray svgOf(const PaintedPicture& picture);

}  // namespace alidade::ui
