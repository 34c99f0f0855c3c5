#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace alidade {

/// What chance alone seldom exceeds, in all tests of the check: 95 %, as the standard has it.
inline constexpr double levelOfTests = 0.05;

/// What rounding alone leaves of angles in arcseconds: below it a value is 0, however well it is determined.
inline constexpr double roundingArcsec = 1e-6;

/// Trunnion tilt (arcsec) and offset of the line of sight (mm) of a plausible size.
inline constexpr double plausibleTilt = 30, plausibleOffset = 0.5;

/// A mean of N values, or what a fit makes of them: u = scatter √cofactor; 1/N of a mean. NaN where there are
/// too few.
struct PairMean {
  double value, u, scatter;
  double dof;
  double cofactor = std::numeric_limits<double>::quiet_NaN();
};

/// c and another cause of the difference of the faces, by the fit of all causes that are stated.
struct TwoCauses {
  double collimation, uCollimation;
  double other, uOther;
  double correlation;  ///< of both
  double dof;          ///< pairs − unknowns
  double pValue;       ///< two-sided, of an `other` as large by chance
  /// Cofactors of c, of both and of the other: covariance = scatter² · cofactor.
  double cofactorCollimation = 1, cofactorBoth = 0, cofactorOther = 1;
};

/// Chance of a value as far from zero, in either direction, by its u alone (Student). NaN: not known.
double twoSidedStudent(double value, double u, double dof);

/// Half the difference of the faces at one target: h = c/cos e + i tan e + e_s/(D cos e), e_s being the
/// offset of the line of sight from the vertical axis.
struct HalfDifference {
  double arcsec;     ///< h
  double elevation;  ///< e, rad
  double distanceM;  ///< D, along the line of sight
};

/// The model of the collimation: least squares of h with each cause that is stated.
struct FaceCauses {
  std::optional<PairMean> collimation;         ///< absent: no cause is stated besides
  std::optional<TwoCauses> tilt, lineOfSight;  ///< absent: not stated
  /// Standard uncertainties as which a plausible size would show, of a cause that is not stated; NaN where it
  /// cannot be fitted.
  double tiltShows = std::numeric_limits<double>::quiet_NaN();
  double offsetShows = std::numeric_limits<double>::quiet_NaN();
  /// Tilt and offset cannot be told apart by these targets; stated is the one of the more usual size.
  bool isEither = false;
};

/// A cause is stated where a plausible size of it would show (by three standard uncertainties, or by what is
/// significant at 95 % where that is more), or where it is itself significant at 95 %. `ofTilt`,
/// `ofDistance`: elevations and distances differ enough to look for it.
FaceCauses separateFaceCauses(const std::vector<HalfDifference>& differences, bool ofTilt, bool ofDistance);

}  // namespace alidade
