#include "core/statement/next_measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/square.h"
#include "core/diagnosis/session_evidence.h"
#include "core/session/protocol_progress.h"
#include "core/statement/gap.h"
#include "core/wording/effect_name.h"
#include "core/wording/measure.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

using Attainable = std::vector<AttainableUncertainty>;

struct Entry {
  std::vector<Measure> measures = {};
  std::string shows = {};
  double ofCauses = 0, ofUncertainty = 0;  ///< worth, defined as for `NextSighting`
  std::optional<double> expanded = {};     ///< U afterwards, mm; absent if hardly smaller than now

  double worth() const { return ofCauses + ofUncertainty; }
  double effort() const { return effortOf(measures); }
  double perEffort() const { return worth() / effort(); }
  bool isBeatenBy(const Entry& other) const {
    const bool isNoWorse =
        other.effort() <= effort() && other.ofCauses >= ofCauses && other.ofUncertainty >= ofUncertainty;
    return isNoWorse && (other.effort() < effort() || other.worth() > worth() || &other < this);
  }
};

Entry& entryOf(std::vector<Entry>& entries, const std::vector<Measure>& measures) {
  const auto own = std::ranges::find(entries, measures, &Entry::measures);
  return own == entries.end() ? entries.emplace_back(Entry{.measures = measures}) : *own;
}

void add(Entry& entry, std::string shows, double ofCauses, double ofUncertainty) {
  entry.shows = entry.shows.empty() ? std::move(shows) : Phrase::of("%1; %2", entry.shows, shows);
  entry.ofCauses += ofCauses;
  entry.ofUncertainty = std::max(entry.ofUncertainty, ofUncertainty);
}

/// "would show a and b at 3.0 σ or more", "separates any two of a, b and c by 4.1 σ or more; probability …".
std::string whatItShows(const Advice& advice) {
  const std::string names = causeNames(advice.separates, Phrase::of(" and ")),
                    sigmas = displayText(advice.bySigma, 1);
  if (advice.ofUndetectable) return Phrase::of("would show %1 at %2 σ or more", names, sigmas);
  const std::string text = advice.separates.size() == 2
                               ? Phrase::of("separates %1 by %2 σ or more", names, sigmas)
                               : Phrase::of("separates any two of %1 by %2 σ or more", names, sigmas);
  if (!(advice.oneLeft > 0)) return text;
  return Phrase::of("%1; probability that only one cause remains: %2", text,
                    shortProbabilityText(advice.oneLeft));
}

std::string whatItShows(const PlanAdvice& advice) {
  std::vector<std::string> texts;
  if (!advice.reveals.empty())
    texts.push_back(Phrase::of("would show %1", causeNames(advice.reveals, Phrase::of(" and "))));
  std::vector<std::string> pairs;
  for (const auto& [one, other] : advice.separates)
    pairs.push_back(Phrase::of("%1 from %2", causeName(one), causeName(other)));
  if (!pairs.empty()) texts.push_back(Phrase::of("separates %1", listed(pairs)));
  return texts.size() == 2 ? Phrase::of("%1; %2", texts[0], texts[1]) : listed(texts);
}

/// Σ √(wᵢ wⱼ)(1 − BCᵢⱼ) over the pairs of “no effect” and each shown effect. w is 1 for “no effect” and the
/// prior odds for an effect; BC is the Bhattacharyya coefficient.
double worthOfShowing(const Advice& advice) {
  const double overlap = std::exp(-square(advice.bySigma) / 8);
  return static_cast<double>(advice.separates.size()) * std::sqrt(priorOddsOfEffect()) * (1 - overlap);
}

/// −ln(U after/U before) if an advice shows effects that contribute to U.
double reductionByShowing(const MeasuredIntersection& measured, const Advice& advice) {
  constexpr double least = 1e-3;
  double variance = 0;
  for (const UncertaintyShare& share : measured.budget)
    if (std::ranges::find(advice.separates, share.effect) != advice.separates.end())
      variance += square(share.sigma);
  const double shown = square(advice.bySigma) / (1 + square(advice.bySigma));
  return -std::log(std::max(1 - variance * shown / square(measured.estimate.sigma), least)) / 2;
}

void addAttainable(std::vector<Entry>& entries, const Attainable& attainable) {
  for (const AttainableUncertainty& one : attainable) {
    if (one.measures.empty()) continue;
    Entry& entry = entryOf(entries, one.measures);
    entry.expanded = one.expanded;
    entry.ofUncertainty = std::log(attainable.front().expanded / one.expanded);
  }
}

/// Adds entries that only reduce U. Keeps the entry of most worth and up to two of most worth per effort.
std::vector<Entry> fewOf(std::vector<Entry> all, const Attainable& attainable) {
  constexpr std::size_t most = 3;
  addAttainable(all, attainable);
  std::vector<Entry> few;
  std::ranges::copy_if(all, std::back_inserter(few), [&](const Entry& entry) {
    return std::ranges::none_of(all, [&](const Entry& other) { return entry.isBeatenBy(other); });
  });
  std::ranges::stable_sort(few, std::greater{}, &Entry::perEffort);
  while (few.size() > most) {
    const auto best = std::ranges::max_element(few, {}, &Entry::worth);
    few.erase(few.end() - (best == few.end() - 1 ? 2 : 1));
  }
  return few;
}

