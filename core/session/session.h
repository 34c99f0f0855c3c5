#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/session/first_texts.h"
#include "core/session/journal.h"
#include "core/session/json_origin.h"

namespace alidade {

// The plain data of one measurement, as typed. Every number and angle is kept as its text, so nothing the
// user typed is lost or rounded, bad entries included; empty text means "not given". What the texts mean is
// worked out by `examine` (measurement.h), which is the only road from here to a fit. Names and units are
// those of the session file. A JSON number of decimal degrees appears here as `341.873333°`.

/// One row of readings: the slider at one place, sighted in one face.
struct Reading {
  std::string point;  ///< whole number; names the slider place within position and round; empty: the row's
                      ///< number from 1
  std::string round;  ///< whole number ≥ 1; empty: 1
  std::string face;   ///< 1 or 2; empty: 1
  std::string horizontal;        ///< circle reading α
  std::string vertical;          ///< circle reading β
  std::string slider;            ///< slider coordinate; may be empty
  std::string tiltCrossArcsec;   ///< what the compensator read across the line of sight; may be empty
  std::string tiltLengthArcsec;  ///< along it; signs: compensator.h
  std::string corrections;  ///< that the instrument had on, words of `correctionSwitches` or "none"; empty:
                            ///< not known
  std::string takenAt;      ///< when the instrument sent it, ISO 8601 with zone; may be empty, as the next
  std::string returnCode;   ///< of GeoCOM, that came with the angles
  std::string instrumentSerial;  ///< of the instrument that sent it
  bool excluded = false;         ///< kept and shown, but no part of any fit
  std::string note;
  FirstTexts asRead;  ///< of what was changed since it was entered
  JsonOrigin origin;

  bool operator==(const Reading&) const = default;
};

/// A further sighting of a pointing zero; both texts empty: there was none.
struct ZeroSighting {
  std::string horizontal, vertical;
  JsonOrigin origin = {};
  std::string takenAt = {}, returnCode = {}, instrumentSerial = {};  ///< as of a row

  bool operator==(const ZeroSighting&) const = default;
};

struct PointingZero {
  std::string horizontal;        ///< α0: circle reading of the direction perpendicular to the arc plane
  std::string vertical;          ///< β0; both in face 1, before the readings of the position
  ZeroSighting faceTwo = {};     ///< before them in face 2
  ZeroSighting after = {};       ///< after them in face 1
  ZeroSighting afterInTwo = {};  ///< after them in face 2
  JsonOrigin origin = {};
  std::string takenAt = {}, returnCode = {}, instrumentSerial = {};  ///< of the first, as of a row

  bool operator==(const PointingZero&) const = default;
};

/// Where a further sighting of a pointing zero stands.
struct ZeroSlot {
  const char* key;  ///< in the session file, within `pointing_zero`
  ZeroSighting PointingZero::*sighting;
  int face;
  bool isAfter;
};
inline constexpr ZeroSlot furtherZeros[] = {{"face_2", &PointingZero::faceTwo, 2, false},
                                            {"after", &PointingZero::after, 1, true},
                                            {"after_face_2", &PointingZero::afterInTwo, 2, true}};

struct Position {
  std::string axisDeg;  ///< rotation of the axis: 0 or 180
  PointingZero zero;
  std::vector<Reading> readings;  ///< in the order in which they were taken
  JsonOrigin origin;

  bool operator==(const Position&) const = default;
};

/// What is known of one number of an effect beforehand: from a certificate, from a check of the instrument.
struct KnownSize {
  std::string effect = {};     ///< id of the catalogue
  std::string parameter = {};  ///< which of its numbers; empty where it has one
  std::string value = {};      ///< empty: 0
  std::string sigma = {};      ///< standard uncertainty; required
  std::string unit = {};       ///< that of the catalogue
  std::string from = {};       ///< where it is known from
  std::string date = {};       ///< when it was found
  JsonOrigin origin = {};

  bool operator==(const KnownSize&) const = default;
};

struct Device {
  std::string name, serial;
  std::vector<KnownSize> known = {};
  JsonOrigin origin;

  bool operator==(const Device&) const = default;
};

/// The instrument record that what is known was taken from. All that was taken stands in the session itself,
/// so a record that is moved or changed changes no result.
struct NamedRecord {
  std::string file = {};  ///< its name, without folder
  std::string date = {};  ///< that it was made on
  JsonOrigin origin = {};

