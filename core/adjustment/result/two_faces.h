#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/base/angle.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: the theodolite sighted the slider at rest in both faces. The difference between the two
// readings is due to the instrument:
//
//   2c(e) = α1 − (α2 ± 180°) = 2c/cos e + 2i·tan e
//   j = (β1 + β2 − 360°)/2, elevation circle (… − 180°)/2
//
// with the collimation c and the trunnion axis tilt i of face 1 (δα = +c/cos e + i·tan e, in face 2 the
// opposite) and the index error j. The vertical circle reads j too much in both faces. So 2c(e)·cos e/2 = c +
// i·sin e is a straight line in sin e, fitted by least squares with the weights of the horizontal circle. The
// index is a mean. Zeros, drift and a tilted vertical axis are equal in both faces and cancel. Terms that c
// and i omit are of third order: below 1e-4″ for errors up to 500″. Source: any textbook of surveying on the
// errors of the theodolite.

/// A visit read in both faces.
struct FaceDifference {
  std::size_t arc = 0;      ///< index into the measurement's arcs
  std::size_t faceOne = 0;  ///< indices into the arc's sightings
  std::size_t faceTwo = 0;
  Angle elevation;          ///< e, mean of both faces
  Angle doubleCollimation;  ///< 2c(e) as read
  Angle index;              ///< j as read
  Angle fromCourse;         ///< 2c(e) as read minus that of the fitted c and i
};

/// An error of the instrument with its standard uncertainty.
struct InstrumentError {
  Angle value, sigma;
};

/// The scatter of the differences of one circle: s0 = √(χ²/f) with its stated σ.
struct FaceScatter {
  double chiSquare = 0;
  int degreesOfFreedom = 0;  ///< 0: the scatter cannot be determined

  double ratio() const;  ///< s0; 0 without redundancy
};

struct TwoFaces {
  std::vector<FaceDifference> visits;  ///< in the order of arcs and visits
  InstrumentError collimation;         ///< c
  /// i. Absent if there are fewer than three visits, or if elevations spread too little to separate i from c
  /// (sin e within 0.001 rms); c is then a mean.
  std::optional<InstrumentError> trunnionTilt;
  InstrumentError index;  ///< j
  FaceScatter horizontal, vertical;
};

/// Absent if no visit was read in both faces. Each σ is scaled by the scatter of its own circle, by the rules
/// of `noiseScale`.
std::optional<TwoFaces> compareFaces(const Measurement& measurement);

}  // namespace alidade
