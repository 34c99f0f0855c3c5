#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/forms/find_forms.h"

namespace alidade {

/// A model whose readings are divided into those that are fitted and those that are predicted.
struct DividedModel {
  FormSystem::Outside outside;  ///< columns over the readings as rows
  Eigen::MatrixXd basis;        ///< orthonormal, of what the model takes up
  Eigen::VectorXd left;         ///< rows: readings, then what is known beforehand
};

/// A fold for each of `count` groups of readings, at random by a fixed seed, all of nearly one size.
std::vector<int> shuffledFolds(std::size_t count, int folds);

struct HeldOutReadings {
  static constexpr int none = -1;
  std::vector<int> fold;       ///< of each reading; none: always fitted, such as a pointing zero
  int folds = 0;               ///< 0: too few readings to hold any out
  Eigen::VectorXd arcseconds;  ///< σ of each reading whose prediction counts, else 0
  /// Numbers that every group of held-out readings has for itself alone, as arc angles: of each fold.
  std::vector<int> eliminated = {};
};

/// Of what is left of the readings that count, each in its σ; arcseconds. `arcseconds`: σ of each reading, 0
/// where it does not count.
double rmsOf(const Eigen::VectorXd& left, const Eigen::VectorXd& arcseconds);

/// The shrinkage by all forms together, the same for each: in all readings, and in those held out, with the
/// exact test that the forms predict nothing there.
///
/// For each fold shape and amplitudes are found from the other readings. What they predict is one column g on
/// the readings of the fold, whatever was searched: independent of their noise. With Q what the model takes
/// up of these readings alone, F = (gᵀQy)²/(gᵀQg) / (rest/ν) follows F(1, ν) if there is no form. Of several
/// folds the least probability counts, times their number (Bonferroni).
///
/// `plain`: with what is certain; `full`: with every effect, beside which the forms are found. Before:
/// `plain` without the forms. After: whichever of the two with the forms predicts better.
void addShrinkage(FoundForms& found, const DividedModel& plain, const DividedModel& full,
                  const HeldOutReadings& held, const FormReadings& readings, double variance,
                  const std::stop_token& stop);

}  // namespace alidade
