#pragma once

class QLineEdit;

namespace alidade::ui {

/// Adds a button to a line that enters a day: it opens a calendar at the day typed, or else at today. The day
/// chosen is entered as if it were typed and ended with Return.
void addCalendarButton(QLineEdit& line);

}  // namespace alidade::ui
