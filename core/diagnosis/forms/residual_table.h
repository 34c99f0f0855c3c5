#pragma once

#include <Eigen/Core>
#include <string_view>

#include "core/base/result.h"
#include "core/diagnosis/forms/form_readings.h"

namespace alidade {

/// A table of residuals, whitened by their stated σ.
struct ResidualTable {
  FormReadings readings;     ///< carriers: horizontal, vertical, and orientation if both occur
  Eigen::VectorXd residual;  ///< divided by σ
  Eigen::VectorXd sigma;     ///< arcsec
  Eigen::MatrixXd base;      ///< base columns, divided by σ
};

/// Parses the table of residuals that `discover` reads.
Result<ResidualTable> readResiduals(std::string_view bytes);

}  // namespace alidade
