#pragma once

#include <QString>

#include "core/wording/position_name.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

/// "0°", "0° again": `positionName` for the window.
inline QString positionText(int axisDeg, int time = 1) {
  return qText(positionName(axisDeg, time));
}

}  // namespace alidade::ui
