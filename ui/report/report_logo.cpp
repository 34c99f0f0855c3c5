#include "ui/report/report_logo.h"

#include <QFileInfo>
#include <QImageReader>
#include <QPainter>

#include "ui/report/report_text.h"

namespace alidade::ui {

namespace {

constexpr QSize most(1400, 350);  // pixels, for 600 dots per inch on the sheet

Problem refused(const QString& text) {
  return Problem{text.toStdString()};
}

}  // namespace

Result<QImage> readLogo(const QString& path) {
  if (!QFileInfo(path).isFile())
    return refused(Report::tr("the logo “%1” cannot be used: there is no such file").arg(path));
  QImageReader reader(path);
  reader.setDecideFormatFromContent(true);
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  const bool isLarger = size.width() > most.width() || size.height() > most.height();
  if (size.isValid() && (isLarger || reader.format() == "svg"))
    reader.setScaledSize(size.scaled(most, Qt::KeepAspectRatio));
  QImage read = reader.read();
  if (read.isNull())
    return refused(Report::tr("the logo “%1” cannot be used: %2").arg(path, reader.errorString()));
  if (read.width() > most.width() || read.height() > most.height())
    read = read.scaled(most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  QImage logo(read.size(), QImage::Format_RGB32);
  logo.fill(Qt::white);
  QPainter(&logo).drawImage(0, 0, read);
  return logo;
}

}  // namespace alidade::ui
