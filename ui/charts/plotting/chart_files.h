#pragma once

#include <QObject>
#include <string>

#include "ui/charts/plotting/picture_files.h"

class QMenu;
class QWidget;

namespace alidade::ui {

/// A file requested from a chart.
struct ChartFile {
  QString chart;   ///< for the file name: "residuals"
  QString suffix;  ///< "svg", "png" or "csv"
  QByteArray bytes;
};

/// The source of a chart's copies and files.
class ChartSource {
 public:
  virtual ~ChartSource() = default;
  virtual QString fileName() const = 0;  ///< part of the file name that names the chart, without suffix
  virtual PaintedPicture picture() = 0;
  virtual std::string numbers() const = 0;  ///< a table (`CsvText`)
};

/// Copies a chart, and offers it as SVG, PNG and CSV. The receiver of `fileWanted` writes the files.
class ChartFiles : public QObject {
  Q_OBJECT

 public:
  /// `chart`: the widget, which implements `source` and owns this object.
  ChartFiles(ChartSource& source, QWidget* chart);

  void addTo(QMenu& menu);
  void copy();

 signals:
  void fileWanted(const alidade::ui::ChartFile& file);

 private:
  ChartSource& m_source;
};

}  // namespace alidade::ui
