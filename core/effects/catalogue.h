#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/terms/effect.h"

namespace alidade {

class OwnEffects;
struct Measurement;

/// The effects of the catalogue, each a group of error terms of the forward model, in a fixed order.
std::span<const Effect> effectCatalogue();

/// The effects that may explain a gap, in the same order.
std::vector<const Effect*> soughtEffects();

/// Null if the id is unknown.
const Effect* effectById(std::string_view id);

/// The effect of the catalogue with this term; null for the terms of a jump and the user's own.
const Effect* effectOf(ErrorTerm term);

/// The effects of the catalogue, then the user's own effects; `own` may be null.
std::vector<const Effect*> effectsWith(const OwnEffects* own);
std::vector<const Effect*> effectsOf(const Measurement& measurement);
const Effect* effectById(std::string_view id, const Measurement& measurement);
const Effect* effectOf(ErrorTerm term, const Measurement& measurement);

/// True if a parameter of the effect has no consequence without slider readings.
bool needsSlider(const Effect& effect);

/// The factor from `unit` to the model's own unit: radians, mm or 1.
double modelUnitsPer(std::string_view unit);

/// The displayed name of a parameter of an effect or another cause; `name` is its name in files.
std::string parameterName(std::string_view name);

/// 1σ of the plausible size, in the unit of the term: rad, mm or 1.
double plausibleSize(const EffectParameter& parameter);

}  // namespace alidade
