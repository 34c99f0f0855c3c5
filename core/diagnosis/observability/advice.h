#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/observability/undetectable.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// A suspect: one of several causes that these readings cannot separate.
struct PossibleCause {
  std::string id;                         ///< identifier; one jump for each position may be listed
  Eigen::VectorXd weights;                ///< estimated, in plausible sizes
  double odds = 1;                        ///< relative to the first suspect
  std::optional<std::size_t> arc = {};    ///< for a jump between a zero and the first visit: index of the arc
  std::optional<JumpMoment> moment = {};  ///< for a jump
};

/// Returns the readings that can separate the suspects. With fewer than two suspects, or more than 16,
/// returns the readings that can reveal undetectable effects.
///
/// Two suspects are separated if the trace of either at its estimated size is at least `clearlyDifferent` σ
/// away from every trace of the other. The measure that most probably leaves one answer comes first; among
/// equal measures, the cheapest. Combinations are offered only if no single measure leaves one answer.
std::vector<Advice> adviceFor(const Inquiry& inquiry, const std::vector<PossibleCause>& suspects,
                              const std::vector<Cause>& causes,
                              const std::vector<Detectability>& undetectable);

}  // namespace alidade
