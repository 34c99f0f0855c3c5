#pragma once

#include <QObject>

namespace alidade::ui {

class CheckRowsTable;

/// Keeps the rows typed for an instrument check, and the cell that is being typed, among the process's
/// `Drafts`: a later start has them again, until they are cleared.
class CheckRowsDraft : public QObject {
  Q_OBJECT

 public:
  /// Puts what was kept into the table, a cell that was half typed as it stood.
  explicit CheckRowsDraft(CheckRowsTable& table);

 private:
  void restore();
  void keepRows();

  CheckRowsTable& m_table;
};

}  // namespace alidade::ui
