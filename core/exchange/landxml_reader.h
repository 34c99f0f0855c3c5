#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Is the text XML whose outermost element is LandXML? Leica's HeXML is LandXML with an element of its own.
bool looksLikeLandXml(std::string_view beginning);

/// Reads the observations (Survey) of a LandXML 1.2 file. A RawObservation with horizAngle and zenithAngle is
/// one sighting; slopeDistance, else horizDistance, is its distance, and directFace its face. Angles are in
/// the file's angularUnit: radians if it names none, grads, decimal degrees, or decimal dd.mm.ss (45.3025 is
/// 45°30'25"). The point is the TargetPoint's name, or the CgPoint it refers to (pntRef), named by its oID.
/// InstrumentSetups are the stations, InstrumentDetails the instrument; a FieldNote has the meaning of code
/// blocks in GSI (gsi_reader.h). ReducedObservations, and unused or deleted observations, are listed in
/// `unused`.
Recording readLandXml(std::string_view text, const std::string& zeroPoint = {});

}  // namespace alidade
