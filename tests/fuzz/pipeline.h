#pragma once

#include "core/session/session.h"

namespace alidade::fuzz {

/// What the programs do with a session: write and read it again, examine it, fit it both ways, look for
/// suspects, draw a few times, diagnose it, review it as a plan, and print all of that. Whatever comes out
/// has to be within its range; a session that cannot be used has to be refused in words.
void workThrough(const Session& session);

}  // namespace alidade::fuzz
