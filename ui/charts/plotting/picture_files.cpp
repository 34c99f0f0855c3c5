#include "ui/charts/plotting/picture_files.h"

#include <QBuffer>
#include <QPainter>
#include <QSvgGenerator>

namespace alidade::ui {

QImage imageOf(const PaintedPicture& picture, int scale) {
  QImage image(picture.size * scale, QImage::Format_ARGB32_Premultiplied);
  if (image.isNull()) return image;
  image.setDevicePixelRatio(scale);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  picture.paint(&painter);
  return image;
}

QByteArray pngOf(const PaintedPicture& picture, int scale) {
  QImage image = imageOf(picture, scale);
  image.setText(QStringLiteral("Title"), picture.title);
  image.setText(QStringLiteral("Description"), picture.description);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG")) bytes.clear();
  return bytes;
}

QByteArray svgOf(const PaintedPicture& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setSize(picture.size);
  svg.setViewBox(QRect({}, picture.size));
  svg.setResolution(96);
  svg.setTitle(picture.title);
  svg.setDescription(picture.description);
  QPainter painter(&svg);
  picture.paint(&painter);
  painter.end();
  return bytes;
}

}  // namespace alidade::ui
