#pragma once

#include <QObject>
#include <QPointer>

class QAction;
class QMenu;
class QToolBar;

namespace alidade::ui {

class Dialogs;
class HelpWindow;
class MainWindow;
class ReadingsTable;

/// The window's menus, tool bar and shortcuts, and their actions.
class WindowActions : public QObject {
  Q_OBJECT

 public:
  WindowActions(MainWindow& window, Dialogs& dialogs);

  /// Opens the guide at the topic of the focused widget.
  void showHelp();
  void showFirstSteps();
  /// Gives a table its actions as context menu.
  void attachTo(ReadingsTable* table) const;

 private:
  enum class Clipboard { Cut, Copy, Paste };

  void createFileMenu(QToolBar& bar);
  void addExportMenu(QMenu& menu);
  void createEditMenu(QToolBar& bar);
  void addEntryActions(QMenu& menu);
  void addPositionActions(QMenu& menu);
  void removePosition();
  void addSuspectActions(QMenu& menu);
  void createViewMenu();
  void addUnitActions(QMenu& menu);
  void addPageActions(QMenu& menu);
  void addEnlargeAction(QMenu& menu);
  void createInstrumentMenu();
  void createToolsMenu();
  void createHelpMenu(Dialogs& dialogs);
  void fillRecentMenu(QMenu& menu);
  void showGuide(const QString& topic);
  void useClipboard(Clipboard way);
  void selectAll();

  MainWindow& m_window;
  Dialogs& m_dialogs;
  QAction* m_enlarge = nullptr;
  QPointer<HelpWindow> m_guide;  ///< null until first shown
  QList<QAction*> m_tableActions;
};

}  // namespace alidade::ui
