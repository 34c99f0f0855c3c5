#pragma once

#include <QString>
#include <string>

#include "ui/document/known_entry.h"

namespace alidade::ui {

/// The common name of a number: "collimation", "plane tilt, tilt about x".
QString numberName(const Effect& effect, const EffectParameter& parameter);

/// The name of the row. For numbers unknown to the catalogue, the shortened name of the entry with hidden
/// characters made visible.
QString knownName(const Session& session, const KnownRow& row);

/// The content of an entry: "collimation 3.2 u 0.5 arcsec, check".
QString knownText(const KnownSize& size);

/// The name of the place: "known size of collimation, u"; empty if the session has no entry there.
QString accessibleKnown(const Session& session, const KnownPlace& place);

}  // namespace alidade::ui
