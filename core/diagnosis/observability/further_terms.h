#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/observability/further_readings.h"
#include "core/diagnosis/observability/visible_terms.h"

namespace alidade {

/// Computes what further readings show of the terms of some effects, of the model's terms, and of jumps.
class FurtherTerms {
 public:
  /// `ofSession` are the equations at the fit of `model`; both must outlive this object. `moments` belong to
  /// jumps, which only readings after those of the session show (`FurtherReadings::goesOn`).
  FurtherTerms(const GapModel& model, const Linearised& ofSession, const std::vector<const Effect*>& effects,
               std::vector<JumpMoment> moments = {});

  /// The terms of the model count as unknowns.
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
