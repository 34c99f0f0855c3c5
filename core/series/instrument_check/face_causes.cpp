#include "core/series/instrument_check/face_causes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

/// Least squares of half differences of the faces. The unknowns are c and the causes sought.
class FaceFit {
 public:
  FaceFit(const std::vector<HalfDifference>& differences, bool ofTilt, bool ofDistance)
      : m_ofTilt(ofTilt), m_ofDistance(ofDistance) {
    const Eigen::Index unknowns = 1 + (ofTilt ? 1 : 0) + (ofDistance ? 1 : 0);
    m_normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
    m_right = Eigen::VectorXd::Zero(unknowns);
    for (const HalfDifference& difference : differences) add(difference);
  }

  /// Returns false if the unknowns cannot be separated, or if there is no degree of freedom.
  bool solve() {
    m_degreesOfFreedom = static_cast<double>(m_count - m_right.size());
    if (!(m_degreesOfFreedom > 0)) return false;
    const Eigen::VectorXd lengths = m_normal.diagonal().cwiseSqrt();
    const Eigen::MatrixXd cosines = m_normal.cwiseQuotient(lengths * lengths.transpose());
    constexpr double leastIndependent = 1e-10;  // for equal columns, rounding leaves 1e-16
    if (!(cosines.determinant() > leastIndependent)) return false;
    m_inverse = m_normal.inverse();
    m_solution = m_inverse * m_right;
    m_variance = std::max(m_squares - m_solution.dot(m_right), 0.0) / m_degreesOfFreedom;
    return true;
  }

  PairMean collimation() const {
    return {m_solution(0), u(0), std::sqrt(m_variance), m_degreesOfFreedom, m_inverse(0, 0)};
  }
  TwoCauses tilt() const { return with(1); }
  TwoCauses lineOfSight() const { return with(m_right.size() - 1); }

 private:
  void add(const HalfDifference& difference) {
    const double cosine = std::cos(difference.elevation);
    Eigen::VectorXd factors(m_right.size());
    factors(0) = 1 / cosine;
    if (m_ofTilt) factors(1) = std::tan(difference.elevation);
    if (m_ofDistance)
      factors(factors.size() - 1) = Angle::fromRadians(1e-3 / difference.distanceM).arcseconds() / cosine;
    m_normal += factors * factors.transpose();
    m_right += factors * difference.arcsec;
    m_squares += difference.arcsec * difference.arcsec;
    ++m_count;
  }
  double u(Eigen::Index k) const { return std::sqrt(m_variance * m_inverse(k, k)); }

  TwoCauses with(Eigen::Index other) const {
    const double correlation = m_inverse(0, other) / std::sqrt(m_inverse(0, 0) * m_inverse(other, other));
    return {m_solution(0),
            u(0),
            m_solution(other),
            u(other),
            correlation,
            m_degreesOfFreedom,
            twoSidedStudent(m_solution(other), u(other), m_degreesOfFreedom),
            m_inverse(0, 0),
            m_inverse(0, other),
            m_inverse(other, other)};
  }

  bool m_ofTilt, m_ofDistance;
  Eigen::MatrixXd m_normal, m_inverse;
  Eigen::VectorXd m_right, m_solution;
  double m_squares = 0, m_variance = 0, m_degreesOfFreedom = 0;
  Eigen::Index m_count = 0;
};

double shows(const TwoCauses& cause, double plausible) {
  return cause.uOther > 0 ? plausible / cause.uOther : std::numeric_limits<double>::infinity();
}

bool isStated(const TwoCauses& cause, double plausible) {
  const double least = std::max(3.0, coverageFactor(1 - levelOfTests, cause.degreesOfFreedom));
  return cause.pValue < levelOfTests || shows(cause, plausible) >= least;
}

/// Chooses the causes to state.
class FaceSeparation {
 public:
  explicit FaceSeparation(const std::vector<HalfDifference>& differences) : m_differences(differences) {}

  FaceCauses separate(bool ofTilt, bool ofDistance) {
    if (ofTilt && ofDistance)
      separateBoth();
    else if (ofTilt)
      tryTilt();
    else if (ofDistance)
      tryDistance();
    return m_causes;
  }

 private:
  void separateBoth() {
    FaceFit both(m_differences, true, true);
    if (!both.solve()) return chooseEither();
    const TwoCauses tilt = both.tilt(), sight = both.lineOfSight();
    const bool hasTilt = isStated(tilt, plausibleTilt), hasOffset = isStated(sight, plausibleOffset);
    if (!hasTilt) m_causes.tiltShows = shows(tilt, plausibleTilt);
    if (!hasOffset) m_causes.offsetShows = shows(sight, plausibleOffset);
    if (hasTilt && hasOffset) {
      m_causes.tilt = tilt;
      m_causes.lineOfSight = sight;
      m_causes.collimation = both.collimation();
    } else if (hasTilt) {
      tryTilt();
    } else if (hasOffset) {
      tryDistance();
    } else {
      chooseEither();
    }
  }

  void tryTilt() {
    FaceFit fit(m_differences, true, false);
    if (!fit.solve()) return;
    m_causes.tiltShows = shows(fit.tilt(), plausibleTilt);
    if (!isStated(fit.tilt(), plausibleTilt)) return;
    m_causes.tilt = fit.tilt();
    m_causes.collimation = fit.collimation();
  }

  void tryDistance() {
    FaceFit fit(m_differences, false, true);
    if (!fit.solve()) return;
    m_causes.offsetShows = shows(fit.lineOfSight(), plausibleOffset);
    if (!isStated(fit.lineOfSight(), plausibleOffset)) return;
    m_causes.lineOfSight = fit.lineOfSight();
    m_causes.collimation = fit.collimation();
  }

  /// Fits each cause alone. If both would be stated, keeps the one smaller relative to its plausible size.
  void chooseEither() {
    FaceFit tilt(m_differences, true, false), sight(m_differences, false, true);
    const bool hasTilt = tilt.solve() && isStated(tilt.tilt(), plausibleTilt),
               hasOffset = sight.solve() && isStated(sight.lineOfSight(), plausibleOffset);
    m_causes.isEither = hasTilt && hasOffset;
    if (!hasTilt && !hasOffset) return;
    const bool isTilt = hasTilt && (!hasOffset || std::abs(tilt.tilt().other) / plausibleTilt <
                                                      std::abs(sight.lineOfSight().other) / plausibleOffset);
    if (isTilt)
      tryTilt();
    else
      tryDistance();
  }

  const std::vector<HalfDifference>& m_differences;
  FaceCauses m_causes;
};

}  // namespace

double twoSidedStudent(double value, double u, double degreesOfFreedom) {
  if (std::abs(value) < roundingArcsec) return 1;
  const auto lower = studentLowerTail(-std::abs(value / u), degreesOfFreedom);
  return lower ? 2 * *lower : std::numeric_limits<double>::quiet_NaN();
}

FaceCauses separateFaceCauses(const std::vector<HalfDifference>& differences, bool ofTilt, bool ofDistance) {
  return FaceSeparation(differences).separate(ofTilt, ofDistance);
}

}  // namespace alidade
