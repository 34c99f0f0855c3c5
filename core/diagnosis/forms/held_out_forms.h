#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/forms/find_forms.h"

namespace alidade {

/// A model whose readings are divided into those that are fitted and those that are predicted.
struct DividedModel {
  FormSystem::Outside outside;  ///< converts columns over the readings to columns over the rows
  Eigen::MatrixXd basis;        ///< orthonormal basis of the part that the model absorbs
  Eigen::VectorXd left;         ///< leftover, σ; rows: readings, then prior knowledge
};

/// Distributes `count` groups of readings at random, by a fixed seed, over folds of nearly equal size.
std::vector<int> shuffledFolds(std::size_t count, int folds);

struct HeldOutReadings {
  static constexpr int none = -1;
  std::vector<int> fold;       ///< fold of each reading; `none` if always fitted, like a pointing zero
  int folds = 0;               ///< 0: too few readings to hold any out
  Eigen::VectorXd arcseconds;  ///< σ of each reading whose prediction counts, else 0
  /// For each fold, the number of unknowns that occur in its readings only, such as arc angles.
  std::vector<int> eliminated = {};
};

/// Rms, arcseconds, of the residuals `left`, which are in σ of each reading. `arcseconds` holds these σ, 0
/// for a reading that does not count.
double rmsOf(const Eigen::VectorXd& left, const Eigen::VectorXd& arcseconds);

/// Adds to each form the shrinkage by all forms together, on all readings and on held-out readings. Also adds
/// the exact test of the hypothesis that the forms predict nothing of held-out readings.
///
/// For each fold, shape and amplitudes are found from the other readings. They predict one column g for the
/// readings y of the fold, whose noise is independent of g. With Q the projector that eliminates the model
/// from y alone, F = (gᵀQy)²/(gᵀQg)/(rest/ν) follows F(1, ν) if there is no form; rest is the remainder of
/// yᵀQy. The result is the least probability of all folds times their number (Bonferroni).
///
/// `plain` contains the certain causes, `full` every effect; the forms were found in `full`. The rms before
/// is that of `plain` without the forms. The rms after is the smaller rms of the two models with the forms.
void addShrinkage(FoundForms& found, const DividedModel& plain, const DividedModel& full,
                  const HeldOutReadings& held, const FormReadings& readings, double variance,
                  const std::stop_token& stop);

}  // namespace alidade
