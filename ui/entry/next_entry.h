#pragma once

class QWidget;

namespace alidade::ui {

/// The entry that Enter leads to from `entry`: the next in the order of Tab that is in sight and can be typed
/// or chosen in, a table too. Buttons and tabs are passed over, and what `passOver` was told of. Null: none.
QWidget* nextEntry(const QWidget* entry);

/// Enter does not stop at it: as a rule it is right as it is.
void passOver(QWidget* entry);

}  // namespace alidade::ui
