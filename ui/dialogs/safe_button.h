#pragma once

class QPushButton;

namespace alidade::ui {

/// Makes the non-destructive button the default: it has the keyboard focus, and Return presses it wherever
/// the focus is. Call once all buttons of the dialog exist.
void makeSafeButton(QPushButton& button);

}  // namespace alidade::ui
