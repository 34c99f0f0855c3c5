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

/// One of those that these readings cannot tell apart.
struct PossibleCause {
  std::string id;           ///< of the catalogue; a jump may stand there for each position
  Eigen::VectorXd weights;  ///< found, in plausible sizes
  double odds = 1;          ///< against the first one
  std::optional<std::size_t> arc =
      {};  ///< of a jump between a zero and the first place: the measurement's arc
  std::optional<JumpMoment> moment = {};  ///< of a jump
};

/// What further readings would tell apart, or where there are no two suspects, what would show of the effects
/// that do not show yet. A suspect is told from another where, whichever of the two it is, at the size that
/// was found, the other can leave nothing nearer than `clearlyDifferent` σ once the measure is taken. The
/// measure that most probably leaves one answer comes first, of those alike the one that costs the least;
/// several together are offered where no single one leaves one answer.
std::vector<Advice> adviceFor(const Inquiry& inquiry, const std::vector<PossibleCause>& suspects,
                              const std::vector<Cause>& causes,
                              const std::vector<Detectability>& undetectable);

}  // namespace alidade
