#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace alidade {

/// The document of an answer as the console prints it, with the program that gives it as its last member:
/// indented by two blanks, with a newline at its end. Bytes that are not UTF-8 are replaced; numbers that are
/// not finite become null.
std::string answerText(nlohmann::ordered_json document);

}  // namespace alidade
