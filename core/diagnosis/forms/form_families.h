#pragma once

#include <vector>

#include "core/diagnosis/evidence/width.h"
#include "core/diagnosis/forms/form_readings.h"

namespace alidade {

/// Forms that differ in their shape numbers only.
struct FormFamily {
  Form form;
  std::vector<Form> grid;  ///< forms with start values of the shape numbers; a single form if it has none
  double logPrior = 0;     ///< natural logarithm; 2 bits less for each word; the priors sum to 1
  double logVolume = 0;    ///< natural logarithm of the range of the shape numbers in `shapeCoordinates`
};

/// All families that these readings may show.
std::vector<FormFamily> formFamilies(const FormReadings& readings);

/// The shape numbers in the coordinates of the search: widths and time constants as logarithms.
Eigen::Array2d shapeCoordinates(const Form& form);
void setShapeCoordinates(Form& form, const Eigen::Array2d& coordinates);

/// The number of words of a form, each of which costs two bits of its prior: carrier, function, argument,
/// sign in face 2, shape numbers. A form has one word more if it follows the slider, which turns with the
/// guideway, but acts in a direction of the room.
int wordsOf(const Form& form);

/// Unit of an amplitude's prior widths (`formWidths`), mm or arcseconds.
double formUnit(FormCarrier carrier);
const std::vector<Width>& formWidths();

}  // namespace alidade
