#pragma once

#include "core/session/session.h"

namespace alidade::fuzz {

/// Runs all that the programs do with a session: write and read it again, examine it, fit it both ways, look
/// for suspects, diagnose it, review it as a plan, and print all results. Every result has to meet
/// `every_answer.h`; an unusable session has to be refused with a sentence. No text of the session may
/// contain “nan” or “inf ”.
void workThrough(const Session& session);

}  // namespace alidade::fuzz
