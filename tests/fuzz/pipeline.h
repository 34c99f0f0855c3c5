#pragma once

#include "core/session/session.h"

namespace alidade::fuzz {

/// What the programs do with a session: write and read it again, examine it, fit it both ways, look for
/// suspects, diagnose it, review it as a plan, and print all of that. Every answer has to keep to
/// `every_answer.h`; a session that cannot be used has to be refused in words. None of its own texts may hold
/// “nan” or “inf ”.
void workThrough(const Session& session);

}  // namespace alidade::fuzz
