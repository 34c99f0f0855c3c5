#pragma once

#include <QString>

namespace alidade::ui {

/// Creates `folder` with its parents if missing, and restricts it to its owner, since it holds copies of
/// sessions whose own files may be private.
void makePrivateFolder(const QString& folder);

}  // namespace alidade::ui
