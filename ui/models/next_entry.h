#pragma once

class QWidget;

namespace alidade::ui {

/// The widget to which Enter moves from `entry`: the next visible editable widget in Tab order, including
/// tables. Skips buttons, tabs and entries given to `passOver`. Null: none.
QWidget* nextEntry(const QWidget* entry);

/// Makes Enter skip this entry, since its value is usually right.
void passOver(QWidget* entry);

}  // namespace alidade::ui
