#include "core/session/own_effects.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr std::size_t longestId = 40;

bool isInId(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

bool isId(const std::string& text) {
  return !text.empty() && text.size() <= longestId && std::ranges::all_of(text, isInId);
}

/// The problem of the parameter for an amplitude, at its key; absent if it has none.
std::optional<Problem> parameterProblem(const OwnEffect& effect, const FormulaAmplitude& amplitude) {
  const auto own = std::ranges::find(effect.parameters, amplitude.name, &OwnParameter::name);
  if (own == effect.parameters.end())
    return Problem{Phrase::of("lack the amplitude %1: state its plausible size", quotation(amplitude.name)),
                   {.field = "parameters"}};
  const std::string entry = "parameters[" + std::to_string(own - effect.parameters.begin()) + "]";
  const Result<double> plausible = parseNumber(own->plausible);
  constexpr double largest = 1e5;
  if (!plausible || !(*plausible > 0) || !(*plausible <= largest))
    return Problem{Phrase::of("is no plausible size: type a number above 0"),
                   {.field = entry + ".plausible"}};
  if (const std::string_view unit = unitOf(amplitude.carrier); !own->unit.empty() && own->unit != unit)
    return Problem{Phrase::of("is not the unit of %1, which is %2", quotation(nameOf(amplitude.carrier)),
                              std::string(unit)),
                   {.field = entry + ".unit"}};
  return std::nullopt;
}

/// The formula of the effect, or the first problem of the effect.
Result<Formula> soundFormula(const OwnEffect& effect) {
  if (!isId(effect.id))
    return Problem{Phrase::of("must be up to 40 letters, digits, _ or -"), {.field = "id"}};
  Result<Formula, FormulaFault> formula = parseFormula(effect.formula);
  if (!formula) return Problem{formula.problem().text(effect.formula), {.field = "formula"}};
  for (const FormulaAmplitude& amplitude : formula->amplitudes)
    if (auto problem = parameterProblem(effect, amplitude)) return *std::move(problem);
  for (std::size_t i = 0; i < effect.parameters.size(); ++i)
    if (std::ranges::find(formula->amplitudes, effect.parameters[i].name, &FormulaAmplitude::name) ==
        formula->amplitudes.end())
      return Problem{Phrase::of("%1 is no amplitude of the formula", quotation(effect.parameters[i].name)),
                     {.field = "parameters[" + std::to_string(i) + "].name"}};
  return *std::move(formula);
}

ErrorSource sourceOf(const Formula& formula) {
  const auto isOfGuideway = [](const FormulaLine& line) { return !isOfCircles(line.carrier); };
  if (std::ranges::any_of(formula.lines, isOfGuideway)) return ErrorSource::Guideway;
  return std::ranges::any_of(formula.lines, &FormulaLine::isOfTime) ? ErrorSource::Time
                                                                    : ErrorSource::Instrument;
}

ErrorTerm following(ErrorTerm first, std::size_t count) {
  return static_cast<ErrorTerm>(static_cast<std::size_t>(first) + count);
}

}  // namespace

std::string ownIdFrom(std::string name) {
  if (name.size() > longestId) name.resize(longestId);
  std::ranges::replace_if(name, std::not_fn(isInId), '_');
  return name;
}

std::string ownId(const OwnEffect& effect) {
  return std::string(ownPrefix) + effect.id;
}

OwnEffects::OwnEffects(std::vector<OwnEntry> entries) : m_entries(std::move(entries)) {
  for (OwnEntry& entry : m_entries) {
    const OwnEffect& source = entry.source;
    entry.effect = {entry.id,
                    source.name.empty() ? source.id.c_str() : source.name.c_str(),
                    source.description.c_str(),
                    source.remedy.c_str(),
                    sourceOf(entry.formula),
                    Response::Linear,
                    {}};
    for (std::size_t i = 0; i < entry.terms.size(); ++i) {
      const FormulaAmplitude& amplitude = entry.formula.amplitudes[i];
      const auto own = std::ranges::find(source.parameters, amplitude.name, &OwnParameter::name);
      entry.effect.parameters.push_back(
          {amplitude.name, entry.terms[i], unitOf(amplitude.carrier), *parseNumber(own->plausible)});
    }
  }
}

const Effect* OwnEffects::find(std::string_view id) const {
  const auto found = std::ranges::find(m_entries, id, &OwnEntry::id);
  return found == m_entries.end() ? nullptr : &found->effect;
}

const Effect* OwnEffects::find(ErrorTerm term) const {
  for (const OwnEntry& entry : m_entries)
    if (std::ranges::find(entry.terms, term) != entry.terms.end()) return &entry.effect;
  return nullptr;
}

std::optional<Problem> ownEffectProblem(const OwnEffect& effect) {
  const Result<Formula> formula = soundFormula(effect);
  if (formula) return std::nullopt;
  return formula.problem();
}

std::shared_ptr<const OwnEffects> examineOwnEffects(const std::vector<OwnEffect>& effects,
                                                    std::vector<Problem>& problems) {
  std::vector<OwnEntry> entries;
  std::size_t ofGuideway = 0, ofCircles = 0;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const std::string entry = "own_effects[" + std::to_string(i) + "].";
    const auto refuse = [&](Problem problem) {
      problem.where.field.insert(0, entry);
      problems.push_back(std::move(problem));
    };
    constexpr std::size_t mostRead = 20;
    if (i == mostRead) {
      refuse(
          {Phrase::of("is one effect too many: a session may have at most %1", mostRead), {.field = "id"}});
      break;
    }
    Result<Formula> formula = soundFormula(effects[i]);
    const std::string id = ownId(effects[i]);
    if (!formula) {
      refuse(formula.problem());
    } else if (std::ranges::find(entries, id, &OwnEntry::id) != entries.end()) {
      refuse({Phrase::of("is used by another effect of the session: choose another one"), {.field = "id"}});
    } else if (ofGuideway + ofCircles + formula->amplitudes.size() > mostOwnTerms) {
      refuse({Phrase::of("has too many amplitudes: a session's own effects may have at most %1 together",
                         mostOwnTerms),
              {.field = "formula"}});
    } else {
      OwnEntry& own = entries.emplace_back(OwnEntry{effects[i], id, *std::move(formula)});
      for (const FormulaAmplitude& amplitude : own.formula.amplitudes)
        own.terms.push_back(isOfCircles(amplitude.carrier) ? following(ErrorTerm::OwnInstrument, ofCircles++)
                                                           : following(ErrorTerm::OwnGuideway, ofGuideway++));
    }
  }
  return entries.empty() ? nullptr : std::make_shared<const OwnEffects>(std::move(entries));
}

}  // namespace alidade
