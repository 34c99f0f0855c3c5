#pragma once

#include <QTimer>

#include "tests/ui/monkey/chance.h"

namespace alidade::ui {

/// Answers menus and message boxes, which would wait forever, by a key or two, and closes those that remain.
class Housekeeper {
 public:
  explicit Housekeeper(unsigned seed);

  /// True while a menu or dialog waits.
  static bool isBusy();

 private:
  void look();

  Chance m_chance;
  int m_patience = 0;
  QTimer m_timer;
};

}  // namespace alidade::ui
