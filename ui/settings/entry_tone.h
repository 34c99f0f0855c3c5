#pragma once

namespace alidade::ui {

/// True if an unexpected reading sounds the desktop's bell. Remembered; off at first.
bool hasTone();
void setTone(bool sounds);

}  // namespace alidade::ui
