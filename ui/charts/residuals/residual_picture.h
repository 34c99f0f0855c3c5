#pragma once

#include <vector>

#include "ui/charts/plotting/sighting_ref.h"
#include "ui/jobs/evaluation.h"

namespace alidade::ui {

enum class CircleRead { Horizontal, Vertical };

/// The residual of one reading of one circle.
struct DrawnResidual {
  SightingRef ref;
  int axisDeg = 0;
  int time = 1;  ///< the how many-th position at this axis
  CircleRead circle = CircleRead::Horizontal;
  int point = 0, round = 1, face = 1;
  double slider = 0;  ///< s in degrees: the arc angle φ at 0°, −φ at 180°, so that both run over 0…180°
  double arcsec = 0;        ///< observed minus adjusted; right and up positive
  double standardised = 0;  ///< w = v/(s0 σ √r); NaN where no other reading checks this one
};

/// What the residual chart shows, in numbers.
struct ResidualPicture {
  std::vector<DrawnResidual> residuals;  ///< horizontal and vertical of each row in turn
  double sigmaHorizontal = 0;            ///< stated, arcseconds; 0 while nothing is known
  double sigmaVertical = 0;

  bool isEmpty() const { return residuals.empty(); }
  bool oneSigma() const;  ///< both circles have the same
  double largestSigma() const { return sigmaHorizontal > sigmaVertical ? sigmaHorizontal : sigmaVertical; }
  double largestResidual() const;  ///< of the absolute values, arcseconds
};

ResidualPicture residualPicture(const Evaluation& evaluation);

}  // namespace alidade::ui
