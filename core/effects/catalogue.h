#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/observation/error_term.h"

namespace alidade {

/// One parameter of an effect.
struct EffectParameter {
  std::string_view name;  ///< "tilt about x": in files; `parameterName` is for people
  ErrorTerm term;
  std::string_view unit;  ///< "arcsec", "deg", "mm", "1" or "-"
  double plausible;       ///< 1σ, in that unit
};

/// The source of an error. Sighting the same guideway in two positions separates its errors from those of the
/// instrument.
enum class ErrorSource {
  Guideway,    ///< its form, its place, the slider's scale
  Instrument,  ///< its axes, circles and line of sight
  Time,        ///< it develops during the session
  Reading,     ///< a single reading is wrong; has no effect in the catalogue
};

/// How the readings depend on the parameters of an effect.
enum class Response {
  Linear,        ///< in proportion, to sufficient accuracy
  Bent,          ///< second derivatives matter; of two parameters, both the guideway's
  AllOrNothing,  ///< its one parameter is 1, or it is absent
};

/// A physical effect of the catalogue: related error terms of the forward model.
struct Effect {
  std::string_view id;  ///< part of the file format
  // Texts for `Phrase::of`.
  const char* name;         ///< "plane tilt"
  const char* description;  ///< description, as a phrase
  const char* remedy;       ///< remedy at the machine, as a phrase
  ErrorSource source;
  Response response;
  std::vector<EffectParameter> parameters;
  /// Does the diagnosis consider it as a cause of a gap? Effects indistinguishable in any readings enter only
  /// the uncertainty.
  bool isSought = true;
};

/// Every effect that is a linear combination of error terms, in the order of the catalogue.
std::span<const Effect> effectCatalogue();

/// The effects that may explain a gap, in the same order.
std::vector<const Effect*> soughtEffects();

/// Null if the id is unknown.
const Effect* effectById(std::string_view id);

/// The effect with this term; null for the terms of a jump.
const Effect* effectOf(ErrorTerm term);

/// The factor from `unit` to the model's own unit: radians, mm or 1.
double modelUnitsPer(std::string_view unit);

/// The name for people of a parameter of an effect, or of another cause, with the name `name` in files.
std::string parameterName(std::string_view name);

/// 1σ of the plausible size, in the unit of the term: rad, mm or 1.
double plausibleSize(const EffectParameter& parameter);

}  // namespace alidade
