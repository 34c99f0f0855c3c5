#pragma once

#include "core/session/session.h"

namespace alidade {

/// A blank session for the next device. It keeps laboratory, customer, operator, place, instrument with its
/// known sizes, set-up, acceptance, model and protocol. It drops the data of one device or measurement:
/// title, notes, date, report number, serial, known sizes of the device, L, the reference, temperature,
/// effects that its readings needed, and all readings.
Session nextSession(const Session& session);

}  // namespace alidade
