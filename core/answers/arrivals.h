#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/session/session.h"

namespace alidade {

/// The data that an instrument sent with one row of a session.
struct Arrival {
  std::size_t position = 0, row = 0;
  std::string takenAt = {}, returnCode = {}, instrumentSerial = {};
};

/// Returns the arrivals of all rows that have data from an instrument, in the order of the file.
std::vector<Arrival> arrivalsOf(const Session& session);

/// Null if the instrument sent nothing with the row.
const Arrival* arrivalAt(const std::vector<Arrival>& arrivals, std::size_t position, std::size_t row);

}  // namespace alidade
