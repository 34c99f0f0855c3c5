#pragma once

class QPushButton;

namespace alidade::ui {

/// Of a dialog's buttons the one that destroys nothing: it has the keyboard, and Return means it wherever the
/// keyboard is. Asked for once all of the dialog's buttons are there.
void makeSafeButton(QPushButton& button);

}  // namespace alidade::ui
