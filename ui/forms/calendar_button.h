#pragma once

class QLineEdit;

namespace alidade::ui {

/// Adds a calendar button to a line for a date. The calendar opens at the date typed, or else at today. The
/// chosen date is entered as if typed and ended with Return.
void addCalendarButton(QLineEdit& line);

}  // namespace alidade::ui
