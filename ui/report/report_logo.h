#pragma once

#include <QImage>
#include <QString>

#include "core/base/result.h"

namespace alidade::ui {

/// The picture in `path` for a report: opaque on white, at print resolution at most. Otherwise a problem with
/// the reason.
Result<QImage> readLogo(const QString& path);

}  // namespace alidade::ui
