#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/observation/error_term.h"

namespace alidade {

/// One number of an effect.
struct EffectParameter {
  std::string_view name;  ///< "tilt about x": in files; `parameterName` gives it out to people
  ErrorTerm term;
  std::string_view unit;  ///< "arcsec", "deg", "mm", "1" or "-"
  double plausible;       ///< 1σ, in that unit
};

/// Where an error comes from: what an effect belongs to. The same guideway sighted in two positions tells
/// what belongs to it from what belongs to the instrument.
enum class ErrorSource {
  Guideway,    ///< its form, its place, the slider's scale
  Instrument,  ///< its axes, circles and line of sight
  Time,        ///< it comes as the session goes on
  Reading,     ///< one reading is off; of no effect
};

/// How the readings follow the numbers of an effect.
enum class Response {
  Linear,        ///< in proportion, as far as matters
  Bent,          ///< second derivatives matter; of two numbers, both the guideway's
  AllOrNothing,  ///< its one number is 1, or it is not there at all
};

/// A physical effect of the catalogue: a few error terms of the forward model that belong together.
struct Effect {
  std::string_view id;  ///< part of the file format
  // For `Phrase::of`.
  const char* name;         ///< "plane tilt"
  const char* description;  ///< what it is, in a phrase
  const char* remedy;       ///< what to do about it at the machine, in a phrase
  ErrorSource source;
  Response response;
  std::vector<EffectParameter> parameters;
  /// By the diagnosis as a cause of a gap. Where no reading tells an effect from another, it takes part in
  /// the uncertainty alone.
  bool isSought = true;
};

/// Every effect that is a linear combination of error terms, in the order of the catalogue.
std::span<const Effect> effectCatalogue();

/// Those that a gap may be put down to, in the same order.
std::vector<const Effect*> soughtEffects();

/// Null where no effect has this id.
const Effect* effectById(std::string_view id);

/// The effect that the term is a number of; null for the terms of a jump.
const Effect* effectOf(ErrorTerm term);

/// Radians, mm or 1 per `unit`: the factor from the unit to the model's own.
double modelUnitsPer(std::string_view unit);

/// What people call a number of an effect, or of another cause, whose name in files is `name`.
std::string parameterName(std::string_view name);

/// 1σ of what is plausible, in the unit of the term: rad, mm or 1.
double plausibleSize(const EffectParameter& parameter);

}  // namespace alidade
