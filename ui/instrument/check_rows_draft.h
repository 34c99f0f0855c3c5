#pragma once

#include <QObject>

namespace alidade::ui {

class CheckRowsTable;

/// Stores the rows typed for an instrument check, and the open cell, in the process's `Drafts`: a later start
/// restores them until they are cleared.
class CheckRowsDraft : public QObject {
  Q_OBJECT

 public:
  /// Restores the stored rows into the table, with an unfinished cell.
  explicit CheckRowsDraft(CheckRowsTable& table);

 private:
  void restore();
  void keepRows();

  CheckRowsTable& m_table;
};

}  // namespace alidade::ui
