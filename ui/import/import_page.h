#pragma once

#include <QDialog>
#include <memory>
#include <optional>
#include <set>

#include "ui/import/import_choice.h"
#include "ui/jobs/background.h"

class QDialogButtonBox;
class QGroupBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QRadioButton;
class QTableView;

namespace alidade::ui {

class FormDraft;
class ImportFiles;
class ImportLayout;
class ImportPreview;
class ImportZeros;

/// What is to be imported, and where to.
struct ImportRequest {
  std::vector<ImportSource> sources;       ///< one at least
  std::shared_ptr<const Session> session;  ///< at work
};

/// What was decided: the session that the import makes, and where its rows came from.
struct ImportDecision {
  Session session;
  bool isAdded = false;               ///< it is the session at work with the readings; else a new one
  std::vector<JournalEntry> origins;  ///< entries of the journal
  std::size_t rows = 0;
};

/// Asks how files of readings are to be taken, all in one page: what each is, where and in which round it was
/// read, units and columns, pointing zeros, and whether the readings are added; it shows the rows as they
/// will stand. What was chosen for a layout is remembered. Reads on another thread.
class ImportPage : public QDialog {
  Q_OBJECT

 public:
  explicit ImportPage(ImportRequest request, QWidget* parent = nullptr);
  ~ImportPage() override;

  /// Absent: cancelled.
  std::optional<ImportDecision> ask();
  /// What is shown is what is chosen.
  bool isSettled() const { return m_isCurrent && !m_reading->isAtWork(); }
  /// Why it cannot be imported so; empty where it can.
  QString obstacle() const;
  /// As it is chosen now.
  ImportDecision decision() const;

 public slots:
  void accept() override;

 private:
  QWidget* createFiles();
  QWidget* createLayoutBox();
  QWidget* createZeroBox();
  QWidget* createPreview();
  QWidget* createModes();
  QWidget* createFoot();
  void recallLayouts();
  void showLayout();
  void choose();
  void read();
  void take(std::shared_ptr<const ImportReading> reading);
  void showReading();
  void tellTroubles();
  QStringList remarks() const;
  void showState();
  QString summary() const;
  QString unplacedFile() const;
  bool asksUnit(std::size_t source) const;

  ImportRequest m_request;
  FormDraft* m_draft;
  bool m_hasReadings;  ///< of the session at work
  ImportChoice m_choice;
  std::set<std::string> m_remembered;  ///< signatures
  std::unique_ptr<Background<ImportReading>> m_reading;
  std::shared_ptr<const ImportReading> m_shown;
  bool m_isCurrent = false;
  ImportFiles* m_files = nullptr;
  ImportLayout* m_layout = nullptr;
  QGroupBox* m_layoutBox = nullptr;
  ImportZeros* m_zeros = nullptr;
  QLineEdit* m_zeroPoint = nullptr;
  QRadioButton* m_add = nullptr;
  ImportPreview* m_preview = nullptr;
  QTableView* m_table = nullptr;
  QLabel* m_summary = nullptr;
  QPlainTextEdit* m_problems = nullptr;
  QDialogButtonBox* m_buttons = nullptr;
};

}  // namespace alidade::ui
