#include "core/session/session_fields.h"

#include <algorithm>
#include <limits>

#include "core/base/number_text.h"
#include "core/base/phrase.h"

namespace alidade {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double longestMm = 1e6;
// The lower limit is finer than any circle; far below it, Bayes factors and weights would lose their digits.
constexpr double leastSigmaArcsec = 0.001, largestSigmaArcsec = 3600;

// A choice within 0.5″ to 1.5″, the assumed range of setting accuracies of compensators; not from a data
// sheet. A session should state the setting accuracy of its instrument.
constexpr double usualSigmaCompensator = 1;

// Far above a true offset of the line of sight, which is some tenths of a millimetre.
constexpr double largestOffsetMm = 10;

constexpr const char* noLength =
    PHRASE_LATER("Phrase", "%1 is out of range: it must be above 0 and below 1000000 mm");
constexpr const char* noSigmaOfLength =
    PHRASE_LATER("Phrase", "%1 is out of range: it must be 0 or more and below 1000000 mm");
constexpr const char* noExpansion = PHRASE_LATER(
    "Phrase", "%1 is out of range: it must be from -1000 to below 1000, in millionths per kelvin");
constexpr const char* noSigma =
    PHRASE_LATER("Phrase", "%1 is out of range: it must be at least 0.001 and below 3600 arcseconds");

constexpr const char* mm = PHRASE_LATER("Forms", "mm");
constexpr const char* arcseconds = PHRASE_LATER("Forms", "″");

constexpr WordChoice circleChoices[] = {{"zenith", PHRASE_LATER("Forms", "Zenith")},
                                        {"elevation", PHRASE_LATER("Forms", "Elevation")}};
constexpr WordChoice planeChoices[] = {{"vertical", PHRASE_LATER("Forms", "Vertical")},
                                       {"square", PHRASE_LATER("Forms", "Square")}};
constexpr WordChoice relationChoices[] = {{"exact", PHRASE_LATER("Forms", "Exact")},
                                          {"planar", PHRASE_LATER("Forms", "Planar")}};
constexpr WordChoice radiusChoices[] = {{"free", PHRASE_LATER("Forms", "Free")},
                                        {"common", PHRASE_LATER("Forms", "Common")},
                                        {"known", PHRASE_LATER("Forms", "Known")}};
constexpr WordChoice measurandChoices[] = {{"intersection", PHRASE_LATER("Forms", "Δd")},
                                           {"distance", PHRASE_LATER("Forms", "Distance")}};
constexpr WordChoice markChoices[] = {{"", PHRASE_LATER("Forms", "Unstated")},
                                      {"mark", PHRASE_LATER("Forms", "A mark")},
                                      {"normal", PHRASE_LATER("Forms", "The normal")},
                                      {"unknown", PHRASE_LATER("Forms", "Not known")}};
constexpr WordChoice zeroChoices[] = {{"", PHRASE_LATER("Forms", "Unstated")},
                                      {"each", PHRASE_LATER("Forms", "Each")},
                                      {"one", PHRASE_LATER("Forms", "One for all")}};

/// The rule of a word that `entry` reads.
template <auto entry>
std::optional<Problem> wordRule(const std::string& text) {
  const auto value = entry(text);
  return value ? std::nullopt : std::optional(value.problem());
}

template <auto... members>
constexpr SessionField ofSession(SessionField field) {
  field.get = [](const Session& session) -> const std::string& { return (session.*....*members); };
  field.at = [](Session& session) -> std::string& { return (session.*....*members); };
  return field;
}

constexpr SessionField allSessionFields[] = {
    ofSession<&Session::title>({.key = "title",
                                .noun = PHRASE_LATER("Field", "title"),
                                .caption = PHRASE_LATER("Forms", "T&itle"),
                                .fillsRow = true,
                                .isOfMeasurement = false,
                                .isOfOneMeasurement = true}),
    ofSession<&Session::notes>({.key = "notes",
                                .noun = PHRASE_LATER("Field", "notes"),
                                .isOfMeasurement = false,
                                .isOfOneMeasurement = true}),
    ofSession<&Session::operatorName>({.key = "operator",
                                       .noun = PHRASE_LATER("Field", "operator"),
                                       .caption = PHRASE_LATER("Forms", "Operator"),
                                       .isOfMeasurement = false,
                                       .isWantedOnReport = true}),
    ofSession<&Session::place>({.key = "place",
                                .noun = PHRASE_LATER("Field", "place"),
                                .caption = PHRASE_LATER("Forms", "&Place"),
                                .isOfMeasurement = false,
                                .isWantedOnReport = true}),
    ofSession<&Session::measuredOn>({.key = "measured_on",
                                     .noun = PHRASE_LATER("Field", "date"),
                                     .rule = &dateProblem,
                                     .caption = PHRASE_LATER("Forms", "D&ate"),
                                     .whenEmpty = PHRASE_LATER("Forms", "YYYY-MM-DD"),
                                     .help = PHRASE_LATER("Forms", "Day of the measurement"),
                                     .isOfMeasurement = false,
                                     .isOfOneMeasurement = true,
                                     .isWantedOnReport = true}),
    ofSession<&Session::report, &ReportEntries::number>(
        {.key = "report.number",
         .noun = PHRASE_LATER("Field", "report number"),
         .caption = PHRASE_LATER("Forms", "Re&port no."),
         .help = PHRASE_LATER("Forms", "Unique number of the report, printed on each of its pages"),
         .isOfMeasurement = false,
         .isOfOneMeasurement = true,
         .isWantedOnReport = true}),
    ofSession<&Session::report, &ReportEntries::laboratory>(
        {.key = "report.laboratory",
         .noun = PHRASE_LATER("Field", "laboratory"),
         .caption = PHRASE_LATER("Forms", "&Laboratory"),
         .whenEmpty = PHRASE_LATER("Forms", "name and address"),
         .fillsRow = true,
         .isOfMeasurement = false,
         .isWantedOnReport = true}),
    ofSession<&Session::report, &ReportEntries::customer>(
        {.key = "report.customer",
         .noun = PHRASE_LATER("Field", "customer"),
         .caption = PHRASE_LATER("Forms", "Customer"),
         .whenEmpty = PHRASE_LATER("Forms", "name and address"),
         .fillsRow = true,
         .isOfMeasurement = false,
         .isWantedOnReport = true}),
    ofSession<&Session::report, &ReportEntries::authorisedBy>(
        {.key = "report.authorised_by",
         .noun = PHRASE_LATER("Field", "authorised by"),
         .caption = PHRASE_LATER("Forms", "Authorised b&y"),
         .help = PHRASE_LATER("Forms", "Person responsible for the report"),
         .isOfMeasurement = false,
         .isWantedOnReport = true}),
    ofSession<&Session::report, &ReportEntries::ruleAgreedBy>(
        {.key = "report.rule_agreed_by",
         .noun = PHRASE_LATER("Field", "decision rule agreed by"),
         .caption = PHRASE_LATER("Forms", "Rule a&greed by"),
         .whenEmpty = PHRASE_LATER("Forms", "who, and in which document"),
         .help =
             PHRASE_LATER("Forms",
                          "With whom the decision rule was agreed: accept only where |Δd| + U is within the "
                          "tolerance, reject only where |Δd| − U is beyond it"),
         .fillsRow = true,
         .isOfMeasurement = false,
         .isWantedOnReport = true}),
    ofSession<&Session::device, &Device::name>({.key = "device.name",
                                                .noun = PHRASE_LATER("Field", "device"),
                                                .caption = PHRASE_LATER("Forms", "Dev&ice"),
                                                .whenEmpty = PHRASE_LATER("Forms", "simulator under test"),
                                                .fillsRow = true,
                                                .isWantedOnReport = true}),
    ofSession<&Session::device, &Device::serial>({.key = "device.serial",
                                                  .noun = PHRASE_LATER("Field", "device serial number"),
                                                  .caption = PHRASE_LATER("Forms", "Serial no."),
                                                  .isOfOneMeasurement = true,
                                                  .isWantedOnReport = true}),
    ofSession<&Session::device, &Device::condition>(
        {.key = "device.condition",
         .noun = PHRASE_LATER("Field", "condition of the device"),
         .caption = PHRASE_LATER("Forms", "Condition"),
         .help = PHRASE_LATER("Forms", "Condition of the device on receipt, for the report"),
         .fillsRow = true,
         .isOfMeasurement = false,
         .isOfOneMeasurement = true}),
    ofSession<&Session::device, &Device::receivedOn>({.key = "device.received_on",
                                                      .noun = PHRASE_LATER("Field", "day of receipt"),
                                                      .rule = &dateProblem,
                                                      .caption = PHRASE_LATER("Forms", "&Received on"),
                                                      .whenEmpty = PHRASE_LATER("Forms", "YYYY-MM-DD"),
                                                      .isOfMeasurement = false,
                                                      .isOfOneMeasurement = true}),
    ofSession<&Session::instrument, &Instrument::name>({.key = "instrument.name",
                                                        .noun = PHRASE_LATER("Field", "instrument"),
                                                        .caption = PHRASE_LATER("Forms", "Instrument"),
                                                        .whenEmpty = PHRASE_LATER("Forms", "model"),
                                                        .fillsRow = true,
                                                        .isWantedOnReport = true}),
    ofSession<&Session::instrument, &Instrument::serial>(
        {.key = "instrument.serial",
         .noun = PHRASE_LATER("Field", "instrument serial number"),
         .caption = PHRASE_LATER("Forms", "Serial no."),
         .isWantedOnReport = true}),
    ofSession<&Session::instrument, &Instrument::certificate>(
        {.key = "instrument.certificate",
         .noun = PHRASE_LATER("Field", "instrument certificate"),
         .caption = PHRASE_LATER("Forms", "Certificate"),
         .help = PHRASE_LATER("Forms", "Calibration certificate of the instrument, for the report"),
         .isWantedOnReport = true}),
    ofSession<&Session::instrument, &Instrument::traceability>(
        {.key = "instrument.traceability",
         .noun = PHRASE_LATER("Field", "traceability of the circles"),
         .caption = PHRASE_LATER("Forms", "Circles traceable"),
         .whenEmpty = PHRASE_LATER("Forms", "to"),
         .help = PHRASE_LATER(
             "Forms", "To which standards the circles are traceable, and through whom; for the report"),
         .fillsRow = true,
         .isWantedOnReport = true}),
    ofSession<&Session::instrument, &Instrument::angleUnit>({.key = "instrument.angle_unit",
                                                             .noun = PHRASE_LATER("Field", "unit of angles"),
                                                             .rule = &wordRule<circleUnitEntry>}),
    ofSession<&Session::instrument, &Instrument::sigmaHorizontalArcsec>(
        {.key = "instrument.sigma_horizontal_arcsec",
         .noun = PHRASE_LATER("Field", "σ of the horizontal circle"),
         .rule = NumberRule{leastSigmaArcsec, Bound::Included, largestSigmaArcsec, 2, noSigma},
         .caption = PHRASE_LATER("Forms", "σ ho&rizontal"),
         .unit = arcseconds,
         .whenEmpty = PHRASE_LATER("Forms", "2"),
         .help = PHRASE_LATER("Forms", "Stated standard deviation of one horizontal reading")}),
    ofSession<&Session::instrument, &Instrument::sigmaVerticalArcsec>(
        {.key = "instrument.sigma_vertical_arcsec",
         .noun = PHRASE_LATER("Field", "σ of the vertical circle"),
         .rule = NumberRule{leastSigmaArcsec, Bound::Included, largestSigmaArcsec, 2, noSigma},
         .caption = PHRASE_LATER("Forms", "σ vertical"),
         .unit = arcseconds,
         .whenEmpty = PHRASE_LATER("Forms", "2"),
         .help = PHRASE_LATER("Forms", "Stated standard deviation of one vertical reading")}),
    ofSession<&Session::instrument, &Instrument::sigmaZeroArcsec>(
        {.key = "instrument.sigma_zero_arcsec",
         .noun = PHRASE_LATER("Field", "σ of the pointing zero"),
         .rule =
             NumberRule{0,
                        Bound::Included,
                        largestSigmaArcsec,
                        {},
                        PHRASE_LATER("Phrase",
                                     "%1 is out of range: it must be 0 or more and below 3600 arcseconds")},
         .caption = PHRASE_LATER("Forms", "σ of &zeros"),
         .unit = arcseconds,
         .whenEmpty = PHRASE_LATER("Forms", "same as circles"),
         .help =
             PHRASE_LATER("Forms", "Standard uncertainty of one sighting of the pointing zeros α0 and β0")}),
    ofSession<&Session::instrument, &Instrument::sigmaSliderArcsec>(
        {.key = "instrument.sigma_slider_arcsec",
         .noun = PHRASE_LATER("Field", "σ of the slider"),
         .rule = NumberRule{leastSigmaArcsec, Bound::Included, largestSigmaArcsec, 5, noSigma},
         .caption = PHRASE_LATER("Forms", "σ slider"),
         .unit = arcseconds,
         .whenEmpty = PHRASE_LATER("Forms", "5"),
         .help = PHRASE_LATER("Forms", "Standard deviation of one slider reading")}),
    ofSession<&Session::instrument, &Instrument::sigmaCompensatorArcsec>(
        {.key = "instrument.sigma_compensator_arcsec",
         .noun = PHRASE_LATER("Field", "σ of the compensator"),
         .rule = NumberRule{leastSigmaArcsec, Bound::Included, largestSigmaArcsec, usualSigmaCompensator,
                            noSigma},
         .caption = PHRASE_LATER("Forms", "σ compensator"),
         .unit = arcseconds,
         .whenEmpty = PHRASE_LATER("Forms", "1"),
         .help = PHRASE_LATER("Forms",
                              "Setting accuracy of the compensator from its data sheet; used if the rows "
                              "have tilts or state what the instrument corrected")}),
    ofSession<&Session::instrument, &Instrument::lineOfSight, &LineOfSight::offsetMm>(
        {.key = "instrument.line_of_sight_mm",
         .noun = PHRASE_LATER("Field", "offset of the line of sight"),
         .rule =
             NumberRule{-largestOffsetMm,
                        Bound::Excluded,
                        largestOffsetMm,
                        {},
                        PHRASE_LATER("Phrase", "%1 is out of range: it must be above -10 and below 10 mm")},
         .caption = PHRASE_LATER("Forms", "Line of sight e"),
         .unit = mm,
         .whenEmpty = PHRASE_LATER("Forms", "not known"),
         .help =
             PHRASE_LATER("Forms",
                          "Offset e of the line of sight from the vertical axis, from the instrument check; "
                          "e/D, with the distance D of the slider, is added to the known collimation")}),
    ofSession<&Session::instrument, &Instrument::lineOfSight, &LineOfSight::sigmaMm>(
        {.key = "instrument.sigma_line_of_sight_mm",
         .noun = PHRASE_LATER("Field", "u of the offset of the line of sight"),
         .rule =
             NumberRule{0, Bound::Included, largestOffsetMm, 0,
                        PHRASE_LATER("Phrase", "%1 is out of range: it must be 0 or more and below 10 mm")},
         .caption = PHRASE_LATER("Forms", "u of e"),
         .unit = mm,
         .whenEmpty = PHRASE_LATER("Forms", "0"),
         .help = PHRASE_LATER("Forms", "Standard uncertainty of the offset of the line of sight")}),
    ofSession<&Session::instrument, &Instrument::lineOfSight, &LineOfSight::correlation>(
        {.key = "instrument.line_of_sight_correlation",
         .noun = PHRASE_LATER("Field", "correlation of the offset with the collimation"),
         .rule = NumberRule{-1, Bound::Excluded, 1, 0,
                            PHRASE_LATER("Phrase", "%1 is out of range: it must be above -1 and below 1")},
         .caption = PHRASE_LATER("Forms", "Correlation of e"),
         .whenEmpty = PHRASE_LATER("Forms", "0"),
         .help = PHRASE_LATER(
             "Forms",
             "Correlation of the offset with the known collimation, −1 to 1: both come from one fit")}),
    ofSession<&Session::environment, &Environment::temperatureC>(
        {.key = "environment.temperature_c",
         .noun = PHRASE_LATER("Field", "temperature"),
         .rule =
             NumberRule{
                 -273.15,
                 Bound::Included,
                 1000,
                 {},
                 PHRASE_LATER("Phrase", "%1 is out of range: it must be at least -273.15 and below 1000 °C")},
         .caption = PHRASE_LATER("Forms", "&Temp."),
         .unit = PHRASE_LATER("Forms", "°C"),
         .help = PHRASE_LATER("Forms", "Temperature of the device and of the air"),
         .isOfOneMeasurement = true,
         .isWantedOnReport = true}),
    ofSession<&Session::environment, &Environment::sigmaTemperatureC>(
        {.key = "environment.sigma_temperature_c",
         .noun = PHRASE_LATER("Field", "σ of the temperature"),
         .rule =
             NumberRule{0, Bound::Included, 1000, 0,
                        PHRASE_LATER("Phrase", "%1 is out of range: it must be 0 or more and below 1000 K")},
         .caption = PHRASE_LATER("Forms", "σ of temp."),
         .unit = PHRASE_LATER("Forms", "K"),
         .whenEmpty = PHRASE_LATER("Forms", "0 (exact)"),
         .help = PHRASE_LATER("Forms", "Standard uncertainty of the temperature"),
         .isOfOneMeasurement = true}),
    ofSession<&Session::geometry, &Geometry::distanceMm>(
        {.key = "geometry.distance_mm",
         .noun = PHRASE_LATER("Field", "distance L"),
         .rule = NumberRule{0,
                            Bound::Excluded,
                            longestMm,
                            {},
                            noLength,
                            PHRASE_LATER(
                                "Phrase",
                                "is empty: type the distance from the theodolite to the arc plane in mm")},
         .remedy = PHRASE_LATER("Phrase", "add the distance from the theodolite to the arc plane in mm"),
         .caption = PHRASE_LATER("Forms", "Distance &L"),
         .unit = mm,
         .whenEmpty = PHRASE_LATER("Forms", "required"),
         .help = PHRASE_LATER("Forms", "From the theodolite's centre to the plane of the arc"),
         .isOfOneMeasurement = true}),
    ofSession<&Session::geometry, &Geometry::sigmaDistanceMm>(
        {.key = "geometry.sigma_distance_mm",
         .noun = PHRASE_LATER("Field", "σ of the distance"),
         .rule = NumberRule{0, Bound::Included, longestMm, 0, noSigmaOfLength},
         .caption = PHRASE_LATER("Forms", "σ of L"),
         .unit = mm,
         .whenEmpty = PHRASE_LATER("Forms", "0 (exact)"),
         .help = PHRASE_LATER("Forms", "Standard uncertainty of the distance; empty means exact"),
         .isOfOneMeasurement = true,
         .isWantedOnReport = true}),
    ofSession<&Session::geometry, &Geometry::radiusMm>(
        {.key = "geometry.radius_mm",
         .noun = PHRASE_LATER("Field", "nominal radius"),
         .rule = NumberRule{0,
                            Bound::Excluded,
                            longestMm,
                            {},
                            noLength,
                            PHRASE_LATER("Phrase", "is empty: type the nominal radius of the arc in mm")},
         .remedy = PHRASE_LATER("Phrase", "add the nominal radius of the arc in mm"),
         .caption = PHRASE_LATER("Forms", "&Radius R0"),
         .unit = mm,
         .whenEmpty = PHRASE_LATER("Forms", "required"),
         .help = PHRASE_LATER("Forms", "Nominal radius of the arc")}),
    ofSession<&Session::geometry, &Geometry::sigmaRadiusMm>(
        {.key = "geometry.sigma_radius_mm",
         .noun = PHRASE_LATER("Field", "σ of the radius"),
         .rule = NumberRule{0, Bound::Included, longestMm, 0, noSigmaOfLength},
         .caption = PHRASE_LATER("Forms", "σ of R0"),
         .unit = mm,
         .help = PHRASE_LATER("Forms",
                              "Standard uncertainty of the nominal radius. With a known radius, it weights "
                              "R0 in the fit; empty means exact. With a free or common radius, it makes R − "
                              "R0 a closure; empty means no closure")}),
    ofSession<&Session::geometry, &Geometry::verticalCircle>(
        {.key = "geometry.vertical_circle",
         .noun = PHRASE_LATER("Field", "vertical circle"),
         .rule = &wordRule<verticalCircleEntry>,
         .caption = PHRASE_LATER("Forms", "Vert. c&ircle"),
         .help = PHRASE_LATER(
             "Forms",
             "What the vertical circle reads: zenith angles grow downwards, elevation angles upwards"),
         .choices = circleChoices}),
    ofSession<&Session::geometry, &Geometry::pointingZeros>(
        {.key = "geometry.pointing_zeros",
         .noun = PHRASE_LATER("Field", "pointing zeros"),
         .rule = &wordRule<pointingZerosEntry>,
         .caption = PHRASE_LATER("Forms", "Pointing zeros"),
         .help = PHRASE_LATER("Forms",
                              "Each: sighted again in every position. One for all: sighted once, so that its "
                              "error cancels in Δd"),
         .choices = zeroChoices}),
    ofSession<&Session::geometry, &Geometry::plane>(
        {.key = "geometry.plane",
         .noun = PHRASE_LATER("Field", "plane of the arc"),
         .rule = &wordRule<arcPlaneEntry>,
         .caption = PHRASE_LATER("Forms", "Arc's plane"),
         .help = PHRASE_LATER(
             "Forms",
             "For an instrument above or below the axis, whose pointing zero is inclined. Vertical: the "
             "plane of the arc is plumb. Square: the plane is perpendicular to the pointing zero"),
         .choices = planeChoices}),
    ofSession<&Session::geometry, &Geometry::zeroIs>(
        {.key = "geometry.zero_is",
         .noun = PHRASE_LATER("Field", "target of the pointing zeros"),
         .rule = &wordRule<zeroIsEntry>,
         .caption = PHRASE_LATER("Forms", "Zeros sight"),
         .help = PHRASE_LATER("Forms",
                              "Mark: a fixed target; different zeros show a drift or a knocked tripod. "
                              "Normal: the normal of the guideway, set again in each position. Unstated: "
                              "treated as a mark if the zeros agree within 30″"),
         .choices = markChoices}),
    ofSession<&Session::geometry, &Geometry::distanceFrom>(
        {.key = "geometry.distance_from",
         .noun = PHRASE_LATER("Field", "method of the distance measurement"),
         .caption = PHRASE_LATER("Forms", "L measured"),
         .whenEmpty = PHRASE_LATER("Forms", "how"),
         .help = PHRASE_LATER("Forms", "How the distance was measured, and its traceability; for the report"),
         .isWantedOnReport = true}),
    ofSession<&Session::geometry, &Geometry::distanceExpansionPpmPerK>(
        {.key = "geometry.distance_expansion_ppm_per_k",
         .noun = PHRASE_LATER("Field", "expansion of the distance"),
         .rule = NumberRule{-1000, Bound::Included, 1000, 0, noExpansion},
         .caption = PHRASE_LATER("Forms", "L expands"),
         .unit = PHRASE_LATER("Forms", "ppm/K"),
         .whenEmpty = PHRASE_LATER("Forms", "none"),
         .help = PHRASE_LATER("Forms",
                              "Expansion of L per kelvin if L is stated for 20 °C; empty if L was measured "
                              "at the temperature of this session")}),
    ofSession<&Session::geometry, &Geometry::radiusExpansionPpmPerK>(
        {.key = "geometry.radius_expansion_ppm_per_k",
         .noun = PHRASE_LATER("Field", "expansion of the radius"),
         .rule = NumberRule{-1000, Bound::Included, 1000, 0, noExpansion},
         .caption = PHRASE_LATER("Forms", "R0 expands"),
         .unit = PHRASE_LATER("Forms", "ppm/K"),
         .whenEmpty = PHRASE_LATER("Forms", "none"),
         .help = PHRASE_LATER("Forms", "Expansion of R0 per kelvin; R0 is stated for 20 °C. Steel: 11.5")}),
    ofSession<&Session::acceptance, &Acceptance::toleranceMm>(
        {.key = "acceptance.tolerance_mm",
         .noun = PHRASE_LATER("Field", "tolerance"),
         .rule = NumberRule{0, Bound::Excluded, longestMm, {}, noLength},
         .caption = PHRASE_LATER("Forms", "&Tolerance"),
         .unit = mm,
         .whenEmpty = PHRASE_LATER("Forms", "none"),
         .help = PHRASE_LATER("Forms",
                              "Largest acceptable value of the quantity under “Limits”; without a tolerance "
                              "there is no verdict")}),
    ofSession<&Session::acceptance, &Acceptance::measurand>(
        {.key = "acceptance.measurand",
         .noun = PHRASE_LATER("Field", "quantity limited by the tolerance"),
         .rule = &wordRule<measurandEntry>,
         .caption = PHRASE_LATER("Forms", "Limits"),
         .help = PHRASE_LATER(
             "Forms",
             "The quantity that the tolerance limits. Δd: distance of the arc's centre from the axis in the "
             "plane of the arc. Distance: the whole distance of the centre from the axis"),
         .choices = measurandChoices}),
    ofSession<&Session::acceptance, &Acceptance::coverage>(
        {.key = "acceptance.coverage",
         .noun = PHRASE_LATER("Field", "coverage"),
         .rule = NumberRule{0, Bound::Excluded, 1, 0.95,
                            PHRASE_LATER("Phrase",
                                         "%1 is out of range: it must be between 0 and 1, such as 0.95")},
         .caption = PHRASE_LATER("Forms", "Covera&ge"),
         .whenEmpty = PHRASE_LATER("Forms", "0.95"),
         .help =
             PHRASE_LATER("Forms", "Coverage probability of the expanded uncertainty U, between 0 and 1")}),
    ofSession<&Session::acceptance, &Acceptance::referenceIntersectionMm>(
        {.key = "acceptance.reference_intersection_mm",
         .noun = PHRASE_LATER("Field", "reference intersection"),
         .rule = NumberRule{-infinite,
                            Bound::Excluded,
                            infinite,
                            {},
                            PHRASE_LATER("Phrase", "%1 is out of range: it must be a length in mm")},
         .caption = PHRASE_LATER("Forms", "Reference"),
         .unit = mm,
         .whenEmpty = PHRASE_LATER("Forms", "none"),
         .help = PHRASE_LATER("Forms",
                              "Setting of the device, if known; shown with the result, not used in the fit"),
         .isOfOneMeasurement = true}),
    ofSession<&Session::acceptance, &Acceptance::sigmaReferenceMm>(
        {.key = "acceptance.sigma_reference_mm",
         .noun = PHRASE_LATER("Field", "σ of the reference"),
         .rule = NumberRule{0, Bound::Excluded, longestMm, {}, noLength},
         .caption = PHRASE_LATER("Forms", "σ of ref."),
         .unit = mm,
         .whenEmpty = PHRASE_LATER("Forms", "none"),
         .help =
             PHRASE_LATER("Forms",
                          "Standard uncertainty of the reference. If stated, Δd − reference is a closure and "
                          "may help the diagnosis to distinguish causes; Δd never depends on the reference"),
         .isOfOneMeasurement = true}),
    ofSession<&Session::model, &Model::verticalAngle>(
        {.key = "model.vertical_angle",
         .noun = PHRASE_LATER("Field", "vertical angle relation"),
         .rule = &wordRule<verticalAngleEntry>,
         .caption = PHRASE_LATER("Forms", "Relation"),
         .help = PHRASE_LATER(
             "Forms",
             "Exact: tan e = y/√(x²+L²), what a theodolite reads. Planar: tan e = y/L, as in the "
             "published method"),
         .choices = relationChoices}),
    ofSession<&Session::model, &Model::radius>(
        {.key = "model.radius",
         .noun = PHRASE_LATER("Field", "radius model"),
         .rule = &wordRule<radiusModelEntry>,
         .caption = PHRASE_LATER("Forms", "R&adius is"),
         .help = PHRASE_LATER("Forms",
                              "Free: a radius for each arc. Common: one radius for both arcs. Known: R0 with "
                              "its σ is one more observation"),
         .choices = radiusChoices}),
};

constexpr std::string_view ofMeasurement[] = {"geometry.distance_mm",
                                              "geometry.sigma_distance_mm",
                                              "geometry.radius_mm",
                                              "geometry.sigma_radius_mm",
                                              "model.radius",
                                              "geometry.vertical_circle",
                                              "model.vertical_angle",
                                              "acceptance.coverage",
                                              "acceptance.tolerance_mm",
                                              "acceptance.measurand",
                                              "acceptance.reference_intersection_mm",
                                              "acceptance.sigma_reference_mm",
                                              "geometry.plane"};
constexpr std::string_view ofInstrument[] = {"instrument.name",
                                             "instrument.serial",
                                             "geometry.pointing_zeros",
                                             "geometry.zero_is",
                                             "instrument.sigma_horizontal_arcsec",
                                             "instrument.sigma_vertical_arcsec",
                                             "instrument.sigma_zero_arcsec",
                                             "instrument.sigma_slider_arcsec",
                                             "instrument.line_of_sight_mm",
                                             "instrument.sigma_line_of_sight_mm",
                                             "instrument.line_of_sight_correlation",
                                             "instrument.sigma_compensator_arcsec",
                                             "device.name",
                                             "device.serial"};
constexpr std::string_view ofLaboratory[] = {
    "report.number",          "report.authorised_by",   "report.laboratory",  "report.customer",
    "report.rule_agreed_by",  "device.condition",       "device.received_on", "instrument.certificate",
    "geometry.distance_from", "instrument.traceability"};
constexpr std::string_view ofSessionForm[] = {"title",
                                              "operator",
                                              "place",
                                              "measured_on",
                                              "environment.temperature_c",
                                              "environment.sigma_temperature_c",
                                              "geometry.distance_expansion_ppm_per_k",
                                              "geometry.radius_expansion_ppm_per_k"};

}  // namespace

