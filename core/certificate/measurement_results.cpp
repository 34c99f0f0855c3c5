#include "core/certificate/measurement_results.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/certificate/quantity.h"
#include "core/statement/result_figures.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/findings.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

constexpr const char* millimetres = "\\milli\\metre";

/// The unit of a figure in the notation of the digital SI.
const char* digitalUnit(std::string_view unit) {
  if (unit == "mm") return millimetres;
  return unit == "arcsec" ? "\\arcsecond" : "\\one";
}

const char* shapeOf(double degreesOfFreedom) {
  return std::isfinite(degreesOfFreedom) ? "Student's t" : "normal";
}

std::string measuredName() {
  return Phrase::of("Intersection Δd, measured");
}

StatedQuantity asMeasured(const IntersectionEstimate& estimate, double coverage) {
  return {
      .id = "intersection_as_measured",
      .refType = "basic_measuredValue",
      .name = [] { return measuredName(); },
      .value = estimate.value,
      .unit = millimetres,
      .uncertainty = StatedUncertainty{estimate.sigma, estimate.expanded, coverage, distributionOf(estimate)},
      .description =
          [] {
            return Phrase::of(
                "Includes every catalogued effect, limited by these readings or by its plausible size.");
          }};
}

/// Adds the quantity “Δd, measured” with the reason why it has no value.
void addNoneMeasured(const Element& data, bool isDiagnosed) {
  const Element quantity = data.add("quantity");
  quantity.attribute("id", "intersection_as_measured");
  quantity.say("name", measuredName);
  quantity.say("noQuantity", [=] {
    return isDiagnosed ? Phrase::of("not determined by these readings") : Phrase::of("no diagnosis was made");
  });
}

StatedQuantity ofTheFit(const Intersection& intersection, bool isHeadline) {
  return {.id = "intersection_of_fit",
          .refType = isHeadline ? "basic_measuredValue" : nullptr,
          .name = [] { return Phrase::of("Intersection Δd, fit only"); },
          .value = intersection.value,
          .unit = millimetres,
          .uncertainty = StatedUncertainty{intersection.sigma, intersection.expanded, intersection.coverage,
                                           shapeOf(intersection.effectiveDegreesOfFreedom)},
          .description =
              [] {
                return Phrase::of(
                    "The uncertainty comes from the scatter of the readings, the pointing zeros and the "
                    "distance.");
              }};
}

void addIntersection(const Element& results, const FitAnswer& answer) {
  const auto& fitted = answer.fit.intersection;
  if (!fitted) return;
  const MeasuredIntersection* measured =
      answer.diagnosis && answer.diagnosis->measured ? &*answer.diagnosis->measured : nullptr;
  const Element result = results.add("result");
  result.attribute("id", "intersection");
  result.say("name", [] { return Phrase::of("Intersection Δd"); });
  const Element data = result.add("data");
  if (measured)
    addQuantity(data, asMeasured(measured->estimate, answer.measurement.coverage));
  else
    addNoneMeasured(data, answer.diagnosis.has_value());
  addQuantity(data, ofTheFit(*fitted, !measured));
  addQuantity(
      data, {.id = "in_plane",
             .name = [] { return Phrase::of("Half the distance of the centres, |O1 − O2|/2"); },
             .value = fitted->inPlane,
             .unit = millimetres,
             .uncertainty = StatedUncertainty{fitted->inPlaneSigma, fitted->inPlaneExpanded, fitted->coverage,
                                              shapeOf(fitted->effectiveDegreesOfFreedom)}});
}

void addAcross(const Element& results, const FitAnswer& answer) {
  if (!answer.diagnosis || !answer.diagnosis->measured) return;
  const MeasuredIntersection& measured = *answer.diagnosis->measured;
  const Element result = results.add("result");
  result.attribute("id", "distance_of_centre");
  result.say("name", [] { return Phrase::of("Distance of the arc's centre from the axis"); });
  const Element data = result.add("data");
  for (const MeasuredFigure& figure : measuredFigures()) {
    const Say name = [&] { return Phrase::of(figure.name); };
    if (const std::optional<MeasuredLength>& length = measured.*figure.length) {
      addQuantity(data, {.id = figure.id,
                         .name = name,
                         .value = length->value,
                         .unit = millimetres,
                         .uncertainty =
                             StatedUncertainty{length->sigma, length->expanded, answer.measurement.coverage,
                                               figure.distribution, figure.isNonNegative}});
      continue;
    }
    const Element quantity = data.add("quantity");
    quantity.attribute("id", figure.id);
    quantity.say("name", name);
    quantity.say("noQuantity", [] { return Phrase::of("not measured"); });
  }
}

