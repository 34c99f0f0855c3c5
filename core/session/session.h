#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/session/first_texts.h"
#include "core/session/journal.h"
#include "core/session/json_origin.h"
#include "core/session/own_effect.h"

namespace alidade {

// The plain data of one measurement, as typed. Every number and angle is kept as its text, so that user
// input, even invalid, is neither lost nor rounded; empty text means "not given". `examine` (measurement.h)
// converts the texts and is the only way from a session to a fit. Names and units are those of the session
// file. A JSON number of decimal degrees appears here as `341.873333°`.

/// One row of readings: the slider at one place, sighted in one face.
struct Reading {
  std::string point;       ///< number of a slider place within position and round; empty: the row's number
  std::string round;       ///< whole number ≥ 1; empty: 1
  std::string face;        ///< 1 or 2; empty: 1
  std::string horizontal;  ///< circle reading α
  std::string vertical;    ///< circle reading β
  std::string slider;      ///< slider coordinate; may be empty
  std::string tiltCrossArcsec;   ///< compensator reading across the line of sight; may be empty
  std::string tiltLengthArcsec;  ///< along the line of sight; signs: compensator.h
  std::string corrections;       ///< switches that were on (`correctionSwitches`) or "none"; empty: unknown
  std::string takenAt;           ///< time of transmission by the instrument, ISO 8601 with zone; may be empty
  std::string returnCode;        ///< GeoCOM return code received with the angles; may be empty
  std::string instrumentSerial;  ///< serial of the sending instrument; may be empty
  bool excluded = false;         ///< kept and shown, but not used in any fit
  std::string note;
  FirstTexts asRead;  ///< original texts of changed fields
  JsonOrigin origin;

  bool operator==(const Reading&) const = default;
};

/// A further sighting of a pointing zero; both texts are empty if there was none.
struct ZeroSighting {
  std::string horizontal, vertical;
  JsonOrigin origin = {};
  std::string takenAt = {}, returnCode = {}, instrumentSerial = {};  ///< as in a row

  bool operator==(const ZeroSighting&) const = default;
};

struct PointingZero {
  std::string horizontal;        ///< α0: circle reading of the direction perpendicular to the arc plane
  std::string vertical;          ///< β0; both in face 1, before the readings of the position
  ZeroSighting faceTwo = {};     ///< before the readings, in face 2
  ZeroSighting after = {};       ///< after the readings, in face 1
  ZeroSighting afterInTwo = {};  ///< after the readings, in face 2
  JsonOrigin origin = {};
  std::string takenAt = {}, returnCode = {}, instrumentSerial = {};  ///< of the first sighting

  bool operator==(const PointingZero&) const = default;
};

/// The key, member, face and time of a further sighting of a pointing zero.
struct ZeroSlot {
  const char* key;  ///< key within `pointing_zero` of the session file
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

/// Prior knowledge of one parameter of an effect: from a certificate or a check of the instrument.
struct KnownSize {
  std::string effect = {};     ///< id of the catalogue
  std::string parameter = {};  ///< one of its parameters; empty if it has only one
  std::string value = {};      ///< empty: 0
  std::string sigma = {};      ///< standard uncertainty; required
  std::string unit = {};       ///< unit of the parameter in the catalogue
  std::string from = {};       ///< source of the knowledge
  std::string date = {};       ///< date of the finding
  JsonOrigin origin = {};

  bool operator==(const KnownSize&) const = default;
};

struct Device {
  std::string name, serial;
  std::string condition = {}, receivedOn = {};  ///< condition on receipt; date of receipt, YYYY-MM-DD
  std::vector<KnownSize> known = {};
  JsonOrigin origin;

  bool operator==(const Device&) const = default;
};

/// The instrument record that is the source of known values. The session has copies of the values: moving
/// or changing the record does not affect results.
struct NamedRecord {
  std::string file = {};  ///< its file name, without folder
  std::string date = {};  ///< date of the record
  JsonOrigin origin = {};

