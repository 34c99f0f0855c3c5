#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// SHA-256 of the readings with their instrument, device and date: the values of axes, pointing zeros and
/// rows, the serial numbers (a name where there is none), and the date. Copies of a file have equal digests,
/// even if they were saved again with another unit of angles or notation of numbers, title, notes or
/// tolerance. `measurement`: of the session.
std::string readingsDigest(const Session& session, const Measurement& measurement);

/// Returns for each digest the index of the first equal one, which may be its own. An empty digest equals no
/// other.
std::vector<std::size_t> firstsAlike(const std::vector<std::string>& digests);

}  // namespace alidade
