#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/observability/further_readings.h"
#include "core/diagnosis/observability/visible_terms.h"

namespace alidade {

/// What further readings would show of the terms of some effects and of those of the model, and of jumps.
class FurtherTerms {
 public:
  /// `ofSession`: the equations at the fit of `model`. Both have to live as long. `moments`: of jumps, which
  /// only readings behind those of the session tell of (`FurtherReadings::goesOn`).
  FurtherTerms(const GapModel& model, const Linearised& ofSession, const std::vector<const Effect*>& effects,
               std::vector<JumpMoment> moments = {});

  /// The terms of the model estimated along.
  VisibleTerms shownBy(const FurtherReadings& plan);

 private:
  const GapModel& m_model;
  const Linearised& m_equations;
  std::vector<ErrorTerm> m_terms;
  std::vector<JumpMoment> m_moments;
  std::optional<VisibleTerms> m_ofSession;

  VisibleTerms ofSet(const Measurement& set) const;
  VisibleTerms goingOn(const Measurement& set) const;
  VisibleTerms ofSession(const Measurement& plan) const;
};

}  // namespace alidade
