#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/evaluation/evaluation.h"
#include "ui/charts/plotting/sighting_ref.h"
#include "ui/charts/residuals/residual_choice.h"

namespace alidade::ui {

/// The residual of one reading of one circle.
struct DrawnResidual {
  SightingRef ref;
  int axisDeg = 0;
  int repeat = 1;  ///< number of the repeat at this axis
  CircleRead circle = CircleRead::Horizontal;
  int point = 0, round = 1, face = 1;
  std::size_t order = 1;              ///< number of the row in the session, in the order of reading, from 1
  double elevation = 0, azimuth = 0;  ///< e and a of the sighting, degrees, up and right positive
  double slider = 0;  ///< s in degrees: the arc angle φ at 0°, −φ at 180°, so that both run over 0…180°
  double arcsec = 0;        ///< observed minus adjusted; right and up positive
  double standardised = 0;  ///< w = v/(s0 σ √r); NaN if no other reading checks this reading
};

/// The contents of the residual chart, as numbers.
struct ResidualPicture {
  /// The horizontal and the vertical residual of each row in turn, then all slider residuals.
  std::vector<DrawnResidual> residuals;
  std::vector<std::uint32_t> byStandardised;  ///< indices of residuals with a w, smallest first
  RowKinds kinds;                             ///< rounds and faces of all residuals
  double sigmaHorizontal = 0;                 ///< stated, arcseconds; 0 while unknown
  double sigmaVertical = 0;
  double sigmaSlider = 0;

  bool isEmpty() const { return residuals.empty(); }
  double sigmaOf(CircleRead circle) const;
};

ResidualPicture residualPicture(const Evaluation& evaluation);

/// The picture computed along with the evaluation, or else a new one.
std::shared_ptr<const ResidualPicture> residualPictureOf(const Evaluation& evaluation);

}  // namespace alidade::ui
