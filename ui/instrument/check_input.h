#pragma once

#include <QWidget>

#include "ui/commands/reading_block.h"
#include "ui/jobs/instrument_job.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTabWidget;

namespace alidade::ui {

class CheckRowsTable;
class Dialogs;

/// The input of an instrument check: files, typed or pasted rows, data sheet values, and the unit of plain
/// numbers.
class CheckInput : public QWidget {
  Q_OBJECT

 public:
  explicit CheckInput(Dialogs& dialogs, QWidget* parent = nullptr);

  InstrumentQuestion question() const;
  /// Adds files; reports unreadable ones.
  void addFiles(const QStringList& paths);
  CheckRowsTable& table() { return *m_table; }
  QStringList paths() const;  ///< paths of the files
  /// Shows in the empty fields what the files state about the instrument.
  void suggest(const CheckIdentity& read);

 signals:
  void changed();

 private:
  QWidget* createFiles();
  QWidget* createRows();
  QWidget* createForm();
  QWidget* createIdentity();
  void chooseFiles();
  void removeFiles();
  void clearRows();
  void showButtons();

  struct OpenFile {
    QString path, name;
    std::shared_ptr<const std::string> bytes;
  };

  Dialogs& m_dialogs;
  std::vector<OpenFile> m_files;
  QTabWidget* m_tabs;
  QListWidget* m_list;
  QPushButton *m_add, *m_remove, *m_clear;
  CheckRowsTable* m_table;
  ReadingBlock m_cleared;  ///< the rows cleared last; empty once a row is typed
  QLineEdit *m_name, *m_serial, *m_date, *m_due;
  QDoubleSpinBox *m_sigmaDirection, *m_sigmaVertical;
  QComboBox *m_unit, *m_circle;
};

}  // namespace alidade::ui
