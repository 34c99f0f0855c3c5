#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Is the text XML whose outermost element is LandXML? Leica's HeXML is LandXML with an element of its own.
bool looksLikeLandXml(std::string_view beginning);

/// Reads the observations (Survey) of a LandXML 1.2 file. A RawObservation with horizAngle and zenithAngle is
/// one sighting; slopeDistance, else horizDistance, is its distance, and directFace tells the face. Angles
/// are in the file's angularUnit: radians where it names none, grads, decimal degrees, or decimal dd.mm.ss
/// (45.3025 is 45°30'25"). The point is the TargetPoint's name, or what it refers to (pntRef, a CgPoint,
/// called by its oID). InstrumentSetups are the stations, InstrumentDetails the instrument, and a FieldNote
/// says what code blocks say in GSI (gsi_reader.h). ReducedObservations, and observations that are unused or
/// deleted, are listed in `unused`.
Recording readLandXml(std::string_view text, const std::string& zeroPoint = {});

}  // namespace alidade
