#include "core/diagnosis/advice.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/further_readings.h"
#include "core/diagnosis/look_alikes.h"
#include "core/diagnosis/visible_terms.h"

namespace alidade {

namespace {

using Eigen::VectorXd;

/// What the cause is made of, at the size that was found.
VectorXd combinationOf(const Cause& cause, const Effect& effect) {
  VectorXd weights(static_cast<Eigen::Index>(effect.parameters.size()));
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    weights[static_cast<Eigen::Index>(p)] = cause.parameters[p].value / effect.parameters[p].plausible;
  return combinationOf(effect) * weights;
}

std::optional<Advice> separating(const Cause& cause, const std::string& measure, const VisibleTerms& terms) {
  const Effect* own = effectById(cause.effect);
  if (!own) return std::nullopt;
  const VectorXd combination = combinationOf(cause, *own);
  Advice advice{measure, {cause.effect}, std::sqrt(std::max(combination.dot(terms.gram * combination), 0.0))};
  for (const std::string& id : cause.indistinguishableFrom) {
    const Effect* other = effectById(id);
    const double difference = other ? differenceFrom(terms, combination, *other) : 0;
    if (difference < clearlyDifferent) continue;
    advice.separates.push_back(id);
    advice.bySigma = std::min(advice.bySigma, difference);
  }
  if (advice.separates.size() < 2) return std::nullopt;
  return advice;
}

std::optional<Advice> revealing(const std::vector<Danger>& unseen, const std::string& measure,
                                const VisibleTerms& terms) {
  Advice advice{measure, {}, 0};
  for (const Danger& danger : unseen) {
    const Effect* effect = effectById(danger.effect);
    if (!effect) continue;
    const VectorXd trace = combinationOf(*effect) * danger.weights;
    const double visible = std::sqrt(std::max(trace.dot(terms.gram * trace), 0.0));
    if (visible < clearlyDifferent) continue;
    advice.bySigma = advice.separates.empty() ? visible : std::min(advice.bySigma, visible);
    advice.separates.push_back(danger.effect);
  }
  if (advice.separates.empty()) return std::nullopt;
  return advice;
}

/// The session's own equations serve where it was fitted without effects and with all its readings.
VisibleTerms termsOfSession(const Inquiry& inquiry, const Measurement& plan) {
  const JointFitOptions& options = inquiry.base.options;
  return visibleTerms(options.terms.empty() && options.without.empty() ? inquiry.leftover.sets().front()
                                                                       : linearisedPlan(inquiry.base, plan));
}

}  // namespace

std::vector<Advice> adviceFor(const Inquiry& inquiry, const std::vector<Cause>& causes,
                              const std::vector<Danger>& unseen) {
  const auto unclear =
      std::ranges::find_if(causes, [](const Cause& cause) { return !cause.indistinguishableFrom.empty(); });
  if (unclear == causes.end() && unseen.empty()) return {};
  std::vector<Advice> list;
  std::optional<VisibleTerms> ofSession;
  for (const FurtherReadings& plan : furtherReadings(inquiry.base)) {
    if (plan.besideSession && !ofSession) ofSession = termsOfSession(inquiry, plan.sets.front());
    VisibleTerms terms = visibleTerms(linearisedPlan(inquiry.base, plan.sets.back()));
    if (plan.besideSession) terms = terms + *ofSession;
    terms = withEstimated(std::move(terms), inquiry.base.options.terms);
    const std::optional<Advice> advice = unclear != causes.end() ? separating(*unclear, plan.measure, terms)
                                                                 : revealing(unseen, plan.measure, terms);
    if (advice) list.push_back(*advice);
  }
  std::ranges::sort(list, [](const Advice& a, const Advice& b) {
    return std::pair(a.separates.size(), a.bySigma) > std::pair(b.separates.size(), b.bySigma);
  });
  return list;
}

}  // namespace alidade
