#pragma once

#include <QImage>
#include <QString>

#include "core/base/result.h"

namespace alidade::ui {

/// The picture in `path` for a report, on a white background and at most at print resolution; or the reason
/// why it cannot be used.
Result<QImage> readLogo(const QString& path);

}  // namespace alidade::ui
