#include "ui/settings/entry_tone.h"

#include <QSettings>

namespace alidade::ui {

namespace {

const QString toneKey = QStringLiteral("entry/tone");

}  // namespace

bool hasTone() {
  return QSettings().value(toneKey, false).toBool();
}

void setTone(bool sounds) {
  QSettings().setValue(toneKey, sounds);
}

}  // namespace alidade::ui
