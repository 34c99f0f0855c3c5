#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/adjustment/joint/linearised.h"
#include "core/diagnosis/next_sighting/possible_sightings.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

/// A form of no catalogue with its prior share of all of them; the shares sum to 1.
struct PossibleForm {
  Form form;
  double share = 0;
};

/// The forms that are weighed while a session grows: a few of every kind that the diagnosis seeks. They are
/// the same for all sessions, because evidence that may be looked at at any time needs prior shares that no
/// reading changes.
const std::vector<PossibleForm>& possibleForms();

/// The columns of the possible forms over readings, side by side, for amplitudes of the plausible size
/// (`formUnit`).
struct FormColumns {
  Eigen::MatrixXd columns;
  std::vector<Eigen::Index> counts;  ///< columns of each form; 0 if no reading shows it
};

/// `all` are the equations of `session` at these circles, one for each arc.
FormColumns columnsOfForms(const PossibleSightings& session, const std::vector<Circle>& circles,
                           const Linearised& all);

}  // namespace alidade
