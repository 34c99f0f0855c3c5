#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace alidade {

/// A JSON result as the console prints it: name and version of the program as the last member, indented by
/// two blanks, with a newline at its end. Bytes that are not UTF-8 are replaced; numbers that are not finite
/// become null. `digest`: SHA-256 of the file of the one session that it is of; empty: of none.
std::string answerText(nlohmann::ordered_json document, const std::string& digest = {});

/// Returns the document with new names in addition to old ones: `standard_uncertainty` next to `u`,
/// `degrees_of_freedom_zenith` next to `dof_zenith`.
nlohmann::ordered_json withLongNames(const nlohmann::ordered_json& document);

}  // namespace alidade
