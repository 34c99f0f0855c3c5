#pragma once

#include <QString>

namespace alidade::ui {

/// Makes `folder`, where it is missing, with its parents, and closes it to others than its owner: what it
/// holds are copies of sessions, whose own files may be private.
void makePrivateFolder(const QString& folder);

}  // namespace alidade::ui
