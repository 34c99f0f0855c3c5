#include "ui/document/field.h"

#include <QtGlobal>
#include <algorithm>
#include <iterator>

namespace alidade::ui {

namespace {

template <auto... members>
constexpr Field ofSession(std::string_view name, const char* noun) {
  return {name, noun,
          [](const Session& session, std::size_t) -> const std::string& { return (session.*....*members); },
          [](Session& session, std::size_t) -> std::string& { return (session.*....*members); }, false};
}

template <auto... members>
constexpr Field ofPosition(std::string_view name, const char* noun) {
  return {name, noun,
          [](const Session& session, std::size_t position) -> const std::string& {
            return (session.positions.at(position).*....*members);
          },
          [](Session& session, std::size_t position) -> std::string& {
            return (session.positions.at(position).*....*members);
          },
          true};
}

constexpr Field fields[] = {
    ofSession<&Session::title>("title", QT_TRANSLATE_NOOP("Field", "title")),
    ofSession<&Session::notes>("notes", QT_TRANSLATE_NOOP("Field", "notes")),
    ofSession<&Session::operatorName>("operator", QT_TRANSLATE_NOOP("Field", "operator")),
    ofSession<&Session::place>("place", QT_TRANSLATE_NOOP("Field", "place")),
    ofSession<&Session::measuredOn>("measured_on", QT_TRANSLATE_NOOP("Field", "date")),
    ofSession<&Session::report, &ReportEntries::number>("report.number",
                                                        QT_TRANSLATE_NOOP("Field", "report number")),
    ofSession<&Session::report, &ReportEntries::laboratory>("report.laboratory",
                                                            QT_TRANSLATE_NOOP("Field", "laboratory")),
    ofSession<&Session::report, &ReportEntries::customer>("report.customer",
                                                          QT_TRANSLATE_NOOP("Field", "customer")),
    ofSession<&Session::report, &ReportEntries::authorisedBy>("report.authorised_by",
                                                              QT_TRANSLATE_NOOP("Field", "authorised by")),
    ofSession<&Session::report, &ReportEntries::ruleAgreedBy>(
        "report.rule_agreed_by", QT_TRANSLATE_NOOP("Field", "decision rule agreed by")),
    ofSession<&Session::device, &Device::name>("device.name", QT_TRANSLATE_NOOP("Field", "device")),
    ofSession<&Session::device, &Device::serial>("device.serial",
                                                 QT_TRANSLATE_NOOP("Field", "device serial number")),
    ofSession<&Session::instrument, &Instrument::name>("instrument.name",
                                                       QT_TRANSLATE_NOOP("Field", "instrument")),
    ofSession<&Session::instrument, &Instrument::serial>(
        "instrument.serial", QT_TRANSLATE_NOOP("Field", "instrument serial number")),
    ofSession<&Session::instrument, &Instrument::certificate>(
        "instrument.certificate", QT_TRANSLATE_NOOP("Field", "instrument certificate")),
    ofSession<&Session::instrument, &Instrument::traceability>(
        "instrument.traceability", QT_TRANSLATE_NOOP("Field", "traceability of the circles")),
    ofSession<&Session::instrument, &Instrument::angleUnit>("instrument.angle_unit",
                                                            QT_TRANSLATE_NOOP("Field", "unit of angles")),
    ofSession<&Session::instrument, &Instrument::sigmaHorizontalArcsec>(
        "instrument.sigma_horizontal_arcsec", QT_TRANSLATE_NOOP("Field", "σ of the horizontal circle")),
    ofSession<&Session::instrument, &Instrument::sigmaVerticalArcsec>(
        "instrument.sigma_vertical_arcsec", QT_TRANSLATE_NOOP("Field", "σ of the vertical circle")),
    ofSession<&Session::instrument, &Instrument::sigmaZeroArcsec>(
        "instrument.sigma_zero_arcsec", QT_TRANSLATE_NOOP("Field", "σ of the pointing zero")),
    ofSession<&Session::instrument, &Instrument::sigmaSliderArcsec>(
        "instrument.sigma_slider_arcsec", QT_TRANSLATE_NOOP("Field", "σ of the slider")),
    ofSession<&Session::instrument, &Instrument::sigmaCompensatorArcsec>(
        "instrument.sigma_compensator_arcsec", QT_TRANSLATE_NOOP("Field", "σ of the compensator")),
    ofSession<&Session::instrument, &Instrument::lineOfSight, &LineOfSight::offsetMm>(
        "instrument.line_of_sight_mm", QT_TRANSLATE_NOOP("Field", "offset of the line of sight")),
    ofSession<&Session::instrument, &Instrument::lineOfSight, &LineOfSight::sigmaMm>(
        "instrument.sigma_line_of_sight_mm",
        QT_TRANSLATE_NOOP("Field", "u of the offset of the line of sight")),
    ofSession<&Session::instrument, &Instrument::lineOfSight, &LineOfSight::correlation>(
        "instrument.line_of_sight_correlation",
        QT_TRANSLATE_NOOP("Field", "correlation of the offset with the collimation")),
    ofSession<&Session::environment, &Environment::temperatureC>("environment.temperature_c",
                                                                 QT_TRANSLATE_NOOP("Field", "temperature")),
    ofSession<&Session::environment, &Environment::sigmaTemperatureC>(
        "environment.sigma_temperature_c", QT_TRANSLATE_NOOP("Field", "σ of the temperature")),
    ofSession<&Session::geometry, &Geometry::distanceMm>("geometry.distance_mm",
                                                         QT_TRANSLATE_NOOP("Field", "distance L")),
    ofSession<&Session::geometry, &Geometry::sigmaDistanceMm>(
        "geometry.sigma_distance_mm", QT_TRANSLATE_NOOP("Field", "σ of the distance")),
    ofSession<&Session::geometry, &Geometry::radiusMm>("geometry.radius_mm",
                                                       QT_TRANSLATE_NOOP("Field", "nominal radius")),
    ofSession<&Session::geometry, &Geometry::sigmaRadiusMm>("geometry.sigma_radius_mm",
                                                            QT_TRANSLATE_NOOP("Field", "σ of the radius")),
    ofSession<&Session::geometry, &Geometry::verticalCircle>("geometry.vertical_circle",
                                                             QT_TRANSLATE_NOOP("Field", "vertical circle")),
    ofSession<&Session::geometry, &Geometry::pointingZeros>("geometry.pointing_zeros",
                                                            QT_TRANSLATE_NOOP("Field", "pointing zeros")),
    ofSession<&Session::geometry, &Geometry::plane>("geometry.plane",
                                                    QT_TRANSLATE_NOOP("Field", "plane of the arc")),
    ofSession<&Session::geometry, &Geometry::zeroIs>("geometry.zero_is",
                                                     QT_TRANSLATE_NOOP("Field", "what the zeros sight")),
    ofSession<&Session::geometry, &Geometry::distanceFrom>(
        "geometry.distance_from", QT_TRANSLATE_NOOP("Field", "how the distance was measured")),
    ofSession<&Session::geometry, &Geometry::distanceExpansionPpmPerK>(
        "geometry.distance_expansion_ppm_per_k", QT_TRANSLATE_NOOP("Field", "expansion of the distance")),
    ofSession<&Session::geometry, &Geometry::radiusExpansionPpmPerK>(
        "geometry.radius_expansion_ppm_per_k", QT_TRANSLATE_NOOP("Field", "expansion of the radius")),
    ofSession<&Session::acceptance, &Acceptance::toleranceMm>("acceptance.tolerance_mm",
                                                              QT_TRANSLATE_NOOP("Field", "tolerance")),
    ofSession<&Session::acceptance, &Acceptance::coverage>("acceptance.coverage",
                                                           QT_TRANSLATE_NOOP("Field", "coverage")),
    ofSession<&Session::acceptance, &Acceptance::referenceIntersectionMm>(
        "acceptance.reference_intersection_mm", QT_TRANSLATE_NOOP("Field", "reference intersection")),
    ofSession<&Session::acceptance, &Acceptance::sigmaReferenceMm>(
        "acceptance.sigma_reference_mm", QT_TRANSLATE_NOOP("Field", "σ of the reference")),
    ofSession<&Session::acceptance, &Acceptance::measurand>(
        "acceptance.measurand", QT_TRANSLATE_NOOP("Field", "what the tolerance limits")),
    ofSession<&Session::model, &Model::verticalAngle>("model.vertical_angle",
                                                      QT_TRANSLATE_NOOP("Field", "vertical angle relation")),
    ofSession<&Session::model, &Model::radius>("model.radius", QT_TRANSLATE_NOOP("Field", "radius model")),
    ofSession<&Session::protocol>("protocol", QT_TRANSLATE_NOOP("Field", "protocol")),
    ofPosition<&Position::axisDeg>("axis_deg", QT_TRANSLATE_NOOP("Field", "axis position")),
    ofPosition<&Position::zero, &PointingZero::horizontal>("pointing_zero.horizontal",
                                                           QT_TRANSLATE_NOOP("Field", "pointing zero α0")),
    ofPosition<&Position::zero, &PointingZero::vertical>("pointing_zero.vertical",
                                                         QT_TRANSLATE_NOOP("Field", "pointing zero β0")),
    ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::horizontal>(
        "pointing_zero.face_2.horizontal", QT_TRANSLATE_NOOP("Field", "pointing zero α0 in face 2")),
    ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::vertical>(
        "pointing_zero.face_2.vertical", QT_TRANSLATE_NOOP("Field", "pointing zero β0 in face 2")),
    ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::horizontal>(
        "pointing_zero.after.horizontal", QT_TRANSLATE_NOOP("Field", "pointing zero α0 after the readings")),
    ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::vertical>(
        "pointing_zero.after.vertical", QT_TRANSLATE_NOOP("Field", "pointing zero β0 after the readings")),
    ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::horizontal>(
        "pointing_zero.after_face_2.horizontal",
        QT_TRANSLATE_NOOP("Field", "pointing zero α0 after the readings in face 2")),
    ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::vertical>(
        "pointing_zero.after_face_2.vertical",
        QT_TRANSLATE_NOOP("Field", "pointing zero β0 after the readings in face 2")),
    ofPosition<&Position::zero, &PointingZero::takenAt>(
        "pointing_zero.taken_at", QT_TRANSLATE_NOOP("Field", "time of the pointing zero")),
    ofPosition<&Position::zero, &PointingZero::returnCode>(
        "pointing_zero.return_code", QT_TRANSLATE_NOOP("Field", "return code of the pointing zero")),
    ofPosition<&Position::zero, &PointingZero::instrumentSerial>(
        "pointing_zero.instrument_serial",
        QT_TRANSLATE_NOOP("Field", "instrument serial number of the pointing zero")),
    ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::takenAt>(
        "pointing_zero.face_2.taken_at", QT_TRANSLATE_NOOP("Field", "time of the pointing zero in face 2")),
    ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::returnCode>(
        "pointing_zero.face_2.return_code",
        QT_TRANSLATE_NOOP("Field", "return code of the pointing zero in face 2")),
    ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::instrumentSerial>(
        "pointing_zero.face_2.instrument_serial",
        QT_TRANSLATE_NOOP("Field", "instrument serial number of the pointing zero in face 2")),
    ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::takenAt>(
        "pointing_zero.after.taken_at",
        QT_TRANSLATE_NOOP("Field", "time of the pointing zero after the readings")),
    ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::returnCode>(
        "pointing_zero.after.return_code",
        QT_TRANSLATE_NOOP("Field", "return code of the pointing zero after the readings")),
    ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::instrumentSerial>(
        "pointing_zero.after.instrument_serial",
        QT_TRANSLATE_NOOP("Field", "instrument serial number of the pointing zero after the readings")),
    ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::takenAt>(
        "pointing_zero.after_face_2.taken_at",
        QT_TRANSLATE_NOOP("Field", "time of the pointing zero after the readings in face 2")),
    ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::returnCode>(
        "pointing_zero.after_face_2.return_code",
        QT_TRANSLATE_NOOP("Field", "return code of the pointing zero after the readings in face 2")),
    ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::instrumentSerial>(
        "pointing_zero.after_face_2.instrument_serial",
        QT_TRANSLATE_NOOP("Field",
                          "instrument serial number of the pointing zero after the readings in face 2")),
};

}  // namespace

std::span<const Field> allFields() {
  return fields;
}

const Field* fieldNamed(std::string_view name) {
  const auto found = std::find_if(std::begin(fields), std::end(fields),
                                  [name](const Field& field) { return field.name == name; });
  return found == std::end(fields) ? nullptr : found;
}

std::string fieldText(const Session& session, const Place& place) {
  const Field* field = fieldNamed(place.field);
  if (!field || (place.position && *place.position >= session.positions.size())) return {};
  return field->get(session, place.position.value_or(0));
}

}  // namespace alidade::ui