std::span<const SessionField> sessionFields() {
  return allSessionFields;
}

const SessionField* sessionFieldNamed(std::string_view key) {
  const auto* const found = std::ranges::find(allSessionFields, key, &SessionField::key);
  return found == std::end(allSessionFields) ? nullptr : found;
}

bool isSameMeasurement(const Session& a, const Session& b) {
  if (a.positions != b.positions) return false;  // most edits differ here, which saves the copy
  Session same = a;
  for (const SessionField& field : allSessionFields)
    if (!field.isOfMeasurement) field.at(same) = field.get(b);
  same.journal = b.journal;
  same.origin = b.origin;
  return same == b;
}

std::string withoutUnit(const SessionField& field, const std::string& typed) {
  const std::string unit = field.unit ? field.unit : "";
  if (unit.empty() || field.kind() != ValueKind::Number || !typed.ends_with(unit)) return typed;
  std::string number = typed.substr(0, typed.size() - unit.size());
  number.erase(number.find_last_not_of(' ') + 1);
  return parseNumber(number) ? number : typed;
}

std::optional<Problem> entryProblem(const SessionField& field, const std::string& text) {
  if (const auto* number = std::get_if<NumberRule>(&field.rule)) {
    const auto value = numberEntry(*number, text);
    return value ? std::nullopt : std::optional(value.problem());
  }
  const auto* word = std::get_if<WordRule>(&field.rule);
  return word ? (*word)(text) : std::nullopt;
}

const std::span<const std::string_view> measurementForm = ofMeasurement, instrumentForm = ofInstrument,
                                        laboratoryForm = ofLaboratory, sessionForm = ofSessionForm;

}  // namespace alidade
