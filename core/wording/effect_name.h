#pragma once

#include <string>
#include <vector>

namespace alidade {

/// The common name of an effect from its identifier: "trunnion tilt". The name of a user's own effect or an
/// unknown effect is its identifier without prefix and underscores, as visible text.
std::string effectName(const std::string& id);

/// The name within a sentence of anything that a diagnosis may find: an effect, "a jump of the orientation",
/// "misread values", "noise larger than stated".
std::string causeName(const std::string& id);
/// `causeName` with a capital first letter and without its article.
std::string causeTitle(const std::string& id);
/// `causeName` of each id, separated by commas; `last` separates the last two, with its blanks: " or ".
std::string causeNames(const std::vector<std::string>& ids, const std::string& last);

/// "Gravity sag": a capital first letter, if it is an ASCII letter.
std::string withCapital(std::string text);

/// The sign of a unit of the catalogue, with the blank before it: "″", "°", " mm"; empty for others.
std::string signOf(const std::string& unit);

/// Returns the plausible size (1σ) of a catalogue effect: "30″", "0.05 mm"; pure numbers have no unit.
/// Empty for a jump, misread values and larger noise, which have no plausible size.
std::string plausibleSizeText(const std::string& id);

/// True if the effect's identifier already names the parameter, as "slider_scale" does "scale".
bool isNamedBy(const std::string& effect, const std::string& parameter);

}  // namespace alidade
