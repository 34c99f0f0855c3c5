#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/session/measurement.h"
#include "ui/import/import_choice.h"

namespace alidade::ui {

/// A preview of the imported rows, each with its line in the file.
class ImportPreview : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum class Column {
    Position,
    Origin,
    Used,
    Point,
    Round,
    Face,
    Horizontal,
    Vertical,
    Slider,
    TiltCross,
    TiltLength,
    Corrections,
    Note
  };
  static constexpr int columns = static_cast<int>(Column::Note) + 1;

  using QAbstractTableModel::QAbstractTableModel;

  /// If `reading` is null, the preview is empty.
  void setReading(std::shared_ptr<const ImportReading> reading);
  bool isShown(Column column) const;  ///< false for an empty column

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    const ImportedRows* origin;
    std::size_t offset;  ///< number of the row within the origin, from 0
    const Reading* reading;
  };

  Row rowAt(int row) const;
  QString text(const Row& row, Column column) const;
  QString problem(const Row& row, Column column) const;

  std::shared_ptr<const ImportReading> m_reading;
  std::vector<std::size_t> m_begins;  ///< first row of each origin
  VerticalCircle m_circle = VerticalCircle::Zenith;
  CircleUnit m_unit = CircleUnit::Dms;
};

}  // namespace alidade::ui
