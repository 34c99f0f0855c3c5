#pragma once

#include <string>

#include "core/adjustment/result/two_faces.h"

namespace alidade::console {

/// The two-face table of `measurement` and the instrument errors derived from it, ″.
std::string twoFacesText(const Measurement& measurement, const TwoFaces& faces);

}  // namespace alidade::console
