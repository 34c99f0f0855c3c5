#pragma once

#include <string_view>
#include <vector>

#include "core/terms/error_term.h"

namespace alidade {

/// Traits of a parameter in addition to its derivatives.
struct ParameterTraits {
  bool needsSlider = false;  ///< cannot be determined without slider readings
  /// The order of a wave over the slider coordinate that turns with the guideway, in the radius or across the
  /// plane of the arc; 0: none.
  int radialOrder = 0, acrossOrder = 0;
  /// Turns a circle away from its pointing zero, as a second sighting of the zero shows.
  bool turnsHorizontalZero = false, turnsVerticalZero = false;
  bool changesDistance = false;  ///< changes the distance, by opposite amounts in the two positions
};

/// One parameter of an effect.
struct EffectParameter {
  std::string_view name;  ///< "tilt about x": in files; `parameterName` is for people
  ErrorTerm term;
  std::string_view unit;  ///< "arcsec", "deg", "mm", "1" or "-"
  double plausible;       ///< 1σ, in that unit
  ParameterTraits traits = {};
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
  Bent,          ///< second derivatives matter; has two parameters, both of the guideway
  AllOrNothing,  ///< its only parameter is 1 if the effect is present, else 0
};

/// A physical effect of the catalogue: related error terms of the forward model.
struct Effect {
  std::string_view id;  ///< part of the file format
  // Texts for `Phrase::of`.
  const char* name;         ///< "plane tilt"
  const char* description;  ///< what the effect is
  const char* remedy;       ///< what to do at the machine
  ErrorSource source;
  Response response;
  std::vector<EffectParameter> parameters;
  /// Does the diagnosis consider the effect as a cause of a gap between model and readings? An effect that no
  /// readings can distinguish from others enters only the uncertainty.
  bool isSought = true;
};

}  // namespace alidade
