#include "core/diagnosis/conclusion/with_forms.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/square.h"
#include "core/diagnosis/conclusion/accounts.h"
#include "core/diagnosis/conclusion/afterwards.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/forms/form_component.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

using Combination = std::vector<const WeighedForm*>;

/// The likeliest forms, and for each of them what is nearly as likely in its place.
std::vector<Combination> combinationsOf(const FoundForms& found) {
  Combination likeliest;
  for (const std::vector<WeighedForm>& likely : found.likely) likeliest.push_back(&likely.front());
  std::vector<Combination> all{likeliest};
  for (std::size_t f = 0; f < found.likely.size(); ++f)
    for (std::size_t i = 1; i < found.likely[f].size(); ++i) {
      all.push_back(likeliest);
      all.back()[f] = &found.likely[f][i];
    }
  return all;
}

/// Natural, odds against nothing: of the forms, each with the range of its shape numbers.
double logPriorOf(const Combination& forms) {
  double log = 0;
  for (const WeighedForm* form : forms)
    log += std::log(PriorOdds{}.shape) + form->logPrior + form->logAveraged - form->logEvidence;
  return log;
}

bool isJump(const Component& component) {
  return component.isJump() || component.slippedArc().has_value();
}

/// What is certain, with and without the jumps that a form may have been taken for.
std::vector<Explanation> restsOf(const Inquiry& inquiry, const Explanation& certain) {
  Explanation calm = certain;
  std::erase_if(calm.parts, [&](const Part& part) { return isJump(inquiry.of(part)); });
  if (calm.parts.size() == certain.parts.size()) return {certain};
  return {certain, calm};
}

/// Readings far off leave no number.
bool isFinite(const Account& account) {
  return std::isfinite(account.logOdds) && std::isfinite(account.value) && std::isfinite(account.variance) &&
         std::isfinite(account.ofWeights);
}

/// An explanation with forms, and how likely it is with effects at their plausible sizes.
struct Weighed {
  Explanation explanation;
  double logOdds = 0;
};

std::vector<Weighed> weighedWith(const Inquiry& inquiry, const Explanation& certain, std::size_t first,
                                 const std::vector<Combination>& combinations) {
  Accounts accounts(inquiry);
  std::vector<Weighed> all;
  const std::optional<Account> nothing = accounts.of({}, noEffect);
  if (!nothing) return all;
  for (const Explanation& rest : restsOf(inquiry, certain))
    for (std::size_t i = 0; i < combinations.size(); ++i) {
      const auto& component = static_cast<const FormComponent&>(inquiry.candidates[first + i]);
      Explanation with = rest;
      with.shaped = true;
      with.noisy = false;
      with.parts.push_back({first + i, 1, component.found()});
      double prior = logPriorOf(combinations[i]);
      for (const Part& part : rest.parts) prior += inquiry.candidates.groupOf(part.component).logPrior;
      const auto alone = accounts.of(with, noEffect), beside = accounts.of(with, EffectScales{});
      if (!alone || !beside || !isFinite(*alone) || !isFinite(*beside)) continue;
      with.logPosteriorOdds = prior + alone->logOdds - nothing->logOdds;
      all.push_back({std::move(with), prior + beside->logOdds});
    }
  std::ranges::stable_sort(all, {}, [](const Weighed& one) { return -one.logOdds; });
  return all;
}

/// In the place of those with a pattern, with their chance.
void replacePatterns(Inquiry& inquiry, std::vector<Weighed> all) {
  const double chance = inquiry.chanceOf(&Explanation::shaped);
  double sum = 0;
  for (const Weighed& one : all) sum += std::exp(one.logOdds - all.front().logOdds);
  std::erase_if(inquiry.explanations, &Explanation::shaped);
  std::vector<Explanation> with;
  for (Weighed& one : all) {
    one.explanation.chance = chance * std::exp(one.logOdds - all.front().logOdds) / sum;
    with.push_back(std::move(one.explanation));
  }
  inquiry.explanations.insert(inquiry.explanations.begin(), with.begin(), with.end());
}

/// What a pattern does to the zero of a position, in the mean of its sightings: its rows count from there.
class ZeroShift {
 public:
  void add(ReadingKind kind, Angle off) {
    Mean& mean = kind == ReadingKind::Horizontal ? m_horizontal : m_vertical;
    mean.sum = mean.sum + off;
    ++mean.count;
  }
  Angle horizontal() const { return m_horizontal.value(); }
  Angle vertical() const { return m_vertical.value(); }

 private:
  struct Mean {
    Angle sum;
    int count = 0;

    Angle value() const { return count > 0 ? sum * (1.0 / count) : Angle(); }
  };
  Mean m_horizontal, m_vertical;
};

