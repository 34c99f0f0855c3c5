#pragma once

#include <string>

#include "core/adjustment/result/two_faces.h"

namespace alidade::console {

/// The two-face table of `measurement` and what it says about the instrument, ″.
std::string twoFacesText(const Measurement& measurement, const TwoFaces& faces);

}  // namespace alidade::console
