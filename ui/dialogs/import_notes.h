#pragma once

#include <QString>

#include "core/exchange/import.h"

namespace alidade::ui {

/// Is this the name of a file of readings: .gsi, .csv, .tsv or .txt?
bool isReadingsFile(const QString& path);

/// What the user should know of an import: lines and entries that cannot be used first, then what was taken
/// how; the first dozen of them. Empty: all went in as it stands.
QString importNotes(const Import& import);

}  // namespace alidade::ui
