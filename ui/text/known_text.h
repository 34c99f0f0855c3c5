#pragma once

#include <QString>
#include <string>

#include "ui/document/known_entry.h"

namespace alidade::ui {

/// A number of an effect as people call it: "collimation", "plane tilt, tilt about x".
QString numberName(const Effect& effect, const EffectParameter& parameter);

/// What the row is of; of no number of the catalogue what the entry names, short, hidden parts made seen.
QString knownName(const Session& session, const KnownRow& row);

/// What an entry says: "collimation 3.2 u 0.5 arcsec, check".
QString knownText(const KnownSize& size);

/// "known size of collimation, u"; empty where the session has no such entry.
QString spokenKnown(const Session& session, const KnownPlace& place);

}  // namespace alidade::ui
