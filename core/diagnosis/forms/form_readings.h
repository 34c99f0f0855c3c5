#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "core/diagnosis/gap/leftover.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

inline constexpr std::size_t formCarriers = 10, formArguments = 10;

/// The readings that forms are sought in: what one unit of each carrier does to each of them, and what the
/// functions are of.
struct FormReadings {
  Eigen::Index count = 0;
  /// ∂reading/∂carrier, whitened, per mm or arcsecond; empty where these readings do not have it. Of the
  /// orientation: both circles added up. Vertical: of the elevation in face 1, up positive.
  std::array<Eigen::VectorXd, formCarriers> carriers;
  /// Value of each argument: rad, share, or ±1; empty where it is the same for all readings or unknown.
  std::array<Eigen::VectorXd, formArguments> arguments;
  /// Argument of the pointing zero that a reading counts from, in face 1; empty where zeros are readings.
  std::array<Eigen::VectorXd, formArguments> zeros;
  Eigen::VectorXd face;  ///< 1 or −1

  const Eigen::VectorXd& of(FormCarrier carrier) const { return carriers[static_cast<std::size_t>(carrier)]; }
  const Eigen::VectorXd& of(FormArgument argument) const {
    return arguments[static_cast<std::size_t>(argument)];
  }
  bool has(const Form& form) const { return of(form.carrier).size() > 0 && of(form.of).size() > 0; }
};

/// Of a session, by the leftover of a model of it and its fit.
FormReadings formReadings(const Leftover& leftover, const Measurement& measurement, const JointFit& fit);

/// The columns of a form over the readings, whitened, for amplitudes of 1 mm or 1″. Of the orientation first
/// those of the horizontal circle.
Eigen::MatrixXd formColumns(const FormReadings& readings, const Form& form);
/// The same of a free form at these places: those that it was found with in other readings.
Eigen::MatrixXd formColumns(const FormReadings& readings, const Form& form,
                            const std::vector<double>& places);
/// How many columns a form has.
Eigen::Index columnsOf(const FormReadings& readings, const Form& form);
/// Of a form with a number for each place the places, of which those that agree to 0.1° are one; of a walk
/// the moments of its steps. In the unit of the argument.
std::vector<double> placesOf(const FormReadings& readings, const Form& form);
/// The functions of a form that is free at `x`, one for each of `places`. A walk's amplitudes have the size
/// of what it comes to by the end.
Eigen::VectorXd freeFunctions(const Form& form, const std::vector<double>& places, double x);
/// The functions of a form that is not free at `x`: one, or cosine and sine.
Eigen::Array2d formFunctions(const Form& form, double x);

/// 1 in powers: 10° of an angle, the whole session.
double powerUnit(FormArgument of);

}  // namespace alidade
