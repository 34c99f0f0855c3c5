#pragma once

#include <QImage>
#include <QString>

#include "core/base/result.h"

namespace alidade::ui {

/// The picture in `path` as a report has it: opaque on white, no larger than print shows. The problem says
/// why it cannot be used.
Result<QImage> readLogo(const QString& path);

}  // namespace alidade::ui
