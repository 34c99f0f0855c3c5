#include "core/diagnosis/observability/further_terms.h"

#include <algorithm>
#include <utility>

namespace alidade {

FurtherTerms::FurtherTerms(const GapModel& model, const Linearised& ofSession,
                           const std::vector<const Effect*>& effects, std::vector<JumpMoment> moments)
    : m_model(model), m_equations(ofSession), m_moments(std::move(moments)) {
  const auto add = [&](ErrorTerm term) {
    if (std::ranges::find(m_terms, term) == m_terms.end()) m_terms.push_back(term);
  };
  for (const Effect* effect : effects)
    for (const EffectParameter& parameter : effect->parameters) add(parameter.term);
  for (const EstimatedTerm& term : model.options.terms) add(term.term);
}

VisibleTerms FurtherTerms::shownBy(const FurtherReadings& plan) {
  if (plan.goesOn) return withEstimated(goingOn(plan.sets.back()), m_model.options.terms);
  VisibleTerms terms = ofSet(plan.sets.back());
  if (plan.includesSession) {
    if (!m_ofSession) m_ofSession = ofSession(plan.sets.front());
    terms = terms + *m_ofSession;
  }
  return withEstimated(std::move(terms), m_model.options.terms);
}

VisibleTerms FurtherTerms::ofSet(const Measurement& set) const {
  VisibleTermsOfSet sum(m_terms);
  linearisePlan(m_model, set, m_terms, [&](const Linearised& piece) { sum.add(piece); });
  return sum.sum();
}

VisibleTerms FurtherTerms::goingOn(const Measurement& set) const {
  std::vector<ErrorTerm> terms = m_terms;
  if (!m_moments.empty()) terms.insert(terms.end(), {ErrorTerm::HorizontalJump, ErrorTerm::VerticalJump});
  VisibleTermsOfSet sum(m_terms, m_moments);
  linearisePlan(m_model, set, terms, [&](const Linearised& piece) { sum.add(piece); });
  return sum.sum();
}

/// Uses the session's own equations if the session was fitted without effects and with all its readings.
VisibleTerms FurtherTerms::ofSession(const Measurement& plan) const {
  if (!m_model.options.terms.empty() || !m_model.options.without.empty()) return ofSet(plan);
  return visibleTerms(m_equations, m_terms);
}

}  // namespace alidade