  bool operator==(const NamedRecord&) const = default;
};

/// The line of sight passes the vertical axis at a distance e. For e > 0 the horizontal circle reads e/(D
/// cos(elevation)) too much in face 1 and as much too little in face 2; D is the distance along the line of
/// sight. At one distance the effect is a collimation of e/D, which adds to the known collimation.
struct LineOfSight {
  std::string offsetMm = {};     ///< e; empty: unknown
  std::string sigmaMm = {};      ///< standard uncertainty of e; empty: 0
  std::string correlation = {};  ///< correlation of e with the known collimation, −1 … 1; empty: 0

  bool operator==(const LineOfSight&) const = default;
};

struct Instrument {
  std::string name, serial;
  std::string certificate;   ///< calibration certificate
  std::string traceability;  ///< reference standards and laboratory to which the circles are traceable
  std::string angleUnit;  ///< unit of plain typed numbers and of displayed angles: "dms", "degrees" or "gon"
  std::string sigmaHorizontalArcsec;   ///< empty: 2
  std::string sigmaVerticalArcsec;     ///< empty: 2
  std::string sigmaZeroArcsec;         ///< empty: the σ of the circles
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
  std::string sigmaRadiusMm;    ///< standard uncertainty of R0; empty: 0, and a known radius is exact
  std::string verticalCircle;   ///< "zenith" or "elevation"; empty: zenith
  std::string pointingZeros;    ///< "each": sighted in each position; "one": once for all; empty: each
  std::string plane = {};       ///< plane of the arc: "vertical" or "square" to the zero; empty: vertical
  /// What the pointing zeros sight: "mark", one fixed direction; "normal", the guideway's normal, set again
  /// in each position; "unknown"; empty: a mark if the zeros agree.
  std::string zeroIs = {};
  std::string distanceFrom;              ///< how L was measured, and its traceability
  std::string distanceExpansionPpmPerK;  ///< expansion of L, stated for 20 °C; empty: 0, L is not converted
  std::string radiusExpansionPpmPerK;    ///< expansion of R0, stated for 20 °C; empty: 0
  JsonOrigin origin;

  bool operator==(const Geometry&) const = default;
};

struct Acceptance {
  std::string toleranceMm;  ///< empty: no verdict
  std::string measurand;    ///< toleranced quantity: "intersection" or "distance"; empty: intersection
  std::string coverage;     ///< in (0, 1); empty: 0.95
  std::string referenceIntersectionMm;  ///< the set value of the device, if known; never enters a fit
  std::string sigmaReferenceMm;         ///< standard uncertainty of the reference; empty: not stated
  JsonOrigin origin;

  bool operator==(const Acceptance&) const = default;
};

struct Model {
  std::string verticalAngle;         ///< "exact" or "planar"; empty: exact
  std::string radius;                ///< "free", "common" or "known"; empty: free
  std::vector<std::string> effects;  ///< ids of the effects to estimate; unknown ones are kept
  JsonOrigin origin;

  bool operator==(const Model&) const = default;
};

/// Entries that a laboratory prints on a report in addition to the measurement; they never enter a fit.
struct ReportEntries {
  std::string number;  ///< unique; on every page
  std::string laboratory, customer;
  std::string authorisedBy;  ///< person responsible for the report
  std::string ruleAgreedBy;  ///< person with whom the decision rule was agreed
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
  std::vector<OwnEffect> ownEffects;  ///< effects of the user; candidates like those of the catalogue
  std::vector<Position> positions;
  /// The protocol of sightings in use, as its JSON; empty: none. See `protocolOf`.
  std::string protocol;
  std::vector<JournalEntry> journal;  ///< recorded changes, in order
  JsonOrigin origin;

  bool operator==(const Session&) const = default;
};

/// A new session: two positions, 0° and 180°, without readings, and the usual σ filled in.
Session blankSession();

}  // namespace alidade
