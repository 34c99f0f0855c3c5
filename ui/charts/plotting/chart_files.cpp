#include "ui/charts/plotting/chart_files.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QWidget>

namespace alidade::ui {
namespace {

constexpr int pixelsPerUnit = 2;

}  // namespace

ChartFiles::ChartFiles(ChartSource& source, QWidget* chart) : QObject(chart), m_source(source) {}

void ChartFiles::addTo(QMenu& menu) {
  menu.addAction(tr("&Copy Picture\tCtrl+C"), this, &ChartFiles::copy);
  const auto offer = [&](const QString& text, const char* suffix, auto make) {
    menu.addAction(text, this, [this, suffix, make] {
      emit fileWanted({m_source.fileName(), QString::fromLatin1(suffix), make()});
    });
  };
  offer(tr("Save as &SVG…"), "svg", [this] { return svgOf(m_source.picture()); });
  offer(tr("Save as &PNG…"), "png", [this] { return pngOf(m_source.picture(), pixelsPerUnit); });
  offer(tr("Save &Numbers as CSV…"), "csv", [this] { return QByteArray::fromStdString(m_source.numbers()); });
}

void ChartFiles::copy() {
  QApplication::clipboard()->setImage(imageOf(m_source.picture(), pixelsPerUnit));
}

}  // namespace alidade::ui