GapModel without(GapModel model, const Inquiry& inquiry, const Eigen::VectorXd& taken) {
  model.measurement = std::make_shared<const Measurement>(withoutPattern(*model.measurement, inquiry, taken));
  model.refit();
  return model;
}

}  // namespace

void takeUpForms(Inquiry& inquiry, Answer& answer, const FoundForms& found) {
  if (found.forms.empty()) return;
  const FormReadings readings = formReadings(inquiry.leftover, *inquiry.base.measurement, *inquiry.base.fit);
  const std::vector<Combination> combinations = combinationsOf(found);
  std::vector<FormComponent> components;
  components.reserve(combinations.size());
  for (const Combination& forms : combinations) components.emplace_back(inquiry.leftover, readings, forms);
  Inquiry with = inquiry;
  const std::size_t first = with.candidates.size();
  with.candidates.add(std::move(components), PriorOdds{}.shape);
  std::vector<Weighed> all = weighedWith(with, answer.explanation, first, combinations);
  if (all.empty()) return;
  replacePatterns(with, std::move(all));

  const Explanation& likeliest = with.explanations.front();
  Answer then = answer;
  then.kind = Answer::Kind::Unknown;
  then.pattern = likeliest.parts.back();
  for (std::size_t p = then.explanation.parts.size(); p-- > 0;) {
    if (likeliest.has(then.explanation.parts[p].component)) continue;
    then.explanation.parts.erase(then.explanation.parts.begin() + static_cast<std::ptrdiff_t>(p));
    then.rivals.erase(then.rivals.begin() + static_cast<std::ptrdiff_t>(p));
  }
  const Eigen::VectorXd taken = Accounts(with).takenByPattern(likeliest, noEffect);
  if (!taken.allFinite()) return;
  then.after = without(modelWith(with.base, then.explanation, with.candidates, with.leftover), with, taken);
  const std::optional<IntersectionEstimate> estimate = estimateOf(then.after);
  if (!then.after.fit->isDetermined() || (estimate && !std::isfinite(estimate->value + estimate->expanded)))
    return;
  then.measured = then.after;
  then.opened = without(openedModelOf(then.after, with.own), with, taken);
  inquiry = std::move(with);
  answer = std::move(then);
}

bool hasForms(const Inquiry& inquiry, const Answer& answer) {
  return answer.pattern && inquiry.of(*answer.pattern).id() == formId;
}

std::optional<IntersectionEstimate> intersectionWithForms(const Inquiry& inquiry, const Answer& answer) {
  std::optional<IntersectionEstimate> own = estimateOf(answer.measured);
  Accounts accounts(inquiry);
  const auto likeliest = accounts.of(inquiry.explanations.front(), noEffect),
             rest = accounts.of(answer.explanation, noEffect);
  if (!own || !likeliest || !rest || !(own->sigma > 0) || !isFinite(*likeliest) || !isFinite(*rest))
    return own;
  own = widerBy(*own, likeliest->ofWeights - rest->ofWeights);
  std::vector<Possible> all;
  for (const Explanation& explanation : inquiry.explanations)
    if (const auto account = accounts.of(explanation, noEffect);
        account && explanation.shaped && isFinite(*account))
      all.push_back({explanation.chance / inquiry.explanations.front().chance,
                     account->value - likeliest->value, account->variance - likeliest->variance});
  return averagedOver(*own, all, inquiry.base.measurement->coverage);
}

Measurement withoutPattern(Measurement measurement, const Inquiry& inquiry, const Eigen::VectorXd& taken) {
  std::vector<ZeroShift> zeros(measurement.arcs.size());
  for (Eigen::Index i = 0; i < taken.size(); ++i) {
    const LinearReading& reading = inquiry.leftover.reading(i);
    const Angle off = Angle::fromRadians(taken[i] * reading.sigma);
    std::vector<Sighting>& sightings = measurement.arcs[reading.arc].sightings;
    if (reading.sighting >= sightings.size()) {
      zeros[reading.arc].add(reading.kind, off);
      continue;
    }
    Sighting& sighting = sightings[reading.sighting];
    if (reading.kind == ReadingKind::Horizontal) sighting.a = sighting.a - off;
    if (reading.kind == ReadingKind::Vertical) sighting.e = sighting.e - off;
    if (reading.kind == ReadingKind::Slider) sighting.slider = *sighting.slider - off;
  }
  for (std::size_t arc = 0; arc < zeros.size(); ++arc)
    for (Sighting& sighting : measurement.arcs[arc].sightings) {
      const ZeroShift& zero = zeros[measurement.hasOneZero() ? 0 : arc];
      sighting.a = sighting.a + zero.horizontal();
      sighting.e = sighting.e + zero.vertical();
    }
  return measurement;
}

}  // namespace alidade
