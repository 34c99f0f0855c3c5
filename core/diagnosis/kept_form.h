#pragma once

#include "core/diagnosis/result/form.h"
#include "core/session/own_effect.h"
#include "core/session/session.h"

namespace alidade {

/// Returns a found form as an effect of the user's own. The formula keeps the found shape numbers. The
/// plausible size of every amplitude is the rms of the found amplitudes. The effect belongs, by serial
/// number, to the instrument if it acts on circles, otherwise to the device. `from` names the session.
OwnEffect ownEffectOf(const FoundForm& found, const Session& session);

}  // namespace alidade
