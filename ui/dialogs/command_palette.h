#pragma once

#include <QDialog>
#include <QPointer>
#include <vector>

class QAction;
class QLineEdit;
class QListWidget;
class QMenu;
class QMenuBar;

namespace alidade::ui {

/// Every command of the menus in one list, filtered by typing: "ret ru" finds Edit › Add Rows › Return Run.
/// Enter chooses the current command.
class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  CommandPalette(const QMenuBar& menus, QWidget* parent);

  /// Lets the user choose a command; null: cancelled.
  QAction* ask();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Command {
    QPointer<QAction> action;
    QString path, keys;
  };

  void gather(QMenu& menu, const QString& path);
  void narrow(const QString& typed);

  std::vector<Command> m_commands;
  QLineEdit* m_typed;
  QListWidget* m_list;
};

}  // namespace alidade::ui