  bool operator==(const NamedRecord&) const = default;
};

/// The line of sight passes the vertical axis at a distance e. For e > 0 face 1 reads e/(D cos(elevation))
/// too much on the horizontal circle and face 2 as much too little, D along the line of sight: at one
/// distance that is a collimation of e/D, which adds to the known collimation.
struct LineOfSight {
  std::string offsetMm = {};     ///< e; empty: not known
  std::string sigmaMm = {};      ///< its standard uncertainty; empty: 0
  std::string correlation = {};  ///< with the known collimation, −1 … 1; empty: 0

  bool operator==(const LineOfSight&) const = default;
};

struct Instrument {
  std::string name, serial;
  std::string certificate;   ///< of its calibration
  std::string traceability;  ///< of its circles: to which standards, by whom
  std::string
      angleUnit;  ///< of angles typed without one, and in which they are shown: "dms", "degrees", "gon"
  std::string sigmaHorizontalArcsec;   ///< empty: 2
  std::string sigmaVerticalArcsec;     ///< empty: 2
  std::string sigmaZeroArcsec;         ///< empty: as the circles'
  std::string sigmaSliderArcsec;       ///< empty: 5
  std::string sigmaCompensatorArcsec;  ///< setting accuracy; empty: 1
  LineOfSight lineOfSight = {};
  NamedRecord record = {};
  std::vector<KnownSize> known = {};
  JsonOrigin origin;

  bool operator==(const Instrument&) const = default;
};

struct Environment {
  std::string temperatureC;
  std::string sigmaTemperatureC;  ///< standard uncertainty; empty: 0
  JsonOrigin origin;

  bool operator==(const Environment&) const = default;
};

struct Geometry {
  std::string distanceMm;       ///< L, theodolite to arc plane; required
  std::string sigmaDistanceMm;  ///< empty: 0, taken as exact
  std::string radiusMm;         ///< nominal R0; required
  std::string sigmaRadiusMm;    ///< of R0 where the model takes it as known; empty: 0, taken as exact
  std::string verticalCircle;   ///< "zenith" or "elevation"; empty: zenith
  std::string pointingZeros;    ///< "each": sighted in each position; "one": once, for all; empty: each
  std::string plane = {};       ///< of the arc: "vertical", or "square" to the pointing zero; empty: vertical
  /// What the pointing zeros sight: "mark", one fixed direction; "normal", that of the guideway, set anew;
  /// "unknown"; empty: a mark where they agree.
  std::string zeroIs = {};
  std::string distanceFrom;              ///< how L was measured, and its traceability
  std::string distanceExpansionPpmPerK;  ///< of L, as stated for 20 °C; empty: 0, as it is at the temperature
  std::string radiusExpansionPpmPerK;    ///< of R0 likewise
  JsonOrigin origin;

  bool operator==(const Geometry&) const = default;
};

struct Acceptance {
  std::string toleranceMm;  ///< empty: no verdict
  std::string measurand;    ///< of the tolerance: "intersection" or "distance"; empty: intersection
  std::string coverage;     ///< in (0, 1); empty: 0.95
  std::string referenceIntersectionMm;  ///< what the device was set to, where known; never enters a fit
  std::string sigmaReferenceMm;         ///< of the reference; empty: not stated
  JsonOrigin origin;

  bool operator==(const Acceptance&) const = default;
};

struct Model {
  std::string verticalAngle;         ///< "exact" or "planar"; empty: exact
  std::string radius;                ///< "free", "common" or "known"; empty: free
  std::vector<std::string> effects;  ///< ids of the effects to be estimated along; unknown ones stay
  JsonOrigin origin;

  bool operator==(const Model&) const = default;
};

/// What a laboratory prints on a report beside the measurement; nothing of it enters a fit.
struct ReportEntries {
  std::string number;                ///< unique; on every page
  std::string laboratory, customer;  ///< who measured, and for whom
  std::string authorisedBy;          ///< who answers for the report
  std::string ruleAgreedBy;          ///< with whom the decision rule was agreed
  JsonOrigin origin;

  bool operator==(const ReportEntries&) const = default;
};

struct Session {
  std::string title, notes, operatorName, place, measuredOn;
  ReportEntries report;
  Device device;
  Instrument instrument;
  Environment environment;
  Geometry geometry;
  Acceptance acceptance;
  Model model;
  std::vector<Position> positions;
  /// The protocol of sightings that is followed, as its JSON; empty: none. See `protocolOf`.
  std::string protocol;
  std::vector<JournalEntry> journal;  ///< changes of entries that stood, in their order
  JsonOrigin origin;

  bool operator==(const Session&) const = default;
};

/// A new session: two positions, 0° and 180°, without readings, and the usual σ filled in.
Session blankSession();

}  // namespace alidade
