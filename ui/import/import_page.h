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

/// The files to import, and the current session.
struct ImportRequest {
  std::vector<ImportSource> sources;  ///< at least one
  std::shared_ptr<const Session> session;
};

/// The result: the session made by the import, and the origin of its rows.
struct ImportDecision {
  Session session;
  bool isAdded = false;               ///< true: the current session with the readings; false: a new session
  std::vector<JournalEntry> origins;  ///< journal entries that state the origin of the rows
  std::size_t rows = 0;
};

/// Asks on one page how to import files of readings: format, position, round, units, columns, pointing zeros,
/// and target; shows a preview of the rows. Remembers the chosen layouts. Reads on another thread.
class ImportPage : public QDialog {
  Q_OBJECT

 public:
  explicit ImportPage(ImportRequest request, QWidget* parent = nullptr);
  ~ImportPage() override;

  /// Absent: cancelled.
  std::optional<ImportDecision> ask();
  /// True if the page shows the result of the current choices.
  bool isUpToDate() const { return m_isCurrent && !m_reading->isAtWork(); }
  /// The reason why the files cannot be imported with the current choices; empty if they can.
  QString obstacle() const;
  /// The result of the current choices.
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
  void showProblems();
  QStringList remarks() const;
  void showState();
  QString summary() const;
  QString unplacedFile() const;
  bool asksUnit(std::size_t source) const;

  ImportRequest m_request;
  FormDraft* m_draft;
  bool m_hasReadings;  ///< true if the current session has readings
  ImportChoice m_choice;
  std::set<std::string> m_remembered;  ///< signatures of the remembered layouts
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
