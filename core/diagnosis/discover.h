#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

/// The forms in a table of residuals.
struct Discovery {
  int readings = 0;
  double rms = 0;                ///< rms of the residuals without the span of the base columns, arcsec
  double reducedChiSquare = 0;   ///< χ²/f of the residuals, with the stated σ
  double noise = 1;              ///< ratio of the estimated to the stated scatter, ≥ 1
  std::vector<FoundForm> forms;  ///< the likeliest first
};

/// Reads a table of residuals whose first row names the columns, in any order. Required: `residual_arcsec`,
/// `sigma_arcsec`, `circle` (horizontal or vertical), `azimuth_deg`, `elevation_deg`. Optional: `time` (any
/// unit, ascending), `leg` (there or back, 1 or 2), `face` (1 or 2). Any number of `base:NAME` columns,
/// arcseconds for a size of 1, hold effects that a fit has absorbed. Other columns are ignored. A problem of
/// a line names that line.
Result<Discovery> discover(std::string_view bytes);

}  // namespace alidade
