#pragma once

#include <QDialog>
#include <QStringList>
#include <map>
#include <vector>

#include "ui/report/report_choice.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace alidade::ui {

class PaperForm;

/// All that is to be known and decided before a report is written or printed.
struct ReportQuestion {
  enum class Way { Export, Print, Preview };

  Way way = Way::Export;
  ReportChoice choice = {};                ///< as chosen last
  std::vector<ReportPart> there = {};      ///< parts that this session's report may have
  std::vector<ReportPart> mustStand = {};  ///< those that may not be left out
  QStringList emptyFields = {};            ///< what a laboratory would state and the session leaves empty
  int unusable = 0;                        ///< entries; with any there is no verdict
};

/// The one question before a report: what it holds, on which paper, with which logo, and what it will lack.
class ReportDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ReportDialog(const ReportQuestion& question, QWidget* parent = nullptr);

  ReportChoice choice() const;

 private:
  QWidget* createContents();
  QWidget* createSheet();
  QWidget* createLacks();
  void addLanguage();
  QWidget* createLogo();
  QWidget* createButtons();
  void keepDraft();
  QWidget* createHistory();
  void setSeriesFolder(const QString& folder);
  void chooseLogo();
  void setLogo(const QString& path);

  ReportQuestion m_question;
  std::map<ReportPart, QCheckBox*> m_parts;
  QCheckBox* m_session = nullptr;
  PaperForm* m_paper = nullptr;
  QComboBox* m_language = nullptr;
  QLabel *m_logo = nullptr, *m_logoName = nullptr;
  QWidget* m_noLogo = nullptr;  ///< the button that takes it away
  QString m_logoPath;
  QLabel* m_seriesName = nullptr;
  QWidget* m_noSeries = nullptr;  ///< the button that leaves the history out
  QString m_seriesFolder;
};

}  // namespace alidade::ui
