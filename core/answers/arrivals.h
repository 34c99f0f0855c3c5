#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/session/session.h"

namespace alidade {

/// What came from the instrument with one row of a session.
struct Arrival {
  std::size_t position = 0, row = 0;
  std::string takenAt = {}, returnCode = {}, instrumentSerial = {};
};

/// Of the rows that anything came with, in the order of the file.
std::vector<Arrival> arrivalsOf(const Session& session);

/// Null where nothing came with the row.
const Arrival* arrivalAt(const std::vector<Arrival>& arrivals, std::size_t position, std::size_t row);

}  // namespace alidade
