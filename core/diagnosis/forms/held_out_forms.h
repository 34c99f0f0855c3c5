#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/forms/form_search.h"

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

/// With the forms in either model.
struct InSampleShrinkage {
  double plain = 0, full = 0;
};

/// The shrinkage of the readings held out, and the exact test that the forms predict nothing there.
///
/// For each fold shape and amplitudes are found from the other readings. What they predict is one column g on
/// the readings of the fold, whatever was searched: independent of their noise. With Q what the model takes
/// up of these readings alone, F = (gᵀQy)²/(gᵀQg) / (rest/ν) follows F(1, ν) if there is no form. Of several
/// folds the least probability counts, times their number (Bonferroni).
///
/// `plain`: with what is certain; `full`: with every effect, beside which the forms are found. Before:
/// `plain` without the forms. After: whichever of the two with the forms predicts better.
FormShrinkage heldOutForms(const DividedModel& plain, const DividedModel& full, const HeldOutReadings& held,
                           const FormReadings& readings, const std::vector<FormFamily>& families,
                           double variance, const InSampleShrinkage& inSample, const std::stop_token& stop);

}  // namespace alidade
