#pragma once

#include <string>

#include "core/diagnosis/result/form.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

/// "radius", "horizontal readings".
std::string carrierText(const Form& form);

/// "0.190 mm", "12″": an amplitude with two digits of `sigma`, both in mm or arcseconds.
std::string sizeText(double value, double sigma, const Form& form);

/// "radius + 0.19 mm · cos 7s − 0.19 mm · sin 7s, turning with the guideway".
std::string textOf(const FoundForm& found);

/// "radius, cos 7s": the carrier and the first function of a form, without the amplitude.
std::string kindText(const Form& form);

/// The name of a number of a form: "amplitude", "order", "at", "width", "horizontal".
std::string nameOf(const FormNumber& number);

/// The unit of a number of the form, as in the catalogue: "mm", "arcsec", "deg" or "1".
std::string unitOf(const FormNumber& number);

/// Whether the number is exact, such as an order that is certain, so that no uncertainty is stated.
bool isExact(double value, double sigma);

/// "The form: … (probability 97 %)."
std::string formSentence(const FoundForm& found);

/// "vertical drift, radius, cos 2s, and 3 more": the look-alikes of the form, effects of the catalogue first.
std::string lookAlikesText(const FoundForm& found);

/// "These readings cannot distinguish the form from: …."; empty without look-alikes.
std::string lookAlikesSentence(const FoundForm& found);

/// The range in which the model is valid without the form. Empty for harmonics and hysteresis, which act on
/// every reading.
std::string cleanRangeSentence(const FoundForm& found);

/// How much the form reduces the gap of held-out readings and of all readings, with p of the F test. Empty
/// if too few readings were held out.
std::string shrinkSentence(const FoundForm& found);

}  // namespace alidade
