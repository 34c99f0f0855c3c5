#include "ui/dialogs/safe_button.h"

#include <QPushButton>

namespace alidade::ui {

void makeSafeButton(QPushButton& button) {
  for (QPushButton* other : button.window()->findChildren<QPushButton*>())
    if (other != &button) other->setAutoDefault(false);
  button.setDefault(true);
  button.setFocus();
}

}  // namespace alidade::ui
