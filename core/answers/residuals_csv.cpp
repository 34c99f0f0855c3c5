#include "core/answers/csv_answers.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "core/adjustment/joint/reliability.h"
#include "core/exchange/csv_text.h"
#include "core/observation/half_turn.h"
#include "core/observation/reading_ref.h"

namespace alidade {

namespace {

/// A reading of the fit with its row.
struct ReadIn {
  const AdjustedReading* reading;
  const Sighting* sighting;
};

std::vector<ReadIn> inTheOrderTaken(const Measurement& measurement, const SessionFit& fit) {
  std::vector<const std::vector<Sighting>*> sightings;  // for each fitted arc
  for (const ArcFit& arc : fit.arcs)
    sightings.push_back(
        &std::ranges::find(measurement.arcs, arc.position, &ArcMeasurement::position)->sightings);
  std::vector<ReadIn> read;
  read.reserve(fit.joint.readings.size());
  for (const AdjustedReading& reading : fit.joint.readings)
    read.push_back({&reading, &(*sightings[reading.arc])[reading.sighting]});
  std::ranges::sort(read, {},
                    [](const ReadIn& in) { return std::tuple(in.sighting->sequence, in.reading->kind); });
  return read;
}

/// s of the adjusted target, degrees in [−90, 270).
double sliderDegrees(const ArcFit& arc, std::size_t sighting) {
  return unwrappedSliderCoordinate(arc.residuals[sighting].arcAngle, arc.axisDeg).degrees();
}

}  // namespace

std::string residualsCsv(const Measurement& measurement, const SessionFit& fit) {
  CsvText csv{"axis_deg",
              "turn",
              "point",
              "round",
              "face",
              "order",
              "reading",
              "s_deg",
              "azimuth_deg",
              "elevation_deg",
              "residual_arcsec",
              "sigma_arcsec",
              "redundancy",
              "standardised_residual",
              "minimal_detectable_bias_arcsec",
              "influence_mm"};
  const Detection detection = detectionIn(fit.joint, fit.noise.factor);
  for (const auto& [reading, sighting] : inTheOrderTaken(measurement, fit)) {
    const ArcFit& arc = fit.arcs[reading->arc];
    const Reliability reliability = reliabilityOf(*reading, detection);
    csv.count(arc.axisDeg).count(arc.repeat).count(sighting->point).count(sighting->round);
    csv.count(sighting->face).count(static_cast<long long>(sighting->sequence) + 1);
    csv.word(nameOf(reading->kind)).number(sliderDegrees(arc, reading->sighting));
    csv.number(sighting->a.degrees()).number(sighting->e.degrees());
    csv.number(Angle::fromRadians(reading->residual).arcseconds());
    csv.number(Angle::fromRadians(reading->sigma).arcseconds()).number(reading->redundancy);
    csv.number(reading->standardised(detection.scale));
    csv.number(reliability.minimalDetectableBias.arcseconds());
    csv.number(fit.intersection ? reliability.influence : std::numeric_limits<double>::quiet_NaN()).endRow();
  }
  return csv.text();
}

}  // namespace alidade
