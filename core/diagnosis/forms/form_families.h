#pragma once

#include <vector>

#include "core/diagnosis/evidence/width.h"
#include "core/diagnosis/forms/form_readings.h"

namespace alidade {

/// Forms that differ in their shape numbers only.
struct FormFamily {
  Form form;
  std::vector<Form> grid;  ///< with start values of the shape numbers; one entry if there are none
  double logPrior = 0;     ///< natural logarithm; 2 bits less for each word of a form; all sum to 1
  double logVolume = 0;    ///< natural logarithm of the range of the shape numbers in `shapeCoordinates`
};

/// All families that these readings may show.
std::vector<FormFamily> formFamilies(const FormReadings& readings);

/// The shape numbers in the coordinates of the search: logarithms of widths and time constants.
Eigen::Array2d shapeCoordinates(const Form& form);
void setShapeCoordinates(Form& form, const Eigen::Array2d& coordinates);

/// The words of a form, for its prior of two bits for each: carrier, function, argument, sign in face 2,
/// shape numbers. A form that follows the slider, whose coordinate turns with the guideway, but acts in a
/// direction of the room has one word more.
int wordsOf(const Form& form);

/// Plausible size of an amplitude, mm or arcseconds, to which `formWidths` belong.
double formUnit(FormCarrier carrier);
const std::vector<Width>& formWidths();

}  // namespace alidade
