#pragma once

#include <QDialog>
#include <QStringList>

#include "core/series/history/record_history.h"

class QLabel;
class QPushButton;

namespace alidade::ui {

class Dialogs;
class HistoryChart;
class HistoryChoices;
class StatementTable;

/// The records of one instrument with their due dates, and the control chart of each of its constants, as
/// `alidade-cli history` states them.
class RecordHistoryDialog : public QDialog {
  Q_OBJECT

 public:
  explicit RecordHistoryDialog(Dialogs& dialogs, QWidget* parent = nullptr);

  void addFolder();  ///< asks for the folder
  /// Adds records and the records in folders; skips files added before.
  void add(const QStringList& filesAndFolders);
  bool exportJson();
  bool exportCsv();
  StatementTable* table() const { return m_table; }
  HistoryChart* chart() const { return m_chart; }

 private:
  QWidget* createButtons();
  void read(const QString& path);
  void showInstruments();
  void showInstrument();
  void showQuantity();
  /// What does not concern one instrument, and what is left out of the one shown.
  void showRemarks(const InstrumentHistory& shown);
  const InstrumentHistory* instrument() const;
  const QuantityHistory* quantity() const;
  std::vector<std::string> remarks() const;
  bool write(const QString& title, const QString& suffix, const std::string& bytes);

  Dialogs& m_dialogs;
  std::vector<KeptRecord> m_records;
  std::vector<std::string> m_unusable;  ///< file and reason
  InstrumentHistories m_histories;
  QStringList m_paths;  ///< files added
  QString m_folder;     ///< the folder visited last
  StatementTable* m_table;
  HistoryChoices* m_choices;
  HistoryChart* m_chart;
  QLabel *m_says, *m_remarks;
  QPushButton *m_json, *m_csv;
};

}  // namespace alidade::ui
