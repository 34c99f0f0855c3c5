#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace alidade {

/// Significance level of all tests of the check: 5 %, as in the standard.
inline constexpr double levelOfTests = 0.05;

/// Rounding error of angles in arcseconds: a value below it is 0, however well it is determined.
inline constexpr double roundingArcsec = 1e-6;

/// Plausible sizes of trunnion tilt (arcsec) and offset of the line of sight (mm).
inline constexpr double plausibleTilt = 30, plausibleOffset = 0.5;

/// A mean of N values, or a result of a fit to them: u = scatter √cofactor, where the cofactor of a mean is
/// 1/N. Members are NaN if the values are too few to determine them.
struct PairMean {
  double value, u, scatter;
  double degreesOfFreedom;
  double cofactor = std::numeric_limits<double>::quiet_NaN();
};

/// c and one other cause of the difference of the faces, from the fit of all stated causes.
struct TwoCauses {
  double collimation, uCollimation;
  double other, uOther;
  double correlation;       ///< of `collimation` and `other`
  double degreesOfFreedom;  ///< pairs − unknowns
  double pValue;            ///< two-sided probability that chance exceeds |`other`|
  /// Cofactors of c, of c and the other cause, and of the other cause: covariance = scatter² · cofactor.
  double cofactorCollimation = 1, cofactorBoth = 0, cofactorOther = 1;
};

/// Two-sided probability (Student) that chance yields a value at least this far from zero. NaN: unknown.
double twoSidedStudent(double value, double u, double degreesOfFreedom);

/// Half the difference of the faces at one target: h = c/cos e + i tan e + e_s/(D cos e), with collimation c,
/// trunnion tilt i and offset e_s of the line of sight from the vertical axis.
struct HalfDifference {
  double arcsec;     ///< h
  double elevation;  ///< e, rad
  double distanceM;  ///< D, along the line of sight
};

/// The stated causes of the difference of the faces, from least squares of h.
struct FaceCauses {
  std::optional<PairMean> collimation;         ///< of the fit of the stated causes; absent if none is stated
  std::optional<TwoCauses> tilt, lineOfSight;  ///< absent: not stated
  /// The plausible size of the cause divided by its standard uncertainty. NaN if the cause was not sought,
  /// cannot be fitted or is stated together with the other cause.
  double tiltShows = std::numeric_limits<double>::quiet_NaN();
  double offsetShows = std::numeric_limits<double>::quiet_NaN();
  /// Tilt and offset are inseparable here: the cause smaller relative to its plausible size is stated.
  bool isEither = false;
};

/// A cause is stated if its size is significant at 95 %. It is also stated if its plausible size exceeds
/// three standard uncertainties and would be significant at 95 %. `ofTilt`, `ofDistance`: elevations and
/// distances differ enough to look for the cause.
FaceCauses separateFaceCauses(const std::vector<HalfDifference>& differences, bool ofTilt, bool ofDistance);

}  // namespace alidade