/// "Slider readings", "Trunnion tilt known".
std::string nameOf(const AttainableUncertainty& one) {
  return withCapital(one.known.empty() ? textOf(one.measures) : Phrase::of("%1 known", causeName(one.known)));
}

/// The known effects that reduce U most.
Attainable knownOf(Attainable attainable) {
  constexpr std::size_t most = 2;
  std::erase_if(attainable, [](const AttainableUncertainty& one) { return one.known.empty(); });
  std::ranges::stable_sort(attainable, {}, &AttainableUncertainty::expanded);
  attainable.resize(std::min(most, attainable.size()));
  return attainable;
}

/// The number of decimals for every U: as many as the smallest U needs.
int decimalsOf(const Attainable& attainable) {
  int decimals = 0;
  for (const AttainableUncertainty& one : attainable)
    decimals = std::max(decimals, decimalsFor(one.expanded));
  return decimals;
}

Statement statementOf(std::vector<Entry> entries, const Attainable& attainable,
                      const SessionEffort& session) {
  Statement statement{.id = "advice",
                      .title = Phrase::of("What to measure next"),
                      .columns = {{"measures", Phrase::of("Measure"), Statement::Column::Role::Name},
                                  {"rows", Phrase::of("rows, about")},
                                  {"minutes", Phrase::of("min, about")},
                                  {"expanded", "U (mm)"},
                                  {"tells", Phrase::of("What it shows"), Statement::Column::Role::Text}},
                      .rows = {}};
  const int decimals = decimalsOf(attainable);
  for (const Entry& entry : fewOf(std::move(entries), attainable)) {
    const auto effort = [&](double ofSession) {
      return displayText(std::max(1.0, std::round(ofSession * entry.effort())), 0);
    };
    statement.rows.push_back(
        {.cells = {withCapital(howTo(entry.measures)), effort(session.rows), effort(session.minutes),
                   entry.expanded ? displayText(*entry.expanded, decimals) : "", entry.shows}});
  }
  if (statement.rows.empty())
    statement.sentences.push_back(
        Phrase::of("Further readings of the usual kinds would add no information."));
  for (const AttainableUncertainty& one : knownOf(attainable))
    statement.rows.push_back({.cells = {nameOf(one), "", "", displayText(one.expanded, decimals), ""}});
  if (!attainable.empty())
    statement.sentences.push_back(
        Phrase::of("Typical U for this plan: %1 mm.", displayText(attainable.front().expanded, decimals)));
  return statement;
}

std::vector<Entry> entriesOf(const Diagnosis& diagnosis) {
  constexpr double steps = 20;  // probabilities are compared in steps of a twentieth
  std::vector<Entry> entries;
  for (const Advice& advice : diagnosis.advice) {
    Entry& entry = entryOf(entries, advice.measures);
    if (advice.ofUndetectable)
      add(entry, whatItShows(advice), worthOfShowing(advice),
          diagnosis.measured ? reductionByShowing(*diagnosis.measured, advice) : 0);
    else
      add(entry, whatItShows(advice), std::round(steps * advice.oneLeft) / steps / 2, 0);
  }
  return entries;
}

}  // namespace

Statement gapAdvice(const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  return statementOf(entriesOf(*gap.diagnosis), gap.diagnosis->attainable,
                     effortOf(*evaluation.examined.measurement, sightingMinutesOf(evaluation.session)));
}

std::vector<std::vector<Measure>> measuresNext(const Gap& gap) {
  std::vector<std::vector<Measure>> measures;
  for (Entry& entry : fewOf(entriesOf(*gap.diagnosis), gap.diagnosis->attainable))
    measures.push_back(std::move(entry.measures));
  return measures;
}

Statement planAdvice(const PlanReview& review, const SessionEffort& session) {
  std::vector<Entry> entries;
  for (const PlanAdvice& advice : review.advice)
    add(entryOf(entries, advice.measures), whatItShows(advice),
        static_cast<double>(advice.separates.size()) / static_cast<double>(review.effects.size() + 1), 0);
  return statementOf(std::move(entries), review.attainable, session);
}

Statement insteadStatement(const Outlook& outlook) {
  if (outlook.instead.size() < 2) return {};
  return statementOf({}, outlook.instead, outlook.whole);
}

void addUncertainties(Statement& statement, const Attainable& attainable) {
  const int decimals = decimalsOf(attainable);
  statement.title = Phrase::of("What would reduce U further");
  statement.columns = {{"measures", Phrase::of("Measure"), Statement::Column::Role::Name},
                       {"expanded", "U (mm)"}};
  for (auto one = attainable.begin() + 1; one != attainable.end(); ++one)
    statement.rows.push_back({.cells = {nameOf(*one), displayText(one->expanded, decimals)}});
}

}  // namespace alidade
