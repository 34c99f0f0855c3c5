#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/session/json_object_reader.h"
#include "core/session/json_object_writer.h"
#include "core/session/session.h"

namespace alidade {

// Known sizes of effects have the same form in sessions and in instrument records: a list `known`.

/// The list in the reader's object; empty if it has none.
std::vector<KnownSize> readKnown(const ObjectReader& reader);
nlohmann::ordered_json knownJson(const std::vector<KnownSize>& known);

// The offset of the line of sight has one form in sessions and records, too: members of the object itself.

LineOfSight readLineOfSight(const ObjectReader& reader);
void writeLineOfSight(ObjectWriter& writer, const LineOfSight& lineOfSight);

}  // namespace alidade
