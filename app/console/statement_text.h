#pragma once

#include <string>

#include "core/statement/statement.h"

namespace alidade::console {

/// An empty line, the table under its title, the sentences and the note. Empty without rows and sentences.
std::string statementText(const Statement& statement);

}  // namespace alidade::console
