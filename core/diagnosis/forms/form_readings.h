#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "core/diagnosis/gap/leftover.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

inline constexpr std::size_t formCarriers = 10, formArguments = 10;

/// The readings in which forms are sought: the effect of one unit of each carrier on them, and the arguments
/// of the functions.
struct FormReadings {
  Eigen::Index count = 0;
  /// ∂reading/∂carrier, whitened, per mm or arcsecond; empty if the carrier changes no reading. `Orientation`
  /// holds the sum of both circles; `Vertical` is reduced to face 1 and positive upwards.
  std::array<Eigen::VectorXd, formCarriers> carriers;
  /// Value of each argument: rad, share, ±1 or round; empty if it is equal for all readings or unknown.
  std::array<Eigen::VectorXd, formArguments> arguments;
  /// Argument, in face 1, of the pointing zero to which a reading refers; empty if zeros are readings.
  std::array<Eigen::VectorXd, formArguments> zeros;
  Eigen::VectorXd face;  ///< 1 or −1

  const Eigen::VectorXd& of(FormCarrier carrier) const { return carriers[static_cast<std::size_t>(carrier)]; }
  const Eigen::VectorXd& of(FormArgument argument) const {
    return arguments[static_cast<std::size_t>(argument)];
  }
  bool has(const Form& form) const { return of(form.carrier).size() > 0 && of(form.of).size() > 0; }
};

/// `leftover` belongs to a model of the session, `fit` is its fit.
FormReadings formReadings(const Leftover& leftover, const Measurement& measurement, const JointFit& fit);

/// The columns of a form over the readings, whitened, for amplitudes of 1 mm or 1″. For the orientation, the
/// columns of the horizontal circle come first.
Eigen::MatrixXd formColumns(const FormReadings& readings, const Form& form);
/// The columns of a free form with places that were found in other readings.
Eigen::MatrixXd formColumns(const FormReadings& readings, const Form& form,
                            const std::vector<double>& places);
Eigen::Index columnsOf(const FormReadings& readings, const Form& form);
/// The places of a `PerPlace` form, or the moments of the steps of a walk, in the unit of the argument.
/// Places within 0.1° count as one.
std::vector<double> placesOf(const FormReadings& readings, const Form& form);
/// The functions at `x` of a free form, one for each of `places`. The functions of a walk with n steps are
/// divided by √n: the final displacement then has the σ of the independent amplitudes.
Eigen::VectorXd freeFunctions(const Form& form, const std::vector<double>& places, double x);
/// The functions at `x` of a form that is not free: one, or cosine and sine.
Eigen::Array2d formFunctions(const Form& form, double x);

/// The unit of the argument in powers and hinges: 10° for an angle, otherwise the session or one round.
double powerUnit(FormArgument of);

}  // namespace alidade
