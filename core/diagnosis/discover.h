#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

/// The forms in a table of residuals.
struct Discovery {
  int readings = 0;
  double rms = 0;                ///< of the residuals outside the base columns, arcsec
  double reducedChiSquare = 0;   ///< of these, by the stated σ
  double noise = 1;              ///< scatter beside the forms, over the stated one; 1 or more
  std::vector<FoundForm> forms;  ///< the plainest first
};

/// Reads a table whose first row names the columns, in any order: `residual_arcsec`, `sigma_arcsec`, `circle`
/// (horizontal or vertical), `azimuth_deg`, `elevation_deg`, optional `time` (any unit, rising), `leg` (there
/// or back, 1 or 2) and `face` (1 or 2), and any number of `base:NAME`, arcseconds for a size of 1, which a
/// fit has taken up. Other columns are ignored. Fails with the line of what cannot be read.
Result<Discovery> discover(std::string_view bytes);

}  // namespace alidade
