#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"
#include "core/simulation/truth.h"

namespace alidade {

/// Adds an effect to the truth. `text` is an argument of the command line:
///
///   collimation=20: an effect of the catalogue with one parameter, in the catalogue's unit
///   plane_tilt=0.3,0.1: an effect with several parameters, in their order
///   plane_tilt.x=0.3: one of several parameters, by the last word of its name; the others stay as they are
///   orientation_jump=0.4,30,-20: moment (share of the rows), horizontal and vertical, arcsec
///   underestimated_noise=2.5: true noise divided by the stated one
///   gross_error=180,1,11,1,60,0: axis, round, point, face, horizontal and vertical, arcsec
///   own:dent=0.2: one of the user's own effects in `Truth::own`, in its unit
///   form_harmonic=7,0.1,0.1: order, cosine and sine, mm; uncatalogued
///   local_dent=0.1,60,8, settling=20,0.2, …: other uncatalogued disturbances (foreign_effect.h)
///
/// Returns the reason if `text` cannot be read.
std::optional<Problem> addEffect(Truth& truth, const std::string& text);

/// All names that `addEffect` accepts, with their units, a line each, for help texts.
std::string effectNames();

/// Ids that a diagnosis should name, each once, in the order of the catalogue; ids of uncatalogued effects
/// begin with `unknown_`. Effects of size 0 do not count.
std::vector<std::string> trueCauses(const Truth& truth);

/// `none`, the id of the only cause, `two_causes` or `several_causes`.
std::string kindOf(const Truth& truth);

/// The truth as a JSON document, {id: {…}}: seed, effects by name, intersection_mm, radius_mm, centre_x_mm,
/// axis_height_mm, distance_mm, blunders ([position, round, point, face, horizontal, vertical], arcsec), kind
/// (`kindOf`), protocol and reference; causes if several; true_sigma_arcsec if the noise is not as stated.
std::string truthJson(const std::string& id, const Truth& truth);

}  // namespace alidade
