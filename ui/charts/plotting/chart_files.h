#pragma once

#include <QObject>
#include <string>

#include "ui/charts/plotting/picture_files.h"

class QMenu;
class QWidget;

namespace alidade::ui {

/// A file that somebody wants of a chart.
struct ChartFile {
  QString chart;   ///< for its name: "residuals"
  QString suffix;  ///< "svg", "png" or "csv"
  QByteArray bytes;
};

/// What a chart is copied and written from.
class ChartSource {
 public:
  virtual ~ChartSource() = default;
  virtual QString fileName() const = 0;  ///< without suffix, of the chart alone
  virtual PaintedPicture picture() = 0;
  virtual std::string numbers() const = 0;  ///< a table (`CsvText`)
};

/// Copies a chart, and offers it as SVG, PNG and CSV. Who writes files is not known here.
class ChartFiles : public QObject {
  Q_OBJECT

 public:
  /// `chart` is a ChartSource, too, and owns this.
  ChartFiles(ChartSource& source, QWidget* chart);

  void addTo(QMenu& menu);
  void copy();

 signals:
  void fileWanted(const alidade::ui::ChartFile& file);

 private:
  ChartSource& m_source;
};

}  // namespace alidade::ui
