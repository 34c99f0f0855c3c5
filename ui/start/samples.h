#pragma once

#include <QString>
#include <vector>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

/// A session that comes with the program, in its resources: found wherever the program is.
struct Sample {
  const char* name;   ///< of its file, without suffix
  const char* title;  ///< in the context `Sample`
  const char* shows;  ///< one line, likewise
};

/// In an order to look at them.
const std::vector<Sample>& allSamples();

Result<Session> readSample(const QString& name);

}  // namespace alidade::ui
