#pragma once

namespace alidade::ui {

/// Shall a reading that is not as expected sound the desktop's bell? Remembered; at first not.
bool hasTone();
void setTone(bool sounds);

}  // namespace alidade::ui
