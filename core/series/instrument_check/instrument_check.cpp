#include "core/series/instrument_check/instrument_check.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/square.h"
#include "core/base/statistics.h"
#include "core/series/instrument_check/plausibility.h"
#include "core/series/instrument_check/pooled_faces.h"
#include "core/series/instrument_check/rounds.h"

namespace alidade {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The value that χ² of `degreesOfFreedom` > 0 degrees of freedom exceeds with probability `tail`.
double chiSquareLimit(double tail, double degreesOfFreedom) {
  return boost::math::quantile(
      complement(boost::math::chi_squared_distribution<double>(degreesOfFreedom), tail));
}

std::optional<SigmaTest> testedAgainst(std::optional<double> sigma, const CheckScatter& scatter) {
  if (!sigma || !(*sigma > 0)) return std::nullopt;
  const auto p = chiSquareUpperTail(scatter.sumOfSquares / square(*sigma), scatter.degreesOfFreedom);
  if (!p) return std::nullopt;
  return SigmaTest{
      *sigma,
      *sigma * std::sqrt(chiSquareLimit(levelOfTests, scatter.degreesOfFreedom) / scatter.degreesOfFreedom),
      *p};
}

double differ(const CheckScatter& one, const CheckScatter& two) {
  if (!(one.degreesOfFreedom > 0) || !(two.degreesOfFreedom > 0) || !(two.sumOfSquares > 0)) return nothing;
  const auto above =
      fUpperTail(one.sumOfSquares / square(two.s()), one.degreesOfFreedom, two.degreesOfFreedom);
  return above ? 2 * std::min(*above, 1 - *above) : nothing;
}

void takeFaces(InstrumentCheck& check) {
  const PooledSight sight = pooledSight(check.stations);
  const Pooled index = pooledIndex(check.stations);
  check.collimation = sight.collimation.mean;
  check.collimationsDifferP = sight.collimation.differP;
  check.lineOfSight = sight.lineOfSight;
  check.tilt = pooledTilt(check.stations);
  check.index = index.mean;
  check.indicesDifferP = index.differP;
}

CheckScatter without(const CheckScatter& all, const CheckScatter& part) {
  return part.degreesOfFreedom > 0 ? CheckScatter{all.sumOfSquares - part.sumOfSquares,
                                                  all.degreesOfFreedom - part.degreesOfFreedom}
                                   : all;
}

}  // namespace

InstrumentCheck checkInstrument(const std::vector<StationRounds>& stations, const CheckOptions& options) {
  InstrumentCheck check;
  for (const StationRounds& station : stations) {
    check.stations.push_back(checkStation(station));
    check.direction.add(check.stations.back().direction);
    check.vertical.add(check.stations.back().vertical);
  }
  takeFaces(check);
  check.directionTest = testedAgainst(options.sigmaDirection, check.direction);
  check.verticalTest = testedAgainst(options.sigmaVertical, check.vertical);
  const auto& checks = check.stations;
  if (checks.size() == 2)
    check.samples.push_back({checks[0].station, checks[1].station,
                             differ(checks[0].direction, checks[1].direction),
                             differ(checks[0].vertical, checks[1].vertical)});
  for (std::size_t i = 0; checks.size() > 2 && i < checks.size(); ++i)
    check.samples.push_back({checks[i].station,
                             {},
                             differ(checks[i].direction, without(check.direction, checks[i].direction)),
                             differ(checks[i].vertical, without(check.vertical, checks[i].vertical))});
  return check;
}

Result<InstrumentCheck> checkReadings(const CheckReadings& readings, const CheckOptions& options) {
  const std::vector<StationRounds> stations = completeRounds(readings);
  InstrumentCheck check = checkInstrument(stations, options);
  if (auto problem = implausibility(stations, check)) return *std::move(problem);
  return check;
}

}  // namespace alidade
