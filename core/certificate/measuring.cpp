#include "core/certificate/measurement_results.h"

#include <algorithm>

#include "core/base/phrase.h"
#include "core/certificate/administrative_data.h"
#include "core/certificate/quantity.h"
#include "core/observation/visits.h"
#include "core/session/entry.h"

namespace alidade {

namespace {

void addMethods(const Element& to, const FitAnswer& answer) {
  const Element list = to.add("usedMethods");
  const Element fit = list.add("usedMethod");
  fit.say("name", [] { return Phrase::of("Rigorous least-squares fit of the arcs to theodolite readings"); });
  fit.say("description", [] {
    return Phrase::of(
        "Directions and vertical angles to the slider in the positions 0° and 180° of the axis, adjusted "
        "together; Δd = (y(O1) − y(O2))/2, y up: positive if the arc's centre is higher at 0°.");
  });
  fit.value("norm", "JCGM 100:2008");
  fit.value("reference", "Cui, Ren, Yuan, Liu: Intersection Measurement for Rotatable Arc Guideway System");
  if (!answer.diagnosis) return;
  const Element diagnosis = list.add("usedMethod");
  diagnosis.say("name", [] { return Phrase::of("Diagnosis of the gap between model and readings"); });
  diagnosis.say("description", [] {
    return Phrase::of(
        "Δd, measured, is averaged over every explanation that the readings do not exclude, with every "
        "catalogued effect as large as readings and its plausible or known size allow.");
  });
}

void addIdentities(const Element& to, const Instrument& instrument) {
  const std::string serial = certificateText(instrument.serial),
                    certificate = certificateText(instrument.certificate);
  if (serial.empty() && certificate.empty()) return;
  const Element list = to.add("identifications");
  if (!serial.empty())
    list.identification(
        "manufacturer", serial, [] { return Phrase::of("Serial number"); }, "basic_serialNumber");
  if (!certificate.empty())
    list.identification("other", certificate,
                        [] { return Phrase::of("Calibration certificate of the instrument"); });
}

void addSigmas(const Element& to, const Measurement& measurement) {
  const Element list = to.add("measuringEquipmentQuantities");
  const auto add = [&](const char* id, const Say& name, Angle sigma) {
    addQuantity(list, {.id = id, .name = name, .value = sigma.arcseconds(), .unit = "\\arcsecond"},
                "measuringEquipmentQuantity");
  };
  add(
      "sigma_horizontal", [] { return Phrase::of("Standard uncertainty of a direction"); },
      measurement.sigmaHorizontal);
  add(
      "sigma_vertical", [] { return Phrase::of("Standard uncertainty of a vertical angle"); },
      measurement.sigmaVertical);
  add(
      "sigma_zero_horizontal",
      [] { return Phrase::of("Standard uncertainty of a pointing zero's direction"); },
      measurement.sigmaZeroHorizontal);
  add(
      "sigma_zero_vertical",
      [] { return Phrase::of("Standard uncertainty of a pointing zero's vertical angle"); },
      measurement.sigmaZeroVertical);
  if (std::ranges::any_of(measurement.arcs, hasSliderReadings))
    add(
        "sigma_slider", [] { return Phrase::of("Standard uncertainty of a slider reading"); },
        measurement.sigmaSlider);
}

void addTheodolite(const Element& to, const CertificateSource& source) {
  const Instrument& instrument = source.session.instrument;
  const Element theodolite = to.add("measuringEquipments").add("measuringEquipment");
  theodolite.attribute("id", "theodolite");
  const std::string name = certificateText(instrument.name),
                    traceability = certificateText(instrument.traceability);
  if (name.empty())
    theodolite.say("name", [] { return Phrase::of("Theodolite, name not stated"); });
  else
    theodolite.typed("name", name);
  if (!traceability.empty())
    theodolite.say("description", [&] { return Phrase::of("Circles traceable: %1", traceability); });
  addIdentities(theodolite, instrument);
  addSigmas(theodolite, source.answer.measurement);
}

void addCondition(const Element& list, const StatedQuantity& quantity) {
  const Element condition = list.add("influenceCondition");
  if (quantity.refType) condition.attribute("refType", quantity.refType);
  condition.say("name", quantity.name);
  addQuantity(condition.add("data"), quantity);
}

/// Converts a typed temperature, as `examine` does only if a length expands. Absent if empty or invalid.
std::optional<double> typedNumber(std::string_view field, const std::string& text) {
  const Result<std::optional<double>> number = numberEntry(field, text);
  return number && !text.empty() ? *number : std::nullopt;
}

void addConditions(const Element& to, const CertificateSource& source) {
  const Measurement& measurement = source.answer.measurement;
  const Element list = to.add("influenceConditions");
  StatedQuantity distance{
      .id = "distance",
      .name = [] { return Phrase::of("Distance L from the theodolite to the plane of the arc"); },
      .value = measurement.distance,
      .unit = "\\milli\\metre",
      .uncertainty = typedUncertainty(measurement.sigmaDistance)};
  const std::string from = certificateText(source.session.geometry.distanceFrom);
  if (!from.empty()) distance.description = [from] { return Phrase::of("Measured: %1", from); };
  addCondition(list, distance);
  const Environment& environment = source.session.environment;
  const auto temperature = typedNumber("environment.temperature_c", environment.temperatureC);
  if (!temperature) return;
  StatedQuantity degrees{.id = "temperature",
                         .refType = "basic_temperature",
                         .name = [] { return Phrase::of("Temperature of the device and of the air"); },
                         .value = *temperature,
                         .unit = "\\degreecelsius"};
  if (const auto sigma = typedNumber("environment.sigma_temperature_c", environment.sigmaTemperatureC))
    degrees.uncertainty = typedUncertainty(*sigma);
  addCondition(list, degrees);
}

}  // namespace

void addMeasuring(const Element& result, const CertificateSource& source, const std::string& version) {
  addMethods(result, source.answer);
  addSoftware(result, "usedSoftware", version);
  addTheodolite(result, source);
  addConditions(result, source);
}

}  // namespace alidade
