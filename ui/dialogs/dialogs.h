#pragma once

#include <QPointer>
#include <QString>
#include <QWidget>

namespace alidade::ui {

/// The questions the program asks. Virtual, so that tests can answer.
class Dialogs {
 public:
  enum class SaveAnswer { Save, Discard, Cancel };
  enum class Way { Undo, Redo };

  explicit Dialogs(QWidget* parent = nullptr) : m_parent(parent) {}
  virtual ~Dialogs() = default;

  virtual SaveAnswer askSaveChanges(const QString& name);
  /// Shall the changes of another session be lost, which undo or redo leads to? `name` is empty where it was
  /// never saved.
  virtual bool askDiscardOther(const QString& name, Way way);
  /// Empty: cancelled.
  virtual QString askOpenPath(const QString& folder);
  virtual QString askImportPath(const QString& folder);
  virtual QString askSavePath(const QString& suggestion);
  virtual QString askReportPath(const QString& suggestion);
  /// Shall a report be written although `entries` > 0 entries cannot be used?
  virtual bool askReportWithoutVerdict(int entries);
  virtual void showProblem(const QString& title, const QString& text);
  virtual void showAbout();
  virtual void showShortcuts();

 private:
  QPointer<QWidget> m_parent;
};

}  // namespace alidade::ui
