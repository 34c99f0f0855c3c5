#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>
#include <QString>
#include <functional>

class QPainter;

namespace alidade::ui {

/// A picture independent of its output: paints itself at (0, 0) in `size`, opaque.
struct PaintedPicture {
  QSize size;
  QString title, description;  ///< for screen readers and viewers without the image
  std::function<void(QPainter*)> paint;
};

/// Returns the image with `scale` pixels per unit.
QImage imageOf(const PaintedPicture& picture, int scale);
/// The image as PNG with title and description. Empty if the image cannot be made.
QByteArray pngOf(const PaintedPicture& picture, int scale);
/// An SVG document in which shapes remain vectors and texts remain texts.
QByteArray svgOf(const PaintedPicture& picture);

}  // namespace alidade::ui
