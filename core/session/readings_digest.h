#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// SHA-256 of what was read, with what, of what and when: axes, pointing zeros and rows as they are
/// understood, serials, names where there is no serial, and the date. The same of a file and its copies, also
/// where they were saved anew, with numbers written otherwise, another title, other notes or another
/// tolerance. `measurement`: of the session.
std::string readingsDigest(const Session& session, const Measurement& measurement);

/// Of each digest the index of the first one like it: its own where there is none before it. An empty one is
/// like no other.
std::vector<std::size_t> firstsAlike(const std::vector<std::string>& digests);

}  // namespace alidade
