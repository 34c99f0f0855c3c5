#pragma once

#include <QString>
#include <QStringList>

#include "core/series/history/device_history.h"

namespace alidade::ui {

/// "Guideway 7, serial number G-07"; as typed.
QString deviceText(const DeviceHistory& device);

/// The conclusions from a quantity's history, in one or two sentences each.
QStringList historyLines(const DeviceHistory& device, const QuantityHistory& quantity);

/// "0.185 ± 0.226 mm": Δd, measured, and its expanded uncertainty.
QString intersectionText(const Epoch& epoch);

/// "accept"; empty without a tolerance.
QString verdictText(const Epoch& epoch);

}  // namespace alidade::ui
