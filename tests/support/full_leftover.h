#pragma once

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/gap/leftover.h"
#include "tests/support/trials.h"

namespace alidade::test {

/// The leftover of a session with two faces, two rounds and slider readings.
inline const Leftover& leftover() {
  static const Leftover instance = [] {
    const Measurement measurement = trialMeasurement("full");
    return Leftover(linearise(measurement, fitSession(measurement).joint));
  }();
  return instance;
}

inline double greatest(const Eigen::MatrixXd& matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

}  // namespace alidade::test
