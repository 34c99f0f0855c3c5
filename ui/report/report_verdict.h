#pragma once

#include <QString>

#include "ui/jobs/evaluation.h"

namespace alidade::ui {

/// The verdict as it may be printed. A session with entries that could not be used gets none, whatever the
/// rest says.
struct ReportVerdict {
  QString word;      ///< "Accepted", "Rejected", "Undecided", or why there is none
  QString sentence;  ///< with the numbers it rests on
  bool isAccepted = false;
};

ReportVerdict reportVerdict(const Evaluation& evaluation);

}  // namespace alidade::ui
