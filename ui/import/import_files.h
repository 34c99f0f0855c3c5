#pragma once

#include <QTableWidget>
#include <vector>

#include "ui/import/import_choice.h"

class QComboBox;
class QSpinBox;

namespace alidade::ui {

/// The files of an import, each with its position and round.
class ImportFiles : public QTableWidget {
  Q_OBJECT

 public:
  ImportFiles(const std::vector<ImportSource>& sources, const std::vector<FileChoice>& choices);

  std::vector<FileChoice> choices() const;
  /// The current row; 0 if none.
  std::size_t current() const;
  /// Focuses the first position still to be chosen, else the first position.
  void focusOpenChoice();

 signals:
  void chosen();

 private:
  struct Row {
    QComboBox* where;
    QSpinBox* turned;
    QComboBox* round;
  };

  void addRow(const ImportSource& source, const FileChoice& choice);
  QComboBox* createWhere(const ImportSource& source, const FileChoice& choice);
  QComboBox* createRound(const FileChoice& choice);
  void fitColumns();

  std::vector<Row> m_rows;
};

}  // namespace alidade::ui
