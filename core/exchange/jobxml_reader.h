#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Is the text XML whose outermost element is JOBFile?
bool looksLikeJobXml(std::string_view beginning);

/// Reads the field book of a Trimble JobXML file (JobXML schema 5; Trimble Access, Survey Controller, General
/// Survey). The file has decimal degrees and metres whatever units the job shows. A PointRecord with a Circle
/// is one sighting: HorizontalCircle, VerticalCircle (a zenith angle), EDMDistance, and Face1, Face2 or
/// FaceNull, which states no face. StationRecords are the stations, InstrumentRecords the instrument, and
/// notes (NoteRecord) have the meaning of code blocks in GSI (gsi_reader.h). Deleted records, means of both
/// faces (MeanTurnedAngle) and computed observations are listed in `unused`.
Recording readJobXml(std::string_view text, const std::string& zeroPoint = {});

}  // namespace alidade
