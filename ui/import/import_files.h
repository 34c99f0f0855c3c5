#pragma once

#include <QTableWidget>
#include <vector>

#include "ui/import/import_choice.h"

class QComboBox;
class QSpinBox;

namespace alidade::ui {

/// The files of an import, each with where and in which round it was read.
class ImportFiles : public QTableWidget {
  Q_OBJECT

 public:
  ImportFiles(const std::vector<ImportSource>& sources, const std::vector<FileChoice>& choices);

  std::vector<FileChoice> choices() const;
  /// The row at work; 0 where none is.
  std::size_t current() const;
  /// Gives the keyboard to the first position that is still to be chosen, else to the first one.
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
