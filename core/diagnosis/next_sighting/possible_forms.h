#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/adjustment/joint/linearised.h"
#include "core/diagnosis/next_sighting/possible_sightings.h"
#include "core/diagnosis/result/form.h"

namespace alidade {

/// A form of an uncatalogued effect, and its prior share among all possible forms; the shares sum to 1.
struct PossibleForm {
  Form form;
  double share = 0;
};

/// The forms that are weighed while a session grows, a selection of those that the diagnosis seeks. The forms
/// and their shares are the same for all sessions: evidence stays valid at any time only if no reading
/// changes the prior.
const std::vector<PossibleForm>& possibleForms();

/// The columns of each possible form over the readings, for amplitudes of the plausible size (`formUnit`);
/// empty if no reading shows the form. `circles` has one circle for each arc; `all` are the equations of
/// `session` linearised at these circles.
std::vector<Eigen::MatrixXd> columnsOfForms(const PossibleSightings& session,
                                            const std::vector<Circle>& circles, const Linearised& all);

}  // namespace alidade
