#pragma once

#include <QDialog>

#include "ui/jobs/background.h"
#include "ui/self_test/installation_check.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace alidade::ui {

class Dialogs;

/// Checks this installation when opened and on request. Shows the verdict and every line with expected and
/// found values; prints them, or writes them into a PDF.
class InstallationDialog : public QDialog {
  Q_OBJECT

 public:
  explicit InstallationDialog(Dialogs& dialogs, QWidget* parent = nullptr);

  void check();
  bool isAtWork() const { return m_work.isAtWork(); }
  SharedInstallationCheck last() const { return m_check; }  ///< null before the first
  QString verdict() const;

  bool savePdf();
  bool print();

 signals:
  void checked();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* createButtons();
  void take(SelfTest ofCore);
  void colorVerdict();

  Dialogs& m_dialogs;
  Background<SelfTest> m_work;
  SharedInstallationCheck m_check;
  QLabel* m_verdict;
  QTreeWidget* m_lines;
  QPushButton* m_again = nullptr;
  QPushButton* m_save = nullptr;
  QPushButton* m_print = nullptr;
};

}  // namespace alidade::ui
