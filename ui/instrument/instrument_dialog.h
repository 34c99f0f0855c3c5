#pragma once

#include <QDialog>

#include "ui/jobs/instrument_job.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace alidade::ui {

class CheckChart;
class CheckInput;
class GapHeadline;
class StatementTable;
class Dialogs;

/// The field check of an instrument according to ISO 17123-3: input above, results below, updated while
/// typing.
class InstrumentDialog : public QDialog {
  Q_OBJECT

 public:
  explicit InstrumentDialog(Dialogs& dialogs, QWidget* parent = nullptr);

  CheckInput& input() { return *m_input; }
  CheckChart& chart() { return *m_chart; }
  InstrumentJob& job() { return m_job; }
  QString said() const;  ///< the sentences shown

  bool exportJson();
  bool exportCsv();
  bool exportPdf();
  bool saveRecord();  ///< as an instrument record, for later sessions

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* createResult();
  QWidget* createButtons();
  void take(const SharedInstrument& answer);
  void showVerdict();
  void colorProblem();
  QString checkName() const;
  bool write(const QString& title, const QString& name, const QString& suffix, const std::string& bytes);

  Dialogs& m_dialogs;
  InstrumentJob m_job;
  SharedInstrument m_answer;
  CheckInput* m_input;
  GapHeadline* m_verdict;
  StatementTable* m_table;
  CheckChart* m_chart;
  QComboBox* m_view;
  QLabel *m_problem, *m_said;
  QPushButton *m_json, *m_csv, *m_pdf, *m_record;
};

}  // namespace alidade::ui
