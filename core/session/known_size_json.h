#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/session/json_object_reader.h"
#include "core/session/json_object_writer.h"
#include "core/session/session.h"

namespace alidade {

// What is known of effects stands alike in sessions and in instrument records: a list `known`.

/// That of the reader's object; empty where it has none.
std::vector<KnownSize> readKnown(const ObjectReader& reader);
nlohmann::ordered_json knownJson(const std::vector<KnownSize>& known);

// So does the offset of the line of sight: members of the object itself.

LineOfSight readLineOfSight(const ObjectReader& reader);
void writeLineOfSight(ObjectWriter& writer, const LineOfSight& lineOfSight);

}  // namespace alidade
