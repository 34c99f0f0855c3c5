#pragma once

#include "core/diagnosis/result/form.h"
#include "core/session/own_effect.h"
#include "core/session/session.h"

namespace alidade {

/// A found form as an effect of the user's own: its formula with the numbers of its shape as found; each
/// amplitude as large as it was found, as a plausible size. It belongs to the session's device, or to its
/// instrument if it acts on circles, by serial number; and it says from which session it is.
OwnEffect ownEffectOf(const FoundForm& found, const Session& session);

}  // namespace alidade
