#pragma once

#include <QDialog>
#include <QStringList>
#include <map>
#include <vector>

#include "ui/report/report_choice.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;

namespace alidade::ui {

class LogoForm;
class PaperForm;

/// What the dialog before a report shows and asks.
struct ReportQuestion {
  enum class Way { Export, Print, Preview };

  Way way = Way::Export;
  ReportChoice choice = {};                ///< the last choice
  std::vector<ReportPart> there = {};      ///< parts available in this session's report
  std::vector<ReportPart> mandatory = {};  ///< parts that cannot be left out
  QStringList emptyFields = {};            ///< fields that a laboratory states but the session lacks
  bool isCertificate = false;              ///< true: asks also for statements that only a certificate has
  int unusable = 0;                        ///< number of unusable entries; any of them prevents a verdict
};

/// The one dialog before a report: asks for contents, paper and logo, and lists what the report will lack.
class ReportDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ReportDialog(const ReportQuestion& question, QWidget* parent = nullptr);

  ReportChoice choice() const;

 private:
  QWidget* createContents();
  QWidget* createSheet();
  QWidget* createLacks();
  QWidget* createCertificate();
  QWidget* createButtons();
  void keepDraft();
  QWidget* createHistory();
  void setSeriesFolder(const QString& folder);

  ReportQuestion m_question;
  std::map<ReportPart, QCheckBox*> m_parts;
  QCheckBox* m_session = nullptr;
  PaperForm* m_paper = nullptr;
  QComboBox* m_language = nullptr;
  QLineEdit *m_country = nullptr, *m_maker = nullptr;
  QComboBox* m_performedAt = nullptr;
  QCheckBox* m_draft = nullptr;
  LogoForm* m_logo = nullptr;
  QLabel* m_seriesName = nullptr;
  QWidget* m_noSeries = nullptr;  ///< the button that leaves out the history
  QString m_seriesFolder;
};

}  // namespace alidade::ui
