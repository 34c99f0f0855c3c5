#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <stop_token>
#include <vector>

#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/forms/form_families.h"

namespace alidade {

// The search for the likeliest form. With F the columns of a form after elimination of the model, r the
// leftover, v the variance of the readings and w the width of the amplitudes, the amplitudes are
//
//   (FᵀF + v/w²)⁻¹ Fᵀ r,      the evidence |1 + w² FᵀF/v|^(−1/2) exp(½ rᵀF (FᵀF + v/w²)⁻¹ Fᵀr/v),
//
// averaged over the widths. The average over the shape numbers is by Laplace's method at their likeliest
// values. Source: MacKay, "Bayesian interpolation", Neural Computation 4 (1992).

/// The part of the readings that a model absorbs, and the leftover.
class FormSystem {
 public:
  using Outside = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;
  /// `outside` converts columns over the readings to columns over the rows of the system. `basis` is an
  /// orthonormal basis of the absorbed part, `left` the leftover.
  FormSystem(Outside outside, Eigen::MatrixXd basis, Eigen::VectorXd left, double variance);

  const Eigen::MatrixXd& basis() const { return m_basis; }
  const Eigen::VectorXd& left() const { return m_left; }
  double variance() const { return m_variance; }
  Eigen::MatrixXd visible(const Eigen::MatrixXd& columns) const;
  /// Absorbs further columns over the readings, with any amplitudes.
  void takeUp(const Eigen::MatrixXd& columns);

  struct Products {
    Eigen::MatrixXd all;    ///< columns over the rows of the system
    Eigen::MatrixXd taken;  ///< products of `all` with the basis
    Eigen::VectorXd right;  ///< products of `all` with the leftover

    Eigen::MatrixXd gram(Eigen::Index first, Eigen::Index count) const;
  };
  Products productsOf(const Eigen::MatrixXd& columns) const;

 private:
  Outside m_outside;
  Eigen::MatrixXd m_basis;
  Eigen::VectorXd m_left;
  double m_variance;
};

/// A family at its likeliest shape.
struct WeighedForm {
  Form form;
  double logPrior = 0;
  double logEvidence = impossible;  ///< natural logarithm at `form`, integrated over the amplitudes
  double logAveraged = impossible;  ///< `logEvidence` averaged over the shape numbers
  double width = 1;                 ///< prior width of the amplitudes, in `formUnit`
  Eigen::Array2d sigmas{};          ///< standard uncertainty of `shapeCoordinates`
  Eigen::VectorXd amplitudes = {};  ///< mm or arcseconds
  Eigen::MatrixXd covariance = {};  ///< covariance of the amplitudes, with the uncertainty of the shape
  std::vector<double> places = {};  ///< places of the amplitudes of a free form, in the argument's unit

  double logPosterior() const { return logPrior + logAveraged; }
};

/// ln of the sum of the posterior odds against no form.
double logSumOf(const std::vector<WeighedForm>& all);

/// All families, the likeliest first. Only promising families have refined shape numbers and amplitudes.
std::vector<WeighedForm> weighForms(const FormSystem& system, const FormReadings& readings,
                                    const std::vector<FormFamily>& families, const std::stop_token& stop);

}  // namespace alidade
