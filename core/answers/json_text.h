#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace alidade {

/// The document of an answer as the console prints it, with the program that gives it as its last member:
/// indented by two blanks, with a newline at its end. Bytes that are not UTF-8 are replaced; numbers that are
/// not finite become null.
std::string answerText(nlohmann::ordered_json document);

/// The document with every number that has an old name also by the name that replaces it, beside it: `u` and
/// `standard_uncertainty`, `dof_zenith` and `degrees_of_freedom_zenith`.
nlohmann::ordered_json withLongNames(const nlohmann::ordered_json& document);

}  // namespace alidade
