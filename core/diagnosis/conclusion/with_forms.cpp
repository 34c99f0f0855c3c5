#include "core/diagnosis/conclusion/with_forms.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/square.h"
#include "core/diagnosis/conclusion/afterwards.h"
#include "core/diagnosis/conclusion/weighed_explanations.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/forms/form_component.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

using Combination = std::vector<const WeighedForm*>;

/// The combination of the likeliest forms, then variants that replace one of them by a nearly as likely form.
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

/// Prior log odds (natural) of forms against nothing, including the average over their shape numbers.
double logPriorOf(const Combination& forms) {
  double log = 0;
  for (const WeighedForm* form : forms)
    log += std::log(PriorOdds{}.shape) + form->logPrior + form->logAveraged - form->logEvidence;
  return log;
}

/// Returns `certain` and, if it contains jumps, a copy without them: a form may look like a jump.
std::vector<Explanation> restsOf(const Inquiry& inquiry, const Explanation& certain) {
  Explanation calm = certain;
  std::erase_if(calm.parts, [&](const Part& part) { return inquiry.of(part).isJump(); });
  if (calm.parts.size() == certain.parts.size()) return {certain};
  return {certain, calm};
}

/// Log odds (natural), up to a constant, of an explanation together with every effect at its plausible size.
double logOddsWithEffects(WeighedExplanations& weighed, const Explanation& explanation) {
  const auto alone = weighed.of(explanation, noEffect), withEffects = weighed.of(explanation, EffectScales{});
  return alone && withEffects ? explanation.logPosteriorOdds - alone->logOdds + withEffects->logOdds
                              : impossible;
}

/// An explanation with forms, and its log odds together with every effect.
struct Weighed {
  Explanation explanation;
  double logOdds = 0;
};

/// Explanations with each combination, likeliest first. `forms`: part and prior log odds of each combination.
std::vector<Weighed> weighedWith(WeighedExplanations& weighed, const Inquiry& inquiry,
                                 const Explanation& certain,
                                 const std::vector<std::pair<Part, double>>& forms) {
  std::vector<Weighed> all;
  const std::optional<WeighedExplanation> nothing = weighed.of({}, noEffect);
  if (!nothing) return all;
  for (const Explanation& rest : restsOf(inquiry, certain))
    for (const auto& [form, logPrior] : forms) {
      Explanation with = rest;
      with.shaped = true;
      with.noisy = false;
      with.parts.push_back(form);
      const std::optional<WeighedExplanation> alone = weighed.of(with, noEffect);
      if (!alone) continue;
      with.logPosteriorOdds = logPrior + alone->logOdds - nothing->logOdds;
      for (const Part& part : rest.parts)
        with.logPosteriorOdds += inquiry.candidates.groupOf(part.component).logPrior;
      const double logOdds = logOddsWithEffects(weighed, with);
      if (std::isfinite(logOdds)) all.push_back({std::move(with), logOdds});
    }
  std::ranges::stable_sort(all, {}, [](const Weighed& one) { return -one.logOdds; });
  return all;
}

/// Replaces the explanations with a pattern by `all`, which together get the same probability.
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

/// The displacement of the pointing zero of a position by a pattern: the mean over the sightings of the zero.
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
  std::vector<std::pair<Part, double>> parts;
  for (const Combination& forms : combinations) {
    const FormComponent& component = components.emplace_back(inquiry.leftover, readings, forms);
    parts.emplace_back(Part{inquiry.candidates.size() + parts.size(), 1, component.found()},
                       logPriorOf(forms));
  }
  Inquiry with = inquiry;
  with.candidates.add(std::move(components), PriorOdds{}.shape);
  WeighedExplanations weighed(with);
  std::vector<Weighed> all = weighedWith(weighed, with, answer.explanation, parts);
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
  const Eigen::VectorXd taken = weighed.takenByPattern(likeliest, noEffect);
  then.after = without(modelWith(with.base, then.explanation, with.candidates, with.leftover), with, taken);
  then.measured = then.after;
  then.opened = without(openedModelOf(then.after, with.own), with, taken);
  if (!then.after.fit->isDetermined() || !then.opened.fit->isDetermined()) return;
  inquiry = std::move(with);
  answer = std::move(then);
}

bool hasForms(const Inquiry& inquiry, const Answer& answer) {
  return answer.pattern && inquiry.of(*answer.pattern).id() == formId;
}

std::optional<IntersectionEstimate> intersectionWithForms(const Inquiry& inquiry, const Answer& answer) {
  const std::optional<IntersectionEstimate> own = estimateOf(answer.measured);
  WeighedExplanations weighed(inquiry);
  const auto likeliest = weighed.of(inquiry.explanations.front(), noEffect),
             rest = weighed.of(answer.explanation, noEffect);
  if (!own || !likeliest || !rest || !(own->sigma > 0)) return own;
  const double logOdds = logOddsWithEffects(weighed, inquiry.explanations.front());
  std::vector<Possible> all;
  for (const Explanation& explanation : inquiry.explanations)
    if (const auto one = weighed.of(explanation, noEffect); one && explanation.shaped)
      all.push_back({std::exp(logOddsWithEffects(weighed, explanation) - logOdds),
                     one->value - likeliest->value, one->variance - likeliest->variance});
  return averagedOver(widerBy(*own, likeliest->ofWeights - rest->ofWeights), all,
                      inquiry.base.measurement->coverage);
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
