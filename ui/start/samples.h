#pragma once

#include <QString>
#include <vector>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

/// A session in the program's resources, available wherever the program is.
struct Sample {
  const char* name;   ///< file name without suffix
  const char* title;  ///< in the context `Sample`
  const char* shows;  ///< one line about the sample, in the context `Sample`
};

/// All samples in the recommended order.
const std::vector<Sample>& allSamples();

Result<Session> readSample(const QString& name);

}  // namespace alidade::ui
