#pragma once

#include <QDir>
#include <functional>
#include <utility>

#include "tests/ui/monkey/chance.h"

namespace alidade::ui {

class MainWindow;
class ReadingsTable;

/// External actions on a window.
class MonkeyHands {
 public:
  using Say = std::function<void(const QString& deed)>;

  /// `say` receives each action before it is done.
  MonkeyHands(Chance& chance, const QDir& folder, Say say)
      : m_chance(chance), m_folder(folder), m_say(std::move(say)) {}

  void take(MainWindow* window) { m_window = window; }
  /// A random action; everyday ones are frequent.
  void doAnything();

 private:
  void pressKey();
  void typeIntoCell();
  void typeIntoField();
  void click();
  void openContextMenu();
  void pressButton();
  void triggerAction();
  void paste();
  void editRows();
  void undoOrRedo();
  void turnPage();
  void tickEffect();
  void useSuspect();
  void useFiles();
  void addPosition();
  void changeLook();
  void hover();
  void wait();

  QWidget* anyWindow() const;
  ReadingsTable* table() const;
  void writeReadingsFile() const;

  Chance& m_chance;
  QDir m_folder;
  Say m_say;
  MainWindow* m_window = nullptr;
};

}  // namespace alidade::ui