/// "arc_180", and "arc_180_2" for a repeated axis.
std::string idOf(const ArcFit& arc) {
  std::string id = "arc_" + std::to_string(arc.axisDeg);
  if (arc.repeat > 1) id += "_" + std::to_string(arc.repeat);
  return id;
}

void addArc(const Element& results, const ArcFit& arc, const ArcSigma& sigma) {
  const std::string id = idOf(arc);
  const Element result = results.add("result");
  result.attribute("id", id);
  result.say("name", [&] {
    return Phrase::of("Arc in the position %1 of the axis", positionName(arc.axisDeg, arc.repeat));
  });
  result.say("description", [] {
    return Phrase::of(
        "Centre in the plane of the arc, relative to the theodolite's centre: x to the right, y up.");
  });
  const Element data = result.add("data");
  const ArcSummary summary = summaryOf(arc, sigma);
  for (const ArcFigure& figure : arcFigures()) {
    const std::string own = id + "_" + figure.id;
    const double value = figure.value(summary);
    StatedQuantity quantity{.id = own.c_str(),
                            .name = [&] { return figure.nameAt(arc.axisDeg); },
                            .value = figure.sigma ? value : roundedTo(value, std::max(figure.decimals, 1)),
                            .unit = digitalUnit(figure.unit)};
    if (figure.sigma) quantity.uncertainty = standardUncertainty(figure.sigma(summary));
    addQuantity(data, quantity);
  }
}

void addSentences(const Element& metaData, const CertificateSource& source) {
  const FitAnswer& answer = source.answer;
  const auto add = [&](const char* id, const Say& name, const Say& text) {
    const Element own = metaData.add("metaData");
    own.attribute("id", id);
    own.say("name", name);
    own.say("declaration", text);
  };
  if (answer.diagnosis)
    add(
        "gap", [] { return Phrase::of("Gap between model and readings"); },
        [&] { return sentenceOf(*answer.diagnosis); });
  const std::size_t count = inWords(answer.fit.findings, answer.suspects).size();
  for (std::size_t i = 0; i < count; ++i)
    add(("finding_" + std::to_string(i + 1)).c_str(), [] { return Phrase::of("Finding"); },
        [&, i] { return sentencesOf(inWords(answer.fit.findings, answer.suspects)[i]); });
}

std::string sessionFileName(const CertificateSource& source) {
  const std::string name = certificateText(source.fileName);
  return name.empty() ? "session.alidade" : name;
}

void addFiles(const Element& result, const CertificateSource& source, const std::string& results) {
  const Element description = result.say("description", [] {
    return Phrase::of("Every reading as it was entered, and the results in full, are attached as files.");
  });
  description.file("file", sessionFileName(source), "application/x-alidade-session", source.bytes);
  description.file("file", "results.json", "application/json", results);
}

}  // namespace

void addMeasurementResults(const Element& certificate, const CertificateSource& source,
                           const std::string& version, const std::string& results) {
  const FitAnswer& answer = source.answer;
  const Element result = certificate.add("measurementResults").add("measurementResult");
  result.attribute("id", "measurement");
  result.say("name", [] { return Phrase::of("Intersection of a rotatable arc guideway"); });
  addFiles(result, source, results);
  addMeasuring(result, source, version);
  const Element list = result.add("results");
  addIntersection(list, answer);
  addAcross(list, answer);
  for (std::size_t i = 0; i < answer.fit.arcs.size(); ++i)
    addArc(list, answer.fit.arcs[i], answer.fit.sigmas[i]);
  const Element metaData = result.add("measurementMetaData");
  addConformity(metaData, source);
  addSentences(metaData, source);
}

}  // namespace alidade
